//! Whether every entry of a journal is the one that was written, and is found as it says.
//!
//! One thread reads and hashes, another one compares what entries are found by, a third looks at the indexes, a fourth at the pages of
//! the entries: each takes about as long.
//!
//! The entries are read one after the other, and questions look each of them up by its number. A number in the pages above that was
//! changed lets the first pass and misleads the second, so the pages are looked at, too.

use std::collections::HashMap;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

use fitcheck_core::message::Say;
use fitcheck_exchange::journal::body;
use fitcheck_exchange::journal::chain::{ChainId, Hash, Head, entry_hash};
use fitcheck_exchange::journal::entry::{Content, Kept};
use fitcheck_exchange::journal::found::FoundEntry;
use fitcheck_exchange::journal::inspection::{Inspected, Inspection};
use rusqlite::{Connection, InterruptHandle, OptionalExtension as _};

use super::{finding, index, number, opening, reader, reported, schema};
use crate::error::StoreError;

/// After how many entries the progress is told.
const STEP: u64 = 10_000;
/// So many entries are handed over at once, and so often ahead.
const BLOCK: usize = 500;
const AHEAD: usize = 4;

/// What was found in a journal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verified {
    /// The name of its chain.
    pub chain: ChainId,
    /// The chain.
    pub inspected: Inspected,
    /// What is wrong with the file around it.
    pub findings: Vec<Finding>,
}

impl Verified {
    /// Whether nothing is wrong.
    pub const fn is_whole(&self) -> bool {
        self.inspected.breaks.is_empty() && self.findings.is_empty()
    }
}

/// What is wrong with a journal's file, besides its chain.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "store-finding")]
pub enum Finding {
    /// What keeps entries from being changed is missing or was changed.
    Altered {
        /// The trigger or table.
        name: String,
    },
    /// There is no first entry that tells its chain.
    NoBeginning,
    /// The pages of a table lead to another entry than they say, or to none: what is in the file is hidden from questions.
    Pages {
        /// What the database says.
        reason: String,
    },
    /// An index of questions does not agree with its table.
    Index {
        /// What the database says.
        reason: String,
    },
    /// Questions find entries by something else than what they say, or do not find them.
    NotFound {
        /// How many entries.
        entries: u64,
    },
}

/// Looks at every entry of a journal, and compares it with heads of its chain that were kept elsewhere. `progress` gets how many were looked
/// at and how many there are, and may stop it.
///
/// # Errors
/// [`StoreError::Interrupted`] where it was stopped; [`StoreError`] where the file cannot be read to its end.
pub fn verify(
    path: &Path,
    known: &[Head],
    progress: &mut dyn FnMut(u64, u64) -> ControlFlow<()>,
) -> Result<Verified, StoreError> {
    let _which_version = opening::look_to_read(path)?;
    let connection = opening::to_read(path)?;
    let finds = opening::to_read(path)?;
    let failed = |error: rusqlite::Error| StoreError::of(path, &error);
    let mut findings = Vec::new();
    findings.extend(schema::altered(&connection).map_err(failed)?.map(|name| Finding::Altered { name }));
    findings.extend(schema::derived_altered(&connection).map_err(failed)?.map(|name| Finding::Altered { name }));
    let chain = chain_of(&connection, path, &mut findings)?;
    let mut inspection = Inspection::new(chain, known);
    let (sender, receiver) = sync_channel(AHEAD);
    let checked = opening::to_read(path)?;
    let paged = opening::to_read(path)?;
    let no_more = [checked.get_interrupt_handle(), paged.get_interrupt_handle()];
    let (not_found, index, pages) = thread::scope(|scope| {
        let thread = |name: &str| thread::Builder::new().name(name.to_owned());
        let no_thread = |error: std::io::Error| StoreError::system(path, &error);
        let comparing =
            thread("compare").spawn_scoped(scope, move || compared(&finds, &receiver)).map_err(no_thread)?;
        let checking = thread("indexes").spawn_scoped(scope, move || indexes(&checked)).map_err(no_thread)?;
        let paging = thread("pages").spawn_scoped(scope, move || pages(&paged)).map_err(no_thread)?;
        let walked = walk(&connection, &mut inspection, &sender, progress).map_err(failed);
        drop(sender);
        if !matches!(walked, Ok(ControlFlow::Continue(()))) {
            no_more.iter().for_each(InterruptHandle::interrupt);
        }
        let not_found = comparing.join().map_err(|_panicked| StoreError::Interrupted)?.map_err(failed);
        let index = checking.join().map_err(|_panicked| StoreError::Interrupted)?.map_err(failed);
        let pages = paging.join().map_err(|_panicked| StoreError::Interrupted)?.map_err(failed);
        if walked?.is_break() {
            return Err(StoreError::Interrupted);
        }
        Ok((not_found?, index?, pages?))
    })?;
    findings.extend(pages.map(|reason| Finding::Pages { reason }));
    findings.extend(index.map(|reason| Finding::Index { reason }));
    findings.extend((0 < not_found).then_some(Finding::NotFound { entries: not_found }));
    Ok(Verified { chain, inspected: inspection.finish(), findings })
}

/// Reads all entries, and hands them over to be compared.
fn walk(
    connection: &Connection,
    inspection: &mut Inspection,
    sender: &SyncSender<Vec<Kept>>,
    progress: &mut dyn FnMut(u64, u64) -> ControlFlow<()>,
) -> rusqlite::Result<ControlFlow<()>> {
    let all = connection.query_row("SELECT count(*) FROM entry", [], |row| row.get(0).map(number::natural))?;
    let mut entries = connection.prepare("SELECT number, body, hash FROM entry ORDER BY number")?;
    let mut rows = entries.query([])?;
    let mut done = 0_u64;
    let mut block = Vec::with_capacity(BLOCK);
    while let Some(row) = rows.next()? {
        let kept = reader::kept(row)?;
        inspection.see(kept.head.number, &kept.body, kept.head.hash);
        block.push(kept);
        if block.len() == BLOCK {
            // Where nobody listens, that thread tells why.
            let _heard = sender.send(std::mem::replace(&mut block, Vec::with_capacity(BLOCK)));
        }
        done = done.saturating_add(1);
        if done.is_multiple_of(STEP) && progress(done, all).is_break() {
            return Ok(ControlFlow::Break(()));
        }
    }
    let _heard = sender.send(block);
    Ok(ControlFlow::Continue(()))
}

/// How many entries are found by something else than what they say, or are found and not there.
fn compared(connection: &Connection, entries: &Receiver<Vec<Kept>>) -> rusqlite::Result<u64> {
    let transaction = connection.unchecked_transaction()?;
    let mut finds = transaction.prepare(finding::ROWS)?;
    let mut rows = finds.query([])?;
    let mut row = rows.next()?;
    let indexed = index::indexed(&transaction)?;
    let mut wrong = 0_u64;
    let mut last = 0;
    let mut classes = Classes::default();
    while let Ok(block) = entries.recv() {
        for kept in block {
            last = number::integer(kept.head.number);
            // Rows without an entry.
            while row.is_some_and(|row| row.get_ref(0).is_ok_and(|number| number.as_i64().is_ok_and(|row| row < last)))
            {
                wrong = wrong.saturating_add(1);
                row = rows.next()?;
            }
            // An entry that cannot be read is found by nothing, and one that waits is looked at itself.
            let found = body::found(&kept.body).ok().flatten().filter(|_found| last <= indexed);
            let is_there = row.is_some_and(|row| row.get_ref(0).is_ok_and(|number| number.as_i64() == Ok(last)));
            let agrees = match (row, &found) {
                (Some(row), Some(found)) if is_there => {
                    finding::is_of(row, found, classes.of(found))?
                        && match &found.report {
                            Some(report) => reported::agrees(&transaction, last, report)?,
                            None => true,
                        }
                }
                (_, found) => !is_there && found.is_none(),
            };
            if is_there {
                row = rows.next()?;
            }
            if !agrees {
                wrong = wrong.saturating_add(1);
            }
        }
    }
    // Whoever records meanwhile adds rows behind the last.
    let more: i64 = transaction.query_row(
        "SELECT count(*) FROM find WHERE number > ?1 AND number NOT IN (SELECT number FROM entry)",
        [last],
        |row| row.get(0),
    )?;
    let without = reported::without_report(&transaction)?;
    Ok(wrong.saturating_add(number::natural(more)).saturating_add(without))
}

/// What is wrong with the table of questions and its indexes, and with the pages of the words, by the database's own look at them.
fn indexes(connection: &Connection) -> rusqlite::Result<Option<String>> {
    first_of(
        connection,
        &[
            "PRAGMA integrity_check('find')",
            "PRAGMA integrity_check('report')",
            "PRAGMA integrity_check('reported')",
            "PRAGMA quick_check('words_data')",
            "PRAGMA quick_check('words_idx')",
        ],
    )
}

/// What is wrong with the pages that lead to entries by their numbers; what the entries say is looked at by their hashes.
fn pages(connection: &Connection) -> rusqlite::Result<Option<String>> {
    first_of(connection, &["PRAGMA quick_check('entry')"])
}

fn first_of(connection: &Connection, looks: &[&str]) -> rusqlite::Result<Option<String>> {
    for look in looks {
        let said: String = connection.query_row(look, [], |row| row.get(0))?;
        if said != "ok" {
            return Ok(Some(said));
        }
    }
    Ok(None)
}

/// The classes of callouts that were met: a shop has few.
#[derive(Default)]
struct Classes(HashMap<String, String>);

impl Classes {
    /// So many are remembered.
    const MOST: usize = 1_000;

    fn of(&mut self, found: &FoundEntry<'_>) -> &str {
        let callout = found.callout();
        if !self.0.contains_key(callout.as_ref()) {
            if Self::MOST <= self.0.len() {
                self.0.clear();
            }
            self.0.insert(callout.clone().into_owned(), found.class());
        }
        self.0.get(callout.as_ref()).map_or("", String::as_str)
    }
}

/// The name of the chain by which its first entry is hashed: the file tells it, and so does that entry.
fn chain_of(connection: &Connection, path: &Path, findings: &mut Vec<Finding>) -> Result<ChainId, StoreError> {
    let failed = |error: rusqlite::Error| StoreError::of(path, &error);
    let told = reader::chain_of(connection, path)?;
    let first = connection
        .query_row("SELECT number, body, hash FROM entry WHERE number = 1", [], reader::kept)
        .optional()
        .map_err(failed)?;
    let Some(Kept { head: Head { hash, .. }, body }) = first else {
        findings.push(Finding::NoBeginning);
        return Ok(told);
    };
    let begins = |chain: ChainId, hash: Hash| entry_hash(chain, Head::default(), &body) == Some(hash);
    let own = if let Ok(Content::Begin(begin)) = body::read(&body).map(|entry| entry.content) {
        begin.chain
    } else {
        findings.push(Finding::NoBeginning);
        told
    };
    if own != told && begins(own, hash) {
        findings.push(Finding::Altered { name: "chain".to_owned() });
        return Ok(own);
    }
    Ok(told)
}
