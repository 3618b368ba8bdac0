//! Tables that are edited and tables that are made from the standard.

use fitcheck::length::Length;
use fitcheck::tolerance::compare::compare;
use fitcheck::tolerance::iso286;
use fitcheck::tolerance::table::{Column, TableShapeError};
use fitcheck::tolerance::table_edit::{MakeError, TableEdit, standard_column, standard_table, table_of_standard};
use fitcheck::tolerance::{DeviationTable, Deviations, ToleranceClass};
use proptest::prelude::*;

/// How many steps can be undone.
const UNDO_STEPS: usize = 200;

fn classes(text: &str) -> Vec<ToleranceClass> {
    text.split_whitespace().map(|class| class.parse().unwrap()).collect()
}

fn made(text: &str, to: &str) -> Result<DeviationTable, MakeError> {
    standard_table("own.tab", &classes(text), to.parse().unwrap(), iso286::Options::default())
}

fn pair(um: i32) -> Option<Deviations> {
    Deviations::new(Length::from_micrometres(um), Length::ZERO).ok()
}

#[test]
fn every_change_can_be_taken_back_and_done_again() {
    let mut edit = TableEdit::new(made("H7", "6").unwrap());
    let h7 = classes("H7")[0];
    assert!(!edit.undo() && !edit.redo() && !edit.is_changed() && !edit.can_undo());
    let pair = Deviations::new(Length::from_micrometres(11), Length::ZERO).unwrap();
    assert!(edit.set(h7, 0, Some(pair)) && edit.can_undo());
    assert!(!edit.set(h7, 0, Some(pair)), "nothing changes");
    assert!(!edit.set(h7, 9, Some(pair)) && !edit.set(classes("H8")[0], 0, Some(pair)));
    let h8 = standard_column(classes("H8")[0], edit.table().ends(), iso286::Options::default());
    edit.add_column(h8.clone()).unwrap();
    assert_eq!(edit.add_column(h8.clone()), Err(TableShapeError::Twice { class: h8.class }));
    assert!(edit.remove_column(h7) && !edit.remove_column(h7));
    let last = edit.table().clone();
    assert!(edit.undo() && edit.undo() && edit.undo() && !edit.undo());
    assert!(!edit.is_changed() && edit.can_redo());
    assert!(edit.redo() && edit.redo() && edit.redo() && !edit.redo());
    assert_eq!(*edit.table(), last);
    edit.undo();
    edit.set(h7, 1, None);
    assert!(!edit.can_redo(), "a change ends what could be done again");
}

#[test]
fn undo_forgets_the_oldest_steps() {
    let mut edit = TableEdit::new(made("H7", "6").unwrap());
    for um in 0..i32::try_from(UNDO_STEPS).unwrap() + 50 {
        let pair = Deviations::new(Length::from_micrometres(um + 20), Length::ZERO).unwrap();
        assert!(edit.set(classes("H7")[0], 0, Some(pair)));
    }
    let steps = std::iter::from_fn(|| edit.undo().then_some(())).count();
    assert_eq!(steps, UNDO_STEPS);
}

#[test]
fn a_shipped_table_is_one_while_it_holds_what_was_shipped() {
    let own = made("H7 H8", "6").unwrap();
    let shipped = DeviationTable::new("82553_hole.tab", true, own.ends().to_vec(), own.columns().to_vec()).unwrap();
    let mut edit = TableEdit::new(shipped.clone());
    edit.set(classes("H7")[0], 0, None);
    assert!(!edit.table().shipped() && edit.undo());
    assert_eq!(*edit.table(), shipped);
}

proptest! {
    /// Any changes, then all the way back and forth: every state between occurs again.
    #[test]
    fn undo_and_redo_meet_every_state(steps in proptest::collection::vec((0..4_u8, 0..3_usize, 0..3_i32), 0..60)) {
        let names = classes("H7 H8 H9");
        let mut edit = TableEdit::new(made("H7 H8 H9", "6").unwrap());
        let mut states = vec![edit.table().clone()];
        for (kind, number, um) in steps {
            let class = names[number];
            let changed = match kind {
                0 => edit.set(class, 0, pair(um)),
                1 => edit.set(class, 1, None),
                2 => edit.remove_column(class),
                _ => edit.add_column(Column { class, cells: vec![pair(um); 2] }).is_ok(),
            };
            prop_assert_eq!(changed, states.last() != Some(edit.table()));
            if changed {
                states.push(edit.table().clone());
            }
        }
        for state in states.iter().rev().skip(1) {
            prop_assert!(edit.undo());
            prop_assert_eq!(edit.table(), state);
        }
        prop_assert!(!edit.can_undo() && !edit.is_changed());
        for state in states.iter().skip(1) {
            prop_assert!(edit.redo());
            prop_assert_eq!(edit.table(), state);
        }
        prop_assert!(!edit.can_redo());
    }
}

#[track_caller]
fn check(text: &str, to: &str, ends: &str) {
    let table = made(text, to).unwrap();
    let found: Vec<String> = table.ends().iter().map(ToString::to_string).collect();
    assert_eq!(found.join(" "), ends, "for {text} to {to}");
    assert_eq!(compare(&table, iso286::Options::default()).differences, []);
}

#[test]
fn a_table_has_the_ranges_that_its_classes_need() {
    check("H7 H8", "50", "3 6 10 18 30 50");
    check("H7 R7", "80", "3 6 10 18 30 50 65 80");
    check("N9", "10", "1 3 6 10");
    check("h6", "12.5", "3 6 10 12.5");
    check("H7", "3150", "3 6 10 18 30 50 80 120 180 250 315 400 500 630 800 1000 1250 1600 2000 2500 3150");
}

#[test]
fn what_cannot_be_made_is_refused() {
    for (text, to, expected) in [
        ("", "50", "no tolerance class is given: name one or more, such as H7 H8 JS9"),
        (
            "H7 g6",
            "50",
            "H7 and g6 cannot be in one table: only the case of their letters differs, so make one table for holes and \
             one for shafts",
        ),
        ("H7", "0", "the last size is 0 mm: it must be above 0 and at most 3150 mm"),
        ("H7", "3150.000001", "the last size is 3150.000001 mm: it must be above 0 and at most 3150 mm"),
        ("T7", "24", "T7 is not defined at 24 mm in ISO 286; it is defined over 24 up to 3150 mm"),
        ("H7 H7", "24", "column H7 occurs twice"),
    ] {
        assert_eq!(made(text, to).unwrap_err().to_string(), expected);
    }
}

#[test]
fn given_ranges_end_with_the_standard_and_leave_a_cell_empty_that_has_no_one_value() {
    let made = |text: &str, ends: &str| {
        let ends = ends.split(' ').map(|end| end.parse().unwrap()).collect();
        table_of_standard("own.tab", &classes(text), ends, iso286::Options::default())
    };
    let refused = |text: &str, ends: &str| made(text, ends).unwrap_err().to_string();
    let why = "the last size is 3150.000001 mm: it must be above 0 and at most 3150 mm";
    assert_eq!(refused("H7", "3 3150.000001"), why);
    assert_eq!(refused("H7", "0 3"), "size range up to 0 mm does not end above the one before it, 0 mm");
    let why = "T6 is not defined at 20 mm in ISO 286; it is defined over 24 up to 3150 mm";
    assert_eq!(refused("R6 T6", "20"), why, "R6 is defined and merely has no one value");
    let cells = |text: &str, ends: &str| -> Vec<_> {
        made(text, ends).unwrap().columns()[0].cells.iter().map(Option::is_some).collect()
    };
    assert_eq!(cells("H7", "0.5 1 2.5 3"), [true; 4]);
    assert_eq!(cells("A11", "1 3"), [false, true]);
    assert_eq!(cells("A11", "3 6"), [false, true], "not for the whole of the first range");
    assert_eq!(cells("R6", "3 50 80"), [true, false, false], "more than one value");
}
