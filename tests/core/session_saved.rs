//! What survives a restart: every key of a state file, including old ones.

#![cfg(test)]

use fitcheck::session::{
    CheckCommand, CheckField, Command, Field, FitField, MeasureBy, Saved, SavedError, Session, TablesField, Theme,
};
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
    let saved = Saved::read(&session.saved().write()).unwrap();
    let (again, effects) = Session::restore(saved);
    assert_eq!(again.text(CheckField::Callout), "25 H7");
    assert_eq!(again.text(CheckField::Measured), "25,012");
    assert_eq!((again.language(), again.theme(), again.check().by()), (Language::Nl, Theme::Dark, MeasureBy::Typing));
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
feature = "shaft"

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
    let written = String::from_utf8(session.saved().write()).unwrap();
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
