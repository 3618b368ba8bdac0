//! Gauges on ports, without a port: lines come in, checks go out, and what gives no check is told.

use fitcheck::exchange::gauge::{LineUnit, Taught};
use fitcheck::gauges::{News, PortSettings, Refusal, Trouble};
use fitcheck::session::{
    CheckField, Command, Effect, Field, GaugeAction, GaugeCommand, Mode, Page, PartsAction, PortState, Purpose, Saved,
    SavedGauge, Section, Session, SettingsAction, SettingsCommand, SettingsField, WalkField,
};
use fitcheck::words::Language;
use jiff::ToSpan as _;

use crate::session_walk::{act, begin_records, kept, now, open_journal, said, send, typed, walking_by};

const PORT: &str = "/dev/ttyUSB0";

const PLAN: &str = r#"fitcheck_plan = 1
part = "Flange"
[[feature]]
name = "A"
callout = "25 H7"
[[feature]]
name = "B"
callout = "25 H7"
[[feature]]
name = "C"
callout = "20 g6"
"#;

fn gauge(command: GaugeCommand) -> Command {
    SettingsCommand::Gauge(command).into()
}

/// Adds a gauge to a session, and opens its port; returns its number.
fn connected(session: &mut Session, unit: LineUnit) -> u64 {
    send(session, gauge(GaugeCommand::Add));
    typed(session, SettingsField::GaugeName, "Bench 1");
    typed(session, SettingsField::GaugePort, PORT);
    send(session, gauge(GaugeCommand::UseUnit(unit)));
    let effects = send(session, gauge(GaugeCommand::Connect(true)));
    let run = opened(&effects).expect("a port is opened");
    send(session, Command::Heard { run, news: News::Opened });
    run
}

fn opened(effects: &[Effect]) -> Option<u64> {
    effects.iter().find_map(|effect| if let Effect::OpenGauge { run, .. } = effect { Some(*run) } else { None })
}

/// The check page with a callout, recorded, and a gauge that sends millimetres.
fn checking() -> (Session, u64) {
    let mut session = Session::new(Language::En);
    begin_records(&mut session);
    open_journal(&mut session, 7);
    let run = connected(&mut session, LineUnit::Mm);
    typed(&mut session, CheckField::Callout, "25 H7");
    (session, run)
}

fn hear_after(session: &mut Session, run: u64, milliseconds: i64, news: News) -> Vec<Effect> {
    session.apply(Command::Heard { run, news }, now().checked_add(milliseconds.milliseconds()).unwrap())
}

fn line_after(session: &mut Session, run: u64, milliseconds: i64, line: &str) -> Vec<Effect> {
    hear_after(session, run, milliseconds, News::Line(line.to_owned()))
}

fn line(session: &mut Session, run: u64, text: &str) -> Vec<Effect> {
    line_after(session, run, 0, text)
}

fn noticed(session: &Session) -> Vec<String> {
    session.notices().iter().map(|notice| said(&notice.message)).collect()
}

#[test]
fn a_value_is_checked_as_if_it_had_been_typed_and_says_with_which_gauge() {
    let (mut session, run) = checking();
    let effects = line(&mut session, run, "01A+0025.0120");
    let (_, entries) = kept(&effects);
    assert_eq!(entries[0].about.remark, "measured with Bench 1");
    let shown = session.check().shown.as_ref().unwrap();
    assert_eq!(shown.record.measured(), "25.012".parse().unwrap());
    assert!(!shown.record.measurement.origin.is_simulated());
    let from = session.check().gauge.as_ref().unwrap();
    assert_eq!((from.name.as_str(), from.remarks.len()), ("Bench 1", 1));
    assert_eq!(noticed(&session), Vec::<String>::new());
    // What is typed next is not from the gauge.
    typed(&mut session, CheckField::Measured, "25.013");
    let (_, entries) = kept(&session.apply(Command::Enter(CheckField::Measured.into()), now()));
    assert_eq!(entries[0].about.remark, "");
}

#[test]
fn values_go_through_the_sizes_of_a_part() {
    let mut session = walking_by(PLAN);
    let run = connected(&mut session, LineUnit::Mm);
    line(&mut session, run, "25.010");
    let effects = line_after(&mut session, run, 1_500, "25.011");
    let (_, entries) = kept(&effects);
    assert_eq!((entries[0].about.feature.as_str(), entries[0].about.remark.as_str()), ("B", "measured with Bench 1"));
    assert_eq!(session.parts().walking.at, Some(2));
}

#[test]
fn ten_values_a_second_do_not_run_through_ten_features() {
    let mut session = walking_by(PLAN);
    let run = connected(&mut session, LineUnit::Mm);
    for tenth in 0..30 {
        line_after(&mut session, run, tenth * 100, "25.010");
    }
    assert_eq!(session.history().len(), 1);
    let told = noticed(&session);
    assert_eq!(
        told,
        [
            "Bench 1: 29 lines are not used, the last one 25.01: it came less than a second after another value of the gauge"
        ]
    );
    // After a second without one the next is taken.
    line_after(&mut session, run, 2_900 + 1_000, "25.011");
    assert_eq!(session.history().len(), 2);
}

#[test]
fn a_doubtful_value_is_asked_about_and_the_next_one_is_no_answer() {
    let (mut session, run) = checking();
    line(&mut session, run, "250.12");
    assert!(session.check().question.is_some(), "a value far away is doubted, as a typed one is");
    assert!(session.history().is_empty());
    line_after(&mut session, run, 5_000, "25.012");
    assert!(session.check().question.is_some() && session.history().is_empty());
    assert_eq!(
        noticed(&session),
        ["Bench 1: 25.012 is not used: the page asks something: answer it and measure again"]
    );
}

#[test]
fn after_a_verdict_that_is_not_good_nothing_is_taken_for_a_second() {
    let (mut session, run) = checking();
    line(&mut session, run, "25.031");
    assert_eq!(session.history().len(), 1);
    let other = connected(&mut session, LineUnit::Mm);
    line_after(&mut session, other, 999, "25.012");
    assert_eq!(session.history().len(), 1);
    assert!(noticed(&session)[0].contains("the verdict before it is not good"), "{:?}", noticed(&session));
    line_after(&mut session, run, 1_000, "25.012");
    assert_eq!(session.history().len(), 2);
}

#[test]
fn what_comes_over_another_page_or_below_a_dialog_is_told_with_its_value() {
    let (mut session, run) = checking();
    send(&mut session, Command::OpenPage(Page::Fit));
    line(&mut session, run, "25.012");
    assert_eq!(noticed(&session), ["Bench 1: 25.012 is not used: no value is asked for: open Check or measure a part"]);
    send(&mut session, Command::OpenPage(Page::Check));
    send(&mut session, Command::OpenDialog(Purpose::Import));
    line_after(&mut session, run, 2_000, "25.013");
    let told = noticed(&session);
    assert_eq!(
        told,
        [
            "Bench 1: 2 lines are not used, the last one 25.013: something else is open over the page: close it and measure again"
        ]
    );
    assert!(session.history().is_empty());
}

#[test]
fn a_value_that_is_being_typed_stays() {
    let (mut session, run) = checking();
    typed(&mut session, CheckField::Measured, "25.");
    line(&mut session, run, "25.012");
    assert_eq!(session.text(CheckField::Measured), "25.");
    assert!(noticed(&session)[0].contains("a value is being typed"));
}

#[test]
fn garbage_half_a_line_and_an_inch_that_nobody_said_give_no_check() {
    let (mut session, run) = checking();
    send(&mut session, gauge(GaugeCommand::UseUnit(LineUnit::Said)));
    line(&mut session, run, "0.98472");
    assert_eq!(
        noticed(&session),
        [
            "Bench 1: 0.98472 is not used: 0.98472 names no unit: say in the settings of the gauge whether it sends millimetres or inches"
        ]
    );
    for news in [
        News::Line("ERR".to_owned()),
        News::Line(String::new()),
        News::Line("25.0\u{0}12".to_owned()),
        News::Refused(Refusal::Half { given: "25.0".to_owned() }),
        News::Refused(Refusal::NotText { given: "\\xff".to_owned() }),
        News::Refused(Refusal::TooLong { most: 200 }),
    ] {
        hear_after(&mut session, run, 5_000, news);
        assert_eq!(session.notices().len(), 1, "one notice for all of a gauge");
    }
    assert!(session.history().is_empty());
    line_after(&mut session, run, 9_000, "0.98472 in");
    assert_eq!(session.check().shown.as_ref().unwrap().record.measured(), "25.011888".parse().unwrap());
}

#[test]
fn a_taught_gauge_refuses_what_looks_otherwise() {
    let (mut session, run) = checking();
    send(&mut session, Command::OpenPage(Page::Settings));
    send(&mut session, SettingsCommand::Show(Section::Gauges));
    line(&mut session, run, "No. 1;DIA=25.0123;OK");
    let page = session.settings_page();
    assert!(page.gauges.shown().unwrap().lines().next().unwrap().read.is_err());
    assert_eq!(noticed(&session), Vec::<String>::new(), "here it is listed");
    typed(&mut session, SettingsField::GaugeGave, "25.0124");
    act(&mut session, SettingsAction::Gauge(GaugeAction::Teach).into());
    assert!(said(session.error(SettingsField::GaugeGave).unwrap()).contains("does not stand in the line"));
    typed(&mut session, SettingsField::GaugeGave, "25.0123");
    act(&mut session, SettingsAction::Gauge(GaugeAction::Teach).into());
    assert_eq!(session.error(SettingsField::GaugeGave), None);
    let line_read = session.settings_page().gauges.shown().unwrap().lines().next().unwrap().read.clone();
    assert_eq!(line_read.unwrap().value, "25.0123".parse().unwrap());
    send(&mut session, Command::OpenPage(Page::Check));
    line_after(&mut session, run, 2_000, "No. 2;DIA=25.0098;NG");
    assert!(session.history().is_empty());
    line_after(&mut session, run, 4_000, "No. 3;DIA=25.0098;OK");
    assert_eq!(session.history().len(), 1);
    // It is taught after a restart, too, and its port is opened again.
    let text = String::from_utf8(session.saved().write().unwrap()).unwrap();
    assert!(text.contains("line = \"No. 1;DIA=25.0123;OK\"") && text.contains("gave = \"25.0123\""), "{text}");
    let (restored, effects) = Session::restore(Saved::read(text.as_bytes()).unwrap());
    assert_eq!(restored.saved().gauges, session.saved().gauges);
    assert!(opened(&effects).is_some());
}

#[test]
fn an_unplugged_gauge_is_told_and_so_is_that_it_is_back() {
    let (mut session, run) = checking();
    let lost = News::Lost(Trouble::Unplugged { port: PORT.to_owned() });
    send(&mut session, Command::Heard { run, news: lost });
    assert_eq!(noticed(&session), ["Bench 1: the gauge at /dev/ttyUSB0 is gone: plug it in again"]);
    let state = |session: &Session| session.settings_page().gauges.shown().unwrap().state.clone();
    assert!(matches!(state(&session), PortState::Lost(_)));
    send(&mut session, Command::Heard { run, news: News::Back });
    assert_eq!((state(&session), noticed(&session)), (PortState::Open, vec!["Bench 1 is connected again".to_owned()]));
}

#[test]
fn a_port_is_opened_anew_with_other_settings_and_what_the_old_one_says_is_nothing() {
    let (mut session, old) = checking();
    let effects =
        act(&mut session, SettingsAction::Gauge(GaugeAction::UseParity(fitcheck::gauges::Parity::Even)).into());
    let new = opened(&effects).unwrap();
    assert!(effects.contains(&Effect::CloseGauge(old)) && new != old);
    line(&mut session, old, "25.012");
    assert!(session.history().is_empty());
    // While a name is typed nothing is opened.
    typed(&mut session, SettingsField::GaugePort, "COM");
    assert_eq!(session.settings_page().gauges.shown().unwrap().state, PortState::Closed);
    typed(&mut session, SettingsField::GaugeSpeed, "fast");
    assert!(session.error(SettingsField::GaugeSpeed).is_some());
    assert_eq!(opened(&act(&mut session, SettingsAction::Gauge(GaugeAction::Connect).into())), None);
    typed(&mut session, SettingsField::GaugeSpeed, "4800");
    let effects = act(&mut session, SettingsAction::Gauge(GaugeAction::Connect).into());
    let settings = PortSettings {
        port: "COM".to_owned(),
        speed: 4_800,
        parity: fitcheck::gauges::Parity::Even,
        ..PortSettings::default()
    };
    assert!(effects.iter().any(|effect| matches!(effect, Effect::OpenGauge { settings: of, .. } if *of == settings)));
    let effects = act(&mut session, SettingsAction::Gauge(GaugeAction::Remove).into());
    assert!(effects.iter().any(|effect| matches!(effect, Effect::CloseGauge(_))));
    assert_eq!(session.text(Field::from(SettingsField::GaugePort)), "");
}

#[test]
fn a_gauge_without_a_port_is_not_connected() {
    let mut session = Session::new(Language::En);
    send(&mut session, gauge(GaugeCommand::Add));
    assert_eq!(opened(&send(&mut session, gauge(GaugeCommand::Connect(true)))), None);
    assert_eq!(said(session.error(SettingsField::GaugePort).unwrap()), "Choose the port of the gauge first");
}

#[test]
fn gauges_of_a_state_file_are_readable_and_default_to_nothing() {
    let saved = Saved::read(b"version = 1\n").unwrap();
    assert_eq!(saved.gauges, []);
    let taught = Taught::by("D 25.0123", "25.0123".parse().unwrap()).unwrap();
    let gauge = SavedGauge { name: "Bench 1".to_owned(), taught: Some(taught), ..SavedGauge::default() };
    let mut saved = Saved::default();
    saved.gauges.push(gauge);
    assert_eq!(Saved::read(&saved.write().unwrap()).unwrap(), saved);
}

#[test]
fn a_value_below_a_question_of_the_walk_stays_out() {
    let mut session = walking_by(PLAN);
    let run = connected(&mut session, LineUnit::Mm);
    line(&mut session, run, "250.1");
    assert!(session.parts().walking.question.is_some());
    line_after(&mut session, run, 3_000, "25.01");
    assert!(session.parts().walking.question.is_some() && session.history().is_empty());
    // Taken anyway, it is still from the gauge.
    let effects =
        session.apply(PartsAction::TakeValue.command(&session).unwrap(), now().checked_add(9.seconds()).unwrap());
    assert_eq!(kept(&effects).1[0].about.remark, "measured with Bench 1");
    assert_eq!(session.text(WalkField::Value), "");
}

#[test]
fn an_operator_reads_a_verdict_that_is_not_good_before_the_next_value_is_taken() {
    let of_a_part = || {
        let mut session = walking_by(PLAN);
        let run = connected(&mut session, LineUnit::Mm);
        (session, run)
    };
    let begins: [&dyn Fn() -> (Session, u64); 2] = [&checking, &of_a_part];
    for begin in begins {
        let (mut session, run) = begin();
        send(&mut session, Command::SetMode(Mode::Operator));
        let page = session.page();
        line(&mut session, run, "25.010");
        line_after(&mut session, run, 2_000, "25.030");
        assert_eq!(session.history().len(), 2, "after GOOD the next value is taken, {page:?}");
        line_after(&mut session, run, 9_000, "25.011");
        assert_eq!(session.history().len(), 2, "SCRAP was not read yet, {page:?}");
        assert!(session.rests(), "the verdict stays, {page:?}");
        assert!(noticed(&session).iter().any(|said| said.contains("was not read yet")), "{:?}", noticed(&session));
        send(&mut session, Command::GoOn);
        let next = if page == Page::Check { "25.012" } else { "19.990" };
        line_after(&mut session, run, 12_000, next);
        assert_eq!(session.history().len(), 3, "{page:?}");
    }
}
