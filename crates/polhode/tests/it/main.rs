//! Tests that belong to no single module: laws across the engine, and the house it lives in.

mod house;
