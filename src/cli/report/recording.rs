//! `--record`: the journal is told which file was written. Its checks were judged from files and options and are in no journal, which the
//! entry says, too.

use super::super::CliError;
use super::super::journal_place::JOURNAL;
use super::super::record::{Recorder, about};

/// What a journal is told of a report besides the file itself.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Record")]
pub(super) struct ReportRecordArgs {
    /// Record in the journal which file was written, but not its checks: fitcheck import --record does that
    #[arg(long)]
    record: bool,
    #[arg(long, help = JOURNAL, value_name = "FILE|ADDRESS", requires = "record")]
    journal: Option<String>,
    /// Who writes the report
    #[arg(long, value_name = "NAME", requires = "record")]
    who: Option<String>,
    /// Remark to record with the report
    #[arg(long, value_name = "TEXT", requires = "record")]
    remark: Option<String>,
    /// The station that writes the report; default: the name of the computer
    #[arg(long, value_name = "NAME", requires = "record")]
    station: Option<String>,
}

impl ReportRecordArgs {
    /// What records the report; `None` where it is not to be recorded. Standard output is no file that anybody finds again.
    pub(super) fn recorder(&self, is_file: bool) -> Result<Option<Recorder>, CliError> {
        if !self.record {
            return Ok(None);
        }
        if !is_file {
            return Err(CliError::RecordNeedsFile);
        }
        let about = about(self.station.as_ref(), [self.who.as_ref(), None, None, None, self.remark.as_ref()]);
        Recorder::at(self.journal.as_deref(), about).map(Some)
    }
}
