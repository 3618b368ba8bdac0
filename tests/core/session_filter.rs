//! The filter of the table page: what its words choose and mark.

#![cfg(test)]

use fitcheck::length::Length;
use fitcheck::session::tables::Filter;
use fitcheck::tolerance::DeviationTable;
use fitcheck::tolerance::table::Column;

fn table(classes: &str) -> DeviationTable {
    let column = |class: &str| Column { class: class.parse().unwrap(), cells: vec![None; 4] };
    let ends = [3, 6, 18, 30].map(|mm| Length::from_micrometres(mm * 1000)).to_vec();
    DeviationTable::new("own.tab", false, ends, classes.split(' ').map(column).collect()).unwrap()
}

/// The classes that are shown, the ends of the marked rows, and what does not exist.
#[track_caller]
fn check(classes: &str, text: &str, expected: &str) {
    let table = table(classes);
    let filter = Filter::of(text, &table);
    let shown: Vec<_> = filter.columns.iter().map(|&column| table.columns()[column].class.to_string()).collect();
    let rows: Vec<_> = filter.rows.iter().map(|&row| table.ends()[row].to_string()).collect();
    let said = format!("{} | {} | {}", shown.join(" "), rows.join(" "), filter.unmatched.join(" "));
    assert_eq!(said, expected, "for {text:?}");
}

#[test]
fn classes_letters_and_grades_choose_columns() {
    let holes = "H6 H7 JS7 J7 H25";
    check(holes, "", "H6 H7 JS7 J7 H25 |  | ");
    check(holes, "H7", "H7 |  | ");
    check(holes, "H7 js7", "H7 JS7 |  | ");
    check(holes, "h", "H6 H7 H25 |  | ");
    check(holes, "7", "H7 JS7 J7 |  | ");
    check(holes, "j", "J7 |  | ");
    check(holes, "H7, J7;h6", "H6 H7 J7 |  | ");
    check(holes, "g6", " |  | g6");
    check(holes, "H7/g6", "H7 |  | g6");
}

#[test]
fn case_counts_where_it_tells_columns_apart() {
    check("H7 h7 g6", "h7", "h7 |  | ");
    check("H7 h7 g6", "H", "H7 |  | ");
    check("H7 h7 g6", "G6", "g6 |  | ");
}

#[test]
fn a_size_marks_its_row_and_belongs_to_the_range_that_it_ends() {
    let holes = "H6 H7";
    check(holes, "25", "H6 H7 | 30 | ");
    check(holes, "18", "H6 H7 | 18 | ");
    check(holes, "18.000001", "H6 H7 | 30 | ");
    check(holes, "2,5", "H6 H7 | 3 | ");
    check(holes, "7 mm", "H6 H7 | 18 | ");
    check(holes, "7.0", "H6 H7 | 18 | ");
    check(holes, "Ø7", "H6 H7 | 18 | ");
    check(holes, "25 H7", "H7 | 30 | ");
    check(holes, "31", "H6 H7 |  | 31");
    check(holes, "0", "H6 H7 |  | 0");
    check(holes, "-5 ?", "H6 H7 |  | -5 ?");
}
