//! The program page without a window: what is open, what a run does slice by slice, and when it is cleared.

#![cfg(test)]

use std::path::PathBuf;

use fitcheck::control::variables::{Family, Parameter, Value};
use fitcheck::message::Message;
use fitcheck::nc::machine::BlockPlace;
use fitcheck::session::program::{Agreement, Document, Input, NoteKind, Run, Speed, State, Switch, WorkpieceFrom};
use fitcheck::session::{Command, Effect, Page, ProgramCommand, ProgramField, Purpose, Session, Step};
use fitcheck::store::programs::Folders;
use fitcheck::verdict::Status;
use fitcheck::words::{Language, Words};
use jiff::civil::{DateTime, date};

fn now() -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0)
}

fn session() -> Session {
    let mut session = Session::new(Language::En);
    session.use_program_files(|program| Box::new(Folders::beside(program)));
    session.apply(Command::OpenPage(Page::Program), now());
    session
}

fn send(session: &mut Session, command: impl Into<Command>) {
    assert_eq!(session.apply(command.into(), now()), []);
}

/// Opens a program as the window does once its file has been read.
fn opened(body: &str) -> Session {
    let mut session = session();
    let text = format!("BEGIN PGM x MM\n{body}\nEND PGM x MM\n");
    let (document, warnings) = Document::read("x.h", text.as_bytes()).unwrap();
    let result = Ok((Box::new(document), warnings));
    send(&mut session, ProgramCommand::Read { path: PathBuf::from("x.h"), result });
    session
}

fn type_text(session: &mut Session, field: ProgramField, text: &str) {
    send(session, ProgramCommand::Type(field, text.to_owned()));
}

fn run(session: &Session) -> &Run {
    session.program().run.as_ref().unwrap()
}

fn said(message: &Message) -> String {
    Words::new(Language::En).say(message)
}

fn state(session: &Session) -> String {
    said(&session.program().state_message())
}

fn block(session: &Session) -> usize {
    run(session).place().unwrap().block
}

fn number(session: &Session, parameter: Parameter) -> Option<f64> {
    match run(session).variables().get(parameter)? {
        Value::Number(number) => Some(*number),
        Value::Length(length) => Some(length.to_mm_f64()),
        Value::Text(_) => None,
    }
}

#[test]
fn the_shipped_program_of_the_language_is_open() {
    for (language, name) in [(Language::En, "8255_en.h"), (Language::Nl, "8255_nl.h")] {
        let mut session = Session::new(language);
        assert!(session.program().main().is_none(), "nothing is read before the page is opened");
        session.apply(Command::OpenPage(Page::Program), now());
        assert_eq!(session.program().main().unwrap().title(), name);
        let inputs: Vec<_> = session.program().inputs().collect();
        assert_eq!(inputs, Input::ALL);
        assert_eq!(session.text(ProgramField::Input(Input::Size)), "25");
        assert_eq!(session.text(ProgramField::Input(Input::Class)), "H7");
    }
}

#[test]
fn every_shipped_program_runs_and_agrees() {
    let mut session = session();
    for (_, name) in fitcheck::nc::machine::Shipped::main_programs() {
        send(&mut session, ProgramCommand::OpenShipped(name));
        for (size, class) in [("25", "H7"), ("25", "g6"), ("400", "H11"), ("3", "js6"), ("0.5", "M7")] {
            type_text(&mut session, ProgramField::Input(Input::Size), size);
            type_text(&mut session, ProgramField::Input(Input::Class), class);
            send(&mut session, ProgramCommand::Run);
            assert_eq!(
                session.program().agreement(session.sources()),
                Some(Agreement::Agrees),
                "{name} {size} {class}"
            );
            assert_eq!(run(&session).status(), Some(Status::Good), "{name} {size} {class}");
            send(&mut session, ProgramCommand::Run);
            assert_eq!(run(&session).state, State::Ended);
        }
    }
}

#[test]
fn limits_belong_to_the_zone_and_a_nanometre_more_does_not_in_both_answers() {
    let mut session = session();
    send(&mut session, ProgramCommand::ChooseWorkpiece(WorkpieceFrom::Given));
    for (class, diameter, status) in [
        ("H7", "25", Status::Good),
        ("H7", "25.021", Status::Good),
        ("H7", "24.999999", Status::Rework),
        ("H7", "25.021001", Status::Scrap),
        ("g6", "24.993", Status::Good),
        ("g6", "24.98", Status::Good),
        ("g6", "24.993001", Status::Rework),
        ("g6", "24.979999", Status::Scrap),
    ] {
        type_text(&mut session, ProgramField::Input(Input::Class), class);
        type_text(&mut session, ProgramField::Diameter, diameter);
        send(&mut session, ProgramCommand::Run);
        assert_eq!(run(&session).status(), Some(status), "{class} {diameter}");
        assert_eq!(
            session.program().verdict(session.sources()).map(|(_, verdict)| verdict.status),
            Some(status),
            "{class} {diameter}"
        );
        assert_eq!(session.program().agreement(session.sources()), Some(Agreement::Agrees), "{class} {diameter}");
    }
}

#[test]
fn the_workpiece_may_lie_beside_its_place() {
    let mut session = session();
    send(&mut session, ProgramCommand::ChooseWorkpiece(WorkpieceFrom::Given));
    for (field, text) in
        [(ProgramField::Diameter, "25.01"), (ProgramField::WorkpieceX, "40.1"), (ProgramField::WorkpieceY, "29.95")]
    {
        type_text(&mut session, field, text);
    }
    send(&mut session, ProgramCommand::Run);
    assert_eq!(number(&session, Parameter::q(151)).map(|x| (x * 1e6).round() / 1e6), Some(40.1));
    assert_eq!(number(&session, Parameter::q(152)).map(|y| (y * 1e6).round() / 1e6), Some(29.95));
}

#[test]
fn a_program_that_differs_says_in_what() {
    // A maximum that is wrong by a micrometre, and a verdict that follows it.
    let mut session = opened(
        "Q1 = 25\nDECLARE STRING QS1 = \"H7\"\nCALL LBL 1\nQ23 = 25.022\nQ33 = 25\nTOOL CALL 1 Z\nTCH PROBE 421 X ~\nQ273=+0 ~\nQ274=+0 ~\n\
        Q262=+25 ~\nQ325=+0 ~\nQ247=+90 ~\nQ261=-5 ~\nQ320=+2 ~\nQ260=+50 ~\nQ301=+0 ~\nQ275=+Q23 ~\nQ276=+Q33 ~\nQ279=+0 ~\n\
        Q280=+0 ~\nQ281=+0 ~\nQ309=+0 ~\nQ330=+0\nM30\nLBL 1\nLBL 0",
    );
    assert!(session.program().has_inputs());
    send(&mut session, ProgramCommand::ChooseWorkpiece(WorkpieceFrom::Given));
    type_text(&mut session, ProgramField::Diameter, "25.0215");
    send(&mut session, ProgramCommand::Run);
    assert_eq!(state(&session), "Ended after 11 blocks");
    let Some(Agreement::Differs(differences)) = session.program().agreement(session.sources()) else {
        panic!("no difference")
    };
    let differences: Vec<_> = differences.iter().map(said).collect();
    assert_eq!(differences, ["its maximum is 25.022 mm, Fitcheck’s 25.021 mm", "it says GOOD, Fitcheck says SCRAP"]);
}

#[test]
fn any_changed_input_clears_the_run() {
    let mut session = session();
    let changes = [
        ProgramCommand::Type(ProgramField::Input(Input::Clearance), "3".to_owned()),
        ProgramCommand::Type(ProgramField::Diameter, "25.01".to_owned()),
        ProgramCommand::ChooseWorkpiece(WorkpieceFrom::Perfect),
        ProgramCommand::Toggle(Switch::SkipUnknown),
        ProgramCommand::Reset,
        ProgramCommand::OpenShipped("8255_de.h"),
    ];
    for change in changes {
        send(&mut session, ProgramCommand::Run);
        assert!(session.program().run.is_some());
        send(&mut session, change.clone());
        assert!(session.program().run.is_none(), "{change:?}");
        assert_eq!(state(&session), "Ready to run");
        assert_eq!(session.program().shown().unwrap().path, session.program().main().unwrap().path);
    }
    send(&mut session, ProgramCommand::Run);
    type_text(&mut session, ProgramField::Filter, "Q1");
    assert!(session.program().run.is_some(), "looking changes nothing");
}

#[test]
fn a_run_on_a_workpiece_that_is_made_by_the_limits_does_not_outlive_their_source() {
    for (workpiece, stays) in
        [(WorkpieceFrom::Perfect, false), (WorkpieceFrom::Given, false), (WorkpieceFrom::Simulated, true)]
    {
        let mut session = session();
        // Typing a diameter chooses the workpiece of that diameter.
        type_text(&mut session, ProgramField::Diameter, "25.01");
        send(&mut session, ProgramCommand::ChooseWorkpiece(workpiece));
        send(&mut session, ProgramCommand::Run);
        assert!(session.program().run.is_some(), "{workpiece:?}");
        send(&mut session, Command::UseSource(fitcheck::tolerance::Base::ControlTables));
        assert_eq!(session.program().run.is_some(), stays, "{workpiece:?}");
    }
}

#[test]
fn an_unreadable_input_keeps_the_program_from_running() {
    let mut session = session();
    let field = ProgramField::Input(Input::Height);
    type_text(&mut session, field, "deep");
    assert_eq!(session.error(field).map(said).as_deref(), Some("Q261 MEASURING HEIGHT: deep is not a number"));
    for command in [ProgramCommand::Run, ProgramCommand::Step] {
        send(&mut session, command);
        assert!(session.program().run.is_none());
        assert_eq!(state(&session), "An input cannot be read");
    }
    type_text(&mut session, field, "-3");
    assert_eq!(state(&session), "Ready to run");
}

#[test]
fn a_loop_runs_in_slices_and_pauses_where_it_is() {
    let mut session = opened("LBL 1\nQ1 = 1\nFN 9: IF +0 EQU +0 GOTO LBL 1");
    send(&mut session, ProgramCommand::Run);
    assert!(session.program().is_running());
    assert_eq!(run(&session).blocks_run(), 2_000);
    send(&mut session, ProgramCommand::Tick);
    assert_eq!(run(&session).blocks_run(), 4_000);
    send(&mut session, ProgramCommand::SetSpeed(Speed::Slow));
    send(&mut session, ProgramCommand::Tick);
    assert_eq!(run(&session).blocks_run(), 4_001);
    send(&mut session, ProgramCommand::Pause);
    assert_eq!((state(&session).as_str(), run(&session).state), ("Paused", State::Paused));
    send(&mut session, ProgramCommand::Tick);
    assert_eq!(run(&session).blocks_run(), 4_001);
}

#[test]
fn an_endless_loop_ends_by_its_budget() {
    let mut session = opened("LBL 1\nFN 9: IF +0 EQU +0 GOTO LBL 1");
    send(&mut session, ProgramCommand::Run);
    while session.program().is_running() {
        send(&mut session, ProgramCommand::Tick);
    }
    assert_eq!(run(&session).state, State::Faulted);
    let problem = session.program().note(0).unwrap();
    assert!(said(&problem.message).contains("limit of 10000000 blocks reached"), "{}", said(&problem.message));
}

#[test]
fn breakpoints_hold_at_every_place_of_a_slice() {
    // The second round of the loop ends one block before the boundary between two parts of a slice.
    let mut session = opened("LBL 1\nQ1 = 1\nQ1 = 2\nQ1 = 3\nFN 9: IF +0 EQU +0 GOTO LBL 1");
    send(&mut session, ProgramCommand::ToggleBreakpoint(Some(3)));
    assert!(session.program().has_breakpoint(3));
    for round in 0..150 {
        send(&mut session, ProgramCommand::Run);
        assert_eq!(state(&session), "Paused at a breakpoint");
        assert_eq!((block(&session), run(&session).blocks_run()), (3, 3 + round * 5));
    }
    send(&mut session, ProgramCommand::ToggleBreakpoint(None));
    assert!(!session.program().has_breakpoint(3), "the block of the pause is selected");
    send(&mut session, ProgramCommand::Run);
    assert!(session.program().is_running());
}

#[test]
fn a_breakpoint_in_the_middle_of_a_long_way_is_not_missed() {
    for wanted in [99, 100, 101, 199, 200, 201, 1_999, 2_000, 2_001] {
        let body = "Q1 = 1\n".repeat(2_500);
        let mut session = opened(body.trim_end());
        send(&mut session, ProgramCommand::ToggleBreakpoint(Some(wanted)));
        send(&mut session, ProgramCommand::Run);
        while session.program().is_running() {
            send(&mut session, ProgramCommand::Tick);
        }
        assert_eq!(state(&session), "Paused at a breakpoint", "{wanted}");
        assert_eq!(block(&session), wanted);
    }
}

#[test]
fn to_the_cursor_and_over_a_call() {
    let mut session = opened("Q1 = 1\nCALL LBL 7\nQ2 = 1\nM30\nLBL 7\nQ3 = 1\nLBL 0");
    send(&mut session, ProgramCommand::Select(2));
    send(&mut session, ProgramCommand::RunToSelected);
    assert_eq!((block(&session), state(&session).as_str()), (2, "Paused at the cursor"));
    send(&mut session, ProgramCommand::StepOver);
    assert_eq!((block(&session), state(&session).as_str()), (3, "Paused after the call"));
    assert_eq!(number(&session, Parameter::q(3)), Some(1.0));
    // A block that calls nothing is one step.
    send(&mut session, ProgramCommand::StepOver);
    assert_eq!(block(&session), 4);
    send(&mut session, ProgramCommand::Select(2));
    send(&mut session, ProgramCommand::RunToSelected);
    assert_eq!(run(&session).state, State::Ended, "it is not reached again");
    // A run that has ended starts again.
    send(&mut session, ProgramCommand::Run);
    assert_eq!(run(&session).state, State::Ended);
    assert_eq!(run(&session).blocks_run(), 8);
}

#[test]
fn only_what_the_last_command_changed_is_marked() {
    let mut session = opened("Q1 = 1\nQ2 = 1\nQ2 = 1\nQ3 = 5");
    let changed = |session: &Session| -> Vec<_> {
        let watched = session.program().watched();
        watched.iter().filter(|watched| watched.is_changed).map(|watched| watched.parameter.to_string()).collect()
    };
    for expected in [&[][..], &["Q1"], &["Q2"], &[], &["Q3"]] {
        send(&mut session, ProgramCommand::Step);
        assert_eq!(changed(&session), expected);
    }
    send(&mut session, ProgramCommand::Reset);
    send(&mut session, ProgramCommand::Run);
    assert_eq!(changed(&session), ["Q1", "Q2", "Q3"]);
}

#[test]
fn problems_name_their_block() {
    let mut session = opened("5 Q1 = 1\nCUTTING DATA\n3 Q2 = 0\nQ3 = Q1 / Q2");
    send(&mut session, ProgramCommand::Toggle(Switch::SkipUnknown));
    send(&mut session, ProgramCommand::Run);
    let problems: Vec<_> = (0..session.program().note_count())
        .filter_map(|number| session.program().note(number))
        .map(|problem| (problem.kind, problem.place.block))
        .collect();
    assert_eq!(problems.first(), Some(&(NoteKind::Error, 4)), "{problems:?}");
    assert_eq!(problems.get(1), Some(&(NoteKind::Remark, 2)), "{problems:?}");
    // Block number 3 after block number 5.
    assert_eq!(problems.get(2), Some(&(NoteKind::Warning, 3)), "{problems:?}");
    assert!(session.program().note(problems.len()).is_none());
    let place = session.program().note(1).unwrap().place;
    send(&mut session, ProgramCommand::GoTo(place));
    assert_eq!(session.program().shown().unwrap().selected, 2);
}

/// Behind what is odd stands where the files came from; where nothing is odd, nothing is listed.
#[test]
fn the_files_of_a_run_are_listed_behind_its_problems() {
    let mut session = opened("CALL PGM 82551_en.h");
    send(&mut session, ProgramCommand::Run);
    let page = session.program();
    let notes: Vec<_> = (0..page.note_count()).filter_map(|number| page.note(number)).collect();
    let files: Vec<_> = notes.iter().skip_while(|note| note.kind != NoteKind::File).collect();
    assert!(!files.is_empty() && files.len() < notes.len(), "{notes:?}");
    assert!(files.iter().all(|note| note.kind == NoteKind::File), "{notes:?}");
    let words = Words::new(Language::En);
    assert!(words.say(&files[0].message).ends_with("82551_en.h is built in"), "{notes:?}");
    assert!(page.note(notes.len()).is_none());
    let mut session = Session::new(Language::En);
    session.apply(Command::OpenPage(Page::Program), now());
    send(&mut session, ProgramCommand::Run);
    assert!(0 < session.program().run.as_ref().unwrap().file_count());
    assert_eq!(session.program().note_count(), 0);
    assert!(session.program().note(0).is_none());
}

#[test]
fn the_selection_stays_within_the_program() {
    let mut session = opened("Q1 = 1");
    for (step, expected) in
        [(Step::Up, 0), (Step::PageDown, 2), (Step::Down, 2), (Step::First, 0), (Step::Last, 2), (Step::PageUp, 0)]
    {
        send(&mut session, ProgramCommand::Move(step));
        assert_eq!(session.program().shown().unwrap().selected, expected, "{step:?}");
    }
    send(&mut session, ProgramCommand::Select(99));
    assert_eq!(session.program().shown().unwrap().selected, 2);
    send(&mut session, ProgramCommand::ToggleBreakpoint(Some(99)));
    let elsewhere = BlockPlace { program: session.program().main().unwrap().path.clone(), block: 99 };
    send(&mut session, ProgramCommand::GoTo(elsewhere));
    assert_eq!(session.program().shown().unwrap().selected, 2);
}

#[test]
fn the_outline_holds_headings_and_labels() {
    let session = opened("* - one\n* -   two\nLBL 5\nLBL \"NAME\"\nLBL 0");
    let document = session.program().main().unwrap();
    let entries: Vec<_> = document.outline.iter().map(|entry| (entry.block, entry.text.as_str())).collect();
    assert_eq!(entries, [(1, "one"), (2, "two"), (3, "LBL 5"), (4, "LBL \"NAME\"")]);
    assert_eq!((document.under(0), document.under(2), document.under(6)), (None, Some(1), Some(3)));
}

#[test]
fn a_program_is_opened_by_the_dialog() {
    let mut session = session();
    session.apply(Command::OpenDialog(Purpose::OpenProgram), now());
    let picked = Command::Picked(Some(PathBuf::from("/parts/a.h")));
    let number = session.dialog().unwrap().number;
    let effects = session.apply(Command::Answered(number, Box::new(picked)), now());
    assert_eq!(effects[0].errand(), &Effect::Read(Purpose::OpenProgram, PathBuf::from("/parts/a.h")));
    let problem = Message::new("program-empty");
    let refused = ProgramCommand::Read { path: PathBuf::from("/parts/a.h"), result: Err(problem.clone()) };
    session.apply(Command::Answered(number, Box::new(refused.into())), now());
    assert_eq!(session.dialog().unwrap().problem, Some(problem));
    assert_eq!(session.program().main().unwrap().title(), "8255_en.h");
    assert!(session.recent_files().is_empty());
}

#[test]
fn recorded_contacts_are_asked_for() {
    let mut session = session();
    send(&mut session, ProgramCommand::ChooseWorkpiece(WorkpieceFrom::Recorded));
    assert!(session.dialog().is_some());
    assert_eq!(session.program().workpiece, WorkpieceFrom::Perfect);
}

#[test]
fn only_plain_values_before_the_first_call_are_inputs() {
    let body = "1 * - Head\n2 Q1 = 25\n3 DECLARE STRING QS1 = \"H7\"\n4 Q11 = Q1 + 1\n\
        5 Q31 = - 5.5\n6 Q1 = 30\n7 CALL PGM y.h\n8 Q41 = 0";
    let session = opened(body);
    let program = session.program();
    let found: Vec<_> = program.inputs().map(|input| (input, session.text(ProgramField::Input(input)))).collect();
    assert_eq!(found, [(Input::Size, "25"), (Input::Class, "H7"), (Input::Height, "-5.5")]);
}

fn give(session: &mut Session, name: &str, value: &str) {
    type_text(session, ProgramField::Name, name);
    type_text(session, ProgramField::Value, value);
    send(session, ProgramCommand::SetValue);
}

/// What the next run starts with.
fn given(session: &Session) -> Vec<String> {
    let given = session.program().given();
    given.map(|(parameter, value)| format!("{parameter} = {}", fitcheck::nc::machine::shown(value))).collect()
}

#[test]
fn a_program_without_a_class_may_begin_with_a_q1_of_zero() {
    let mut session = opened("Q1 = 0\nQ11 = 99999999\nQ2 = Q1 + 7");
    let program = session.program();
    assert!(!program.has_inputs());
    assert_eq!(program.inputs().collect::<Vec<_>>(), [], "nothing is asked of a Q1 that is no nominal size");
    for input in Input::ALL {
        assert_eq!(session.error(ProgramField::Input(input)), None, "{input:?}");
    }
    send(&mut session, ProgramCommand::Run);
    assert_eq!(state(&session), "Ended after 5 blocks");
    assert_eq!(number(&session, Parameter::q(2)), Some(7.0));
    // Nor of a value that the user gives it.
    give(&mut session, "Q1", "-3");
    assert_eq!(given(&session), ["Q1 = -3"]);
    send(&mut session, ProgramCommand::Run);
    assert_eq!(number(&session, Parameter::q(2)), Some(4.0));
}

#[test]
fn what_is_given_to_an_input_is_in_its_field_its_workpiece_and_its_block() {
    let mut session = session();
    for (name, value) in [("Q1", "30"), ("qs1", "g6"), ("Q11", "45,5")] {
        give(&mut session, name, value);
    }
    let text = |session: &Session, input| session.text(ProgramField::Input(input)).to_owned();
    assert_eq!([Input::Size, Input::Class, Input::CentreX].map(|input| text(&session, input)), ["30", "g6", "45,5"]);
    let limits = session.program().limits(session.sources()).unwrap().unwrap();
    assert_eq!((limits.minimum().to_string(), limits.maximum().to_string()), ("29.98".into(), "29.993".into()));
    send(&mut session, ProgramCommand::Run);
    assert_eq!(number(&session, Parameter::q(1)), Some(30.0));
    assert_eq!(number(&session, Parameter::q(151)).map(|x| (x * 1e6).round() / 1e6), Some(45.5));
    let (measured, verdict) = session.program().verdict(session.sources()).unwrap();
    assert_eq!((measured.to_string(), verdict.status), ("29.9865".to_owned(), Status::Good), "the middle of 30 g6");
    assert_eq!(session.program().agreement(session.sources()), Some(Agreement::Agrees));
}

#[test]
fn form_and_given_values_are_one_truth() {
    let mut session = session();
    type_text(&mut session, ProgramField::Input(Input::Size), "30");
    give(&mut session, "Q5", "2");
    assert_eq!(given(&session), ["Q1 = 30", "Q5 = 2"]);
    // The program's own value is not given, however it is written.
    type_text(&mut session, ProgramField::Input(Input::Size), "25.0");
    assert_eq!(given(&session), ["Q5 = 2"]);
    give(&mut session, "Q1", "40");
    assert_eq!(session.text(ProgramField::Input(Input::Size)), "40");
    send(&mut session, ProgramCommand::DropValue(Parameter::q(1)));
    assert_eq!(session.text(ProgramField::Input(Input::Size)), "25");
    assert_eq!(given(&session), ["Q5 = 2"]);
    // What the input does not allow is refused where it is typed, and nothing changes.
    give(&mut session, "Q1", "0");
    let error = session.error(ProgramField::Value).map(said).unwrap_or_default();
    assert!(error.contains("is not above 0"), "{error}");
    assert_eq!(session.text(ProgramField::Input(Input::Size)), "25");
    // Another program begins with its own values.
    give(&mut session, "Q1", "40");
    send(&mut session, ProgramCommand::OpenShipped("8255_de.h"));
    assert_eq!((session.text(ProgramField::Input(Input::Size)), given(&session)), ("25", Vec::new()));
}

#[test]
fn a_called_program_gets_the_form_once_size_and_class_are_given() {
    let mut session = opened("Q2 = Q1 + 1");
    give(&mut session, "Q1", "25");
    assert!(!session.program().has_inputs());
    give(&mut session, "QS1", "H7");
    assert_eq!(session.program().inputs().collect::<Vec<_>>(), [Input::Size, Input::Class]);
    assert!(session.program().limits(session.sources()).unwrap().is_ok());
    type_text(&mut session, ProgramField::Input(Input::Size), "26,,");
    send(&mut session, ProgramCommand::Run);
    assert_eq!(state(&session), "An input cannot be read");
    // Without the form its unreadable text goes too: nothing stays that cannot be seen.
    send(&mut session, ProgramCommand::DropValue(Parameter::qs(1)));
    assert_eq!((session.program().has_inputs(), given(&session)), (false, Vec::new()));
    send(&mut session, ProgramCommand::Run);
    assert_eq!(run(&session).state, State::Faulted, "{}", state(&session));
}

#[test]
fn parameters_are_named_as_on_the_control() {
    #[track_caller]
    fn check(name: &str, expected: Option<Parameter>) {
        let mut session = opened("1 Q1 = 25");
        type_text(&mut session, ProgramField::Name, name);
        type_text(&mut session, ProgramField::Value, "7");
        send(&mut session, ProgramCommand::SetValue);
        assert_eq!(session.program().given().map(|(parameter, _)| parameter).next(), expected, "{name}");
        assert_eq!(session.error(ProgramField::Name).is_none(), expected.is_some(), "{name}");
    }
    check("q5", Some(Parameter::q(5)));
    check(" QS 12", Some(Parameter::qs(12)));
    check("QL499", Some(Parameter { family: Family::Ql, number: 499 }));
    for text in ["", "Q", "5", "QL500", "Q2000", "QX1", "Q1a", "Q99999"] {
        check(text, None);
    }
}

/// What is advised leads on: skipped, the datum stays unknown, and a copy without the block is measured.
#[test]
fn what_is_advised_about_a_cycle_that_sets_a_datum_leads_to_a_measurement() {
    const HOLE: &str = "TCH PROBE 421 MEASURE HOLE ~\nQ273=+0 ~\nQ274=+0 ~\nQ262=+25 ~\nQ325=+0 ~\nQ247=+90 ~\nQ261=-8 ~\nQ320=+2 ~\n\
        Q260=+50 ~\nQ301=+0 ~\nQ275=+25.021 ~\nQ276=+25";
    let datum = "TOOL CALL 1 Z\nTCH PROBE 416 DATUM CIRCLE CENTER ~\nQ321=+40 ~\nQ322=+30 ~\nQ262=+25";
    let advice = "Without its datum nothing is measured. For a trial, open a copy of the program without the block that sets it, \
                  and a workpiece seen from that datum";
    let mut session = opened(&format!("{datum}\n{HOLE}"));
    session.apply(ProgramCommand::Run.into(), now());
    let fault = said(&session.program().note(0).unwrap().message);
    assert!(fault.contains("does not follow cycle 416") && fault.ends_with(advice), "{fault}");
    send(&mut session, ProgramCommand::Toggle(Switch::SkipUnknown));
    session.apply(ProgramCommand::Run.into(), now());
    let fault = said(&session.program().note(0).unwrap().message);
    assert!(fault.contains("an unknown datum has been active") && fault.ends_with(advice), "{fault}");
    let mut copy = opened(&format!("TOOL CALL 1 Z\n{HOLE}"));
    copy.apply(ProgramCommand::Run.into(), now());
    assert!(run(&copy).fault.is_none());
    // A plane sets no datum: the run goes on without it.
    let mut plane = opened("TOOL CALL 1 Z\nTCH PROBE 431 MEASURE PLANE ~\nQ263=+35");
    plane.apply(ProgramCommand::Run.into(), now());
    let fault = said(&plane.program().note(0).unwrap().message);
    assert!(fault.ends_with("To run on without it, switch on Options → Skip unknown blocks"), "{fault}");
}
