//! The classical Runge–Kutta scheme on the numbers x, q, p, L, with q̇ = ½ (0, ω) q.
//!
//! Order 4. The quaternion leaves the unit sphere by the error of the step and is put back at its end; the law only sees
//! unit quaternions. No invariant but L is kept.

use super::phase::{Law, Phase, Rates, Work};
use crate::math::{Quat, Vec3};

/// One step of h \[s\] from time t \[s\]: four evaluations of the law.
pub fn step(law: &mut Law<'_>, t: f64, h: f64, y: &mut Phase, work: &mut Work) {
    let Work { at, k, dq, .. } = work.prepare(y);
    for stage in 0..4 {
        let a = [0.0, 0.5, 0.5, 1.0][stage] * h;
        if stage > 0 {
            at.copy_from(y);
            at.add_vectors(a, &[(1.0, &k[stage - 1])]);
            for (body, rot) in at.rot.iter_mut().enumerate() {
                *rot = add(*rot, dq[stage - 1][body], a).normalized();
            }
        }
        law(t + a, at, &mut k[stage]);
        let (before, now) = dq.split_at_mut(stage);
        for (body, dq) in now[0].iter_mut().enumerate() {
            // The rate belongs to the quaternion before it was normalised.
            let q = before.last().map_or(y.rot[body], |before| add(y.rot[body], before[body], a));
            *dq = quaternion_rate(k[stage].w[body], q);
        }
    }
    for (body, rot) in y.rot.iter_mut().enumerate() {
        let mut q = *rot;
        for (b, dq) in WEIGHTS.iter().zip(dq.iter()) {
            q = add(q, dq[body], b * h);
        }
        *rot = q.normalized();
    }
    let [k1, k2, k3, k4] = &*k;
    let terms: [(f64, &Rates); 4] = [(WEIGHTS[0], k1), (WEIGHTS[1], k2), (WEIGHTS[2], k3), (WEIGHTS[3], k4)];
    y.add_vectors(h, &terms);
}

/// b of the classical tableau.
pub(super) const WEIGHTS: [f64; 4] = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0];

/// q̇ = ½ (0, ω) q.
pub(super) fn quaternion_rate(w: Vec3, q: Quat) -> Quat {
    (Quat::from_parts(0.0, w * 0.5)) * q
}

/// q + a·d, as four numbers.
fn add(q: Quat, d: Quat, a: f64) -> Quat {
    Quat::new(q.w + a * d.w, q.x + a * d.x, q.y + a * d.y, q.z + a * d.z)
}
