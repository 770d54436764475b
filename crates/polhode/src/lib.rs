//! Rigid-body dynamics whose state is the textbook's: position, orientation, linear and angular momentum.

pub mod error;
pub mod math;
pub mod store;
pub mod par;

pub use error::Error;
