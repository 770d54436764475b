//! Tests by law: one binary for all of them.

mod integrators;
