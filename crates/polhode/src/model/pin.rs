//! The description of a pinned point.

use crate::math::{Mat3, Quat, Vec3};
use crate::store::BodyId;

/// Holds one point of a body at one point of the world, and leaves it free to turn: a spherical bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pin {
    /// The body.
    pub body: BodyId,
    /// From the centre of mass, along the principal axes \[m\].
    pub point: Vec3,
    /// Where it is held, world \[m\].
    pub at: Vec3,
    /// Reciprocal principal moments about the pinned point [1/(kg·m²)].
    pub inv_inertia: Vec3,
    /// Principal axes about the pinned point → principal axes about the centre of mass.
    pub axes: Quat,
}

impl Pin {
    /// Pins the body at `point` from its centre of mass, along its principal axes; `mass` \[kg\] and `inertia` [kg·m²] are its own.
    pub fn new(body: BodyId, point: Vec3, at: Vec3, mass: f64, inertia: Vec3) -> Self {
        // Parallel axes: J_c = J0 + m (|r|² 1 − r rᵀ).
        let steiner = Mat3::diagonal(Vec3::splat(point.length_squared())) - Mat3::outer(point, point);
        let about = (Mat3::diagonal(inertia) + steiner.scaled(mass)).symmetric_eigen();
        let [x, y, z] = about.values.to_array().map(|i| 1.0 / i);
        Self { body, point, at, inv_inertia: Vec3::new(x, y, z), axes: Quat::from_mat3(&about.vectors) }
    }
}

/// The name of a pin: valid until the pin or its body is removed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PinId(pub(crate) u64);
