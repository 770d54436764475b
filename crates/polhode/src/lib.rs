//! Rigid-body dynamics whose state is the textbook's: position, orientation, linear and angular momentum.

pub mod error;
pub mod mass;
pub mod math;
pub mod shape;

pub use error::Error;
