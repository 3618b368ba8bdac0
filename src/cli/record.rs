//! `--record`: what a subcommand judges, kept in a journal.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::io::tell_at_once;
use super::journal::{server, warn_of_zone};
use super::journal_place::{JOURNAL, JournalArgs, JournalPlace, own};
use super::said::Recorded;
use super::{CliError, Io};
use crate::exchange::{Labels, part_and_feature};
use crate::journal::chain::Hash;
use crate::journal::entry::{About, Check, Checked, Content, CycleCheck, Entry, Kept, Reported, UsedFile};
use crate::journal::{Record, body};
use crate::message::{Message, Say as _};
use crate::store::local::{Journal, Opening, Reader};
use crate::store::{StoreError, StoreRemark, here};

/// What a journal is told of a check besides the check itself.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Record")]
pub(super) struct RecordArgs {
    /// Record every verdict in the journal
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
    /// Remark to record
    #[arg(long, value_name = "TEXT", requires = "record")]
    remark: Option<String>,
    /// The station; default: the name of the computer
    #[arg(long, value_name = "NAME", requires = "record")]
    station: Option<String>,
}

/// The same for what records always, as long as it runs.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Record")]
pub(super) struct StreamArgs {
    /// Every verdict is kept in the journal, with or without this
    #[arg(long, hide = true)]
    record: bool,
    #[command(flatten)]
    journal: JournalArgs,
    /// Who measures, if the files do not say it
    #[arg(long, value_name = "NAME")]
    who: Option<String>,
    /// The part, instead of the plan's, if the files do not say it
    #[arg(long, value_name = "NAME")]
    part: Option<String>,
    /// Its serial number, if the files do not say it
    #[arg(long, value_name = "NO")]
    serial: Option<String>,
    /// Remark to record
    #[arg(long, value_name = "TEXT")]
    remark: Option<String>,
    /// The station; default: the name of the computer
    #[arg(long, value_name = "NAME")]
    station: Option<String>,
}

/// Records as long as it runs.
pub(super) struct Stream {
    recorder: Recorder,
    file: PathBuf,
    journal: Journal,
    /// Whether entries were added that the server does not have yet.
    is_new: bool,
}

/// Collects what is to be recorded.
pub(super) struct Recorder {
    place: JournalPlace,
    about: About,
    /// The part of a plan that names the features, empty where it names no part: what a value is called is never the part then.
    plan: Option<String>,
    /// Whether what a file says counts before what the options say: they stand for all files that come.
    is_file_first: bool,
    entries: Vec<Entry>,
}

impl RecordArgs {
    /// What collects records; `None` where nothing is to be recorded. From here on the files that are read are remembered.
    pub(super) fn recorder(&self, io: &mut Io<'_>) -> Result<Option<Recorder>, CliError> {
        if !self.record {
            return Ok(None);
        }
        io.remember();
        let station = self.station.as_ref();
        let part = self.part.as_ref();
        let serial = self.serial.as_ref();
        let about = about(station, [self.who.as_ref(), part, serial, self.feature_name.as_ref(), self.remark.as_ref()]);
        Recorder::at(self.journal.as_deref(), about).map(Some)
    }
}

/// What is told of every check, at this moment: who, part, serial number, feature and remark.
pub(super) fn about(station: Option<&String>, given: [Option<&String>; 5]) -> About {
    let [who, part, serial, feature, remark] = given.map(|text| text.map_or_else(String::new, Clone::clone));
    About {
        station: station.cloned().unwrap_or_else(here::computer),
        time: here::moment(),
        who,
        part,
        serial,
        feature,
        remark,
    }
}

impl Recorder {
    /// One that records in a journal that was named, or in the user's own.
    pub(super) fn at(journal: Option<&str>, about: About) -> Result<Self, CliError> {
        let place = JournalPlace::of(journal)?;
        Ok(Self { place, about, plan: None, is_file_first: false, entries: Vec::new() })
    }

    /// The same for the features of a plan, and the part that it is of.
    pub(super) fn of_plan(self, part: &str) -> Self {
        Self { plan: Some(part.to_owned()), ..self }
    }

    /// A record. What its file or field calls it is the part, where none is named; otherwise the feature.
    pub(super) fn size(&mut self, record: Arc<Record>, files: Vec<UsedFile>) -> Result<(), CliError> {
        self.size_of(record, &Labels::default(), files)
    }

    /// The same with what its file says of part, serial number and operator: where no option says it, or before the options.
    pub(super) fn size_of(
        &mut self,
        record: Arc<Record>,
        labels: &Labels,
        files: Vec<UsedFile>,
    ) -> Result<(), CliError> {
        let about = self.about(&record.id, labels);
        self.add(about, Checked::Size(record), files)
    }

    /// What a cycle found.
    pub(super) fn cycle(&mut self, cycle: CycleCheck, files: Vec<UsedFile>) -> Result<(), CliError> {
        let about = self.about.clone();
        self.add(about, Checked::Cycle(Box::new(cycle)), files)
    }

    fn about(&self, id: &str, labels: &Labels) -> About {
        let mut about = self.about.clone();
        for (text, given) in [(&mut about.serial, &labels.serial), (&mut about.who, &labels.who)] {
            if text.is_empty() || self.is_file_first && !given.is_empty() {
                text.clone_from(given);
            }
        }
        self.part(&labels.part, !about.serial.is_empty()).clone_into(&mut about.part);
        if self.plan.is_some() {
            id.clone_into(&mut about.feature);
        } else {
            part_and_feature(&mut about.part, &mut about.feature, id);
        }
        about
    }

    /// The part of a check. The plan's own name tells parts apart by their serial numbers alone: without one, the name in the file does.
    fn part<'a>(&'a self, of_file: &'a str, has_serial: bool) -> &'a str {
        let option = self.about.part.as_str();
        let plan = self.plan.as_deref();
        if !option.is_empty() && !self.is_file_first {
            return option;
        }
        let of_all = if option.is_empty() { plan.unwrap_or("") } else { option };
        let is_same = of_file.trim().is_empty() || of_file.trim().eq_ignore_ascii_case(of_all);
        match plan {
            _ if of_all.is_empty() => of_file,
            _ if is_same => of_all,
            Some(_) if has_serial => of_all,
            _ => of_file,
        }
    }

    /// An entry that can be written: one that cannot would keep all others out.
    fn add(&mut self, about: About, what: Checked, files: Vec<UsedFile>) -> Result<(), CliError> {
        let check = Check { what, files, corrects: None };
        let entry = Entry { about, content: Content::Check(Box::new(check)) };
        let _bytes = body::write(&entry).map_err(|error| CliError::NotRecorded { error: error.message() })?;
        self.entries.push(entry);
        Ok(())
    }

    /// How many were kept so far.
    pub(super) const fn count(&self) -> usize {
        self.entries.len()
    }

    /// Gives the hash of the last file of all checks from one on, as it is known once the file is read.
    pub(super) fn hash_last_file(&mut self, first: usize, sha256: Hash) {
        for entry in self.entries.iter_mut().skip(first) {
            if let Content::Check(check) = &mut entry.content
                && let Some(file) = check.files.last_mut()
            {
                file.sha256 = sha256;
            }
        }
    }

    /// Keeps that a report was written, with the last entry that the journal has now, and says so.
    ///
    /// # Errors
    /// Why the journal does not know it.
    pub(super) fn keep_report(self, mut report: Reported, io: &mut Io<'_>) -> Result<(), Message> {
        let Self { place, mut about, .. } = self;
        about.time = here::moment();
        let file = match &place {
            JournalPlace::File(file) => file.clone(),
            JournalPlace::Server(_) => own().map_err(|error| error.message())?,
        };
        warn_of_zone(io);
        let mut journal = Journal::open(&file, &opening(&about)).map_err(|error| error.message())?;
        report.shown.head = Some(journal.head().map_err(|error| error.message())?);
        let station = about.station.clone();
        let kept = journal.append(&[Entry { about, content: Content::Report(report) }]);
        journal.keep_head();
        tell_remarks(&journal, io);
        tell_kept(&file, &kept.map_err(|error| error.message())?, io);
        if let JournalPlace::Server(address) = place
            && let Err(error) = server::send(&address, &file, &station, io)
        {
            io.warn(&Recorded::NotSent { error: error.message() });
        }
        Ok(())
    }

    /// Keeps all of them or none, and says so.
    pub(super) fn keep(self, io: &mut Io<'_>) -> Result<(), CliError> {
        let Self { place, about, entries, .. } = self;
        if entries.is_empty() {
            io.remark(&Recorded::Nothing);
            return Ok(());
        }
        match place {
            JournalPlace::File(file) => keep(&file, &about, &entries, io),
            // A station writes to its own file first: what is there is safe, whatever becomes of the server.
            JournalPlace::Server(address) => {
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
    warn_of_zone(io);
    let mut journal = Journal::open(file, &opening(about)).map_err(refused)?;
    let kept = journal.append(entries);
    journal.keep_head();
    tell_remarks(&journal, io);
    tell_kept(file, &kept.map_err(refused)?, io);
    Ok(())
}

fn opening(about: &About) -> Opening {
    Opening { waits: tell_at_once, ..Opening::new(&about.station, about.time.clone()) }
}

#[expect(clippy::needless_pass_by_value, reason = "map_err hands over the error")]
fn refused(error: StoreError) -> CliError {
    CliError::NotRecorded { error: error.message() }
}

fn tell_remarks(journal: &Journal, io: &mut Io<'_>) {
    for remark in journal.remarks() {
        match remark {
            StoreRemark::Begun { .. } | StoreRemark::Migrated { .. } => io.remark(remark),
            _ => io.warn(remark),
        }
    }
}

fn tell_kept(file: &Path, kept: &[Kept], io: &mut Io<'_>) {
    let (Some(first), Some(last)) = (kept.first(), kept.last()) else { return };
    let file = file.display().to_string();
    let hash = last.head.hash.to_string();
    io.note(if first.head == last.head {
        Recorded::Entry { number: last.head.number, file, hash }
    } else {
        Recorded::Entries { first: first.head.number, last: last.head.number, file, hash }
    });
}

impl StreamArgs {
    /// Opens the journal; `plan` is the part of a plan that names the features.
    pub(super) fn stream(&self, plan: Option<&str>, io: &mut Io<'_>) -> Result<Stream, CliError> {
        warn_of_zone(io);
        let part = self.part.as_ref();
        let serial = self.serial.as_ref();
        let about = about(self.station.as_ref(), [self.who.as_ref(), part, serial, None, self.remark.as_ref()]);
        let opening = opening(&about);
        let place = self.journal.place()?;
        let recorder = Recorder { place, about, plan: None, is_file_first: true, entries: Vec::new() };
        let recorder = match plan {
            Some(part) => recorder.of_plan(part),
            None => recorder,
        };
        let file = match &recorder.place {
            JournalPlace::File(file) => file.clone(),
            JournalPlace::Server(_) => own()?,
        };
        let journal = Journal::open(&file, &opening).map_err(refused)?;
        tell_remarks(&journal, io);
        Ok(Stream { recorder, file, journal, is_new: false })
    }
}

impl Stream {
    /// The journal's file at this station.
    pub(super) fn file(&self) -> &Path {
        &self.file
    }

    /// All entries so far: their numbers and bodies.
    pub(super) fn each(&self, see: &mut dyn FnMut(u64, &[u8])) -> Result<(), CliError> {
        let reader = Reader::open(&self.file).map_err(refused)?;
        let mut from = 1;
        loop {
            let entries = reader.entries(from, 1_000).map_err(refused)?;
            let Some(last) = entries.last() else { return Ok(()) };
            from = last.head.number + 1;
            for kept in &entries {
                see(kept.head.number, &kept.body);
            }
        }
    }

    /// What tells a part from others in the journal: its name and its serial number. The name of the plan is that of all its parts; of a part
    /// without any other name, its file is the name.
    pub(super) fn part_of(&self, about: &About, file: &str) -> (String, String) {
        let of_all = [self.recorder.about.part.as_str(), self.recorder.plan.as_deref().unwrap_or("")];
        let own = Some(about.part.as_str()).filter(|part| !of_all.contains(part)).unwrap_or("");
        let part = if own.is_empty() && about.serial.is_empty() { file } else { own };
        (part.to_owned(), about.serial.clone())
    }

    /// Who, where and when: what is recorded of a check that a file tells these of.
    pub(super) fn about(&self, id: &str, labels: &Labels) -> About {
        self.recorder.about(id, labels)
    }

    /// A check that is to be recorded, now.
    pub(super) fn size_of(&mut self, record: Arc<Record>, labels: &Labels, file: UsedFile) -> Result<(), CliError> {
        self.recorder.about.time = here::moment();
        self.recorder.size_of(record, labels, vec![file])
    }

    /// Records what was collected, all of it or none.
    pub(super) fn keep(&mut self, io: &mut Io<'_>) -> Result<(), CliError> {
        let entries = std::mem::take(&mut self.recorder.entries);
        if entries.is_empty() {
            return Ok(());
        }
        let kept = self.journal.append(&entries).map_err(refused)?;
        self.is_new = true;
        tell_kept(&self.file, &kept, io);
        Ok(())
    }

    /// In a quiet moment: the server gets what it does not have, and the journal is put in order.
    pub(super) fn rest(&mut self, io: &mut Io<'_>) {
        if !std::mem::take(&mut self.is_new) {
            return;
        }
        self.journal.keep_head();
        if let Err(error) = self.journal.tidy() {
            io.warn(&error);
        }
        if let JournalPlace::Server(address) = &self.recorder.place
            && let Err(error) = server::send(address, &self.file, &self.recorder.about.station, io)
        {
            io.warn(&Recorded::NotSent { error: error.message() });
        }
    }
}
