//! Reads arguments, opens the window or runs a subcommand, and maps errors to exit codes.

use std::process::ExitCode;

use clap::Parser as _;
use fitcheck::cli::Cli;

fn main() -> ExitCode {
    let cli = Cli::parse();
    cli.run_here()
}
