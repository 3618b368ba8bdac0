//! The palette: everything that can be done is found by its name in any language, and a callout is checked.

use std::collections::BTreeSet;

use fitcheck::session::action::ActionScope;
use fitcheck::session::help::{HelpField, HelpPlace};
use fitcheck::session::{
    Action, CheckField, Command, Effect, Page, PaletteCommand, PaletteGroup, Purpose, Session, Step, Theme,
    WindowAction,
};
use fitcheck::words::{Language, Words};
use jiff::civil::DateTime;

fn now() -> DateTime {
    jiff::civil::date(2026, 11, 26).at(10, 42, 7, 0)
}

fn opened() -> Session {
    let mut session = Session::new(Language::En);
    session.apply(PaletteCommand::Show(true).into(), now());
    session
}

fn searched(query: &str) -> Session {
    let mut session = opened();
    session.apply(PaletteCommand::Type(query.to_owned()).into(), now());
    session
}

fn texts(session: &Session) -> Vec<&str> {
    session.palette.as_ref().unwrap().found.iter().map(|entry| entry.text.as_str()).collect()
}

fn enter(session: &mut Session) -> Vec<Effect> {
    session.apply(PaletteCommand::Do(None).into(), now())
}

#[test]
fn every_action_is_in_the_palette_but_those_of_a_dialog() {
    let session = opened();
    let words = Words::new(Language::En);
    let listed: BTreeSet<&str> = texts(&session).into_iter().collect();
    let closing: [Action; 2] = [WindowAction::Close.into(), WindowAction::Palette.into()];
    let missing: Vec<_> = Action::all()
        .filter(|action| action.place() != ActionScope::Dialog && !closing.contains(action))
        .map(|action| action.text(&session, &words))
        .filter(|text| !listed.contains(text.as_str()))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn an_action_is_found_by_its_name_in_any_language_and_done_by_enter() {
    for query in ["dark", "Donker", "DARK"] {
        let mut session = searched(query);
        assert_eq!(session.palette.as_ref().unwrap().found[0].group, PaletteGroup::Settings, "{query}");
        enter(&mut session);
        assert_eq!((session.theme(), session.palette.is_none()), (Theme::Dark, true), "{query}");
    }
}

#[test]
fn a_callout_is_checked_with_the_limits_that_stand_in_its_entry() {
    let mut session = searched("25 h6");
    let entry = &session.palette.as_ref().unwrap().found[0];
    // ISO 286-2: h6 over 18 up to 30 mm is 0 / -13 µm.
    assert_eq!((entry.text.as_str(), entry.note.as_str()), ("Check 25 h6", "24.987 … 25.000 mm"));
    let effects = enter(&mut session);
    assert_eq!((session.page(), session.text(CheckField::Callout)), (Page::Check, "25 h6"));
    assert!(effects.contains(&Effect::Focus(CheckField::Measured.into())));
    // A class that the standard does not define there is no entry.
    assert!(!texts(&searched("4000 H7")).iter().any(|text| text.starts_with("Check")));
}

#[test]
fn what_is_done_on_another_page_opens_that_page_first() {
    let mut session = searched("new budget");
    assert_eq!(texts(&session)[0], "New budget");
    enter(&mut session);
    assert_eq!(session.page(), Page::Budget);
    assert!(!session.budget().document.text.is_empty());
}

#[test]
fn what_cannot_be_done_now_is_listed_last_and_does_nothing() {
    let mut session = searched("clear history");
    let palette = session.palette.as_ref().unwrap();
    assert!(!palette.found[0].is_possible);
    enter(&mut session);
    assert!(session.palette.is_some(), "it stays open");
}

#[test]
fn arrows_go_round_and_escape_closes() {
    let mut session = opened();
    let last = texts(&session).len() - 1;
    let at = |session: &Session| session.palette.as_ref().unwrap().at;
    for (step, expected) in [(Step::Up, last), (Step::Down, 0), (Step::Down, 1), (Step::PageDown, 9), (Step::First, 0)]
    {
        session.apply(PaletteCommand::Move(step).into(), now());
        assert_eq!(at(&session), expected, "{step:?}");
    }
    let close = Action::from(WindowAction::Close).command(&session).unwrap();
    session.apply(close, now());
    assert!(session.palette.is_none());
}

#[test]
fn what_only_the_text_of_the_manual_has_is_searched_there() {
    for query in ["Q303", "preset table", "tool data"] {
        let mut session = searched(query);
        assert_eq!(texts(&session).last(), Some(&format!("Search the manual for “{query}”").as_str()), "{query}");
        session.apply(PaletteCommand::Move(Step::Last).into(), now());
        enter(&mut session);
        assert_eq!((session.page(), session.text(HelpField::Search)), (Page::Help, query));
    }
}

#[test]
fn a_query_that_finds_nothing_does_nothing() {
    let mut session = searched("no such thing at all");
    assert!(texts(&session).is_empty());
    session.apply(PaletteCommand::Move(Step::Down).into(), now());
    enter(&mut session);
    assert!(session.palette.is_some());
}

#[test]
fn a_recent_file_is_opened_again() {
    use fitcheck::session::{FilesCommand, ReadOutcome};
    let mut session = Session::new(Language::En);
    let seen =
        FilesCommand::Seen { purpose: Purpose::Import, path: "/parts/lot 7.csv".into(), fate: ReadOutcome::Read };
    session.apply(seen.into(), now());
    session.apply(Command::Palette(PaletteCommand::Show(true)), now());
    session.apply(PaletteCommand::Type("lot 7".to_owned()).into(), now());
    assert_eq!(texts(&session).first(), Some(&"lot 7.csv"));
    assert_eq!(enter(&mut session), [Effect::Read(Purpose::Import, "/parts/lot 7.csv".into())]);
}

#[test]
fn the_best_match_never_removes_anything() {
    for query in ["H7", "remove", "clear", "delete", "empty"] {
        let mut session = Session::new(Language::En);
        session.apply(Command::OpenPage(Page::Tables), now());
        session.apply(PaletteCommand::Show(true).into(), now());
        session.apply(PaletteCommand::Type(query.to_owned()).into(), now());
        let found = &session.palette.as_ref().unwrap().found;
        let first = found.first().map(|entry| entry.text.clone()).unwrap();
        assert!(!first.starts_with("Remove H7"), "{query}: {first}");
    }
}

#[test]
fn a_rule_that_is_chosen_in_the_palette_is_told_with_a_way_back() {
    let mut session = searched("14253-1:1998");
    let before = session.notices().len();
    enter(&mut session);
    assert_eq!(session.notices().len(), before + 1);
    let notice = session.notices().last().unwrap();
    assert!(notice.before.is_some(), "{notice:?}");
}

#[test]
fn terms_and_headings_of_the_manual_are_found_by_the_beginning_of_a_word() {
    let mut session = searched("guard");
    let found = texts(&session);
    let term = found.iter().position(|text| *text == "Help: Guard band").unwrap();
    assert!(found.contains(&"Help: What a guard band is"), "{found:?}");
    session.apply(PaletteCommand::Do(Some(term)).into(), now());
    assert_eq!(session.page(), Page::Help);
    assert_eq!(session.help().shown, HelpPlace::at("terms.md", "guard-band"));
    // What can be done comes before what can be read; without a query no heading is listed.
    let session = searched("plan");
    let found = &session.palette.as_ref().unwrap().found;
    assert!(found[0].action().is_some() && found.iter().any(|entry| entry.text == "Help: Plan"), "{found:?}");
    assert!(!texts(&opened()).contains(&"Help: Guard band"));
}
