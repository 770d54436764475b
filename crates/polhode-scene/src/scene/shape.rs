//! What a body is made of.

use super::values::{OneOrMany, Rotation};
use crate::decode::{table, tagged};

table! {
    /// A part of a body: a form, where it sits in the body, and how heavy it is.
    "a shape" Shape {
        flatten /// Which form, with its dimensions.
            form: Form;
        /// Density [kg/m³] (of a planar form: [kg/m²]); 1000 if neither this nor a mass is given.
        density: Option<f64>, positive;
        /// Mass [kg], instead of a density.
        mass: Option<f64>, positive;
        /// Thickness [m] of a hollow shape's wall; solid if absent.
        shell: Option<f64>, positive;
        /// Origin of the form in body coordinates [m].
        position: [f64; 3] = [0.0, 0.0, 0.0];
        /// Rotation of the form: form axes to body axes.
        rotation: Rotation;
    }
}

/// The shapes of a body: one table or a list.
pub type Shapes = OneOrMany<Shape>;

tagged! {
    /// The forms. The axis of a form of revolution is its z; its origin is its centre of mass.
    "a shape" Form {
        "sphere" Sphere,
        "cuboid" Cuboid,
        "capsule" Capsule,
        "cylinder" Cylinder,
        "cone" Cone,
        "ellipsoid" Ellipsoid,
        "torus" Torus,
        "half_space" HalfSpace,
        "mesh" Mesh,
        "hull" Hull,
        "disc" Disc,
        "rectangle" Rectangle,
        "polygon" Polygon,
        "ring" Ring,
    }
}

table! {
    /// A ball.
    "a sphere" Sphere {
        /// Radius [m].
        radius: f64, positive;
    }
}

table! {
    /// A box.
    "a cuboid" Cuboid {
        /// Full edge lengths along x, y and z [m].
        size: [f64; 3], positive;
    }
}

table! {
    /// A cylinder with a half ball on each end.
    "a capsule" Capsule {
        /// Radius [m].
        radius: f64, positive;
        /// Length of the cylindrical part [m].
        length: f64, positive;
    }
}

table! {
    /// A circular cylinder.
    "a cylinder" Cylinder {
        /// Radius [m].
        radius: f64, positive;
        /// Full length [m].
        length: f64, positive;
    }
}

table! {
    /// A circular cone, apex at +z.
    "a cone" Cone {
        /// Radius of the base [m].
        radius: f64, positive;
        /// Height from base to apex [m].
        length: f64, positive;
    }
}

table! {
    /// An ellipsoid.
    "an ellipsoid" Ellipsoid {
        /// Half diameters along x, y and z [m].
        semi_axes: [f64; 3], positive;
    }
}

table! {
    /// A ring of round section about z.
    "a torus" Torus {
        /// Radius of the circle that the section's centre goes along [m].
        major: f64, positive;
        /// Radius of the section [m], smaller than `major`.
        minor: f64, positive;
    }
}

table! {
    /// Everything on one side of a plane; for fixed bodies, without mass.
    "a half-space" HalfSpace {
        /// Outward normal, of any length but zero.
        normal: [f64; 3] = [0.0, 0.0, 1.0];
    }
}

table! {
    /// A closed triangle mesh from a file. Its coordinates are taken as they are in the file, times `scale`.
    "a mesh" Mesh {
        /// OBJ, STL, PLY, glTF or GLB file, relative to the scene file.
        file: String;
        /// Metres in one unit of the file.
        scale: f64, positive = 1.0;
    }
}

table! {
    /// The convex hull of points.
    "a hull" Hull {
        /// At least four, not all in one plane; those inside are left out [m].
        points: Vec<[f64; 3]>;
    }
}

table! {
    /// A disc in the plane z = 0.
    "a disc" Disc {
        /// Radius [m].
        radius: f64, positive;
    }
}

table! {
    /// A rectangle in the plane z = 0.
    "a rectangle" Rectangle {
        /// Full edge lengths along x and y [m].
        size: [f64; 2], positive;
    }
}

table! {
    /// A simple polygon in the plane z = 0.
    "a polygon" Polygon {
        /// Corners in order [m].
        points: Vec<[f64; 2]>;
    }
}

table! {
    /// The part of a disc outside a smaller one.
    "a ring" Ring {
        /// Inner radius [m], smaller than `outer`.
        inner: f64, positive;
        /// Outer radius [m].
        outer: f64, positive;
    }
}
