//! The polhode command; all of it is in the library of the same name.

fn main() -> std::process::ExitCode {
    polhode_cli::main()
}
