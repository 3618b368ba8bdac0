//! The tables of a journal's file.
//!
//! `entry` is the truth and never changes its form: what was written stays as it was. Everything else is derived from it, serves
//! questions, and is made anew by every newer version ([`rebuild`]).

use std::collections::BTreeMap;

use rusqlite::{Connection, OptionalExtension as _, Transaction, TransactionBehavior};

use super::index;

/// What the file says it is: `Fitc` as a number.
pub(super) const APPLICATION: i64 = 0x4669_7463;
/// The version of the derived tables.
pub(super) const VERSION: i64 = 5;

/// The truth, and what keeps it: no change, no removal, and no entry out of its place, which `INSERT OR REPLACE` would be too.
const ENTRY: [(&str, &str); 5] = [
    ("chain", "CREATE TABLE chain(name BLOB NOT NULL CHECK(length(name) = 16)) STRICT"),
    (
        "entry",
        "CREATE TABLE entry(number INTEGER PRIMARY KEY, body BLOB NOT NULL, hash BLOB NOT NULL CHECK(length(hash) = 32)) STRICT",
    ),
    (
        "entry_keeps",
        "CREATE TRIGGER entry_keeps BEFORE UPDATE ON entry BEGIN SELECT RAISE(ABORT, 'a journal is only added to'); END",
    ),
    (
        "entry_stays",
        "CREATE TRIGGER entry_stays BEFORE DELETE ON entry BEGIN SELECT RAISE(ABORT, 'a journal is only added to'); END",
    ),
    (
        "entry_follows",
        "CREATE TRIGGER entry_follows BEFORE INSERT ON entry WHEN NEW.number IS NOT coalesce((SELECT max(number) FROM entry), 0) + 1 \
         BEGIN SELECT RAISE(ABORT, 'not the next number'); END",
    ),
];

/// What questions are answered by. Names are in small letters, as they are looked for; words have no accents either, and blanks between them.
/// `report` has the files that were written, and `reported` the entries that each of them shows.
const FIND: &str = "
CREATE TABLE find(
  number INTEGER PRIMARY KEY,
  at INTEGER NOT NULL,
  kind INTEGER NOT NULL,
  status INTEGER,
  simulated INTEGER NOT NULL,
  part TEXT NOT NULL,
  serial TEXT NOT NULL,
  feature TEXT NOT NULL,
  callout TEXT NOT NULL,
  class TEXT NOT NULL,
  who TEXT NOT NULL,
  station TEXT NOT NULL,
  corrects INTEGER
) STRICT;
CREATE INDEX find_at ON find(at, number);
CREATE INDEX find_part ON find(part, number);
CREATE INDEX find_serial ON find(serial, number) WHERE serial <> '';
CREATE INDEX find_feature ON find(feature, number) WHERE feature <> '';
CREATE INDEX find_callout ON find(callout, number);
CREATE INDEX find_class ON find(class, number);
CREATE INDEX find_status ON find(status, number);
CREATE INDEX find_who ON find(who, number);
CREATE INDEX find_corrects ON find(corrects, number) WHERE corrects IS NOT NULL;
CREATE VIRTUAL TABLE words USING fts5(text, content='', columnsize=0, detail='none', tokenize='ascii');
CREATE TABLE indexed(number INTEGER NOT NULL) STRICT;
INSERT INTO indexed VALUES (0);
CREATE INDEX find_simulated ON find(number) WHERE simulated = 1;
CREATE INDEX find_report ON find(number) WHERE kind = 3;
CREATE INDEX find_alarm ON find(number) WHERE kind = 4;
CREATE TABLE report(number INTEGER PRIMARY KEY, sha256 BLOB NOT NULL, name TEXT NOT NULL) STRICT;
CREATE INDEX report_sha256 ON report(sha256, number);
CREATE INDEX report_name ON report(name, number);
CREATE TABLE reported(
  report INTEGER NOT NULL,
  first INTEGER NOT NULL,
  last INTEGER NOT NULL,
  PRIMARY KEY(report, first)
) STRICT, WITHOUT ROWID;
CREATE INDEX reported_last ON reported(last, first, report);
";

/// Makes everything in an empty file.
pub(super) fn make(transaction: &Transaction<'_>) -> rusqlite::Result<()> {
    for (_name, sql) in ENTRY {
        transaction.execute_batch(sql)?;
    }
    transaction.execute_batch(FIND)?;
    transaction.pragma_update(None, "application_id", APPLICATION)?;
    transaction.pragma_update(None, "user_version", VERSION)
}

/// Makes the derived tables anew from the entries: how every older version is brought to this one.
pub(super) fn rebuild(connection: &mut Connection) -> rusqlite::Result<()> {
    let transaction = connection.transaction_with_behavior(TransactionBehavior::Immediate)?;
    let derived: Vec<String> = transaction
        .prepare(
            "SELECT name FROM sqlite_schema WHERE type = 'table' AND name IN ('find', 'words', 'indexed', 'report', 'reported')",
        )?
        .query_map([], |row| row.get(0))?
        .collect::<Result<_, _>>()?;
    for name in derived {
        transaction.execute_batch(&format!("DROP TABLE \"{name}\""))?;
    }
    transaction.execute_batch(FIND)?;
    let last = transaction.query_row("SELECT coalesce(max(number), 0) FROM entry", [], |row| row.get(0))?;
    index::all_from(&transaction, 0, last)?;
    transaction.pragma_update(None, "user_version", VERSION)?;
    transaction.commit()
}

/// What keeps the entries is missing or not what it should be, or something else is there that acts; `None` where all is as it was made.
pub(super) fn altered(connection: &Connection) -> rusqlite::Result<Option<String>> {
    let mut there = connection.prepare_cached("SELECT sql FROM sqlite_schema WHERE name = ?1")?;
    for (name, expected) in ENTRY {
        let mut rows = there.query([name])?;
        let is_as_made = match rows.next()? {
            Some(row) => row.get_ref(0)?.as_str_or_null()? == Some(expected),
            None => false,
        };
        if !is_as_made {
            return Ok(Some(name.to_owned()));
        }
    }
    // Nothing else may act when an entry is added.
    let mut others = connection.prepare_cached(
        "SELECT name FROM sqlite_schema WHERE (type = 'trigger' OR type = 'view') \
         AND name NOT IN ('entry_keeps', 'entry_stays', 'entry_follows') LIMIT 1",
    )?;
    others.query_row([], |row| row.get(0)).optional()
}

/// What questions are answered by is missing or not what it should be, or something else is there beside it; `None` where all is as it was made.
pub(super) fn derived_altered(connection: &Connection) -> rusqlite::Result<Option<String>> {
    let made = Connection::open_in_memory()?;
    made.execute_batch(FIND)?;
    let expected = tables(&made)?;
    let mut there = tables(connection)?;
    there.retain(|name, _sql| ENTRY.iter().all(|(kept, _)| kept != name));
    let mut names = expected.keys().chain(there.keys());
    if let Some(name) = names.find(|name| expected.get(*name) != there.get(*name)) {
        return Ok(Some(name.clone()));
    }
    // One chain, and one mark up to which entries are found by words.
    for (name, count) in [("chain", "SELECT count(*) FROM chain"), ("indexed", "SELECT count(*) FROM indexed")] {
        if connection.query_row(count, [], |row| row.get::<_, i64>(0))? != 1 {
            return Ok(Some(name.to_owned()));
        }
    }
    Ok(None)
}

/// The tables and indexes of a file with how they were made, without those that the database keeps for itself.
fn tables(connection: &Connection) -> rusqlite::Result<BTreeMap<String, Option<String>>> {
    let mut all = connection.prepare(
        "SELECT name, sql FROM sqlite_schema WHERE type IN ('table', 'index') AND name NOT LIKE 'sqlite!_%' ESCAPE '!'",
    )?;
    all.query_map([], |row| Ok((row.get(0)?, row.get(1)?)))?.collect()
}
