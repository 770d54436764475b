//! q ← exp(hω) q with ω at the start of the step: the rotation of symplectic Euler.
//!
//! Order 1. Turns about the right axis only at the start, so that the energy drifts; L is untouched.

use super::phase::angular_velocity;
use crate::math::{Quat, Vec3};

/// The attitude after h \[s\] with ω = R J0⁻¹ Rᵀ L frozen at its initial value; `l` in world axes \[kg·m²/s\], principal
/// moments `inertia` > 0 \[kg·m²\].
pub fn rotate(rot: Quat, l: Vec3, inertia: Vec3, h: f64) -> Quat {
    (Quat::from_rotation_vector(angular_velocity(rot, l, inertia) * h) * rot).renormalized()
}
