//! Files as shops have them, ten or more for each format, and the ways that a file takes through the program: `import`, `plan convert`,
//! `import --plan`, `watch`, `batch`, the check page and the walk through a part. All of them have the values and verdicts of a table that
//! a person wrote beside the files, in `tests/data/field`.
//!
//! | file | what |
//! |---|---|
//! | here | the tests, one for each format |
//! | `case` | a file and the table of what is right of it |
//! | `place` | a file in a folder of its own, for the tests of `field_files` |
//! | `contacts` | files of contacts |
//! | `points` | logs of points in 3-D |
//! | `ways` | the ways, each as the program goes it |

mod case;
mod contacts;
pub(crate) mod place;
mod points;
mod ways;

use case::{Case, Row, cases};
use ways::{by_batch, by_command_line, by_watch, by_window};

/// Every file of a format goes every way, and there are at least this many files.
#[track_caller]
fn check(format: &str, count: usize) {
    let only = std::env::var("FIELD_FILE").ok();
    let cases: Vec<Case> =
        cases(format).into_iter().filter(|case| only.as_ref().is_none_or(|only| *only == case.name)).collect();
    assert!(count <= cases.len() || only.is_some(), "{format}: {} files", cases.len());
    let mut faults = Vec::new();
    for case in &cases {
        by_command_line(case, &mut faults);
        by_window(case, &mut faults);
    }
    by_watch(&cases, &mut faults);
    assert!(faults.is_empty(), "{} of {format}:\n{}", faults.len(), faults.join("\n"));
}

/// `batch` has the verdicts of the table; what it refuses as a whole has no verdict that it could get wrong.
#[track_caller]
fn check_batch(cases: &[Case], of: impl Fn(&Case) -> Option<(String, Vec<u8>)>, count: usize) {
    let mut faults = Vec::new();
    let mut judged = 0;
    for case in cases {
        let Some((name, bytes)) = of(case) else { continue };
        let said = match by_batch(&name, &bytes) {
            Ok(said) => said,
            Err(why) => {
                let is_refused =
                    ["side by side", "may each be the measured value"].iter().any(|words| why.contains(words));
                if !is_refused {
                    faults.push(format!("{name} by batch: {why}"));
                }
                continue;
            }
        };
        judged += 1;
        let row = |row: &Row| Row {
            name: String::new(),
            measured: None,
            limits: row.limits,
            verdict: row.verdict.clone(),
            callout: String::new(),
            by_plan: String::new(),
        };
        let rows: Vec<Row> = case.rows.iter().map(row).collect();
        case.check(&format!("batch of {name}"), &rows.iter().collect::<Vec<_>>(), &said, &mut faults);
    }
    assert!(faults.is_empty(), "{}:\n{}", faults.len(), faults.join("\n"));
    assert!(count <= judged, "{judged} files");
}

#[test]
fn tables_are_the_same_by_batch() {
    check_batch(&cases("csv"), |case| Some((case.name.clone(), case.bytes.clone())), 10);
}

/// The tables whose first line is their header, as columns of texts and as columns of numbers.
#[cfg(feature = "parquet")]
#[test]
fn typed_columns_are_the_same_by_batch() {
    for are_typed in [false, true] {
        let of = |case: &Case| {
            let text = String::from_utf8(case.bytes.clone()).ok()?;
            let mut lines = text.lines().filter(|line| !line.contains('"'));
            let separator = if text.contains(';') { ';' } else { ',' };
            let names: Vec<&str> = lines.next()?.split(separator).collect();
            let rows: Vec<Vec<&str>> = lines.map(|line| line.split(separator).collect()).collect();
            let is_plain = rows.iter().all(|row| row.len() == names.len() && row.iter().any(|cell| !cell.is_empty()));
            let has_names = names.iter().all(|name| !name.is_empty() && !name.contains('\u{feff}'));
            // Values in cells as they are: a decimal comma in a column of texts is one.
            let is_whole = text.lines().count() == rows.len() + 1 && is_plain && has_names && text.ends_with('\n');
            let bytes = is_whole.then(|| crate::parquet::of_table(&names, &rows, are_typed).to_vec())?;
            Some((case.name.replace(".csv", ".parquet"), bytes))
        };
        check_batch(&cases("csv"), of, 9);
    }
}

#[test]
fn tables_are_the_same_in_every_way() {
    check("csv", 10);
}

#[test]
fn workbooks_are_the_same_in_every_way() {
    check("xlsx", 10);
}

#[test]
fn files_of_q_das_are_the_same_in_every_way() {
    check("aqdef", 10);
}

#[test]
fn qif_is_the_same_in_every_way() {
    check("qif", 10);
}

#[test]
fn tables_of_calypso_are_the_same_in_every_way() {
    check("calypso", 10);
}

#[test]
fn reports_of_pc_dmis_are_the_same_in_every_way() {
    check("pcdmis", 10);
}

#[test]
fn prints_of_probing_macros_are_the_same_in_every_way() {
    check("probed", 10);
}

#[test]
fn logs_of_a_control_are_the_same_in_every_way() {
    check("logs", 10);
}

#[test]
fn prints_of_a_mask_are_the_same_in_every_way() {
    check("fn16", 10);
}

#[test]
fn printed_reports_of_calypso_are_the_same_in_every_way() {
    check("protocol", 10);
}

#[test]
fn tolerances_of_geopak_are_the_same_in_every_way() {
    check("geopak", 10);
}

#[test]
fn lines_of_gauges_are_the_same_in_every_way() {
    check("gauge", 10);
}
