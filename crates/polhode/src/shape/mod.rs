//! Shapes: what they are, where on the body, how much they weigh.
//!
//! A [`Shape`] is a description. Building one cannot fail; [`Shape::validate`] and [`Shape::mass_properties`] say what is
//! wrong with it, and where. Lengths are full: a cuboid has edges, not half edges. Axes of revolution lie along the
//! shape's own z.
//!
//! ```
//! use polhode::shape::Shape;
//!
//! let bar = Shape::cuboid([0.1, 0.4, 0.9]).density(7800.0).at([0.0, 0.0, 0.2]);
//! let p = bar.mass_properties()?;
//! assert!((p.mass() - 280.8).abs() < 1e-12 && p.center().z == 0.2);
//!
//! let e = Shape::sphere(-1.0).mass_properties().unwrap_err();
//! assert_eq!(e.to_string(), "radius: must be positive and finite, is -1 m");
//! # Ok::<(), polhode::Error>(())
//! ```

mod capsule;
mod cone;
mod cuboid;
mod cylinder;
mod disc;
mod ellipsoid;
mod geometry;
mod half_space;
mod hull;
mod mesh;
mod polygon;
mod rectangle;
mod ring;
mod sphere;
mod torus;

pub use capsule::Capsule;
pub use cone::Cone;
pub use cuboid::Cuboid;
pub use cylinder::Cylinder;
pub use disc::Disc;
pub use ellipsoid::Ellipsoid;
pub use geometry::Geometry;
pub use half_space::HalfSpace;
pub use hull::ConvexHull;
pub use mesh::TriangleMesh;
pub use polygon::Polygon;
pub use rectangle::Rectangle;
pub use ring::Ring;
pub use sphere::Sphere;
pub use torus::Torus;

use crate::error::Error;
use crate::mass::{MassProperties, MassProperties2, Moments, check};
use crate::math::{Pose, Quat, Vec3};
use std::sync::Arc;

/// Whether a shape is full or hollow.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Fill {
    /// Mass throughout the inside.
    #[default]
    Solid,
    /// Mass on the surface only, or on the outline of a planar shape.
    Shell {
        /// The same everywhere, and thin: terms in its square are left out \[m\].
        thickness: f64,
    },
}

/// How much mass a shape has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// Mass per volume \[kg/m³\]; for a planar shape, mass per area \[kg/m²\].
    Density(f64),
    /// Mass in total \[kg\], whatever the size.
    Mass(f64),
}

/// A geometry, placed on a body and given a mass.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// What it is, in its own frame.
    pub geometry: Geometry,
    /// Takes shape coordinates to body coordinates; the identity by default.
    pub pose: Pose,
    /// How much mass it has; by default a density of 1000 kg/m³ (water), or 1000 kg/m² for a planar shape.
    pub amount: Amount,
    /// Whether it is full or hollow; full by default.
    pub fill: Fill,
}

/// Constructors: dimensions in m, checked by [`Shape::validate`].
impl Shape {
    /// A geometry with the default pose, density and fill.
    pub fn new(geometry: impl Into<Geometry>) -> Self {
        Self { geometry: geometry.into(), pose: Pose::IDENTITY, amount: Amount::Density(1000.0), fill: Fill::Solid }
    }
    /// A ball.
    pub fn sphere(radius: f64) -> Self {
        Self::new(Sphere { radius })
    }
    /// A box with full edge lengths `size`.
    pub fn cuboid(size: impl Into<Vec3>) -> Self {
        Self::new(Cuboid { size: size.into() })
    }
    /// A cylinder of `length` along z between two half balls.
    pub fn capsule(radius: f64, length: f64) -> Self {
        Self::new(Capsule { radius, length })
    }
    /// A circular cylinder along z.
    pub fn cylinder(radius: f64, length: f64) -> Self {
        Self::new(Cylinder { radius, length })
    }
    /// A circular cone with its apex at z = ¾ `length` and its base at −¼ `length`.
    pub fn cone(radius: f64, length: f64) -> Self {
        Self::new(Cone { radius, length })
    }
    /// An ellipsoid with the given semi-axes.
    pub fn ellipsoid(semi_axes: impl Into<Vec3>) -> Self {
        Self::new(Ellipsoid { semi_axes: semi_axes.into() })
    }
    /// A torus about z: a tube of radius `minor` around a circle of radius `major`.
    pub fn torus(major: f64, minor: f64) -> Self {
        Self::new(Torus { major, minor })
    }
    /// Everything below the plane through the shape's origin with the outward `normal`, of any length. Without mass: for
    /// fixed bodies.
    pub fn half_space(normal: impl Into<Vec3>) -> Self {
        Self::new(HalfSpace { normal: normal.into() })
    }
    /// A triangle mesh; closed, if it is to have mass.
    pub fn mesh(mesh: impl Into<Arc<TriangleMesh>>) -> Self {
        Self::new(Geometry::Mesh(mesh.into()))
    }
    /// A convex polyhedron; [`ConvexHull::new`] makes one of points.
    pub fn hull(hull: impl Into<Arc<ConvexHull>>) -> Self {
        Self::new(Geometry::Hull(hull.into()))
    }
    /// A disc in the plane z = 0.
    pub fn disc(radius: f64) -> Self {
        Self::new(Disc { radius })
    }
    /// A rectangle in the plane z = 0, with full edge lengths `size` along x and y.
    pub fn rectangle(size: [f64; 2]) -> Self {
        Self::new(Rectangle { size })
    }
    /// A simple polygon in the plane z = 0, corners in either sense of rotation.
    pub fn polygon(points: impl Into<Vec<[f64; 2]>>) -> Self {
        Self::new(Polygon { points: points.into() })
    }
    /// What is between two circles in the plane z = 0.
    pub fn ring(inner: f64, outer: f64) -> Self {
        Self::new(Ring { inner, outer })
    }
}

/// Settings, to be chained; of two that contradict, the last one counts.
impl Shape {
    /// Sets the mass per volume \[kg/m³\], or per area of a planar shape \[kg/m²\].
    pub fn density(self, density: f64) -> Self {
        Self { amount: Amount::Density(density), ..self }
    }
    /// Sets the total mass instead of a density \[kg\].
    pub fn mass(self, mass: f64) -> Self {
        Self { amount: Amount::Mass(mass), ..self }
    }
    /// Makes it hollow: mass on the surface, of this thickness \[m\].
    pub fn shell(self, thickness: f64) -> Self {
        Self { fill: Fill::Shell { thickness }, ..self }
    }
    /// Puts the shape's origin at `position` in body coordinates \[m\].
    pub fn at(self, position: impl Into<Vec3>) -> Self {
        Self { pose: Pose::new(position.into(), self.pose.rot), ..self }
    }
    /// Sets the rotation from shape to body axes; made a unit quaternion here. The shape turns about its own origin.
    pub fn rotated(self, rot: impl Into<Quat>) -> Self {
        Self { pose: Pose::new(self.pose.x, rot.into().normalized()), ..self }
    }
    /// Sets the pose from shape to body coordinates.
    pub fn posed(self, pose: Pose) -> Self {
        self.at(pose.x).rotated(pose.rot)
    }
}

/// What follows from the description.
impl Shape {
    /// Checks everything but that it can have mass: a half-space or an open mesh is a fine shape of a fixed body.
    ///
    /// # Errors
    /// Names the first number that is not as it must be: `radius`, `size[1]`, `density`, `thickness`, `position`, …
    pub fn validate(&self) -> Result<(), Error> {
        self.geometry.validate()?;
        match self.amount {
            Amount::Density(density) => {
                let unit = if self.geometry.is_planar() { "kg/m²" } else { "kg/m³" };
                check::positive("density", density, unit)?;
            }
            Amount::Mass(mass) => {
                check::positive("mass", mass, "kg")?;
            }
        }
        if let Fill::Shell { thickness } = self.fill {
            check::positive("thickness", thickness, "m")?;
        }
        check::finite("position", self.pose.x)?;
        let length = self.pose.rot.norm_squared().sqrt();
        // A unit quaternion is one to a few roundings; anything else is not the rotation it seems to be.
        if (length - 1.0).abs() <= 1e-12 {
            return Ok(());
        }
        Err(Error::new("rotation", format!("must be a unit quaternion, has length {}", check::show(length))))
    }
    /// Mass, centre and second moment in body coordinates.
    ///
    /// # Errors
    /// As [`Shape::validate`]; also if the geometry has no mass properties: a half-space, an open mesh.
    pub fn moments(&self) -> Result<Moments, Error> {
        self.validate()?;
        let own = match self.amount {
            Amount::Density(density) => self.geometry.moments(self.fill, density)?,
            Amount::Mass(mass) => {
                let unit = self.geometry.moments(self.fill, 1.0)?;
                unit.with_mass_times(mass / unit.mass)
            }
        };
        Ok(own.transformed(self.pose))
    }
    /// Mass, centre and inertia in body coordinates.
    ///
    /// A planar shape is a thin plate here, with J₃ = J₁ + J₂.
    ///
    /// # Errors
    /// As [`Shape::moments`]; also if the result is outside the range of f64.
    pub fn mass_properties(&self) -> Result<MassProperties, Error> {
        self.moments()?.properties()
    }
    /// Mass, centre and inertia about z, for a body that moves in the plane z = 0.
    ///
    /// # Errors
    /// As [`Shape::mass_properties`].
    pub fn planar_mass_properties(&self) -> Result<MassProperties2, Error> {
        self.moments()?.planar()
    }
}

#[cfg(test)]
mod tests;
