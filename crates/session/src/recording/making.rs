//! From a check to the entry that is kept.

use std::sync::Arc;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_exchange::exchange::{Labels, part_and_feature};
use fitcheck_exchange::journal::chain::Hash;
use fitcheck_exchange::journal::entry::{
    About, Check, Checked, Content, Correction, CycleCheck, Entry, FileRole, Moment, UsedFile,
};
use fitcheck_exchange::journal::query::RecordId;
use fitcheck_exchange::journal::{Record, body};

use super::{Known, Recording};

/// What a user names beside a check.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Named {
    pub part: String,
    pub serial: String,
    /// The feature of a part that has several.
    pub feature: String,
    /// Who measured, where a file says so; otherwise whoever measures now.
    pub who: String,
    /// Anything else.
    pub remark: String,
}

impl Named {
    /// What an entry is named.
    pub(crate) fn of_entry(about: &About) -> Self {
        let About { part, serial, feature, who, remark, .. } = about.clone();
        Self { part, serial, feature, who, remark }
    }

    /// The same for a value that is called `id`, with what its file says of it: as the command line records it.
    fn of_file(self, labels: Option<&Labels>, id: &str) -> Self {
        let given = |text: &String, usual: String| if text.is_empty() { usual } else { text.clone() };
        let mut named = match labels {
            Some(labels) => Self {
                part: labels.part.clone(),
                serial: given(&labels.serial, self.serial),
                who: given(&labels.who, self.who),
                ..self
            },
            None => Self { part: String::new(), ..self },
        };
        part_and_feature(&mut named.part, &mut named.feature, id);
        named
    }
}

/// A check that is sent to the journal.
#[derive(Debug)]
pub(crate) struct ToKeep {
    /// The check.
    pub record: Arc<Record>,
    /// What is named beside it.
    pub named: Named,
    /// The files that it was made with.
    pub files: Vec<UsedFile>,
}

/// What became of checks that were sent to the journal.
#[derive(Debug, Default)]
pub(crate) struct Sent {
    /// The number of their batch; `None` where nothing of them is recorded.
    pub run: Option<u64>,
    /// How many can be no entries of a journal, and why the first cannot.
    pub refused: Option<(usize, Message)>,
}

/// A file that checks were made with, where its bytes were seen.
pub(crate) fn used(role: FileRole, name: &str, sha256: Option<Hash>) -> Option<UsedFile> {
    Some(UsedFile { role, name: name.into(), sha256: sha256? })
}

impl Recording {
    /// Sends checks of the history, from this number on; each is named by its own part, and as its file names it. `files` says what each was made with.
    /// Returns how many can be no entries of a journal, and why the first cannot: the others do not wait for them.
    pub(crate) fn keep_checks(
        &mut self,
        first: RecordId,
        records: &[Arc<Record>],
        labels: &[Labels],
        named: &Named,
        files: impl Fn(&Record) -> Vec<UsedFile>,
    ) -> Option<(usize, Message)> {
        let labels = labels.iter().map(Some).chain(std::iter::repeat(None));
        let to_keep = |(record, labels): (&Arc<Record>, Option<&Labels>)| {
            let named = named.clone().of_file(labels, &record.id);
            ToKeep { record: Arc::clone(record), named, files: files(record) }
        };
        self.keep_named(first, records.iter().zip(labels).map(to_keep).collect()).refused
    }

    /// The same of checks that are each named by themselves.
    pub(crate) fn keep_named(&mut self, first: RecordId, checks: Vec<ToKeep>) -> Sent {
        if !self.is_on() {
            return Sent::default();
        }
        let mut entries = Vec::new();
        let mut known = Vec::new();
        let mut refused = Vec::new();
        for (id, ToKeep { record, named, files }) in (first.0..).map(RecordId).zip(checks) {
            let check = Check { what: Checked::Size(record), files: files.clone(), corrects: None };
            let entry = self.entry(&named, Content::Check(Box::new(check)));
            match body::write(&entry) {
                Ok(_) => {
                    // Somebody else may measure when it is withdrawn.
                    known.push((id, Named { who: entry.about.who.clone(), ..named }, files));
                    entries.push(entry);
                }
                Err(error) => refused.push((id, named, error.message())),
            }
        }
        let run = self.send(entries);
        if let Some(run) = run {
            let of_run = (0..).map(|at| (run, at)).zip(known);
            self.checks.extend(of_run.map(|(slip, (id, named, files))| (id, Known { slip, named, files })));
        }
        let told = refused.first().map(|(_, _, why)| (refused.len(), why.clone()));
        let sent = Sent { run, refused: told };
        for (id, named, why) in refused {
            let slip = (self.refuse(why), 0);
            self.checks.insert(id, Known { slip, named, files: Vec::new() });
        }
        sent
    }

    /// Sends corrections of checks of the history that were judged again. `false`, and nothing is sent, where one of them is not on disk yet
    /// or was read from the journal.
    pub(crate) fn judge_again(&mut self, again: &[(RecordId, Arc<Record>)], reason: &str) -> bool {
        if !self.is_on() {
            return true;
        }
        let mut ids = Vec::new();
        let mut entries = Vec::new();
        for (id, record) in again {
            let Some(Known { slip, named, files }) = self.checks.get(id) else {
                // An example is not recorded.
                if self.numbers.contains_key(id) {
                    return false;
                }
                continue;
            };
            let Some(target) = self.head_of_slip(*slip) else { return false };
            let corrects = Some(self.by_whom(correcting(target, reason)));
            let check = Check { what: Checked::Size(Arc::clone(record)), files: files.clone(), corrects };
            entries.push(self.entry(named, Content::Check(Box::new(check))));
            ids.push(*id);
        }
        if let Some(run) = self.send(entries) {
            for (at, id) in (0..).zip(ids) {
                if let Some(known) = self.checks.get_mut(&id) {
                    known.slip = (run, at);
                }
            }
        }
        true
    }

    /// Sends what cycles say, named as the next check is; returns the number of the batch.
    pub(crate) fn keep_cycles(&mut self, cycles: Vec<CycleCheck>, files: &[UsedFile]) -> Option<u64> {
        let named = self.named.clone();
        let entry = |cycle| {
            let check = Check { what: Checked::Cycle(Box::new(cycle)), files: files.to_vec(), corrects: None };
            self.entry(&named, Content::Check(Box::new(check)))
        };
        let entries = cycles.into_iter().map(entry).collect();
        self.send(entries)
    }

    /// Sends a correction; returns the number of the batch.
    ///
    /// # Errors
    /// Why it can be no entry of a journal, or that nothing is recorded.
    pub(crate) fn keep_correction(&mut self, about: About, content: Content) -> Result<u64, Message> {
        let about = About { station: self.station.clone(), time: unstamped(), ..about };
        let content = match content {
            Content::Withdrawal(correction) => Content::Withdrawal(self.by_whom(correction)),
            Content::Check(mut check) => {
                check.corrects = check.corrects.map(|correction| self.by_whom(correction));
                Content::Check(check)
            }
            // Nobody corrects by one of these.
            other @ (Content::Begin(_) | Content::Report(_) | Content::Alarm(_)) => other,
        };
        let entry = Entry { about, content };
        body::write(&entry).map_err(|error| error.message())?;
        self.send(vec![entry]).ok_or_else(|| message!("records-page-not-recording"))
    }

    /// Whoever measures now corrects.
    fn by_whom(&self, correction: Correction) -> Correction {
        Correction { by: self.who().to_owned(), ..correction }
    }

    pub(super) fn entry(&self, named: &Named, content: Content) -> Entry {
        let about = About {
            station: self.station.clone(),
            time: unstamped(),
            who: if named.who.is_empty() { self.who() } else { &named.who }.to_owned(),
            part: named.part.clone(),
            serial: named.serial.clone(),
            feature: named.feature.clone(),
            remark: named.remark.clone(),
        };
        Entry { about, content }
    }
}

/// The clock is outside: whoever keeps an entry puts in its time.
const fn unstamped() -> Moment {
    Moment { utc_ms: 0, offset_min: 0, zone: String::new() }
}

/// The reason of a correction, and what it corrects; who corrects is put in when it is sent.
pub(crate) fn correcting(target: fitcheck_exchange::journal::chain::Head, reason: &str) -> Correction {
    Correction { target, reason: reason.trim().to_owned(), by: String::new() }
}
