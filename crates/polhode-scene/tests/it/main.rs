//! What the scene crate promises to its users.

mod mesh;
mod recording;
mod run;
mod scene;
