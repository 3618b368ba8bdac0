//! `fitcheck journal`: asks, checks, corrects and copies a journal.
//!
//! | file | what |
//! |---|---|
//! | here | the subcommands, and what they share: the question, the file |
//! | `row` | the columns of a list |
//! | `list`, `show`, `export` | checks as a list, one of them with its reasons, all of them for other programs |
//! | `text` | an entry with its reasons, for people |
//! | `entry_name` | an entry by its number or its hash |
//! | `verify`, `written` | whether a journal is whole, and whether a file is a report that it knows |
//! | `correct` | a check in place of another one, or taken back |
//! | `backup` | a copy |
//! | `shop` | the server of a shop: its tables, and what is sent there |
//! | `server`, `no_server` | a server that is asked, and a program that was built without |

mod backup;
mod correct;
mod entry_name;
mod export;
mod inspected;
mod list;
mod row;
#[cfg(feature = "shop")]
pub(super) mod server;
#[cfg(not(feature = "shop"))]
#[path = "no_server.rs"]
pub(super) mod server;
mod shop;
mod show;
mod text;
mod verify;
mod written;

use jiff::Timestamp;

use super::journal_place::JournalArgs;
use super::{CliError, CliRemark, Format, IntoCliError, Io, Outcome, put};
use crate::files;
use crate::journal::ask::{LocalNow, Question};

/// Work with the journal: list, show, export, verify, correct, back up, send
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    #[command(subcommand)]
    command: Command,
}

subcommands! {
    List(list::Args),
    Show(show::Args),
    Export(export::Args),
    Verify(verify::Args),
    Correct(correct::Args),
    Backup(backup::Args),
    InitShop(shop::InitArgs),
    Send(shop::SendArgs),
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        self.command.run(io)
    }
}

/// What a question may say.
const QUESTIONS: &str = "\
A question narrows the list word by word:
  part:Flange feature:B1 who:Anna station:Mill3    exactly these names
  serial:17 serial:17*                             this serial number; all that begin with 17
  \"callout:25 H7\" class:H7                         this callout; this class
  verdict:scrap,rework                             any of good, rework, re-measure, scrap
  from:2026-11-01 to:2026-11-23 today week         recorded on these days, the last one included
  simulated measured                               only simulated ones, only measured ones
  standing                                         neither corrected nor withdrawn
  reports checks alarms                            only reports that were written; only checks and
                                                   withdrawals; only alarms of control charts and
                                                   answers, with standing those without an answer
  good rework re-measure scrap                     standing, with any of these verdicts
  burr 25H7                                        begins a word of a name, callout, remark, reason,
                                                   or of the file or title of a report
  25.012                                           begins the measured value in mm
  88                                               the same, and the record of this number";

/// Which checks are asked for.
#[derive(Debug, Clone, clap::Args)]
struct QuestionArgs {
    /// Which checks: part:Flange serial:17* verdict:scrap today word …; default: all
    #[arg(value_name = "QUESTION")]
    question: Vec<String>,
}

impl QuestionArgs {
    fn read(&self, io: &mut Io<'_>) -> Result<Question, CliError> {
        let words: Vec<String> = self.question.iter().map(|word| as_given(word)).collect();
        let text = words.join(" ");
        let question = Question::read(&text, &here()).about(&text)?;
        if question.from_ms.or(question.before_ms).is_some() {
            warn_of_zone(io);
        }
        Ok(question)
    }
}

/// Now, in the time zone of this computer.
fn here() -> LocalNow {
    LocalNow { now: Timestamp::now(), zone: files::zone_or_unknown() }
}

/// Tells that nobody knows the time zone of this computer, where days or the time of an entry depend on it.
pub(super) fn warn_of_zone(io: &mut Io<'_>) {
    if let Err(error) = files::zone() {
        io.warn(&error);
    }
}

/// An argument as a word of a question: the shell has taken its quotation marks away.
fn as_given(word: &str) -> String {
    match word.split_once(':') {
        Some((key, value)) if value.contains(char::is_whitespace) && !value.contains([':', '"']) => {
            format!("{key}:\"{value}\"")
        }
        _ => word.to_owned(),
    }
}
