//! A study of a gauge without a window: how readings were understood, what has to be confirmed, what is missing, and published figures.

use std::fmt::Write as _;
use std::io::Cursor;
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck::budget::Budget;
use fitcheck::exchange::{ImportInputs, import_from};
use fitcheck::message::Message;
use fitcheck::series::StudyKind;
use fitcheck::session::statistics::{Study, StudyCommand, StudyFile, StudyRead};
use fitcheck::session::{
    Command, Content, Effect, FilesCommand, Page, Purpose, Session, StatisticsAction, StatisticsCommand,
    StatisticsField,
};
use fitcheck::tolerance::Sources;
use fitcheck::words::{Language, Words};

use crate::session_records::{send, typed};
use crate::studies_cli::{column, numbers, published, table};

fn words() -> Words {
    Words::new(Language::En)
}

fn study(session: &Session) -> &Study {
    &session.statistics().study
}

/// The readings of a file, as the world outside reads them.
fn file(name: &str, text: &str) -> Arc<StudyFile> {
    let sources = Sources::default();
    let now = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
    let mut items = Vec::new();
    let mut body = Cursor::new(text.as_bytes());
    import_from(name, &mut body, ImportInputs::new(&sources, now), &mut |item| items.push(item));
    Arc::new(StudyFile::of(name, &items))
}

fn does(session: &mut Session, command: StudyCommand) -> Vec<Effect> {
    send(session, StatisticsCommand::Study(command))
}

/// A study of a kind of these readings.
fn opened(kind: StudyKind, text: &str) -> Session {
    let mut session = Session::new(Language::En);
    send(&mut session, Command::OpenPage(Page::Statistics));
    does(&mut session, StudyCommand::Read { name: "study.csv".to_owned(), result: Ok(file("study.csv", text)) });
    does(&mut session, StudyCommand::SetKind(kind));
    session
}

#[track_caller]
fn read(session: &Session) -> &StudyRead {
    study(session).read.as_ref().unwrap().as_ref().unwrap_or_else(|why| panic!("{why}"))
}

#[track_caller]
fn layout(session: &Session) -> String {
    read(session).layout_text(&words())
}

/// Presses a button; what is asked for is computed as the world outside does it.
fn press(session: &mut Session, action: StatisticsAction) {
    let Some(command) = fitcheck::session::Action::from(action).command(session) else { return };
    for effect in send(session, command) {
        if let Effect::EvaluateStudy { run, asked } = effect {
            does(session, StudyCommand::Evaluated { run, result: asked.evaluate() });
        }
    }
}

fn evaluate(session: &mut Session) {
    press(session, StatisticsAction::EvaluateStudy);
}

#[track_caller]
fn value(session: &Session, name: &str) -> f64 {
    let found = study(session).evaluated().expect("figures");
    let figure = found.answer.figure(name).unwrap_or_else(|| panic!("no {name}"));
    figure.value.as_ref().unwrap_or_else(|why| panic!("{name}: {why}")).0
}

#[track_caller]
fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-8 * expected.abs(), "{found} is not {expected}");
}

fn thermal() -> String {
    table(&published("gauge_rr_thermal_impedance")["data"])
}

#[test]
fn the_layout_is_shown_first_and_nothing_is_computed_until_it_is_confirmed() {
    let mut session = opened(StudyKind::Crossed, &thermal());
    assert_eq!(layout(&session), "10 parts, 3 operators, 3 repeats");
    assert_eq!(read(&session).read_text(&words()), "90 values");
    assert!(study(&session).found().is_none() && study(&session).figures(&words()).is_empty());
    assert!(!session.can(StatisticsAction::SaveStudyBudget));
    evaluate(&mut session);
    let [answers, rest] = study(&session).advice(&words());
    assert!(
        answers[0].starts_with("Good enough only where it must do: the gauge takes 19.0 % of all variation"),
        "{answers:?}"
    );
    assert!(answers[1].starts_with("Smallest tolerance that it is good enough for: "), "{answers:?}");
    assert!(rest[0].starts_with("Operators differ more on some parts than on others"), "{rest:?}");
}

#[test]
fn a_changed_field_takes_the_answer_away() {
    let mut session = opened(StudyKind::Crossed, &thermal());
    evaluate(&mut session);
    typed(&mut session, StatisticsField::StudyLower, "5");
    assert!(study(&session).found().is_none());
    typed(&mut session, StatisticsField::StudyUpper, "4");
    let error = session.error(StatisticsField::StudyUpper).map(ToString::to_string);
    assert_eq!(error.as_deref(), Some("the lower limit is not below the upper one"));
    assert!(!session.can(StatisticsAction::EvaluateStudy));
    typed(&mut session, StatisticsField::StudyUpper, "15");
    evaluate(&mut session);
    assert!(study(&session).evaluated().is_some());
    does(&mut session, StudyCommand::SetKind(StudyKind::Nested));
    assert!(study(&session).found().is_none());
}

#[test]
fn a_late_answer_to_an_older_question_changes_nothing() {
    let mut session = opened(StudyKind::Crossed, &thermal());
    let effects = does(&mut session, StudyCommand::Evaluate { all_the_same: false });
    let [Effect::EvaluateStudy { run, asked }] = effects.as_slice() else { panic!("{effects:?}") };
    typed(&mut session, StatisticsField::StudyLower, "5");
    does(&mut session, StudyCommand::Evaluated { run: *run, result: asked.evaluate() });
    assert!(study(&session).found().is_none());
}

#[test]
fn a_layout_that_looks_swapped_is_asked_about_and_evaluated_all_the_same() {
    let swapped = thermal().replacen("part;operator", "operator;part", 1);
    let mut session = opened(StudyKind::Crossed, &swapped);
    assert_eq!(layout(&session), "3 parts, 10 operators, 3 repeats");
    let doubts = read(&session).doubts(&words());
    assert_eq!(doubts, ["Operators: 10, parts: 3: are the columns of parts and operators swapped?"]);
    evaluate(&mut session);
    assert!(study(&session).found().is_none(), "the usual button does nothing");
    press(&mut session, StatisticsAction::EvaluateAllTheSame);
    assert!(study(&session).evaluated().is_some());
}

#[test]
fn figures_that_give_a_swap_away_are_asked_about_too() {
    let rows = ["1;A;10", "1;A;10.1", "1;B;20", "1;B;20.2", "2;A;10.1", "2;A;10", "2;B;20.1", "2;B;20"];
    let mut session = opened(StudyKind::Crossed, &format!("part;operator;measured [mm]\n{}\n", rows.join("\n")));
    evaluate(&mut session);
    assert!(study(&session).evaluated().is_none());
    let doubt = study(&session).doubt_of_figures(&words());
    assert_eq!(
        doubt.as_deref(),
        Some("Operators differ more than parts do: are the columns of parts and operators swapped?")
    );
    assert!(study(&session).figures(&words()).is_empty());
    press(&mut session, StatisticsAction::EvaluateAllTheSame);
    assert!(study(&session).evaluated().is_some());
}

#[test]
fn every_missing_and_every_extra_reading_is_named() {
    let text = thermal();
    // Operator Cleo reads part 10 once less, and Anna part 1 once more.
    let text = text.trim_end().rsplit_once('\n').unwrap().0.to_owned() + "\n1;Anna;37\n";
    let session = opened(StudyKind::Crossed, &text);
    assert_eq!(layout(&session), "10 parts, 3 operators, 3 repeats");
    assert_eq!(
        read(&session).faults(&words()),
        ["Readings of part 1 by operator Anna: 4, expected 3", "Readings of part 10 by operator Cleo: 2, expected 3"]
    );
    assert!(!session.can(StatisticsAction::EvaluateStudy) && !session.can(StatisticsAction::EvaluateAllTheSame));
    let bare = opened(StudyKind::Crossed, "operator;measured [mm]\nA;10\nA;11\n");
    let why = study(&bare).read.as_ref().unwrap().as_ref().unwrap_err();
    assert_eq!(why.to_string(), "values that name no part: 2");
}

#[test]
fn a_crossed_study_has_its_published_figures() {
    let of = published("gauge_rr_interaction_operator_zero");
    let mut session = opened(StudyKind::Crossed, &table(&of["data"]));
    typed(&mut session, StatisticsField::StudyLower, "5");
    typed(&mut session, StatisticsField::StudyUpper, "15");
    evaluate(&mut session);
    let computed = &of["computed"];
    for (name, short) in
        [("ms_part", "part"), ("ms_operator", "op"), ("ms_interaction", "po"), ("ms_repeatability", "e")]
    {
        near(value(&session, name), computed["MS"][short].as_f64().unwrap());
    }
    assert!(study(&session).advice(&words())[0][0].starts_with("Good enough: the gauge takes 9.8 % of the tolerance"));
    let figures = study(&session).figures(&words());
    let of_tolerance = figures.iter().find(|figure| figure.name == "Share of the tolerance").unwrap();
    assert!(of_tolerance.value == "9.8 %" && of_tolerance.interval.starts_with("95 %: "), "{of_tolerance:?}");
    let square = figures.iter().find(|figure| figure.name == "Mean square, parts").unwrap();
    assert_eq!(square.method, "analysis of variance, 3 degrees of freedom");
}

#[test]
fn a_type_1_study_has_its_published_figures_and_gives_the_budget_page_its_scatter() {
    let of = published("type1_gauge_50");
    let mut session = opened(StudyKind::Type1, &column(&numbers(&of["data"]), 10.0));
    assert_eq!(layout(&session), "1 master, 50 readings");
    assert_eq!(read(&session).faults(&words()), ["Values without a calibrated size: 50"]);
    for (field, text) in [
        (StatisticsField::StudyReference, "6"),
        (StatisticsField::StudyLower, "1"),
        (StatisticsField::StudyUpper, "16,0"),
    ] {
        typed(&mut session, field, text);
    }
    evaluate(&mut session);
    near(value(&session, "sd_mm"), of["published"]["s"].as_f64().unwrap());
    near(value(&session, "bias_t"), of["published"]["t"].as_f64().unwrap());
    near(value(&session, "smallest_tolerance_mm"), 10.0 * (3.99 * 0.420_014_577 + 0.054));
    let [answers, _] = study(&session).advice(&words());
    assert!(answers[0].starts_with("Not good enough for this tolerance"), "{answers:?}");
    let file = PathBuf::from("/out/gauge.toml");
    let effects = send(&mut session, FilesCommand::Open(Purpose::SaveStudyBudget, file.clone()));
    let [Effect::Save(path, Content::Bytes(bytes))] = effects.as_slice() else { panic!("{effects:?}") };
    assert_eq!(path, &file);
    let text = String::from_utf8(bytes.clone()).unwrap();
    assert!(
        text.starts_with("name = \"study.csv\"\ndate = 20") && text.contains("degrees_of_freedom = 49\n"),
        "{text}"
    );
    assert!(Budget::read(&text).is_ok(), "{text}");
}

#[test]
fn masters_have_references_by_their_names_or_of_the_file() {
    let of = published("linearity_aiag_12x5");
    let (sizes, readings) = (numbers(&of["reference"]), numbers(&of["measured"]));
    let mut text = "part;nominal;measured [mm]\n".to_owned();
    for (size, reading) in sizes.iter().zip(&readings) {
        writeln!(text, "M{size};{size};{reading}").unwrap();
    }
    let mut session = opened(StudyKind::Linearity, &text);
    for references in ["", "M2 = 2; M4=4; M6=6; M8=8; M10 = 10"] {
        typed(&mut session, StatisticsField::StudyReference, references);
        assert_eq!(layout(&session), "5 masters, 12 readings each");
        evaluate(&mut session);
        near(value(&session, "slope"), of["published"]["slope"].as_f64().unwrap());
        assert_eq!(study(&session).figures(&words()).last().unwrap().name, "Bias at 10 mm (12)");
    }
    typed(&mut session, StatisticsField::StudyReference, "2");
    let error = session.error(StatisticsField::StudyReference).map(ToString::to_string).unwrap();
    assert!(error.starts_with("2 names no master: write its name before the size"), "{error}");
}

#[test]
fn a_drifting_master_is_not_stable_and_its_chart_is_said() {
    let steps = [0.3, -0.4, 0.1, 0.5, -0.2, -0.5, 0.2, 0.4, -0.3, -0.1];
    let values: Vec<f64> =
        (0..30_u8).map(|at| 10.0 + steps[usize::from(at % 10)] / 1_000.0 + 0.0002 * f64::from(at)).collect();
    let mut session = opened(StudyKind::Stability, &column(&values, 0.0));
    assert_eq!(layout(&session), "30 points, 1 reading each");
    evaluate(&mut session);
    assert!(study(&session).advice(&words())[0][0].starts_with("Not stable: "));
    let said = study(&session).chart_text(&words());
    assert!(said.starts_with("30 points, centre line 10.00"), "{said}");
}

#[test]
fn a_file_with_several_features_asks_for_one() {
    let text = "name;part;operator;measured [mm]\nA;1;X;10\nA;1;X;10.1\nB;1;X;20\nB;1;X;20.1\n";
    let mut session = opened(StudyKind::Crossed, text);
    let why = study(&session).read.as_ref().unwrap().as_ref().unwrap_err().to_string();
    assert!(why.starts_with("The file has several features"), "{why}");
    does(&mut session, StudyCommand::ChooseFeature("B".to_owned()));
    assert_eq!(read(&session).count, 2);
}

#[test]
fn a_file_that_cannot_be_read_says_why_and_changes_nothing() {
    let mut session = opened(StudyKind::Crossed, &thermal());
    let why = Message::new("columns-page-no-measured");
    does(&mut session, StudyCommand::Read { name: "other.csv".to_owned(), result: Err(why) });
    assert_eq!(study(&session).file().unwrap().name, "study.csv");
    let odd = file("odd.csv", "part;operator;measured [mm]\n1;A;x\n1;A;10\n");
    assert_eq!((odd.values.len(), odd.notes.len()), (1, 1), "{:?}", odd.notes);
}
