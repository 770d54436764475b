//! The closing half kick where forces depend on the velocity that it leads to.
//!
//! ```text
//! p = p½ + h/2 F(x, p)
//! ```
//!
//! A plain fixed-point iteration diverges as soon as h c/(2m) > 1. Here each body's momentum, and its angular momentum, go by
//! a secant step along their last change: exact after two evaluations where the force is a multiple of the velocity, and
//! stable however strong the damping. What is applied in the end is always h/2 times a force that was evaluated, so that
//! equal and opposite forces stay so.

use crate::integrate::Phase;
use crate::math::Vec3;

/// Evaluations beyond which a body counts as not solved.
pub(super) const MOST_EVALUATIONS: usize = 20;

/// A residual of this share of the momenta ends the iteration.
const SOLVED: f64 = 1e-12;

/// Where large forces cancel, rounding alone may be more than that; up to this share it still counts as solved.
const ROUNDING: f64 = 1e-9;

/// The square of a share of a smaller momentum would underflow: it has stopped.
const NOTHING: f64 = 1e-120;

/// The iteration's memory. Scratch: nothing outlives a stage.
#[derive(Clone, Debug, Default)]
pub(super) struct Closing {
    p: Channel,
    l: Channel,
}

/// One of the two momenta of every dynamic body.
#[derive(Clone, Debug, Default)]
struct Channel {
    /// At the opening of the closing half (n_bodies).
    half: Vec<Vec3>,
    /// Where the force was evaluated last (n_bodies).
    at: Vec<Vec3>,
    /// The last evaluation but one (n_bodies).
    before: Vec<Evaluation>,
}

/// What an evaluation told.
#[derive(Clone, Copy, Debug)]
struct Evaluation {
    /// Where.
    at: Vec3,
    /// p½ + h/2 F(at) − at.
    residual: Vec3,
    /// How the residual changes along the momentum: −1 without a force, less with damping.
    slope: f64,
}

const UNKNOWN: Evaluation = Evaluation { at: Vec3::splat(f64::NAN), residual: Vec3::splat(f64::NAN), slope: f64::NAN };

impl Closing {
    /// Room for n bodies.
    pub(super) fn fit(&mut self, n: usize) {
        for channel in [&mut self.p, &mut self.l] {
            channel.half.resize(n, Vec3::splat(f64::NAN));
            channel.at.resize(n, Vec3::splat(f64::NAN));
            channel.before.resize(n, UNKNOWN);
        }
    }
    /// Overwrites everything with what no computation survives.
    pub(super) fn poison(&mut self) {
        let n = self.p.half.len();
        *self = Self::default();
        self.fit(n);
    }
    /// Remembers the momenta of the first n bodies at the opening.
    pub(super) fn open(&mut self, bodies: &Phase, n: usize) {
        self.p.half[..n].copy_from_slice(&bodies.p[..n]);
        self.l.half[..n].copy_from_slice(&bodies.l[..n]);
    }
    /// Puts the momenta back to the opening, after noting where the force was just evaluated.
    pub(super) fn reopen(&mut self, bodies: &mut Phase, n: usize) {
        for (channel, momenta) in [(&mut self.p, &mut bodies.p), (&mut self.l, &mut bodies.l)] {
            channel.at[..n].copy_from_slice(&momenta[..n]);
            momenta[..n].copy_from_slice(&channel.half[..n]);
        }
    }
    /// After the kick: how many bodies are not solved yet. Where to evaluate next is left in the momenta, unless `last`.
    pub(super) fn improve(&mut self, bodies: &mut Phase, n: usize, first: bool, last: bool) -> usize {
        let mut unsolved = 0;
        for i in 0..n {
            let p = self.p.improve(i, &mut bodies.p[i], first, last);
            let l = self.l.improve(i, &mut bodies.l[i], first, last);
            unsolved += usize::from(!(p && l));
        }
        unsolved
    }
}

impl Channel {
    /// Whether the body is solved; where not, its momentum becomes the next guess.
    fn improve(&mut self, i: usize, momentum: &mut Vec3, first: bool, last: bool) -> bool {
        let (half, at) = (self.half[i], self.at[i]);
        let residual = *momentum - at;
        let size = half.max_abs().max(at.max_abs());
        let slope = if first { -1.0 } else { self.before[i].slope_to(at, residual, size) };
        self.before[i] = Evaluation { at, residual, slope };
        if residual.max_abs() <= SOLVED * size.max(NOTHING) {
            return true;
        }
        if last {
            return residual.max_abs() <= ROUNDING * size.max(NOTHING);
        }
        let length = residual.robust_length();
        let step = if first && size > 0.0 && length > size {
            // Nothing is known of the slope yet: not further than the momentum is long.
            residual * (size / length)
        } else {
            residual * (-1.0 / slope)
        };
        *momentum = at + step;
        false
    }
}

impl Evaluation {
    /// The slope from here to another evaluation; this one's where the two are too close to tell.
    fn slope_to(&self, at: Vec3, residual: Vec3, size: f64) -> f64 {
        let moved = at - self.at;
        if moved.max_abs() <= 1e-12 * size {
            return self.slope;
        }
        let slope = (residual - self.residual).dot(moved) / moved.length_squared();
        // Anti-damping that comes near to 0 has no solution in reach.
        if slope.is_finite() { slope.min(-0.5) } else { -1.0 }
    }
}
