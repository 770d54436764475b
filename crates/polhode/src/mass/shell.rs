//! Closed forms of thin shells: the whole surface of a shape, with mass = density · thickness · area.
//!
//! The thickness is taken as the same everywhere and as thin: terms in its square are left out. Axes of revolution lie
//! along z, and the origin is that of the solid shape of the same name. Lengths in m, densities in kg/m³. Each function
//! refuses a dimension, thickness or density that is not positive and finite, and names it.

use super::{Moments, check, ellipsoid_shell};
use crate::error::Error;
use crate::math::Vec3;
use core::f64::consts::PI;

/// Mass per area \[kg/m²\].
fn per_area(thickness: f64, density: f64) -> Result<f64, Error> {
    Ok(check::positive("thickness", thickness, "m")? * check::density(density)?)
}

fn centered(mass: f64, mean_squares: [f64; 3]) -> Moments {
    Moments::from_mean_squares(mass, Vec3::ZERO, mean_squares.into())
}

/// A sphere: J = ⅔ m r².
///
/// # Errors
/// If an argument is not positive and finite.
pub fn sphere(radius: f64, thickness: f64, density: f64) -> Result<Moments, Error> {
    let (r, sigma) = (check::positive("radius", radius, "m")?, per_area(thickness, density)?);
    Ok(centered(sigma * 4.0 * PI * r * r, [r * r / 3.0; 3]))
}

/// The six faces of a box with full edge lengths `size`.
///
/// # Errors
/// If an argument is not positive and finite.
pub fn cuboid(size: impl Into<Vec3>, thickness: f64, density: f64) -> Result<Moments, Error> {
    let [x, y, z] = check::positive_components("size", size.into().to_array())?;
    let sigma = per_area(thickness, density)?;
    // Each pair of faces, by the axis it is perpendicular to: there the square is (x/2)², and x²/12 on the other faces.
    let (fx, fy, fz) = (2.0 * y * z, 2.0 * x * z, 2.0 * x * y);
    let area = fx + fy + fz;
    let mean_square = |edge: f64, own: f64| edge * edge * (own / 4.0 + (area - own) / 12.0) / area;
    Ok(centered(sigma * area, [mean_square(x, fx), mean_square(y, fy), mean_square(z, fz)]))
}

/// An open cylinder of `length` between two half spheres.
///
/// # Errors
/// If an argument is not positive and finite.
pub fn capsule(radius: f64, length: f64, thickness: f64, density: f64) -> Result<Moments, Error> {
    let (r, l) = (check::positive("radius", radius, "m")?, check::positive("length", length, "m")?);
    let sigma = per_area(thickness, density)?;
    let (side, ends) = (2.0 * PI * r * l, 4.0 * PI * r * r);
    let area = side + ends;
    let across = side * (r * r / 2.0) + ends * (r * r / 3.0);
    // A half sphere has equal areas at equal heights (Archimedes): ⟨s⟩ = r/2, ⟨s²⟩ = r²/3 from its rim, l/2 from the centre.
    let along = side * (l * l / 12.0) + ends * (l * l / 4.0 + l * r / 2.0 + r * r / 3.0);
    Ok(centered(sigma * area, [across / area, across / area, along / area]))
}

/// A circular cylinder closed by its two discs.
///
/// # Errors
/// If an argument is not positive and finite.
pub fn cylinder(radius: f64, length: f64, thickness: f64, density: f64) -> Result<Moments, Error> {
    let (r, l) = (check::positive("radius", radius, "m")?, check::positive("length", length, "m")?);
    let sigma = per_area(thickness, density)?;
    let (side, caps) = (2.0 * PI * r * l, 2.0 * PI * r * r);
    let area = side + caps;
    let across = side * (r * r / 2.0) + caps * (r * r / 4.0);
    let along = side * (l * l / 12.0) + caps * (l * l / 4.0);
    Ok(centered(sigma * area, [across / area, across / area, along / area]))
}

/// A circular cone closed by its base disc, apex at z = ¾ `length`, base at −¼ `length`.
///
/// The origin is the centre of mass of the *solid* cone; that of the shell is on the axis, but not at the origin.
///
/// # Errors
/// If an argument is not positive and finite.
pub fn cone(radius: f64, length: f64, thickness: f64, density: f64) -> Result<Moments, Error> {
    let (r, l) = (check::positive("radius", radius, "m")?, check::positive("length", length, "m")?);
    let sigma = per_area(thickness, density)?;
    let slant = (r * r + l * l).sqrt();
    // At the share u of the way down from the apex the circumference is proportional to u: ⟨u⟩ = ⅔, ⟨u²⟩ = ½.
    let side = Moments::from_mean_squares(
        sigma * PI * r * slant,
        Vec3::Z * (l / 12.0),
        Vec3::new(r * r / 4.0, r * r / 4.0, l * l / 18.0),
    );
    let base =
        Moments::from_mean_squares(sigma * PI * r * r, Vec3::Z * (-l / 4.0), Vec3::new(r * r / 4.0, r * r / 4.0, 0.0));
    Ok(side + base)
}

/// An ellipsoid's surface with the same thickness everywhere, by elliptic integrals, to rounding.
///
/// This is not the homoeoid, the layer between two similar ellipsoids, whose inertia is elementary but which is thicker
/// at the ends of the long axes.
///
/// # Errors
/// If an argument is not positive and finite.
pub fn ellipsoid(semi_axes: impl Into<Vec3>, thickness: f64, density: f64) -> Result<Moments, Error> {
    let semi_axes = check::positive_components("semi_axes", semi_axes.into().to_array())?;
    let sigma = per_area(thickness, density)?;
    let (area, mean_squares) = ellipsoid_shell::area_and_mean_squares(semi_axes);
    Ok(centered(sigma * area, mean_squares))
}

/// A torus with a circle of radius `major` as its core and a tube of radius `minor`: J₃ = m (R² + 3/2 a²).
///
/// # Errors
/// If an argument is not positive and finite, or `minor` exceeds `major`, so that the tube would overlap itself.
pub fn torus(major: f64, minor: f64, thickness: f64, density: f64) -> Result<Moments, Error> {
    let (big, a) = check::torus(major, minor)?;
    let sigma = per_area(thickness, density)?;
    let across = 0.5 * big * big + 0.75 * a * a;
    Ok(centered(sigma * 4.0 * PI * PI * big * a, [across, across, 0.5 * a * a]))
}
