//! Where an entry is found: its row of `find`, and questions as conditions on it.

use fitcheck_core::verdict::Status;
use fitcheck_exchange::journal::ask::{AskedKinds, Question};
use fitcheck_exchange::journal::found::{FoundEntry, FoundEntryKind, folded};
use rusqlite::types::Value;
use rusqlite::{Connection, Row, params};

use super::number::integer;

/// Adds the row of an entry.
pub(super) fn add(connection: &Connection, number: i64, found: &FoundEntry<'_>) -> rusqlite::Result<()> {
    let mut insert = connection.prepare_cached(
        "INSERT INTO find(number, at, kind, status, simulated, part, serial, feature, callout, class, who, station, corrects) \
         VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13)",
    )?;
    let columns = params![
        number,
        found.at_ms,
        kind(found.kind),
        found.status.map(status),
        found.is_simulated,
        folded(&found.part),
        folded(&found.serial),
        folded(&found.feature),
        found.callout(),
        found.class(),
        folded(&found.who),
        folded(&found.station),
        found.corrects.map(integer),
    ];
    insert.execute(columns).map(drop)
}

/// All rows, by number, as [`row`] reads them.
pub(super) const ROWS: &str = "SELECT number, at, kind, status, simulated, part, serial, feature, callout, class, who, station, corrects \
                               FROM find ORDER BY number";

/// Whether a row finds an entry by what that says. `class` is the entry's.
pub(super) fn is_of(row: &Row<'_>, found: &FoundEntry<'_>, class: &str) -> rusqlite::Result<bool> {
    let text = |column: usize, expected: &str| -> rusqlite::Result<bool> {
        Ok(row.get_ref(column)?.as_str().is_ok_and(|there| there == expected))
    };
    let number = |column: usize, expected: Option<i64>| -> rusqlite::Result<bool> {
        Ok(row.get_ref(column)?.as_i64_or_null().is_ok_and(|there| there == expected))
    };
    Ok(number(1, Some(found.at_ms))?
        && number(2, Some(kind(found.kind)))?
        && number(3, found.status.map(status))?
        && number(4, Some(i64::from(found.is_simulated)))?
        && text(5, &folded(&found.part))?
        && text(6, &folded(&found.serial))?
        && text(7, &folded(&found.feature))?
        && text(8, &found.callout())?
        && text(9, class)?
        && text(10, &folded(&found.who))?
        && text(11, &folded(&found.station))?
        && number(12, found.corrects.map(integer))?)
}

const fn kind(kind: FoundEntryKind) -> i64 {
    match kind {
        FoundEntryKind::Check => 1,
        FoundEntryKind::Withdrawal => 2,
        FoundEntryKind::Report => 3,
        FoundEntryKind::Alarm => 4,
    }
}

/// The number of a status in `find`: it never changes, for journals keep it.
const fn status(status: Status) -> i64 {
    match status {
        Status::Good => 0,
        Status::Rework => 1,
        Status::ReMeasure => 2,
        Status::Scrap => 3,
        Status::OutOfLimits => 4,
    }
}

/// A question, but for its words, as conditions on `find`, with the values for its places.
pub(super) struct Conditions {
    /// Joined by `AND`; `1` where nothing is asked.
    pub(super) sql: String,
    pub(super) values: Vec<Value>,
}

impl Conditions {
    pub(super) fn of(question: &Question) -> Self {
        let mut conditions = Self { sql: "1".to_owned(), values: Vec::new() };
        let names = [
            ("part", &question.part),
            ("feature", &question.feature),
            ("who", &question.who),
            ("station", &question.station),
        ];
        for (column, asked) in names {
            if let Some(text) = asked {
                conditions.add(&format!("{column} = ?"), [Value::Text(folded(text).into_owned())]);
                // The index leaves out what has none.
                if column == "feature" && !text.trim().is_empty() {
                    conditions.sql.push_str(" AND feature <> ''");
                }
            }
        }
        for (column, asked) in [("callout", &question.callout), ("class", &question.class)] {
            if let Some(text) = asked {
                conditions.add(&format!("{column} = ?"), [Value::Text(text.clone())]);
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
        if let Some(is_simulated) = question.simulated {
            // As it is written in the index.
            conditions.add(if is_simulated { "simulated = 1" } else { "simulated = 0 AND kind < 3" }, []);
        }
        match question.kinds {
            AskedKinds::All => {}
            AskedKinds::Checks => conditions.add("kind < 3", []),
            // As it is written in the index.
            AskedKinds::Reports => conditions.add("kind = 3", []),
            AskedKinds::Alarms => conditions.add("kind = 4", []),
        }
        if question.standing {
            // What answers an alarm stands for nothing itself.
            let of_kind = if question.kinds == AskedKinds::Alarms { "corrects IS NULL" } else { "kind = 1" };
            conditions.add(of_kind, []);
            conditions.sql.push_str(" AND NOT EXISTS (SELECT 1 FROM find AS other WHERE other.corrects = find.number)");
        }
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
}
