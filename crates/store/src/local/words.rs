//! Questions for words.
//!
//! A word that nearly every entry has is found faster by looking at the newest entries than by asking the index for all that have it; the
//! index is there for words that few have. A word that is the number of an entry is in no index: that entry is looked at by itself.

use fitcheck_exchange::journal::body;
use fitcheck_exchange::journal::found::WantedWord;
use rusqlite::types::Value;
use rusqlite::{Connection, OptionalExtension as _, params_from_iter};

use super::finding::Conditions;
use super::number::{integer, natural};

/// So many entries are looked at before the index is asked.
const LOOK: i64 = 2_000;

/// The numbers of indexed entries that have words, newest first: the newest that conditions allow are looked at, and then the index is
/// asked.
pub(super) fn numbers(
    connection: &Connection,
    conditions: &Conditions,
    words: &[WantedWord],
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
        let mut count = 0;
        let mut last = before;
        while let Some(row) = rows.next()? {
            count += 1;
            last = row.get(0)?;
            let number = natural(last);
            // One that is not found by its number is told by whoever reads it.
            if row.get_ref(1)?.as_blob_or_null()?.is_none_or(|bytes| has_words(number, bytes, words)) {
                numbers.push(number);
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
    let wanted: Vec<String> = words.iter().map(|word| format!("\"{}\"*", word.text)).collect();
    let mut rest = connection.prepare_cached(&format!(
        "SELECT number FROM find WHERE {sql} AND number < ? AND number IN (SELECT rowid FROM words WHERE words MATCH ?) \
         ORDER BY number DESC LIMIT ?"
    ))?;
    let last = [Value::Integer(looked_at), Value::Text(wanted.join(" AND ")), Value::Integer(left)];
    for number in rest.query_map(bound(&last), |row| row.get(0).map(natural))? {
        numbers.push(number?);
    }
    let mut by_number = connection.prepare_cached(&format!(
        "SELECT (SELECT body FROM entry WHERE entry.number = find.number) FROM find WHERE {sql} AND find.number = ?"
    ))?;
    for number in words.iter().filter_map(|word| word.number).filter(|number| integer(*number) < looked_at) {
        let body: Option<Option<Vec<u8>>> =
            by_number.query_row(bound(&[Value::Integer(integer(number))]), |row| row.get(0)).optional()?;
        let is_found = body.flatten().is_some_and(|bytes| has_words(number, &bytes, words));
        if is_found && !numbers.contains(&number) {
            numbers.push(number);
        }
    }
    numbers.sort_unstable_by(|one, other| other.cmp(one));
    numbers.truncate(most);
    Ok(numbers)
}

/// Whether an entry has the words that are asked for.
fn has_words(number: u64, bytes: &[u8], words: &[WantedWord]) -> bool {
    body::found(bytes).is_ok_and(|found| found.is_some_and(|found| found.has_words(number, words)))
}
