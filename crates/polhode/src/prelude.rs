//! What most programs need.

pub use crate::field::{Anchor, Field, Wrench};
pub use crate::integrate::Integrator;
pub use crate::mass::MassProperties;
pub use crate::math::{Mat3, Pose, Quat, Vec3};
pub use crate::model::{Body, PinId};
pub use crate::shape::Shape;
pub use crate::step::Report;
pub use crate::store::{BodyId, Group};
pub use crate::world::World;
