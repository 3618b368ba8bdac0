//! Limits and verdicts as plain SQL: an engine that holds the measurements judges them where they are.
//!
//! | file | what |
//! |---|---|
//! | `model` | every cell of class and step, from the same sources of limits as everywhere |
//! | `head` | the comment at the top: source, rule, errors, grammar, names |
//! | `decimals` | limits and verdict for engines with exact decimals |
//! | `postgres`, `duckdb`, `spark`, `sqlite` | one dialect each: its tables, how it reads texts, its functions and examples |
//!
//! To add a dialect:
//!
//! 1. Write a file with its `DIALECT`. Add its `mod` line, its line in [`DIALECTS`] and its row above. `decimals` has what engines
//!    with exact decimals share.
//! 2. Add a function that runs it to `ENGINES` in `tests/engines/engines.py`. `tests/core/sql.rs` asks the same names and errors of
//!    every dialect by itself.
//! 3. Add a call of `fitcheck sql` to the corpus and record the answers (`tests/core/corpus.rs`).
//!
//! The command line follows.
//!
//! All steps end at whole millimetres, so a table from each millimetre to its step turns the look-up of a size into
//! equality joins. Texts are checked before they are cast, because casts of the engines round and take too much.
//! The same model gives the same bytes.

mod decimals;
mod duckdb;
mod head;
mod model;
mod postgres;
mod spark;
mod sqlite;

use std::io::{self, Write};

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::Feature;

pub use model::{Cell, Model, SqlError};

/// How one engine writes SQL.
#[derive(Debug, Clone, Copy)]
pub struct Dialect {
    /// The name on the command line.
    pub name: &'static str,
    /// The engine and its oldest version, `PostgreSQL 12 or later`.
    pub engine: &'static str,
    /// How the objects are used: lines of the comment at the top, with an example each.
    usage: &'static str,
    /// The statement that begins a transaction, or nothing.
    begin: &'static str,
    tables: &'static str,
    /// A text as a literal.
    text: fn(&str) -> String,
    /// A deviation as a literal.
    deviation: fn(Length) -> String,
    /// How many rows one statement inserts: engines differ in what they do well.
    rows: usize,
    /// Views and functions.
    views: fn() -> String,
    /// What ends the transaction, or nothing.
    end: &'static str,
}

pub const DIALECTS: &[Dialect] = &[postgres::DIALECT, duckdb::DIALECT, sqlite::DIALECT, spark::DIALECT];

/// The codes in the column `error`, in the order in which they are tested, and what each says.
///
/// The order is that of `fitcheck check`: the callout, its limits, the measured value.
pub const ERRORS: [(&str, &str); 6] = [
    ("callout-not-read", "the callout, or the nominal size or the class, is missing or outside the grammar below"),
    ("nominal-not-positive", "a nominal size of 0 or less"),
    ("class-unknown", "no class of these tables"),
    ("no-limits-at-size", "the class is not defined at this size, or the size is beyond the last step"),
    ("measured-not-read", "the measured value is missing or outside the grammar below"),
    ("measured-not-positive", "a measured value of 0 or less"),
];

/// The codes of a row that has its limits beside it, in the order in which they are tested; the measured value comes last.
pub const LIMIT_ERRORS: [(&str, &str); 3] = [
    ("limits-not-read", "a limit is missing, or finer than a nanometre"),
    ("limits-reversed", "the lower limit is above the upper one"),
    ("feature-unknown", "feature is not hole, shaft or null"),
];

/// What a callout is, as a regular expression without a backslash: the size is its first group, the class its second.
///
/// At most nine figures before the point and six after it, besides zeros: exact nanometres in 15 figures, which every
/// engine's decimal holds in 64 bits. A class is as in [`CLASS`].
pub const CALLOUT: &str = "^ *(-?[0-9]{1,9}(?:[.][0-9]{1,6}0*)?) *\
    ([A-Z][A-Z0-9]{1,7}|[a-z][a-z0-9]{1,7}|[ABDEG-LN-UW-Z]|[abdeg-ln-uw-z]) *$";

/// What a class is: a letter, then letters of the same case and figures, at most eight characters; alone no letter of a
/// general class of ISO 2768-1. A unit is such a name, too, and no class of the tables.
pub const CLASS: &str = "^([A-Z][A-Z0-9]{1,7}|[a-z][a-z0-9]{1,7}|[ABDEG-LN-UW-Z]|[abdeg-ln-uw-z])$";

pub const MEASURED: &str = "^ *(-?[0-9]{1,9}(?:[.][0-9]{1,6}0*)?) *$";

/// Writes the SQL of a model, statement by statement.
///
/// # Errors
/// Those of the stream.
pub fn write(model: &Model, dialect: &Dialect, out: &mut dyn Write) -> io::Result<()> {
    head::write(model, dialect, out)?;
    out.write_all(dialect.begin.as_bytes())?;
    out.write_all(dialect.tables.as_bytes())?;
    let literal = dialect.text;
    let sources = (1..).zip(model.sources()).map(|(number, name)| format!("{number},{}", literal(name)));
    insert("fitcheck_source", sources, dialect.rows, out)?;
    let hole = |feature| if feature == Feature::Hole { "true" } else { "false" };
    let classes = model.classes().iter().map(|class| format!("{},{}", literal(class.as_str()), hole(class.feature())));
    insert("fitcheck_class", classes, dialect.rows, out)?;
    let steps = model.millimetres().map(|(mm, step)| format!("{mm},{step}"));
    insert("fitcheck_step", steps, dialect.rows, out)?;
    let cells = model.cells().iter().map(|cell| {
        let lower = (dialect.deviation)(cell.lower);
        let upper = (dialect.deviation)(cell.upper);
        let Cell { class, step, over_mm, to_mm, source, .. } = cell;
        format!("{},{step},{over_mm},{to_mm},{lower},{upper},{source}", literal(class.as_str()))
    });
    insert("fitcheck_limits", cells, dialect.rows, out)?;
    out.write_all((dialect.views)().as_bytes())?;
    out.write_all(dialect.end.as_bytes())
}

/// Inserts of at most `most` rows each.
fn insert(table: &str, rows: impl Iterator<Item = String>, most: usize, out: &mut dyn Write) -> io::Result<()> {
    let mut before = 0;
    for row in rows {
        match before % most {
            0 if before == 0 => write!(out, "\ninsert into {table} values\n({row})")?,
            0 => write!(out, ";\ninsert into {table} values\n({row})")?,
            _ => write!(out, ",\n({row})")?,
        }
        before += 1;
    }
    if 0 < before { writeln!(out, ";") } else { Ok(()) }
}

/// A literal of standard SQL: quotation marks are doubled.
fn quoted(text: &str) -> String {
    format!("'{}'", text.replace('\'', "''"))
}

/// Millimetres as an exact decimal.
fn millimetres(length: Length) -> String {
    length.to_string()
}
