//! `fitcheck journal init-shop` and `fitcheck journal send`: the server of a shop.

use super::{CliError, Io, JournalArgs, Outcome, server};
use crate::store::here;

const PASSWORDS: &str = "\
The password comes from the address, PGPASSWORD, the password file (~/.pgpass, or PGPASSFILE) or the
system's keyring, in this order. To another machine the connection is always encrypted and its
certificate checked; sslrootcert=FILE in the address names the authority of the shop.

Examples:
  fitcheck journal init-shop postgres://admin@shop.example/checks
  fitcheck journal send postgres://mill3@shop.example/checks";

/// Make the tables of a shop's server, or bring them to this version
///
/// It can be repeated. Nothing that is recorded there is changed.
#[derive(Debug, clap::Args)]
#[command(after_help = PASSWORDS)]
pub(super) struct InitArgs {
    /// The server, as a user who may make roles and schemas
    #[arg(value_name = "ADDRESS")]
    address: String,
}

/// Send what the server of a shop does not have yet
#[derive(Debug, clap::Args)]
#[command(after_help = PASSWORDS)]
pub(super) struct SendArgs {
    /// The server, as the user of this station
    #[arg(value_name = "ADDRESS")]
    address: String,
    /// What the station is called there, where an entry does not say it; default: the name of the computer
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
