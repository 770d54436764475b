//! Drag: the resistance of a medium that moves with the wind.

use super::{BodyView, Field, Law, Wrench, at_least, finite};
use crate::Error;
use crate::math::Vec3;

/// F = −c (v − u), τ = −c_r ω.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearDrag {
    /// c [N·s/m], at least 0.
    pub linear: f64,
    /// c_r [N·m·s/rad], at least 0.
    pub angular: f64,
    /// Velocity u of the medium, world \[m/s\].
    pub wind: Vec3,
}

/// F = −k |v − u| (v − u), τ = −k_r |ω| ω.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuadraticDrag {
    /// k = ½ ρ C_d A [N·s²/m²], at least 0.
    pub linear: f64,
    /// k_r [N·m·s²/rad²], at least 0.
    pub angular: f64,
    /// Velocity u of the medium, world \[m/s\].
    pub wind: Vec3,
}

impl Field {
    /// Drag in proportion to the velocity: `linear` [N·s/m] and `angular` [N·m·s/rad].
    pub fn linear_drag(linear: f64, angular: f64) -> Self {
        Self { law: Law::LinearDrag(LinearDrag { linear, angular, wind: Vec3::ZERO }), only: None }
    }
    /// Drag in proportion to the square of the velocity: `linear` [N·s²/m²] and `angular` [N·m·s²/rad²].
    pub fn quadratic_drag(linear: f64, angular: f64) -> Self {
        Self { law: Law::QuadraticDrag(QuadraticDrag { linear, angular, wind: Vec3::ZERO }), only: None }
    }
    /// The velocity of the medium \[m/s\], for the two laws of drag; others have none.
    pub fn wind(mut self, velocity: impl Into<Vec3>) -> Self {
        match &mut self.law {
            Law::LinearDrag(d) => d.wind = velocity.into(),
            Law::QuadraticDrag(d) => d.wind = velocity.into(),
            _ => {}
        }
        self
    }
}

impl LinearDrag {
    /// The drag on the body.
    pub fn wrench(&self, body: &BodyView) -> Wrench {
        Wrench { force: (body.v - self.wind) * -self.linear, torque: body.w * -self.angular }
    }
    pub(super) fn validate(&self) -> Result<(), Error> {
        at_least("linear", self.linear, 0.0, "N·s/m")?;
        at_least("angular", self.angular, 0.0, "N·m·s/rad")?;
        finite("wind", self.wind)
    }
}

impl QuadraticDrag {
    /// The drag on the body.
    pub fn wrench(&self, body: &BodyView) -> Wrench {
        let v = body.v - self.wind;
        Wrench { force: v * (-self.linear * v.length()), torque: body.w * (-self.angular * body.w.length()) }
    }
    pub(super) fn validate(&self) -> Result<(), Error> {
        at_least("linear", self.linear, 0.0, "N·s²/m²")?;
        at_least("angular", self.angular, 0.0, "N·m·s²/rad²")?;
        finite("wind", self.wind)
    }
}
