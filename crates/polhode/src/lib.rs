//! Rigid-body dynamics whose state is the textbook's: position **x**, orientation **R**, linear momentum **p** and angular
//! momentum **L**.
//!
//! ```text
//! v = p/m        ω = R J0⁻¹ Rᵀ L
//! ẋ = v          Ṙ = [ω]× R
//! ṗ = Σ F_i      L̇ = Σ (r_i − x) × F_i + Σ τ_j
//! ```
//!
//! A [`World`] holds bodies ([`model::Body`], made of [`shape::Shape`]s), laws of force ([`field::Field`]) and pinned points,
//! and advances them by an [`integrate::Integrator`]. All numbers are f64, all units SI, all vectors in world axes unless
//! their documentation says otherwise; the same program gives the same bits on every machine and for any number of threads.
//!
//! ```
//! use polhode::prelude::*;
//!
//! # fn main() -> Result<(), polhode::Error> {
//! let mut world = World::new(); // gravity (0, 0, −9.81)
//! let top = world.add(
//!     Body::dynamic()
//!         .shape(Shape::cuboid([0.1, 0.4, 0.9]).density(1000.0)) // full edge lengths
//!         .position([0.0, 0.0, 2.0])
//!         .angular_velocity([0.1, 5.0, 0.1]), // near the unstable axis: it will flip
//! )?;
//! let l = world.body(top).angular_momentum();
//! for _ in 0..600 {
//!     world.step(1.0 / 60.0);
//! }
//! assert_eq!(world.body(top).angular_momentum(), l); // after ten seconds of flips: the same bits
//! # Ok(())
//! # }
//! ```
//!
//! The modules are listed from the lowest floor up: each uses only those above it in this list.

pub mod error;
pub mod math;
pub mod store;
pub mod par;
pub mod mass;
pub mod shape;
pub mod field;
pub mod collide;
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

/// The README's example, kept true.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
