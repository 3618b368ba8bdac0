//! A file of settings for a whole shop: written, read on another station, with what it does not know kept.

#![cfg(test)]

use std::path::PathBuf;

use fitcheck::session::{
    CheckCommand, CheckField, Command, Content, Effect, Field, Purpose, RecordsCommand, RecordsField, Session,
    SettingsAction, Theme, Zoom,
};
use fitcheck::tolerance::Base;
use fitcheck::verdict::rules::RuleName;
use fitcheck::words::{Language, Words};
use jiff::civil::DateTime;

fn now() -> DateTime {
    jiff::civil::date(2026, 11, 26).at(10, 42, 7, 0)
}

fn send(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), now())
}

/// A station that was set up, with what is nobody else's.
fn set_up() -> Session {
    let mut session = Session::new(Language::Nl);
    for command in [
        Command::SetTheme(Theme::Dark),
        Command::SetZoom(Zoom::from(125)),
        Command::UseSource(Base::ControlTables),
        CheckCommand::UseRule(RuleName::IlacG8).into(),
        Field::from(CheckField::Uncertainty).typed("1.2".to_owned()),
        Field::from(CheckField::Callout).typed("25 H7".to_owned()),
        Field::from(RecordsField::Who).typed("Anna".to_owned()),
        RecordsCommand::TakeName.into(),
    ] {
        send(&mut session, command);
    }
    session
}

/// What a station exports, by its dialog.
fn exported(session: &mut Session) -> String {
    let export = SettingsAction::ExportSettings.command(session).unwrap();
    send(session, export);
    assert_eq!(session.dialog().map(|dialog| dialog.path.as_str()), Some("fitcheck-settings.toml"));
    send(session, Command::TypePath("/shop/settings.toml".to_owned()));
    let effects = send(session, Command::Confirm);
    let [Effect::ForDialog(_, effect)] = effects.as_slice() else { panic!("{effects:?}") };
    let Effect::Save(path, Content::Bytes(bytes)) = effect.as_ref() else { panic!("{effect:?}") };
    assert_eq!(path, &PathBuf::from("/shop/settings.toml"));
    send(session, Command::Close);
    String::from_utf8(bytes.clone()).unwrap()
}

/// A station reads a file without a dialog; its effects.
fn imported(session: &mut Session, text: &str) -> Vec<Effect> {
    send(session, Command::SettingsRead { path: "/shop/settings.toml".into(), result: Ok(text.to_owned()) })
}

/// The last notice with its details.
fn told(session: &Session) -> Vec<String> {
    let words = Words::new(Language::En);
    let notice = session.notices().last().unwrap();
    std::iter::once(&notice.message).chain(&notice.details).map(|message| words.say(message)).collect()
}

#[test]
fn another_station_gets_the_settings_and_nothing_of_a_person_or_a_part() {
    let text = exported(&mut set_up());
    for absent in ["Anna", "25 H7", "server", "recent", "walk"] {
        assert!(!text.contains(absent), "{absent} is in {text}");
    }
    let mut other = Session::new(Language::En);
    send(&mut other, Field::from(CheckField::Callout).typed("12 g6".to_owned()));
    assert_eq!(imported(&mut other, &text), []);
    assert_eq!((other.language(), other.theme(), other.zoom()), (Language::Nl, Theme::Dark, Zoom::from(125)));
    assert_eq!(other.sources().base(), Base::ControlTables);
    assert_eq!(other.check().asked.worth.judging.rule, RuleName::IlacG8);
    assert_eq!((other.text(CheckField::Uncertainty), other.text(CheckField::Callout)), ("1.2", "12 g6"));
    assert_eq!(
        told(&other),
        [
            "settings.toml: 6 settings changed",
            "Language",
            "Colours",
            "Zoom",
            "Limits from",
            "Decision rule",
            "Uncertainty of the measured value",
        ]
    );
    assert_eq!(exported(&mut other), text, "it goes on to the next station as it came");
    imported(&mut other, &text);
    assert_eq!(told(&other), ["settings.toml: nothing is different"]);
}

#[test]
fn what_a_file_does_not_have_stays_and_what_is_not_known_is_written_again() {
    let mut session = Session::new(Language::En);
    send(&mut session, Command::SetZoom(Zoom::from(150)));
    let text = "version = 1\ntheme = \"dark\"\ntelescope = 3\n[inputs]\nfuture = true\n";
    imported(&mut session, text);
    assert_eq!((session.theme(), session.zoom()), (Theme::Dark, Zoom::from(150)));
    let said = told(&session);
    assert_eq!(said[0], "settings.toml: 1 setting changed");
    assert!(said.contains(&"telescope is not a setting of this version. An export keeps it.".to_owned()), "{said:?}");
    let again: toml::Table = toml::from_str(&exported(&mut session)).unwrap();
    assert_eq!(again["telescope"].as_integer(), Some(3));
    assert_eq!(again["inputs"]["future"].as_bool(), Some(true));
    assert_eq!(again["zoom"].as_integer(), Some(150));
}

#[test]
fn folders_and_masks_of_the_shop_are_read() {
    let mut session = Session::new(Language::En);
    let text = "version = 1\ntables_folder = \"/shop/tables\"\nmask = \"/shop/own.a\"\n";
    let effects = imported(&mut session, text);
    let wanted = [
        Effect::Read(Purpose::LoadTables, "/shop/tables".into()),
        Effect::Read(Purpose::LoadMask, "/shop/own.a".into()),
    ];
    assert_eq!(effects, wanted);
}

#[test]
fn of_a_state_file_only_settings_are_taken() {
    let text = String::from_utf8(set_up().saved().write().unwrap()).unwrap();
    let mut session = Session::new(Language::En);
    imported(&mut session, &text);
    assert_eq!((session.theme(), session.text(CheckField::Callout)), (Theme::Dark, ""));
    assert!(told(&session).iter().all(|line| !line.contains("is not a setting")), "{:?}", told(&session));
}

#[test]
fn a_file_that_is_none_or_of_a_later_version_changes_nothing_and_is_reported() {
    for (text, why) in [
        ("theme = \"dark\"", "the file has no version: it is not a file of settings"),
        ("version = 2\ntheme = \"dark\"", "version 2"),
        ("version = 1\ntheme = \"pink\"", "cannot be read"),
        ("not a file", "cannot be read"),
    ] {
        let mut session = Session::new(Language::En);
        assert_eq!(imported(&mut session, text), []);
        assert_eq!(session.theme(), Theme::System, "{text}");
        assert!(told(&session)[0].contains(why), "{text}: {:?}", told(&session));
    }
}
