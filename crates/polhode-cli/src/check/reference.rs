//! The stored trajectories: 22 digits, from extrapolation in 113-bit arithmetic and from closed forms.

use polhode::Error;
use polhode::math::{Quat, Vec3};
use serde_json::Value;

/// A free top: constants, start, and attitudes at times.
pub(super) struct FreeTop {
    /// The name of its file.
    pub(super) name: &'static str,
    /// Principal moments [kg·m²].
    pub(super) inertia: Vec3,
    /// Angular velocity at the start, where world and body axes coincide \[rad/s\].
    pub(super) w: Vec3,
    /// Time \[s\], attitude, angular velocity in body axes \[rad/s\].
    pub(super) rows: Vec<(f64, Quat, Vec3)>,
}

/// A top in gravity, with a fixed point in the origin.
pub(super) struct HeavyTop {
    pub(super) mass: f64,
    /// Along −z [m/s²].
    pub(super) gravity: f64,
    /// Principal moments about the fixed point [kg·m²].
    pub(super) inertia: Vec3,
    /// Centre of mass in body axes \[m\].
    pub(super) center: Vec3,
    /// Angular velocity at the start, body axes \[rad/s\].
    pub(super) w: Vec3,
    /// Time \[s\], attitude, centre of mass \[m\].
    pub(super) rows: Vec<(f64, Quat, Vec3)>,
}

fn broken(file: &str, what: &str) -> Error {
    Error::new(format!("reference/{file}"), format!("has no {what} as expected"))
}

fn numbers(file: &str, value: &Value) -> Result<Vec<f64>, Error> {
    let array = value.as_array().ok_or_else(|| broken(file, "array"))?;
    array.iter().map(|v| v.as_f64().ok_or_else(|| broken(file, "number"))).collect()
}

fn vec3(file: &str, value: &Value) -> Result<Vec3, Error> {
    match numbers(file, value)?[..] {
        [x, y, z] => Ok(Vec3::new(x, y, z)),
        _ => Err(broken(file, "vector")),
    }
}

fn number(file: &str, value: &Value) -> Result<f64, Error> {
    value.as_f64().ok_or_else(|| broken(file, "number"))
}

fn parse(file: &str, text: &str) -> Result<Value, Error> {
    serde_json::from_str(text).map_err(|e| Error::new(format!("reference/{file}"), e.to_string()))
}

/// The rows, each with at least `columns` numbers.
fn rows(file: &str, json: &Value, columns: usize) -> Result<Vec<Vec<f64>>, Error> {
    let rows = json["rows"].as_array().ok_or_else(|| broken(file, "rows"))?;
    let rows: Vec<Vec<f64>> = rows.iter().map(|row| numbers(file, row)).collect::<Result<_, _>>()?;
    if rows.iter().any(|row| row.len() < columns) {
        return Err(broken(file, "full row"));
    }
    Ok(rows)
}

fn free_top(name: &'static str, text: &str) -> Result<FreeTop, Error> {
    let json = parse(name, text)?;
    let rows = rows(name, &json, 8)?.iter().map(|r| (r[0], quat(r), Vec3::new(r[5], r[6], r[7]))).collect();
    Ok(FreeTop { name, inertia: vec3(name, &json["I"])?, w: vec3(name, &json["omega0_body"])?, rows })
}

fn quat(row: &[f64]) -> Quat {
    Quat::new(row[1], row[2], row[3], row[4])
}

fn heavy_top(name: &'static str, text: &str) -> Result<HeavyTop, Error> {
    let json = parse(name, text)?;
    Ok(HeavyTop {
        mass: number(name, &json["m"])?,
        gravity: number(name, &json["g"])?,
        inertia: vec3(name, &json["I_pivot"])?,
        center: vec3(name, &json["com_body"])?,
        w: vec3(name, &json["omega0_body"])?,
        rows: rows(name, &json, 11)?.iter().map(|r| (r[0], quat(r), Vec3::new(r[8], r[9], r[10]))).collect(),
    })
}

/// I = (0.6, 0.8, 1): no special motion.
pub(super) fn hv() -> Result<FreeTop, Error> {
    free_top("free_top_HV_060810", include_str!("../../reference/free_top_HV_060810.json"))
}

/// The moments of the water molecule.
pub(super) fn water() -> Result<FreeTop, Error> {
    free_top("free_top_water_0345_0653_1", include_str!("../../reference/free_top_water_0345_0653_1.json"))
}

/// I = (1, 2, 3) about the middle axis: it flips.
pub(super) fn dzhanibekov() -> Result<FreeTop, Error> {
    free_top("free_top_dzhanibekov_123", include_str!("../../reference/free_top_dzhanibekov_123.json"))
}

/// The box of the published Gazebo benchmark, next to its separatrix.
pub(super) fn gazebo_box() -> Result<FreeTop, Error> {
    free_top("free_box_gazebo_complex", include_str!("../../reference/free_box_gazebo_complex.json"))
}

/// The fast top of the multibody literature.
pub(super) fn bruls() -> Result<HeavyTop, Error> {
    heavy_top("heavy_top_bruls", include_str!("../../reference/heavy_top_bruls.json"))
}

/// Lagrange's top released at 30° without nutation velocity.
pub(super) fn lagrange() -> Result<HeavyTop, Error> {
    heavy_top("heavy_top_lagrange_30deg", include_str!("../../reference/heavy_top_lagrange_30deg.json"))
}

/// Amplitude \[degrees\] and T/T0 of a pendulum.
pub(super) fn pendulum_periods() -> Result<Vec<(f64, f64)>, Error> {
    let file = "pendulum_period_ratio";
    let json = parse(file, include_str!("../../reference/pendulum_period_ratio.json"))?;
    let ratios = json["ratio"].as_object().ok_or_else(|| broken(file, "ratio"))?;
    let mut periods = Vec::new();
    for (amplitude, ratio) in ratios {
        let degrees: f64 = amplitude.trim_end_matches("deg").parse().map_err(|_| broken(file, "amplitude"))?;
        periods.push((degrees, number(file, ratio)?));
    }
    periods.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(periods)
}

/// Time \[s\] and place (x, y) \[m\] of the pendulum of benchmark A01: 1 m long, from rest at (−1, 0), g = 9.81 along −y.
pub(super) fn simple_pendulum() -> Result<Vec<(f64, [f64; 2])>, Error> {
    let file = "A01_simple_pendulum";
    let json = parse(file, include_str!("../../reference/A01_simple_pendulum.json"))?;
    Ok(rows(file, &json, 3)?.iter().map(|r| (r[0], [r[1], r[2]])).collect())
}

/// The period of a free top's angular velocity in body axes \[s\].
pub(super) fn free_period(name: &str) -> Result<f64, Error> {
    let file = "closed_forms";
    let json = parse(file, include_str!("../../reference/closed_forms.json"))?;
    let text = json[name]["period_body"].as_str().ok_or_else(|| broken(file, "period"))?;
    text.parse().map_err(|_| broken(file, "period"))
}

/// One row of the hard cases: principal moments, angular momentum, time, attitude, condition.
pub(super) struct HardCase {
    pub(super) inertia: Vec3,
    pub(super) l: Vec3,
    pub(super) time: f64,
    pub(super) attitude: Quat,
    /// The attitude change \[rad\] a relative change of the six inputs, summed.
    pub(super) condition: f64,
}

/// Free bodies next to every limit: symmetric, separatrix, needle, plate, very long and very short times.
pub(super) fn hard_free_bodies() -> Result<Vec<HardCase>, Error> {
    let file = "free_body_hard";
    let json = parse(file, include_str!("../../reference/free_body_hard.json"))?;
    let rows = json["rows"].as_array().ok_or_else(|| broken(file, "rows"))?;
    let case = |row: &Value| {
        let q = numbers(file, &row[4])?;
        let [w, x, y, z] = q[..] else { return Err(broken(file, "attitude")) };
        Ok(HardCase {
            inertia: vec3(file, &row[1])?,
            l: vec3(file, &row[2])?,
            time: number(file, &row[3])?,
            attitude: Quat::new(w, x, y, z),
            condition: number(file, &row[5])?,
        })
    };
    rows.iter().map(case).collect()
}
