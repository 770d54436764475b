//! The augmented second-order method of S. R. Buss, *Accurate and efficient simulation of rigid-body rotations*,
//! J. Comput. Phys. 164 (2000).
//!
//! ω̇ = J⁻¹(τ − ω × L) is known at the start of the step, so the rotation vector of the step is known to third order:
//! q ← exp(h\[ω + ½hω̇ + (h²/12) ω̇ × ω\]) q. Published with a torque that is constant through the step; here x, p and l go
//! by Heun's rule, which makes the order 2 with any forces and changes nothing without.

use super::phase::{Law, Phase, Work, angular_velocity};
use crate::math::{Quat, Vec3};

/// Buss's scheme for bodies of given principal moments.
#[derive(Clone, Copy, Debug)]
pub struct Buss<'a> {
    /// Principal moments > 0 \[kg·m²\], (n_bodies).
    pub inertia: &'a [Vec3],
}

impl Buss<'_> {
    /// One step of h \[s\] from time t \[s\]: two evaluations of the law.
    ///
    /// # Panics
    /// If `inertia` has fewer entries than `y` has bodies.
    pub fn step(&self, law: &mut Law<'_>, t: f64, h: f64, y: &mut Phase, work: &mut Work) {
        let Work { at, k: [k1, k2, ..], .. } = work.prepare(y);
        law(t, y, k1);
        at.turn(|body| {
            let w = k1.w[body];
            // R J0⁻¹ Rᵀ of a torque, as of a momentum.
            let dw = angular_velocity(y.rot[body], k1.torque[body] - w.cross(y.l[body]), self.inertia[body]);
            Quat::from_rotation_vector((w + dw * (0.5 * h) + dw.cross(w) * (h * h / 12.0)) * h)
        });
        at.add_vectors(h, &[(1.0, k1)]);
        law(t + h, at, k2);
        y.rot.copy_from_slice(&at.rot);
        y.add_vectors(h, &[(0.5, k1), (0.5, k2)]);
    }
}
