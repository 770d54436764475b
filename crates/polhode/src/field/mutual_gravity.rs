//! Newton's gravitation of all bodies on each other, summed directly.
//!
//! A body is the set of its shapes, each a point mass at its own centre: exact for spheres outside each other, and it gives
//! a dumbbell the torque that a single point could not. The pull of i on j and of j on i are the same bits with opposite
//! signs, because d → −d and m_i m_j → m_j m_i round alike.

use super::{Field, Law, at_least};
use crate::Error;
use crate::math::Vec3;

/// F = G m_i m_j d/(|d|² + ε²)^{3/2} between every two point masses of different bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MutualGravity {
    /// G [m³/(kg·s²)]; 6.674e-11 in nature.
    pub constant: f64,
    /// ε \[m\], at least 0: the distance below which the pull is weakened, so that close passes stay finite.
    pub softening: f64,
}

impl Field {
    /// Gravitation of all dynamic bodies on each other with constant G [m³/(kg·s²)] and Plummer softening ε \[m\].
    pub fn mutual_gravity(constant: f64, softening: f64) -> Self {
        Self { law: Law::MutualGravity(MutualGravity { constant, softening }), only: None }
    }
}

impl MutualGravity {
    /// The force on a point mass `m_a` at `a` from `m_b` at `b`, world \[N\]; zero where they coincide.
    #[inline]
    pub fn pull(&self, m_a: f64, a: Vec3, m_b: f64, b: Vec3) -> Vec3 {
        let d = b - a;
        let r2 = d.length_squared() + self.softening * self.softening;
        if r2 == 0.0 {
            return Vec3::ZERO;
        }
        d * (self.constant * (m_a * m_b) / (r2 * r2.sqrt()))
    }
    /// −G m_a m_b/√(|d|² + ε²) \[J\].
    #[inline]
    pub fn potential(&self, m_a: f64, a: Vec3, m_b: f64, b: Vec3) -> f64 {
        let r2 = (b - a).length_squared() + self.softening * self.softening;
        if r2 == 0.0 { 0.0 } else { -self.constant * (m_a * m_b) / r2.sqrt() }
    }
    pub(super) fn validate(&self) -> Result<(), Error> {
        at_least("constant", self.constant, f64::MIN, "m³/(kg·s²)")?;
        at_least("softening", self.softening, 0.0, "m")
    }
}
