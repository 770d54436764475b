//! The order of a scheme from its errors at halved steps.

/// A claim about the order of a scheme.
pub(super) struct Claim {
    pub(super) order: usize,
    /// A symmetric scheme has an error expansion in even powers of h only.
    pub(super) symmetric: bool,
    /// h|ω| of the longest step \[rad\], of its longest stage for a composition.
    pub(super) angle: f64,
    /// How often the step is halved.
    pub(super) halvings: usize,
}

impl Claim {
    /// Asserts that `error(n)`, the error with n times as many steps, n = 1, 2, 4, …, falls as claimed.
    ///
    /// An error c hᵖ (1 + d xᵏ + …) with x = h|ω| and |d| ≤ 1 has, over the first halving, a slope that is off p by at
    /// most log₂((1 − (x/2)ᵏ)/(1 − xᵏ)), and over the later ones by less. k is 2 for a symmetric scheme and else 1.
    #[track_caller]
    pub(super) fn assert(&self, name: &str, error: impl Fn(usize) -> f64) {
        let errors: Vec<f64> = (0..=self.halvings).map(|i| error(1 << i)).collect();
        let slope = fitted_slope(&errors);
        let (x, half) = (self.angle, self.angle / 2.0);
        let tolerance = if self.symmetric {
            libm::log2((1.0 - half * half) / (1.0 - x * x))
        } else {
            libm::log2((1.0 - half) / (1.0 - x))
        };
        let off = (slope - self.order as f64).abs();
        assert!(off < tolerance, "{name}: slope {slope} ± {tolerance} from errors {errors:?}");
    }
}

/// The slope of log₂ error over log₂ h for steps h, h/2, h/4, … (least squares).
fn fitted_slope(errors: &[f64]) -> f64 {
    let n = errors.len() as f64;
    let mean_x = -0.5 * (n - 1.0);
    let logs: Vec<f64> = errors.iter().map(|e| libm::log2(*e)).collect();
    let mean_y = logs.iter().sum::<f64>() / n;
    let (mut xy, mut xx) = (0.0, 0.0);
    for (i, y) in logs.iter().enumerate() {
        let x = -(i as f64) - mean_x;
        xy += x * (y - mean_y);
        xx += x * x;
    }
    xy / xx
}
