//! The settings page without a window: every setting is a row of its table, in the palette too, and leads back to its default.

#![cfg(test)]

use std::collections::BTreeSet;

use fitcheck::session::action::ActionScope;
use fitcheck::session::{
    Action, CheckCommand, CheckField, Command, Control, Density, Field, PaletteCommand, PaletteGroup, SETTINGS,
    Section, Session, SettingsAction, SettingsCommand, SettingsField, Theme, WindowAction, Zoom,
};
use fitcheck::tolerance::Base;
use fitcheck::verdict::rules::RuleName;
use fitcheck::words::{Dialogue, Language, Words};
use jiff::civil::DateTime;

fn now() -> DateTime {
    jiff::civil::date(2026, 11, 26).at(10, 42, 7, 0)
}

fn send(session: &mut Session, command: impl Into<Command>) {
    session.apply(command.into(), now());
}

/// Every action that a row of the table offers.
fn offered() -> Vec<Action> {
    let of_row = |control: Control| match control {
        Control::OneOf(choices, _) => choices(),
        Control::Switch(action) => vec![action],
        Control::Buttons(_, actions)
        | Control::Field(_, _, actions)
        | Control::Gauge(actions)
        | Control::Port(actions) => actions.to_vec(),
        Control::Zoom | Control::Ruler | Control::Who | Control::Told(_) => Vec::new(),
    };
    SETTINGS.iter().flat_map(|setting| of_row(setting.control)).collect()
}

/// What switches or chooses something and belongs to no page is a setting; which page is open is none.
fn is_setting(action: Action, session: &Session) -> bool {
    action.place() == ActionScope::Everywhere
        && action.is_on(session).is_some()
        && !matches!(action, Action::Window(WindowAction::Open(_)))
}

#[test]
fn every_setting_is_on_the_settings_page_and_in_the_palette() {
    let mut session = Session::new(Language::En);
    let settings: Vec<Action> = Action::all().filter(|action| is_setting(*action, &session)).collect();
    assert!(25 < settings.len(), "{settings:?}");
    let offered = offered();
    let missing: Vec<_> = settings.iter().filter(|action| !offered.contains(action)).collect();
    assert!(missing.is_empty(), "not in SETTINGS: {missing:?}");
    let all: Vec<Action> = Action::all().collect();
    let unknown: Vec<_> = offered.iter().filter(|action| !all.contains(action)).collect();
    assert!(unknown.is_empty(), "in no list of actions: {unknown:?}");
    send(&mut session, PaletteCommand::Show(true));
    let words = Words::new(Language::En);
    let entries = &session.palette.as_ref().unwrap().found;
    let listed = |text: &str| entries.iter().any(|entry| entry.text == text && entry.group == PaletteGroup::Settings);
    let missing: Vec<_> = settings.iter().filter(|action| !listed(&action.text(&session, &words))).collect();
    assert!(missing.is_empty(), "not in the palette: {missing:?}");
}

#[test]
fn a_choice_of_the_palette_says_what_it_sets() {
    let mut session = Session::new(Language::En);
    send(&mut session, PaletteCommand::Show(true));
    let entries = &session.palette.as_ref().unwrap().found;
    let english: BTreeSet<&str> =
        entries.iter().filter(|entry| entry.text == "English").map(|entry| entry.note.as_str()).collect();
    assert_eq!(english, BTreeSet::from(["Language", "Mask of the status window"]));
}

#[test]
fn every_row_has_its_texts_and_one_name() {
    for language in Language::all() {
        let words = Words::new(language);
        let mut names = BTreeSet::new();
        for setting in SETTINGS {
            for id in [setting.name, setting.about, setting.section.name()] {
                assert!(words.find(id).is_some(), "{language}: {id}");
            }
            assert!(names.insert(words.get(setting.name)), "{language}: two settings are called {}", setting.name);
        }
    }
}

#[test]
fn a_first_start_has_the_defaults_of_the_table() {
    let session = Session::new(Language::En);
    for setting in SETTINGS {
        match setting.control {
            Control::OneOf(choices, first) => {
                let chosen = choices().into_iter().filter(|choice| choice.is_on(&session) == Some(true));
                let chosen: Vec<Action> = chosen.collect();
                assert_eq!(chosen.len(), 1, "{}", setting.name);
                assert!(first.is_none_or(|first| chosen.contains(&first)), "{}", setting.name);
            }
            Control::Switch(action) => assert_eq!(action.is_on(&session), Some(false), "{}", setting.name),
            _ => {}
        }
    }
    for section in Section::ALL {
        let mut session = Session::new(Language::En);
        send(&mut session, SettingsCommand::Show(section));
        assert!(!session.can(SettingsAction::BackToDefaults), "{section:?}");
        let has_defaults =
            matches!(section, Section::General | Section::Appearance | Section::Rule | Section::OwnFiles);
        assert_eq!(section.has_defaults(), has_defaults, "{section:?}");
    }
}

#[test]
fn a_section_goes_back_to_its_defaults_and_no_other_does() {
    let mut session = Session::new(Language::Nl);
    for command in [
        Command::SetTheme(Theme::Dark),
        Command::SetDensity(Density::Touch),
        Command::SetZoom(Zoom::from(150)),
        Command::UseSource(Base::ControlTables),
        CheckCommand::UseRule(RuleName::Fixed).into(),
        Field::from(CheckField::GuardWidth).typed("3".to_owned()),
        Field::from(CheckField::Clearance).typed("7".to_owned()),
        Command::SetMask(Some(Dialogue::It)),
    ] {
        send(&mut session, command);
    }
    send(&mut session, SettingsCommand::Show(Section::Appearance));
    let back = SettingsAction::BackToDefaults.command(&session).unwrap();
    send(&mut session, back);
    assert_eq!((session.theme(), session.density(), session.zoom()), (Theme::System, Density::ByUse, Zoom::NORMAL));
    assert_eq!(session.sources().base(), Base::ControlTables);
    assert!(!session.can(SettingsAction::BackToDefaults), "nothing is left to set back");
    send(&mut session, SettingsCommand::Show(Section::Rule));
    let back = SettingsAction::BackToDefaults.command(&session).unwrap();
    send(&mut session, back);
    assert_eq!(session.sources().base(), Base::Iso286);
    assert_eq!(session.check().asked.worth.judging.rule, RuleName::Simple);
    assert_eq!((session.text(CheckField::GuardWidth), session.text(CheckField::Clearance)), ("", "2"));
    assert_eq!(session.language(), Language::Nl, "the language is nobody's default");
}

/// The names of what a search finds.
#[track_caller]
fn check_found(language: Language, query: &str, names: &[&str]) {
    let mut session = Session::new(language);
    send(&mut session, SettingsCommand::Type(SettingsField::Find, query.to_owned()));
    let words = Words::new(language);
    let found: Vec<String> = session.settings_page().shown().iter().map(|setting| words.get(setting.name)).collect();
    assert_eq!(found, names, "{query}");
}

#[test]
fn words_find_settings_by_name_line_choice_and_section() {
    check_found(Language::En, "zoom", &["Zoom"]);
    check_found(Language::En, "DARK", &["Colours"]);
    check_found(Language::En, "ilac", &["Decision rule"]);
    check_found(Language::En, "nederlands", &["Language", "Mask of the status window"]);
    check_found(Language::En, "mask built", &["Own mask"]);
    check_found(Language::Nl, "donker", &["Kleuren"]);
    check_found(Language::Nl, "sleutelbos", &["Adres van de server"]);
    check_found(Language::En, "no such setting", &[]);
}

#[test]
fn a_search_ends_with_escape_or_with_a_section_and_follows_the_language() {
    let mut session = Session::new(Language::En);
    send(&mut session, Command::OpenPage(fitcheck::session::Page::Settings));
    let find =
        |session: &mut Session, text: &str| send(session, SettingsCommand::Type(SettingsField::Find, text.into()));
    find(&mut session, "taal");
    assert!(session.settings_page().shown().is_empty());
    send(&mut session, Command::SetLanguage(Language::Nl));
    assert!(!session.settings_page().shown().is_empty());
    let escape = WindowAction::Close.command(&session).unwrap();
    send(&mut session, escape);
    assert_eq!((session.text(SettingsField::Find), session.settings_page().section), ("", Section::General));
    find(&mut session, "zoom");
    send(&mut session, SettingsCommand::Show(Section::Records));
    assert_eq!(session.text(SettingsField::Find), "");
    assert!(session.settings_page().shown().iter().all(|setting| setting.section == Section::Records));
}

#[test]
fn enter_in_a_field_of_the_settings_page_measures_nothing() {
    let mut session = Session::new(Language::En);
    for (field, text) in [(CheckField::Callout, "25 H7"), (CheckField::Measured, "25.012")] {
        send(&mut session, Field::from(field).typed(text.to_owned()));
    }
    send(&mut session, Command::OpenPage(fitcheck::session::Page::Settings));
    send(&mut session, Command::Enter(CheckField::Uncertainty.into()));
    assert!(session.check().shown.is_none());
    send(&mut session, Command::OpenPage(fitcheck::session::Page::Check));
    send(&mut session, Command::Enter(CheckField::Uncertainty.into()));
    assert!(session.check().shown.is_some());
}

#[test]
fn all_keys_of_the_table_of_actions_are_listed() {
    let mut session = Session::new(Language::En);
    assert!(session.settings_page().keys.is_empty());
    send(&mut session, SettingsCommand::Show(Section::Keys));
    let places = &session.settings_page().keys;
    let listed: usize = places.iter().flat_map(|place| &place.rows).map(|row| row.shortcuts.len()).sum();
    assert_eq!(listed, Action::all().flat_map(Action::shortcuts).count());
    let words = Words::new(Language::En);
    for place in places {
        assert!(words.find(place.place).is_some(), "{}", place.place);
    }
    assert_eq!(places[0].place, "settings-page-everywhere");
}
