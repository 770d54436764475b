//! A pinned point: the point r of a body stays at c in the world.
//!
//! ```text
//! g = x + R r − c = 0                      position, 3 rows
//! ġ = v + ω × R r = G (v, ω),              G = [ 1, −[R r]× ]
//! Gᵀ P:  p += P,  l += R r × P             an impulse P at the point
//! ```
//!
//! The response of the point i to an impulse at the point j of the same body is the 3×3 block
//! `K_ij = 1/m − [r_i]× J⁻¹ [r_j]×`; on the diagonal it is symmetric and positive definite.

use crate::math::{Mat3, Quat, Vec3};

/// J⁻¹ = R J0⁻¹ Rᵀ in world axes [1/(kg·m²)].
pub fn world_inverse_inertia(rot: Quat, inv_inertia: Vec3) -> Mat3 {
    let r = rot.to_mat3();
    r * Mat3::diagonal(inv_inertia) * r.transposed()
}

/// g = x + arm − c \[m\].
#[inline]
pub fn gap(x: Vec3, arm: Vec3, at: Vec3) -> Vec3 {
    (x - at) + arm
}

/// The velocity of the point at `arm` per impulse at `arm_j`: K_ij [1/kg].
#[inline]
pub fn response(inv_mass: f64, inv_inertia_w: Mat3, arm_i: Vec3, arm_j: Vec3) -> Mat3 {
    let lever = Mat3::cross(arm_i) * inv_inertia_w * Mat3::cross(arm_j);
    Mat3::diagonal(Vec3::splat(inv_mass)) - lever
}
