//! Compositions: a symmetric scheme of order 2, taken in fractions γᵢ of the step, becomes one of order 4, 6 or 8.
//!
//! Ψ_h = Φ_{γₛh} ∘ … ∘ Φ_{γ₁h} with a palindromic γ, Σγᵢ = 1 and, for order 4, Σγᵢ³ = 0. Some fractions are negative: a
//! theorem above order 2. What Φ conserves exactly, Ψ does too.

/// How many fractions of a step make one, and which.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Composition {
    /// The base scheme itself, order 2.
    #[default]
    Single,
    /// Three stages, order 4: 1/(2−∛2) twice (H. Yoshida, Phys. Lett. A 150, 1990). Cheapest, with the largest error.
    Yoshida4,
    /// Five stages, order 4: 1/(4−∛4) four times (M. Suzuki, Phys. Lett. A 146, 1990).
    Suzuki4,
    /// Nine stages, order 6 (W. Kahan, R.-C. Li, Math. Comp. 66, 1997).
    KahanLi6,
    /// Seventeen stages, order 8 (same).
    KahanLi8,
}

// 1/(2 − 2^(1/3)), 1 − 2 of it; 1/(4 − 4^(1/3)), 1 − 4 of it.
const Y1: f64 = 1.351207191959657634047688;
const Y0: f64 = -1.702414383919315268095376;
const S1: f64 = 0.4144907717943757371423541;
const S0: f64 = -0.6579630871775029485694163;

const K6: [f64; 5] = [
    0.39216144400731413928,
    0.33259913678935943860,
    -0.70624617255763935981,
    0.082213596293550800230,
    0.79854399093482996340,
];
const K8: [f64; 9] = [
    0.13020248308889008088,
    0.56116298177510838456,
    -0.38947496264484728641,
    0.15884190655515560090,
    -0.39590389413323757734,
    0.18453964097831570709,
    0.25837438768632204729,
    0.29501172360931029887,
    -0.60550853383003451170,
];
const KAHAN_LI6: [f64; 9] = mirrored(K6);
const KAHAN_LI8: [f64; 17] = mirrored(K8);

impl Composition {
    /// All of them, by rising order.
    pub const ALL: [Self; 5] = [Self::Single, Self::Yoshida4, Self::Suzuki4, Self::KahanLi6, Self::KahanLi8];

    /// The fractions γᵢ of the step, in the order they are taken; a palindrome whose sum is 1.
    pub const fn fractions(self) -> &'static [f64] {
        match self {
            Self::Single => &[1.0],
            Self::Yoshida4 => &[Y1, Y0, Y1],
            Self::Suzuki4 => &[S1, S1, S0, S1, S1],
            Self::KahanLi6 => &KAHAN_LI6,
            Self::KahanLi8 => &KAHAN_LI8,
        }
    }
    /// The name in a scene or on a command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Single => "single",
            Self::Yoshida4 => "yoshida4",
            Self::Suzuki4 => "suzuki4",
            Self::KahanLi6 => "kahan-li6",
            Self::KahanLi8 => "kahan-li8",
        }
    }
    /// The order of the composition of a symmetric scheme of order 2.
    pub const fn order(self) -> usize {
        match self {
            Self::Single => 2,
            Self::Yoshida4 | Self::Suzuki4 => 4,
            Self::KahanLi6 => 6,
            Self::KahanLi8 => 8,
        }
    }
}

/// The first half and the middle of a palindrome, continued.
const fn mirrored<const HALF: usize, const ALL: usize>(half: [f64; HALF]) -> [f64; ALL] {
    let mut all = [0.0; ALL];
    let mut i = 0;
    while i < ALL {
        all[i] = half[if i < HALF { i } else { ALL - 1 - i }];
        i += 1;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_are_palindromes_that_meet_their_order_conditions() {
        for composition in Composition::ALL {
            let g = composition.fractions();
            assert!(g.iter().eq(g.iter().rev()), "{composition:?}");
            let power_sum = |n: u32| -> f64 { g.iter().map(|x| (0..n).fold(1.0, |product, _| product * x)).sum() };
            // Each of up to 17 terms of size up to 1.7ⁿ rounds at n ε/2, as does each partial sum.
            let tolerance = |n: u32| 17.0 * f64::EPSILON * power_sum(n).abs().max(1.0) * f64::from(n);
            assert!((power_sum(1) - 1.0).abs() < tolerance(1), "{composition:?}");
            // Order conditions of a composition of one symmetric scheme: odd power sums vanish below the order.
            for n in (3..composition.order() as u32).step_by(2) {
                let largest = g.iter().fold(0.0_f64, |a, x| a.max(x.abs()));
                let scale = (0..n).fold(1.0, |product, _| product * largest.max(1.0));
                assert!(power_sum(n).abs() < tolerance(n) * scale, "{composition:?} {n} {:e}", power_sum(n));
            }
        }
    }

    #[test]
    fn fourth_order_fractions_are_their_closed_forms() {
        let (c2, c4) = (libm::cbrt(2.0), libm::cbrt(4.0));
        // 2 − ∛2 = 0.74 from 1.26: cancellation makes one rounding two.
        assert!((Y1 - 1.0 / (2.0 - c2)).abs() < 4.0 * f64::EPSILON);
        assert!((Y0 + c2 / (2.0 - c2)).abs() < 4.0 * f64::EPSILON);
        assert!((S1 - 1.0 / (4.0 - c4)).abs() < 2.0 * f64::EPSILON);
        assert!((S0 + c4 / (4.0 - c4)).abs() < 2.0 * f64::EPSILON);
    }
}
