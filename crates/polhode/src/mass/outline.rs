//! The boundaries of planar shapes as thin strips in the plane z = 0, with mass = density · thickness · length.
//!
//! What [`shell`](super::shell) is to a solid. The thickness is taken as thin: terms in its square are left out. Lengths
//! in m; densities per area, in kg/m².

use super::{Moments, check, polygon};
use crate::error::Error;
use crate::math::Vec3;
use core::f64::consts::PI;

/// Mass per length \[kg/m\].
fn per_length(thickness: f64, density: f64) -> Result<f64, Error> {
    Ok(check::positive("thickness", thickness, "m")? * check::surface_density(density)?)
}

fn circle(mass_per_length: f64, radius: f64) -> Moments {
    let square = 0.5 * radius * radius;
    Moments::from_mean_squares(mass_per_length * 2.0 * PI * radius, Vec3::ZERO, Vec3::new(square, square, 0.0))
}

/// The circle around a disc: I = m r².
///
/// # Errors
/// If an argument is not positive and finite.
pub fn disc(radius: f64, thickness: f64, density: f64) -> Result<Moments, Error> {
    let (r, lambda) = (check::positive("radius", radius, "m")?, per_length(thickness, density)?);
    Ok(circle(lambda, r))
}

/// The four edges of a rectangle with full edge lengths `size`.
///
/// # Errors
/// If an argument is not positive and finite.
pub fn rectangle(size: [f64; 2], thickness: f64, density: f64) -> Result<Moments, Error> {
    let [w, h] = check::positive_components("size", size)?;
    let lambda = per_length(thickness, density)?;
    // Two edges of length w with ⟨x²⟩ = w²/12 and y² = h²/4, and two of length h the other way round.
    let square = |own: f64, other: f64| own * own * (own / 12.0 + other / 4.0) / (own + other);
    Ok(Moments::from_mean_squares(lambda * 2.0 * (w + h), Vec3::ZERO, Vec3::new(square(w, h), square(h, w), 0.0)))
}

/// The two circles of a ring.
///
/// # Errors
/// If an argument is not positive and finite, or `inner` is not less than `outer`.
pub fn ring(inner: f64, outer: f64, thickness: f64, density: f64) -> Result<Moments, Error> {
    let (r, big) = check::ring(inner, outer)?;
    let lambda = per_length(thickness, density)?;
    Ok(circle(lambda, r) + circle(lambda, big))
}

/// The edges of a simple polygon.
///
/// # Errors
/// As [`lamina::polygon`](super::lamina::polygon); also if the thickness is not positive and finite.
pub fn polygon(points: &[[f64; 2]], thickness: f64, density: f64) -> Result<Moments, Error> {
    let lambda = per_length(thickness, density)?;
    polygon::check(points)?;
    Ok(polygon::edge_moments(points, lambda))
}
