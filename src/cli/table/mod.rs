//! `fitcheck table`: compares control tables with ISO 286, makes new ones, and exports tables for other tools.

mod made;
mod verify;

use super::{CliError, Io, Outcome};

/// Control tables: compare with ISO 286, make new ones, export
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    #[command(subcommand)]
    command: Command,
}

subcommands! {
    Verify(verify::Args),
    New(made::NewArgs),
    Export(made::ExportArgs),
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        self.command.run(io)
    }
}
