//! A scene: everything a run needs to know, as plain data.
//!
//! ```toml
//! title = "Tennis racket"
//! time = 20
//! gravity = 0
//!
//! [[body]]
//! name = "racket"
//! shape = { type = "cuboid", size = [0.7, 0.3, 0.05], density = 400 }
//! angular_velocity = [0.001, 5, 0.001]
//! ```

mod body;
mod check;
mod file;
mod force;
mod shape;
mod values;

pub use body::{Body, Kind, Repeat};
pub use file::SceneFile;
pub use force::{
    Buoyancy, Central, Field, Force, Frame, LinearDrag, MutualGravity, Pin, QuadraticDrag, Spring, TorsionSpring,
};
pub use shape::{
    Capsule, Cone, Cuboid, Cylinder, Disc, Ellipsoid, Form, HalfSpace, Hull, Mesh, Polygon, Rectangle, Ring, Shape,
    Shapes, Sphere, Torus,
};
pub use values::{AxisAngle, Color, EulerAngles, Gravity, Inertia, OneOrMany, Rotation, TimeStep};

use crate::decode::{Decode, Definitions, table, words};
use polhode::math::Vec3;
use serde_json::{Value as Json, json};

table! {
    /// A scene of rigid bodies for polhode.
    "a scene" Scene {
        flatten /// How it is computed.
            settings: Settings;
        flatten /// What is in it.
            parts: Parts;
        /// What it is called.
        title: String = "";
        /// What happens, in two lines.
        explanation: String = "";
        /// What to watch.
        look_for: String = "";
        /// Rows of the lecture that it shows.
        row: OneOrMany<u32>;
        /// Whether everything moves in the plane z = 0.
        planar: bool = false;
        /// What the page draws at the start; what suits the scene if absent.
        show: Option<Vec<Show>>;
        /// Name of the body that the camera goes with.
        follow: Option<String>;
        /// What is recorded of each body, besides position, rotation and what `show` needs.
        record: Vec<Channel>;
        /// Plots under the picture; energy and momenta if there are none.
        plot: Vec<Plot>;
        /// Variants that run side by side; each changes what it states and keeps the rest.
        compare: Vec<Compare>;
    }
}

table! {
    /// How a scene is computed. What is absent has its default, or in a variant the scene's value.
    "settings" Settings derive Default {
        /// Gravity: a vector [m/s²], or one number, how strongly it pulls down (−z; planar: −y); 9.81 if absent.
        gravity: Option<Gravity>;
        /// How long the run is [s]; 10 if absent.
        time: Option<f64>, positive;
        /// Time step [s], a number or a quotient such as "1/60"; 1/60 if absent.
        dt: Option<TimeStep>, positive;
        /// Integrator, such as "pdmv6", "suzuki4:pdmv10" or "rk4".
        integrator: Option<String>;
        /// Time between two recorded frames [s]; about 1/60, and never less than a step, if absent.
        frame_interval: Option<TimeStep>, positive;
        /// Integrator of a second run, at a tenth of the step, that attitudes are compared with.
        reference: Option<String>;
        /// Formulas that are used as the lecture's slides print them.
        slides: Option<Vec<Slide>>;
    }
}

table! {
    /// What is in a scene.
    "a scene" Parts derive Default {
        /// The bodies.
        body: Vec<Body>;
        /// Forces, torques and impulses on single bodies.
        force: Vec<Force>;
        /// Forces by a law.
        field: Vec<Field>;
        /// Points that are held in place.
        pin: Vec<Pin>;
    }
}

table! {
    /// A variant of the scene. A list of bodies, forces, fields or pins in it replaces the scene's list.
    "a variant" Compare derive Default {
        flatten /// How it is computed, where that differs.
            settings: Settings;
        /// What it is called; unique in the scene.
        label: String;
        /// Other bodies.
        body: Option<Vec<Body>>;
        /// Other forces, torques and impulses.
        force: Option<Vec<Force>>;
        /// Other forces by a law.
        field: Option<Vec<Field>>;
        /// Other points that are held.
        pin: Option<Vec<Pin>>;
    }
}

table! {
    /// A plot of one or more series over time.
    "a plot" Plot {
        /// What it is called.
        title: String;
        /// Names of the series: of the whole scene such as `energy`, or of a body such as `top.speed`.
        series: Vec<String>;
        /// Unit on the axis.
        unit: String = "";
        /// Whether the axis is logarithmic.
        log: bool = false;
    }
}

words! {
    /// What can be recorded of each body, besides position and rotation.
    Channel {
        /// Centre of mass [m].
        "center" Center,
        /// Velocity of the centre of mass [m/s].
        "velocity" Velocity,
        /// Angular velocity [rad/s].
        "angular_velocity" AngularVelocity,
        /// Angular momentum about the centre of mass [kg·m²/s].
        "angular_momentum" AngularMomentum,
        /// Sum of the forces [N].
        "force" Force,
        /// Sum of the torques about the centre of mass [N·m].
        "torque" Torque,
        /// Tangent of the path.
        "tangent" Tangent,
        /// Normal of the path (Frenet).
        "normal" Normal,
        /// A normal carried along without twisting (Bishop).
        "parallel" Parallel,
        /// The matrix of an explicit scheme, which is no rotation any more.
        "matrix" Matrix,
    }
}

words! {
    /// What the page draws.
    Show {
        /// The axes of each body.
        "axes" Axes,
        /// Angular velocity.
        "omega" Omega,
        /// Angular momentum.
        "momentum" Momentum,
        /// Velocity.
        "velocity" Velocity,
        /// Force.
        "force" Force,
        /// Torque.
        "torque" Torque,
        /// The path of the centre of mass.
        "path" Path,
        /// Tangent, normal and binormal of the path.
        "frenet" Frenet,
        /// A frame carried along the path without twisting.
        "parallel" Parallel,
        /// Where the body was a moment ago.
        "trail" Trail,
        /// The curve of the angular velocity in the body.
        "polhode" Polhode,
        /// The curve of the angular velocity in space.
        "herpolhode" Herpolhode,
    }
}

words! {
    /// A formula of the lecture's slides that is wrong as printed.
    Slide {
        /// ṗ = F(F·r), the force projected on the lever.
        "force-projection" ForceProjection,
        /// τ = F × r instead of r × F.
        "torque-sign" TorqueSign,
        /// J₃₃ = y² + z² instead of x² + y².
        "inertia-33" Inertia33,
        /// R ← R + h [ω]× R, which leaves the rotations.
        "explicit-r" ExplicitR,
    }
}

/// How a variant is computed, with every default in its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Resolved {
    /// Gravity, world axes [m/s²].
    pub gravity: Vec3,
    /// How long the run is \[s\].
    pub time: f64,
    /// Time step \[s\].
    pub dt: f64,
    /// Integrator.
    pub integrator: String,
    /// Time between two recorded frames \[s\].
    pub frame_interval: f64,
    /// Integrator of the run that attitudes are compared with.
    pub reference: Option<String>,
    /// Formulas taken literally from the slides.
    pub slides: Vec<Slide>,
}

/// One run of a scene: the scene itself, or one of its variants.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// What it is called; the integrator if the scene has no variants.
    pub label: String,
    /// How it is computed.
    pub settings: Resolved,
    /// What is in it.
    pub parts: Parts,
    /// Where its parts stand in the scene, for errors: `""` or `"compare[2]"`, for bodies, forces, fields and pins.
    pub places: [String; 4],
}

/// The integrator of a scene that names none.
pub const DEFAULT_INTEGRATOR: &str = "pdmv6";

impl Settings {
    /// These settings where they state something, and `outer` where they do not.
    fn over(&self, outer: &Self) -> Self {
        Self {
            gravity: self.gravity.or(outer.gravity),
            time: self.time.or(outer.time),
            dt: self.dt.or(outer.dt),
            integrator: self.integrator.clone().or_else(|| outer.integrator.clone()),
            frame_interval: self.frame_interval.or(outer.frame_interval),
            reference: self.reference.clone().or_else(|| outer.reference.clone()),
            slides: self.slides.clone().or_else(|| outer.slides.clone()),
        }
    }

    fn resolved(self, planar: bool) -> Resolved {
        let dt = self.dt.map_or(1.0 / 60.0, |dt| dt.0);
        Resolved {
            gravity: self.gravity.unwrap_or(Gravity::Down(9.81)).vector(planar),
            time: self.time.unwrap_or(10.0),
            dt,
            integrator: self.integrator.unwrap_or_else(|| DEFAULT_INTEGRATOR.to_owned()),
            frame_interval: self.frame_interval.map_or_else(|| dt.max(1.0 / 60.0), |interval| interval.0),
            reference: self.reference,
            slides: self.slides.unwrap_or_default(),
        }
    }
}

impl Scene {
    /// The runs of this scene: one for each `[[compare]]`, or the scene itself if there is none.
    pub fn variants(&self) -> Vec<Variant> {
        if self.compare.is_empty() {
            let settings = self.settings.clone().resolved(self.planar);
            let label = settings.integrator.clone();
            return vec![Variant { label, settings, parts: self.parts.clone(), places: Default::default() }];
        }
        self.compare.iter().enumerate().map(|(i, compare)| self.variant(i, compare)).collect()
    }

    fn variant(&self, i: usize, compare: &Compare) -> Variant {
        let own = |stated: bool| if stated { format!("compare[{i}]") } else { String::new() };
        Variant {
            label: compare.label.clone(),
            settings: compare.settings.over(&self.settings).resolved(self.planar),
            parts: Parts {
                body: compare.body.clone().unwrap_or_else(|| self.parts.body.clone()),
                force: compare.force.clone().unwrap_or_else(|| self.parts.force.clone()),
                field: compare.field.clone().unwrap_or_else(|| self.parts.field.clone()),
                pin: compare.pin.clone().unwrap_or_else(|| self.parts.pin.clone()),
            },
            places: [
                own(compare.body.is_some()),
                own(compare.force.is_some()),
                own(compare.field.is_some()),
                own(compare.pin.is_some()),
            ],
        }
    }
}

/// The JSON schema (draft 2020-12) of a scene file, for editors and for documentation.
pub fn schema() -> Json {
    let mut definitions = Definitions::new();
    let reference = Scene::schema(&mut definitions);
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "polhode scene",
        "$ref": reference["$ref"],
        "$defs": definitions,
    })
}
