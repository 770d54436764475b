//! Rotations by Cayley's map, δ = (1, e)/√(1+|e|²): rational, so that it needs no trigonometry and runs in lanes.
//!
//! e = u tan(θ/2) is the Gibbs vector of the rotation by θ about u.

use crate::math::{Lane, Mat3, Quat, Vec3};

/// rot · δ(e) for a Gibbs vector `e` in body axes.
#[inline(always)]
pub(super) fn compose<T: Lane>(rot: Quat<T>, e: Vec3<T>) -> Quat<T> {
    let one = e.x.like(1.0);
    let w = one / (one + e.length_squared()).sqrt();
    (rot * Quat::from_parts(w, e * w)).renormalized()
}

/// The solution of m·s = r by Cramer's rule, with one division.
#[inline(always)]
pub(super) fn solve<T: Lane>(m: Mat3<T>, r: Vec3<T>) -> Vec3<T> {
    let [a, b, c] = m.cols;
    let bc = b.cross(c);
    let scale = a.x.like(1.0) / a.dot(bc);
    Vec3::new(r.dot(bc) * scale, r.dot(c.cross(a)) * scale, r.dot(a.cross(b)) * scale)
}
