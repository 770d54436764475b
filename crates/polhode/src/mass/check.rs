//! What makes a mass, a length or an inertia acceptable, and how a refusal reads.

use crate::error::Error;
use crate::math::{Mat3, Vec3};

/// Share of the largest moment by which an inertia may miss symmetry or the triangle inequality: what a sum of ten million
/// particles can lose to rounding, n ε/2.
const ROUNDING: f64 = 1e-9;

/// Least ratio of smallest to largest principal moment. Below, the moment of a line of a million particles that is not
/// along an axis cannot be told from the rounding of its sum; a rod 1 m long reaches it at a radius of 0.4 µm.
const THINNEST: f64 = 1e-12;

/// A number for a message: plain where that is short, scientific where it would be a row of zeros.
pub(crate) fn show(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-4..1e7).contains(&size) || !size.is_finite() {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// `value` if it is positive and finite.
pub(crate) fn positive(path: &str, value: f64, unit: &str) -> Result<f64, Error> {
    if value > 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(Error::new(path, format!("must be positive and finite, is {} {unit}", show(value))))
}

/// Mass per volume, if it is positive and finite \[kg/m³\].
pub(super) fn density(value: f64) -> Result<f64, Error> {
    positive("density", value, "kg/m³")
}

/// Mass per area of a lamina, if it is positive and finite \[kg/m²\].
pub(super) fn surface_density(value: f64) -> Result<f64, Error> {
    positive("density", value, "kg/m²")
}

/// The components of `size` if all are positive and finite \[m\]; the path says which is not: `size[1]`.
pub(crate) fn positive_components<const N: usize>(path: &str, size: [f64; N]) -> Result<[f64; N], Error> {
    for (i, value) in size.into_iter().enumerate() {
        positive(&format!("{path}[{i}]"), value, "m")?;
    }
    Ok(size)
}

/// Major and minor radius of a torus that does not overlap itself \[m\].
pub(super) fn torus(major: f64, minor: f64) -> Result<(f64, f64), Error> {
    let (major, minor) = (positive("major", major, "m")?, positive("minor", minor, "m")?);
    if minor <= major {
        return Ok((major, minor));
    }
    let message = format!("must not exceed the major radius {} m, is {} m", show(major), show(minor));
    Err(Error::new("minor", message))
}

/// Inner and outer radius of a ring \[m\].
pub(super) fn ring(inner: f64, outer: f64) -> Result<(f64, f64), Error> {
    let (inner, outer) = (positive("inner", inner, "m")?, positive("outer", outer, "m")?);
    if inner < outer {
        return Ok((inner, outer));
    }
    let message = format!("must be less than the outer radius {} m, is {} m", show(outer), show(inner));
    Err(Error::new("inner", message))
}

/// `v` if it is finite.
pub(crate) fn finite(path: &str, v: Vec3) -> Result<Vec3, Error> {
    if v.is_finite() {
        return Ok(v);
    }
    let [x, y, z] = v.to_array().map(show);
    Err(Error::new(path, format!("must be finite, is ({x}, {y}, {z})")))
}

/// The inertia matrix, made symmetric to the bit, if a rigid body can have it.
pub(super) fn inertia(j: &Mat3) -> Result<Mat3, Error> {
    let refuse = |message: String| Err(Error::new("inertia", message));
    if !j.is_finite() {
        return refuse("has elements that are not finite".into());
    }
    let mut symmetric = *j;
    for (row, col, upper, lower) in [(0, 1, "xy", "yx"), (0, 2, "xz", "zx"), (1, 2, "yz", "zy")] {
        let (a, b) = (j.at(row, col), j.at(col, row));
        if (a - b).abs() > ROUNDING * j.max_abs() {
            let (a, b) = (show(a), show(b));
            return refuse(format!("is not symmetric: element {upper} is {a}, element {lower} is {b} kg·m²"));
        }
        let mean = a + 0.5 * (b - a);
        symmetric.cols[col][row] = mean;
        symmetric.cols[row][col] = mean;
    }
    let mut moments = symmetric.symmetric_eigen().values.to_array();
    moments.sort_by(f64::total_cmp);
    let [i1, i2, i3] = moments;
    let largest = i3.abs();
    if i1 < -THINNEST * largest {
        return refuse(format!("is not positive: its smallest principal moment is I1 = {} kg·m²", show(i1)));
    }
    if largest == 0.0 {
        return refuse("is zero: a point of mass needs a size to turn as a rigid body".into());
    }
    if i1 < THINNEST * largest {
        let (i1, i3) = (show(i1), show(i3));
        return refuse(format!(
            "is that of a line without thickness: I1 = {i1}, I3 = {i3} kg·m², and nothing resists a turn about the line"
        ));
    }
    if i3 - (i1 + i2) > ROUNDING * largest {
        let (sum, i3) = (show(i1 + i2), show(i3));
        return refuse(format!("violates the triangle inequality: I3 = {i3} > I1 + I2 = {sum} kg·m²"));
    }
    Ok(symmetric)
}
