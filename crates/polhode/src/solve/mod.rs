//! How the laws of [`crate::constraint`] are satisfied together.

pub mod pins;
