//! Rigid-body dynamics whose state is the textbook's: position, orientation, linear and angular momentum.

pub mod error;
pub mod math;

pub mod integrate;

pub use error::Error;
