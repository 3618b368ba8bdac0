//! No verdict stands beside anything that it was not made with: random edits and events over all pages.

use std::path::PathBuf;
use std::sync::Arc;

use fitcheck::exchange::import;
use fitcheck::files::FileError;
use fitcheck::journal::Record;
use fitcheck::journal::query::{Column, RecordId};
use fitcheck::length::Length;
use fitcheck::message::Say as _;
use fitcheck::probing::Origin;
use fitcheck::session::program::{Input, WorkpieceFrom};
use fitcheck::session::{
    CheckCommand, CheckField, Command, ContactsFrom, CycleField, CyclesCommand, FitCommand, FitField, ListCommand,
    MeasureBy, Page, ProgramCommand, ProgramField, Session, Step, UncertaintyFrom, WorkpieceCommand,
};
use fitcheck::tolerance::{Base, Feature};
use fitcheck::verdict::rules::{Prover, RuleName};
use fitcheck::verdict::{Status, judge_by};
use fitcheck::words::{Dialogue, Language};
use jiff::civil::{DateTime, date};
use proptest::prelude::*;
use proptest::sample::select;

fn now() -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0)
}

const ROWS: &[u8] = b"id,callout,measured\nA1,25 H7,25.012\nA2,25 H7,25.030\nA3,40 g6,39.98\nA4,25 Q9,25\nA5,,25\n";
const ONE: &[u8] = b"id,callout,measured\nB1,25 H7,24.998\n";
const CONTACTS: &[u8] = b"x,y\n12.506,0\n0,12.506\n-12.506,0\n0,-12.506\n";

/// What a user or a file does; a command may need the state.
#[derive(Debug, Clone)]
enum Act {
    Do(Command),
    Import(&'static [u8]),
    Log,
    Cycle(&'static str, &'static str),
}

impl Act {
    fn run(&self, session: &mut Session) {
        let import = |session: &Session, name: &str, bytes: &[u8]| {
            let imported = import(name, bytes, session.sources(), now());
            CheckCommand::Imported { name: name.to_owned(), result: Ok(Box::new(imported)) }.into()
        };
        let command = match self {
            Self::Do(command) => command.clone(),
            Self::Import(bytes) => import(session, "parts.csv", bytes),
            Self::Log => {
                let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/logs/en/TCHPR421.TXT");
                import(session, "TCHPR421.TXT", &std::fs::read(path).unwrap())
            }
            Self::Cycle(name, text) => {
                let Some(parameter) = session.cycles().cycle.parameter_named(name) else { return };
                CyclesCommand::Type(CycleField::Parameter(parameter.key), (*text).to_owned()).into()
            }
        };
        session.apply(command, now());
    }
}

fn one_of<T: Clone + std::fmt::Debug + 'static>(all: Vec<T>) -> impl Strategy<Value = T> {
    select(all)
}

fn typed_of_check() -> impl Strategy<Value = Command> {
    const CALLOUTS: [&str; 9] = ["25 H7", "500 H7", "25 h6", "25 H7/g6", "12 +0.01 -0.015", "10m", "25 X", "", "40 g6"];
    const MEASURED: [&str; 10] =
        ["500.01", "25.012", "25.030", "24.998", "25.03O", "", "250.12", "12.005", "39.98", "12.506"];
    prop_oneof![
        4 => select(CALLOUTS.as_slice()).prop_map(|text| (CheckField::Callout, text)),
        4 => select(MEASURED.as_slice()).prop_map(|text| (CheckField::Measured, text)),
        1 => select(["", "A1", "B 2"].as_slice()).prop_map(|text| (CheckField::Part, text)),
        1 => select(["25", "40", "x"].as_slice()).prop_map(|text| (CheckField::Nominal, text)),
        1 => select(["0", "0.1", "x"].as_slice()).prop_map(|text| (CheckField::CentreX, text)),
        1 => select(["0", "0.001", "-1"].as_slice()).prop_map(|text| (CheckField::CentreTolerance, text)),
        1 => select(["", "25.03", "24.9"].as_slice()).prop_map(|text| (CheckField::TrueDiameter, text)),
        1 => select(["0.003", "0.5", "100"].as_slice()).prop_map(|text| (CheckField::OffsetX, text)),
        1 => select(["3", "5", "three"].as_slice()).prop_map(|text| (CheckField::Lobes, text)),
        1 => select(["0", "0.002"].as_slice()).prop_map(|text| (CheckField::LobeHeight, text)),
        1 => select(["1", "7", "x"].as_slice()).prop_map(|text| (CheckField::Seed, text)),
        2 => select(["1.2", "20", "", "x"].as_slice()).prop_map(|text| (CheckField::Uncertainty, text)),
        1 => select(["2", "3", "0"].as_slice()).prop_map(|text| (CheckField::Coverage, text)),
        1 => select(["2", "0", ""].as_slice()).prop_map(|text| (CheckField::GuardWidth, text)),
        1 => select(["24", "20", "", "hot"].as_slice()).prop_map(|text| (CheckField::PartTemperature, text)),
        1 => select(["22", ""].as_slice()).prop_map(|text| (CheckField::ScaleTemperature, text)),
    ]
    .prop_map(|(field, text)| CheckCommand::Type(field, text.to_owned()).into())
}

fn check_act() -> impl Strategy<Value = Act> {
    let events = one_of(vec![
        Command::Check(CheckCommand::Measure),
        CheckCommand::TakeMeant.into(),
        CheckCommand::MeasureBy(MeasureBy::Typing).into(),
        CheckCommand::MeasureBy(MeasureBy::Simulating).into(),
        CheckCommand::ChooseFeature(Some(Feature::Hole)).into(),
        CheckCommand::ChooseFeature(Some(Feature::Shaft)).into(),
        CheckCommand::ChooseClass("H8".parse().unwrap()).into(),
        CheckCommand::UseRule(RuleName::Simple).into(),
        CheckCommand::UseRule(RuleName::Iso14253Of2017).into(),
        CheckCommand::UseRule(RuleName::Fixed).into(),
        CheckCommand::LetProve(Prover::Customer).into(),
        CheckCommand::TellUncertainty(UncertaintyFrom::Expanded).into(),
        CheckCommand::TellUncertainty(UncertaintyFrom::Standard).into(),
        CheckCommand::Clear.into(),
        CheckCommand::Show(RecordId(0)).into(),
        CheckCommand::Show(RecordId(2)).into(),
        CheckCommand::ShowInLot(Step::Right).into(),
        CheckCommand::ShowInLot(Step::Last).into(),
        CheckCommand::ClearHistory.into(),
        CheckCommand::Undo.into(),
        ListCommand::Move(Step::Down).into(),
        ListCommand::OnlyBad(true).into(),
        ListCommand::SortBy(Column::Measured).into(),
        CheckCommand::Imported {
            name: "none.csv".to_owned(),
            result: Err(FileError::Missing { path: "none.csv".into() }.message()),
        }
        .into(),
    ]);
    prop_oneof![
        6 => typed_of_check().prop_map(Act::Do),
        4 => Just(Act::Do(CheckCommand::Measure.into())),
        4 => events.prop_map(Act::Do),
        1 => one_of(vec![Act::Import(ROWS), Act::Import(ONE), Act::Import(CONTACTS), Act::Log]),
    ]
}

fn other_act() -> impl Strategy<Value = Act> {
    let program = |field, text: &str| ProgramCommand::Type(field, text.to_owned()).into();
    let fit = |field, text: &str| FitCommand::Type(field, text.to_owned()).into();
    let of_pages = one_of(vec![
        Act::Cycle("Q262", "25"),
        Act::Cycle("Q273", "50"),
        Act::Cycle("Q274", "50"),
        Act::Cycle("Q275", "25.021"),
        Act::Cycle("Q276", "25"),
        Act::Cycle("Q276", "25.01"),
        Act::Cycle("Q261", "-5"),
        Act::Cycle("Q260", "20"),
        Act::Do(CyclesCommand::Run.into()),
        Act::Do(CyclesCommand::Run.into()),
        Act::Do(CyclesCommand::From(ContactsFrom::Simulated).into()),
        Act::Do(CyclesCommand::From(ContactsFrom::Perfect).into()),
        Act::Do(CyclesCommand::ChooseProbe(1).into()),
        Act::Do(CyclesCommand::Choose(421).into()),
        Act::Do(WorkpieceCommand::Suit.into()),
        Act::Do(program(ProgramField::Input(Input::Size), "25")),
        Act::Do(program(ProgramField::Input(Input::Class), "H8")),
        Act::Do(program(ProgramField::Input(Input::Class), "h6")),
        Act::Do(program(ProgramField::Diameter, "25.03")),
        Act::Do(ProgramCommand::ChooseWorkpiece(WorkpieceFrom::Given).into()),
        Act::Do(ProgramCommand::ChooseWorkpiece(WorkpieceFrom::Perfect).into()),
        Act::Do(ProgramCommand::ChooseWorkpiece(WorkpieceFrom::Simulated).into()),
        Act::Do(ProgramCommand::Run.into()),
        Act::Do(ProgramCommand::Run.into()),
        Act::Do(ProgramCommand::Tick.into()),
        Act::Do(fit(FitField::Callout, "25 H7/g6")),
        Act::Do(fit(FitField::Callout, "25 H7/")),
        Act::Do(fit(FitField::HoleMeasured, "25.01")),
        Act::Do(fit(FitField::HoleMeasured, "25.01O")),
        Act::Do(fit(FitField::ShaftMeasured, "24.99")),
        Act::Do(fit(FitField::ShaftMeasured, "")),
        Act::Do(FitCommand::Check(Feature::Hole).into()),
    ]);
    let everywhere = one_of(vec![
        Command::UseSource(Base::ALL.into_iter().next().unwrap()),
        Command::UseSource(Base::ALL.into_iter().next_back().unwrap()),
        Command::NoOwnTables,
        Command::SetLanguage(Language::Nl),
        Command::SetMask(Some(Dialogue::De)),
        Command::OpenPage(Page::Check),
        Command::OpenPage(Page::Program),
        Command::OpenPage(Page::Cycles),
    ]);
    prop_oneof![4 => of_pages, 1 => everywhere.prop_map(Act::Do)]
}

/// What stands in the fields is what the shown verdict was made with.
fn the_check_page_agrees_with_itself(session: &Session) {
    let page = session.check();
    let Some(shown) = page.shown.as_ref() else { return };
    let record = &shown.record;
    assert!(page.question.is_none());
    assert!(session.history().iter().any(|of_history| Arc::ptr_eq(of_history, record)));
    assert_eq!(page.asked.limits.as_ref(), Some(&record.limits));
    for field in [CheckField::Callout, CheckField::Measured] {
        assert_eq!(session.error(field), None, "{field:?}");
    }
    assert_eq!((session.culprit(CheckField::Callout), page.refusal.as_ref()), (None, None));
    the_position_agrees(session, record);
    assert_eq!(session.text(CheckField::Part).trim(), record.id);
    let callout = page.asked.callout.map(|callout| callout.of_part(record.limits.feature));
    assert_eq!(callout, record.callout);
    assert_eq!(callout.is_none(), session.text(CheckField::Callout).is_empty());
    match record.measurement.origin {
        Origin::Typed => {
            let measured = record.correction.map_or(record.measurement.diameter, |correction| correction.measured);
            assert_eq!(session.text(CheckField::Measured).parse::<Length>().unwrap(), measured);
        }
        _ => assert_eq!(session.text(CheckField::Measured), ""),
    }
    let again = judge_by(record.verdict.rule, &record.limits, record.measurement.diameter, record.verdict.position);
    assert_eq!(again, record.verdict);
    // The rule that judged stands in the fields, and so does the temperature.
    let worth = &page.asked.worth;
    assert_eq!(worth.rule(), Some(record.verdict.rule));
    let length = record.correction.map_or(record.measurement.diameter, |correction| correction.measured);
    assert_eq!(worth.correction(length), record.correction);
    let word = fitcheck::control::status::status_word(record.verdict.status(), session.drawn_with().0);
    assert!(shown.window.as_ref().unwrap().contains(word));
}

/// The position that a verdict was made with stands in its fields, and a simulation of the fields gives the record again.
fn the_position_agrees(session: &Session, record: &Record) {
    let page = session.check();
    if let (Some(position), Some(centre)) = (record.verdict.position, record.measurement.centre) {
        let tolerance = page.asked.length(CheckField::CentreTolerance).unwrap();
        let fields = [CheckField::CentreX, CheckField::CentreY];
        for ((axis, is), field) in position.axes.iter().zip(centre).zip(fields) {
            assert_eq!(axis.tolerance.unwrap_or(Length::ZERO), tolerance);
            assert_eq!(is.saturating_sub(axis.deviation), page.asked.length(field).unwrap(), "{field:?}");
        }
    }
    let Origin::Simulated { seed, .. } = record.measurement.origin else { return };
    let mut again = Session::new(Language::En);
    again.apply(Command::UseSource(session.sources().base()), now());
    run(&mut again, [typed(CheckField::Callout, session.text(CheckField::Callout))]);
    run(
        &mut again,
        [CheckCommand::ChooseFeature(record.limits.feature), CheckCommand::MeasureBy(MeasureBy::Simulating)],
    );
    let judging = page.asked.worth.judging;
    run(&mut again, [CheckCommand::UseRule(judging.rule), CheckCommand::LetProve(judging.prover)]);
    run(&mut again, [CheckCommand::TellUncertainty(judging.from)]);
    for field in SIMULATION.into_iter().chain(WORTH) {
        run(&mut again, [typed(field, session.text(field))]);
    }
    if again.check().asked.limits.as_ref() == Some(&record.limits) {
        run(&mut again, [typed(CheckField::Seed, &seed.to_string()), CheckCommand::Measure]);
        let made = &again.check().shown.as_ref().unwrap().record;
        assert_eq!((&made.measurement, &made.verdict), (&record.measurement, &record.verdict));
    }
}

/// Everything that a simulated measurement depends on, besides callout and seed.
const SIMULATION: [CheckField; 14] = [
    CheckField::CentreX,
    CheckField::CentreY,
    CheckField::Height,
    CheckField::FirstAngle,
    CheckField::Clearance,
    CheckField::CentreTolerance,
    CheckField::TrueDiameter,
    CheckField::OffsetX,
    CheckField::OffsetY,
    CheckField::Ovality,
    CheckField::Lobes,
    CheckField::LobeHeight,
    CheckField::SurfaceScatter,
    CheckField::ProbeScatter,
];

/// Everything that the judgement depends on.
const WORTH: [CheckField; 7] = [
    CheckField::Uncertainty,
    CheckField::Coverage,
    CheckField::GuardWidth,
    CheckField::PartTemperature,
    CheckField::PartExpansion,
    CheckField::ScaleTemperature,
    CheckField::ScaleExpansion,
];

/// What the other pages show is what they would show if everything were done once more.
fn the_other_pages_agree_with_themselves(session: &mut Session) {
    let cycles = |session: &Session| session.cycles().run.as_ref().map(|run| run.result.clone());
    if let Some(before) = cycles(session) {
        session.apply(CyclesCommand::Run.into(), now());
        assert_eq!(format!("{:?}", Some(before)), format!("{:?}", cycles(session)));
    }
    let status = |session: &Session| session.program().run.as_ref().map(|run| (run.status(), run.is_over()));
    if let Some((before, true)) = status(session) {
        session.apply(ProgramCommand::Reset.into(), now());
        session.apply(ProgramCommand::Run.into(), now());
        while session.program().is_running() {
            session.apply(ProgramCommand::Tick.into(), now());
        }
        assert_eq!(status(session).map(|(status, _)| status), Some(before));
    }
}

/// Whether an act changes what a verdict was made of, so that none may be left.
fn takes_away(act: &Act) -> bool {
    let Act::Do(command) = act else { return false };
    match command {
        Command::Check(command) => matches!(
            command,
            CheckCommand::Type(..)
                | CheckCommand::ChooseFeature(_)
                | CheckCommand::ChooseClass(_)
                | CheckCommand::Clear
                | CheckCommand::UseRule(_)
                | CheckCommand::LetProve(_)
                | CheckCommand::TellUncertainty(_)
        ),
        other => matches!(other, Command::UseSource(_) | Command::NoOwnTables),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn no_verdict_stands_beside_anything_that_it_was_not_made_with(
        acts in prop::collection::vec(prop_oneof![5 => check_act(), 1 => other_act()], 1..40)
    ) {
        let mut session = Session::new(Language::En);
        for act in &acts {
            act.run(&mut session);
            if takes_away(act) {
                let shown = session.check().shown.as_ref().map(|shown| shown.record.limits.feature);
                // Hole or shaft, said after the verdict, judges anew at once.
                let Act::Do(command) = act else { unreachable!("a file takes nothing away") };
                let is_anew = matches!(command, Command::Check(CheckCommand::ChooseFeature(of)) if Some(*of) == shown && of.is_some());
                prop_assert!(shown.is_none() || is_anew, "{act:?}");
            }
            the_check_page_agrees_with_itself(&session);
        }
    }

    #[test]
    fn the_other_pages_show_nothing_stale(
        acts in prop::collection::vec(other_act(), 1..30)
    ) {
        let mut session = Session::new(Language::En);
        session.apply(Command::OpenPage(Page::Program), now());
        for act in &acts {
            act.run(&mut session);
            the_other_pages_agree_with_themselves(&mut session);
        }
    }
}

fn run(session: &mut Session, commands: impl IntoIterator<Item = CheckCommand>) {
    for command in commands {
        session.apply(command.into(), now());
    }
}

fn typed(field: CheckField, text: &str) -> CheckCommand {
    CheckCommand::Type(field, text.to_owned())
}

fn status(session: &Session) -> Option<Status> {
    session.check().shown.as_ref().map(|shown| shown.record.verdict.status())
}

#[test]
fn a_mistyped_or_emptied_value_leaves_no_verdict() {
    let mut session = Session::new(Language::En);
    for edit in ["25.03O", "", "25.0120"] {
        run(&mut session, [typed(CheckField::Callout, "25 H7"), typed(CheckField::Measured, "25.012")]);
        run(&mut session, [CheckCommand::Measure]);
        assert_eq!(status(&session), Some(Status::Good));
        run(&mut session, [typed(CheckField::Measured, edit)]);
        assert_eq!(status(&session), None, "{edit:?} before Enter");
    }
    run(&mut session, [typed(CheckField::Measured, "25.03O"), CheckCommand::Measure]);
    assert_eq!(status(&session), None);
}

#[test]
fn a_value_far_from_the_nominal_size_is_asked_about_and_judged_at_the_second_enter() {
    // What it may have been, for 25 H7.
    for (measured, meant) in [
        ("250.12", Some("25.012")),
        ("2.5012", Some("25.012")),
        ("25012", Some("25.012")),
        ("0.98472", Some("25.011888")),
        ("12.506", Some("25.012")),
        ("50.024", Some("25.012")),
        ("30", None),
        ("24.4", None),
    ] {
        let mut session = Session::new(Language::En);
        run(&mut session, [typed(CheckField::Callout, "25 H7"), typed(CheckField::Measured, measured)]);
        run(&mut session, [CheckCommand::Measure]);
        let asked = session.check().question.as_ref().copied();
        assert_eq!((status(&session), session.history().len(), asked.is_some()), (None, 0, true), "{measured}");
        assert_eq!(asked.unwrap().doubt.meant().map(|length| length.to_string()).as_deref(), meant, "{measured}");
        let mut taken = Session::new(Language::En);
        run(&mut session, [CheckCommand::Measure]);
        assert!(matches!(status(&session), Some(Status::Scrap | Status::Rework)), "{measured}");
        run(&mut taken, [typed(CheckField::Callout, "25 H7"), typed(CheckField::Measured, measured)]);
        run(&mut taken, [CheckCommand::Measure, CheckCommand::TakeMeant]);
        assert_eq!(status(&taken), meant.map(|_| Status::Good), "{measured}");
    }
    // Honest values are judged at once.
    for measured in ["25.012", "24.6", "25.5", "24.998"] {
        let mut session = Session::new(Language::En);
        run(&mut session, [typed(CheckField::Callout, "25 H7"), typed(CheckField::Measured, measured)]);
        run(&mut session, [CheckCommand::Measure]);
        assert!(status(&session).is_some(), "{measured}");
    }
}

#[test]
fn another_value_is_asked_about_anew() {
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::Callout, "25 H7"), typed(CheckField::Measured, "250.12")]);
    run(&mut session, [CheckCommand::Measure, typed(CheckField::Measured, "250.13"), CheckCommand::Measure]);
    assert_eq!((status(&session), session.history().len()), (None, 0));
    assert!(session.check().question.is_some());
}

#[test]
fn many_rows_make_a_lot_with_the_worst_first() {
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::Measured, "9.9")]);
    Act::Import(ROWS).run(&mut session);
    let lot = session.check().lot.as_ref().unwrap().clone();
    let counts: Vec<_> = lot.counts().map(|(_, count)| count).collect();
    // 25.012 is good, 25.030 scrap, 39.98 is in 39.975 to 39.991.
    assert_eq!((counts, lot.unjudged, lot.refused, lot.rows), (vec![2, 0, 0, 0, 1], 1, 1, 5));
    assert_eq!((lot.shown(), status(&session)), (Some((1, 3)), Some(Status::Scrap)));
    assert_eq!(session.text(CheckField::Part), "A2");
    assert_eq!(session.text(CheckField::Measured), "", "nothing imported stays beside a typed value");
    run(&mut session, [CheckCommand::ShowInLot(Step::Last)]);
    assert_eq!((session.check().lot.as_ref().unwrap().shown(), status(&session)), (Some((3, 2)), Some(Status::Good)));
    run(&mut session, [CheckCommand::ShowInLot(Step::Left)]);
    // 5 µm from its nearer limit, against 9 µm.
    assert_eq!(session.text(CheckField::Part), "A3");
    run(&mut session, [typed(CheckField::Measured, "39.98")]);
    assert_eq!((session.check().lot.is_none(), session.text(CheckField::Part)), (true, ""));
}

#[test]
fn nothing_is_simulated_until_it_is_asked_for() {
    let session = Session::new(Language::En);
    assert_eq!(session.check().by, MeasureBy::Typing);
}

/// A check of 500 H7 by ISO 286, which the control's tables do not reach, shown again once those are the source.
fn shown_by_another_source() -> Session {
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::Callout, "500 H7"), typed(CheckField::Measured, "500.01")]);
    run(&mut session, [CheckCommand::Measure]);
    session.apply(Command::UseSource(Base::ControlTables), now());
    run(&mut session, [CheckCommand::Show(RecordId(0))]);
    assert_eq!(status(&session), Some(Status::Good));
    session
}

fn error(session: &Session, field: CheckField) -> Option<String> {
    session.error(field).map(ToString::to_string)
}

#[test]
fn a_check_shown_again_has_no_error_of_another_source_beside_it() {
    let session = shown_by_another_source();
    assert_eq!(error(&session, CheckField::Callout), None);
    // An import that was judged before the source was changed.
    let mut session = Session::new(Language::En);
    let rows = b"id,callout,measured\nA1,500 H7,500.01\n";
    let imported = import("parts.csv", rows, session.sources(), now());
    session.apply(Command::UseSource(Base::ControlTables), now());
    let imported = CheckCommand::Imported { name: "parts.csv".into(), result: Ok(Box::new(imported)) };
    run(&mut session, [imported]);
    assert_eq!((status(&session), error(&session, CheckField::Callout)), (Some(Status::Good), None));
}

#[test]
fn a_new_value_is_judged_by_the_chosen_source_or_refused_with_its_reason() {
    let mut session = shown_by_another_source();
    run(&mut session, [typed(CheckField::Measured, "500.02"), CheckCommand::Measure]);
    assert_eq!((status(&session), session.history().len()), (None, 1));
    assert!(error(&session, CheckField::Callout).unwrap().contains("500 mm is beyond table"), "{session:?}");
    // The value that is on screen is a new one at the second Enter.
    let mut session = shown_by_another_source();
    run(&mut session, [CheckCommand::Measure]);
    assert_eq!((status(&session), session.history().len()), (None, 1));
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::Callout, "25 H7"), typed(CheckField::Measured, "25.01")]);
    run(&mut session, [CheckCommand::Measure]);
    session.apply(Command::UseSource(Base::ControlTables), now());
    run(&mut session, [CheckCommand::Show(RecordId(0)), typed(CheckField::Measured, "25.02"), CheckCommand::Measure]);
    let source = |session: &Session| session.check().shown.as_ref().unwrap().record.limits.source.to_string();
    assert!(source(&session).starts_with("built-in table"), "{}", source(&session));
    run(&mut session, [CheckCommand::Show(RecordId(0))]);
    assert!(source(&session).starts_with("ISO 286"), "the old check is as it was");
    Act::Import(CONTACTS).run(&mut session);
    assert!(source(&session).starts_with("built-in table"), "contacts are a new value too");
}

/// A hole whose centre is 0.5 mm off, simulated where 0.001 mm is permitted: scrap. Then the fields were changed.
fn simulated_and_changed() -> Session {
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::Callout, "25 H7"), typed(CheckField::CentreTolerance, "0.001")]);
    run(&mut session, [typed(CheckField::OffsetX, "0.5"), CheckCommand::MeasureBy(MeasureBy::Simulating)]);
    run(&mut session, [CheckCommand::Measure]);
    assert_eq!(status(&session), Some(Status::Scrap));
    run(&mut session, [typed(CheckField::CentreTolerance, "0"), typed(CheckField::CentreX, "40")]);
    assert_eq!(status(&session), None);
    session
}

fn texts<const N: usize>(session: &Session, fields: [CheckField; N]) -> [&str; N] {
    fields.map(|field| session.text(field))
}

#[test]
fn a_simulated_check_shown_again_stands_beside_the_inputs_it_was_made_with() {
    let fields = [CheckField::CentreTolerance, CheckField::CentreX, CheckField::OffsetX];
    let mut session = simulated_and_changed();
    run(&mut session, [CheckCommand::Show(RecordId(0))]);
    assert_eq!((status(&session), texts(&session, fields)), (Some(Status::Scrap), ["0.001", "0", "0.5"]));
    // They are not kept as the user's own, and give way to them.
    let (restored, _) = Session::restore(session.saved());
    assert_eq!(texts(&restored, fields), ["0", "40", "0.5"]);
    run(&mut session, [typed(CheckField::Part, "B7")]);
    assert_eq!((status(&session), texts(&session, fields)), (None, ["0", "40", "0.5"]));
    // Typing into one of them changes that one.
    run(&mut session, [CheckCommand::Show(RecordId(0)), typed(CheckField::CentreX, "41")]);
    assert_eq!(texts(&session, fields), ["0", "41", "0.5"]);
}

#[test]
fn measuring_beside_a_check_shown_again_takes_the_inputs_on_screen() {
    let mut session = simulated_and_changed();
    run(&mut session, [CheckCommand::Show(RecordId(0)), CheckCommand::Measure]);
    assert_eq!(status(&session), Some(Status::Scrap));
    assert_eq!(texts(&session, [CheckField::CentreTolerance, CheckField::CentreX]), ["0.001", "0"]);
}

#[test]
fn the_name_of_a_check_shown_again_is_lent_and_a_typed_one_comes_back() {
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::Callout, "25 H7"), typed(CheckField::Measured, "25.012")]);
    run(&mut session, [CheckCommand::Measure, typed(CheckField::Part, "B7"), CheckCommand::Show(RecordId(0))]);
    assert_eq!(session.text(CheckField::Part), "");
    run(&mut session, [typed(CheckField::Measured, "25.013")]);
    assert_eq!(session.text(CheckField::Part), "B7");
    run(&mut session, [CheckCommand::Measure]);
    assert_eq!(session.check().shown.as_ref().unwrap().record.id, "B7");
}

#[test]
fn the_name_of_a_check_shown_again_is_not_the_next_part_s_after_a_restart() {
    let mut before = Session::new(Language::En);
    Act::Import(ONE).run(&mut before);
    assert_eq!(before.text(CheckField::Part), "B1");
    let (mut session, _) = Session::restore(before.saved());
    assert_eq!(session.text(CheckField::Part), "");
    run(&mut session, [typed(CheckField::Measured, "25.013"), CheckCommand::Measure]);
    assert_eq!(session.check().shown.as_ref().unwrap().record.id, "");
}

#[test]
fn a_judged_value_does_not_outlive_its_callout_in_a_restart() {
    let mut before = Session::new(Language::En);
    run(&mut before, [typed(CheckField::Callout, "25 H7"), typed(CheckField::Measured, "25.012")]);
    let (not_judged, _) = Session::restore(before.saved());
    assert_eq!(not_judged.text(CheckField::Measured), "25.012");
    run(&mut before, [CheckCommand::Measure]);
    let (mut session, _) = Session::restore(before.saved());
    run(&mut session, [typed(CheckField::Callout, "30 H7")]);
    assert_eq!(session.text(CheckField::Measured), "");
}

#[test]
fn contacts_get_the_typed_name_and_not_a_lent_one() {
    let mut session = Session::new(Language::En);
    run(&mut session, [typed(CheckField::Callout, "25 H7"), typed(CheckField::Part, "A12")]);
    Act::Import(CONTACTS).run(&mut session);
    assert_eq!(session.check().shown.as_ref().unwrap().record.id, "A12");
    Act::Import(ONE).run(&mut session);
    assert_eq!(session.text(CheckField::Part), "B1");
    Act::Import(CONTACTS).run(&mut session);
    assert_eq!(session.check().shown.as_ref().unwrap().record.id, "A12");
}

#[test]
fn contacts_that_are_not_judged_are_told_with_the_reason_and_as_no_check() {
    let mut session = Session::new(Language::En);
    Act::Import(CONTACTS).run(&mut session);
    assert_eq!(session.history().len(), 0);
    let [notice] = session.notices() else { panic!("{:?}", session.notices()) };
    assert_eq!(notice.message.to_string(), "The contacts in parts.csv were not judged");
    let details: Vec<_> = notice.details.iter().map(ToString::to_string).collect();
    assert_eq!(details, ["No limits to judge by: type a callout first"]);
    assert!(notice.is_problem);
}

#[test]
fn a_refused_simulation_is_told_beside_the_field_that_caused_it() {
    for (field, text) in [
        (CheckField::OffsetX, "100"),
        (CheckField::OffsetY, "-100"),
        (CheckField::OffsetY, "99999"),
        (CheckField::TrueDiameter, "5"),
        (CheckField::Ovality, "20"),
        (CheckField::LobeHeight, "30"),
        (CheckField::Lobes, "1000000"),
        (CheckField::Lobes, "three"),
        (CheckField::SurfaceScatter, "50"),
        (CheckField::ProbeScatter, "50"),
        (CheckField::Seed, "x"),
        (CheckField::CentreTolerance, "-1"),
    ] {
        let mut session = Session::new(Language::En);
        run(&mut session, [typed(CheckField::Callout, "25 H7"), CheckCommand::MeasureBy(MeasureBy::Simulating)]);
        run(&mut session, [typed(field, text)]);
        let before = error(&session, field);
        run(&mut session, [CheckCommand::Measure]);
        let refusal = session.check().refusal.as_ref().map(ToString::to_string);
        assert_eq!((status(&session), session.history().len()), (None, 0), "{field:?} {text}");
        assert!(refusal.is_some() && error(&session, field) == refusal, "{field:?} {text}: {refusal:?}");
        // What was wrong with the text before is still what is wrong.
        assert!(before.is_none() || before == refusal, "{field:?} {text}: {before:?}, then {refusal:?}");
        run(&mut session, [typed(CheckField::Part, "A1")]);
        assert_eq!(session.check().refusal.as_ref(), None, "an edit is a new attempt");
    }
}
