//! The two halves of a RATTLE step for a body with pinned points.
//!
//! With one pin the constraint is eliminated: between kicks the body turns freely about the pinned point, with its inertia
//! about that point and its angular momentum about it constant, so the free rotation of [`crate::integrate`] is the whole
//! answer and the point never leaves its place.
//!
//! With several, all rows of the body are solved together and directly: 3 rows a pin, however redundant. In the first half the impulses λ are found such that the points close *after* the drift, by Newton steps on
//! the real drift; in the second the impulses µ such that the points do not move. λ starts from the last µ and never from
//! the last λ, which would integrate the gap instead of closing it.

use crate::constraint::pin;
use crate::math::{Mat3, Quat, Vec3, dense};
use crate::model::Pin;
use crate::state::angular_velocity;

/// Room for one body's rows. Scratch: nothing in it outlives a call.
#[derive(Clone, Debug, Default)]
pub struct Rows {
    system: System,
    /// Arms at the start of the half, world \[m\] (n).
    arms: Vec<Vec3>,
}

/// The linear system of n points of one body, three rows each.
#[derive(Clone, Debug, Default)]
pub struct System {
    /// The matrix, 3n × 3n by rows.
    a: Vec<f64>,
    /// Right-hand side, then solution (3n).
    b: Vec<f64>,
    /// Column order of the elimination (3n).
    order: Vec<usize>,
}

impl Rows {
    /// Room for `n` pins on one body, so that a step allocates nothing.
    pub fn reserve(&mut self, n: usize) {
        self.system.reserve(n);
        self.arms.resize(n.max(self.arms.len()), Vec3::splat(f64::NAN));
    }
    /// Overwrites everything with what no computation survives.
    pub fn poison(&mut self) {
        self.system.a.fill(f64::NAN);
        self.system.b.fill(f64::NAN);
        self.system.order.fill(usize::MAX);
        self.arms.fill(Vec3::splat(f64::NAN));
    }
}

impl System {
    /// Room for `n` points.
    pub fn reserve(&mut self, n: usize) {
        self.a.resize((9 * n * n).max(self.a.len()), f64::NAN);
        self.b.resize((3 * n).max(self.b.len()), f64::NAN);
        self.order.resize((3 * n).max(self.order.len()), usize::MAX);
    }
    /// The impulses P with Σ_j `block(i, j)` P_j = `right(i)`; where rows are redundant, one choice of several.
    pub fn solve(
        &mut self,
        n: usize,
        right: impl Fn(usize) -> Vec3,
        block: impl Fn(usize, usize) -> Mat3,
    ) -> impl Iterator<Item = Vec3> {
        for i in 0..n {
            self.b[3 * i..3 * i + 3].copy_from_slice(&right(i).to_array());
            for j in 0..n {
                let k = block(i, j);
                for r in 0..3 {
                    for c in 0..3 {
                        self.a[(3 * i + r) * 3 * n + 3 * j + c] = k.at(r, c);
                    }
                }
            }
        }
        let b = &mut self.b[..3 * n];
        dense::solve_rank_revealing(&mut self.a[..9 * n * n], b, &mut self.order[..3 * n], RANK_TOLERANCE);
        b.chunks_exact(3).map(|p| Vec3::new(p[0], p[1], p[2]))
    }
}

/// The pinned body: its state and constants.
pub struct Pinned<'a> {
    /// Centre of mass, world \[m\].
    pub x: &'a mut Vec3,
    /// Principal axes → world axes.
    pub rot: &'a mut Quat,
    /// Linear momentum, world [kg·m/s].
    pub p: &'a mut Vec3,
    /// Angular momentum about the centre of mass, world [kg·m²/s].
    pub l: &'a mut Vec3,
    /// 1/m \[1/kg\].
    pub inv_mass: f64,
    /// Reciprocal principal moments [1/(kg·m²)].
    pub inv_inertia: Vec3,
}

/// One pin of the body: its point in principal axes, and where it is held.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// From the centre of mass, principal axes \[m\].
    pub point: Vec3,
    /// World \[m\].
    pub at: Vec3,
}

/// How far the points were from closed when the iteration ended, and what it took.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Residual {
    /// Largest |g| \[m\].
    pub gap: f64,
    /// Newton steps taken.
    pub iterations: u32,
    /// Parts into which the drift was divided.
    pub parts: u32,
}

impl Residual {
    /// The worse of two.
    pub fn max(self, other: Self) -> Self {
        Self {
            gap: self.gap.max(other.gap),
            iterations: self.iterations.max(other.iterations),
            parts: self.parts.max(other.parts),
        }
    }
}

/// The largest turn of one RATTLE step \[rad\]. A bar hinged through its centre opens, out of rounding, from 0.43 on, one
/// hinged at its end from 0.85 on; at 0.35 both held for 20,000 steps.
const RATTLE_ANGLE: f64 = 0.25;

/// A turn of more than 100 rad in a step is no motion that anyone could see.
const MOST_PARTS: f64 = 1000.0;

/// More would mean that the step is too long for the motion; each contracts the gap by about h|ω|/2.
const MAX_NEWTON_STEPS: u32 = 24;

/// A pivot this much smaller than the largest is a redundant row: rounding leaves 1e-16, honest geometry more than 1e-9.
const RANK_TOLERANCE: f64 = 1e-10;

impl Pinned<'_> {
    /// An impulse P at an arm: p += P, l += r × P.
    fn apply(&mut self, impulse: Vec3, arm: Vec3) {
        *self.p += impulse;
        *self.l += arm.cross(impulse);
    }

    /// The free motion over `h` that several pins leave: RATTLE, in as many equal parts as the turn needs.
    ///
    /// `closing` is scratch of n impulses; all impulses are added to `sum`. `drift` is the free rotation over a time.
    /// `longest` is the longest stage of the composition \[s\]: all its stages take the same number of parts, or they would not
    /// be the same scheme and gain no order. `least_inertia` is the least moment about the first pin [kg·m²].
    pub fn drift_by_rattle(
        &mut self,
        points: impl Fn(usize) -> Point,
        (closing, sum): (&mut [Vec3], &mut [Vec3]),
        (h, longest, least_inertia): (f64, f64, f64),
        drift: impl Fn(Quat, Vec3, f64) -> Quat,
        rows: &mut Rows,
    ) -> Residual {
        let add = |sum: &mut [Vec3], impulse: &[Vec3]| sum.iter_mut().zip(impulse).for_each(|(s, p)| *s += *p);
        // The kick left a velocity that the pins do not allow.
        self.close_velocities(&points, closing, rows);
        add(sum, closing);
        let speed = self.largest_speed(&points, sum.len(), least_inertia);
        let parts = (longest * speed / RATTLE_ANGLE).ceil().clamp(1.0, MOST_PARTS);
        let part = h / parts;
        closing.fill(Vec3::ZERO);
        let mut worst = Residual::default();
        for _ in 0..parts as u32 {
            worst = worst.max(self.close_positions(&points, closing, part, |rot, l| drift(rot, l, part), rows));
            add(sum, closing);
            self.close_velocities(&points, closing, rows);
            add(sum, closing);
        }
        worst.parts = parts as u32;
        worst
    }

    /// The largest |ω| of the free motion that the pins leave: an invariant, so that there are as many parts backwards as
    /// forwards.
    fn largest_speed(&self, points: impl Fn(usize) -> Point, n: usize, least_inertia: f64) -> f64 {
        let w = angular_velocity(*self.rot, *self.l, self.inv_inertia);
        if (1..n).any(|i| points(i).point != points(0).point) {
            // A turn about an axis, whose speed stays the same.
            return w.length();
        }
        let twice_energy = self.p.length_squared() * self.inv_mass + w.dot(*self.l);
        (twice_energy / least_inertia).sqrt()
    }

    /// The first half: finds and applies the impulses with which the points are closed after the drift over `h`, and
    /// drifts. `impulse` holds the last closing impulses, and receives what was applied.
    fn close_positions(
        &mut self,
        points: impl Fn(usize) -> Point,
        impulse: &mut [Vec3],
        h: f64,
        drift: impl Fn(Quat, Vec3) -> Quat,
        rows: &mut Rows,
    ) -> Residual {
        let n = impulse.len();
        let Rows { system, arms } = rows;
        let (x, rot) = (*self.x, *self.rot);
        for (i, &impulse) in impulse.iter().enumerate() {
            arms[i] = rot.rotate(points(i).point);
            self.apply(impulse, arms[i]);
        }
        let mut residual = Residual { gap: f64::INFINITY, iterations: 0, parts: 1 };
        loop {
            let x1 = x + *self.p * (h * self.inv_mass);
            let rot1 = drift(rot, *self.l);
            let gap = |i: usize| pin::gap(x1, rot1.rotate(points(i).point), points(i).at);
            let worst = (0..n).map(|i| gap(i).robust_length()).fold(0.0, f64::max);
            // Newton ends where rounding stops it: the gap no longer shrinks.
            let stuck = worst.is_nan() || worst >= 0.75 * residual.gap;
            (*self.x, *self.rot) = (x1, rot1);
            residual.gap = worst;
            if worst == 0.0 || stuck || residual.iterations == MAX_NEWTON_STEPS {
                return residual;
            }
            residual.iterations += 1;
            let (inv_mass, turn) = (h * self.inv_mass, self.turn_response(rot.halfway_to(rot1), h));
            let block = |i: usize, j: usize| pin::response(inv_mass, turn, rot1.rotate(points(i).point), arms[j]);
            for (i, step) in system.solve(n, |i| -gap(i), block).enumerate() {
                impulse[i] += step;
                self.apply(step, arms[i]);
            }
        }
    }

    /// The turn over a step h per angular impulse at its start; `middle` is the orientation halfway.
    ///
    /// From ω = J⁻¹ L the variation of ω is J⁻¹ δL + δθ × ω − J⁻¹ (δθ × L), because a body that is turned also turns its
    /// inertia; and a turn is carried along, dδθ/dt = δω + ω × δθ. So
    ///
    /// ```text
    /// dδθ/dt = A δθ + J⁻¹ δL,   A = J⁻¹ [L]×
    /// δθ = h (1 + hA/2 + h²A²/6 + …) J⁻¹ δL
    /// ```
    ///
    /// Without A each Newton step would gain a factor h|ω| only.
    fn turn_response(&self, middle: Quat, h: f64) -> Mat3 {
        let inverse = pin::world_inverse_inertia(middle, self.inv_inertia);
        let a = (inverse * Mat3::cross(*self.l)).scaled(h);
        (Mat3::IDENTITY + a.scaled(0.5) + (a * a).scaled(1.0 / 6.0)) * inverse.scaled(h)
    }

    /// The first half of a body with one pin: drifts about it over `h`. `rotate` is the free rotation (orientation,
    /// angular momentum, reciprocal moments). Returns the impulse of the pin.
    pub fn drift_about(
        &mut self,
        pin: &Pin,
        mass: f64,
        rotate: impl Fn(Quat, Vec3, Vec3) -> Quat,
        rows: &mut Rows,
    ) -> Vec3 {
        let before = *self.p;
        let mut impulse = [Vec3::ZERO];
        let point = Point { point: pin.point, at: pin.at };
        // The kick left a velocity that the pin does not allow; its answer does not change L about the pin.
        self.close_velocities(|_| point, &mut impulse, rows);
        let l = *self.l - rows.arms[0].cross(*self.p);
        let rot = rotate(*self.rot * pin.axes, l, pin.inv_inertia);
        *self.rot = (rot * pin.axes.conjugate()).renormalized();
        let w = angular_velocity(rot, l, pin.inv_inertia);
        let arm = self.rot.rotate(pin.point);
        *self.x = pin.at - arm;
        *self.p = arm.cross(w) * mass;
        *self.l = l + arm.cross(*self.p);
        *self.p - before
    }

    /// The second half: finds and applies the impulses with which the points are at rest, and writes them to `impulse`.
    pub fn close_velocities(&mut self, points: impl Fn(usize) -> Point, impulse: &mut [Vec3], rows: &mut Rows) {
        let n = impulse.len();
        let Rows { system, arms } = rows;
        impulse.fill(Vec3::ZERO);
        for (i, arm) in arms.iter_mut().enumerate().take(n) {
            *arm = self.rot.rotate(points(i).point);
        }
        let inv_inertia_w = pin::world_inverse_inertia(*self.rot, self.inv_inertia);
        // The system is linear; the second pass removes the rounding of the first.
        for _ in 0..2 {
            let v = *self.p * self.inv_mass;
            let w = angular_velocity(*self.rot, *self.l, self.inv_inertia);
            let inv_mass = self.inv_mass;
            let block = |i: usize, j: usize| pin::response(inv_mass, inv_inertia_w, arms[i], arms[j]);
            for (i, step) in system.solve(n, |i| -(v + w.cross(arms[i])), block).enumerate() {
                impulse[i] += step;
                self.apply(step, arms[i]);
            }
        }
    }
}
