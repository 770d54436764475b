//! Closed forms of solid shapes of uniform density.
//!
//! Axes of revolution lie along z, and the origin is the centre of mass. Lengths in m, densities in kg/m³. Each function
//! refuses a dimension or density that is not positive and finite, and names it.

use super::{Moments, check};
use crate::error::Error;
use crate::math::Vec3;
use core::f64::consts::PI;

fn centered(mass: f64, mean_squares: [f64; 3]) -> Moments {
    Moments::from_mean_squares(mass, Vec3::ZERO, mean_squares.into())
}

/// A ball: J = ⅖ m r².
///
/// # Errors
/// If an argument is not positive and finite.
pub fn sphere(radius: f64, density: f64) -> Result<Moments, Error> {
    let (r, rho) = (check::positive("radius", radius, "m")?, check::density(density)?);
    Ok(centered(rho * (4.0 / 3.0 * PI) * r * r * r, [r * r / 5.0; 3]))
}

/// A box with full edge lengths `size`: J₁ = m (y² + z²)/12.
///
/// # Errors
/// If an argument is not positive and finite.
pub fn cuboid(size: impl Into<Vec3>, density: f64) -> Result<Moments, Error> {
    let [x, y, z] = check::positive_components("size", size.into().to_array())?;
    let rho = check::density(density)?;
    Ok(centered(rho * x * y * z, [x * x / 12.0, y * y / 12.0, z * z / 12.0]))
}

/// A cylinder of `length` between two half balls.
///
/// # Errors
/// If an argument is not positive and finite.
pub fn capsule(radius: f64, length: f64, density: f64) -> Result<Moments, Error> {
    let (r, l) = (check::positive("radius", radius, "m")?, check::positive("length", length, "m")?);
    let rho = check::density(density)?;
    let middle = rho * PI * r * r * l;
    let ends = rho * (4.0 / 3.0 * PI) * r * r * r;
    let mass = middle + ends;
    let across = middle * (r * r / 4.0) + ends * (r * r / 5.0);
    // A half ball has ⟨s⟩ = 3r/8 and ⟨s²⟩ = r²/5 from its flat face, which is l/2 from the centre.
    let along = middle * (l * l / 12.0) + ends * (l * l / 4.0 + 3.0 * l * r / 8.0 + r * r / 5.0);
    Ok(centered(mass, [across / mass, across / mass, along / mass]))
}

/// A circular cylinder: J₃ = ½ m r², J₁ = m (3r² + l²)/12.
///
/// # Errors
/// If an argument is not positive and finite.
pub fn cylinder(radius: f64, length: f64, density: f64) -> Result<Moments, Error> {
    let (r, l) = (check::positive("radius", radius, "m")?, check::positive("length", length, "m")?);
    let rho = check::density(density)?;
    Ok(centered(rho * PI * r * r * l, [r * r / 4.0, r * r / 4.0, l * l / 12.0]))
}

/// A circular cone with its apex at z = ¾ `length` and its base at −¼ `length`, so that the origin is the centre of mass:
/// J₃ = 3/10 m r², J₁ = 3/80 m (4r² + l²).
///
/// # Errors
/// If an argument is not positive and finite.
pub fn cone(radius: f64, length: f64, density: f64) -> Result<Moments, Error> {
    let (r, l) = (check::positive("radius", radius, "m")?, check::positive("length", length, "m")?);
    let rho = check::density(density)?;
    Ok(centered(rho * (PI / 3.0) * r * r * l, [0.15 * r * r, 0.15 * r * r, 0.0375 * l * l]))
}

/// An ellipsoid: J₁ = m (b² + c²)/5.
///
/// # Errors
/// If an argument is not positive and finite.
pub fn ellipsoid(semi_axes: impl Into<Vec3>, density: f64) -> Result<Moments, Error> {
    let [a, b, c] = check::positive_components("semi_axes", semi_axes.into().to_array())?;
    let rho = check::density(density)?;
    Ok(centered(rho * (4.0 / 3.0 * PI) * a * b * c, [a * a / 5.0, b * b / 5.0, c * c / 5.0]))
}

/// A torus with a circle of radius `major` as its core and a tube of radius `minor`: J₃ = m (R² + ¾ a²).
///
/// # Errors
/// If an argument is not positive and finite, or `minor` exceeds `major`, so that the tube would overlap itself.
pub fn torus(major: f64, minor: f64, density: f64) -> Result<Moments, Error> {
    let (big, a) = check::torus(major, minor)?;
    let rho = check::density(density)?;
    let across = 0.5 * big * big + 0.375 * a * a;
    Ok(centered(rho * (2.0 * PI * PI) * big * a * a, [across, across, 0.25 * a * a]))
}
