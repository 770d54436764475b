//! Closed forms of planar shapes of uniform density: laminae in the plane z = 0.
//!
//! Lengths in m; densities per area, in kg/m². The result is in space, with z = 0, so that it serves a planar body
//! ([`Moments::planar`]) as well as a thin plate in space ([`Moments::properties`]: J₃ = J₁ + J₂).

use super::{Moments, check, polygon};
use crate::error::Error;
use crate::math::Vec3;
use core::f64::consts::PI;

fn centered(mass: f64, x_squared: f64, y_squared: f64) -> Moments {
    Moments::from_mean_squares(mass, Vec3::ZERO, Vec3::new(x_squared, y_squared, 0.0))
}

/// A disc: I = ½ m r².
///
/// # Errors
/// If an argument is not positive and finite.
pub fn disc(radius: f64, density: f64) -> Result<Moments, Error> {
    let (r, sigma) = (check::positive("radius", radius, "m")?, check::surface_density(density)?);
    Ok(centered(sigma * PI * r * r, r * r / 4.0, r * r / 4.0))
}

/// A rectangle with full edge lengths `size`: I = m (w² + h²)/12.
///
/// # Errors
/// If an argument is not positive and finite.
pub fn rectangle(size: [f64; 2], density: f64) -> Result<Moments, Error> {
    let [w, h] = check::positive_components("size", size)?;
    let sigma = check::surface_density(density)?;
    Ok(centered(sigma * w * h, w * w / 12.0, h * h / 12.0))
}

/// What is between two circles: I = ½ m (r² + R²).
///
/// # Errors
/// If an argument is not positive and finite, or `inner` is not less than `outer`.
pub fn ring(inner: f64, outer: f64, density: f64) -> Result<Moments, Error> {
    let (r, big) = check::ring(inner, outer)?;
    let sigma = check::surface_density(density)?;
    let square = (r * r + big * big) / 4.0;
    Ok(centered(sigma * PI * (big - r) * (big + r), square, square))
}

/// A simple polygon, corners in either sense of rotation.
///
/// # Errors
/// If the polygon is not simple: fewer than 3 corners, a corner that is not finite, or edges that touch or cross; or if
/// the density is not positive and finite. Names the corner or the first two such edges.
pub fn polygon(points: &[[f64; 2]], density: f64) -> Result<Moments, Error> {
    let sigma = check::surface_density(density)?;
    polygon::check(points)?;
    Ok(polygon::area_moments(points, sigma))
}
