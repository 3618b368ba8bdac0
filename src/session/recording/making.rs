//! From a check to the entry that is kept.

use std::sync::Arc;

use super::{Known, Recording};
use crate::journal::chain::Hash;
use crate::journal::entry::{
    About, Check, Checked, Content, Correction, CycleCheck, Entry, FileRole, Moment, UsedFile,
};
use crate::journal::query::RecordId;
use crate::journal::{Record, body};
use crate::message::{Message, Say as _};

/// What a user names beside a check.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Named {
    /// The part.
    pub part: String,
    /// Its serial number.
    pub serial: String,
    /// Anything else.
    pub remark: String,
}

/// A file that checks were made with, where its bytes were seen.
pub(in crate::session) fn used(role: FileRole, name: &str, sha256: Option<Hash>) -> Option<UsedFile> {
    Some(UsedFile { role, name: name.into(), sha256: sha256? })
}

impl Recording {
    /// Sends checks of the history, from this number on; each is named by its own part. `files` says what each was made with.
    /// Returns how many can be no entries of a journal, and why the first cannot: the others do not wait for them.
    pub(in crate::session) fn keep_checks(
        &mut self,
        first: RecordId,
        records: &[Arc<Record>],
        named: &Named,
        files: impl Fn(&Record) -> Vec<UsedFile>,
    ) -> Option<(usize, Message)> {
        if !self.is_on() {
            return None;
        }
        let (mut entries, mut known, mut refused) = (Vec::new(), Vec::new(), Vec::new());
        for (id, record) in (first.0..).map(RecordId).zip(records) {
            let named = Named { part: record.id.clone(), ..named.clone() };
            let check = Check { what: Checked::Size(Arc::clone(record)), files: files(record), corrects: None };
            let entry = self.entry(&named, Content::Check(Box::new(check)));
            match body::write(&entry) {
                Ok(_) => {
                    known.push((id, named));
                    entries.push(entry);
                }
                Err(error) => refused.push((id, named, error.message())),
            }
        }
        if let Some(run) = self.send(entries) {
            let of_run = (0..).map(|at| (run, at)).zip(known);
            self.checks.extend(of_run.map(|(slip, (id, named))| (id, Known { slip, named })));
        }
        let told = refused.first().map(|(_, _, why)| (refused.len(), why.clone()));
        for (id, named, why) in refused {
            let slip = (self.refuse(why), 0);
            self.checks.insert(id, Known { slip, named });
        }
        told
    }

    /// Sends what cycles say, named as the next check is; returns the number of the batch.
    pub(in crate::session) fn keep_cycles(&mut self, cycles: Vec<CycleCheck>, files: &[UsedFile]) -> Option<u64> {
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
    pub(in crate::session) fn keep_correction(&mut self, about: About, content: Content) -> Result<u64, Message> {
        let about = About { station: self.station.clone(), time: unstamped(), ..about };
        let content = match content {
            Content::Withdrawal(correction) => Content::Withdrawal(self.by_whom(correction)),
            Content::Check(mut check) => {
                check.corrects = check.corrects.map(|correction| self.by_whom(correction));
                Content::Check(check)
            }
            begin @ Content::Begin(_) => begin,
        };
        let entry = Entry { about, content };
        body::write(&entry).map_err(|error| error.message())?;
        self.send(vec![entry]).ok_or_else(|| Message::new("records-page-not-recording"))
    }

    /// Whoever measures now corrects.
    fn by_whom(&self, correction: Correction) -> Correction {
        Correction { by: self.who().to_owned(), ..correction }
    }

    fn entry(&self, named: &Named, content: Content) -> Entry {
        let about = About {
            station: self.station.clone(),
            time: unstamped(),
            who: self.who().to_owned(),
            part: named.part.clone(),
            serial: named.serial.clone(),
            feature: String::new(),
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
pub(in crate::session) fn correcting(target: crate::journal::chain::Head, reason: &str) -> Correction {
    Correction { target, reason: reason.trim().to_owned(), by: String::new() }
}
