//! One law a file: what a constraint asks for, and how an impulse answers it.

pub mod pin;
