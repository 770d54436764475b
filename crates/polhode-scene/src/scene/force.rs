//! What acts on the bodies of a scene.

use crate::decode::{table, tagged, words};

table! {
    /// A force, a torque or an impulse on a body. Of a body that `repeat` copies, on every copy.
    "a force" Force {
        /// The body, by name.
        body: String;
        /// Force [N].
        force: Option<[f64; 3]>;
        /// Torque [N·m], besides that of the force.
        torque: Option<[f64; 3]>;
        /// Impulse [N·s], given once at `time`.
        impulse: Option<[f64; 3]>;
        /// Angular impulse [N·m·s], given once at `time`.
        angular_impulse: Option<[f64; 3]>;
        /// Point at which the force or impulse acts [m]; the centre of mass if absent.
        at: Option<[f64; 3]>;
        /// Frame of `at`: a point of the body, or one that stays in the world.
        at_frame: Frame = Frame::Body;
        /// Frame of the vectors: fixed in the world, or turning with the body.
        frame: Frame = Frame::World;
        /// When the force begins [s].
        from: Option<f64>, nonnegative;
        /// When it ends [s].
        until: Option<f64>, positive;
        /// When the impulse is given [s]; 0 if absent.
        time: Option<f64>, nonnegative;
    }
}

words! {
    /// The frame in which a vector is given.
    Frame {
        /// World axes.
        "world" World,
        /// Axes of the body.
        "body" Body,
    }
}

table! {
    /// A point of a body that is held in place, free to turn.
    "a pin" Pin {
        /// The body, by name.
        body: String;
        /// The point in body coordinates [m].
        point: [f64; 3] = [0.0, 0.0, 0.0];
        /// Where it is held, world coordinates [m]: the body starts with the point there, whatever its `position`. If absent,
        /// where it is at the start.
        at: Option<[f64; 3]>;
    }
}

tagged! {
    /// Forces by a law.
    "a field" Field {
        "central" Central,
        "linear-drag" LinearDrag,
        "quadratic-drag" QuadraticDrag,
        "buoyancy" Buoyancy,
        "spring" Spring,
        "torsion-spring" TorsionSpring,
        "mutual-gravity" MutualGravity,
    }
}

table! {
    /// Attraction to a point, acceleration μ/r² of each centre of mass.
    "a central field" Central {
        /// The point [m].
        center: [f64; 3] = [0.0, 0.0, 0.0];
        /// Gravitational parameter μ [m³/s²]; negative repels.
        mu: f64;
        /// Bodies it acts on; all if absent.
        only: Option<Vec<String>>;
    }
}

table! {
    /// Drag proportional to velocity and to angular velocity.
    "a drag" LinearDrag {
        /// Force per velocity [N·s/m].
        linear: f64, nonnegative = 0.0;
        /// Torque per angular velocity [N·m·s/rad].
        angular: f64, nonnegative = 0.0;
        /// Velocity of the medium [m/s].
        wind: [f64; 3] = [0.0, 0.0, 0.0];
        /// Bodies it acts on; all if absent.
        only: Option<Vec<String>>;
    }
}

table! {
    /// Drag proportional to the squares of speed and of angular speed.
    "a drag" QuadraticDrag {
        /// Force per squared speed [N·s²/m²]: half of density × drag coefficient × area.
        linear: f64, nonnegative = 0.0;
        /// Torque per squared angular speed [N·m·s²/rad²].
        angular: f64, nonnegative = 0.0;
        /// Velocity of the medium [m/s].
        wind: [f64; 3] = [0.0, 0.0, 0.0];
        /// Bodies it acts on; all if absent.
        only: Option<Vec<String>>;
    }
}

table! {
    /// The lift of a fluid at rest on bodies of spheres and cuboids.
    "a fluid" Buoyancy {
        /// Density of the fluid [kg/m³].
        density: f64, nonnegative = 1000.0;
        /// Height of its surface above the origin, against gravity [m].
        level: f64 = 0.0;
        /// Bodies it acts on; all if absent.
        only: Option<Vec<String>>;
    }
}

table! {
    /// A spring with a damper between two points.
    "a spring" Spring {
        /// First body, by name.
        a: String;
        /// Second body, by name; the world if absent.
        b: Option<String>;
        /// End on the first body, in its coordinates [m].
        point_a: [f64; 3] = [0.0, 0.0, 0.0];
        /// End on the second body, in its coordinates, or in the world [m].
        point_b: [f64; 3] = [0.0, 0.0, 0.0];
        /// Stiffness [N/m].
        stiffness: f64, nonnegative;
        /// Damping [N·s/m].
        damping: f64, nonnegative = 0.0;
        /// Length without force [m]; the length at the start if absent.
        rest_length: Option<f64>, nonnegative;
    }
}

table! {
    /// A spring that turns two bodies back to the relative orientation of the start.
    "a torsion spring" TorsionSpring {
        /// First body, by name.
        a: String;
        /// Second body, by name; the world if absent.
        b: Option<String>;
        /// Stiffness [N·m/rad].
        stiffness: f64, nonnegative;
        /// Damping [N·m·s/rad].
        damping: f64, nonnegative = 0.0;
    }
}

table! {
    /// The attraction of all bodies to each other.
    "mutual gravity" MutualGravity {
        /// Gravitational constant [m³/(kg·s²)]; nature's if absent.
        constant: f64, nonnegative = 6.6743e-11;
        /// Distance ε [m] that softens the law to m₁m₂ r/(r²+ε²)^{3/2}.
        softening: f64, nonnegative = 0.0;
    }
}
