//! `--record`: what a subcommand judges, kept in a journal.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::journal::server;
use super::said::Recorded;
use super::{CliError, Io};
use crate::journal::Record;
use crate::journal::body;
use crate::journal::entry::{About, Check, Checked, Content, CycleCheck, Entry, UsedFile};
use crate::message::Say as _;
use crate::store::local::{self, Journal, Opening};
use crate::store::{StoreError, StoreRemark, here, is_server};

const JOURNAL: &str =
    "The journal: a file, or the server of a shop (postgres://…); default: FITCHECK_JOURNAL, or your own";

/// Where a journal is.
#[derive(Debug, Clone, clap::Args)]
pub(super) struct JournalArgs {
    #[arg(long, help = JOURNAL, value_name = "FILE|ADDRESS")]
    journal: Option<String>,
}

/// What a journal is told of a check besides the check itself.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Record")]
pub(super) struct RecordArgs {
    /// Keep every verdict in the journal
    #[arg(long)]
    record: bool,
    #[arg(long, help = JOURNAL, value_name = "FILE|ADDRESS", requires = "record")]
    journal: Option<String>,
    /// Who measured
    #[arg(long, value_name = "NAME", requires = "record")]
    who: Option<String>,
    /// The part
    #[arg(long, value_name = "NAME", requires = "record")]
    part: Option<String>,
    /// Its serial number
    #[arg(long, value_name = "NO", requires = "record")]
    serial: Option<String>,
    /// The feature of the part
    #[arg(long, value_name = "NAME", requires = "record")]
    feature_name: Option<String>,
    /// Anything else that is worth keeping
    #[arg(long, value_name = "TEXT", requires = "record")]
    remark: Option<String>,
    /// The station; default: the name of the computer
    #[arg(long, value_name = "NAME", requires = "record")]
    station: Option<String>,
}

/// Where a journal is.
pub(super) enum Place {
    /// The file of a station.
    File(PathBuf),
    /// The server of a shop. Its address may hold a password.
    Server(String),
}

impl Place {
    /// The journal that was named, or else the user's own.
    fn of(given: Option<&str>) -> Result<Self, CliError> {
        let of_variable = || std::env::var("FITCHECK_JOURNAL").ok().filter(|text| !text.is_empty());
        match given.map(str::to_owned).or_else(of_variable) {
            Some(text) if is_server(&text) => Ok(Self::Server(text)),
            Some(text) => Ok(Self::File(PathBuf::from(text))),
            None => own().map(Self::File),
        }
    }
}

/// The user's own journal.
fn own() -> Result<PathBuf, CliError> {
    Ok(local::folder().ok_or(CliError::NoJournalFolder)?.join(local::FILE))
}

impl JournalArgs {
    /// The file or the server.
    pub(super) fn place(&self) -> Result<Place, CliError> {
        Place::of(self.journal.as_deref())
    }

    /// The file, for what a server cannot do.
    pub(super) fn file(&self) -> Result<PathBuf, CliError> {
        match self.place()? {
            Place::File(file) => Ok(file),
            Place::Server(_) => Err(CliError::JournalIsServer),
        }
    }
}

/// Collects what is to be recorded.
pub(super) struct Recorder {
    place: Place,
    about: About,
    entries: Vec<Entry>,
}

impl RecordArgs {
    /// What collects records; `None` where nothing is to be recorded. From here on the files that are read are remembered.
    pub(super) fn recorder(&self, io: &mut Io<'_>) -> Result<Option<Recorder>, CliError> {
        if !self.record {
            return Ok(None);
        }
        io.remember();
        let text = |given: &Option<String>| given.clone().unwrap_or_default();
        let about = About {
            station: self.station.clone().unwrap_or_else(here::computer),
            time: here::moment(),
            who: text(&self.who),
            part: text(&self.part),
            serial: text(&self.serial),
            feature: text(&self.feature_name),
            remark: text(&self.remark),
        };
        Ok(Some(Recorder { place: Place::of(self.journal.as_deref())?, about, entries: Vec::new() }))
    }
}

impl Recorder {
    /// A record. What its file or field calls it is the part, where none is named; otherwise the feature.
    pub(super) fn size(&mut self, record: Arc<Record>, files: Vec<UsedFile>) -> Result<(), CliError> {
        let about = self.about(&record.id);
        self.add(about, Checked::Size(record), files)
    }

    /// What a cycle found.
    pub(super) fn cycle(&mut self, cycle: CycleCheck, files: Vec<UsedFile>) -> Result<(), CliError> {
        let about = self.about.clone();
        self.add(about, Checked::Cycle(Box::new(cycle)), files)
    }

    fn about(&self, id: &str) -> About {
        let mut about = self.about.clone();
        if about.part.is_empty() {
            id.clone_into(&mut about.part);
        } else if about.feature.is_empty() {
            id.clone_into(&mut about.feature);
        }
        about
    }

    /// An entry that can be written: one that cannot would keep all others out.
    fn add(&mut self, about: About, what: Checked, files: Vec<UsedFile>) -> Result<(), CliError> {
        let check = Check { what, files, corrects: None };
        let entry = Entry { about, content: Content::Check(Box::new(check)) };
        let _bytes = body::write(&entry).map_err(|error| CliError::NotRecorded { error: error.message() })?;
        self.entries.push(entry);
        Ok(())
    }

    /// Keeps all of them or none, and says so.
    pub(super) fn keep(self, io: &mut Io<'_>) -> Result<(), CliError> {
        let Self { place, about, entries } = self;
        if entries.is_empty() {
            io.remark(&Recorded::Nothing);
            return Ok(());
        }
        match place {
            Place::File(file) => keep(&file, &about, &entries, io),
            // A station writes to its own file first: what is there is safe, whatever becomes of the server.
            Place::Server(address) => {
                let file = own()?;
                keep(&file, &about, &entries, io)?;
                if let Err(error) = server::send(&address, &file, &about.station, io) {
                    io.warn(&Recorded::NotSent { error: error.message() });
                }
                Ok(())
            }
        }
    }
}

/// Adds entries to a journal, all of them or none, and says so.
pub(super) fn keep(file: &Path, about: &About, entries: &[Entry], io: &mut Io<'_>) -> Result<(), CliError> {
    let refused = |error: StoreError| CliError::NotRecorded { error: error.message() };
    let mut journal = Journal::open(file, &Opening::new(&about.station, about.time.clone())).map_err(refused)?;
    let kept = journal.append(entries);
    journal.keep_head();
    for remark in journal.remarks() {
        match remark {
            StoreRemark::Begun { .. } | StoreRemark::Migrated { .. } => io.remark(remark),
            _ => io.warn(remark),
        }
    }
    let kept = kept.map_err(refused)?;
    let (Some(first), Some(last)) = (kept.first(), kept.last()) else { return Ok(()) };
    let (file, hash) = (file.display().to_string(), last.head.hash.to_string());
    io.tell(if first.head == last.head {
        Recorded::Entry { number: last.head.number, file, hash }
    } else {
        Recorded::Entries { first: first.head.number, last: last.head.number, file, hash }
    });
    Ok(())
}
