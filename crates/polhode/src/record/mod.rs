//! What is kept of a run.

mod hash;

pub use hash::state_hash;
