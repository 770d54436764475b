//! Schemes that advance bodies in time, one a file.
//!
//! Free rotations, with the angular momentum `l` held in world axes: [`exponential`], [`implicit_midpoint`], [`dmv`],
//! [`splitting`], [`symmetric_top`] and [`exact`]. Schemes that ask for forces at their stages: [`explicit_euler`],
//! [`explicit_matrix`], [`buss`], [`lie_midpoint`], [`rk4`], [`rkmk4`], [`crouch_grossman`], [`commutator_free`] and the
//! adaptive [`dormand_prince`] through [`phase_solver`]. [`composition`] raises the order of any symmetric one.

pub mod phase;

pub mod cayley;
pub mod dmv;
pub mod exact;
pub mod exponential;
pub mod implicit_midpoint;
pub mod splitting;
pub mod symmetric_top;

pub mod buss;
pub mod commutator_free;
pub mod crouch_grossman;
pub mod dormand_prince;
pub mod explicit_euler;
pub mod explicit_matrix;
pub mod lie_midpoint;
pub mod phase_solver;
pub mod rk4;
pub mod rkmk4;

pub mod composition;
