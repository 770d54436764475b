//! The preprocessed discrete Moser–Veselov map: the free rotation of a rigid body.
//!
//! The angular momentum L is the state and it is constant in world axes, so a free rotation only has to turn the body
//! frame. The discrete Moser–Veselov (DMV) map does it with one Cayley rotation δ = (1, e)/√(1+|e|²) whose vector e solves
//!
//! ```text
//! I e + e × I e = (h/2) (1 + |e|²) y,      y = Rᵀ L
//! ```
//!
//! It conserves the kinetic energy and L exactly, but its phase is wrong at order 2. Hairer and Vilmart's remedy
//! ("Preprocessed discrete Moser–Veselov algorithm for the full dynamics of a rigid body", J. Phys. A 39, 2006): run it
//! with modified moments of inertia
//!
//! ```text
//! 1/Ĩ_j = k_j (1 + S) + D,     S = h² s3 + h⁴ s5 + …,   D = h² d3 + h⁴ d5 + …,    k_j = 1/I_j
//! ```
//!
//! whose coefficients depend only on the invariants H = ½ Σ k_j y_j² and C = ½ |y|² and on the elementary symmetric
//! polynomials of the k_j. Every pair (s, d) gains two orders and nothing of the conservation is lost. There is no
//! trigonometry and no branch, so eight bodies go through it at once.
//!
//! The unknown here is a = Ĩ e, which needs the k̃_j = 1/Ĩ_j only and so no division by them:
//!
//! ```text
//! F(a) = a + e × a − (h/2)(1 + |e|²) y = 0,     e = k̃ a
//! ```
//!
//! The solvability limit is h|ω| < π/2; [`rotate`] splits a step into equal sub-rotations long before.

use crate::math::{Lane, Mat3, Quat, Vec3};

/// Order of the preprocessed map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Order {
    /// The plain discrete Moser–Veselov map.
    Two,
    /// Errors of order h⁴.
    Four,
    /// Errors of order h⁶: the default.
    Six,
    /// Errors of order h⁸.
    Eight,
    /// Errors of order h¹⁰: rounding at 40 steps a radian.
    Ten,
}

impl Order {
    /// The largest angle of one sub-rotation \[rad\].
    ///
    /// Half a radian keeps the sixth-order map below 2e-6 rad and the Newton iteration at rounding after three steps;
    /// the orders that are chosen for precision take half of that.
    pub fn max_angle(self) -> f64 {
        match self {
            Self::Two | Self::Four | Self::Six => 0.5,
            Self::Eight | Self::Ten => 0.25,
        }
    }
    /// The order as a number.
    pub fn number(self) -> u32 {
        match self {
            Self::Two => 2,
            Self::Four => 4,
            Self::Six => 6,
            Self::Eight => 8,
            Self::Ten => 10,
        }
    }
}

/// A rotation that would take more sub-rotations than this is left to the exact solution.
pub const MAX_SUBROTATIONS: f64 = 64.0;

/// What the free motion of one body conserves, and what follows from it.
#[derive(Clone, Copy)]
struct Invariants<T> {
    /// Kinetic energy H = ½ Σ k y² \[J\].
    energy: T,
    /// Casimir C = ½ |y|² [kg²·m⁴/s²].
    casimir: T,
    /// k1 + k2 + k3, k1 k2 + k2 k3 + k3 k1, k1 k2 k3.
    p: T,
    q: T,
    r: T,
}

impl<T: Lane> Invariants<T> {
    #[inline(always)]
    fn new(y: Vec3<T>, k: Vec3<T>) -> Self {
        let half = y.x.like(0.5);
        Self {
            energy: half * y.dot(y.scale(k)),
            casimir: half * y.dot(y),
            p: k.x + k.y + k.z,
            q: k.x * k.y + k.y * k.z + k.z * k.x,
            r: k.x * k.y * k.z,
        }
    }

    /// The largest |ω|² on the orbit.
    ///
    /// Σ k² y² at given Σ y² = 2C and Σ k y² = 2H is largest where y has no part along the middle axis, which every orbit
    /// passes: |ω|² = 2H (k_max + k_min) − 2C k_max k_min. Being an invariant, it makes the number of sub-rotations the
    /// same forwards and backwards in time.
    #[inline(always)]
    fn max_angular_speed_squared(&self, k: Vec3<T>) -> T {
        let two = k.x.like(2.0);
        let high = k.x.greatest(k.y).greatest(k.z);
        let low = k.x.least(k.y).least(k.z);
        two * (self.energy * (high + low) - self.casimir * high * low)
    }
}

/// S and D of the modified moments for a step `h`, to the given order (coefficients: see the module's source).
#[inline(always)]
fn preprocessing<T: Lane>(order: Order, inv: &Invariants<T>, h: T) -> (T, T) {
    let c = |v: f64| h.like(v);
    let Invariants { energy: e, casimir: m, p, q, r } = *inv;
    let h2 = h * h;
    if order == Order::Two {
        return (c(0.0), c(0.0));
    }
    let s3 = c(1.0 / 6.0) * q * m - c(1.0 / 3.0) * p * e;
    let d3 = c(1.0 / 6.0) * q * e - c(1.0 / 3.0) * r * m;
    if order == Order::Four {
        return (h2 * s3, h2 * d3);
    }
    let (pp, qq, pq, pr, qr) = (p * p, q * q, p * q, p * r, q * r);
    let (ee, em, mm) = (e * e, e * m, m * m);
    let s5 = c(1.0 / 60.0) * (c(2.0) * pp - q) * ee - c(1.0 / 30.0) * (pq - c(4.0) * r) * em
        + c(1.0 / 30.0) * (qq - c(3.0) * pr) * mm;
    let d5 = c(1.0 / 60.0) * (c(8.0) * pr - qq) * em - c(1.0 / 60.0) * (pq + c(6.0) * r) * ee - c(1.0 / 60.0) * qr * mm;
    if order == Order::Six {
        return (h2 * (s3 + h2 * s5), h2 * (d3 + h2 * d5));
    }
    let (s7, d7) = seventh(inv, h);
    if order == Order::Eight {
        return (h2 * (s3 + h2 * (s5 + h2 * s7)), h2 * (d3 + h2 * (d5 + h2 * d7)));
    }
    let (s9, d9) = ninth(inv, h);
    (h2 * (s3 + h2 * (s5 + h2 * (s7 + h2 * s9))), h2 * (d3 + h2 * (d5 + h2 * (d7 + h2 * d9))))
}

/// s7 and d7.
#[inline(always)]
fn seventh<T: Lane>(inv: &Invariants<T>, h: T) -> (T, T) {
    let c = |v: f64| h.like(v);
    let Invariants { energy: e, casimir: m, p, q, r } = *inv;
    let (pp, qq, rr, pq, pr, qr) = (p * p, q * q, r * r, p * q, p * r, q * r);
    let (e3, e2m, em2, m3) = (e * e * e, e * e * m, e * m * m, m * m * m);
    let s = c(-1.0 / 630.0) * (pp * p - pq - c(18.0) * r) * e3
        + c(1.0 / 2520.0) * (c(6.0) * pp * q - c(212.0) * pr + c(41.0) * qq) * e2m
        + c(1.0 / 420.0) * (c(22.0) * pp * r - c(6.0) * p * qq - c(5.0) * qr) * em2
        - c(1.0 / 2520.0) * (c(66.0) * pq * r - c(17.0) * qq * q - c(100.0) * rr) * m3;
    let d = c(1.0 / 1260.0) * (pp * q + c(30.0) * pr - c(13.0) * qq) * e3
        - c(1.0 / 2520.0) * (c(64.0) * pp * r - c(13.0) * p * qq - c(110.0) * qr) * e2m
        - c(1.0 / 1260.0) * (pq * r - qq * q + c(88.0) * rr) * em2
        + c(1.0 / 2520.0) * r * (c(72.0) * pr - c(19.0) * qq) * m3;
    (s, d)
}

/// s9 and d9.
#[inline(always)]
fn ninth<T: Lane>(inv: &Invariants<T>, h: T) -> (T, T) {
    let c = |v: f64| h.like(v);
    let Invariants { energy: e, casimir: m, p, q, r } = *inv;
    let (p2, q2, r2) = (p * p, q * q, r * r);
    let (p3, q3) = (p2 * p, q2 * q);
    let (e2, m2) = (e * e, m * m);
    let s = c(1.0 / 45360.0) * (c(2.0) * p2 * p2 - c(3.0) * p2 * q - c(486.0) * p * r + c(153.0) * q2) * (e2 * e2)
        - c(1.0 / 11340.0) * (p3 * q - c(276.0) * p2 * r + c(66.0) * p * q2 + c(207.0) * q * r) * (e2 * e * m)
        - c(1.0 / 7560.0)
            * (c(102.0) * p3 * r - c(26.0) * p2 * q2 - c(30.0) * p * q * r - c(3.0) * q3 - c(318.0) * r2)
            * (e2 * m2)
        + c(1.0 / 22680.0)
            * (c(306.0) * p2 * q * r - c(77.0) * p * q3 - c(1128.0) * p * r2 + c(141.0) * q2 * r)
            * (e * m2 * m)
        + c(1.0 / 45360.0)
            * (c(378.0) * p2 * r2 - c(342.0) * p * q2 * r + c(62.0) * q2 * q2 + c(291.0) * q * r2)
            * (m2 * m2);
    let d = c(-1.0 / 45360.0) * (p3 * q + c(126.0) * p2 * r + c(6.0) * p * q2 - c(459.0) * q * r) * (e2 * e2)
        + c(1.0 / 22680.0)
            * (c(64.0) * p3 * r - c(15.0) * p2 * q2 - c(276.0) * p * q * r + c(97.0) * q3 - c(648.0) * r2)
            * (e2 * e * m)
        + c(1.0 / 7560.0)
            * (c(19.0) * p2 * q * r - c(5.0) * p * q3 + c(356.0) * p * r2 - c(133.0) * q2 * r)
            * (e2 * m2)
        - c(1.0 / 45360.0) * (c(864.0) * p2 * r2 - c(222.0) * p * q2 * r + q2 * q2 - c(684.0) * q * r2) * (e * m2 * m)
        + c(1.0 / 45360.0) * r * (c(243.0) * p * q * r - c(61.0) * q3 - c(610.0) * r2) * (m2 * m2);
    (s, d)
}

/// The Cayley vector e of the DMV map with reciprocal moments `k` and step `h`.
///
/// One fixed-point step, whose error is of third order in h|ω|, then three Newton steps: 1e-16 up to h|ω| = 0.5.
#[inline(always)]
fn cayley_vector<T: Lane>(y: Vec3<T>, k: Vec3<T>, h: T) -> Vec3<T> {
    let one = h.like(1.0);
    let half_h = h * h.like(0.5);
    let start = y * half_h;
    let e = start.scale(k);
    let mut a = start * (one + e.dot(e)) - e.cross(start);
    for _ in 0..3 {
        let e = a.scale(k);
        let residual = a + e.cross(a) - start * (one + e.dot(e));
        // ∂F/∂a = 1 + [e]× − [a]× K − h y (K e)ᵀ, with K = diag(k) and e = K a.
        let u = e.scale(k);
        let hy = start + start;
        let jacobian = Mat3::from_cols(
            Vec3::new(one - hy.x * u.x, e.z - a.z * k.x - hy.y * u.x, a.y * k.x - e.y - hy.z * u.x),
            Vec3::new(a.z * k.y - e.z - hy.x * u.y, one - hy.y * u.y, e.x - a.x * k.y - hy.z * u.y),
            Vec3::new(e.y - a.y * k.z - hy.x * u.z, a.x * k.z - e.x - hy.y * u.z, one - hy.z * u.z),
        );
        // Cramer's rule: one division for the three unknowns.
        let [c0, c1, c2] = jacobian.cols;
        let (r12, r20, r01) = (c1.cross(c2), c2.cross(c0), c0.cross(c1));
        let inverse_det = one / c0.dot(r12);
        a -= Vec3::new(r12.dot(residual), r20.dot(residual), r01.dot(residual)) * inverse_det;
    }
    a.scale(k)
}

/// One free rotation over `h` \[s\]: the new orientation.
///
/// `l` is the angular momentum in world axes [kg·m²/s]; `k` the reciprocal principal moments [1/(kg·m²)], along the axes
/// of `rot`. Lanes whose angle h|ω| exceeds [`Order::max_angle`] take several equal sub-rotations, at most
/// [`MAX_SUBROTATIONS`]: beyond it the lane does not turn, and its mask is true in the second result.
#[inline(always)]
pub fn rotate<T: Lane>(order: Order, rot: Quat<T>, l: Vec3<T>, k: Vec3<T>, h: T) -> (Quat<T>, T::Mask) {
    let one = h.like(1.0);
    let y = rot.inverse_rotate(l);
    let inv = Invariants::new(y, k);
    let bound = h.like(order.max_angle());
    let angle2 = h * h * inv.max_angular_speed_squared(k);
    let refused = (bound * bound * h.like(MAX_SUBROTATIONS * MAX_SUBROTATIONS)).lt(angle2);
    let several = (bound * bound).lt(angle2);
    if !T::any(several) {
        let (s, d) = preprocessing(order, &inv, h);
        let k = k * (one + s) + Vec3::new(d, d, d);
        return (turn(rot, cayley_vector(y, k, h)), refused);
    }
    let n = T::select(refused, h.like(0.0), (angle2.sqrt() / bound).ceil().greatest(one));
    let h = h / n.greatest(one);
    let (s, d) = preprocessing(order, &inv, h);
    let k = k * (one + s) + Vec3::new(d, d, d);
    let mut rot = rot;
    let mut done = h.like(0.0);
    while T::any(done.lt(n)) {
        let y = rot.inverse_rotate(l);
        rot = Quat::select(done.lt(n), turn(rot, cayley_vector(y, k, h)), rot);
        done = done + one;
    }
    (rot, refused)
}

/// rot δ with δ = (1, e)/√(1 + |e|²), a unit again.
#[inline(always)]
fn turn<T: Lane>(rot: Quat<T>, e: Vec3<T>) -> Quat<T> {
    let q = rot * Quat::from_parts(e.x.like(1.0), e);
    q.scaled(e.x.like(1.0) / q.norm_squared().sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrate::exact;

    /// One step without sub-rotation.
    fn one_step(order: Order, rot: Quat, l: Vec3, k: Vec3, h: f64) -> Quat {
        let y = rot.inverse_rotate(l);
        let (s, d) = preprocessing(order, &Invariants::new(y, k), h);
        turn(rot, cayley_vector(y, k * (1.0 + s) + Vec3::splat(d), h))
    }

    /// Against the exact solution the error of one step falls with the power order + 1, for steps so large that even the
    /// tenth order is above rounding; the coefficients of every order are in play.
    #[test]
    fn every_order_has_its_slope() {
        let inertia = Vec3::new(0.6, 0.8, 1.0);
        let k = Vec3::new(1.0 / 0.6, 1.0 / 0.8, 1.0);
        let l = Vec3::new(1.8, 0.4, -0.9);
        for order in [Order::Two, Order::Four, Order::Six, Order::Eight, Order::Ten] {
            // |ω| = 3.1 rad/s: angles of 0.5 to 0.25 rad, and of 0.6 for the orders that would otherwise be at rounding.
            let largest = if order.number() < 8 { 0.16 } else { 0.2 };
            let error = |h: f64| {
                let mut sum = 0.0;
                for i in 0..20 {
                    // Different places of the orbit, so that no leading term vanishes by chance.
                    let rot = exact::rotate(Quat::IDENTITY, l, inertia, 0.37 * f64::from(i));
                    sum += one_step(order, rot, l, k, h).angle_to(exact::rotate(rot, l, inertia, h));
                }
                sum
            };
            let slope = libm::log2(error(largest) / error(0.5 * largest));
            let expected = f64::from(order.number() + 1);
            // The next term of the error is two orders of h|ω| smaller: it bends the slope by some (h|ω|)² = 0.25.
            assert!((slope - expected).abs() < 0.25, "{order:?}: slope {slope}, expected {expected}");
        }
    }

    /// The bound on |ω| is reached on the orbit, and never exceeded.
    #[test]
    fn the_largest_angular_speed_is_sharp() {
        for (inertia, l) in [
            (Vec3::new(0.6, 0.8, 1.0), Vec3::new(1.8, 0.4, -0.9)),
            (Vec3::new(1.0, 2.0, 3.0), Vec3::new(0.001, 2.0, 0.003)),
            (Vec3::new(1.0, 1.0, 0.01), Vec3::new(0.3, 0.0, 0.5)),
        ] {
            let k = Vec3::new(1.0 / inertia.x, 1.0 / inertia.y, 1.0 / inertia.z);
            let bound = Invariants::new(l, k).max_angular_speed_squared(k).sqrt();
            let mut fastest = 0.0f64;
            for i in 0..100_000 {
                let y = exact::rotate(Quat::IDENTITY, l, inertia, 0.001 * f64::from(i)).inverse_rotate(l);
                fastest = fastest.max(y.scale(k).length());
            }
            assert!(fastest <= bound * (1.0 + 1e-12), "{fastest} {bound}");
            // Sampled every millisecond: the speed is flat at its maximum.
            assert!(fastest >= bound * (1.0 - 1e-3), "{fastest} {bound}");
        }
    }
}
