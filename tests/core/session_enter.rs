//! What Enter does: the highlighted answer to what is asked, no answer in passing, and nothing twice.

use fitcheck::session::{CheckAction, CheckCommand, CheckField, Command, Effect, Field, Page, Saved, Session};
use fitcheck::session::{PartsAction, WalkField};
use fitcheck::tolerance::Feature;
use fitcheck::verdict::Status;
use fitcheck::words::Language;
use jiff::ToSpan as _;
use jiff::civil::{DateTime, date};

use crate::session_walk;

fn after(milliseconds: i64) -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0).checked_add(milliseconds.milliseconds()).unwrap()
}

fn send(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), after(0))
}

fn typed(session: &mut Session, field: impl Into<Field>, text: &str) {
    let command = field.into().typed(text.to_owned());
    session.apply(command, after(0));
}

fn enter(session: &mut Session, field: impl Into<Field>, milliseconds: i64) -> Vec<Effect> {
    session.apply(Command::Enter(field.into()), after(milliseconds))
}

/// A check page with callout and value.
fn with(callout: &str, measured: &str) -> Session {
    let mut session = Session::new(Language::En);
    typed(&mut session, CheckField::Callout, callout);
    typed(&mut session, CheckField::Measured, measured);
    session
}

fn measured(session: &Session) -> Vec<String> {
    session.history().iter().map(|record| record.measurement.diameter.to_string()).collect()
}

#[test]
fn enter_gives_the_highlighted_answer_of_every_question() {
    // 2501 mm is asked about, and "use 25.010" is what is highlighted.
    for (value, first, taken) in [
        ("2501", CheckAction::TakeMeant, "25.01"),
        ("26", CheckAction::JudgeAnyway, "26"),
        ("250.12", CheckAction::TakeMeant, "25.012"),
    ] {
        let mut session = with("25 H7", value);
        enter(&mut session, CheckField::Measured, 0);
        assert_eq!(session.answers().first(), Some(&first.into()), "{value}");
        assert_eq!(session.on_enter(CheckField::Measured.into()), Some(first.into()));
        enter(&mut session, CheckField::Measured, 600);
        assert_eq!(measured(&session), [taken], "{value}");
    }
    for (value, first, taken) in
        [("25013", PartsAction::TakeMeantValue, "25.013"), ("26", PartsAction::TakeValue, "26")]
    {
        let mut session = session_walk::walking_by(
            "fitcheck_plan = 1\npart = \"Flange\"\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n",
        );
        typed(&mut session, WalkField::Value, value);
        enter(&mut session, WalkField::Value, 0);
        assert_eq!(session.answers().first(), Some(&first.into()), "{value}");
        assert_eq!(session.on_enter(WalkField::Value.into()), Some(first.into()));
        enter(&mut session, WalkField::Value, 1_000);
        assert_eq!(session.parts().walking.values(0)[0].record.measurement.diameter.to_string(), taken);
    }
}

#[test]
fn no_enter_answers_in_passing() {
    let mut session = with("25 H7", "2501");
    enter(&mut session, CheckField::Measured, 0);
    for milliseconds in [1, 30, 499, 900] {
        enter(&mut session, CheckField::Measured, milliseconds);
        assert_eq!(measured(&session), [""; 0], "{milliseconds} ms");
    }
    enter(&mut session, CheckField::Measured, 1_500);
    assert_eq!(measured(&session), ["25.01"]);
}

#[test]
fn another_text_is_not_the_answer_to_a_question_about_the_one_before() {
    let plan = "fitcheck_plan = 1\npart = \"Flange\"\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n";
    let mut session = session_walk::walking_by(plan);
    typed(&mut session, WalkField::Value, "25013");
    enter(&mut session, WalkField::Value, 0);
    typed(&mut session, WalkField::Value, "25.03");
    enter(&mut session, WalkField::Value, 1_000);
    assert_eq!(session.parts().walking.values(0)[0].record.measurement.diameter.to_string(), "25.03");
}

#[test]
fn enter_twice_is_one_check() {
    let mut session = with("25 H7", "25.012");
    for milliseconds in [0, 5, 2_000] {
        enter(&mut session, CheckField::Measured, milliseconds);
    }
    assert_eq!(measured(&session), ["25.012"]);
    assert!(session.check().is_repeated);
    assert!(session.check().shown.is_some(), "its verdict stays");
    // The button does it again, but not where it was pressed twice at once.
    session.apply(CheckCommand::Measure.into(), after(300));
    assert_eq!(measured(&session), ["25.012"]);
    session.apply(CheckCommand::Measure.into(), after(2_500));
    assert_eq!(measured(&session), ["25.012", "25.012"]);
    // Typed again it is another measurement.
    typed(&mut session, CheckField::Measured, "25.012");
    assert!(!session.check().is_repeated);
    enter(&mut session, CheckField::Measured, 3_000);
    assert_eq!(measured(&session).len(), 3);
    // An old check that is shown again is not measured again.
    send(&mut session, CheckCommand::Show(fitcheck::journal::query::RecordId(0)));
    enter(&mut session, CheckField::Measured, 4_000);
    assert_eq!(measured(&session).len(), 3);
}

#[test]
fn the_value_of_one_part_is_not_judged_for_the_serial_number_of_the_next_one() {
    for field in [CheckField::Serial, CheckField::Part, CheckField::Remark] {
        let mut session = with("25 H7", "25.012");
        enter(&mut session, CheckField::Measured, 0);
        typed(&mut session, field, "A-0002");
        enter(&mut session, field, 100);
        assert_eq!((measured(&session).len(), session.text(CheckField::Measured)), (1, ""), "{field:?}");
    }
    // A value that waits for its serial number stays.
    let mut session = with("25 H7", "25.012");
    typed(&mut session, CheckField::Serial, "A-0002");
    enter(&mut session, CheckField::Serial, 0);
    assert_eq!(measured(&session), ["25.012"]);
}

#[test]
fn hole_or_shaft_is_chosen_for_each_callout_that_does_not_say_it() {
    let mut session = with("25 +0.021 0", "25.030");
    send(&mut session, CheckCommand::ChooseFeature(Some(Feature::Hole)));
    enter(&mut session, CheckField::Measured, 0);
    assert_eq!(session.check().shown.as_ref().unwrap().record.verdict.status(), Status::Scrap);
    typed(&mut session, CheckField::Callout, "40 0 -0.025");
    assert_eq!((session.check().feature(), session.check().asked.limits.as_ref().unwrap().feature), (None, None));
    typed(&mut session, CheckField::Measured, "40.017");
    enter(&mut session, CheckField::Measured, 100);
    let status = |session: &Session| session.check().shown.as_ref().map(|shown| shown.record.verdict.status());
    assert_eq!((measured(&session).len(), status(&session)), (2, Some(Status::OutOfLimits)));
    // Said afterwards, the same value is judged again at once, and stands once.
    send(&mut session, CheckCommand::ChooseFeature(Some(Feature::Shaft)));
    assert_eq!((session.text(CheckField::Measured), status(&session)), ("40.017", Some(Status::Rework)));
    assert_eq!((measured(&session).len(), session.check().feature()), (2, Some(Feature::Shaft)));
    // The same callout, written otherwise, is the same.
    typed(&mut session, CheckField::Callout, "40  0 -0,025");
    assert_eq!(session.check().feature(), Some(Feature::Shaft));
    // Nothing of it is there after a restart.
    let (again, _) = Session::restore(Saved::read(&session.saved().write().unwrap()).unwrap());
    assert_eq!((again.check().feature(), again.text(CheckField::Callout)), (None, "40  0 -0,025"));
}

#[test]
fn a_serial_number_is_never_a_value() {
    let plan = "fitcheck_plan = 1\npart = \"Flange\"\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n[[feature]]\nname = \"B\"\ncallout = \"20 H7\"\n";
    let mut session = session_walk::walking_by(plan);
    let serial = session.parts().walking.serial().to_owned();
    for scanned in [serial.as_str(), "A-0100", "B-7788"] {
        typed(&mut session, WalkField::Value, scanned);
        assert_eq!(session.text(WalkField::Value), "", "{scanned} does not stay");
        assert!(session.error(WalkField::Value).unwrap().to_string().contains("serial number"), "{scanned}");
        assert_eq!(enter(&mut session, WalkField::Value, 10), []);
    }
    typed(&mut session, WalkField::Value, "25.01");
    enter(&mut session, WalkField::Value, 20);
    assert_eq!(session.parts().walking.values(0).len(), 1);
}

#[test]
fn the_page_is_about_the_size_whose_verdict_is_new_until_the_next_one_is_begun() {
    let plan = "fitcheck_plan = 1\npart = \"Flange\"\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n[[feature]]\nname = \"B\"\ncallout = \"20 H7\"\n";
    let mut session = session_walk::walking_by(plan);
    typed(&mut session, WalkField::Value, "25.03");
    enter(&mut session, WalkField::Value, 0);
    let faced = |session: &Session| session.parts().walking.faced();
    let walking = &session.parts().walking;
    assert_eq!((walking.at, walking.faced(), walking.faced_value().map(|(at, _)| at)), (Some(1), Some(0), Some(0)));
    typed(&mut session, WalkField::Value, "2");
    assert_eq!((faced(&session), session.parts().walking.faced_value().is_none()), (Some(1), true));
    // A size that is chosen is begun, too.
    send(&mut session, fitcheck::session::parts::WalkCommand::Go(0));
    assert_eq!(session.parts().walking.faced_value().map(|(at, _)| at), Some(0));
}

#[test]
fn enter_does_what_it_is_for_where_nothing_is_asked() {
    let session = with("25 H7", "25.012");
    assert_eq!(session.on_enter(CheckField::Callout.into()), Some(CheckAction::Measure.into()));
    assert_eq!(session.on_enter(CheckField::HistoryFilter.into()), None);
    assert_eq!((session.page(), session.answers()), (Page::Check, Vec::new()));
}
