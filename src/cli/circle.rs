//! `fitcheck circle`

use super::{CliError, Io, Outcome};

/// circle
#[derive(Debug, clap::Args)]
pub(super) struct Args {}

impl Args {
    pub(super) fn run(&self, _io: &mut Io<'_>) -> Result<Outcome, CliError> {
        Ok(Outcome::Done)
    }
}
