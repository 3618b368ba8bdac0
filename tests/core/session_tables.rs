//! The table page without a window: what is open, what differs, and what an edit does.

#![cfg(test)]

use std::path::{Path, PathBuf};

use fitcheck::control::deviations::read_table;
use fitcheck::session::tables::{Document, Origin, TableChoice};
use fitcheck::session::{CheckField, Command, Effect, Field, Page, Purpose, Session, Step, TablesCommand, TablesField};
use fitcheck::tolerance::DeviationTable;
use fitcheck::tolerance::iso286::{JsHalves, Options};
use fitcheck::words::{Language, Words};
use jiff::civil::{DateTime, date};

fn now() -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0)
}

fn session() -> Session {
    let mut session = Session::new(Language::En);
    session.apply(Command::OpenPage(Page::Tables), now());
    session
}

fn send(session: &mut Session, command: TablesCommand) {
    session.apply(Command::Tables(command), now());
}

fn type_text(session: &mut Session, field: impl Into<Field>, text: &str) {
    session.apply(field.into().typed(text.to_owned()), now());
}

fn shown(session: &Session) -> &Document {
    session.tables().shown().unwrap()
}

fn select(session: &mut Session, class: &str, range: usize) {
    send(session, TablesCommand::Select(class.parse().unwrap(), range));
}

/// The selected cell, `H7 18 30 +21/0`.
fn selected(session: &Session) -> String {
    let (class, range) = shown(session).selected.unwrap();
    let (over, to) = shown(session).range(range).unwrap();
    let words = Words::new(Language::En);
    let cell = shown(session).cell(class, range);
    let cell =
        cell.map_or("-".into(), |cell| format!("{}/{}", words.signed_um(cell.upper()), words.signed_um(cell.lower())));
    format!("{class} {over} {to} {cell}")
}

fn error(session: &Session, field: TablesField) -> Option<String> {
    session.error(field).map(|error| Words::new(Language::En).say(error))
}

/// A table of the standard, then changed in its cells.
fn made(session: &mut Session, classes: &str, to: &str) {
    type_text(session, TablesField::Classes, classes);
    type_text(session, TablesField::To, to);
    send(session, TablesCommand::Make);
}

#[test]
fn the_built_in_tables_are_open_and_differ_nowhere() {
    let session = session();
    let titles: Vec<_> = session.tables().documents.iter().map(|document| document.title.as_str()).collect();
    assert_eq!(titles, ["82553_hole.tab", "82553_shaft.tab"]);
    for document in &session.tables().documents {
        let cells = document.table().columns().len() * document.table().ends().len();
        assert_eq!((document.differing(), document.comparison.compared), (0, cells), "{}", document.title);
        assert!(!document.is_unsaved());
    }
    assert_eq!(selected(&session), "D10 0 1 +60/+20");
}

#[test]
fn nothing_is_read_before_the_page_is_opened() {
    let mut session = Session::new(Language::En);
    assert!(session.tables().shown().is_none());
    for command in [
        TablesCommand::Move(Step::Down),
        TablesCommand::SetCell,
        TablesCommand::EmptyCell,
        TablesCommand::Undo,
        TablesCommand::AddColumns,
        TablesCommand::RemoveColumn,
        TablesCommand::NextDifference,
        TablesCommand::Use,
        TablesCommand::Open(TableChoice::Document(7)),
        TablesCommand::Open(TableChoice::Own(0)),
    ] {
        send(&mut session, command);
    }
    assert!(session.tables().shown().is_none());
}

#[test]
fn steps_end_at_the_edges_and_stay_among_the_shown_classes() {
    let mut session = session();
    for (step, expected) in [
        (Step::Left, "D10 0 1 +60/+20"),
        (Step::Up, "D10 0 1 +60/+20"),
        (Step::Right, "E9 0 1 +39/+14"),
        (Step::PageDown, "E9 100 120 +159/+72"),
        (Step::Bottom, "E9 355 400 +265/+125"),
        (Step::Down, "E9 355 400 +265/+125"),
        (Step::Last, "R7 355 400 \u{2212}93/\u{2212}150"),
        (Step::Right, "R7 355 400 \u{2212}93/\u{2212}150"),
        (Step::Top, "R7 0 1 \u{2212}10/\u{2212}20"),
        (Step::First, "D10 0 1 +60/+20"),
    ] {
        send(&mut session, TablesCommand::Move(step));
        assert_eq!(selected(&session), expected, "{step:?}");
    }
    type_text(&mut session, TablesField::Filter, "25 H7 JS7");
    assert_eq!(selected(&session), "H7 18 30 +21/0", "the filter leads to its cell");
    send(&mut session, TablesCommand::Move(Step::Right));
    assert_eq!(selected(&session), "JS7 18 30 +10.5/\u{2212}10.5");
    send(&mut session, TablesCommand::Move(Step::Right));
    assert_eq!(selected(&session), "JS7 18 30 +10.5/\u{2212}10.5");
}

#[test]
fn an_edit_of_a_built_in_table_leaves_it_as_it_is() {
    let mut session = session();
    let before = shown(&session).table().clone();
    select(&mut session, "H7", 5);
    type_text(&mut session, TablesField::CellUpper, "+21.001");
    send(&mut session, TablesCommand::SetCell);
    let copy = shown(&session);
    assert_eq!((copy.title.as_str(), copy.origin, copy.is_unsaved()), ("82553_hole_copy.tab", Origin::Copy, true));
    assert_eq!(copy.differing_cells().collect::<Vec<_>>().len(), 1, "a nanometre counts");
    assert_eq!(session.tables().documents[0].table(), &before);
    send(&mut session, TablesCommand::Undo);
    assert_eq!((selected(&session).as_str(), shown(&session).is_unsaved()), ("H7 18 30 +21/0", false));
    send(&mut session, TablesCommand::Redo);
    assert_eq!(selected(&session), "H7 18 30 +21.001/0");
    // A second copy has a name of its own; what was shown keeps its edits.
    send(&mut session, TablesCommand::Open(TableChoice::Document(0)));
    send(&mut session, TablesCommand::EmptyCell);
    assert_eq!(shown(&session).title, "82553_hole_copy_2.tab");
    send(&mut session, TablesCommand::Open(TableChoice::Document(2)));
    assert_eq!(selected(&session), "H7 18 30 +21.001/0");
}

#[test]
fn what_was_typed_is_never_dropped_when_another_cell_is_selected() {
    let mut session = session();
    made(&mut session, "H7", "30");
    type_text(&mut session, TablesField::CellUpper, "11");
    send(&mut session, TablesCommand::Move(Step::Down));
    send(&mut session, TablesCommand::Move(Step::Up));
    assert_eq!(selected(&session), "H7 0 3 +11/0");
    type_text(&mut session, TablesField::CellLower, "12");
    send(&mut session, TablesCommand::Move(Step::Down));
    assert_eq!(selected(&session), "H7 0 3 +11/0");
    assert_eq!(
        error(&session, TablesField::CellUpper).as_deref(),
        Some("upper deviation +11 µm is below lower deviation +12 µm")
    );
    send(&mut session, TablesCommand::RevertCell);
    assert_eq!((error(&session, TablesField::CellUpper), session.text(TablesField::CellLower)), (None, "0"));
    for (text, expected) in [
        ("11", None),
        ("x", Some("x is not a number")),
        ("0.0001", Some("0.0001 is finer than a nanometre")),
        ("1.234,5", Some("1.234,5 is ambiguous: write one decimal sign and no thousands separator")),
    ] {
        type_text(&mut session, TablesField::CellUpper, text);
        assert_eq!(error(&session, TablesField::CellUpper).as_deref(), expected, "{text}");
    }
    // Both empty is an empty cell, one alone is not.
    type_text(&mut session, TablesField::CellUpper, "");
    send(&mut session, TablesCommand::SetCell);
    assert_eq!(error(&session, TablesField::CellUpper).as_deref(), Some("a length is missing"));
    type_text(&mut session, TablesField::CellLower, " ");
    send(&mut session, TablesCommand::SetCell);
    assert_eq!(selected(&session), "H7 0 3 -");
}

#[test]
fn a_range_over_several_steps_differs_in_each_and_counts_once() {
    let (table, _) = read_table(
        b"BEGIN own.tab MM\r\nNR BEREICH r6  \r\n0  50         \r\n1             \r\n2  80      +60\r\n3          +41\r\n[END]\r\n",
        "own.tab",
        "own.tab",
        false,
    )
    .unwrap();
    let mut session = session();
    let read = TablesCommand::Read { name: "own.tab".into(), result: Ok((Box::new(table.unwrap()), vec![])) };
    send(&mut session, read);
    let document = shown(&session);
    assert_eq!((document.differing(), document.comparison.compared), (2, 2));
    assert_eq!((document.differences(0, 0).len(), document.differences(0, 1).len()), (6, 1));
    assert_eq!(document.standard("r6".parse().unwrap(), 1), None, "the standard changes at 65 mm");
    send(&mut session, TablesCommand::NextDifference);
    assert_eq!(selected(&session), "r6 50 80 +60/+41");
    send(&mut session, TablesCommand::TakeStandard);
    assert_eq!(selected(&session), "r6 50 80 +60/+41", "there is no one value to take");
}

#[test]
fn the_options_of_the_standard_count_at_once() {
    let mut session = session();
    assert_eq!(shown(&session).differing(), 0);
    session.apply(Command::SetStandard(Options { js: JsHalves::Rounded, ..Options::default() }), now());
    let found: Vec<_> = shown(&session).comparison.differences.iter().map(|one| one.class.to_string()).collect();
    assert!(!found.is_empty() && found.iter().all(|class| class.starts_with("JS")), "{found:?}");
    type_text(&mut session, TablesField::Filter, "H7");
    send(&mut session, TablesCommand::NextDifference);
    assert!(selected(&session).starts_with("JS7"), "{}", selected(&session));
    assert_eq!(session.text(TablesField::Filter), "", "a hidden difference ends the filter");
}

#[test]
fn tables_and_columns_that_cannot_be_are_refused_beside_their_field() {
    let mut session = session();
    for (classes, to, field, expected) in [
        ("", "50", TablesField::Classes, "a tolerance class is missing, such as H7 for a hole or h7 for a shaft"),
        (
            "H7 x",
            "50",
            TablesField::Classes,
            "x is not an ISO 286 tolerance class: write letters and a grade, such as H7 or js13",
        ),
        ("H7", "0", TablesField::To, "the last size is 0 mm: it must be above 0 and at most 3150 mm"),
        (
            "H7",
            "3150.000001",
            TablesField::To,
            "the last size is 3150.000001 mm: it must be above 0 and at most 3150 mm",
        ),
        ("H7", "", TablesField::To, "a length is missing"),
        (
            "T7",
            "24",
            TablesField::Classes,
            "T7 is not defined at 24 mm in ISO 286; it is defined over 24 up to 3150 mm",
        ),
    ] {
        made(&mut session, classes, to);
        assert_eq!(error(&session, field).as_deref(), Some(expected));
        assert_eq!(session.tables().documents.len(), 2);
    }
    made(&mut session, "H7 g6", "50");
    assert!(error(&session, TablesField::Classes).unwrap().starts_with("H7 and g6 cannot be in one table"));
    made(&mut session, "h7, g6/h7", "50");
    assert_eq!((shown(&session).title.as_str(), shown(&session).is_unsaved()), ("iso286_shaft.tab", true));
    assert_eq!(shown(&session).differing(), 0);
    type_text(&mut session, TablesField::Classes, "H6");
    send(&mut session, TablesCommand::AddColumns);
    assert!(error(&session, TablesField::Classes).unwrap().starts_with("H6 and h7 cannot be in one table"));
}

#[test]
fn removing_the_last_column_leaves_an_empty_table_that_can_be_undone() {
    let mut session = session();
    made(&mut session, "H7", "30");
    send(&mut session, TablesCommand::RemoveColumn);
    assert_eq!((shown(&session).selected, session.text(TablesField::CellUpper)), (None, ""));
    for command in [TablesCommand::Move(Step::Down), TablesCommand::SetCell, TablesCommand::EmptyCell] {
        send(&mut session, command);
    }
    send(&mut session, TablesCommand::Undo);
    assert_eq!(selected(&session), "H7 0 3 +10/0");
}

/// Confirms the dialog and answers as the outside world would; returns the bytes.
fn save(session: &mut Session, format: usize, path: &str) -> Option<Vec<u8>> {
    session.apply(Command::OpenDialog(Purpose::SaveTable(format)), now());
    session.apply(Command::TypePath(path.to_owned()), now());
    let effects = session.apply(Command::Confirm, now());
    let Some(Effect::Save(path, content)) = effects.first().map(Effect::errand) else { return None };
    let (path, bytes): (PathBuf, Vec<u8>) = (path.clone(), content.bytes().unwrap());
    let number = session.dialog()?.number;
    session.apply(Command::Answered(number, Box::new(Command::Saved { path, result: Ok(()) })), now());
    Some(bytes)
}

fn read(bytes: &[u8]) -> DeviationTable {
    read_table(bytes, "saved.tab", "saved.tab", false).unwrap().0.unwrap()
}

#[test]
fn a_table_is_saved_under_its_files_name_and_an_export_saves_nothing() {
    let mut session = session();
    made(&mut session, "H7", "30");
    type_text(&mut session, TablesField::CellUpper, "11");
    let csv = save(&mut session, 3, "/shop/holes.csv").unwrap();
    assert!(String::from_utf8(csv).unwrap().contains("H7,0,3,11,0"), "what was typed counts");
    assert!(shown(&session).is_unsaved(), "a CSV cannot be opened again");
    let table = save(&mut session, 0, "/shop/my holes.tab").unwrap();
    assert!(table.starts_with(b"BEGIN my_holes.tab"), "a control ends the name at a blank");
    assert_eq!(read(&table).columns(), shown(&session).table().columns());
    assert_eq!((shown(&session).title.as_str(), shown(&session).is_unsaved()), ("my holes.tab", false));
    send(&mut session, TablesCommand::Undo);
    assert!(shown(&session).is_unsaved(), "another table than the saved one");
    send(&mut session, TablesCommand::Redo);
    assert!(!shown(&session).is_unsaved());
}

#[test]
fn a_table_that_a_control_refuses_or_that_cannot_be_read_is_not_saved() {
    let mut session = session();
    assert_eq!(save(&mut session, 2, "/shop/82553_hole.tab"), None, "a TNC7 wants a letter first");
    let problem = session.dialog().and_then(|dialog| dialog.problem.clone()).unwrap();
    assert!(Words::new(Language::En).say(&problem).contains("does not begin with a letter"));
    session.apply(Command::Close, now());
    type_text(&mut session, TablesField::CellUpper, "x");
    assert_eq!(save(&mut session, 0, "/shop/own.tab"), None);
    assert!(session.dialog().unwrap().problem.is_some());
}

#[test]
fn a_table_saved_while_another_one_is_shown_is_the_one_that_was_saved() {
    let mut session = session();
    made(&mut session, "H7", "30");
    session.apply(Command::OpenDialog(Purpose::SaveTable(0)), now());
    session.apply(Command::TypePath("/shop/own.tab".into()), now());
    session.apply(Command::Confirm, now());
    send(&mut session, TablesCommand::EmptyCell);
    send(&mut session, TablesCommand::Open(TableChoice::Document(0)));
    session.apply(Command::Saved { path: Path::new("/shop/own.tab").to_owned(), result: Ok(()) }, now());
    let saved = &session.tables().documents[2];
    assert_eq!((saved.title.as_str(), saved.is_unsaved()), ("own.tab", true), "the later edit is in no file");
    assert_eq!(session.tables().documents[0].title, "82553_hole.tab");
}

#[test]
fn a_used_table_comes_first_and_its_later_edits_count_at_once() {
    let mut session = session();
    type_text(&mut session, CheckField::Callout, "25 H7");
    made(&mut session, "H7", "30");
    select(&mut session, "H7", 4);
    type_text(&mut session, TablesField::CellUpper, "25");
    send(&mut session, TablesCommand::Use);
    let maximum = |session: &Session| session.check().asked.limits.as_ref().unwrap().maximum().to_string();
    assert_eq!((maximum(&session).as_str(), session.tables().is_used(session.sources())), ("25.025", true));
    type_text(&mut session, TablesField::CellUpper, "26");
    send(&mut session, TablesCommand::SetCell);
    // A record would name the table: it must be the one that is in sight.
    assert_eq!((maximum(&session).as_str(), session.tables().is_used(session.sources())), ("25.026", true));
    send(&mut session, TablesCommand::Undo);
    assert_eq!((maximum(&session).as_str(), session.sources().own().len()), ("25.025", 1));
    session.apply(Command::NoOwnTables, now());
    assert_eq!((maximum(&session).as_str(), session.tables().is_used(session.sources())), ("25.021", false));
}

#[test]
fn own_tables_of_the_folder_are_in_the_list_and_follow_it_while_unchanged() {
    let mut session = session();
    let mut other = Session::new(Language::En);
    other.apply(Command::OpenPage(Page::Tables), now());
    made(&mut other, "H7", "30");
    let first = shown(&other).table().clone();
    made(&mut other, "H7 H8", "30");
    let second = DeviationTable::new(
        first.name(),
        false,
        shown(&other).table().ends().to_vec(),
        shown(&other).table().columns().to_vec(),
    )
    .unwrap();
    let load = |session: &mut Session, table: &DeviationTable| {
        let result = Ok((vec![table.clone()], vec![]));
        session.apply(Command::TablesRead { folder: "/shop".into(), result }, now());
    };
    load(&mut session, &first);
    assert_eq!(session.unopened_tables().count(), 1);
    send(&mut session, TablesCommand::Open(TableChoice::Own(0)));
    assert_eq!((shown(&session).origin, session.unopened_tables().count()), (Origin::Own, 0));
    load(&mut session, &second);
    assert_eq!(shown(&session).table().columns().len(), 2);
    send(&mut session, TablesCommand::RemoveColumn);
    load(&mut session, &first);
    assert_eq!(shown(&session).table().columns()[0].class.to_string(), "H8", "edits are kept");
}

#[test]
fn open_tables_are_bounded_and_edits_are_never_closed() {
    let mut session = session();
    for _ in 0..40 {
        made(&mut session, "H7", "30");
    }
    assert_eq!(session.tables().documents.len(), 32);
    let last = session.notices().last().unwrap();
    assert!(Words::new(Language::En).say(&last.message).contains("save one first"));
}

#[test]
fn undo_takes_back_what_was_typed_first_and_leads_to_what_it_changed() {
    let mut session = session();
    made(&mut session, "H7 H8", "30");
    type_text(&mut session, TablesField::CellUpper, "11");
    select(&mut session, "H8", 4);
    type_text(&mut session, TablesField::CellUpper, "99");
    send(&mut session, TablesCommand::Undo);
    assert_eq!((selected(&session).as_str(), session.text(TablesField::CellUpper)), ("H8 18 30 +33/0", "+33"));
    send(&mut session, TablesCommand::Undo);
    assert_eq!(selected(&session), "H7 0 3 +10/0");
    send(&mut session, TablesCommand::Move(Step::Bottom));
    send(&mut session, TablesCommand::Redo);
    assert_eq!(selected(&session), "H7 0 3 +11/0");
}

#[test]
fn an_own_table_with_a_built_in_name_is_another_table() {
    let mut session = session();
    made(&mut session, "H7", "30");
    let made = shown(&session).table();
    let own = DeviationTable::new("82553_hole.tab", false, made.ends().to_vec(), made.columns().to_vec()).unwrap();
    session.apply(Command::TablesRead { folder: "/shop".into(), result: Ok((vec![own], vec![])) }, now());
    assert_eq!(session.unopened_tables().count(), 1);
    send(&mut session, TablesCommand::Open(TableChoice::Own(0)));
    assert_eq!((shown(&session).title.as_str(), shown(&session).origin), ("82553_hole.tab", Origin::Own));
    assert_eq!(session.tables().documents[0].table().columns().len(), 24, "the built-in one is as it was");
}

#[test]
fn a_file_is_not_opened_while_the_cell_cannot_be_read_and_one_that_was_read_is_shown() {
    let mut session = session();
    type_text(&mut session, TablesField::CellUpper, "x");
    session.apply(Command::OpenDialog(Purpose::OpenTable), now());
    session.apply(Command::TypePath("/shop/own.tab".into()), now());
    assert_eq!(session.apply(Command::Confirm, now()), []);
    assert!(session.dialog().unwrap().problem.is_some());
    send(&mut session, TablesCommand::RevertCell);
    let effects = session.apply(Command::Confirm, now());
    assert_eq!(effects[0].errand(), &Effect::Read(Purpose::OpenTable, "/shop/own.tab".into()));
}

#[test]
fn a_table_written_over_the_file_of_another_one_leaves_that_one_unsaved() {
    let mut session = session();
    for path in ["/shop/one.tab", "/shop/two.tab"] {
        made(&mut session, "H7", "30");
        save(&mut session, 0, path).unwrap();
    }
    save(&mut session, 0, "/shop/one.tab").unwrap();
    let titles: Vec<_> =
        session.tables().documents[2..].iter().map(|one| (one.title.as_str(), one.is_unsaved())).collect();
    assert_eq!(titles, [("one_2.tab", true), ("one.tab", false)]);
}

#[test]
fn another_source_takes_nothing_from_an_open_table() {
    let options = Options { js: JsHalves::Rounded, ..Options::default() };
    let mut session = session();
    made(&mut session, "H7", "30");
    save(&mut session, 0, "/shop/own.tab").unwrap();
    let as_saved = shown(&session).table().columns().to_vec();
    // A used edit that is taken back is not in the file, and does not come again.
    select(&mut session, "H7", 4);
    type_text(&mut session, TablesField::CellUpper, "25");
    send(&mut session, TablesCommand::Use);
    send(&mut session, TablesCommand::Undo);
    session.apply(Command::SetStandard(options), now());
    assert_eq!((shown(&session).table().columns(), shown(&session).is_unsaved()), (&as_saved[..], false));
    // What was typed into the cell stays.
    type_text(&mut session, TablesField::CellUpper, "26");
    session.apply(Command::SetStandard(Options::default()), now());
    assert_eq!(selected(&session), "H7 18 30 +26/0");
}

/// On some systems `.tab` beside `.TAB` would be another file.
#[test]
fn a_table_is_saved_with_the_ending_that_its_file_has() {
    let mut session = session();
    made(&mut session, "H7", "30");
    save(&mut session, 0, "/shop/FIT_HOLE.TAB").unwrap();
    for (format, proposed) in [(0, "FIT_HOLE.TAB"), (3, "FIT_HOLE.csv")] {
        session.apply(Command::OpenDialog(Purpose::SaveTable(format)), now());
        assert_eq!(session.dialog().map(|dialog| dialog.path.as_str()), Some(proposed));
        session.apply(Command::Close, now());
    }
}
