//! What survives a restart: every key of a state file, including old ones.

#![cfg(test)]

use fitcheck::message::Message;
use fitcheck::session::WindowAction;
use fitcheck::session::{
    CheckCommand, CheckField, Command, Effect, Field, FilesCommand, FitField, MeasureBy, Purpose, Saved, SavedError,
    Session, TablesField, Theme, Zoom,
};
use fitcheck::tolerance::table::Column;
use fitcheck::tolerance::{Base, DeviationTable, Deviations};
use fitcheck::words::Language;
use jiff::civil::{DateTime, date};

fn now() -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0)
}

#[test]
fn inputs_survive_a_restart() {
    let mut session = Session::new(Language::Nl);
    session.apply(CheckCommand::Type(CheckField::Callout, "25 H7".into()).into(), now());
    session.apply(CheckCommand::Type(CheckField::Measured, "25,012".into()).into(), now());
    session.apply(Command::SetTheme(Theme::Dark), now());
    let saved = Saved::read(&session.saved().write().unwrap()).unwrap();
    let (again, effects) = Session::restore(saved);
    assert_eq!(again.text(CheckField::Callout), "25 H7");
    assert_eq!(again.text(CheckField::Measured), "25,012");
    assert_eq!((again.language(), again.theme(), again.check().by), (Language::Nl, Theme::Dark, MeasureBy::Typing));
    assert_eq!(effects, []);
}

/// A state file as versions up to 1.0 wrote it, with every key.
const OLD: &str = r#"version = 1
language = "nl"
theme = "dark"
keypad = true
source = "control-tables"

[standard]
edition = "1988"
js = "rounded"

[inputs]
by = "typing"

[inputs.texts]
callout = "25 h7"
measured = "m"
part = "p"
nominal = "25"
centre-x = "1"
centre-y = "2"
height = "3"
first-angle = "4"
clearance = "5"
centre-tolerance = "6"
true-diameter = "7"
offset-x = "8"
offset-y = "9"
ovality = "10"
lobes = "11"
lobe-height = "12"
surface-scatter = "13"
probe-scatter = "14"
seed = "15"
fit-callout = "16"
hole-measured = "17"
shaft-measured = "18"
temperature = "19"
hole-expansion = "20"
shaft-expansion = "21"
wanted-minimum = "22"
wanted-maximum = "23"
table-filter = "24"
cell-upper = "25"
cell-lower = "26"
table-classes = "27"
table-to = "28"

[cycles]
cycle = 421

[cycles.texts]
"421 Q273" = "50"
"#;

#[test]
fn an_old_state_is_read_and_written_with_the_same_keys() {
    let saved = Saved::read(OLD.as_bytes()).unwrap();
    let (session, _) = Session::restore(saved.clone());
    let fields: [(Field, &str); 8] = [
        (CheckField::Callout.into(), "25 h7"),
        (CheckField::FirstAngle.into(), "4"),
        (CheckField::Seed.into(), "15"),
        (FitField::Callout.into(), "16"),
        (FitField::WantedMaximum.into(), "23"),
        (TablesField::Filter.into(), "24"),
        (TablesField::CellLower.into(), "26"),
        (TablesField::To.into(), "28"),
    ];
    for (field, text) in fields {
        assert_eq!(session.text(field), text, "{field:?}");
    }
    assert_eq!(session.saved(), saved);
    let written = String::from_utf8(session.saved().write().unwrap()).unwrap();
    for line in OLD.lines() {
        assert!(written.lines().any(|other| other == line), "{line} in {written}");
    }
}

#[test]
fn a_broken_or_newer_state_is_refused() {
    assert!(matches!(Saved::read(b"language = 7"), Err(SavedError::Broken { .. })));
    assert!(matches!(Saved::read(b"\xff\xff"), Err(SavedError::Broken { .. })));
    assert_eq!(Saved::read(b"version = 2"), Err(SavedError::Newer { version: 2 }));
    assert_eq!(Saved::read(b"").unwrap(), Saved::default());
}

/// A session that used own tables the last time, before they have been read.
fn with_tables_to_read() -> Session {
    let mut saved = Saved::default();
    saved.tables_folder = Some("/shop".into());
    let (session, effects) = Session::restore(saved);
    assert_eq!(effects, [Effect::Read(Purpose::LoadTables, "/shop".into())]);
    session
}

fn type_check(session: &mut Session, callout: &str, measured: &str) {
    for (field, text) in [(CheckField::Callout, callout), (CheckField::Measured, measured)] {
        session.apply(CheckCommand::Type(field, text.into()).into(), now());
    }
    session.apply(CheckCommand::Measure.into(), now());
}

/// How the checks of the session were judged.
fn judged(session: &Session) -> Vec<String> {
    session.history().iter().map(|check| format!("{} by {}", check.verdict.status(), check.limits.source)).collect()
}

/// The answer of the outside world: H7 ends at +10 µm in the only own table, or the folder cannot be read.
fn tables_read(is_there: bool) -> Command {
    let deviations = Deviations::new("0.01".parse().unwrap(), "0".parse().unwrap()).unwrap();
    let column = Column { class: "H7".parse().unwrap(), cells: vec![Some(deviations)] };
    let own = DeviationTable::new("own.tab", false, vec!["30".parse().unwrap()], vec![column]).unwrap();
    let gone = || Message::new("file-missing").text("path", "/shop");
    let result = if is_there { Ok((vec![own], Vec::new())) } else { Err(gone()) };
    Command::TablesRead { folder: "/shop".into(), result }
}

#[test]
fn a_file_waits_until_the_own_tables_of_the_last_time_are_read() {
    for (name, settled) in
        [("read", tables_read(true)), ("not there", tables_read(false)), ("given up", Command::NoOwnTables)]
    {
        let mut session = with_tables_to_read();
        let open = FilesCommand::Open(Purpose::Import, "/parts/a.csv".into());
        assert_eq!(session.apply(open.into(), now()), [], "{name}");
        let dropped = FilesCommand::Open(Purpose::Import, "/parts/b.csv".into());
        assert_eq!(session.apply(dropped.into(), now()), [], "{name}");
        let read = |path: &str| Effect::Read(Purpose::Import, path.into());
        assert_eq!(session.apply(settled, now()), [read("/parts/a.csv"), read("/parts/b.csv")], "{name}");
        assert_eq!(session.apply(Command::SetTheme(Theme::Dark), now()), [], "{name}: once");
    }
}

#[test]
fn a_file_that_is_not_judged_is_read_while_the_own_tables_are_awaited() {
    let mut session = with_tables_to_read();
    let open = FilesCommand::Open(Purpose::OpenProgram, "/nc/a.h".into());
    let read = Effect::Read(Purpose::OpenProgram, "/nc/a.h".into());
    assert_eq!(session.apply(open.into(), now()), [read]);
}

#[test]
fn no_class_is_judged_until_the_own_tables_of_the_last_time_are_read() {
    let mut session = with_tables_to_read();
    type_check(&mut session, "25 H7", "25.015");
    assert_eq!(judged(&session), [""; 0]);
    let why = session.error(CheckField::Callout).map(ToString::to_string);
    assert_eq!(why.as_deref(), Some("The own tables in /shop are still being read"));
    session.apply(Command::UseSource(Base::ControlTables), now());
    type_check(&mut session, "25 H7", "25.015");
    assert_eq!(judged(&session), [""; 0], "in whatever source");
    session.apply(Field::from(FitField::Callout).typed("25 H7/g6".into()), now());
    assert!(session.fit().fit.is_none());
    session.apply(tables_read(true), now());
    type_check(&mut session, "25 H7", "25.015");
    assert_eq!(judged(&session), ["SCRAP by table own.tab, over 0 up to 30 mm"]);
}

#[test]
fn limits_that_a_callout_states_itself_need_no_tables() {
    let mut session = with_tables_to_read();
    session.apply(CheckCommand::ChooseFeature(Some(fitcheck::tolerance::Feature::Hole)).into(), now());
    type_check(&mut session, "25 +0.021 0", "25.015");
    assert_eq!(judged(&session), ["GOOD by the callout itself"]);
}

#[test]
fn what_is_judged_without_the_own_tables_says_so() {
    let mut session = with_tables_to_read();
    session.apply(tables_read(false), now());
    assert!(session.notices()[0].is_problem);
    type_check(&mut session, "25 H7", "25.015");
    let why = "own tables in /shop could not be read";
    assert_eq!(judged(&session), [format!("GOOD by ISO 286, over 18 up to 30 mm; {why}")]);
    session.apply(Command::UseSource(Base::ControlTables), now());
    type_check(&mut session, "25 H7", "25.015");
    assert!(judged(&session)[1].ends_with(why), "{:?}", judged(&session));
    // Whoever wants no own tables says so once.
    let none = WindowAction::NoOwnTables.command(&session).unwrap();
    assert!(session.can(WindowAction::NoOwnTables));
    session.apply(none, now());
    type_check(&mut session, "25 H7", "25.015");
    assert!(!judged(&session)[2].contains(why) && !session.can(WindowAction::NoOwnTables));
    assert_eq!(session.saved().tables_folder, None);
}

#[test]
fn own_tables_that_come_after_others_were_chosen_are_not_used() {
    let mut session = with_tables_to_read();
    session.apply(Command::NoOwnTables, now());
    assert_eq!(session.apply(tables_read(true), now()), []);
    type_check(&mut session, "25 H7", "25.015");
    assert_eq!(judged(&session), ["GOOD by ISO 286, over 18 up to 30 mm"]);
    assert_eq!((session.notices().len(), session.saved().tables_folder), (0, None));
    // Read again because somebody asked for them, they are.
    session.apply(tables_read(true), now());
    type_check(&mut session, "25 H7", "25.015");
    assert_eq!(judged(&session)[1], "SCRAP by table own.tab, over 0 up to 30 mm");
}

#[test]
fn a_folder_of_tables_that_could_not_be_read_is_tried_again_after_a_restart() {
    let mut session = with_tables_to_read();
    assert_eq!(session.saved().tables_folder, Some("/shop".into()), "before the answer");
    session.apply(tables_read(false), now());
    assert_eq!(session.saved().tables_folder, Some("/shop".into()));
}

#[test]
fn a_window_writes_only_what_it_has_changed_over_what_another_has_written() {
    let state = |text: &str| Saved::read(text.as_bytes()).unwrap();
    let before = state("language = \"en\"\ntheme = \"dark\"\n[inputs.texts]\ncallout = \"25 H7\"\nmeasured = \"25\"");
    let after = state("language = \"nl\"\ntheme = \"dark\"\n[inputs.texts]\ncallout = \"40 js6\"");
    let there =
        "theme = \"light\"\nof-tomorrow = 1\n[inputs.texts]\nmeasured = \"25\"\nfit = \"50 H7/p6\"\ncallout = \"9 e8\"";
    let written = after.write_over(&before, there.as_bytes()).unwrap();
    let read = Saved::read(&written).unwrap();
    assert_eq!((read.language, read.theme), (Language::Nl, Theme::Light));
    let texts: Vec<_> = read.inputs.texts.iter().map(|(key, text)| (key.as_str(), text.as_str())).collect();
    assert_eq!(texts, [("callout", "40 js6"), ("fit", "50 H7/p6")]);
    assert!(String::from_utf8(written).unwrap().contains("of-tomorrow = 1"));
    assert!(matches!(after.write_over(&before, b"language = ["), Err(SavedError::Broken { .. })));
    assert!(matches!(after.write_over(&before, b"version = 99"), Err(SavedError::Newer { .. })));
    // What another window has written already is written once more as it is.
    assert_eq!(Saved::read(&after.write_over(&before, &after.write().unwrap()).unwrap()), Ok(after));
}

#[test]
fn the_scale_of_the_window_survives_and_stays_within_what_can_be_read() {
    let mut session = Session::new(Language::En);
    session.apply(Command::SetZoom(Zoom::from(150)), now());
    let saved = session.saved().write().unwrap();
    assert!(String::from_utf8(saved.clone()).unwrap().contains("zoom = 150"));
    assert_eq!(Session::restore(Saved::read(&saved).unwrap()).0.zoom(), Zoom::from(150));
    for (text, percent) in [("version = 1", 100), ("zoom = 10", 75), ("zoom = 1000", 300)] {
        assert_eq!(Saved::read(text.as_bytes()).unwrap().zoom.percent(), percent, "{text}");
    }
}

#[test]
fn a_step_of_the_scale_goes_to_the_next_ten_per_cent() {
    for (from, larger, smaller) in [(75, 80, 75), (100, 110, 90), (125, 130, 120), (300, 300, 290)] {
        let zoom = Zoom::from(from);
        assert_eq!((zoom.larger().percent(), zoom.smaller().percent()), (larger, smaller), "{from}");
    }
}
