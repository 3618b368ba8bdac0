//! The tool table without a window: which one is open, the tools of Q330, what a run changes, and what is saved. The
//! oracle is the command line.

use std::path::{Path, PathBuf};
use std::process::Command as Process;

use fitcheck::control::tool_table::ToolTable;
use fitcheck::control::variables::Parameter;
use fitcheck::message::Message;
use fitcheck::session::program::{Document, State, ToolOf, WorkpieceFrom};
use fitcheck::session::{
    Command, CycleField, CyclesCommand, Effect, FilesCommand, NamedTool, Page, ProgramCommand, ProgramField, Purpose,
    Session, ToolsCommand,
};
use fitcheck::words::{Language, Words};

fn sample() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/tools/tool_small.t")
}

fn send(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0))
}

fn said(message: &Message) -> String {
    Words::new(Language::En).say(message)
}

fn on(page: Page) -> Session {
    let mut session = Session::new(Language::En);
    send(&mut session, Command::OpenPage(page));
    session
}

/// Opens a table as the window does once its file has been read.
fn open_tools(session: &mut Session) {
    let table = ToolTable::read(&std::fs::read(sample()).unwrap(), "tool_small.t").unwrap();
    let read = ToolsCommand::Read { name: "tool_small.t".to_owned(), result: Ok(Box::new(table)) };
    assert_eq!(send(session, read), []);
}

const HOLE: &str = "Q273=+0 Q274=+0 Q262=25 Q325=0 Q247=90 Q261=-4 Q320=0 Q260=20 Q301=0 Q275=25.1 Q276=24.9 Q279=0 Q280=0 Q281=0 Q309=0";

/// A program whose cycle names this tool.
fn program(before: &str, tool: &str) -> String {
    let lines: Vec<String> = HOLE.split_whitespace().chain([tool]).map(|line| format!("   {line}")).collect();
    format!("BEGIN PGM own MM\n{before}TOOL CALL 9 Z\nTCH PROBE 421 HOLE ~\n{}\nEND PGM own MM\n", lines.join(" ~\n"))
}

fn open_program(session: &mut Session, text: &str) {
    let (document, warnings) = Document::read("own.h", text.as_bytes()).unwrap();
    let result = Ok((Box::new(document), warnings));
    assert_eq!(send(session, ProgramCommand::Read { path: PathBuf::from("own.h"), result }), []);
}

/// The program page with a program, a table, and a hole of this diameter.
fn with(text: &str, diameter: &str) -> Session {
    let mut session = on(Page::Program);
    open_program(&mut session, text);
    open_tools(&mut session);
    send(&mut session, ProgramCommand::Type(ProgramField::Diameter, diameter.to_owned()));
    assert_eq!(session.program().workpiece, WorkpieceFrom::Given);
    session
}

fn give(session: &mut Session, parameter: Parameter, text: &str) {
    assert_eq!(send(session, ProgramCommand::Type(ProgramField::Tool(parameter), text.to_owned())), []);
}

fn changes(session: &Session) -> Vec<String> {
    let run = session.program().run.as_ref().unwrap();
    run.tool_changes().iter().map(|changed| said(&fitcheck::message::Say::message(&changed.change))).collect()
}

/// The bytes that the open page saves, and the proposed name.
fn saved(session: &mut Session) -> (String, Vec<u8>) {
    send(session, Command::OpenDialog(Purpose::SaveTools));
    let effects = send(session, Command::Confirm);
    let Some(Effect::Save(path, content)) = effects.first().map(Effect::errand) else { panic!("{effects:?}") };
    let saved = (path.display().to_string(), content.bytes().unwrap());
    send(session, Command::Close);
    saved
}

/// What the command line writes with `--tools-out` for the same program on the same hole.
fn by_command(text: &str, diameter: &str, set: &[&str]) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, text: &str| {
        let mut file = std::fs::File::create(folder.path().join(name)).unwrap();
        std::io::Write::write_all(&mut file, text.as_bytes()).unwrap();
    };
    put("own.h", text);
    put("bore.toml", &format!("[bore]\ncentre = [0.0, 0.0]\ndiameter = {diameter}\n"));
    let mut process = Process::new(env!("CARGO_BIN_EXE_fitcheck"));
    process.current_dir(folder.path()).args([
        "run",
        "own.h",
        "--workpiece",
        "bore.toml",
        "--tools-out",
        "new.t",
        "--tools",
    ]);
    process.arg(sample());
    for set in set {
        process.args(["--set", set]);
    }
    let said = process.output().unwrap();
    std::fs::read(folder.path().join("new.t")).unwrap_or_else(|_| panic!("{said:?}"))
}

#[test]
fn a_tool_that_is_picked_for_a_parameter_is_corrected_as_by_the_command_line() {
    let text = program("", "Q330=+Q5");
    let mut session = with(&text, "25.03");
    assert_eq!(session.program().tools(), [ToolOf::Parameter(Parameter::q(5))]);
    for (tool, change) in [
        ("3", "tool 3 (MILL_D10): DR changed by 0.015 mm, from 0 to 0.015 mm"),
        ("5", "tool 5 (MILL_D12): DR changed by 0.015 mm, from −0.005 to 0.01 mm"),
    ] {
        give(&mut session, Parameter::q(5), tool);
        assert_eq!(session.program().tool_of(Parameter::q(5)), Some(NamedTool::Number(tool.to_owned())));
        send(&mut session, ProgramCommand::Run);
        assert_eq!(changes(&session), [change]);
        let (name, bytes) = saved(&mut session);
        assert_eq!(name, "tool_small.t");
        assert_eq!(bytes, by_command(&text, "25.03", &[&format!("Q5={tool}")]), "{tool}");
    }
}

#[test]
fn each_run_begins_with_the_table_as_it_was_opened() {
    let mut session = with(&program("", "Q330=3"), "25.03");
    for _ in 0..2 {
        send(&mut session, ProgramCommand::Run);
        assert_eq!(changes(&session), ["tool 3 (MILL_D10): DR changed by 0.015 mm, from 0 to 0.015 mm"]);
    }
    let opened = &session.tools().unwrap().table;
    assert_eq!(opened.write().unwrap(), std::fs::read(sample()).unwrap());
}

#[test]
fn a_broken_tool_is_locked_and_stops_the_run_as_the_control_says_it() {
    // RBREAK of tool 4 is 0.02 mm.
    let text = program("", "QS330=QS3");
    let mut session = with(&text, "25.05");
    assert_eq!(session.program().tools(), [ToolOf::Parameter(Parameter::qs(3))]);
    give(&mut session, Parameter::qs(3), "MILL_D16");
    send(&mut session, ProgramCommand::Run);
    assert_eq!(session.program().run.as_ref().unwrap().state, State::Faulted);
    let note = said(&session.program().note(0).unwrap().message);
    assert!(note.contains("error 1065: tool 4 is broken: DR would change by 0.025 mm, RBREAK is 0.02 mm"), "{note}");
    assert!(note.ends_with("its replacement is tool 6"), "{note}");
    assert_eq!(changes(&session), ["tool 4 (MILL_D16): locked, TL = L"]);
    assert_eq!(saved(&mut session).1, by_command(&text, "25.05", &["QS3=MILL_D16"]));
}

#[test]
fn tools_are_known_however_a_program_names_them() {
    #[track_caller]
    fn check(before: &str, tool: &str, expected: &[ToolOf]) {
        let mut session = on(Page::Program);
        open_program(&mut session, &program(before, tool));
        assert_eq!(session.program().tools(), expected, "{tool}");
    }
    let fixed = |tool: NamedTool| ToolOf::Fixed(tool);
    check("", "Q330=+0", &[]);
    check("", "Q330=+5.1", &[fixed(NamedTool::Number("5.1".to_owned()))]);
    check("", "QS330=\"DRILL\"", &[fixed(NamedTool::Name("DRILL".to_owned()))]);
    check("", "Q330=-Q5", &[]);
    check("", "Q330=QL7", &[ToolOf::Parameter("QL7".parse().unwrap())]);
    // What the program assigns itself is what counts while nothing is given.
    let mut session = with(&program("Q5 = 3\n", "Q330=+Q5"), "25");
    let tool = |session: &Session| session.program().tool_of(Parameter::q(5));
    assert_eq!(
        (session.program().own_tool(Parameter::q(5)), tool(&session)),
        (Some("3"), Some(NamedTool::Number("3".to_owned())))
    );
    give(&mut session, Parameter::q(5), "5");
    assert_eq!(tool(&session), Some(NamedTool::Number("5".to_owned())));
    give(&mut session, Parameter::q(5), "");
    assert_eq!(tool(&session), Some(NamedTool::Number("3".to_owned())));
    give(&mut session, Parameter::q(5), "0");
    assert_eq!(tool(&session), None);
}

#[test]
fn a_tool_that_cannot_be_read_keeps_the_program_from_running() {
    let mut session = with(&program("", "Q330=+Q5"), "25");
    let field = ProgramField::Tool(Parameter::q(5));
    give(&mut session, Parameter::q(5), "MILL");
    assert_eq!(session.error(field).map(said).as_deref(), Some("MILL is not a number"));
    send(&mut session, ProgramCommand::Run);
    assert!(session.program().run.is_none());
    assert_eq!(said(&session.program().state_message()), "An input cannot be read");
    // A tool that the table does not have is the control's own error.
    give(&mut session, Parameter::q(5), "7");
    assert_eq!(session.error(field), None);
    send(&mut session, ProgramCommand::Run);
    let note = said(&session.program().note(0).unwrap().message);
    assert!(note.contains("Q330 = 7: the tool table has no such tool; it has 0, 3, 4, 5, 6, 9"), "{note}");
}

#[test]
fn a_program_begins_without_the_tools_of_another() {
    let mut session = with(&program("", "Q330=+Q5"), "25");
    give(&mut session, Parameter::q(5), "3");
    open_program(&mut session, &program("", "Q330=+Q6"));
    assert_eq!(session.program().tool_inputs().collect::<Vec<_>>(), [Parameter::q(6)]);
    assert_eq!(session.program().given().count(), 0);
}

#[test]
fn another_table_or_none_clears_what_was_measured_with_the_first() {
    let mut session = with(&program("", "Q330=3"), "25.03");
    let changes: [fn(&mut Session); 2] = [open_tools, |session| _ = send(session, ToolsCommand::Close)];
    for change in changes {
        send(&mut session, ProgramCommand::Run);
        assert!(session.changed_tools().is_some());
        change(&mut session);
        assert!(session.program().run.is_none() && session.changed_tools().is_none());
    }
    send(&mut session, ProgramCommand::Run);
    assert!(session.program().run.as_ref().unwrap().tool_changes().is_empty(), "no table, no change");
    // A table that cannot be read changes nothing.
    let read = ToolsCommand::Read { name: "x.t".to_owned(), result: Err(Message::new("tools")) };
    send(&mut session, read);
    assert!(session.program().run.is_some() && session.tools().is_none());
}

/// The cycles page with cycle 421 on a perfect hole of a diameter that is not the nominal one.
fn hole(tool: &str) -> Session {
    let mut session = on(Page::Cycles);
    send(&mut session, CyclesCommand::Choose(421));
    for setting in HOLE.split_whitespace().chain([tool]) {
        let (name, text) = setting.split_once('=').unwrap();
        let field = CycleField::Parameter(session.cycles().cycle.parameter_named(name).unwrap().key);
        send(&mut session, CyclesCommand::Type(field, text.trim_start_matches('+').to_owned()));
    }
    let radius = [[12.515, 0.0], [0.0, 12.515], [-12.515, 0.0], [0.0, -12.515]];
    let contacts = radius.map(|[x, y]| fitcheck::probing::Contact { x, y, z: -4.0 }).to_vec();
    let contacts =
        fitcheck::exchange::contacts::Contacts { contacts, has_heights: true, ignored: Vec::new(), warm: None };
    let result = Ok((contacts, Vec::new()));
    send(&mut session, fitcheck::session::WorkpieceCommand::ContactsRead { name: "bore.csv".to_owned(), result });
    session
}

fn remarks(session: &Session) -> Vec<String> {
    session.cycles().run.as_ref().unwrap().remarks().iter().map(said).collect()
}

#[test]
fn the_cycles_page_monitors_its_tool_with_the_same_table() {
    let not_monitored = "Q330 = 3: the tool is not monitored: no tool table";
    let mut session = hole("Q330=3");
    send(&mut session, CyclesCommand::Run);
    assert!(remarks(&session).iter().any(|remark| remark == not_monitored), "{:?}", remarks(&session));
    assert!(session.cycles().run.as_ref().unwrap().monitoring.is_none());
    open_tools(&mut session);
    assert!(session.cycles().run.is_none(), "a result without a table does not stay beside one");
    send(&mut session, CyclesCommand::Run);
    assert!(!remarks(&session).iter().any(|remark| remark == not_monitored));
    let monitoring = session.cycles().run.as_ref().unwrap().monitoring.as_ref().unwrap();
    assert_eq!(monitoring.problem(), None);
    let change = said(&fitcheck::message::Say::message(monitoring.change().unwrap()));
    assert_eq!(change, "tool 3 (MILL_D10): DR changed by 0.015 mm, from 0 to 0.015 mm");
    let (name, bytes) = saved(&mut session);
    assert_eq!(name, "tool_small.t");
    assert_eq!(bytes, by_command(&program("", "Q330=3"), "25.03", &[]));
}

#[test]
fn the_cycles_page_says_why_a_tool_is_not_corrected() {
    for (tool, problem, remark) in [
        ("Q330=7", Some("Q330 = 7: the tool table has no such tool; it has 0, 3, 4, 5, 6, 9"), None),
        ("Q330=0", None, Some("Q330 names no tool: the tool table is not used")),
    ] {
        let mut session = hole(tool);
        open_tools(&mut session);
        send(&mut session, CyclesCommand::Run);
        let run = session.cycles().run.as_ref().unwrap();
        assert!(run.found().is_some(), "what was measured stands");
        assert_eq!(run.monitoring.as_ref().unwrap().problem().as_ref().map(said).as_deref(), problem, "{tool}");
        assert_eq!(remarks(&session).last().map(String::as_str).filter(|_| remark.is_some()), remark, "{tool}");
        assert!(session.changed_tools().is_none());
        send(&mut session, Command::OpenDialog(Purpose::SaveTools));
        assert_eq!(send(&mut session, Command::Confirm), [], "nothing to save");
        assert_eq!(
            session.dialog().unwrap().problem.as_ref().map(said).as_deref(),
            Some("no run has changed the tool table")
        );
    }
}

#[test]
fn a_table_is_opened_for_the_page_that_is_open_and_comes_back_from_the_state_file() {
    for (page, shown) in [(Page::Cycles, Page::Cycles), (Page::Program, Page::Program), (Page::Check, Page::Program)] {
        let mut session = on(page);
        let effects = send(&mut session, FilesCommand::Open(Purpose::OpenTools, "/nc/tool.t".into()));
        assert_eq!(effects, [Effect::Read(Purpose::OpenTools, "/nc/tool.t".into())]);
        assert_eq!(session.page(), shown, "{page:?}");
        let fate = fitcheck::session::ReadOutcome::Read;
        send(&mut session, FilesCommand::Seen { purpose: Purpose::OpenTools, path: "/nc/tool.t".into(), fate });
        let (restored, _) = Session::restore(session.saved());
        let recent: Vec<_> = restored.recent_files().iter().map(|file| (file.purpose, file.path.clone())).collect();
        assert_eq!(recent, [(Purpose::OpenTools, PathBuf::from("/nc/tool.t"))]);
    }
}
