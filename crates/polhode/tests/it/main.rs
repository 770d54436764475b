//! Tests by law: one binary for all of them.

mod house;
mod integrators;
mod world;

/// Lets a test forbid allocation; elsewhere it is the system's allocator.
#[global_allocator]
static ALLOCATOR: assert_no_alloc::AllocDisabler = assert_no_alloc::AllocDisabler;
