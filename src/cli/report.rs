//! `fitcheck report`

use super::{CliError, Io, Outcome};

/// report
#[derive(Debug, clap::Args)]
pub(super) struct Args {}

impl Args {
    pub(super) fn run(&self, _io: &mut Io<'_>) -> Result<Outcome, CliError> {
        Ok(Outcome::Done)
    }
}
