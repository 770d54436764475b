//! The discrete Moser–Veselov map: the free body's own variational integrator.
//!
//! J. Moser, A. P. Veselov, *Discrete versions of some classical integrable systems*, Comm. Math. Phys. 139 (1991), in
//! Gibbs vectors: J0 e + e × J0 e = (h/2)(1 + |e|²) y. Order 2, symmetric, symplectic; conserves L and the energy exactly,
//! so that only the phase along the polhode and about L errs.

use super::cayley;
use super::implicit_midpoint::{NEWTON_STEPS, jacobian};
use crate::math::{Lane, Mat3, Quat, Vec3};

/// The Gibbs vector e of a step of h \[s\]: the root of J0 e + e × J0 e = (h/2)(1 + |e|²) y next to (h/2) J0⁻¹ y.
///
/// `y` is the angular momentum in body axes \[kg·m²/s\], `inertia` the principal moments \[kg·m²\].
#[inline(always)]
pub fn cayley_vector<T: Lane>(y: Vec3<T>, inertia: Vec3<T>, h: T) -> Vec3<T> {
    let (one, b) = (h.like(1.0), y * (h * h.like(0.5)));
    let mut e = Vec3::new(b.x / inertia.x, b.y / inertia.y, b.z / inertia.z);
    for _ in 0..NEWTON_STEPS {
        let ie = inertia.scale(e);
        let residual = ie + e.cross(ie) - b * (one + e.length_squared());
        e -= cayley::solve(jacobian(e, ie, inertia) - Mat3::outer(b, e + e), residual);
    }
    e
}

/// The attitude after h \[s\] of free rotation; `l` in world axes \[kg·m²/s\], principal moments `inertia` > 0 \[kg·m²\].
///
/// The map exists for h|ω| < π/2 only (a rotation by θ has sin θ = h|ω| about a principal axis): meant for h|ω| ≤ 0.5.
#[inline(always)]
pub fn rotate<T: Lane>(rot: Quat<T>, l: Vec3<T>, inertia: Vec3<T>, h: T) -> Quat<T> {
    cayley::compose(rot, cayley_vector(rot.inverse_rotate(l), inertia, h))
}
