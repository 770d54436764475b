//! Mass, centre of mass and inertia: of particles, closed forms, polygons, meshes, and of sums of them.
//!
//! ```text
//! particles, solid::*, shell::*, mesh::*  ─┐  sums, motions ↺   ┌→  MassProperties    in space, validated
//! lamina::*, outline::* (thin in z)       ─┴→    Moments      ──┴→  MassProperties2   in the plane, validated
//! ```
//!
//! [`Moments`] hold anything that has mass, also a lamina, a rod or a point. [`MassProperties`] are what a rigid body
//! needs: an inertia that is symmetric, positive and physical.
//!
//! ```
//! use polhode::mass::solid;
//!
//! // A hammer: a steel head on a wooden handle that lies along z.
//! let head = solid::cuboid([0.03, 0.12, 0.03], 7800.0)?.translated([0.0, 0.0, 0.3]);
//! let handle = solid::cylinder(0.012, 0.3, 700.0)?.translated([0.0, 0.0, 0.15]);
//! let hammer = (head + handle).properties()?;
//! assert!(hammer.center().z > 0.28 && hammer.principal().moments.x > hammer.principal().moments.y);
//! # Ok::<(), polhode::Error>(())
//! ```

pub(crate) mod check;
mod closed;
mod ellipsoid_shell;
pub mod lamina;
pub mod mesh;
mod moments;
pub mod outline;
mod particles;
mod planar;
mod polygon;
mod properties;
pub mod shell;
mod simplex;
pub mod solid;
mod tensor;

pub use moments::Moments;
pub use particles::Particle;
pub use planar::{MassProperties2, Particle2, inertia_about_center, inertia_by_parallel_axis};
pub use properties::{MassProperties, Principal};

#[cfg(test)]
mod tests;
