//! Explicit Euler: everything goes on at its rate of the start of the step.
//!
//! Order 1. An undamped oscillator grows by √(1+h²ω²) a step; the rotation is q ← exp(hω) q, which at least stays one.

use super::phase::{Law, Phase, Work};
use crate::math::Quat;

/// One step of h \[s\] from time t \[s\].
pub fn step(law: &mut Law<'_>, t: f64, h: f64, y: &mut Phase, work: &mut Work) {
    let [k, ..] = &mut work.prepare(y).k;
    law(t, y, k);
    y.turn(|body| Quat::from_rotation_vector(k.w[body] * h));
    y.add_vectors(h, &[(1.0, k)]);
}
