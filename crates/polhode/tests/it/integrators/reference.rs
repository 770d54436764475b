//! The stored trajectories: 22 digits, from float128 extrapolation.

use polhode::math::{Quat, Vec3};
use serde_json::Value;

/// A free top: constants, start, and attitudes at times.
pub(super) struct FreeTop {
    pub(super) name: &'static str,
    /// Principal moments [kg·m²].
    pub(super) inertia: Vec3,
    /// Angular momentum [kg·m²/s]; all start from the identity, so it has these components in the world and in the body.
    pub(super) l: Vec3,
    /// Time [s], attitude, angular velocity in body axes [rad/s].
    pub(super) rows: Vec<(f64, Quat, Vec3)>,
}

impl FreeTop {
    /// The largest |ω| along the trajectory [rad/s].
    pub(super) fn fastest(&self) -> f64 {
        self.rows.iter().map(|(_, _, w)| w.length()).fold(0.0, f64::max)
    }
    /// The attitude at `t`, which must be a stored time.
    pub(super) fn attitude_at(&self, t: f64) -> Quat {
        self.rows.iter().find(|row| row.0 == t).expect("a stored time").1
    }
}

pub(super) fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("an array").iter().map(|v| v.as_f64().expect("a number")).collect()
}

/// Component by component: J0⁻¹ y.
pub(super) fn over(y: Vec3, inertia: Vec3) -> Vec3 {
    Vec3::new(y.x / inertia.x, y.y / inertia.y, y.z / inertia.z)
}

pub(super) fn vec3(v: &[f64]) -> Vec3 {
    Vec3::new(v[0], v[1], v[2])
}

pub(super) fn quat(v: &[f64]) -> Quat {
    Quat::new(v[0], v[1], v[2], v[3])
}

fn free_top(name: &'static str, text: &str) -> FreeTop {
    let json: Value = serde_json::from_str(text).expect("JSON");
    let inertia = vec3(&numbers(&json["I"]));
    let rows: Vec<_> = json["rows"].as_array().expect("rows").iter().map(numbers).collect();
    let rows = rows.iter().map(|r| (r[0], quat(&r[1..5]), vec3(&r[5..8]))).collect();
    FreeTop { name, inertia, l: inertia.scale(vec3(&numbers(&json["omega0_body"]))), rows }
}

/// A top with three different moments, of no special motion.
pub(super) fn hv() -> FreeTop {
    free_top("free_top_HV_060810", include_str!("../../../../polhode-cli/reference/free_top_HV_060810.json"))
}

/// A water molecule: strongly asymmetric.
pub(super) fn water() -> FreeTop {
    free_top(
        "free_top_water_0345_0653_1",
        include_str!("../../../../polhode-cli/reference/free_top_water_0345_0653_1.json"),
    )
}

/// All four free tops.
pub(super) fn free_tops() -> [FreeTop; 4] {
    [
        hv(),
        free_top(
            "free_top_dzhanibekov_123",
            include_str!("../../../../polhode-cli/reference/free_top_dzhanibekov_123.json"),
        ),
        water(),
        free_top(
            "free_box_gazebo_complex",
            include_str!("../../../../polhode-cli/reference/free_box_gazebo_complex.json"),
        ),
    ]
}
