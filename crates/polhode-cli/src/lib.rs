//! The `polhode` command.
//!
//! A subcommand is a module with its arguments and an `execute`; the enum `Command` lists them. Results go to standard output,
//! progress and complaints to standard error. The exit code is 0 when all went well, 1 when a check failed and 2 for
//! arguments or input that cannot be used.

pub mod bench;
pub mod check;
pub mod lab;
pub mod run;
mod progress;
mod random;
mod terminal;

pub use progress::Progress;
pub use terminal::Terminal;

use clap::{Parser, Subcommand};
use std::ffi::OsString;
use std::process::ExitCode;

/// What the command line says.
#[derive(Debug, Parser)]
#[command(name = "polhode", version, about = "Rigid-body dynamics whose state is the textbook's.")]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
enum Command {
    /// Simulate a scene and write a summary, a page, a table or a recording
    Run(run::Arguments),
    /// Verify the physics: every law and reference trajectory, with error and tolerance
    Check(check::Arguments),
    /// See the lecture: an index of scenes, each as a page to play with
    Lab(lab::Arguments),
    /// Measure speed on this machine
    Bench(bench::Arguments),
}

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// All went well: exit code 0.
    Done,
    /// The command ran, and what it tested did not pass: exit code 1.
    Failed,
}

/// Why a command could not do its work: exit code 2.
#[derive(Debug)]
pub enum Refusal {
    /// The arguments or the input cannot be used; the text says why, and what could be used instead.
    Input(String),
    /// A scene cannot be used; the text is a whole message of its own, with the places in the file.
    Scene(String),
    /// The results could not be written.
    Output(std::io::Error),
}

impl From<polhode::Error> for Refusal {
    fn from(error: polhode::Error) -> Self {
        Self::Input(error.to_string())
    }
}

impl From<std::io::Error> for Refusal {
    fn from(error: std::io::Error) -> Self {
        Self::Output(error)
    }
}

/// Runs the command of this process.
pub fn main() -> ExitCode {
    let (mut out, mut err) = (anstream::stdout(), anstream::stderr());
    let code = run(std::env::args_os(), &mut Terminal::new(&mut out, &mut err));
    ExitCode::from(code)
}

/// Runs a command line, the name of the program first, and returns the exit code.
pub fn run(arguments: impl IntoIterator<Item = OsString>, terminal: &mut Terminal) -> u8 {
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(refused) => {
            // Asking for help is no error, and is answered on standard output.
            let text = refused.render();
            let to = if refused.use_stderr() { &mut terminal.err } else { &mut terminal.out };
            return match write!(to, "{}", text.ansi()) {
                Ok(()) if refused.exit_code() == 0 => 0,
                _ => 2,
            };
        }
    };
    let result = match &cli.command {
        Command::Run(arguments) => arguments.execute(terminal),
        Command::Check(arguments) => arguments.execute(terminal),
        Command::Lab(arguments) => arguments.execute(terminal),
        Command::Bench(arguments) => arguments.execute(terminal),
    };
    match result {
        Ok(Outcome::Done) => 0,
        Ok(Outcome::Failed) => 1,
        Err(Refusal::Input(why)) => {
            terminal.complain(&why);
            2
        }
        Err(Refusal::Scene(message)) => {
            // Where even this cannot be written, nobody is there to be told.
            let _ = writeln!(terminal.err, "{message}");
            2
        }
        Err(Refusal::Output(error)) => {
            // A reader that has read enough, such as `head`, needs no message.
            if error.kind() != std::io::ErrorKind::BrokenPipe {
                terminal.complain(&format!("the output could not be written: {error}"));
            }
            2
        }
    }
}
