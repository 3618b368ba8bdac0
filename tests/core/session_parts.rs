//! A simulated part of several features on the program page, without a window. The oracle is the command line.

use std::path::{Path, PathBuf};
use std::process::Command as Process;

use fitcheck::message::{Message, Say as _};
use fitcheck::probing::simulated::Part;
use fitcheck::session::program::{Agreement, Document, NoteKind, State, WorkpieceFrom};
use fitcheck::session::{
    Command, Effect, FilesCommand, Page, ProgramCommand, Purpose, Session, WorkpieceCommand, feature_message,
};
use fitcheck::store::programs::Folders;
use fitcheck::words::{Language, Words};
use serde_json::Value as Json;

const PLAN: &str = "name;kind;axis;callout;callout2;x;y;z;angle;clearance;clearance_height
A1;;;25 H7;;40;30;-8;0;2;50
S1;;;20 g6;;40;90;-8;0;2;50
N1;width;Y;16 H8;;100;90;-8;0;2;50
P1;face;-Z;10 h9;;220;30;10;0;2;50
B1;boss;;18 s7;16 h9;140;200;-8;0;2;50
T1;point;-Z;±0,05;;260;30;12;0;2;50
";

fn send(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0))
}

fn said(message: &Message) -> String {
    Words::new(Language::En).say(message)
}

fn put(path: &Path, text: &str) {
    std::io::Write::write_all(&mut std::fs::File::create(path).unwrap(), text.as_bytes()).unwrap();
}

fn fitcheck(folder: &Path, args: &[&str]) -> String {
    let output = Process::new(env!("CARGO_BIN_EXE_fitcheck")).current_dir(folder).args(args).output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

/// The program page with a program of a folder.
fn with(path: &Path) -> Session {
    let mut session = Session::new(Language::En);
    session.use_program_files(|program| Box::new(Folders::beside(program)));
    send(&mut session, Command::OpenPage(Page::Program));
    let name = path.file_name().unwrap().to_str().unwrap();
    let (document, warnings) = Document::read(name, &std::fs::read(path).unwrap()).unwrap();
    let result = Ok((Box::new(document), warnings));
    assert_eq!(send(&mut session, ProgramCommand::Read { path: path.to_owned(), result }), []);
    session
}

/// Takes a part as the window does once its file has been read.
fn take(session: &mut Session, text: &str) {
    let result = Ok(Box::new(Part::read(text).unwrap()));
    assert_eq!(send(session, WorkpieceCommand::PartRead { name: "part.toml".to_owned(), result }), []);
}

fn run_to_the_end(session: &mut Session) {
    send(session, ProgramCommand::Run);
    for _ in 0..1_000 {
        match session.program().run.as_ref().map(|run| run.state) {
            Some(State::Running) => _ = send(session, ProgramCommand::Tick),
            Some(State::Paused) => _ = send(session, ProgramCommand::Run),
            _ => return,
        }
    }
    panic!("the run does not end");
}

/// What the window and the command line have to agree on: cycles with status and contacts, windows, remarks, the fault.
fn answers(session: &Session) -> Json {
    let run = session.program().run.as_ref().unwrap();
    let cycles: Vec<Json> = run
        .cycles()
        .iter()
        .map(|cycle| {
            let status = cycle.result.verdict().map(fitcheck::verdict::Status::word);
            serde_json::json!({"cycle": cycle.cycle.code, "status": status, "contacts": cycle.result.contacts})
        })
        .collect();
    let windows: Vec<&str> = run.windows().iter().map(|window| window.text.as_str()).collect();
    // As the page lists them: without their block.
    let page = session.program();
    let notes = (0..page.note_count()).filter_map(|number| page.note(number));
    let remarks: Vec<String> = notes
        .filter(|note| note.kind == NoteKind::Remark)
        .map(|note| said(&note.message).split_once(": ").unwrap().1.to_owned())
        .collect();
    let fault = run.fault.as_ref().map(|fault| fault.kind.to_string());
    let answers = serde_json::json!({"cycles": cycles, "windows": windows, "remarks": remarks, "fault": fault});
    // Through text, as the command line's figures come.
    answers.to_string().parse().unwrap()
}

/// The same from `fitcheck run`.
fn by_command(folder: &Path, program: &str, part: &str) -> Json {
    let out = fitcheck(folder, &["run", program, "--workpiece", part, "--format", "json"]);
    let all: Json = serde_json::from_str(&out).unwrap();
    let list = |name: &str| all[name].as_array().unwrap().clone();
    let cycles: Vec<Json> = list("cycles")
        .into_iter()
        .map(|cycle| {
            serde_json::json!({"cycle": cycle["cycle"], "status": cycle["status"], "contacts": cycle["contacts"]})
        })
        .collect();
    let windows: Vec<Json> = list("windows").into_iter().map(|window| window["window"].clone()).collect();
    // The window has no folder to write to, and says so in its own words.
    let own = |remark: &Json| {
        let text = remark["message"].as_str().unwrap();
        let path = text.strip_suffix(" was not written: no output folder was chosen");
        path.map_or_else(
            || text.to_owned(),
            |path| said(&fitcheck::message::Message::new("program-page-not-written").text("path", path)),
        )
    };
    let remarks: Vec<Json> = list("remarks").iter().map(|remark| own(remark).into()).collect();
    let fault = list("faults").first().map(|fault| fault["message"].clone());
    serde_json::json!({"cycles": cycles, "windows": windows, "remarks": remarks, "fault": fault})
}

#[test]
fn a_plan_of_fitcheck_nc_is_measured_in_the_window_as_by_the_command_line() {
    let folder = tempfile::tempdir().unwrap();
    put(&folder.path().join("plan.csv"), PLAN);
    fitcheck(folder.path(), &["nc", "plan.csv", "--control", "tnc7", "-o", "set", "--workpiece-out", "part.toml"]);
    let text = std::fs::read_to_string(folder.path().join("part.toml")).unwrap();
    let mut session = with(&folder.path().join("set/FIT_MAIN.H"));
    take(&mut session, &text);
    assert_eq!(session.program().workpiece, WorkpieceFrom::Part, "a part that is opened on the page is measured");
    let open = session.part().unwrap();
    let listed: Vec<String> = open.part.features.iter().map(|feature| said(&feature_message(feature))).collect();
    assert_eq!(
        listed,
        [
            "A1: Hole Ø 25.0105 mm, X 40 Y 30",
            "S1: Shaft Ø 19.9865 mm, X 40 Y 90",
            "N1: Slot 16.0135 mm, X 100 Y 90",
            "P1: Face X 220 Y 30 Z 9.982",
            "B1: Boss 18.037 × 15.9785 mm, X 140 Y 200",
            "T1: Free surface point X 260 Y 30 Z 12",
        ]
    );
    run_to_the_end(&mut session);
    let answers = answers(&session);
    assert_eq!(answers["cycles"].as_array().unwrap().len(), 6);
    assert!(answers["cycles"].as_array().unwrap().iter().all(|cycle| cycle["status"] == "GOOD"), "{answers}");
    assert_eq!(answers, by_command(folder.path(), "set/FIT_MAIN.H", "part.toml"));
    // The form is about the first feature: what is measured after it is not held against its limits.
    assert_eq!(session.program().agreement(session.sources()), Some(Agreement::OtherInputs));
    assert_eq!(session.program().verdict(session.sources()), None);
}

const PART: &str = "[[feature]]\nname = \"A1\"\nkind = \"bore\"\ncentre = [40, 30]\ndiameter = 25.0134\nbottom = -20\n\
    [[feature]]\nname = \"rib\"\nkind = \"ridge\"\ncentre = [90, 30]\nwidth = 8\nlength = 40\ntop = 5\n\
    [probe]\nball_radius = 3\nstylus_radius = 2\n";

/// A program of a folder, and the part beside it.
fn with_part(folder: &Path, body: &str) -> Session {
    put(&folder.join("way.h"), &format!("BEGIN PGM way MM\n{body}\nEND PGM way MM\n"));
    put(&folder.join("part.toml"), PART);
    let mut session = with(&folder.join("way.h"));
    take(&mut session, PART);
    session
}

#[test]
fn a_collision_is_told_with_the_feature_and_its_block() {
    let folder = tempfile::tempdir().unwrap();
    let mut session = with_part(folder.path(), "L X+40 Y+30 Z+50 FMAX\nL Z+4 FMAX\nL X+140 FMAX");
    run_to_the_end(&mut session);
    let note = session.program().note(0).unwrap();
    assert_eq!((note.kind, note.place.block), (NoteKind::Remark, 3));
    let note = said(&note.message);
    assert!(
        note.ends_with("the ball would touch rib, with the centre of the ball at X 83.000001 Y 30 Z 4 mm"),
        "{note}"
    );
    assert_eq!(answers(&session), by_command(folder.path(), "way.h", "part.toml"));
}

#[test]
fn what_is_met_beside_its_feature_is_an_error_with_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let hole = "Q273=80 Q274=30 Q262=25 Q325=0 Q247=90 Q261=-4 Q320=0 Q260=20 Q301=0 Q275=25.1 Q276=24.9 Q279=0 Q280=0 Q281=0 Q309=0 Q330=0";
    let body = format!("TOOL CALL 1 Z\nTCH PROBE 421 HOLE ~\n{}", hole.replace(' ', " ~\n"));
    let mut session = with_part(folder.path(), &body);
    run_to_the_end(&mut session);
    let fault = session.program().run.as_ref().unwrap().fault.as_ref().unwrap().message();
    assert!(said(&fault).contains("rib"), "{}", said(&fault));
    assert_eq!(answers(&session), by_command(folder.path(), "way.h", "part.toml"));
}

#[test]
fn a_part_is_asked_for_and_another_one_clears_the_run() {
    let folder = tempfile::tempdir().unwrap();
    let mut session = with_part(folder.path(), "L X+40 Y+30 Z+50 FMAX");
    send(&mut session, ProgramCommand::Run);
    assert!(session.program().run.is_some() && session.program().is_simulated());
    take(&mut session, PART);
    assert!(session.program().run.is_none());
    let mut session = with(&folder.path().join("way.h"));
    assert_eq!(
        send(&mut session, ProgramCommand::ChooseWorkpiece(WorkpieceFrom::Part)),
        [],
        "no home, no folder to list"
    );
    assert_eq!(session.dialog().unwrap().purpose, Purpose::OpenPart);
    assert_eq!(session.program().workpiece, WorkpieceFrom::Perfect);
    // The dialog of the simulated workpiece reads either kind of file.
    let number = session.dialog().unwrap().number;
    send(&mut session, Command::TypePath("/nc/part.toml".to_owned()));
    let effects = send(&mut session, Command::Confirm);
    assert_eq!(effects[0].errand(), &Effect::Read(Purpose::OpenPart, "/nc/part.toml".into()));
    let result = Ok(Box::new(Part::read(PART).unwrap()));
    let answer = WorkpieceCommand::PartRead { name: "part.toml".to_owned(), result };
    send(&mut session, Command::Answered(number, Box::new(answer.into())));
    assert!(session.dialog().is_none());
    assert_eq!(session.program().workpiece, WorkpieceFrom::Part);
    // Another source and back again: the part is still there.
    send(&mut session, ProgramCommand::ChooseWorkpiece(WorkpieceFrom::Perfect));
    send(&mut session, ProgramCommand::ChooseWorkpiece(WorkpieceFrom::Part));
    assert!(session.dialog().is_none());
    assert_eq!(session.program().workpiece, WorkpieceFrom::Part);
}

#[test]
fn the_cycles_page_refuses_a_part_with_its_reason() {
    let mut session = Session::new(Language::En);
    send(&mut session, Command::OpenPage(Page::Cycles));
    take(&mut session, PART);
    assert!(session.part().is_none());
    assert_eq!(
        said(&session.notices()[0].message),
        "the file has [[feature]] tables: a cycle on its own measures one surface; the programs page and fitcheck run measure such a part"
    );
}

#[test]
fn a_part_is_known_by_its_tables_and_opens_on_the_program_page() {
    assert_eq!(Purpose::of_file("part.toml", PART.as_bytes()), Ok(Purpose::OpenPart));
    // The beginning of a long file is enough.
    assert_eq!(Purpose::of_file("part.toml", &PART.as_bytes()[..60]), Ok(Purpose::OpenPart));
    let mut session = Session::new(Language::En);
    let path = PathBuf::from("/nc/part.toml");
    let effects = send(&mut session, FilesCommand::Open(Purpose::OpenPart, path.clone()));
    assert_eq!(effects, [Effect::Read(Purpose::OpenPart, path.clone())]);
    assert_eq!(session.page(), Page::Program);
    let fate = fitcheck::session::ReadOutcome::Read;
    send(&mut session, FilesCommand::Seen { purpose: Purpose::OpenPart, path: path.clone(), fate });
    let (restored, _) = Session::restore(session.saved());
    assert_eq!(restored.recent_files()[0].purpose, Purpose::OpenPart);
}
