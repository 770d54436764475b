//! What the scene crate promises to its users.

mod lecture;
mod mesh;
mod recording;
mod run;
mod scene;
