//! The words of entries, and questions for them.
//!
//! To index the words of each entry when it is added would take as long as adding it. So they wait until some hundreds have come, and
//! whoever asks looks at the newest entries themselves. That is also the faster way for words that nearly every entry has; the index is
//! there for those that few have.

use rusqlite::types::Value;
use rusqlite::{Connection, Transaction, TransactionBehavior, params, params_from_iter};

use super::finding::Conditions;
use super::reader::natural;
use crate::journal::body;

/// So many entries wait for their words to be indexed.
const WAIT: i64 = 512;
/// So many entries are looked at themselves before the index is asked: more than ever wait.
const LOOK: i64 = 2_000;

/// Indexes the words of the entries that wait, if they are many.
pub(super) fn index(connection: &Connection, last: i64) -> rusqlite::Result<()> {
    if last < indexed(connection)?.saturating_add(WAIT) {
        return Ok(());
    }
    let transaction = Transaction::new_unchecked(connection, TransactionBehavior::Immediate)?;
    // Another program may have been first.
    let indexed = indexed(&transaction)?;
    if indexed < last {
        all_from(&transaction, indexed, last)?;
    }
    transaction.commit()
}

/// The last entry whose words are indexed.
fn indexed(connection: &Connection) -> rusqlite::Result<i64> {
    connection.prepare_cached("SELECT number FROM worded")?.query_row([], |row| row.get(0))
}

/// Indexes the words of all entries behind one, up to another one.
pub(super) fn all_from(connection: &Connection, indexed: i64, last: i64) -> rusqlite::Result<()> {
    let mut insert = connection.prepare("INSERT INTO words(rowid, text) VALUES (?1, ?2)")?;
    let mut entries =
        connection.prepare("SELECT number, body FROM entry WHERE ?1 < number AND number <= ?2 ORDER BY number")?;
    let mut rows = entries.query([indexed, last])?;
    while let Some(row) = rows.next()? {
        let words = match body::found(row.get_ref(1)?.as_blob()?) {
            Ok(Some(found)) => found.words(),
            Ok(None) | Err(_) => Vec::new(),
        };
        if !words.is_empty() {
            insert.execute(params![row.get::<_, i64>(0)?, words.join(" ")])?;
        }
    }
    connection.execute("UPDATE worded SET number = ?1", [last]).map(drop)
}

/// The numbers of entries that have words, newest first: those of the newest that conditions allow, and then those of the index.
pub(super) fn numbers(
    connection: &Connection,
    conditions: &Conditions,
    words: &[String],
    (before, most): (i64, i64),
) -> rusqlite::Result<Vec<u64>> {
    let Conditions { sql, values } = conditions;
    let most = usize::try_from(most).unwrap_or(usize::MAX);
    let bound = |last: &[Value]| params_from_iter(values.iter().chain(last).cloned().collect::<Vec<_>>());
    let mut numbers = Vec::new();
    let looked_at = {
        let mut looking = connection.prepare_cached(&format!(
            "SELECT find.number, (SELECT body FROM entry WHERE entry.number = find.number) FROM find \
             WHERE {sql} AND find.number < ? ORDER BY find.number DESC LIMIT ?"
        ))?;
        let mut rows = looking.query(bound(&[Value::Integer(before), Value::Integer(LOOK)]))?;
        let (mut count, mut last) = (0, before);
        while let Some(row) = rows.next()? {
            (count, last) = (count + 1, row.get(0)?);
            let bytes = row.get_ref(1)?.as_blob_or_null()?.unwrap_or_default();
            if body::found(bytes).is_ok_and(|found| found.is_some_and(|found| found.has_words(words))) {
                numbers.push(natural(last));
            }
            if most <= numbers.len() {
                return Ok(numbers);
            }
        }
        if count < LOOK {
            return Ok(numbers);
        }
        last
    };
    let left = i64::try_from(most.saturating_sub(numbers.len())).unwrap_or(i64::MAX);
    // Each goes in quotation marks, so none of them is an operator.
    let wanted: Vec<String> = words.iter().map(|word| format!("\"{word}\"*")).collect();
    let mut rest = connection.prepare_cached(&format!(
        "SELECT number FROM find WHERE {sql} AND number < ? AND number IN (SELECT rowid FROM words WHERE words MATCH ?) \
         ORDER BY number DESC LIMIT ?"
    ))?;
    let last = [Value::Integer(looked_at), Value::Text(wanted.join(" AND ")), Value::Integer(left)];
    for number in rest.query_map(bound(&last), |row| row.get(0).map(natural))? {
        numbers.push(number?);
    }
    Ok(numbers)
}
