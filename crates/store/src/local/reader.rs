//! Reading a journal, beside whoever adds to it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck_exchange::journal::ask::Question;
use fitcheck_exchange::journal::body::{self, BodyError};
use fitcheck_exchange::journal::chain::{ChainId, Hash, Head};
use fitcheck_exchange::journal::entry::{Entry, Kept};
use rusqlite::types::Value;
use rusqlite::{Connection, InterruptHandle, OptionalExtension as _, params_from_iter};

use super::finding::Conditions;
use super::index::{self, Corrections, Waiting};
use super::number::{integer, natural};
use super::{head_of, opening, words};
use crate::error::StoreError;

/// A journal that is read. Every call sees the file at one moment, and holds nothing up between two calls.
#[derive(Debug)]
pub struct Reader {
    path: PathBuf,
    pub(super) connection: Connection,
    chain: ChainId,
}

/// Ends a call of a reader from another thread.
pub struct Interrupt(InterruptHandle);

impl Interrupt {
    /// Ends what runs now: it answers with [`StoreError::Interrupted`].
    pub fn stop(&self) {
        self.0.interrupt();
    }
}

impl std::fmt::Debug for Interrupt {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Interrupt")
    }
}

/// An entry of a list.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedEntry {
    pub kept: Kept,
    /// What it says.
    pub entry: Result<Entry, BodyError>,
    /// The newest entry that corrects it or takes it back.
    pub corrected_by: Option<u64>,
}

impl Reader {
    /// Opens a journal to read it.
    ///
    /// # Errors
    /// [`StoreError`] where there is none, or it is none that this program knows.
    pub fn open(path: &Path) -> Result<Self, StoreError> {
        if opening::look_to_read(path)? == opening::State::Older {
            return Err(StoreError::Older { path: path.to_owned() });
        }
        let connection = opening::to_read(path)?;
        let chain = chain_of(&connection, path)?;
        Ok(Self { path: path.to_owned(), connection, chain })
    }

    /// The name of the chain.
    pub const fn chain(&self) -> ChainId {
        self.chain
    }

    /// The last entry.
    ///
    /// # Errors
    /// [`StoreError`] where the file cannot be read.
    pub fn head(&self) -> Result<Head, StoreError> {
        head_of(&self.connection).map_err(|error| self.failed(&error))
    }

    /// An entry by its number; `None` where there is none.
    ///
    /// # Errors
    /// As for [`Self::head`].
    pub fn entry(&self, number: u64) -> Result<Option<Kept>, StoreError> {
        Ok(self.entries(number, 1)?.into_iter().find(|kept| kept.head.number == number))
    }

    /// Entries from a number on, ascending.
    ///
    /// # Errors
    /// As for [`Self::head`].
    pub fn entries(&self, from: u64, most: usize) -> Result<Vec<Kept>, StoreError> {
        let sql = "SELECT number, body, hash FROM entry WHERE ?1 <= number ORDER BY number LIMIT ?2";
        let read = || -> rusqlite::Result<Vec<Kept>> {
            let mut entries = self.connection.prepare_cached(sql)?;
            entries.query_map([integer(from), size(most)], kept)?.collect()
        };
        read().map_err(|error| self.failed(&error))
    }

    /// The numbers of checks, withdrawals and reports that a question asks for, newest first, below a number.
    ///
    /// # Errors
    /// [`StoreError::Interrupted`] where somebody stopped it, and as for [`Self::head`].
    pub fn numbers(&self, question: &Question, before: Option<u64>, most: usize) -> Result<Vec<u64>, StoreError> {
        let read = || -> rusqlite::Result<Vec<u64>> {
            let Some(words) = question.wanted_words() else { return Ok(Vec::new()) };
            let transaction = self.connection.unchecked_transaction()?;
            let indexed = index::indexed(&transaction)?;
            let before = before.map_or(i64::MAX, integer);
            let mut numbers = Vec::new();
            let mut corrections = BTreeMap::new();
            if indexed < before || question.standing {
                let waiting = Waiting::of(&transaction)?;
                numbers.extend(waiting.numbers(question, before).take(most));
                corrections = waiting.corrections();
            }
            if numbers.len() < most {
                let conditions = Conditions::of(question);
                // Those that an entry corrects that waits do not stand.
                let left = most.saturating_sub(numbers.len()).saturating_add(corrections.len());
                let bounds = (before.min(indexed.saturating_add(1)), size(left));
                let rest = if words.is_empty() {
                    indexed_numbers(&transaction, conditions, bounds)?
                } else {
                    words::numbers(&transaction, &conditions, &words, bounds)?
                };
                let stands = |number: &u64| !question.standing || !corrections.contains_key(number);
                numbers.extend(rest.into_iter().filter(stands));
                numbers.truncate(most);
            }
            Ok(numbers)
        };
        read().map_err(|error| self.failed(&error))
    }

    /// How many checks, withdrawals and reports a question asks for, counted up to a number.
    ///
    /// # Errors
    /// As for [`Self::numbers`].
    pub fn count(&self, question: &Question, most: u64) -> Result<u64, StoreError> {
        if question.standing || question.words.iter().any(|text| !text.trim().is_empty()) {
            let numbers = self.numbers(question, None, usize::try_from(most).unwrap_or(usize::MAX))?;
            return Ok(u64::try_from(numbers.len()).unwrap_or(u64::MAX));
        }
        let Conditions { sql, mut values } = Conditions::of(question);
        let sql = format!("SELECT count(*) FROM (SELECT 1 FROM find WHERE {sql} LIMIT ?)");
        values.push(Value::Integer(integer(most)));
        let read = || -> rusqlite::Result<u64> {
            let transaction = self.connection.unchecked_transaction()?;
            let waiting = Waiting::of(&transaction)?.numbers(question, i64::MAX).count();
            let mut count = transaction.prepare_cached(&sql)?;
            let indexed = count.query_row(params_from_iter(values), |row| row.get(0).map(natural))?;
            Ok(indexed.saturating_add(u64::try_from(waiting).unwrap_or(u64::MAX)).min(most))
        };
        read().map_err(|error| self.failed(&error))
    }

    /// Entries by their numbers, in the order that is given; a number behind the last one is left out.
    ///
    /// # Errors
    /// [`StoreError::Hidden`] where one before the last is not found, and as for [`Self::head`].
    pub fn rows(&self, numbers: &[u64]) -> Result<Vec<ListedEntry>, StoreError> {
        let read = || -> rusqlite::Result<Result<Vec<ListedEntry>, u64>> {
            let transaction = self.connection.unchecked_transaction()?;
            let mut entries = transaction.prepare_cached("SELECT number, body, hash FROM entry WHERE number = ?1")?;
            let last = head_of(&transaction)?.number;
            let corrections = Corrections::of(&transaction)?;
            let mut rows = Vec::with_capacity(numbers.len());
            for number in numbers {
                let Some(kept) = entries.query_row([integer(*number)], kept).optional()? else {
                    // What was listed, or has a number between others, is not left out without a word.
                    if (1..=last).contains(number) {
                        return Ok(Err(*number));
                    }
                    continue;
                };
                let corrected_by = corrections.newest(*number)?;
                rows.push(ListedEntry { entry: body::read(&kept.body), kept, corrected_by });
            }
            Ok(Ok(rows))
        };
        let hidden = |number| StoreError::Hidden { path: self.path.clone(), number };
        read().map_err(|error| self.failed(&error))?.map_err(hidden)
    }

    /// Ends a running call from another thread.
    pub fn interrupt(&self) -> Interrupt {
        Interrupt(self.connection.get_interrupt_handle())
    }

    /// How SQLite looks a question up, for tests.
    ///
    /// # Errors
    /// As for [`Self::numbers`].
    pub fn plan(&self, question: &Question) -> Result<String, StoreError> {
        let Conditions { sql, mut values } = Conditions::of(question);
        let sql = format!(
            "EXPLAIN QUERY PLAN SELECT number FROM find WHERE {sql} AND number < ? ORDER BY number DESC LIMIT ?"
        );
        values.extend([Value::Integer(i64::MAX), Value::Integer(100)]);
        let read = || -> rusqlite::Result<Vec<String>> {
            let mut plan = self.connection.prepare(&sql)?;
            plan.query_map(params_from_iter(values), |row| row.get(3))?.collect()
        };
        read().map(|lines| lines.join("\n")).map_err(|error| self.failed(&error))
    }

    pub(super) fn failed(&self, error: &rusqlite::Error) -> StoreError {
        StoreError::of(&self.path, error)
    }
}

/// The numbers of indexed entries that a question without words asks for.
fn indexed_numbers(
    connection: &Connection,
    conditions: Conditions,
    (before, most): (i64, i64),
) -> rusqlite::Result<Vec<u64>> {
    let Conditions { sql, mut values } = conditions;
    let sql = format!("SELECT number FROM find WHERE {sql} AND number < ? ORDER BY number DESC LIMIT ?");
    values.extend([Value::Integer(before), Value::Integer(most)]);
    let mut numbers = connection.prepare_cached(&sql)?;
    numbers.query_map(params_from_iter(values), |row| row.get(0).map(natural))?.collect()
}

/// The name of the chain that a file holds. Its first entry tells it, too, and is hashed with it.
pub(super) fn chain_of(connection: &Connection, path: &Path) -> Result<ChainId, StoreError> {
    let name: Option<[u8; 16]> = connection
        .query_row("SELECT name FROM chain", [], |row| row.get(0))
        .optional()
        .map_err(|error| StoreError::of(path, &error))?;
    name.map(ChainId).ok_or_else(|| StoreError::NoBeginning { path: path.to_owned() })
}

/// A row of number, body and hash.
pub(super) fn kept(row: &rusqlite::Row<'_>) -> rusqlite::Result<Kept> {
    let body: Arc<[u8]> = row.get_ref(1)?.as_blob()?.into();
    Ok(Kept { head: Head { number: natural(row.get(0)?), hash: Hash(row.get(2)?) }, body })
}

fn size(most: usize) -> i64 {
    i64::try_from(most).unwrap_or(i64::MAX)
}
