//! STUB
use crate::math::*; use crate::mass::*; use crate::Error;
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry { Sphere { radius: f64 }, Cuboid { size: Vec3 } }
#[derive(Clone, Debug, PartialEq)]
pub struct Shape { pub geometry: Geometry, pub pose: Pose, pub density: f64 }
impl Shape {
  pub fn cuboid(s: impl Into<Vec3>) -> Self { Self{geometry: Geometry::Cuboid{size: s.into()}, pose: Pose::IDENTITY, density: 1000.0} }
  pub fn sphere(radius: f64) -> Self { Self{geometry: Geometry::Sphere{radius}, pose: Pose::IDENTITY, density: 1000.0} }
  pub fn density(mut self, d: f64) -> Self { self.density = d; self }
  pub fn validate(&self) -> Result<(), Error> { Ok(()) }
  pub fn mass_properties(&self) -> Result<MassProperties, Error> { match self.geometry { Geometry::Sphere{radius} => solid::sphere(radius, self.density)?, Geometry::Cuboid{size} => solid::cuboid(size, self.density)? }.transformed(self.pose).properties() }
}
