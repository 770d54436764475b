//! Tests by law: one binary for all of them.

mod house;
mod integrators;
