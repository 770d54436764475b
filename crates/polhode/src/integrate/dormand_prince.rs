//! The adaptive Runge–Kutta pair of Dormand and Prince, order 5 with an error estimate of order 4: the general reference.
//!
//! J. R. Dormand, P. J. Prince, J. Comput. Appl. Math. 6 (1980); step control and dense output of Hairer, Nørsett,
//! Wanner, *Solving Ordinary Differential Equations I*, II.4–II.6. Not symplectic: its error grows with time, but it says
//! how large a step may be. [`DormandPrince`] solves any system of numbers,
//! [`PhaseSolver`](super::phase_solver::PhaseSolver) a phase of bodies.

use crate::Error;
use crate::math::Lane;

/// The right-hand side of y' = f(t, y): writes all of y'.
pub type FlatLaw<'a> = dyn FnMut(f64, &[f64], &mut [f64]) + 'a;

const STAGES: usize = 7;
const C: [f64; STAGES] = [0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0];
/// Rows of the tableau; the last is also the step itself, so that its stage is the first of the next step.
const A: [&[f64]; STAGES] = [
    &[],
    &[0.2],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
/// Order 5 minus order 4.
const E: [f64; STAGES] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];
/// The fourth-order interpolant (L. F. Shampine, Math. Comp. 46, 1986).
const D: [f64; STAGES] = [
    -12715105075.0 / 11282082432.0,
    0.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
];

/// How exact, and how far at most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Error allowed a step relative to each number; > 0, default 1e-10.
    pub rtol: f64,
    /// Error allowed a step besides, in the unit of each number; ≥ 0, default 1e-12.
    pub atol: f64,
    /// The longest step \[s\]; > 0, default without bound.
    pub h_max: f64,
    /// The most steps, accepted or not, of one [`DormandPrince::advance`]; default 10⁷.
    pub max_steps: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self { rtol: 1e-10, atol: 1e-12, h_max: f64::INFINITY, max_steps: 10_000_000 }
    }
}

impl Settings {
    /// The same relative and absolute tolerance, the rest by default.
    pub fn tolerance(tolerance: f64) -> Self {
        Self { rtol: tolerance, atol: tolerance, ..Self::default() }
    }
    fn check(&self) -> Result<(), Error> {
        let positive = |name, value: f64| {
            if value > 0.0 { Ok(()) } else { Err(Error::new(name, format!("must be positive, is {value}"))) }
        };
        positive("rtol", self.rtol)?;
        positive("h_max", self.h_max)?;
        if self.atol.is_nan() || self.atol < 0.0 {
            return Err(Error::new("atol", format!("must not be negative, is {}", self.atol)));
        }
        Ok(())
    }
}

/// A system y' = f(t, y) on its way.
#[derive(Clone, Debug)]
pub struct DormandPrince {
    settings: Settings,
    t: f64,
    y: Vec<f64>,
    /// The step to try next; 0 before the first \[s\].
    h: f64,
    /// The error of the last accepted step, in tolerances.
    last_error: f64,
    k: [Vec<f64>; STAGES],
    /// Whether `k[0]` is f(t, y).
    k0_known: bool,
    at: Vec<f64>,
    /// Start and length of the last step, and the coefficients of its interpolant.
    t_old: f64,
    h_old: f64,
    dense: [Vec<f64>; 5],
    n_accepted: usize,
    n_rejected: usize,
    /// Puts the state back where it belongs after each accepted step.
    pub(super) projection: Option<fn(&mut [f64])>,
}

impl DormandPrince {
    /// The system in state `y` at time `t`.
    ///
    /// # Errors
    /// If a tolerance or a number of the state is not acceptable.
    pub fn new(settings: Settings, t: f64, y: Vec<f64>) -> Result<Self, Error> {
        settings.check()?;
        if let Some(i) = y.iter().position(|v| !v.is_finite()) {
            return Err(Error::new(format!("y[{i}]"), format!("must be finite, is {}", y[i])));
        }
        let zero = || vec![0.0; y.len()];
        Ok(Self {
            settings,
            t,
            h: 0.0,
            last_error: 1e-4,
            k: core::array::from_fn(|_| zero()),
            k0_known: false,
            at: zero(),
            t_old: t,
            h_old: 0.0,
            dense: core::array::from_fn(|_| zero()),
            n_accepted: 0,
            n_rejected: 0,
            projection: None,
            y,
        })
    }
    /// The time reached \[s\].
    pub fn t(&self) -> f64 {
        self.t
    }
    /// The state at [`DormandPrince::t`].
    pub fn y(&self) -> &[f64] {
        &self.y
    }
    /// The steps accepted so far, and those rejected.
    pub fn n_steps(&self) -> (usize, usize) {
        (self.n_accepted, self.n_rejected)
    }
    /// Goes on to exactly `t_end`, forwards or backwards.
    ///
    /// # Errors
    /// As [`DormandPrince::step`]; also if it takes more than `max_steps` steps.
    pub fn advance(&mut self, law: &mut FlatLaw<'_>, t_end: f64) -> Result<(), Error> {
        let before = self.n_accepted + self.n_rejected;
        while self.t != t_end {
            self.step(law, t_end)?;
            if self.n_accepted + self.n_rejected - before > self.settings.max_steps {
                return Err(Error::new("max_steps", format!("used up at t = {:e}", self.t)));
            }
        }
        Ok(())
    }
    /// Takes one accepted step towards `t_end`, not beyond it.
    ///
    /// # Errors
    /// If the step becomes too short for t to change, because y' has a singularity or is not finite, or if `t_end` is not
    /// finite. The state is then still that of the last accepted step.
    pub fn step(&mut self, law: &mut FlatLaw<'_>, t_end: f64) -> Result<(), Error> {
        let left = t_end - self.t;
        if !left.is_finite() {
            return Err(Error::new("t_end", format!("must be finite, is {t_end}")));
        }
        if left == 0.0 {
            return Ok(());
        }
        if !self.k0_known {
            law(self.t, &self.y, &mut self.k[0]);
            self.k0_known = true;
        }
        if self.h == 0.0 || (self.h > 0.0) != (left > 0.0) {
            self.h = left.signum() * self.first_step(left.abs());
        }
        let floor = 16.0 * f64::EPSILON * self.t.abs().greatest(t_end.abs());
        let mut rejected = false;
        loop {
            if self.h.is_nan() || self.h.abs() < floor.least(left.abs()) {
                let t = self.t;
                return Err(Error::new(
                    "step",
                    format!("underflow at t = {t:e}: the rates are singular or not finite"),
                ));
            }
            // The last step reaches the end exactly, also where it would leave a sliver.
            let last = 1.000001 * self.h.abs() >= left.abs();
            let h = if last { left } else { self.h };
            let error = self.try_step(law, h);
            // PI control with exponents 0.7/5 and 0.4/5; a NaN error shrinks the step as far as is allowed.
            if error <= 1.0 {
                let factor = 0.9 * libm::pow(error.greatest(1e-10), -0.14) * libm::pow(self.last_error, 0.08);
                let bound = if rejected { 1.0 } else { 10.0 };
                let longer = (h * factor.greatest(0.2).least(bound)).abs().least(self.settings.h_max);
                // A step cut short by the end says little about the next.
                self.h = left.signum() * if last { longer.greatest(self.h.abs()) } else { longer };
                self.last_error = error.greatest(1e-4);
                self.accept(if last { t_end } else { self.t + h }, h);
                return Ok(());
            }
            let factor = 0.9 * libm::pow(error, -0.2);
            self.h = h * if factor > 0.2 { factor } else { 0.2 };
            self.n_rejected += 1;
            rejected = true;
        }
    }
    /// The state at a time of the last step, to fourth order.
    ///
    /// # Panics
    /// If `out` is shorter than the state.
    pub fn interpolate(&self, t: f64, out: &mut [f64]) {
        let s = if self.h_old == 0.0 { 0.0 } else { (t - self.t_old) / self.h_old };
        let r = 1.0 - s;
        for (i, out) in out[..self.y.len()].iter_mut().enumerate() {
            let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|j| self.dense[j][i]);
            *out = a + s * (b + r * (c + s * (d + r * e)));
        }
    }
    /// The error of a step of h in tolerances; the new state is left in `at`, its rates in the last stage.
    fn try_step(&mut self, law: &mut FlatLaw<'_>, h: f64) -> f64 {
        for stage in 1..STAGES {
            for i in 0..self.y.len() {
                let sum: f64 = A[stage].iter().zip(&self.k).map(|(a, k)| a * k[i]).sum();
                self.at[i] = self.y[i] + h * sum;
            }
            law(self.t + C[stage] * h, &self.at, &mut self.k[stage]);
        }
        let mut sum = 0.0;
        for i in 0..self.y.len() {
            let error: f64 = E.iter().zip(&self.k).map(|(e, k)| e * k[i]).sum();
            let ratio = h * error / self.allowed(i, self.at[i]);
            sum += ratio * ratio;
        }
        (sum / self.y.len().max(1) as f64).sqrt()
    }
    /// The error allowed in number i, which is about to become `new`. Never 0: an unmoving 0 has error 0.
    fn allowed(&self, i: usize, new: f64) -> f64 {
        let size = self.y[i].abs().greatest(new.abs());
        self.settings.atol + self.settings.rtol * size + f64::MIN_POSITIVE
    }
    fn accept(&mut self, t_new: f64, h: f64) {
        for i in 0..self.y.len() {
            let change = self.at[i] - self.y[i];
            let bend = h * self.k[0][i] - change;
            let sum: f64 = D.iter().zip(&self.k).map(|(d, k)| d * k[i]).sum();
            let coefficients = [self.y[i], change, bend, change - h * self.k[STAGES - 1][i] - bend, h * sum];
            for (dense, coefficient) in self.dense.iter_mut().zip(coefficients) {
                dense[i] = coefficient;
            }
        }
        (self.t_old, self.h_old) = (self.t, h);
        self.t = t_new;
        core::mem::swap(&mut self.y, &mut self.at);
        self.k.swap(0, STAGES - 1);
        if let Some(project) = self.projection {
            project(&mut self.y);
            self.k0_known = false;
        }
        self.n_accepted += 1;
    }
    /// A first step from the size of y and y' alone (Hairer, Nørsett, Wanner II.4): 1 % of the time in which y doubles.
    fn first_step(&self, left: f64) -> f64 {
        let (mut size, mut rate) = (0.0, 0.0);
        for i in 0..self.y.len() {
            let allowed = self.allowed(i, 0.0);
            let (y, dy) = (self.y[i] / allowed, self.k[0][i] / allowed);
            size += y * y;
            rate += dy * dy;
        }
        let guess = if size > 1e-10 && rate > 1e-10 { 0.01 * (size / rate).sqrt() } else { 1e-6 * left };
        // Not finite only if y' is not: then the floor catches it.
        if guess.is_finite() { guess.least(left).least(self.settings.h_max) } else { left }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn oscillator(_: f64, y: &[f64], dy: &mut [f64]) {
        dy[0] = y[1];
        dy[1] = -y[0];
    }

    #[test]
    fn tableau_meets_its_row_sums_and_quadratures() {
        for (c, row) in C.iter().zip(A) {
            // Terms up to 12 that cancel to ≤ 1.
            assert!((row.iter().sum::<f64>() - c).abs() < 24.0 * f64::EPSILON);
        }
        // Σ b c^n = 1/(n+1) for the step and for the embedded formula b − e.
        for n in 0..5_u32 {
            let power = |c: f64| (0..n).fold(1.0, |p, _| p * c);
            let b: f64 = A[6].iter().zip(C).map(|(b, c)| b * power(c)).sum();
            assert!((b - 1.0 / f64::from(n + 1)).abs() < 4.0 * f64::EPSILON, "{n}");
            if n < 4 {
                let e: f64 = E.iter().zip(C).map(|(e, c)| e * power(c)).sum();
                assert!(e.abs() < 4.0 * f64::EPSILON, "{n}");
            }
        }
    }

    #[test]
    fn error_follows_the_tolerance_and_backwards_undoes() {
        let period = 2.0 * core::f64::consts::PI;
        for tolerance in [1e-6, 1e-9, 1e-12] {
            let mut solver = DormandPrince::new(Settings::tolerance(tolerance), 0.0, vec![1.0, 0.0]).unwrap();
            solver.advance(&mut oscillator, 10.0 * period).unwrap();
            let error = (solver.y()[0] - 1.0).abs().max(solver.y()[1].abs());
            // A stable system adds up at most the errors of its steps, each within the tolerance.
            let (steps, _) = solver.n_steps();
            assert!(error < steps as f64 * tolerance, "{error:e} {steps}");
            solver.advance(&mut oscillator, 0.0).unwrap();
            assert_eq!(solver.t(), 0.0);
            assert!((solver.y()[0] - 1.0).abs() < 2.0 * steps as f64 * tolerance);
        }
    }

    #[test]
    fn dense_output_is_of_fourth_order() {
        let error = |h: f64| {
            let settings = Settings { h_max: h, ..Settings::tolerance(1.0) };
            let mut solver = DormandPrince::new(settings, 0.0, vec![1.0, 0.0]).unwrap();
            let (mut worst, mut out) = (0.0_f64, [0.0; 2]);
            while solver.t() < 5.0 {
                let start = solver.t();
                solver.step(&mut oscillator, 5.0).unwrap();
                for s in [0.0, 0.3, 0.7, 1.0] {
                    let t = start + s * (solver.t() - start);
                    solver.interpolate(t, &mut out);
                    worst = worst.max((out[0] - libm::cos(t)).abs());
                }
            }
            worst
        };
        let slope = libm::log2(error(0.2) / error(0.05)) / 2.0;
        // The interpolant's error is O(h⁵) a step, the steps' own sum is O(h⁵).
        assert!((4.5..5.5).contains(&slope), "{slope}");
    }

    #[test]
    fn singularity_is_an_error_and_not_a_panic() {
        // y' = y² from 1 is 1/(1−t).
        let mut blow_up = |_: f64, y: &[f64], dy: &mut [f64]| dy[0] = y[0] * y[0];
        let mut solver = DormandPrince::new(Settings::default(), 0.0, vec![1.0]).unwrap();
        let error = solver.advance(&mut blow_up, 2.0).unwrap_err();
        assert_eq!(error.path(), "step");
        assert!((solver.t() - 1.0).abs() < 1e-6, "{}", solver.t());

        let mut nan = |_: f64, _: &[f64], dy: &mut [f64]| dy[0] = f64::NAN;
        let mut solver = DormandPrince::new(Settings::default(), 0.0, vec![1.0]).unwrap();
        assert_eq!(solver.advance(&mut nan, 2.0).unwrap_err().path(), "step");
        assert_eq!(solver.y(), [1.0]);
        assert_eq!(solver.advance(&mut nan, f64::NAN).unwrap_err().path(), "t_end");

        let stiff = Settings { max_steps: 10, ..Settings::default() };
        let mut solver = DormandPrince::new(stiff, 0.0, vec![1.0, 0.0]).unwrap();
        assert_eq!(solver.advance(&mut oscillator, 1e6).unwrap_err().path(), "max_steps");
    }

    #[test]
    fn bad_settings_are_named() {
        let path = |settings| DormandPrince::new(settings, 0.0, vec![0.0]).unwrap_err().path().to_owned();
        assert_eq!(path(Settings { rtol: 0.0, ..Settings::default() }), "rtol");
        assert_eq!(path(Settings { atol: f64::NAN, ..Settings::default() }), "atol");
        assert_eq!(path(Settings { h_max: -1.0, ..Settings::default() }), "h_max");
        assert_eq!(DormandPrince::new(Settings::default(), 0.0, vec![0.0, f64::NAN]).unwrap_err().path(), "y[1]");
    }
}
