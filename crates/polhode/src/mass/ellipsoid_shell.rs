//! Area and second moments of the surface of an ellipsoid.
//!
//! With r = (a n₁, b n₂, c n₃), n on the unit sphere, and p = (1/a², 1/b², 1/c²), the surface element is
//! dA = abc √u dΩ, u = Σ p n². Both integrals wanted,
//!
//! ```text
//! F = ∫ √u dΩ      Mᵢ = ∫ nᵢ² √u dΩ
//! ```
//!
//! are Gaussian averages over space (∫ g(x) exp(−|x|²) d³x = ½ Γ((k+3)/2) ∫ g dΩ for g homogeneous of degree k), and
//! √u = π^(−½) ∫₀^∞ u exp(−u t) t^(−½) dt makes the Gaussian integrals elementary. With t = s², αⱼ = 1 + pⱼ s²:
//!
//! ```text
//! F  = 2π  ∫₀^∞ (α₁α₂α₃)^(−½) Σⱼ pⱼ/αⱼ ds
//! Mᵢ = π/2 ∫₀^∞ (α₁α₂α₃)^(−½) (2 pᵢ/αᵢ + Σⱼ pⱼ/αⱼ)/αᵢ ds
//! ```
//!
//! F/4π is Carlson's symmetric `R_G` (DLMF 19.16.3, 19.33.1). Every term is positive, so nothing cancels, for a needle as
//! little as for a sphere. In y = ln s the integrand is analytic for |Im y| < π/2 and decays exponentially both ways, and
//! there the trapezoidal rule converges as exp(−π²/h) (Trefethen & Weideman 2014, theorem 5.1).

use crate::math::Lane;
use core::f64::consts::PI;

/// Step in ln s: exp(−π²/h) = 7e-18.
const STEP: f64 = 0.25;
/// The integrand rises as s below the shortest semi-axis, exp(−40) = 4e-18, and falls as s⁻⁴ above the longest.
const BELOW: f64 = 40.0;
const ABOVE: f64 = 11.0;

/// The area \[m²\] and the mean squares of the three coordinates over it \[m²\], both to rounding.
pub(super) fn area_and_mean_squares(semi_axes: [f64; 3]) -> (f64, [f64; 3]) {
    let shortest = semi_axes.into_iter().fold(f64::INFINITY, Lane::least);
    let longest = semi_axes.into_iter().fold(0.0, Lane::greatest);
    // In units of the longest semi-axis nothing overflows.
    let axes = semi_axes.map(|a| a / longest);
    let p = axes.map(|a| 1.0 / (a * a));
    let (from, to) = (libm::log(shortest / longest) - BELOW, ABOVE);
    let n_steps = libm::ceil((to - from) / STEP) as usize;
    let (mut f, mut m) = (0.0, [0.0; 3]);
    for i in 0..=n_steps {
        let s = libm::exp(from + STEP * i as f64);
        let alpha = p.map(|p| 1.0 + p * s * s);
        // ds = s dy.
        let weight = s / (alpha[0].sqrt() * alpha[1].sqrt() * alpha[2].sqrt());
        let ratio = [p[0] / alpha[0], p[1] / alpha[1], p[2] / alpha[2]];
        let sum = ratio[0] + ratio[1] + ratio[2];
        f += weight * sum;
        for j in 0..3 {
            m[j] += weight * (2.0 * ratio[j] + sum) / alpha[j];
        }
    }
    let area = 2.0 * PI * STEP * f * (longest * axes[0]) * (longest * axes[1]) * axes[2];
    // ⟨x²⟩ = a² M₁/F = a² (π/2)/(2π) m₁/f.
    (area, [0, 1, 2].map(|j| semi_axes[j] * semi_axes[j] * 0.25 * m[j] / f))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Some 200 positive terms with 30 roundings each, of which the worst go one way: below 100 ε.
    const ROUNDING: f64 = 100.0 * f64::EPSILON;

    #[test]
    fn a_sphere_is_exact() {
        for r in [1e-100, 0.3, 1.0, 1e100] {
            let (area, squares) = area_and_mean_squares([r; 3]);
            assert!((area / (4.0 * PI * r * r) - 1.0).abs() < ROUNDING);
            for s in squares {
                assert!((s / (r * r / 3.0) - 1.0).abs() < ROUNDING);
            }
        }
    }

    #[test]
    fn spheroids_have_their_textbook_area() {
        // Oblate: 2πa² (1 + (1−e²)/e artanh e); prolate: 2πa² (1 + c/(a e) arcsin e).
        for ratio in [0.9_f64, 0.5, 0.1, 1e-3, 1e-6] {
            let e = (1.0 - ratio * ratio).sqrt();
            let oblate =
                2.0 * PI * (1.0 + ratio * ratio / e * (0.5 * libm::log((1.0 + e) * (1.0 + e) / (ratio * ratio))));
            let (area, _) = area_and_mean_squares([1.0, 1.0, ratio]);
            assert!((area / oblate - 1.0).abs() < ROUNDING, "{ratio}: {area} {oblate}");
            // arcsin e = arccos(c/a), which does not lose digits where e is nearly 1.
            let prolate = 2.0 * PI * ratio * ratio * (1.0 + libm::acos(ratio) / (ratio * e));
            let (area, _) = area_and_mean_squares([ratio, 1.0, ratio]);
            assert!((area / prolate - 1.0).abs() < ROUNDING, "{ratio}: {area} {prolate}");
        }
    }

    #[test]
    fn extremes_approach_a_disc_and_a_line() {
        // A flat one is two elliptic discs, ⟨x²⟩ = a²/4; corrections are of order c² ln c, 1e-10 here.
        let (area, [x, y, z]) = area_and_mean_squares([2.0, 1.0, 1e-6]);
        assert!((area / (4.0 * PI) - 1.0).abs() < 1e-10);
        assert!((x - 1.0).abs() < 1e-10 && (y - 0.25).abs() < 1e-10 && z < 1e-12);
        // A needle: circumference 2πb √(1 − z²) along z, so that area = π² b, ⟨z²⟩ = ¼, ⟨x²⟩ = ½ b²·¾ (b² above).
        let b = 1e-6;
        let (area, [x, y, z]) = area_and_mean_squares([b, b, 1.0]);
        assert!((area / (PI * PI * b) - 1.0).abs() < 1e-10);
        assert!((z - 0.25).abs() < 1e-10 && (x / (b * b) - 0.375).abs() < 1e-10 && (y - x).abs() < 1e-10 * x);
    }

    #[test]
    fn the_axes_can_be_named_in_any_order() {
        let (area, [x, y, z]) = area_and_mean_squares([1.0, 2.0, 3.0]);
        let (turned, [y2, z2, x2]) = area_and_mean_squares([2.0, 3.0, 1.0]);
        assert!((area / turned - 1.0).abs() < ROUNDING);
        for (a, b) in [(x, x2), (y, y2), (z, z2)] {
            assert!((a / b - 1.0).abs() < ROUNDING);
        }
    }
}
