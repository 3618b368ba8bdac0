//! From a check to the entry that is kept.

use std::sync::Arc;

use super::{Known, Recording};
use crate::journal::Record;
use crate::journal::chain::Hash;
use crate::journal::entry::{
    About, Check, Checked, Content, Correction, CycleCheck, Entry, FileRole, Moment, UsedFile,
};
use crate::journal::query::RecordId;

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
    pub(in crate::session) fn keep_checks(
        &mut self,
        first: RecordId,
        records: &[Arc<Record>],
        named: &Named,
        files: impl Fn(&Record) -> Vec<UsedFile>,
    ) {
        let checks = records.iter().map(|record| {
            let named = Named { part: record.id.clone(), ..named.clone() };
            let check = Check { what: Checked::Size(Arc::clone(record)), files: files(record), corrects: None };
            self.entry(&named, Content::Check(Box::new(check)))
        });
        let entries = checks.collect();
        let Some(run) = self.send(entries) else { return };
        for (at, record) in (0..).zip(records) {
            let named = Named { part: record.id.clone(), ..named.clone() };
            self.checks.insert(RecordId(first.0.saturating_add(at)), Known { slip: (run, at), named });
        }
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
    pub(in crate::session) fn keep_correction(&mut self, about: About, content: Content) -> Option<u64> {
        let about = About { station: self.station.clone(), time: unstamped(), ..about };
        self.send(vec![Entry { about, content }])
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

/// The reason of a correction, and what it corrects.
pub(in crate::session) fn correcting(target: crate::journal::chain::Head, reason: &str) -> Correction {
    Correction { target, reason: reason.trim().to_owned() }
}
