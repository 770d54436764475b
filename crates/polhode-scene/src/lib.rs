//! Scenes for the polhode engine: TOML files, mesh files, recordings.
//!
//! A [`SceneFile`] is a scene read from TOML, plain data with every problem of the file found and placed. A [`mesh`] is read
//! from OBJ, STL, PLY or glTF. A [`recording`] is what a run leaves behind.

mod decode;
mod error;
pub mod mesh;
pub mod recording;
pub mod run;
pub mod scene;

pub use error::{Problem, SceneError};
pub use recording::Recording;
pub use run::{Run, Summary};
pub use scene::{Scene, SceneFile, schema};
