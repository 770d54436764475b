//! Vectors, rotations and numbers that may be several numbers.
//!
//! Every type is generic over [`Lane`]; the `f64` instance, which the bare name means, is the public type.

pub mod curve;
pub mod dense;
mod eigen;
pub mod elliptic;
mod interop;
mod lane;
mod mat3;
mod pose;
mod quat;
mod vec3;

pub use eigen::SymmetricEigen;
pub use lane::{Lane, Wide};
pub use mat3::Mat3;
pub use pose::Pose;
pub use quat::Quat;
pub use vec3::Vec3;
