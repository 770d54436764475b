//! An inverse-square attraction to a fixed point: F = −m μ d/|d|³.

use super::{BodyView, Field, Law, Wrench, at_least, finite};
use crate::Error;
use crate::math::Vec3;

/// The attraction of a point: a = −μ d/|d|³ with d from the centre to the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Central {
    /// The attracting point, world \[m\].
    pub center: Vec3,
    /// Gravitational parameter μ = G M [m³/s²]; negative repels.
    pub mu: f64,
}

impl Field {
    /// The inverse-square attraction of a point `center` \[m\] with μ = G M [m³/s²].
    pub fn central(center: impl Into<Vec3>, mu: f64) -> Self {
        Self { law: Law::Central(Central { center: center.into(), mu }), only: None }
    }
}

impl Central {
    /// The force on the body, through its centre of mass. At the very centre it has no direction and is zero.
    pub fn wrench(&self, body: &BodyView) -> Wrench {
        let d = body.x - self.center;
        let r2 = d.length_squared();
        if r2 == 0.0 {
            return Wrench::ZERO;
        }
        Wrench { force: d * (-(self.mu * body.mass) / (r2 * r2.sqrt())), torque: Vec3::ZERO }
    }
    /// −m μ/|d| \[J\]; at the very centre, where no force acts, 0.
    pub fn potential(&self, body: &BodyView) -> f64 {
        let r = (body.x - self.center).length();
        if r == 0.0 { 0.0 } else { -self.mu * body.mass / r }
    }
    pub(super) fn validate(&self) -> Result<(), Error> {
        finite("center", self.center)?;
        at_least("mu", self.mu, f64::MIN, "m³/s²")
    }
}
