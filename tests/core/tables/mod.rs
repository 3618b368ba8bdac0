//! The control's tables.
//!
//! | file | what |
//! |---|---|
//! | `shipped` | the built-in tables against ISO 286 |
//! | `reading` | the samples, encodings, BEGIN lines, ends |
//! | `refusing` | everything that can be wrong |
//! | `writing` | round trips, and what cannot be written |
#![expect(
    clippy::string_slice,
    clippy::disallowed_methods,
    reason = "a test may stop, and it writes small files that nobody else reads"
)]

mod reading;
mod refusing;
mod shipped;
mod writing;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use fitcheck::control::deviations::{read_table, to_control_table};
use fitcheck::control::shipped_tables;
use fitcheck::control::table::{
    Column, Comment, CommentPlace, ControlTable, Generation, TableFile, TableUnit, WriteError,
};
use fitcheck::length::{Length, Unit};
use fitcheck::store::tables::read_tables;
use fitcheck::tolerance::table::Column as ClassColumn;
use fitcheck::tolerance::{Callout, DeviationTable, Deviations, Feature, ToleranceClass};
use proptest::prelude::*;

fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn um(text: &str) -> Length {
    Length::parse_in(text, Unit::Micrometre).unwrap()
}

fn sample(name: &str) -> Vec<u8> {
    std::fs::read(root("tests/data/samples/tables").join(name)).unwrap()
}

#[track_caller]
fn check_cell(table: &DeviationTable, callout: &str, upper: &str, lower: &str) {
    let tables = fitcheck::tolerance::Sources::of_tables(vec![table.clone()]);
    let limits = tables.limits(&callout.parse().unwrap(), None).unwrap();
    assert_eq!((limits.deviations.upper(), limits.deviations.lower()), (um(upper), um(lower)), "{callout}");
}

/// A small table as text, to be damaged.
const SOUND: &str = "\
BEGIN own.tab
NR  BEREICH H7     U1
0   3       +10    +8
1           +0     +3
2   6       +12    -
3           +0     -
[END]
";

#[track_caller]
fn check(text: &str, expected: &[&str]) {
    check_bytes(text.as_bytes(), expected);
}

/// The messages about a table: its warnings, or its error after a `!`.
#[track_caller]
fn check_bytes(bytes: &[u8], expected: &[&str]) {
    let said: Vec<String> = match read_table(bytes, "own.tab", "own.tab", false) {
        Ok((table, warnings)) => {
            assert!(table.is_some() || !warnings.is_empty());
            warnings.iter().map(ToString::to_string).collect()
        }
        Err(error) => vec![format!("! {error}")],
    };
    assert_eq!(said, expected, "for {:?}", String::from_utf8_lossy(&bytes[..bytes.len().min(400)]));
}
