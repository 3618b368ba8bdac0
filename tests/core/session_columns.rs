//! The columns of files without a window: asked about, corrected, taken, remembered, forgotten.

use fitcheck::session::WindowAction;
use std::path::PathBuf;

use fitcheck::exchange::{DecimalSign, Detected, FirstRows, Mapping, Role, Separator, import};
use fitcheck::message::Message;
use fitcheck::session::{
    CheckCommand, ColumnChoice, ColumnsCommand, ColumnsRequest, Command, Effect, ImportInto, OpenColumns, Purpose,
    Saved, Session, UnitLess, UsedColumns,
};
use fitcheck::tolerance::Sources;
use fitcheck::words::{Language, Words};
use jiff::civil::{DateTime, date};

const ODD: &str = "Stelle;Vorgabe;Ergebnis;Rest\nb1;25 H7;25,012;a\nb2;25 H7;zwölf;b\n";

fn now() -> DateTime {
    date(2026, 11, 24).at(10, 42, 7, 0)
}

fn send(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), now())
}

fn said(message: &Message) -> String {
    Words::new(Language::En).say(message)
}

fn ask(session: &mut Session, name: &str, text: &str) {
    let first = FirstRows::of(name, text.as_bytes()).unwrap();
    let path = PathBuf::from("/in").join(name);
    let mapping = session.remembered_columns().find(&first).map(|(.., mapping)| mapping).unwrap_or_default();
    let asked =
        ColumnsRequest { name: name.to_owned(), path, into: ImportInto::History, first, mapping, is_wanted: false };
    send(session, ColumnsCommand::Ask(Box::new(asked)));
}

fn choose(session: &mut Session, choice: ColumnChoice) {
    assert_eq!(send(session, ColumnsCommand::Choose(choice)), []);
}

#[track_caller]
fn open(session: &Session) -> &OpenColumns {
    session.open_columns().unwrap()
}

fn choose_all(session: &mut Session) {
    for (at, role) in [(0, Role::Id), (1, Role::Tolerance), (2, Role::Measured)] {
        choose(session, ColumnChoice::Role(at, Some(role)));
    }
}

#[test]
fn the_first_rows_tell_what_a_choice_makes_of_them() {
    let mut session = Session::new(Language::En);
    ask(&mut session, "a.csv", ODD);
    assert_eq!(said(open(&session).refusal.as_ref().unwrap()), "No column holds the measured value: choose one");
    assert!(!session.can(WindowAction::TakeColumns));
    assert_eq!(send(&mut session, ColumnsCommand::Take), []);
    assert!(session.open_columns().is_some(), "nothing is taken");
    choose_all(&mut session);
    let shown = open(&session);
    assert_eq!((shown.width, shown.header, shown.lines.as_slice(), shown.read), (4, Some(1), &[2, 3][..], 1));
    assert_eq!(said(shown.problem.as_ref().unwrap()), "line 3, column 3: measured: zwölf is not a number");
    // In another unit 25,012 is 635.3048 mm, which is far from 25: it is read all the same.
    choose(&mut session, ColumnChoice::Unit(Some("inch".parse().unwrap())));
    assert_eq!(open(&session).read, 1);
    choose(&mut session, ColumnChoice::Decimal(Some(DecimalSign::Point)));
    assert_eq!(open(&session).read, 0);
    choose(&mut session, ColumnChoice::Decimal(None));
    choose(&mut session, ColumnChoice::FirstRow(Some(3)));
    assert_eq!((open(&session).lines.as_slice(), open(&session).read), (&[3][..], 0));
    // Another separator begins anew.
    choose(&mut session, ColumnChoice::Separator(Separator::Tab));
    assert_eq!(open(&session).width, 1);
    assert!(open(&session).choice.unit.is_none());
}

#[test]
fn what_is_taken_is_read_with_it_and_remembered() {
    let mut session = Session::new(Language::En);
    ask(&mut session, "a.csv", ODD);
    choose_all(&mut session);
    let action = WindowAction::TakeColumns.command(&session).unwrap();
    let effects = send(&mut session, action);
    let [Effect::ReadColumns { into: ImportInto::History, path, mapping }] = effects.as_slice() else {
        panic!("{effects:?}")
    };
    assert_eq!(path, &PathBuf::from("/in/a.csv"));
    assert!(session.open_columns().is_none());
    let toml = mapping.to_toml().unwrap();
    for said in ["name = \"Stelle\"", "callout = \"Vorgabe\"", "measured = \"Ergebnis\"", "time = \"-\"", "who = \"-\""]
    {
        assert!(toml.contains(said), "{toml}");
    }
    // A restart.
    let saved = Saved::read(&session.saved().write().unwrap()).unwrap();
    assert_eq!(saved.columns.len(), 1);
    let (session, _) = Session::restore(saved);
    let first = FirstRows::of("b.csv", ODD.as_bytes()).unwrap();
    let (_, kept, again) = session.remembered_columns().find(&first).unwrap();
    assert_eq!((kept.day(), &again), ("2026-11-24", mapping.as_ref()));
}

#[test]
fn escape_leaves_a_file_alone_and_the_next_one_is_shown() {
    let mut session = Session::new(Language::En);
    ask(&mut session, "a.csv", ODD);
    ask(&mut session, "b.csv", ODD);
    assert_eq!(open(&session).name(), "a.csv");
    let close = WindowAction::Close.command(&session).unwrap();
    assert_eq!(send(&mut session, close), []);
    assert_eq!(open(&session).name(), "b.csv");
    let close = WindowAction::Close.command(&session).unwrap();
    send(&mut session, close);
    assert!(session.open_columns().is_none());
    assert!(session.remembered_columns().is_empty() && session.notices().is_empty());
}

fn imported(session: &mut Session, remembered: Option<(String, String)>) {
    let text = "id;callout;measured\nb1;25 H7;25,012\n";
    let detected: Detected = Mapping::default().detect(text.as_bytes()).unwrap();
    let (name, path) = ("m.csv".to_owned(), PathBuf::from("/in/m.csv"));
    let used = UsedColumns { name: name.clone(), path, into: ImportInto::History, detected, remembered };
    send(session, ColumnsCommand::Used(Box::new(used)));
    let result = Ok(Box::new(import("m.csv", text.as_bytes(), &Sources::default(), now())));
    send(session, CheckCommand::Imported { name, result });
}

#[test]
fn a_notice_says_what_the_columns_were_taken_for_and_offers_to_correct_it() {
    let mut session = Session::new(Language::En);
    imported(&mut session, None);
    let lines: Vec<String> = session.notices()[0].details.iter().map(said).collect();
    assert_eq!(lines, ["Columns: id → name, callout → callout, measured → measured value; unit of sizes: mm"]);
    assert!(!session.can(WindowAction::ForgetColumns));
    let correct = WindowAction::CorrectColumns.command(&session).unwrap();
    let effects = send(&mut session, correct);
    assert_eq!(effects, [Effect::Read(Purpose::AskColumns(ImportInto::History), PathBuf::from("/in/m.csv"))]);
}

#[test]
fn lines_of_a_gauge_without_a_unit_are_read_again_in_the_one_that_is_said() {
    let path = PathBuf::from("/in/gauge.txt");
    for (action, unit) in [(WindowAction::LengthsInMm, "unit=mm"), (WindowAction::LengthsInInches, "unit=inch")] {
        let mut session = Session::new(Language::En);
        let name = "gauge.txt".to_owned();
        let result = Ok(Box::new(import(&name, b"01A+025.0120\r01A+024.9900\r", &Sources::default(), now())));
        assert!(result.as_ref().is_ok_and(|read| read.lacks_unit()));
        let file = UnitLess { name: name.clone(), path: path.clone(), into: ImportInto::History };
        send(&mut session, ColumnsCommand::UnitLess(Box::new(file)));
        send(&mut session, CheckCommand::Imported { name, result });
        assert!(!session.can(WindowAction::CorrectColumns));
        let command = action.command(&session).unwrap();
        let mapping: Mapping = unit.parse().unwrap();
        let read = Effect::ReadColumns { into: ImportInto::History, path: path.clone(), mapping: Box::new(mapping) };
        assert_eq!(send(&mut session, command), [read]);
    }
}

#[test]
fn what_is_remembered_is_said_and_can_be_forgotten() {
    let mut session = Session::new(Language::En);
    ask(&mut session, "a.csv", ODD);
    choose_all(&mut session);
    send(&mut session, ColumnsCommand::Take);
    let first = FirstRows::of("b.csv", ODD.as_bytes()).unwrap();
    let shape = session.remembered_columns().find(&first).unwrap().0.to_owned();
    imported(&mut session, Some((shape, "2026-11-24".to_owned())));
    let lines: Vec<String> = session.notices()[0].details.iter().map(said).collect();
    assert_eq!(lines[0], "Columns read as corrected on 2026-11-24");
    let forget = WindowAction::ForgetColumns.command(&session).unwrap();
    send(&mut session, forget);
    assert!(session.remembered_columns().is_empty());
    assert!(!session.can(WindowAction::ForgetColumns));
    assert!(said(&session.notices()[0].details[0]).starts_with("Columns forgotten"));
}

#[test]
fn a_file_for_a_part_that_was_ended_is_not_asked_about() {
    let mut session = Session::new(Language::En);
    let first = FirstRows::of("a.csv", ODD.as_bytes()).unwrap();
    let (name, path, mapping) = ("a.csv".to_owned(), PathBuf::from("/in/a.csv"), Mapping::default());
    let asked = ColumnsRequest { name, path, into: ImportInto::Part(1), first, mapping, is_wanted: true };
    send(&mut session, ColumnsCommand::Ask(Box::new(asked)));
    assert!(session.open_columns().is_none());
    assert_eq!(session.notices().len(), 1);
}
