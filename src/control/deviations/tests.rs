//! Unit tests: the texts of every error. What is read and refused is tested on files, in `tests/core/tables.rs`.

use super::*;
use crate::message::Say;
use crate::tolerance::DeviationsError;
use crate::words::{Language, Words};

#[track_caller]
fn said_in_both_languages(what: &(impl Say + std::fmt::Display)) {
    assert_eq!(Words::new(Language::En).told(what), what.to_string());
    let dutch = Words::new(Language::Nl).told(what);
    assert!(dutch != what.message().id && dutch != what.to_string(), "{dutch}");
}

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn at<T>(what: T) -> Located<T> {
    Located { what, place: Place { file: "own.tab".into(), line: 5, column: 13 } }
}

#[test]
fn every_fault_is_said_in_english_and_in_dutch() {
    let class: ToleranceClass = "H7".parse().unwrap();
    for what in [
        DeviationFault::TwoRangeColumns,
        DeviationFault::Inch,
        DeviationFault::NoClass,
        DeviationFault::OddRows { rows: 3 },
        DeviationFault::NoRange,
        DeviationFault::OtherRange { end: mm("6.5"), found: mm("-5.5") },
        DeviationFault::Number { column: "H7".to_owned(), error: LengthError::NotANumber { text: "x".to_owned() } },
        DeviationFault::Half { class, end: mm("6.5") },
        DeviationFault::Order { class, error: DeviationsError { upper: mm("-0.002"), lower: mm("0") } },
        DeviationFault::Touches { column: "H7".to_owned() },
        DeviationFault::Shape(TableShapeError::NoRanges),
    ] {
        said_in_both_languages(&at(what));
    }
}

#[test]
fn errors_and_warnings_are_said_in_english_and_in_dutch() {
    use crate::control::table::{TableDoubt, TableFault};
    said_in_both_languages(&DeviationError::NoTables { folder: "tables".into() });
    said_in_both_languages(&DeviationError::Table(at(TableFault::Empty)));
    said_in_both_languages(&DeviationError::Content(at(DeviationFault::Inch)));
    said_in_both_languages(&DeviationError::File(FileError::Missing { path: "none".into() }));
    said_in_both_languages(&DeviationWarning::NoDeviations { file: "tool.tab".to_owned() });
    said_in_both_languages(&DeviationWarning::Table(at(TableDoubt::NoEnd)));
    for what in [
        DeviationDoubt::RangeAlias,
        DeviationDoubt::NoNumbers { name: "U1".to_owned() },
        DeviationDoubt::MixedCase { name: "Js7".to_owned() },
    ] {
        said_in_both_languages(&DeviationWarning::Content(at(what)));
    }
}

#[test]
fn the_shipped_tables_can_be_read_without_a_warning() {
    let files = || shipped::TABLES.iter().filter(|(name, _)| name.ends_with(".tab"));
    for (name, bytes) in files() {
        let (table, warnings) = read_table(bytes, name, name, true).unwrap();
        assert!(table.is_some() && warnings.is_empty(), "{name}: {warnings:?}");
    }
    assert_eq!(shipped_tables().len(), files().count());
}
