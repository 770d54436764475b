//! `polhode bench`: speed on this machine.
//!
//! A figure of speed is worth something beside another one of the same run on a quiet machine, and little else.

mod broad;
mod free;

use crate::{Outcome, Refusal, Terminal};

/// What to measure.
#[derive(Debug, clap::Args)]
pub struct Arguments {
    #[command(subcommand)]
    scene: Scene,
}

/// The scenes.
#[derive(Debug, clap::Subcommand)]
enum Scene {
    /// Tumbling cuboids that nothing touches, at 60 Hz, without and with gravity
    Free(free::Arguments),
    /// The structures that find overlapping boxes, by scene and number of boxes
    Broad(broad::Arguments),
}

impl Arguments {
    /// Measures what was asked for.
    pub(crate) fn execute(&self, terminal: &mut Terminal) -> Result<Outcome, Refusal> {
        match &self.scene {
            Scene::Free(arguments) => arguments.execute(terminal),
            Scene::Broad(arguments) => arguments.execute(terminal),
        }
    }
}
