//! `fitcheck journal init-shop` and `fitcheck journal send`: the server of a shop.

use super::{CliError, Io, JournalArgs, Outcome, server};
use crate::store::here;

const PASSWORDS: &str = "\
The password comes from the address, PGPASSWORD, the password file (~/.pgpass, or PGPASSFILE) or the
system's keyring, in this order. A connection to another machine is always encrypted, and its
certificate is checked; sslrootcert=FILE in the address names the authority of the shop.

Examples:
  fitcheck journal init-shop postgres://admin@shop.example/checks
  fitcheck journal send postgres://mill3@shop.example/checks";

/// Create the journal on a shop's server, or upgrade it to this version
///
/// The command can be repeated. Recorded entries are not changed.
#[derive(Debug, clap::Args)]
#[command(after_help = PASSWORDS)]
pub(super) struct InitArgs {
    /// Address of the server, with a user who may create roles and schemas
    #[arg(value_name = "ADDRESS")]
    address: String,
}

/// Send what the server of a shop does not have yet
#[derive(Debug, clap::Args)]
#[command(after_help = PASSWORDS)]
pub(super) struct SendArgs {
    /// Address of the server, with the user of this station
    #[arg(value_name = "ADDRESS")]
    address: String,
    /// Name of the station for entries that do not give one; default: the name of the computer
    #[arg(long, value_name = "NAME")]
    station: Option<String>,
    #[command(flatten)]
    journal: JournalArgs,
}

impl InitArgs {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        server::init(&self.address, io)?;
        Ok(Outcome::Done)
    }
}

impl SendArgs {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let station = self.station.clone().unwrap_or_else(here::computer);
        server::send(&self.address, &self.journal.file()?, &station, io)?;
        Ok(Outcome::Done)
    }
}
