//! The explicit midpoint rule on the group (Runge–Kutta–Munthe-Kaas of order 2).
//!
//! Half a step gives the rates of the midpoint; the whole step goes with those: q ← exp(hω½) q. Order 2; no invariant
//! but L is kept.

use super::phase::{Law, Phase, Work};
use crate::math::Quat;

/// One step of h \[s\] from time t \[s\]: two evaluations of the law.
pub fn step(law: &mut Law<'_>, t: f64, h: f64, y: &mut Phase, work: &mut Work) {
    let Work { at, k: [k1, k2, ..], .. } = work.prepare(y);
    let half = 0.5 * h;
    law(t, y, k1);
    at.turn(|body| Quat::from_rotation_vector(k1.w[body] * half));
    at.add_vectors(half, &[(1.0, k1)]);
    law(t + half, at, k2);
    y.turn(|body| Quat::from_rotation_vector(k2.w[body] * h));
    y.add_vectors(h, &[(1.0, k2)]);
}
