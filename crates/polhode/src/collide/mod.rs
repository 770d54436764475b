//! What may touch: boxes around shapes, and the pairs of them that overlap.
//!
//! Nothing here knows a body: shapes, poses, boxes and integer keys go in, boxes and pairs of keys come out.

pub mod bounds;
pub mod broad;

pub use bounds::{Aabb, Ray, bounds};
