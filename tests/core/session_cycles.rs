//! The cycles page without a window: what fields mean, what a run keeps, and what clears it.

use fitcheck::exchange::contacts::Contacts;
use fitcheck::length::Length;
use fitcheck::probing::Contact;
use fitcheck::probing::cycle::{Key, Value};
use fitcheck::probing::cycles::CYCLES;
use fitcheck::probing::simulated::{Shape, Simulation};
use fitcheck::session::{
    Axis, Command, ContactsFrom, CycleField, CycleFile, CyclesCommand, Effect, Page, Purpose, Saved, Session, Step,
    WorkpieceCommand, WorkpieceField,
};
use fitcheck::verdict::Status;
use fitcheck::words::{Dialogue, Language, Words};

/// Contacts as a file with x, y and z gives them.
fn read(contacts: &[Contact]) -> Contacts {
    Contacts { contacts: contacts.to_vec(), has_heights: true, ignored: Vec::new(), warm: None }
}

fn send(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0))
}

fn apply(session: &mut Session, command: Command) -> Vec<Effect> {
    session.apply(command, jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0))
}

/// A parameter of the chosen cycle by the name that people type.
fn field(session: &Session, name: &str) -> CycleField {
    CycleField::Parameter(session.cycles().cycle.parameter_named(name).unwrap().key)
}

fn fill(session: &mut Session, settings: &[&str]) {
    for setting in settings {
        let (name, text) = setting.split_once('=').unwrap();
        let field = field(session, name);
        send(session, CyclesCommand::Type(field, text.to_owned()));
    }
}

fn with(number: u16, settings: &[&str]) -> Session {
    let mut session = Session::new(Language::En);
    apply(&mut session, Command::OpenPage(Page::Cycles));
    send(&mut session, CyclesCommand::Choose(number));
    fill(&mut session, settings);
    session
}

const FACE: [&str; 8] = ["Q263=35", "Q264=45", "Q261=5", "Q272=3", "Q267=-1", "Q260=20", "Q288=5,1", "Q289=4.95"];
const STUD: [&str; 5] = ["Q273=50", "Q274=50", "Q262=75", "Q277=74.9", "Q278=74.8"];

fn status(session: &Session) -> Option<Status> {
    session.cycles().run.as_ref().and_then(|run| run.found()).and_then(|result| result.status)
}

fn problem(session: &Session) -> String {
    let problem = session.cycles().run.as_ref().and_then(|run| run.result.as_ref().err());
    problem.map(|problem| Words::new(Language::En).say(problem)).unwrap_or_default()
}

#[test]
fn a_run_is_kept_with_its_inputs_and_any_change_clears_it() {
    let mut session = with(427, &FACE);
    let now = |session: &mut Session| {
        apply(session, Command::Cycles(CyclesCommand::Run));
        assert_eq!(status(session), Some(Status::Good));
    };
    now(&mut session);
    let changes: Vec<CyclesCommand> = vec![
        CyclesCommand::Type(field(&session, "Q288"), "5.2".into()),
        CyclesCommand::Type(CycleField::Position(Axis::X), String::new()),
        CyclesCommand::From(ContactsFrom::Perfect),
        CyclesCommand::ChooseProbe(1),
        CyclesCommand::ShippedProbes,
        CyclesCommand::Choose(427),
        CyclesCommand::Clear,
    ];
    for change in changes {
        now(&mut session);
        send(&mut session, change.clone());
        assert!(session.cycles().run.is_none(), "{change:?}");
        assert!(session.cycles().window(session.drawn_with()).is_none());
    }
    // The simulated workpiece is not an input until it is changed.
    now(&mut session);
    send(&mut session, WorkpieceCommand::Type(WorkpieceField::Diameter, "30".into()));
    send(&mut session, WorkpieceCommand::ChooseShape(Shape::Face));
    assert!(session.cycles().run.is_some());
    send(&mut session, CyclesCommand::From(ContactsFrom::Simulated));
    apply(&mut session, Command::Cycles(CyclesCommand::Run));
    send(&mut session, WorkpieceCommand::Type(WorkpieceField::PointZ, "5".into()));
    assert!(session.cycles().run.is_none());
}

#[test]
fn what_is_typed_is_kept_for_each_cycle_and_over_a_restart() {
    let mut session = with(427, &["Q263=35,5"]);
    send(&mut session, CyclesCommand::Choose(444));
    fill(&mut session, &["Q263=1", "QS400=0.4-0.1"]);
    send(&mut session, CyclesCommand::Choose(427));
    assert_eq!(session.text(field(&session, "Q263")), "35,5");
    let (mut again, _) = Session::restore(Saved::read(&session.saved().write().unwrap()).unwrap());
    assert_eq!((again.cycles().cycle.number, again.text(field(&again, "Q263"))), (427, "35,5"));
    send(&mut again, CyclesCommand::Choose(444));
    assert_eq!(again.text(field(&again, "QS400")), "0.4-0.1");
    assert!(again.cycles().run.is_none());
}

#[test]
fn errors_stand_beside_their_field_as_soon_as_typed() {
    let words = Words::new(Language::En);
    let mut session = with(427, &FACE);
    let told = |session: &Session, name: &str| {
        session.error(field(session, name)).map(|error| words.say(error)).unwrap_or_default()
    };
    for (setting, said) in [
        ("Q263=x", "Q263 1ST POINT 1ST AXIS: x is not a number"),
        ("Q263=100000", "Q263 1ST POINT 1ST AXIS = 100000 mm: at least −99999.9999 mm, at most 99999.9999 mm"),
        ("Q320=-0.0001", "Q320 SET-UP CLEARANCE = −0.0001 mm: at least 0 mm, at most 99999.9999 mm"),
        ("Q272=4", "Q272 MEASURING AXIS = 4: expected one of 1, 2, 3"),
    ] {
        let name = setting.split_once('=').unwrap().0;
        let before = session.text(field(&session, name)).to_owned();
        fill(&mut session, &[setting]);
        assert_eq!(told(&session, name), said);
        apply(&mut session, Command::Cycles(CyclesCommand::Run));
        assert_eq!(problem(&session), "one field cannot be used: see the form");
        fill(&mut session, &[&format!("{name}={before}")]);
        assert_eq!(told(&session, name), "");
    }
    fill(&mut session, &["Q263=", "Q264="]);
    assert!(!session.cycles().is_complete());
    assert_eq!(told(&session, "Q263"), "", "nothing typed is no error before the run");
    apply(&mut session, Command::Cycles(CyclesCommand::Run));
    assert_eq!(told(&session, "Q263"), "Q263 1ST POINT 1ST AXIS is missing");
    assert_eq!(problem(&session), "2 fields cannot be used: see the form");
}

#[test]
fn predef_asks_for_what_it_stands_for() {
    let mut session = with(427, &FACE);
    fill(&mut session, &["Q320=predef"]);
    let global = CycleField::Global(Key::Q(320));
    assert!(session.cycles().is_predef(Key::Q(320)));
    for text in ["", "PREDEF", "-1"] {
        send(&mut session, CyclesCommand::Type(global, text.into()));
        assert!(session.error(global).is_some(), "{text:?}");
    }
    send(&mut session, CyclesCommand::Type(global, "4".into()));
    apply(&mut session, Command::Cycles(CyclesCommand::Run));
    let run = session.cycles().run.as_ref().unwrap();
    assert_eq!(run.found().unwrap().inputs.value(320), Some(&Value::Length(Length::from_micrometres(4_000))));
}

#[test]
fn every_cycle_is_run_and_stepped() {
    for (number, settings, moves) in [
        (421, &["Q273=0", "Q274=0", "Q262=75"][..], 17),
        (422, &STUD[..], 17),
        (427, &FACE[..], 5),
        (444, &["Q263=1", "Q264=2", "Q294=3", "Q581=0", "Q582=1", "Q583=1"][..], 4),
        (785, &["K=2", "RC=60"][..], 9),
    ] {
        let mut session = with(number, settings);
        send(&mut session, CyclesCommand::Run);
        assert_eq!(problem(&session), "", "{number}");
        let run = session.cycles().run.as_ref().unwrap();
        assert_eq!((run.path.len(), session.cycles().step), (moves, moves - 1), "{number}");
        for (command, at) in [
            (CyclesCommand::Step(Step::Right), moves - 1),
            (CyclesCommand::Step(Step::First), 0),
            (CyclesCommand::Step(Step::Left), 0),
            (CyclesCommand::Step(Step::Right), 1),
            (CyclesCommand::StepTo(2), 2),
            (CyclesCommand::StepTo(usize::MAX), moves - 1),
            (CyclesCommand::Step(Step::Left), moves - 2),
            (CyclesCommand::Step(Step::Last), moves - 1),
        ] {
            let said = format!("{number} {command:?}");
            send(&mut session, command);
            assert_eq!(session.cycles().step, at, "{said}");
        }
    }
}

#[test]
fn a_cycle_that_does_not_come_to_its_end_shows_its_way() {
    let mut session = with(427, &FACE);
    send(&mut session, CyclesCommand::From(ContactsFrom::Simulated));
    send(&mut session, WorkpieceCommand::ChooseShape(Shape::Face));
    send(&mut session, WorkpieceCommand::Type(WorkpieceField::PointZ, "-60".into()));
    send(&mut session, CyclesCommand::Run);
    assert_eq!(problem(&session), "contact 1: the probe met nothing within the probing path of 50 mm");
    assert!(!session.cycles().run.as_ref().unwrap().path.is_empty());
    send(&mut session, WorkpieceCommand::Type(WorkpieceField::Temperature, "hot".into()));
    send(&mut session, CyclesCommand::Run);
    assert_eq!(problem(&session), "simulated workpiece: Workpiece temperature: hot is not a number");
}

#[test]
fn a_workpiece_suits_every_cycle() {
    for (number, settings) in [
        (421, &["Q273=50", "Q274=20", "Q262=75"][..]),
        (422, &STUD[..]),
        (427, &FACE[..]),
        (444, &["Q263=1", "Q264=2", "Q294=3", "Q581=0", "Q582=1", "Q583=1"][..]),
        (785, &["K=2", "RC=60"][..]),
        (785, &["K=-4", "D=30", "RC=120", "BR=1", "R=1"][..]),
    ] {
        let mut session = with(number, settings);
        send(&mut session, CyclesCommand::From(ContactsFrom::Simulated));
        send(&mut session, WorkpieceCommand::Suit);
        send(&mut session, CyclesCommand::Run);
        assert_eq!(problem(&session), "", "{number} {settings:?}");
    }
    let mut session = with(427, &[]);
    send(&mut session, WorkpieceCommand::Suit);
    assert_eq!(session.notices()[0].message.id, "cycles-cannot-suit");
}

#[test]
fn a_workpiece_that_suits_stands_in_the_middle_of_its_limits() {
    let hole = ["Q273=50", "Q274=20", "Q262=25", "Q276=25", "Q275=25.021"];
    let mut session = with(421, &hole);
    send(&mut session, CyclesCommand::From(ContactsFrom::Simulated));
    send(&mut session, WorkpieceCommand::Suit);
    assert_eq!(session.text(WorkpieceField::Diameter), "25.0105");
    send(&mut session, CyclesCommand::Run);
    assert_eq!(status(&session), Some(Status::Good));
    // Without limits it has the nominal size.
    fill(&mut session, &["Q276=", "Q275="]);
    send(&mut session, WorkpieceCommand::Suit);
    assert_eq!(session.text(WorkpieceField::Diameter), "25");
}

#[test]
fn the_measuring_log_is_shown_or_saved_as_q281_asks() {
    let mut session = with(427, &FACE);
    fill(&mut session, &["Q281=0"]);
    send(&mut session, CyclesCommand::Run);
    assert!(session.cycles().run.as_ref().unwrap().found().is_some() && session.cycles().log().is_none());
    apply(&mut session, Command::OpenDialog(Purpose::SaveCycleLog));
    assert!(apply(&mut session, Command::Confirm).is_empty(), "no log, no file");
    apply(&mut session, Command::Close);
    fill(&mut session, &["Q281=1"]);
    assert!(session.cycles().log().is_none(), "a changed input clears the log");
    send(&mut session, CyclesCommand::Run);
    assert_eq!(session.cycles().log().unwrap().shown, None);
    apply(&mut session, Command::OpenDialog(Purpose::SaveCycleLog));
    let effects = apply(&mut session, Command::Confirm);
    let Some(Effect::Save(path, content)) = effects.first().map(Effect::errand) else { panic!("{effects:?}") };
    assert_eq!(path.display().to_string(), "TCHPR427.TXT");
    let logs = fitcheck::control::log::read(&content.bytes().unwrap());
    let [Ok(log)] = logs.as_slice() else { panic!("{logs:?}") };
    assert_eq!(log.date, Some(jiff::civil::date(2026, 11, 21)));
    let [found] = log.figures[..] else { panic!("{log:?}") };
    assert_eq!(found.actual, "5".parse().unwrap());
    apply(&mut session, Command::Close);
    fill(&mut session, &["Q281=2"]);
    send(&mut session, CyclesCommand::Run);
    let shown = session.cycles().log().unwrap().shown.clone().unwrap();
    assert!(shown.contains("5.0000") && !shown.contains('\r'), "{shown}");
}

#[test]
fn the_workpiece_is_saved_and_opened_as_a_file() {
    let mut session = with(421, &[]);
    send(&mut session, WorkpieceCommand::Type(WorkpieceField::Diameter, "25.012".into()));
    apply(&mut session, Command::OpenDialog(Purpose::SaveWorkpiece));
    let effects = apply(&mut session, Command::Confirm);
    let Some(Effect::Save(path, content)) = effects.first().map(Effect::errand) else { panic!("{effects:?}") };
    assert_eq!(path.display().to_string(), "workpiece.toml");
    let bench = Simulation::read(std::str::from_utf8(&content.bytes().unwrap()).unwrap()).unwrap();
    assert_eq!(Some(&bench), session.workpiece().simulation.as_ref());
    let mut other = with(421, &[]);
    apply(&mut other, Command::OpenDialog(Purpose::OpenCycleFile(CycleFile::Workpiece)));
    apply(&mut other, Command::TypePath("workpiece.toml".into()));
    let effects = apply(&mut other, Command::Confirm);
    let read = Effect::Read(Purpose::OpenCycleFile(CycleFile::Workpiece), "workpiece.toml".into());
    assert_eq!(effects[0].errand(), &read);
    let answer = WorkpieceCommand::Read(Ok(Box::new(bench)));
    let number = other.dialog().unwrap().number;
    apply(&mut other, Command::Answered(number, Box::new(answer.into())));
    assert!(other.dialog().is_none());
    assert_eq!(other.cycles().from, ContactsFrom::Simulated);
    assert_eq!(other.text(WorkpieceField::Diameter), "25.012");
}

#[test]
fn recorded_contacts_are_measured_in_their_order() {
    let mut session = with(421, &["Q273=0", "Q274=0", "Q262=25", "Q275=25.021", "Q276=25"]);
    send(&mut session, CyclesCommand::From(ContactsFrom::Recorded));
    send(&mut session, CyclesCommand::Run);
    assert_eq!(problem(&session), "no file of contacts has been opened yet");
    let places = [[12.5, 0.0, 0.0], [0.0, 12.502, 0.0], [-12.5, 0.0, 0.0], [0.0, -12.502, 0.0], [1.0, 1.0, 1.0]];
    let contacts = places.map(Contact::at).to_vec();
    send(
        &mut session,
        WorkpieceCommand::ContactsRead { name: "bore.csv".into(), result: Ok((read(&contacts), Vec::new())) },
    );
    send(&mut session, CyclesCommand::Run);
    assert_eq!(status(&session), Some(Status::Good));
    let run = session.cycles().run.as_ref().unwrap();
    assert_eq!(run.found().unwrap().value(153), Some(&Value::Length(Length::from_micrometres(25_002))));
    let words = Words::new(Language::En);
    let said: Vec<_> = run.remarks().iter().map(|remark| words.say(remark)).collect();
    assert!(said.contains(&"The cycle left one contact of the file unused".to_owned()), "{said:?}");
    assert_eq!(words.say(&run.from), "Contacts from bore.csv");
}

#[test]
fn a_block_fills_the_form_or_changes_nothing() {
    let mut session = with(421, &["Q273=1"]);
    send(&mut session, CyclesCommand::ShowBlock(true));
    let block = "11 TCH PROBE 427 MISURAZ. COORDINATA ~\nQ263=+35 ;1. PUNTO 1. ASSE ~\nQ272=+3 ;ASSE ~\nQ999=+1 ;? ~\n";
    send(&mut session, CyclesCommand::TypeBlock(block.into()));
    send(&mut session, CyclesCommand::TakeBlock);
    let said = session.cycles().block_problem.as_ref().map(|problem| Words::new(Language::En).say(problem));
    assert!(said.unwrap().starts_with("line 4: cycle 427 has no parameter Q999: its parameters are Q263, Q264, "));
    assert_eq!(session.cycles().cycle.number, 421);
    // Another block of the program, or a block that is cut off, is not taken in part either.
    for (changed, expected) in [
        (block.replace("Q999=+1 ;? ~\n", ""), "line 3: the block ends with ~, so a line is missing: it may be cut off"),
        (
            format!("L Z+50\n{}", block.replace(" ~\nQ999=+1 ;? ~\n", "\n")),
            "line 1: L Z+50 is not part of the probing cycle and was skipped",
        ),
        // Nor is one that a control may skip, or does not reach.
        (
            block.replace(" ~\nQ999=+1 ;? ~\n", "\n").replace("11 ", "/11 "),
            "line 1: a control may skip the probing cycle because of the / before it: if it must be measured, delete the /",
        ),
        (
            format!("END PGM A MM\n{}", block.replace(" ~\nQ999=+1 ;? ~\n", "\n")),
            "line 1: the program goes no further than END PGM A MM and does not reach the probing cycle after it, so a control does not \
                measure here: check the program",
        ),
    ] {
        send(&mut session, CyclesCommand::TypeBlock(changed));
        send(&mut session, CyclesCommand::TakeBlock);
        let said = session.cycles().block_problem.as_ref().map(|problem| Words::new(Language::En).say(problem));
        assert_eq!(said.as_deref(), Some(expected));
        assert_eq!(session.cycles().cycle.number, 421);
    }
    send(&mut session, CyclesCommand::TypeBlock(block.replace(" ~\nQ999=+1 ;? ~\n", "\n")));
    send(&mut session, CyclesCommand::TakeBlock);
    assert_eq!((session.cycles().cycle.number, session.cycles().block.as_deref()), (427, None));
    assert_eq!(session.text(field(&session, "Q263")), "35");
    let effects = send(&mut session, CyclesCommand::CopyBlock);
    let [Effect::Copy(text)] = effects.as_slice() else { panic!("{effects:?}") };
    assert!(text.contains("Q263=+35"), "{text}");
    // A head without parameters says which cycle is meant, and empties nothing.
    send(&mut session, CyclesCommand::ShowBlock(true));
    send(&mut session, CyclesCommand::TypeBlock("TCH PROBE 427 MEASURE COORDINATE".into()));
    send(&mut session, CyclesCommand::TakeBlock);
    assert_eq!((session.cycles().block.as_deref(), session.text(field(&session, "Q263"))), (None, "35"));
}

#[test]
fn the_status_window_speaks_the_language_of_the_window_or_of_the_mask() {
    let mut session = with(422, &STUD);
    send(&mut session, CyclesCommand::Run);
    assert_eq!(status(&session), Some(Status::Rework));
    let first = |session: &Session| {
        session.cycles().window(session.drawn_with()).unwrap().unwrap().lines().next().unwrap().to_owned()
    };
    assert_eq!(first(&session), "FIT STATUS: REWORK");
    apply(&mut session, Command::SetLanguage(Language::Nl));
    assert_eq!(first(&session), "STATUS VAN DE PASSING: Nabewerking");
    apply(&mut session, Command::SetMask(Some(Dialogue::It)));
    assert_eq!(first(&session), "STATO ACCOPPIAMENTO: Ripresa");
    let effects = send(&mut session, CyclesCommand::CopyStatus);
    assert!(matches!(effects.as_slice(), [Effect::Copy(text)] if text.contains("75 (422)")), "{effects:?}");
}

#[test]
fn the_status_window_of_a_simulated_cycle_leaves_the_program_below_its_mark() {
    const MARK: &str = "# Simulated by Fitcheck - not measured\n";
    let mut session = with(422, &STUD);
    send(&mut session, CyclesCommand::Run);
    let shown = session.cycles().window(session.drawn_with()).unwrap().unwrap();
    // What is shown is what the control prints.
    assert!(shown.starts_with("FIT STATUS: REWORK"), "{shown}");
    let copied = send(&mut session, CyclesCommand::CopyStatus);
    assert_eq!(copied, [Effect::Copy(format!("{MARK}{shown}"))]);
    apply(&mut session, Command::OpenPage(Page::Cycles));
    apply(&mut session, Command::OpenDialog(Purpose::ExportStatus));
    apply(&mut session, Command::TypePath("status.txt".to_owned()));
    let saved = apply(&mut session, Command::Confirm);
    let Effect::Save(_, content) = saved[0].errand() else { panic!("{saved:?}") };
    assert_eq!(content.bytes().unwrap(), format!("{MARK}{shown}").into_bytes());
    assert!(fitcheck::control::simulated::is_mark(MARK), "every reader knows it");
}

#[test]
fn half_a_position_is_refused() {
    let mut session = with(785, &["K=2", "RC=60"]);
    send(&mut session, CyclesCommand::Type(CycleField::Position(Axis::X), "1".into()));
    assert!(session.error(CycleField::Position(Axis::Y)).is_some());
    send(&mut session, CyclesCommand::Type(CycleField::Position(Axis::Y), "0".into()));
    send(&mut session, CyclesCommand::Type(CycleField::Position(Axis::Z), "-3,5".into()));
    assert_eq!(session.cycles().inputs.position(), Some([1.0, 0.0, -3.5]));
}

#[test]
fn no_text_in_any_field_makes_the_page_panic() {
    let mut session = with(421, &[]);
    let strange = ["", " ", "nan", "-", "1e400", "99999999999999999999", "PREDEF", "\u{0}", "é", "1.234,5", "𝟙"];
    for cycle in CYCLES {
        send(&mut session, CyclesCommand::Choose(cycle.number));
        for text in strange {
            for parameter in cycle.parameters {
                send(&mut session, CyclesCommand::Type(CycleField::Parameter(parameter.key), text.into()));
            }
            send(&mut session, CyclesCommand::Run);
            send(&mut session, WorkpieceCommand::Suit);
        }
    }
}

/// Whatever is done in whatever order: a shown result is that of a new run with the fields on screen.
#[test]
fn a_shown_result_is_always_that_of_what_is_on_screen() {
    let contacts = [[12.5, 0.0, 0.0], [0.0, 12.502, 0.0], [-12.5, 0.0, 0.0], [0.0, -12.502, 0.0]].map(Contact::at);
    let bench = |text: &str| Box::new(Simulation::read(text).unwrap());
    let mut commands: Vec<Command> = vec![
        WorkpieceCommand::Show(true).into(),
        WorkpieceCommand::Suit.into(),
        WorkpieceCommand::Suit.into(),
        CyclesCommand::ChooseProbe(1).into(),
        CyclesCommand::ShippedProbes.into(),
        CyclesCommand::Clear.into(),
        CyclesCommand::Step(Step::Left).into(),
        CyclesCommand::ShowBlock(true).into(),
        CyclesCommand::TypeBlock("TCH PROBE 421 ~\nQ273=0~\nQ274=0~\nQ262=25.01~\nQ275=25.02~\nQ276=25".into()).into(),
        CyclesCommand::TakeBlock.into(),
        CyclesCommand::CopyResults.into(),
        WorkpieceCommand::ContactsRead { name: "a.csv".into(), result: Ok((read(&contacts), Vec::new())) }.into(),
        WorkpieceCommand::Read(Ok(bench("[bore]\ncentre = [0, 0]\ndiameter = 25.03\n"))).into(),
        WorkpieceCommand::Read(Ok(bench("seed = 4\n[point]\npoint = [0, 0, 5]\nnormal = [0, 0, 1]\n"))).into(),
        WorkpieceCommand::Read(Err(fitcheck::message::Message::new("cycles-no-workpiece"))).into(),
    ];
    commands.extend(ContactsFrom::ALL.map(CyclesCommand::From).map(Command::from));
    commands.extend(CYCLES.iter().map(|cycle| CyclesCommand::Choose(cycle.number).into()));
    commands.extend(Shape::ALL.map(WorkpieceCommand::ChooseShape).map(Command::from));
    commands.extend(
        ["25", "25,02", "0", "x"]
            .map(|text| Command::from(WorkpieceCommand::Type(WorkpieceField::Diameter, text.into()))),
    );
    commands
        .extend(["1", ""].map(|text| Command::from(WorkpieceCommand::Type(WorkpieceField::BallRadius, text.into()))));
    commands
        .extend(["0", ""].map(|text| Command::from(CyclesCommand::Type(CycleField::Position(Axis::X), text.into()))));
    commands.extend(
        ["PREDEF", "0.5"]
            .map(|text| Command::from(CyclesCommand::Type(CycleField::Parameter(Key::Q(320)), text.into()))),
    );
    commands.extend(
        ["1", "2"].map(|text| Command::from(CyclesCommand::Type(CycleField::Global(Key::Q(320)), text.into()))),
    );
    let mut session = with(421, &["Q273=0", "Q274=0", "Q262=25", "Q275=25.021", "Q276=25"]);
    for (number, block) in [(422, &STUD[..]), (427, &FACE[..]), (785, &["K=2", "RC=60"])] {
        send(&mut session, CyclesCommand::Choose(number));
        fill(&mut session, block);
    }
    let (mut random, mut compared) = (1_u64, 0);
    let mut left = 60_000;
    // How often a result is on screen falls with every cycle and command that is added.
    while compared < 600 {
        left -= 1;
        assert!(0 < left, "only {compared} results were shown");
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let chosen = usize::try_from(random >> 33).unwrap() % (2 * commands.len());
        let command = commands.get(chosen).cloned().unwrap_or(Command::Cycles(CyclesCommand::Run));
        send(&mut session, command.clone());
        let shown = session.cycles().run.as_ref().map(|run| (run.cycle.code, run.found().cloned()));
        let Some(shown) = shown else { continue };
        let (window, mut again) = (session.cycles().window(session.drawn_with()).map(Result::ok), session);
        send(&mut again, CyclesCommand::Run);
        let anew = again.cycles().run.as_ref().map(|run| (run.cycle.code, run.found().cloned()));
        assert_eq!(Some(&shown), anew.as_ref(), "after {command:?}");
        assert_eq!(again.cycles().window(again.drawn_with()).map(Result::ok), window, "after {command:?}");
        compared += usize::from(shown.1.is_some());
        session = again;
    }
}
