//! The Runge–Kutta–Munthe-Kaas scheme of order 4: the classical tableau in the rotation vector of the step.
//!
//! q(t) = exp(u) q_n with u̇ = dexp⁻¹(u) ω, where dexp⁻¹(u) w = w − ½ u×w + (1/12) u×(u×w) + O(u⁴). (H. Munthe-Kaas, Appl.
//! Numer. Math. 29, 1999.) No invariant but L is kept.

use super::phase::{Law, Phase, Work};
use super::rk4::WEIGHTS;
use crate::math::{Quat, Vec3};

/// One step of h \[s\] from time t \[s\]: four evaluations of the law.
pub fn step(law: &mut Law<'_>, t: f64, h: f64, y: &mut Phase, work: &mut Work) {
    let Work { at, k, u, .. } = work.prepare(y);
    for stage in 0..4 {
        let a = [0.0, 0.5, 0.5, 1.0][stage] * h;
        if stage > 0 {
            at.copy_from(y);
            at.add_vectors(a, &[(1.0, &k[stage - 1])]);
            at.turn(|body| Quat::from_rotation_vector(u[stage - 1][body] * a));
        }
        law(t + a, at, &mut k[stage]);
        let (before, now) = u.split_at_mut(stage);
        for (body, u) in now[0].iter_mut().enumerate() {
            let vector = before.last().map_or(Vec3::ZERO, |before| before[body] * a);
            *u = inverse_dexp(vector, k[stage].w[body]);
        }
    }
    let [k1, k2, k3, k4] = &*k;
    let [b1, b2, b3, b4] = WEIGHTS;
    y.turn(|body| {
        Quat::from_rotation_vector((u[0][body] * b1 + u[1][body] * b2 + u[2][body] * b3 + u[3][body] * b4) * h)
    });
    y.add_vectors(h, &[(b1, k1), (b2, k2), (b3, k3), (b4, k4)]);
}

/// The rate of the rotation vector u of a body that turns at w, up to u³.
fn inverse_dexp(u: Vec3, w: Vec3) -> Vec3 {
    let uw = u.cross(w);
    w - uw * 0.5 + u.cross(uw) * (1.0 / 12.0)
}
