//! The Crouch–Grossman scheme of order 3: stages and step are products of exponentials.
//!
//! P. E. Crouch, R. Grossman, J. Nonlinear Sci. 3 (1993); tableau of Hairer, Lubich, Wanner, *Geometric Numerical
//! Integration*, IV.8.1. No invariant but L is kept.

use super::phase::{Law, Phase, Work};
use crate::math::Quat;

const A21: f64 = 3.0 / 4.0;
const A31: f64 = 119.0 / 216.0;
const A32: f64 = 17.0 / 108.0;
const B1: f64 = 13.0 / 51.0;
const B2: f64 = -2.0 / 3.0;
const B3: f64 = 24.0 / 17.0;

/// One step of h \[s\] from time t \[s\]: three evaluations of the law.
pub fn step(law: &mut Law<'_>, t: f64, h: f64, y: &mut Phase, work: &mut Work) {
    let Work { at, k: [k1, k2, k3, _], .. } = work.prepare(y);
    let exp = Quat::from_rotation_vector;
    law(t, y, k1);
    at.turn(|body| exp(k1.w[body] * (A21 * h)));
    at.add_vectors(h, &[(A21, k1)]);
    law(t + A21 * h, at, k2);
    at.copy_from(y);
    at.turn(|body| exp(k2.w[body] * (A32 * h)) * exp(k1.w[body] * (A31 * h)));
    at.add_vectors(h, &[(A31, k1), (A32, k2)]);
    law(t + (A31 + A32) * h, at, k3);
    y.turn(|body| exp(k3.w[body] * (B3 * h)) * exp(k2.w[body] * (B2 * h)) * exp(k1.w[body] * (B1 * h)));
    y.add_vectors(h, &[(B1, k1), (B2, k2), (B3, k3)]);
}
