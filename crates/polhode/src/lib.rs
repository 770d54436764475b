//! Rigid-body dynamics whose state is the textbook's: position, orientation, linear and angular momentum.

pub mod error;
pub mod math;
pub mod store;
pub mod par;
pub mod mass;
pub mod shape;
pub mod field;
pub mod integrate;
pub mod model;
pub mod state;
pub mod constraint;
pub mod solve;
pub mod step;
pub mod world;
pub mod record;
pub mod prelude;

pub use error::Error;
pub use world::World;
