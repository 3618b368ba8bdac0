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
    if let Some(Correction { target, .. }) = entry.corrects() {
        may_follow(connection, path, *target, |kind| kind.is_none_or(is_corrected))?;
    }
    if let Some(answer) = entry.alarm().and_then(|alarm| alarm.answer.as_ref()) {
        may_follow(connection, path, answer.target, |kind| kind == Some(FoundEntryKind::Alarm))?;
    }
    match entry.report().and_then(|report| report.shown.head) {
        Some(head) => may_know(connection, path, head),
        None => Ok(()),
    }
}

/// Whether entries of a kind are corrected: a report says which file was written and an alarm which rule fired, and that stands.
const fn is_corrected(kind: FoundEntryKind) -> bool {
    match kind {
        FoundEntryKind::Check | FoundEntryKind::Withdrawal => true,
        FoundEntryKind::Report | FoundEntryKind::Alarm => false,
    }
}

/// Whether an entry may be corrected, or an alarm answered: it is the one that was meant, it is of the right kind, and nothing has corrected
/// or answered it meanwhile. The kind of what cannot be read is not known.
fn may_follow(
    connection: &Connection,
    path: &Path,
    Head { number, hash }: Head,
    is_right: impl Fn(Option<FoundEntryKind>) -> bool,
) -> Result<(), StoreError> {
    let failed = |error: rusqlite::Error| StoreError::of(path, &error);
    let mut there = connection.prepare_cached("SELECT hash, body FROM entry WHERE number = ?1").map_err(failed)?;
    let found = there.query_row([number::integer(number)], |row| {
        let kind = body::found(row.get_ref(1)?.as_blob()?).ok().flatten().map(|found| found.kind);
        Ok((row.get::<_, [u8; 32]>(0)?, kind))
    });
    match found.optional().map_err(failed)? {
        Some((there, kind)) if there == hash.0 => {
            if !is_right(kind) {
                return Err(match kind {
                    Some(FoundEntryKind::Report) => StoreError::IsReport { number },
                    Some(FoundEntryKind::Alarm) => StoreError::IsAlarm { number },
                    _ => StoreError::NoAlarm { number },
                });
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
