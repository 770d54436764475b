//! The commutator-free scheme of order 4: six exponentials, no brackets.
//!
//! E. Celledoni, A. Marthinsen, B. Owren, *Commutator-free Lie group methods*, Future Gener. Comput. Syst. 19 (2003).
//! Its abelian part is the classical Runge–Kutta scheme. No invariant but L is kept.

use super::phase::{Law, Phase, Work};
use super::rk4::WEIGHTS;
use crate::math::Quat;

/// One step of h \[s\] from time t \[s\]: four evaluations of the law.
pub fn step(law: &mut Law<'_>, t: f64, h: f64, y: &mut Phase, work: &mut Work) {
    let Work { at, k: [k1, k2, k3, k4], .. } = work.prepare(y);
    let exp = Quat::from_rotation_vector;
    let half = 0.5 * h;
    law(t, y, k1);
    at.turn(|body| exp(k1.w[body] * half));
    at.add_vectors(half, &[(1.0, k1)]);
    law(t + half, at, k2);
    at.copy_from(y);
    at.turn(|body| exp(k2.w[body] * half));
    at.add_vectors(half, &[(1.0, k2)]);
    law(t + half, at, k3);
    at.copy_from(y);
    at.turn(|body| exp(k3.w[body] * h - k1.w[body] * half) * exp(k1.w[body] * half));
    at.add_vectors(h, &[(1.0, k3)]);
    law(t + h, at, k4);
    y.turn(|body| {
        let (w1, w2, w3, w4) = (k1.w[body], k2.w[body], k3.w[body], k4.w[body]);
        let inner = w2 + w3;
        exp((inner + inner + w4 * 3.0 - w1) * (h / 12.0)) * exp((inner + inner + w1 * 3.0 - w4) * (h / 12.0))
    });
    let [b1, b2, b3, b4] = WEIGHTS;
    y.add_vectors(h, &[(b1, k1), (b2, k2), (b3, k3), (b4, k4)]);
}
