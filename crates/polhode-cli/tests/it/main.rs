//! The command as a user meets it, and the checks that it runs.

mod bench;
mod checks;
mod command;

/// Runs a command line in this process: exit code, standard output, standard error.
fn polhode(arguments: &[&str]) -> (u8, String, String) {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let line = std::iter::once("polhode").chain(arguments.iter().copied()).map(Into::into);
    let code = polhode_cli::run(line, &mut polhode_cli::Terminal::new(&mut out, &mut err));
    let text = |bytes| String::from_utf8(bytes).expect("text");
    (code, text(out), text(err))
}
