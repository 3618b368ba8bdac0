//! Where an entry is found: its row of `find` and its words, and the questions that both answer.

use rusqlite::types::Value;
use rusqlite::{Connection, Row, params};

use crate::journal::ask::Question;
use crate::journal::found::{Found, Kind, folded, words_of};
use crate::verdict::Status;

/// Adds what an entry is found by.
pub(super) fn add(connection: &Connection, number: i64, found: &Found) -> rusqlite::Result<()> {
    let mut insert = connection.prepare_cached(
        "INSERT INTO find(number, at, kind, status, simulated, part, serial, feature, callout, class, who, station, corrects) \
         VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13)",
    )?;
    insert.execute(params![
        number,
        found.at_ms,
        kind(found.kind),
        found.status.map(status),
        found.is_simulated,
        found.part,
        found.serial,
        found.feature,
        found.callout,
        found.class,
        found.who,
        found.station,
        found.corrects.and_then(|number| i64::try_from(number).ok()),
    ])?;
    if !found.words.is_empty() {
        connection
            .prepare_cached("INSERT INTO words(rowid, text) VALUES (?1, ?2)")?
            .execute(params![number, found.words])?;
    }
    Ok(())
}

/// All rows, by number, as [`row`] reads them.
pub(super) const ROWS: &str = "SELECT number, at, kind, status, simulated, part, serial, feature, callout, class, who, station, corrects \
                               FROM find ORDER BY number";

/// A row with its number. Words are not kept in it, only found.
pub(super) fn row(row: &Row<'_>) -> rusqlite::Result<(i64, Found)> {
    let place: Option<usize> = row.get::<_, Option<i64>>(3)?.map(|place| usize::try_from(place).unwrap_or(usize::MAX));
    let found = Found {
        kind: if row.get::<_, i64>(2)? == kind(Kind::Check) { Kind::Check } else { Kind::Withdrawal },
        at_ms: row.get(1)?,
        status: place.and_then(|place| Status::ALL.get(place)).copied(),
        is_simulated: row.get(4)?,
        part: row.get(5)?,
        serial: row.get(6)?,
        feature: row.get(7)?,
        callout: row.get(8)?,
        class: row.get(9)?,
        who: row.get(10)?,
        station: row.get(11)?,
        corrects: row.get::<_, Option<i64>>(12)?.and_then(|number| u64::try_from(number).ok()),
        words: String::new(),
    };
    Ok((row.get(0)?, found))
}

/// The same as a row of the table has it.
pub(super) fn without_words(found: Found) -> Found {
    Found { words: String::new(), ..found }
}

const fn kind(kind: Kind) -> i64 {
    match kind {
        Kind::Check => 1,
        Kind::Withdrawal => 2,
    }
}

fn status(status: Status) -> i64 {
    i64::try_from(status.at()).unwrap_or_default()
}

/// A question as conditions on `find`, with the values for its places.
pub(super) struct Conditions {
    /// Joined by `AND`; `1` where nothing is asked.
    pub(super) sql: String,
    pub(super) values: Vec<Value>,
}

impl Conditions {
    pub(super) fn of(question: &Question) -> Self {
        let mut conditions = Self { sql: "1".to_owned(), values: Vec::new() };
        let folding: fn(&str) -> String = folded;
        let as_it_is: fn(&str) -> String = str::to_owned;
        let whole = [
            ("part", &question.part, folding),
            ("feature", &question.feature, folding),
            ("callout", &question.callout, as_it_is),
            ("class", &question.class, as_it_is),
            ("who", &question.who, folding),
            ("station", &question.station, folding),
        ];
        for (column, asked, kept_as) in whole {
            if let Some(text) = asked {
                conditions.add(&format!("{column} = ?"), [Value::Text(kept_as(text))]);
                // The index leaves out what has none.
                if column == "feature" && !text.is_empty() {
                    conditions.sql.push_str(" AND feature <> ''");
                }
            }
        }
        if let Some(serial) = &question.serial {
            conditions.serial(&folded(serial));
        }
        if !question.verdicts.is_empty() {
            let places = vec!["?"; question.verdicts.len()].join(", ");
            let statuses = question.verdicts.iter().map(|one| Value::Integer(status(*one)));
            conditions.add(&format!("status IN ({places})"), statuses);
        }
        if let Some(from) = question.from_ms {
            conditions.add("at >= ?", [Value::Integer(from)]);
        }
        if let Some(before) = question.before_ms {
            conditions.add("at < ?", [Value::Integer(before)]);
        }
        if let Some(simulated) = question.simulated {
            conditions.add("simulated = ?", [Value::Integer(i64::from(simulated))]);
        }
        if question.standing {
            conditions.sql.push_str(
                " AND kind = 1 AND NOT EXISTS (SELECT 1 FROM find AS other WHERE other.corrects = find.number)",
            );
        }
        conditions.words(&question.words);
        conditions
    }

    fn add(&mut self, sql: &str, values: impl IntoIterator<Item = Value>) {
        self.sql.push_str(" AND ");
        self.sql.push_str(sql);
        self.values.extend(values);
    }

    fn serial(&mut self, serial: &str) {
        match serial.strip_suffix('*') {
            None if serial.is_empty() => self.add("serial = ''", []),
            None => self.add("serial <> '' AND serial = ?", [Value::Text(serial.to_owned())]),
            Some(start) => {
                // Everything that begins so lies before the largest character after it.
                let end = format!("{start}{}", char::MAX);
                let range = [Value::Text(start.to_owned()), Value::Text(end)];
                self.add("serial <> '' AND serial >= ? AND serial < ?", range);
            }
        }
    }

    /// Whole words, of which the last letters of each may be missing. They go in quotation marks, so none of them is an operator.
    fn words(&mut self, texts: &[String]) {
        let words: Vec<String> = texts.iter().flat_map(|text| words_of(text)).collect();
        if !words.is_empty() {
            let wanted: Vec<String> = words.iter().map(|word| format!("\"{word}\"*")).collect();
            self.add("number IN (SELECT rowid FROM words WHERE words MATCH ?)", [Value::Text(wanted.join(" AND "))]);
        } else if texts.iter().any(|text| !text.trim().is_empty()) {
            // Signs alone are in no word.
            self.sql.push_str(" AND 0");
        }
    }
}
