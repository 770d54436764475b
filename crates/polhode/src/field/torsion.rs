//! A spring and damper between two orientations: a torque along the rotation vector that parts them.

use super::{BodyView, Field, Law, Wrench, at_least};
use crate::Error;
use crate::math::{Quat, Vec3};
use crate::store::BodyId;

/// Turns its two bodies towards a relative orientation with τ = k u − c (ω_b − ω_a), where u is the rotation vector left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorsionSpring {
    /// One body, or `None` for the world.
    pub a: Option<BodyId>,
    /// The other body.
    pub b: BodyId,
    /// k [N·m/rad], at least 0.
    pub stiffness: f64,
    /// c [N·m·s/rad], at least 0.
    pub damping: f64,
    /// The rest orientation: b's own frame → a's own frame.
    pub rest: Quat,
}

impl Field {
    /// A torsion spring of `stiffness` [N·m/rad] that holds the frame of `b` aligned with that of `a` (or of the world),
    /// undamped.
    pub fn torsion_spring(a: Option<BodyId>, b: BodyId, stiffness: f64) -> Self {
        let rest = Quat::IDENTITY;
        Self { law: Law::TorsionSpring(TorsionSpring { a, b, stiffness, damping: 0.0, rest }), only: None }
    }
    /// The relative orientation in which a torsion spring is at rest; other laws have none.
    pub fn rest_rotation(mut self, rest: Quat) -> Self {
        if let Law::TorsionSpring(s) = &mut self.law {
            s.rest = rest;
        }
        self
    }
}

impl TorsionSpring {
    /// The rotation vector from where b is to where it would be at rest, world axes \[rad\].
    fn turn_to_rest(&self, a: Option<&BodyView>, b: &BodyView) -> Vec3 {
        let rot_a = a.map_or(Quat::IDENTITY, |a| a.pose().rot);
        (rot_a * self.rest * b.pose().rot.conjugate()).to_rotation_vector()
    }
    /// The wrenches on `a` and `b`: pure torques.
    pub fn wrenches(&self, a: Option<&BodyView>, b: &BodyView) -> (Wrench, Wrench) {
        let w = b.w - a.map_or(Vec3::ZERO, |a| a.w);
        let torque = self.turn_to_rest(a, b) * self.stiffness - w * self.damping;
        let on_b = Wrench { force: Vec3::ZERO, torque };
        (on_b.opposite(), on_b)
    }
    /// ½ k |u|² \[J\].
    pub fn potential(&self, a: Option<&BodyView>, b: &BodyView) -> f64 {
        0.5 * self.stiffness * self.turn_to_rest(a, b).length_squared()
    }
    pub(super) fn validate(&self) -> Result<(), Error> {
        at_least("stiffness", self.stiffness, 0.0, "N·m/rad")?;
        at_least("damping", self.damping, 0.0, "N·m·s/rad")?;
        let norm = self.rest.norm_squared();
        if self.rest.is_finite() && (norm - 1.0).abs() < 1e-6 {
            return Ok(());
        }
        Err(Error::new("rest", format!("is no rotation: the squares of its components sum to {norm}, not 1")))
    }
}
