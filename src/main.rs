//! Reads arguments, opens the window or runs a subcommand, and maps errors to exit codes.

use std::process::ExitCode;

use clap::Parser as _;
use fitcheck::cli::Cli;

fn main() -> ExitCode {
    let cli = Cli::parse();
    if cli.has_subcommand() {
        return cli.run_here();
    }
    open_window()
}

#[cfg(feature = "gui")]
fn open_window() -> ExitCode {
    env_logger::init();
    match fitcheck::gui::run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => tell(&error.to_string()),
    }
}

#[cfg(not(feature = "gui"))]
fn open_window() -> ExitCode {
    tell("this program was built without the window: name a subcommand, see fitcheck --help")
}

/// Prints on standard error why the program ends; if it is closed, nobody is left to tell.
fn tell(message: &str) -> ExitCode {
    use std::io::Write as _;
    let _unheard = writeln!(std::io::stderr().lock(), "fitcheck: {message}");
    ExitCode::FAILURE
}
