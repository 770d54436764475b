//! A body of a scene.

use super::shape::Shapes;
use super::values::{Color, Inertia, Rotation};
use crate::decode::{table, words};

table! {
    /// A rigid body, or a grid of equal ones.
    "a body" Body {
        /// Name, unique in the scene. Copies made by `repeat` are called `name.0`, `name.1`, …
        name: String;
        /// Whether forces move it, nothing does, or it moves as prescribed.
        kind: Kind = Kind::Dynamic;
        /// What it is made of: one shape or a list.
        shape: Shapes;
        /// Point masses `[x, y, z, m]` in body coordinates [m, kg], besides the shapes.
        particles: Vec<[f64; 4]>;
        /// Total mass [kg]. With `inertia` it replaces what the shapes say; alone it scales their densities.
        mass: Option<f64>, positive;
        /// Inertia about the centre of mass, body axes [kg·m²]: three moments, a 3×3 matrix, or in a planar scene one number.
        inertia: Option<Inertia>;
        /// Centre of mass in body coordinates [m], with `inertia`.
        center: Option<[f64; 3]>;
        /// Where the origin of the body's frame is at the start [m].
        position: [f64; 3] = [0.0, 0.0, 0.0];
        /// How the body is turned at the start.
        rotation: Rotation;
        /// Velocity of the centre of mass at the start [m/s].
        velocity: [f64; 3] = [0.0, 0.0, 0.0];
        /// Angular velocity at the start, world axes [rad/s].
        angular_velocity: Option<[f64; 3]>;
        /// Angular velocity at the start, world axes [°/s].
        angular_velocity_degrees: Option<[f64; 3]>;
        /// Angular velocity at the start, body axes [rad/s].
        angular_velocity_body: Option<[f64; 3]>;
        /// Angular momentum about the centre of mass at the start, world axes [kg·m²/s].
        angular_momentum: Option<[f64; 3]>;
        /// Factor on the scene's gravity.
        gravity_scale: f64 = 1.0;
        /// Colour in the picture; chosen for you if absent.
        color: Option<Color>;
        /// Copies on a grid.
        repeat: Option<Repeat>;
    }
}

words! {
    /// How a body moves.
    Kind {
        /// Forces and torques move it.
        "dynamic" Dynamic,
        /// It stays where it is.
        "fixed" Fixed,
        /// It keeps the velocity and angular velocity that it is given, whatever acts on it.
        "kinematic" Kinematic,
    }
}

table! {
    /// Copies of a body on a grid that begins at its position.
    "a grid" Repeat {
        /// How many along x, y and z.
        count: [u32; 3], positive;
        /// Distance from one to the next along x, y and z [m].
        spacing: [f64; 3] = [1.0, 1.0, 1.0];
    }
}
