//! What is heard of verdicts: nothing at first, then a rhythm for each that was measured.

use fitcheck::session::{
    Action, CheckAction, CheckField, Command, Effect, MeasureBy, Page, Rhythm, Session, SettingsAction,
};
use fitcheck::words::Language;

use crate::session_walk::{act, send, typed};

fn heard(effects: &[Effect]) -> Vec<Rhythm> {
    effects.iter().filter_map(|effect| if let Effect::Sound(rhythm) = effect { Some(*rhythm) } else { None }).collect()
}

/// What is heard when a value of 25 H7 is judged.
fn judged(session: &mut Session, value: &str) -> Vec<Rhythm> {
    typed(session, CheckField::Measured, value);
    heard(&send(session, Command::Enter(CheckField::Measured.into())))
}

fn checking() -> Session {
    let mut session = Session::new(Language::En);
    typed(&mut session, CheckField::Callout, "25 H7");
    session
}

#[test]
fn nothing_is_heard_until_somebody_wants_it() {
    assert_eq!(judged(&mut checking(), "25.010"), []);
}

#[test]
fn one_tone_is_good_two_ask_for_a_look_and_three_are_scrap() {
    let mut session = checking();
    assert_eq!(heard(&send(&mut session, Command::UseSounds(true))), [Rhythm::Long], "who switches it on hears it");
    for (value, rhythm) in [("25.010", Rhythm::Long), ("24.990", Rhythm::Two), ("25.030", Rhythm::Three)] {
        assert_eq!(judged(&mut session, value), [rhythm], "{value}");
    }
    assert_eq!(judged(&mut session, "25.o1"), [], "what is no value has no verdict");
}

#[test]
fn a_simulated_value_is_not_heard() {
    let mut session = checking();
    send(&mut session, Command::UseSounds(true));
    act(&mut session, CheckAction::MeasureBy(MeasureBy::Simulating).into());
    let effects = act(&mut session, CheckAction::Measure.into());
    assert_eq!(session.history().len(), 1);
    assert_eq!(heard(&effects), []);
}

#[test]
fn the_setting_survives_a_restart_and_is_found_on_the_settings_page() {
    let mut session = checking();
    send(&mut session, Command::OpenPage(Page::Settings));
    let action = Action::Settings(SettingsAction::Sounds);
    assert_eq!(action.is_on(&session), Some(false));
    act(&mut session, action);
    let (again, _) = Session::restore(session.saved());
    assert!(again.has_sounds());
}
