//! Where a report is found: its rows of `report` and `reported`, made from what its entry says.

use fitcheck_exchange::journal::found::{FoundEntry, FoundReport, folded};
use rusqlite::{Connection, params};

use super::number::{integer, natural};

/// Adds the rows of an entry that is a report.
pub(super) fn add(connection: &Connection, number: i64, found: &FoundEntry<'_>) -> rusqlite::Result<()> {
    let Some(report) = &found.report else { return Ok(()) };
    let mut insert = connection.prepare_cached("INSERT INTO report(number, sha256, name) VALUES (?1, ?2, ?3)")?;
    insert.execute(params![number, report.sha256.0, folded(&report.name)])?;
    let mut insert = connection.prepare_cached("INSERT INTO reported(report, first, last) VALUES (?1, ?2, ?3)")?;
    for [first, last] in report.checks.ranges() {
        insert.execute(params![number, integer(*first), integer(*last)])?;
    }
    Ok(())
}

/// Whether a report is found by what its entry says.
pub(super) fn agrees(connection: &Connection, number: i64, report: &FoundReport<'_>) -> rusqlite::Result<bool> {
    let mut file = connection.prepare_cached("SELECT sha256, name FROM report WHERE number = ?1")?;
    let mut rows = file.query([number])?;
    let is_file = match rows.next()? {
        Some(row) => {
            row.get_ref(0)?.as_blob().is_ok_and(|there| there == report.sha256.0)
                && row.get_ref(1)?.as_str().is_ok_and(|there| there == folded(&report.name))
        }
        None => false,
    };
    let mut checks = connection.prepare_cached("SELECT first, last FROM reported WHERE report = ?1 ORDER BY first")?;
    let there: Vec<[i64; 2]> =
        checks.query_map([number], |row| Ok([row.get(0)?, row.get(1)?]))?.collect::<Result<_, _>>()?;
    Ok(is_file && report.checks.ranges().iter().map(|range| range.map(integer)).eq(there))
}

/// How many rows tell of reports that are none.
pub(super) fn without_report(connection: &Connection) -> rusqlite::Result<u64> {
    let sql = "SELECT (SELECT count(*) FROM report WHERE number NOT IN (SELECT number FROM find WHERE kind = 3)) \
               + (SELECT count(DISTINCT report) FROM reported WHERE report NOT IN (SELECT number FROM find WHERE kind = 3))";
    connection.query_row(sql, [], |row| row.get(0).map(natural))
}
