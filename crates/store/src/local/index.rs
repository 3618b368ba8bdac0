//! What entries are found by is indexed some hundreds of entries later.
//!
//! To index each entry when it is added would take longer than adding it: each of its indexes is another page that has to be on the disk. So entries wait, and whoever asks looks at the waiting ones themselves.

use std::collections::BTreeMap;

use fitcheck_exchange::journal::ask::Question;
use fitcheck_exchange::journal::body;
use rusqlite::{Connection, Transaction, TransactionBehavior, params};

use super::number::{integer, natural};
use super::{finding, reported};

/// So many entries wait to be indexed.
const WAIT: i64 = 512;

/// Indexes the entries that wait, if they are many.
pub(super) fn bring_up(connection: &Connection, last: i64) -> rusqlite::Result<()> {
    if last < indexed(connection)?.saturating_add(WAIT) { Ok(()) } else { bring_all_up(connection, last) }
}

/// Indexes all entries that wait.
pub(super) fn bring_all_up(connection: &Connection, last: i64) -> rusqlite::Result<()> {
    let transaction = Transaction::new_unchecked(connection, TransactionBehavior::Immediate)?;
    // Another program may have been first.
    let indexed = indexed(&transaction)?;
    if indexed < last {
        all_from(&transaction, indexed, last)?;
    }
    transaction.commit()
}

/// The last entry that is indexed.
pub(super) fn indexed(connection: &Connection) -> rusqlite::Result<i64> {
    connection.prepare_cached("SELECT number FROM indexed")?.query_row([], |row| row.get(0))
}

/// Indexes all entries behind one, up to another one. An entry that cannot be read is found by nothing.
pub(super) fn all_from(connection: &Connection, indexed: i64, last: i64) -> rusqlite::Result<()> {
    let mut insert = connection.prepare("INSERT INTO words(rowid, text) VALUES (?1, ?2)")?;
    let mut entries =
        connection.prepare("SELECT number, body FROM entry WHERE ?1 < number AND number <= ?2 ORDER BY number")?;
    let mut rows = entries.query([indexed, last])?;
    while let Some(row) = rows.next()? {
        let number = row.get(0)?;
        let Ok(Some(found)) = body::found(row.get_ref(1)?.as_blob()?) else { continue };
        finding::add(connection, number, &found)?;
        reported::add(connection, number, &found)?;
        let words = found.words();
        if !words.is_empty() {
            insert.execute(params![number, words.join(" ")])?;
        }
    }
    connection.execute("UPDATE indexed SET number = ?1", [last]).map(drop)
}

/// Which entries are corrected: by those that wait, or else by indexed ones.
pub(super) struct Corrections<'a> {
    connection: &'a Connection,
    waiting: BTreeMap<u64, u64>,
}

impl<'a> Corrections<'a> {
    pub(super) fn of(connection: &'a Connection) -> rusqlite::Result<Self> {
        Ok(Self { connection, waiting: Waiting::of(connection)?.corrections() })
    }

    /// The newest entry that corrects another one.
    pub(super) fn newest(&self, number: u64) -> rusqlite::Result<Option<u64>> {
        if let Some(by) = self.waiting.get(&number) {
            return Ok(Some(*by));
        }
        let mut newest = self.connection.prepare_cached("SELECT max(number) FROM find WHERE corrects = ?1")?;
        Ok(newest.query_row([integer(number)], |row| row.get::<_, Option<i64>>(0))?.map(natural))
    }
}

/// The entries that wait, newest first.
pub(super) struct Waiting(Vec<(u64, Vec<u8>)>);

impl Waiting {
    pub(super) fn of(connection: &Connection) -> rusqlite::Result<Self> {
        let sql = "SELECT number, body FROM entry WHERE (SELECT number FROM indexed) < number ORDER BY number DESC";
        let mut entries = connection.prepare_cached(sql)?;
        let entries = entries.query_map([], |row| Ok((natural(row.get(0)?), row.get(1)?)))?;
        Ok(Self(entries.collect::<Result<_, _>>()?))
    }

    /// Their numbers and bodies.
    pub(super) fn entries(&self) -> &[(u64, Vec<u8>)] {
        &self.0
    }

    /// Which entries they correct, each with the newest that does.
    pub(super) fn corrections(&self) -> BTreeMap<u64, u64> {
        let oldest_first = self.0.iter().rev();
        let found = oldest_first.filter_map(|(number, body)| Some((*number, body::found(body).ok()??)));
        found.filter_map(|(number, found)| Some((found.corrects?, number))).collect()
    }

    /// The numbers of those that a question asks for, below a number.
    pub(super) fn numbers(&self, question: &Question, before: i64) -> impl Iterator<Item = u64> {
        let corrections = self.corrections();
        let below = self.0.iter().filter(move |(number, _)| integer(*number) < before);
        below.filter_map(move |(number, body)| {
            let found = body::found(body).ok()??;
            question.finds(*number, &found, corrections.contains_key(number)).then_some(*number)
        })
    }
}
