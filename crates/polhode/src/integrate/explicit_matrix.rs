//! Explicit Euler on the nine numbers of R, as a course prints it, for what goes wrong.
//!
//! x += h v; R += h \[ω×T ω×N ω×B\] with T, N, B the columns of R and ω = R J0⁻¹ Rᵀ L; p += h F; L += h τ. The step is a
//! tangent to SO(3) and leaves it: each column grows by √(1 + h²ω⊥²), where ω⊥ is the part of ω across it. About a
//! principal axis at 10 rad/s with h = 1/60 s that is (1 + 1/36)^300 = 3.71e3 in 10 s. The drifting R then falsifies ω.
//! Gram–Schmidt after each step keeps R a rotation and the order 1.

use super::phase::{Law, Phase, Work};
use crate::math::{Mat3, Quat, Vec3};

/// The scheme for bodies of given principal moments.
#[derive(Clone, Copy, Debug)]
pub struct ExplicitMatrix<'a> {
    /// Principal moments > 0 \[kg·m²\], (n_bodies).
    pub inertia: &'a [Vec3],
    /// Whether the columns are made orthonormal again after each step.
    pub gram_schmidt: bool,
}

impl ExplicitMatrix<'_> {
    /// One step of h \[s\] from time t \[s\] of `y` with the orientations `r`, (n_bodies), in place of `y.rot`.
    ///
    /// Forces and v come from the law, ω from `r`. `y.rot` is set to the rotation nearest to what is left of `r`, for
    /// the law and for display; it is not finite once `r` is not.
    ///
    /// # Panics
    /// If `inertia` or `r` has fewer entries than `y` has bodies.
    pub fn step(&self, law: &mut Law<'_>, (t, h): (f64, f64), y: &mut Phase, r: &mut [Mat3], work: &mut Work) {
        let [k, ..] = &mut work.prepare(y).k;
        law(t, y, k);
        for (body, rot) in y.rot.iter_mut().enumerate() {
            let r = &mut r[body];
            let w = matrix_angular_velocity(r, y.l[body], self.inertia[body]);
            let [tangent, normal, binormal] = r.cols;
            *r += Mat3::from_cols(w.cross(tangent) * h, w.cross(normal) * h, w.cross(binormal) * h);
            let rotation = gram_schmidt(r);
            if self.gram_schmidt {
                *r = rotation;
            }
            *rot = Quat::from_mat3(&rotation);
        }
        y.add_vectors(h, &[(1.0, k)]);
    }
}

/// ω = R J0⁻¹ Rᵀ L for a matrix that may have ceased to be a rotation \[rad/s\].
pub fn matrix_angular_velocity(r: &Mat3, l: Vec3, inertia: Vec3) -> Vec3 {
    let y = r.transposed() * l;
    *r * Vec3::new(y.x / inertia.x, y.y / inertia.y, y.z / inertia.z)
}

/// The right-handed orthonormal columns nearest to those of `r` in their order: the first keeps its direction, the
/// second its plane with the first.
pub fn gram_schmidt(r: &Mat3) -> Mat3 {
    let [a, b, _] = r.cols;
    let a = a / a.robust_length();
    let b = b / b.robust_length();
    let b = b - a * a.dot(b);
    let b = b / b.length();
    Mat3::from_cols(a, b, a.cross(b))
}
