//! What an entry may refer to: looked at in the transaction that adds it.

use std::path::Path;

use fitcheck_exchange::journal::body;
use fitcheck_exchange::journal::chain::Head;
use fitcheck_exchange::journal::entry::{Correction, Entry};
use fitcheck_exchange::journal::found::FoundEntryKind;
use rusqlite::{Connection, OptionalExtension as _};

use super::{index, number};
use crate::error::StoreError;

/// Whether an entry may be added: what it corrects or says of the journal is so.
pub(super) fn may_add(connection: &Connection, path: &Path, entry: &Entry) -> Result<(), StoreError> {
    if let Some(correction) = entry.corrects() {
        may_correct(connection, path, correction)?;
    }
    match entry.report().and_then(|report| report.shown.head) {
        Some(head) => may_know(connection, path, head),
        None => Ok(()),
    }
}

/// Whether an entry may be corrected: it is the one that was meant, it is no report, and nothing has corrected it meanwhile.
fn may_correct(connection: &Connection, path: &Path, correction: &Correction) -> Result<(), StoreError> {
    let failed = |error: rusqlite::Error| StoreError::of(path, &error);
    let Head { number, hash } = correction.target;
    let mut there = connection.prepare_cached("SELECT hash, body FROM entry WHERE number = ?1").map_err(failed)?;
    let found = there.query_row([number::integer(number)], |row| {
        let found = body::found(row.get_ref(1)?.as_blob()?);
        // What cannot be read is none that is known to be a report.
        let is_report = found.is_ok_and(|found| found.is_some_and(|found| found.kind == FoundEntryKind::Report));
        Ok((row.get::<_, [u8; 32]>(0)?, is_report))
    });
    match found.optional().map_err(failed)? {
        Some((there, is_report)) if there == hash.0 => {
            if is_report {
                return Err(StoreError::IsReport { number });
            }
        }
        _ => return Err(StoreError::OtherTarget { number }),
    }
    match index::Corrections::of(connection).and_then(|all| all.newest(number)).map_err(failed)? {
        Some(by) => Err(StoreError::Corrected { number, by }),
        None => Ok(()),
    }
}

/// Whether the journal has the entry that a report knows as its last one: another journal's checks have other numbers.
fn may_know(connection: &Connection, path: &Path, head: Head) -> Result<(), StoreError> {
    let failed = |error: rusqlite::Error| StoreError::of(path, &error);
    let mut there = connection.prepare_cached("SELECT hash FROM entry WHERE number = ?1").map_err(failed)?;
    let found: Option<[u8; 32]> =
        there.query_row([number::integer(head.number)], |row| row.get(0)).optional().map_err(failed)?;
    if found == Some(head.hash.0) { Ok(()) } else { Err(StoreError::OtherJournal { number: head.number }) }
}
