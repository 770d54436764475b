//! The description of a pinned point.

use crate::math::Vec3;
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
}

/// The name of a pin: valid until the pin or its body is removed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PinId(pub(crate) u64);
