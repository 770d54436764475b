//! Forces that follow from where bodies are and how they move: one law a file.
//!
//! A law is a pure function of a [`BodyView`]; it knows no world. Laws on one body give a [`Wrench`] about the centre of
//! mass, laws between two give one for each, equal and opposite to the bit.

mod buoyancy;
mod central;
mod custom;
mod drag;
mod mutual_gravity;
mod spring;
mod torsion;

pub use buoyancy::Buoyancy;
pub use central::Central;
pub use custom::Custom;
pub use drag::{LinearDrag, QuadraticDrag};
pub use mutual_gravity::MutualGravity;
pub use spring::Spring;
pub use torsion::TorsionSpring;

use crate::Error;
use crate::math::{Pose, Quat, Vec3};
use crate::shape::Shape;
use crate::store::BodyId;

/// A force through the centre of mass and a torque about it, world axes.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Wrench {
    /// Force \[N\].
    pub force: Vec3,
    /// Torque about the centre of mass [N·m].
    pub torque: Vec3,
}

impl Wrench {
    /// Nothing.
    pub const ZERO: Self = Self { force: Vec3::ZERO, torque: Vec3::ZERO };

    /// The force `f` \[N\] at `arm` from the centre of mass \[m\]: F = f, τ = r × f.
    pub fn at(f: Vec3, arm: Vec3) -> Self {
        Self { force: f, torque: arm.cross(f) }
    }
    /// Both parts negated.
    pub fn opposite(self) -> Self {
        Self { force: -self.force, torque: -self.torque }
    }
    /// Whether both parts are finite.
    pub fn is_finite(&self) -> bool {
        self.force.is_finite() && self.torque.is_finite()
    }
}

impl core::ops::AddAssign for Wrench {
    fn add_assign(&mut self, b: Self) {
        self.force += b.force;
        self.torque += b.torque;
    }
}

/// What a law may know of a body.
#[derive(Clone, Copy, Debug)]
pub struct BodyView<'a> {
    /// Its name.
    pub id: BodyId,
    /// Simulated time \[s\].
    pub time: f64,
    /// Mass \[kg\]; 0 for a body that forces do not move.
    pub mass: f64,
    /// Principal moments of inertia [kg·m²].
    pub inertia: Vec3,
    /// Centre of mass, world \[m\].
    pub x: Vec3,
    /// Principal axes → world axes.
    pub rot: Quat,
    /// Velocity of the centre of mass, world \[m/s\].
    pub v: Vec3,
    /// Angular velocity, world \[rad/s\].
    pub w: Vec3,
    /// Centre of mass and principal axes, in the body's own frame.
    pub frame: Pose,
    /// Shapes, in the body's own frame.
    pub shapes: &'a [Shape],
    /// Uniform gravity of the world \[m/s²\].
    pub gravity: Vec3,
}

impl BodyView<'_> {
    /// The body's own frame in the world.
    pub fn pose(&self) -> Pose {
        Pose::new(self.x, self.rot) * self.frame.inverse()
    }
    /// A point given from the centre of mass along the principal axes, as an arm in world axes \[m\].
    pub fn arm(&self, point: Vec3) -> Vec3 {
        self.rot.rotate(point)
    }
    /// The velocity of the material point at `arm` from the centre of mass: v + ω × r.
    pub fn velocity_at(&self, arm: Vec3) -> Vec3 {
        self.v + self.w.cross(arm)
    }
}

/// A law of force.
#[derive(Clone, Debug)]
pub enum Law {
    /// An inverse-square attraction to a point.
    Central(Central),
    /// Drag in proportion to the velocity.
    LinearDrag(LinearDrag),
    /// Drag in proportion to the square of the velocity.
    QuadraticDrag(QuadraticDrag),
    /// The lift of a fluid at rest.
    Buoyancy(Buoyancy),
    /// A spring and damper between two points.
    Spring(Spring),
    /// A spring and damper between two orientations.
    TorsionSpring(TorsionSpring),
    /// Gravitation of all bodies on each other.
    MutualGravity(MutualGravity),
    /// A law that the user wrote.
    Custom(Custom),
}

/// A law and the bodies that it is for.
#[derive(Clone, Debug)]
pub struct Field {
    /// The law.
    pub law: Law,
    /// The bodies that feel it, in order; `None` is every dynamic body. Springs name their bodies themselves.
    pub only: Option<Vec<BodyId>>,
}

impl Field {
    /// Restricts the law to some bodies.
    pub fn only(mut self, bodies: impl IntoIterator<Item = BodyId>) -> Self {
        let mut only: Vec<BodyId> = bodies.into_iter().collect();
        only.sort_unstable();
        only.dedup();
        self.only = Some(only);
        self
    }
    /// Whether the body feels the law. The list has to be in order, as it is in a world.
    pub fn applies_to(&self, id: BodyId) -> bool {
        self.only.as_ref().is_none_or(|only| only.binary_search(&id).is_ok())
    }
    /// Whether the law asks for the velocity, so that a symmetric step has to solve for it.
    pub fn depends_on_velocity(&self) -> bool {
        match &self.law {
            Law::Central(_) | Law::Buoyancy(_) | Law::MutualGravity(_) => false,
            Law::LinearDrag(_) | Law::QuadraticDrag(_) => true,
            Law::Spring(s) => s.damping != 0.0,
            Law::TorsionSpring(s) => s.damping != 0.0,
            Law::Custom(c) => c.depends_on_velocity,
        }
    }
    /// Checks the parameters.
    ///
    /// # Errors
    /// The parameter that is not finite or out of range.
    pub fn validate(&self) -> Result<(), Error> {
        match &self.law {
            Law::Central(f) => f.validate(),
            Law::LinearDrag(f) => f.validate(),
            Law::QuadraticDrag(f) => f.validate(),
            Law::Buoyancy(f) => f.validate(),
            Law::Spring(f) => f.validate(),
            Law::TorsionSpring(f) => f.validate(),
            Law::MutualGravity(f) => f.validate(),
            Law::Custom(_) => Ok(()),
        }
    }
}

/// One end of a spring: a point of a body, or of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor {
    /// The body, or `None` for the world.
    pub body: Option<BodyId>,
    /// The point: in the body's own frame, or in the world \[m\].
    pub point: Vec3,
}

impl Anchor {
    /// A point of a body, in the body's own frame \[m\].
    pub fn on(body: BodyId, point: impl Into<Vec3>) -> Self {
        Self { body: Some(body), point: point.into() }
    }
    /// A point of the world \[m\].
    pub fn world(point: impl Into<Vec3>) -> Self {
        Self { body: None, point: point.into() }
    }
}

/// Where an anchor is now.
#[derive(Clone, Copy, Debug)]
pub struct AnchorState {
    /// Position, world \[m\].
    pub x: Vec3,
    /// Velocity, world \[m/s\].
    pub v: Vec3,
    /// From the body's centre of mass, world axes \[m\].
    pub arm: Vec3,
}

impl Anchor {
    /// Where the anchor is, given the body it names.
    pub fn state(&self, body: Option<&BodyView>) -> AnchorState {
        match body {
            None => AnchorState { x: self.point, v: Vec3::ZERO, arm: Vec3::ZERO },
            Some(b) => {
                let arm = b.arm(b.frame.inverse_point(self.point));
                AnchorState { x: b.x + arm, v: b.velocity_at(arm), arm }
            }
        }
    }
}

/// Refuses a parameter that is not finite or below `least`.
fn at_least(name: &str, value: f64, least: f64, unit: &str) -> Result<(), Error> {
    if value.is_finite() && value >= least {
        return Ok(());
    }
    Err(Error::new(name, format!("is {value} {unit}; it must be finite and at least {least}")))
}

/// Refuses a vector that is not finite.
fn finite(name: &str, value: Vec3) -> Result<(), Error> {
    if value.is_finite() {
        return Ok(());
    }
    Err(Error::new(name, format!("is {:?}; every component must be finite", value.to_array())))
}
