//! `fitcheck journal backup`: a copy of a journal at one moment.

use std::path::PathBuf;

use super::{CliError, CliRemark, IntoCliError as _, Io, JournalArgs, Outcome};
use crate::cli::io::not_dash;
use crate::journal::chain::Head;
use crate::store::local;

/// Copy a journal to a new file, also while it is in use
///
/// A copy of the file alone would lack what is still in the files beside it. The copy is read back and verified. Keep the
/// printed number and hash in another place: fitcheck journal verify --head compares with them.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The file to write
    #[arg(value_name = "FILE")]
    to: PathBuf,
    #[command(flatten)]
    journal: JournalArgs,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        not_dash(&self.to)?;
        let Head { number, hash } = local::backup(&self.journal.file()?, &self.to).said()?;
        io.note(CliRemark::BackedUp { path: self.to.clone(), number, hash: hash.to_string() });
        Ok(Outcome::Done)
    }
}
