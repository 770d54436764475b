//! The implicit midpoint rule on the rotation group, by Cayley's map.
//!
//! With J0 in principal axes, y = Rᵀ L and the Gibbs vector e of the step, J0 e + e × J0 e = (h/2) y. Order 2, symmetric;
//! conserves L and the energy exactly.

use super::cayley;
use crate::math::{Lane, Mat3, Quat, Vec3};

/// Newton steps. Each squares the relative error, which starts at |e|²: enough for f64 up to h|ω| = 0.5.
pub const NEWTON_STEPS: usize = 3;

/// The Gibbs vector e of a step of h \[s\]: the root of J0 e + e × J0 e = (h/2) y next to (h/2) J0⁻¹ y.
///
/// `y` is the angular momentum in body axes \[kg·m²/s\], `inertia` the principal moments \[kg·m²\].
#[inline(always)]
pub fn cayley_vector<T: Lane>(y: Vec3<T>, inertia: Vec3<T>, h: T) -> Vec3<T> {
    let b = y * (h * h.like(0.5));
    let mut e = Vec3::new(b.x / inertia.x, b.y / inertia.y, b.z / inertia.z);
    for _ in 0..NEWTON_STEPS {
        let ie = inertia.scale(e);
        let residual = ie + e.cross(ie) - b;
        e -= cayley::solve(jacobian(e, ie, inertia), residual);
    }
    e
}

/// ∂(J0 e + e × J0 e)/∂e = J0 + \[e\]× J0 − \[J0 e\]×.
#[inline(always)]
pub(super) fn jacobian<T: Lane>(e: Vec3<T>, ie: Vec3<T>, inertia: Vec3<T>) -> Mat3<T> {
    let i = inertia;
    // Column j: I_j (unit_j + e × unit_j) − J0 e × unit_j.
    Mat3::from_cols(
        Vec3::new(i.x, e.z * i.x - ie.z, ie.y - e.y * i.x),
        Vec3::new(ie.z - e.z * i.y, i.y, e.x * i.y - ie.x),
        Vec3::new(e.y * i.z - ie.y, ie.x - e.x * i.z, i.z),
    )
}

/// The attitude after h \[s\] of free rotation; `l` in world axes \[kg·m²/s\], principal moments `inertia` > 0 \[kg·m²\].
///
/// Meant for h|ω| ≤ 0.5; beyond about 2 Newton's method may find no root.
#[inline(always)]
pub fn rotate<T: Lane>(rot: Quat<T>, l: Vec3<T>, inertia: Vec3<T>, h: T) -> Quat<T> {
    cayley::compose(rot, cayley_vector(rot.inverse_rotate(l), inertia, h))
}
