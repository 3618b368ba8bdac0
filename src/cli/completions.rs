//! `fitcheck completions`: what a shell needs to complete a command line.

use clap::CommandFactory as _;
use clap_complete::Shell;

use super::{Cli, CliError, Io, Outcome, put};

const EXAMPLES: &str = "\
Examples:
  fitcheck completions bash > ~/.local/share/bash-completion/completions/fitcheck
  fitcheck completions zsh > ~/.zfunc/_fitcheck         in a folder of fpath
  fitcheck completions fish > ~/.config/fish/completions/fitcheck.fish
  fitcheck completions powershell >> $PROFILE";

/// Write the script that lets a shell complete subcommands, options and their values
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// The shell
    shell: Shell,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        // Into memory first: the writer of scripts panics where a stream is closed.
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut Cli::command(), "fitcheck", &mut script);
        put(None, &mut |out| out.write_all(&script), io)?;
        Ok(Outcome::Done)
    }
}
