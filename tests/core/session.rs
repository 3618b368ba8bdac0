//! Scripts of commands: what the window can do, without a window.

#![cfg(test)]

use fitcheck::session::WindowAction;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::exchange::import;
use fitcheck::files::FileError;
use fitcheck::journal::query::RecordId;
use fitcheck::message::{Message, Say as _};
use fitcheck::report::{RENDERINGS, of_any_paper};
use fitcheck::session::{CheckCommand, CheckField, Command, Effect, Field, MeasureBy, Purpose, Session};
use fitcheck::tolerance::Feature;
use fitcheck::verdict::Status;
use fitcheck::words::{Dialogue, Language, Words};
use jiff::civil::{DateTime, date};

fn now() -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0)
}

fn session() -> Session {
    Session::new(Language::En)
}

/// Runs the commands one after another; returns the effects of the last.
fn run(session: &mut Session, commands: impl IntoIterator<Item = Command>) -> Vec<Effect> {
    commands.into_iter().map(|command| session.apply(command, now())).last().unwrap_or_default()
}

fn typed(field: impl Into<Field>, text: &str) -> Command {
    field.into().typed(text.to_owned())
}

/// Types a callout and a diameter and measures.
fn measure(session: &mut Session, callout: &str, measured: &str) {
    run(
        session,
        [
            typed(CheckField::Callout, callout),
            typed(CheckField::Measured, measured),
            Command::Check(CheckCommand::Measure),
        ],
    );
}

fn status(session: &Session) -> Option<Status> {
    session.check().shown.as_ref().map(|shown| shown.record.verdict.status())
}

fn can_undo(session: &Session) -> bool {
    session.can(WindowAction::Undo)
}

fn window(session: &Session) -> &str {
    session.check().shown.as_ref().unwrap().window.as_ref().unwrap()
}

/// The limits on screen, mm.
fn limits(session: &Session) -> Option<(String, String)> {
    session.check().asked.limits.as_ref().map(|limits| (limits.minimum().to_string(), limits.maximum().to_string()))
}

fn mm(minimum: &str, maximum: &str) -> (String, String) {
    (minimum.to_owned(), maximum.to_owned())
}

/// There is no verdict next to limits that it was not made with.
#[track_caller]
fn check_limits_belong_to_the_verdict(session: &Session) {
    if let Some(shown) = session.check().shown.as_ref() {
        assert_eq!(session.check().asked.limits.as_ref(), Some(&shown.record.limits));
    }
}

/// The answer to what the open dialog asked for.
fn answered(session: &Session, answer: Command) -> Command {
    Command::Answered(session.dialog().unwrap().number, Box::new(answer))
}

fn told(session: &Session, field: CheckField) -> Option<String> {
    session.check().asked.error(field).map(|problem| Words::new(session.language()).say(problem))
}

/// The answer of the outside world when a file with these bytes is imported.
fn imported(session: &Session, name: &str, bytes: &[u8]) -> Command {
    let imported = import(name, bytes, session.sources(), now());
    Command::Check(CheckCommand::Imported { name: name.to_owned(), result: Ok(Box::new(imported)) })
}

fn log() -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/logs/en/TCHPR421.TXT");
    std::fs::read(path).unwrap()
}

#[test]
fn limits_follow_as_the_callout_is_typed() {
    let mut session = session();
    for (text, expected) in [
        ("2", None),
        ("25", None),
        ("25 H", None),
        ("25 H7", Some(mm("25", "25.021"))),
        ("25 H77", None),
        ("25,5 h6", Some(mm("25.487", "25.5"))),
        ("", None),
    ] {
        run(&mut session, [typed(CheckField::Callout, text)]);
        assert_eq!(limits(&session), expected, "{text:?}");
        assert_eq!(told(&session, CheckField::Callout).is_some(), expected.is_none() && !text.is_empty(), "{text:?}");
    }
}

#[test]
fn nominal_size_and_class_are_two_halves_of_the_callout() {
    let mut session = session();
    run(
        &mut session,
        [typed(CheckField::Nominal, "25"), Command::Check(CheckCommand::ChooseClass("H7".parse().unwrap()))],
    );
    assert_eq!(session.text(CheckField::Callout), "25 H7");
    run(&mut session, [typed(CheckField::Nominal, "30")]);
    assert_eq!((session.text(CheckField::Callout), limits(&session)), ("30 H7", Some(mm("30", "30.021"))));
    run(&mut session, [typed(CheckField::Callout, "40 g6")]);
    assert_eq!(session.text(CheckField::Nominal), "40");
}

#[test]
fn typed_values_are_judged() {
    let mut session = session();
    for (measured, expected) in
        [("25.012", Status::Good), ("24,998", Status::Rework), ("25.030", Status::Scrap), ("25.021", Status::Good)]
    {
        measure(&mut session, "25 H7", measured);
        assert_eq!(status(&session), Some(expected), "{measured}");
    }
    assert_eq!(session.history().len(), 4);
}

#[test]
fn what_cannot_be_measured_is_told_beside_its_field_and_changes_nothing() {
    let mut session = session();
    run(&mut session, [Command::Check(CheckCommand::Measure)]);
    assert!(told(&session, CheckField::Callout).is_some());
    for measured in ["", "abc", "0", "-25", "25.0000001", "1.234,5"] {
        measure(&mut session, "25 H7", measured);
        assert!(told(&session, CheckField::Measured).is_some(), "{measured:?}");
    }
    measure(&mut session, "25 Q7", "25");
    assert!(told(&session, CheckField::Callout).unwrap().starts_with("Q7 is not an ISO 286 tolerance class"));
    assert_eq!((session.history().len(), status(&session), can_undo(&session)), (0, None, false));
}

#[test]
fn the_same_seed_measures_the_same_and_counts_up() {
    let measured = |seed| {
        let mut session = session();
        let by = Command::Check(CheckCommand::MeasureBy(MeasureBy::Simulating));
        run(
            &mut session,
            [
                typed(CheckField::Callout, "25 H7"),
                by,
                typed(CheckField::Seed, seed),
                Command::Check(CheckCommand::Measure),
            ],
        );
        assert_eq!(session.text(CheckField::Seed), (seed.parse::<u64>().unwrap() + 1).to_string());
        check_limits_belong_to_the_verdict(&session);
        session.check().shown.as_ref().unwrap().record.measurement.clone()
    };
    assert_eq!(measured("7"), measured("7"));
    assert_ne!(measured("7"), measured("8"));
}

#[test]
fn a_changed_callout_clears_the_verdict_and_the_value_it_was_made_of() {
    for change in [
        typed(CheckField::Callout, "25 H8"),
        typed(CheckField::Callout, "25 X"),
        typed(CheckField::Nominal, "26"),
        Command::Check(CheckCommand::ChooseClass("g6".parse().unwrap())),
        Command::NoOwnTables,
    ] {
        let mut session = session();
        measure(&mut session, "25 H7", "25.012");
        run(&mut session, [change.clone()]);
        assert_eq!((status(&session), session.text(CheckField::Measured)), (None, ""), "{change:?}");
        assert_eq!(session.history().len(), 1);
    }
    // A value that has not been judged yet stays.
    let mut session = session();
    run(&mut session, [typed(CheckField::Measured, "25.012"), typed(CheckField::Callout, "25 H7")]);
    assert_eq!(session.text(CheckField::Measured), "25.012");
}

#[test]
fn a_check_from_the_history_brings_its_callout_back() {
    let mut session = session();
    measure(&mut session, "25 H7", "25.012");
    measure(&mut session, "40 g6", "39.9");
    run(&mut session, [Command::Check(CheckCommand::Show(RecordId(0)))]);
    assert_eq!(session.text(CheckField::Callout), "25 H7");
    assert_eq!((session.text(CheckField::Nominal), limits(&session)), ("25", Some(mm("25", "25.021"))));
    assert_eq!(status(&session), Some(Status::Good));
    run(&mut session, [Command::Check(CheckCommand::Show(RecordId(1)))]);
    assert_eq!((status(&session), limits(&session)), (Some(Status::Scrap), Some(mm("39.975", "39.991"))));
    run(
        &mut session,
        [Command::Check(CheckCommand::Show(RecordId(2))), Command::Check(CheckCommand::Choose(RecordId(2), true))],
    );
    assert_eq!((status(&session), session.history().chosen_count()), (Some(Status::Scrap), 0));
}

#[test]
fn limits_of_a_log_stay_until_there_are_others() {
    let mut session = session();
    measure(&mut session, "25 H7", "25.012");
    let answer = imported(&session, "TCHPR421.TXT", &log());
    run(&mut session, [answer]);
    let record = Arc::clone(&session.check().shown.as_ref().unwrap().record);
    assert_eq!(record.callout, None);
    // The callout in the field belonged to other limits.
    assert_eq!(session.text(CheckField::Callout), "");
    for change in
        [typed(CheckField::Part, "Bore A"), typed(CheckField::Measured, "9.9"), typed(CheckField::CentreX, "1")]
    {
        run(&mut session, [Command::Check(CheckCommand::Show(RecordId(1))), change]);
        assert!(session.check().shown.is_none(), "the verdict was made with other inputs");
        assert_eq!(session.check().asked.limits.as_ref(), Some(&record.limits));
    }
    // The next check is made with the limits on screen, and the typed value stays readable.
    run(&mut session, [typed(CheckField::Measured, "25.001"), Command::Check(CheckCommand::Measure)]);
    assert_eq!((session.history().len(), session.text(CheckField::Measured)), (3, "25.001"));
    assert_eq!(session.check().shown.as_ref().unwrap().record.limits, record.limits);
    run(&mut session, [Command::Check(CheckCommand::Show(RecordId(0)))]);
    assert_eq!((session.text(CheckField::Callout), limits(&session)), ("25 H7", Some(mm("25", "25.021"))));
    run(&mut session, [Command::Check(CheckCommand::Show(RecordId(1))), Command::Check(CheckCommand::Clear)]);
    assert_eq!((status(&session), limits(&session)), (None, None));
}

#[test]
fn clearing_the_history_can_be_taken_back() {
    let mut session = session();
    measure(&mut session, "25 H7", "25.012");
    measure(&mut session, "25 H7", "24.998");
    run(
        &mut session,
        [Command::Check(CheckCommand::Choose(RecordId(1), true)), Command::Check(CheckCommand::ClearHistory)],
    );
    assert_eq!((session.history().len(), session.history().chosen_count(), status(&session)), (0, 0, None));
    run(&mut session, [Command::Check(CheckCommand::Undo)]);
    assert_eq!(
        (session.history().len(), session.history().is_chosen(RecordId(0)), session.history().is_chosen(RecordId(1))),
        (2, false, true)
    );
    run(
        &mut session,
        [Command::Check(CheckCommand::Undo), Command::Check(CheckCommand::Undo), Command::Check(CheckCommand::Undo)],
    );
    assert_eq!((session.history().len(), can_undo(&session)), (0, false));
    run(&mut session, [Command::Check(CheckCommand::ClearHistory)]);
    assert!(!can_undo(&session), "an empty history is nothing to take back");
}

#[test]
fn rows_of_a_file_fill_the_history_and_bad_ones_are_told() {
    let mut session = session();
    let text = b"id,callout,measured\nA1,25 H7,25.012\nA2,25 Q9,25.0\nA3,25 H7,x\nA4,25 H7,24.998\n";
    let answer = imported(&session, "parts.csv", text);
    run(&mut session, [Command::OpenDialog(Purpose::Import), Command::TypePath("parts.csv".to_owned())]);
    let effects = run(&mut session, [Command::Confirm]);
    assert_eq!(effects[0].errand(), &Effect::Read(Purpose::Import, PathBuf::from("parts.csv")));
    let answer = answered(&session, answer);
    run(&mut session, [answer]);
    let statuses: Vec<_> = session.history().iter().map(|record| record.verdict.status()).collect();
    assert_eq!((statuses, session.dialog()), (vec![Status::Good, Status::Rework], None));
    let [notice] = session.notices() else { panic!("{:?}", session.notices()) };
    assert_eq!((notice.details.len(), notice.is_problem), (2, false));
    check_limits_belong_to_the_verdict(&session);
    run(&mut session, [Command::Check(CheckCommand::Undo)]);
    assert_eq!(session.history().len(), 0, "one import is one step");
}

#[test]
fn contacts_are_not_judged_while_the_centres_tolerance_cannot_be_read() {
    let contacts = b"x,y\n12.605,0\n0.1,12.505\n-12.405,0\n0.1,-12.505\n";
    let import = |tolerance: &str| {
        let mut session = session();
        run(&mut session, [typed(CheckField::Callout, "25 H7"), typed(CheckField::CentreTolerance, tolerance)]);
        let answer = imported(&session, "bore.csv", contacts);
        run(&mut session, [answer]);
        session
    };
    // The centre is 0.1 mm off: scrap where 0.01 mm is permitted, and never good because of a typing error.
    assert_eq!(status(&import("0.01")), Some(Status::Scrap));
    assert_eq!(status(&import("0.2")), Some(Status::Good));
    let refused = import("0.01x");
    assert_eq!(status(&refused), None);
    assert!(refused.notices().iter().any(|notice| notice.is_problem));
    // Fields that the position does not need do not stop it.
    let mut session = session();
    run(&mut session, [typed(CheckField::Callout, "25 H7"), typed(CheckField::Height, "high")]);
    let answer = imported(&session, "bore.csv", contacts);
    run(&mut session, [answer]);
    assert_eq!(status(&session), Some(Status::Good));
}

#[test]
fn contacts_of_a_file_are_judged_by_the_limits_on_screen() {
    let contacts = b"x,y\n12.506,0\n0,12.506\n-12.506,0\n0,-12.506\n";
    let mut session = session();
    let answer = imported(&session, "bore.csv", contacts);
    run(&mut session, [answer.clone()]);
    assert_eq!(session.history().len(), 0);
    assert!(session.notices().iter().any(|notice| notice.is_problem), "{:?}", session.notices());
    for (callout, expected) in [("25 H7", Status::Good), ("25.1 H7", Status::Rework), ("25 h6", Status::Rework)] {
        run(&mut session, [typed(CheckField::Callout, callout), answer.clone()]);
        assert_eq!(status(&session), Some(expected), "{callout}");
        assert_eq!(session.check().shown.as_ref().unwrap().record.measurement.contacts.len(), 4);
    }
}

#[test]
fn a_dialog_says_what_is_wrong_and_stays() {
    let mut session = session();
    let open = || Command::OpenDialog(Purpose::Import);
    assert_eq!(run(&mut session, [open(), Command::TypePath("  ".to_owned()), Command::Confirm]), []);
    let problem = |session: &Session| session.dialog().unwrap().problem.as_ref().map(|message| message.id);
    assert_eq!(problem(&session), Some("dialog-no-path"));
    run(&mut session, [Command::TypePath("none.csv".to_owned())]);
    assert_eq!(problem(&session), None);
    let confirmed = run(&mut session, [Command::Confirm]);
    assert_eq!(confirmed[0].errand(), &Effect::Read(Purpose::Import, PathBuf::from("none.csv")));
    assert!(session.dialog().unwrap().busy);
    // A second Enter does not read the file twice.
    assert_eq!(run(&mut session, [Command::Confirm]), []);
    let missing = FileError::Missing { path: "none.csv".into() }.message();
    let failed =
        || Command::Check(CheckCommand::Imported { name: "none.csv".to_owned(), result: Err(missing.clone()) });
    let failed = answered(&session, failed());
    run(&mut session, [failed]);
    assert_eq!((problem(&session), session.dialog().unwrap().busy), (Some("file-missing"), false));
    run(&mut session, [Command::Close]);
    assert_eq!((session.dialog(), session.notices().len()), (None, 0));
    // Without a status window there is nothing to write; without a choice there is nothing to do.
    run(&mut session, [Command::OpenDialog(Purpose::ExportStatus), Command::Confirm]);
    assert_eq!(problem(&session), Some("dialog-no-status"));
    let picked = answered(&session, Command::Picked(None));
    assert_eq!(run(&mut session, [picked]), []);
    assert_eq!(run(&mut session, [Command::Check(CheckCommand::CopyStatus)]), []);
}

#[test]
fn an_answer_after_its_dialog_was_closed_is_told_and_leaves_the_next_dialog_alone() {
    let path = || PathBuf::from("folder");
    let refusal = || FileError::IsFolder { path: path() };
    let failures: [Command; 4] = [
        Command::Check(CheckCommand::Imported { name: "folder".to_owned(), result: Err(refusal().message()) }),
        Command::MaskRead { path: "folder".into(), result: Err(refusal().message()) },
        Command::TablesRead { folder: path(), result: Err(refusal().message()) },
        Command::Saved { path: path(), result: Err(refusal()) },
    ];
    for failure in failures {
        let mut session = session();
        run(&mut session, [failure.clone()]);
        assert_eq!(session.notices().len(), 1, "{failure:?}");
        assert!(session.notices()[0].is_problem);
        run(&mut session, [Command::OpenDialog(Purpose::LoadMask), failure.clone()]);
        assert_eq!((session.notices().len(), &session.dialog().unwrap().problem), (2, &None), "{failure:?}");
    }
    let mut session = session();
    run(&mut session, [Command::OpenDialog(Purpose::LoadMask), Command::Saved { path: path(), result: Ok(()) }]);
    assert_eq!((session.notices().len(), session.dialog().is_some()), (1, true));
}

#[test]
fn another_language_redraws_the_status_window() {
    let mut session = session();
    measure(&mut session, "25 H7", "24.998");
    assert!(window(&session).starts_with("FIT STATUS: REWORK\n"));
    run(&mut session, [Command::SetLanguage(Language::Nl)]);
    assert!(window(&session).starts_with("STATUS VAN DE PASSING: Nabewerking\n"));
    run(&mut session, [Command::SetMask(Some(Dialogue::En))]);
    assert!(window(&session).starts_with("FIT STATUS: REWORK\n"));
    run(&mut session, [Command::SetMask(None)]);
    assert!(window(&session).starts_with("STATUS VAN DE PASSING: Nabewerking\n"));
    let text = window(&session).to_owned();
    assert_eq!(run(&mut session, [Command::Check(CheckCommand::CopyStatus)]), [Effect::Copy(text)]);
    assert_eq!((session.history().len(), can_undo(&session)), (1, true));
}

#[test]
fn a_script_of_commands_gives_the_same_report_as_the_command_line() {
    let mut session = session();
    let mut arguments = vec!["report".to_owned()];
    for measured in ["25.012", "24.998", "25.030"] {
        measure(&mut session, "25 H7", measured);
        arguments.extend(["--check".to_owned(), format!("25 H7={measured}")]);
    }
    arguments.extend(["-o", "-", "--time", "2026-11-21T10:42:07", "--format"].map(str::to_owned));
    for (number, rendering) in of_any_paper().map(|number| (number, &RENDERINGS[number])) {
        let path = Command::TypePath(format!("report.{}", rendering.name));
        let effects = run(&mut session, [Command::OpenDialog(Purpose::Export(number)), path, Command::Confirm]);
        let Some(Effect::Save(_, content)) = effects.first().map(Effect::errand) else { panic!("{effects:?}") };
        let output = cargo_bin_cmd!("fitcheck").args(&arguments).arg(rendering.name).output().unwrap();
        assert_eq!(output.status.code(), Some(11));
        let bytes = content.bytes().unwrap();
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        assert_eq!(text(&bytes), text(&output.stdout), "{}", rendering.name);
        assert!(bytes == output.stdout, "{}", rendering.name);
        run(&mut session, [Command::Close]);
    }
}

#[test]
fn only_chosen_checks_are_exported() {
    let mut session = session();
    measure(&mut session, "25 H7", "25.012");
    measure(&mut session, "25 H7", "24.998");
    let csv = RENDERINGS.iter().position(|rendering| rendering.name == "csv").unwrap();
    let dialog = Command::OpenDialog(Purpose::Export(csv));
    let effects =
        run(&mut session, [Command::Check(CheckCommand::Choose(RecordId(1), true)), dialog, Command::Confirm]);
    let Some(Effect::Save(path, content)) = effects.first().map(Effect::errand) else { panic!("{effects:?}") };
    let text = String::from_utf8(content.bytes().unwrap()).unwrap();
    assert_eq!((path.to_str(), text.lines().count()), (Some("25H7-2026-11-21.csv"), 2));
    assert!(text.contains("24.998") && !text.contains("25.012"));
    let saved = answered(&session, Command::Saved { path: path.clone(), result: Ok(()) });
    run(&mut session, [saved]);
    assert_eq!((session.dialog(), session.notices().len()), (None, 1));
    session.tell(Message::new("dialog-no-path"));
    run(&mut session, [Command::Close]);
    assert_eq!(session.notices().len(), 1);
}

#[test]
fn the_other_part_of_a_fit_can_be_chosen_after_a_verdict() {
    let mut session = session();
    run(
        &mut session,
        [typed(CheckField::Callout, "25 H7/g6"), Command::Check(CheckCommand::ChooseFeature(Some(Feature::Hole)))],
    );
    run(&mut session, [typed(CheckField::Measured, "25.01"), Command::Check(CheckCommand::Measure)]);
    assert_eq!((status(&session), session.check().asked.needs_feature()), (Some(Status::Good), true));
    assert_eq!(session.check().shown.as_ref().unwrap().record.callout.unwrap().to_string(), "25 H7");
    run(&mut session, [typed(CheckField::Part, "Bush")]);
    assert!(session.check().asked.needs_feature());
    check_limits_belong_to_the_verdict(&session);
    run(&mut session, [Command::Check(CheckCommand::ChooseFeature(Some(Feature::Shaft)))]);
    assert_eq!((status(&session), limits(&session)), (None, Some(mm("24.98", "24.993"))));
    run(
        &mut session,
        [
            typed(CheckField::Measured, "24.99"),
            Command::Check(CheckCommand::Measure),
            Command::Check(CheckCommand::Show(RecordId(0))),
        ],
    );
    assert_eq!((session.text(CheckField::Callout), session.check().asked.needs_feature()), ("25 H7", false));
    check_limits_belong_to_the_verdict(&session);
}
