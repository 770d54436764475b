//! The closed set of geometries.

use super::{
    Capsule, Cone, ConvexHull, Cuboid, Cylinder, Disc, Ellipsoid, Fill, HalfSpace, Polygon, Rectangle, Ring, Sphere,
    Torus, TriangleMesh,
};
use crate::error::Error;
use crate::mass::Moments;
use std::sync::Arc;

/// A shape in its own frame.
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry {
    /// A ball.
    Sphere(Sphere),
    /// A box.
    Cuboid(Cuboid),
    /// A cylinder between two half balls.
    Capsule(Capsule),
    /// A circular cylinder.
    Cylinder(Cylinder),
    /// A circular cone.
    Cone(Cone),
    /// An ellipsoid.
    Ellipsoid(Ellipsoid),
    /// A torus.
    Torus(Torus),
    /// One side of a plane; without mass.
    HalfSpace(HalfSpace),
    /// A triangle mesh, shared by all shapes that use it.
    Mesh(Arc<TriangleMesh>),
    /// A convex polyhedron, shared by all shapes that use it.
    Hull(Arc<ConvexHull>),
    /// A disc, planar.
    Disc(Disc),
    /// A rectangle, planar.
    Rectangle(Rectangle),
    /// A simple polygon, planar.
    Polygon(Polygon),
    /// What is between two circles, planar.
    Ring(Ring),
}

impl Geometry {
    /// The word for it in scenes, recordings and messages: `half_space`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Sphere(_) => "sphere",
            Self::Cuboid(_) => "cuboid",
            Self::Capsule(_) => "capsule",
            Self::Cylinder(_) => "cylinder",
            Self::Cone(_) => "cone",
            Self::Ellipsoid(_) => "ellipsoid",
            Self::Torus(_) => "torus",
            Self::HalfSpace(_) => "half_space",
            Self::Mesh(_) => "mesh",
            Self::Hull(_) => "hull",
            Self::Disc(_) => "disc",
            Self::Rectangle(_) => "rectangle",
            Self::Polygon(_) => "polygon",
            Self::Ring(_) => "ring",
        }
    }
    /// Whether it lies in the plane z = 0.
    pub fn is_planar(&self) -> bool {
        matches!(self, Self::Disc(_) | Self::Rectangle(_) | Self::Polygon(_) | Self::Ring(_))
    }
    /// Mass, centre and second moment in the shape's own frame, at `density` \[kg/m³; kg/m² if planar\].
    ///
    /// # Errors
    /// If a dimension, the density or the thickness is not as it must be, or the geometry cannot have mass.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match self {
            Self::Sphere(s) => s.moments(fill, density),
            Self::Cuboid(s) => s.moments(fill, density),
            Self::Capsule(s) => s.moments(fill, density),
            Self::Cylinder(s) => s.moments(fill, density),
            Self::Cone(s) => s.moments(fill, density),
            Self::Ellipsoid(s) => s.moments(fill, density),
            Self::Torus(s) => s.moments(fill, density),
            Self::HalfSpace(_) => Err(Error::new(
                self.name(),
                "has no mass: it belongs on a fixed body, or on one whose mass properties are given",
            )),
            Self::Mesh(s) => s.moments(fill, density),
            Self::Hull(s) => s.moments(fill, density),
            Self::Disc(s) => s.moments(fill, density),
            Self::Rectangle(s) => s.moments(fill, density),
            Self::Polygon(s) => s.moments(fill, density),
            Self::Ring(s) => s.moments(fill, density),
        }
    }
    /// Checks the dimensions.
    ///
    /// # Errors
    /// Names the first dimension that is not as it must be.
    pub fn validate(&self) -> Result<(), Error> {
        match self {
            Self::HalfSpace(s) => s.validate(),
            // Checked when they were made; a mesh need not be closed to be fixed.
            Self::Mesh(_) | Self::Hull(_) => Ok(()),
            // The closed forms check what they are given.
            _ => self.moments(Fill::Solid, 1.0).map(drop),
        }
    }
}

macro_rules! into_geometry {
    ($($shape:ident),*) => {$(
        impl From<$shape> for Geometry {
            fn from(shape: $shape) -> Self {
                Self::$shape(shape)
            }
        }
    )*};
}
into_geometry!(Sphere, Cuboid, Capsule, Cylinder, Cone, Ellipsoid, Torus, HalfSpace, Disc, Rectangle, Polygon, Ring);
