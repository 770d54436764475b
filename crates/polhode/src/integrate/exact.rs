//! The exact free rotation: Euler 1758, Jacobi 1850, in a form that keeps its digits everywhere.
//!
//! Between impulses L stands still in the world while y = Rᵀ L runs along a polhode, a closed curve around the axis of
//! the largest or of the smallest moment. Call that axis 3, the middle one 2 and the other 1, with moments A, B, C.
//! Measure y in units of |L|. Everything that follows depends on one shape number and three amplitudes:
//!
//! ```text
//! ν   = C(B−A) / A(C−B)                       axis 3 is the one with y3² ≥ ν y1² (else swap 1 and 3: ν → 1/ν)
//! a1² = y1² + y2²/(1+ν)   a2² = (1+ν) a1²   a3² = y3² + y2² ν/(1+ν)   constant; a1² + a3² = 1
//! m   = ν a1²/a3²         1 − m = (y3² − ν y1²)/a3²                     0 on the separatrix
//! Ωt  = (a3/C) √((C−B)(C−A)/AB) |L| h
//! y   = (a1 cn τ, ±a2 sn τ, ±a3 dn τ),  τ = τ0 + Ωt
//! ```
//!
//! The attitude follows from the angle φ by which the direction u = e × y, with e a body axis, turns about L:
//! φ' = (|L|/base) + a bounded positive or negative part, whose integral is one of the third kind. Textbooks evaluate
//! τ0 as an incomplete integral and subtract two of the third kind. That loses all digits of a small step of a slow
//! polhode. Here both go by the addition theorems (DLMF 22.8.1–3 and 19.11.1): sn τ0, cn τ0, dn τ0 are just y/a, all
//! integrals run from 0 to Ωt, and what the addition theorem of the third kind leaves over is one arctangent whose
//! factor turns out to be ±1.
//!
//! The axis e is 3 with base A where ν < 1, and 1 with base C where ν ≥ 1: y then stays away from ±e, or is as near to
//! it all the time, and the bounded part takes off at most half of the base rate.

use crate::math::elliptic::{Jacobi, Modulus, carlson_rj};
use crate::math::{Mat3, Quat, Vec3};

/// Squared distance of y/|L| from a principal axis below which the body spins about that axis: the attitude then errs
/// by 1e-100 a radian, and squares of all amplitudes remain normal numbers.
const ON_AXIS: f64 = 1e-200;

/// The attitude after a time h \[s\] of free rotation of a body with attitude `rot`, angular momentum `l` about its
/// centre of mass \[kg·m²/s, world axes\] and principal moments `inertia` > 0 \[kg·m²\].
///
/// The error is a few roundings of the angle h|ω| itself, for any h of either sign, any moments and any polhode,
/// including those next to the separatrix. Where the motion is unstable the *input* must be that exact as well.
pub fn rotate(rot: Quat, l: Vec3, inertia: Vec3, h: f64) -> Quat {
    let size = l.robust_length();
    let time = h * size;
    if time == 0.0 {
        return rot;
    }
    (rot * turn(rot.inverse_rotate(l / size), inertia.to_array(), time)).renormalized()
}

/// The rotation Δ with R(h) = R(0) Δ for the direction y of L in body axes and `time` = h|L|.
fn turn(y: Vec3, inertia: [f64; 3], time: f64) -> Quat {
    let (lo, mid, hi) = sorted(inertia);
    if inertia[lo] == inertia[hi] {
        return Quat::from_rotation_vector(y * (time / inertia[lo]));
    }
    if inertia[lo] == inertia[mid] {
        return symmetric(y, inertia, hi, lo, time);
    }
    if inertia[mid] == inertia[hi] {
        return symmetric(y, inertia, lo, hi, time);
    }
    for axis in [lo, mid, hi] {
        let off_axis: f64 = (0..3).filter(|&k| k != axis).map(|k| y[k] * y[k]).sum();
        if off_axis < ON_AXIS {
            return Quat::from_axis_angle(unit(axis), y[axis] * time / inertia[axis]);
        }
    }
    let [a, b, c] = [lo, mid, hi].map(|k| inertia[k]);
    // y3² ≥ ν y1² for axis 3 = hi, multiplied out.
    let around_hi = y[hi] * y[hi] * (a / c * (c - b)) >= y[lo] * y[lo] * (b - a);
    let order = if around_hi { [lo, mid, hi] } else { [hi, mid, lo] };
    // A transposition of axes is a reflection: turning axis 2 round makes it a rotation.
    let hand = if (order[0] + 1) % 3 == order[1] { 1.0 } else { -1.0 };
    let polhode = Polhode::new(
        Vec3::new(y[order[0]], hand * y[order[1]], y[order[2]]),
        Vec3::new(inertia[order[0]], inertia[order[1]], inertia[order[2]]),
    );
    let q = polhode.turn(time);
    let mut v = Vec3::ZERO;
    v[order[0]] = q.x;
    v[order[1]] = hand * q.y;
    v[order[2]] = q.z;
    Quat::from_parts(q.w, v)
}

/// The axes of the smallest, the middle and the largest moment.
fn sorted(inertia: [f64; 3]) -> (usize, usize, usize) {
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| inertia[i].total_cmp(&inertia[j]));
    (order[0], order[1], order[2])
}

fn unit(axis: usize) -> Vec3 {
    let mut e = Vec3::ZERO;
    e[axis] = 1.0;
    e
}

/// Two equal moments (that of axis `equal`): the body precesses about L at |L|/A and spins about its odd axis.
fn symmetric(y: Vec3, inertia: [f64; 3], odd: usize, equal: usize, time: f64) -> Quat {
    let (a, c) = (inertia[equal], inertia[odd]);
    let spin = time * y[odd] * ((a - c) / a / c);
    Quat::from_rotation_vector(y * (time / a)) * Quat::from_axis_angle(unit(odd), spin)
}

/// A polhode of a body with three different moments, with the state on it.
struct Polhode {
    /// L/|L| in the body axes 1, 2, 3 of the text above.
    y: Vec3,
    /// A, B, C \[kg·m²\].
    inertia: Vec3,
    nu: f64,
    /// a1, ±a2, ±a3: y = (a1 cn, ±a2 sn, ±a3 dn).
    amplitude: Vec3,
    /// a1²/a3².
    ratio: f64,
    /// 1 − m.
    m1: f64,
}

impl Polhode {
    fn new(y: Vec3, inertia: Vec3) -> Self {
        let Vec3 { x: a, y: b, z: c } = inertia;
        let nu = c / (c - b) * ((b - a) / a);
        let (y1, y2, y3) = (y.x * y.x, y.y * y.y, y.z * y.z);
        let (a1, a3) = (y1 + y2 / (1.0 + nu), y3 + y2 * (nu / (1.0 + nu)));
        // Euler's equation y1' = y2 y3 (1/C − 1/B) ties the sign of the second amplitude to that of the third.
        let s3 = if y.z < 0.0 { -1.0 } else { 1.0 };
        let s2 = if c > b { s3 } else { -s3 };
        Self {
            y,
            inertia,
            nu,
            amplitude: Vec3::new(a1.sqrt(), s2 * ((1.0 + nu) * a1).sqrt(), s3 * a3.sqrt()),
            ratio: a1 / a3,
            m1: (y3 - nu * y1) / a3,
        }
    }

    /// The rotation Δ after h|L| = `time`, in the axes 1, 2, 3.
    fn turn(&self, time: f64) -> Quat {
        let Vec3 { x: a, y: b, z: c } = self.inertia;
        let modulus = Modulus::from_complement(self.m1);
        let m = 1.0 - modulus.complement();
        let a3 = self.amplitude.z.abs();
        let rate = a3 / c * ((c - b) / a * ((c - a) / b)).sqrt();
        let (n_half, u) = modulus.half_periods(rate * time);

        let start = Jacobi {
            cn: self.y.x / self.amplitude.x,
            sn: self.y.y / self.amplitude.y,
            dn: self.y.z / self.amplitude.z,
        };
        let step = modulus.functions_within_quarter(u);
        let end = sum(start, step, m);

        let (pole, base, shape) = if self.nu < 1.0 { (Vec3::Z, a, self.nu) } else { (Vec3::X, c, self.ratio) };
        let kappa = shape * (1.0 + self.nu).sqrt() / a3;
        let mut bounded = kappa * third_kind(step, shape);
        if n_half != 0.0 {
            let quarter = Jacobi { sn: 1.0, cn: 0.0, dn: modulus.complement().sqrt() };
            bounded += 2.0 * n_half * kappa * third_kind(quarter, shape);
        }
        // 1 − m sn²(start) sn²(end) as a sum of squares; `mixed` is then a positive definite form.
        let square = end.cn * end.cn + end.sn * end.sn * start.dn * start.dn;
        let mixed = end.sn * end.sn - start.cn * start.dn * step.sn * end.sn + step.sn * step.sn * square;
        bounded += libm::atan2(kappa * step.sn * start.sn * end.sn, 1.0 + shape * mixed);
        let phi = time / base + if b < base { bounded } else { -bounded };

        let flip = if n_half % 2.0 == 0.0 { 1.0 } else { -1.0 };
        let y_end = self.amplitude.scale(Vec3::new(flip * end.cn, flip * end.sn, end.dn));
        attitude(self.y, y_end, pole, phi)
    }
}

/// The functions at τ0 + u from those at τ0 and u (DLMF 22.8.1–3), the denominator as a sum of squares.
fn sum(start: Jacobi, step: Jacobi, m: f64) -> Jacobi {
    let (a, b) = (start, step);
    let denominator = a.cn * a.cn + a.sn * a.sn * b.dn * b.dn;
    Jacobi {
        sn: (b.sn * a.cn * a.dn + a.sn * b.cn * b.dn) / denominator,
        cn: (b.cn * a.cn - b.sn * b.dn * a.sn * a.dn) / denominator,
        dn: (b.dn * a.dn - m * b.sn * a.sn * b.cn * a.cn) / denominator,
    }
}

/// ∫₀ᵘ sn²/(1 + ν sn²), by the functions at u in \[−K, K\] (DLMF 19.25.14).
fn third_kind(at: Jacobi, nu: f64) -> f64 {
    let s2 = at.sn * at.sn;
    at.sn * s2 / 3.0 * carlson_rj(at.cn * at.cn, at.dn * at.dn, 1.0, 1.0 + nu * s2)
}

/// Δ takes y_end to y and the direction of pole × y_end to that of pole × y, turned by φ about y.
fn attitude(y: Vec3, y_end: Vec3, pole: Vec3, phi: f64) -> Quat {
    let frame = |y: Vec3| {
        let u = pole.cross(y);
        let u = u / u.length();
        (u, y.cross(u))
    };
    let ((u0, w0), (u, w)) = (frame(y), frame(y_end));
    let (sin, cos) = libm::sincos(phi);
    let (u1, w1) = (u0 * cos + w0 * sin, w0 * cos - u0 * sin);
    let row = |k: usize| u * u1[k] + w * w1[k] + y_end * y[k];
    Quat::from_mat3(&Mat3::from_rows(row(0), row(1), row(2)))
}
