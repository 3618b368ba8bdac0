//! Files in the window: the dialog with its list, proposed names, the question before a file is replaced, recent files.

#![cfg(test)]

use fitcheck::session::{FilesAction, WindowAction};
use std::path::{Path, PathBuf};

use fitcheck::files::{Entry, FileError, Listing};
use fitcheck::message::{Message, Say as _};
use fitcheck::report::RENDERINGS;
use fitcheck::session::{
    CheckCommand, CheckField, Command, CycleFile, Dialog, Effect, FilesCommand, Launch, Page, Purpose, ReadOutcome,
    Saved, Session, Step,
};
use fitcheck::words::{Language, Words};
use jiff::civil::{DateTime, date};

/// A path from the root of a disk: Windows remembers only one that names the disk.
fn rooted(path: &str) -> String {
    if cfg!(windows) { format!("C:{path}") } else { path.to_owned() }
}

fn now() -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0)
}

fn session() -> Session {
    let mut session = Session::new(Language::En);
    session.use_home("/home/mia".into());
    session
}

fn send(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), now())
}

fn check(session: &mut Session, callout: &str, measured: &str) {
    for (field, text) in [(CheckField::Callout, callout), (CheckField::Measured, measured)] {
        send(session, CheckCommand::Type(field, text.to_owned()));
    }
    send(session, CheckCommand::Measure);
}

fn csv() -> Purpose {
    Purpose::Export(RENDERINGS.iter().position(|rendering| rendering.name == "csv").unwrap())
}

fn entry(folder: &str, name: &str) -> Entry {
    let is_folder = name.ends_with('/');
    let name = name.trim_end_matches('/').to_owned();
    Entry { path: Path::new(folder).join(&name), name, is_folder, bytes: 7, changed: None }
}

/// A folder as the outside world lists it.
fn listed(folder: &str, names: &[&str]) -> FilesCommand {
    let entries = names.iter().map(|name| entry(folder, name)).collect();
    let listing = Listing { folder: folder.into(), entries, has_more: false };
    FilesCommand::Listed { folder: folder.into(), result: Ok(Box::new(listing)) }
}

/// The answer to what the open dialog asked for.
fn answer(session: &mut Session, answer: impl Into<Command>) -> Vec<Effect> {
    let number = dialog(session).number;
    send(session, Command::Answered(number, Box::new(answer.into())))
}

/// What the open dialog asks for, and nothing else is asked.
#[track_caller]
fn asked_for(session: &Session, effects: &[Effect]) -> Effect {
    let [Effect::ForDialog(number, errand)] = effects else { panic!("{effects:?}") };
    assert_eq!(*number, dialog(session).number);
    errand.as_ref().clone()
}

fn dialog(session: &Session) -> &Dialog {
    session.dialog().unwrap()
}

fn shown(session: &Session) -> Vec<&str> {
    let list = &dialog(session).list;
    (0..list.len()).map(|number| list.entry(number).unwrap().name.as_str()).collect()
}

/// The import dialog with the home folder in its list.
fn importing() -> Session {
    let mut session = session();
    assert_eq!(
        send(&mut session, Command::OpenDialog(Purpose::Import)),
        [Effect::List("/home/mia".into())],
        "the folder is read outside"
    );
    assert!(dialog(&session).list.is_reading());
    send(&mut session, listed("/home/mia", &["logs/", ".cache/", "a.csv", "b.CSV", "notes.pdf", ".c.csv"]));
    session
}

#[test]
fn the_list_shows_folders_and_files_that_fit() {
    let mut session = importing();
    assert_eq!(shown(&session), ["logs", "a.csv", "b.CSV"]);
    assert_eq!(dialog(&session).list.left_out(), 3);
    let all = FilesAction::AllFiles.command(&session).unwrap();
    send(&mut session, all);
    assert_eq!((shown(&session).len(), FilesAction::AllFiles.is_on(&session)), (6, Some(true)));
    let fitting = FilesAction::AllFiles.command(&session).unwrap();
    send(&mut session, fitting);
    assert_eq!(shown(&session).len(), 3);
}

#[test]
fn typing_filters_and_arrows_and_enter_choose() {
    let mut session = importing();
    send(&mut session, Command::TypePath("B".into()));
    assert_eq!(shown(&session), ["b.CSV"]);
    send(&mut session, FilesCommand::Move(Step::Down));
    assert_eq!((dialog(&session).path.as_str(), dialog(&session).list.selected), ("b.CSV", Some(0)));
    assert_eq!(shown(&session), ["b.CSV"], "the name of a selected file is no filter");
    let effects = send(&mut session, Command::Confirm);
    assert_eq!(asked_for(&session, &effects), Effect::Read(Purpose::Import, "/home/mia/b.CSV".into()));
    for step in [Step::Up, Step::Down, Step::PageDown] {
        send(&mut session, FilesCommand::Move(step));
        assert_eq!(dialog(&session).list.selected, Some(0), "nothing moves while the file is read");
    }
}

#[test]
fn arrows_end_at_the_first_and_the_last_entry() {
    let mut session = importing();
    for (step, at) in [
        (Step::Down, 0),
        (Step::Down, 1),
        (Step::PageDown, 2),
        (Step::Down, 2),
        (Step::Up, 1),
        (Step::PageUp, 0),
        (Step::Up, 0),
    ] {
        send(&mut session, FilesCommand::Move(step));
        assert_eq!(dialog(&session).list.selected, Some(at), "{step:?}");
    }
    let mut other = importing();
    send(&mut other, FilesCommand::Move(Step::Up));
    assert_eq!(dialog(&other).path, "b.CSV");
}

#[test]
fn a_folder_is_gone_into_and_left_again() {
    let mut session = importing();
    send(&mut session, FilesCommand::Move(Step::Down));
    assert_eq!(dialog(&session).path, "", "a folder is no file");
    assert_eq!(send(&mut session, Command::Confirm), [Effect::List("/home/mia/logs".into())]);
    assert!(shown(&session).is_empty() && dialog(&session).list.is_reading());
    // An answer about another folder comes too late.
    send(&mut session, listed("/home/mia", &["a.csv"]));
    assert!(shown(&session).is_empty());
    send(&mut session, listed("/home/mia/logs", &["x.txt"]));
    assert_eq!(shown(&session), ["x.txt"]);
    assert_eq!(send(&mut session, FilesCommand::Up), [Effect::List("/home/mia".into())]);
    send(&mut session, listed("/home/mia", &["logs/"]));
    assert_eq!(send(&mut session, FilesCommand::Select(0)), [Effect::List("/home/mia/logs".into())]);
    assert_eq!(send(&mut session, FilesCommand::Home), [Effect::List("/home/mia".into())]);
    send(&mut session, FilesCommand::Show("/".into()));
    assert!(!session.can(FilesAction::FolderUp), "there is nothing above the root");
}

#[test]
fn a_folder_that_cannot_be_read_is_told_in_the_dialog() {
    let mut session = importing();
    send(&mut session, FilesCommand::Show("/none".into()));
    let missing = FileError::Missing { path: "/none".into() };
    send(&mut session, FilesCommand::Listed { folder: "/none".into(), result: Err(missing.clone()) });
    assert_eq!(dialog(&session).list.problem.as_ref(), Some(&missing.message()));
    assert!(
        !dialog(&session).list.is_reading()
            && session.can(FilesAction::FolderUp)
            && session.can(FilesAction::HomeFolder)
    );
}

#[test]
fn a_typed_path_begins_in_the_listed_folder_and_a_typed_folder_is_shown() {
    for (typed, path) in [
        ("sub/x.csv", "/home/mia/sub/x.csv"),
        ("  a.csv ", "/home/mia/a.csv"),
        ("/tmp/a.csv", "/tmp/a.csv"),
        ("~/a.csv", "/home/mia/a.csv"),
    ] {
        let mut session = importing();
        send(&mut session, FilesCommand::Show("/home/mia".into()));
        send(&mut session, Command::TypePath(typed.into()));
        let effects = send(&mut session, Command::Confirm);
        assert_eq!(asked_for(&session, &effects), Effect::Read(Purpose::Import, path.into()), "{typed}");
    }
    let mut session = importing();
    send(&mut session, Command::TypePath("/tmp".into()));
    send(&mut session, Command::Confirm);
    let effects = answer(&mut session, FilesCommand::IsFolder("/tmp".into()));
    assert_eq!(effects, [Effect::List("/tmp".into())]);
    assert_eq!((dialog(&session).path.as_str(), dialog(&session).busy), ("", false));
    send(&mut session, Command::Close);
    send(&mut session, FilesCommand::IsFolder("/tmp".into()));
    assert!(session.notices()[0].is_problem, "without a dialog it is told");
}

#[test]
fn a_folder_of_tables_is_the_one_that_is_listed() {
    let mut session = session();
    send(&mut session, Command::OpenDialog(Purpose::LoadTables));
    send(&mut session, listed("/home/mia", &["tables/", "a.tab"]));
    assert_eq!(shown(&session), ["tables"]);
    send(&mut session, FilesCommand::Select(0));
    assert_eq!(Path::new(&dialog(&session).path), Path::new("/home/mia/tables"));
    let effects = send(&mut session, Command::Confirm);
    assert_eq!(asked_for(&session, &effects), Effect::Read(Purpose::LoadTables, "/home/mia/tables".into()));
}

#[test]
fn a_proposed_name_has_part_and_date() {
    let mut session = session();
    check(&mut session, "25 H7", "25.012");
    send(&mut session, Command::OpenDialog(csv()));
    assert_eq!(dialog(&session).path, "25H7-2026-11-21.csv");
    send(&mut session, Command::Close);
    send(&mut session, Command::OpenDialog(Purpose::ExportStatus));
    assert_eq!(dialog(&session).path, "25H7-status-2026-11-21.txt");
    send(&mut session, Command::Close);
    check(&mut session, "30 H7", "30.012");
    send(&mut session, Command::OpenDialog(csv()));
    assert_eq!(dialog(&session).path, "checks-2026-11-21.csv");
    send(&mut session, Command::Close);
    send(&mut session, Command::SetLanguage(Language::Nl));
    send(&mut session, Command::OpenDialog(csv()));
    assert_eq!(dialog(&session).path, "controles-2026-11-21.csv");
}

/// Imports one row with this name, and returns the name that is proposed for its report.
fn proposed(id: &str) -> String {
    let mut session = session();
    let text = format!("id;callout;measured\n\"{id}\";25 H7;25.012\n");
    let sources = fitcheck::tolerance::Sources::default();
    let imported = fitcheck::exchange::import("parts.csv", text.as_bytes(), &sources, now());
    assert_eq!(imported.records.len(), 1, "{id}");
    send(&mut session, CheckCommand::Imported { name: "parts.csv".into(), result: Ok(Box::new(imported)) });
    send(&mut session, Command::OpenDialog(csv()));
    dialog(&session).path.clone()
}

#[test]
fn a_proposed_name_has_only_what_every_system_allows() {
    for (id, name) in [
        ("A12", "A12-25H7-2026-11-21.csv"),
        ("a/b\\c:d*e?", "a-b-c-d-e-25H7-2026-11-21.csv"),
        ("..", "25H7-2026-11-21.csv"),
        ("Bohrung Ø 3", "Bohrung-Ø-3-25H7-2026-11-21.csv"),
        ("con", "con-25H7-2026-11-21.csv"),
    ] {
        assert_eq!(proposed(id), name, "{id}");
    }
    for letter in ["x", "漢"] {
        let long = proposed(&letter.repeat(200));
        assert!(long.ends_with("-2026-11-21.csv") && long.len() < 255 && long.chars().count() <= 100, "{long}");
    }
}

#[test]
fn a_name_without_an_ending_gets_the_one_of_its_kind() {
    let mut session = session();
    check(&mut session, "25 H7", "25.012");
    for (typed, path) in [
        ("mine", "/home/mia/mine.csv"),
        ("mine.txt", "/home/mia/mine.txt"),
        ("mine.HTML", "/home/mia/mine.HTML"),
        ("bore 12.5", "/home/mia/bore 12.5.csv"),
        ("bore 12.5H7", "/home/mia/bore 12.5H7.csv"),
        ("bore 12.5 mm", "/home/mia/bore 12.5 mm.csv"),
        ("sub/mine", "/home/mia/sub/mine.csv"),
    ] {
        send(&mut session, Command::OpenDialog(csv()));
        send(&mut session, Command::TypePath(typed.into()));
        let effects = send(&mut session, Command::Confirm);
        let Some(Effect::Save(saved, _)) = effects.first().map(Effect::errand) else { panic!("{effects:?}") };
        assert_eq!(saved, Path::new(path));
        send(&mut session, Command::Close);
    }
}

#[test]
fn a_name_taken_from_the_list_goes_along_to_another_folder() {
    let mut session = session();
    check(&mut session, "25 H7", "25.012");
    send(&mut session, Command::OpenDialog(csv()));
    send(&mut session, listed("/home/mia", &["old/", "a.csv"]));
    send(&mut session, FilesCommand::Select(1));
    assert_eq!(dialog(&session).path, "a.csv");
    send(&mut session, FilesCommand::Select(0));
    assert_eq!(dialog(&session).path, "a.csv");
    let effects = send(&mut session, Command::Confirm);
    let Some(Effect::Save(path, _)) = effects.first().map(Effect::errand) else { panic!("{effects:?}") };
    assert_eq!(path, Path::new("/home/mia/old/a.csv"));
}

/// An export whose file exists, before the user has answered.
fn asked() -> Session {
    let mut session = session();
    check(&mut session, "25 H7", "25.012");
    send(&mut session, Command::OpenDialog(csv()));
    send(&mut session, Command::TypePath("/tmp/x.csv".into()));
    send(&mut session, Command::Confirm);
    let exists = FileError::Exists { path: "/tmp/x.csv".into() };
    answer(&mut session, Command::Saved { path: "/tmp/x.csv".into(), result: Err(exists) });
    assert_eq!(dialog(&session).exists, Some(PathBuf::from("/tmp/x.csv")));
    session
}

#[test]
fn a_file_that_exists_is_only_replaced_when_the_user_says_so() {
    let mut session = asked();
    assert_eq!(send(&mut session, Command::Confirm), [], "the question comes first");
    assert!(!session.can(FilesAction::Browse) && session.can(FilesAction::KeepFile));
    let effects = send(&mut session, FilesCommand::Replace(true));
    let Some(Effect::Replace(path, content)) = effects.first().map(Effect::errand) else { panic!("{effects:?}") };
    assert!(path == Path::new("/tmp/x.csv") && String::from_utf8_lossy(&content.bytes().unwrap()).contains("25.012"));
    for keep in [Command::from(FilesCommand::Replace(false)), Command::Close] {
        let mut session = asked();
        assert_eq!(send(&mut session, keep), []);
        assert_eq!((&dialog(&session).exists, dialog(&session).path.as_str()), (&None, "/tmp/x.csv"));
        assert_eq!(send(&mut session, FilesCommand::Replace(true)), [], "nobody is asked any more");
    }
}

#[test]
fn a_written_file_is_told_with_its_folder_and_can_be_opened() {
    let mut session = session();
    let (tmp, file) = (rooted("/tmp"), rooted("/tmp/x.csv"));
    check(&mut session, "25 H7", "25.012");
    assert!(!session.can(WindowAction::OpenWritten));
    send(&mut session, Command::OpenDialog(csv()));
    send(&mut session, Command::TypePath(file.clone()));
    send(&mut session, Command::Confirm);
    answer(&mut session, Command::Saved { path: file.clone().into(), result: Ok(()) });
    assert_eq!(Words::new(Language::En).say(&session.notices()[0].message), format!("x.csv was written to {tmp}"));
    for (action, how) in [(WindowAction::OpenWritten, Launch::Open), (WindowAction::ShowWritten, Launch::ShowInFolder)]
    {
        let command = action.command(&session).unwrap();
        assert_eq!(send(&mut session, command), [Effect::Launch(file.clone().into(), how)]);
    }
    send(&mut session, FilesCommand::Launched(Ok(())));
    assert_eq!(session.notices().len(), 1);
    send(&mut session, FilesCommand::Launched(Err(Message::new("launch-failed").text("reason", "none"))));
    assert!(session.notices()[0].is_problem && session.notices()[1].file.is_some());
    // The next dialog of the kind begins there, and one of another kind as well.
    assert_eq!(send(&mut session, Command::OpenDialog(csv())), [Effect::List(tmp.clone().into())]);
    assert!(!session.can(WindowAction::OpenWritten), "the dialog lies over the notice");
    send(&mut session, Command::Close);
    assert_eq!(send(&mut session, Command::OpenDialog(Purpose::Import)), [Effect::List(tmp.clone().into())]);
}

#[test]
fn every_kind_begins_in_its_own_last_folder() {
    let mut session = session();
    for (purpose, path) in [(Purpose::Import, "/parts/a.csv"), (Purpose::OpenProgram, "/nc/a.h")] {
        send(&mut session, FilesCommand::Seen { purpose, path: rooted(path).into(), fate: ReadOutcome::Read });
    }
    let (mut again, _) = Session::restore(Saved::read(&session.saved().write().unwrap()).unwrap());
    for (purpose, folder) in [(Purpose::Import, "/parts"), (Purpose::OpenProgram, "/nc"), (Purpose::LoadMask, "/nc")] {
        assert_eq!(
            send(&mut again, Command::OpenDialog(purpose)),
            [Effect::List(rooted(folder).into())],
            "{purpose:?}"
        );
        send(&mut again, Command::Close);
    }
    assert_eq!(again.recent_folders(), [Path::new(&rooted("/nc")), Path::new(&rooted("/parts"))]);
}

#[test]
fn the_system_dialog_that_gives_nothing_is_told_and_the_list_stays() {
    let mut session = importing();
    let browse = Effect::Browse { purpose: Purpose::Import, folder: Some("/home/mia".into()), name: String::new() };
    let effects = send(&mut session, Command::Browse);
    assert_eq!(asked_for(&session, &effects), browse);
    assert_eq!(answer(&mut session, Command::Picked(None)), []);
    assert!(dialog(&session).nothing_picked && shown(&session).len() == 3);
    let effects = answer(&mut session, Command::Picked(Some("/tmp/b.csv".into())));
    assert_eq!(asked_for(&session, &effects), Effect::Read(Purpose::Import, "/tmp/b.csv".into()));
    assert!(!dialog(&session).nothing_picked);
}

#[cfg(unix)]
#[test]
fn a_name_that_is_no_text_is_read_as_it_is_and_kept_out_of_the_state_file() {
    use std::os::unix::ffi::OsStrExt as _;
    let odd = Path::new("/tmp").join(std::ffi::OsStr::from_bytes(b"\xff.csv"));
    let mut session = importing();
    let effects = answer(&mut session, Command::Picked(Some(odd.clone())));
    assert_eq!(asked_for(&session, &effects), Effect::Read(Purpose::Import, odd.clone()));
    send(&mut session, FilesCommand::Seen { purpose: Purpose::Import, path: odd, fate: ReadOutcome::Read });
    assert_eq!(session.recent_files().len(), 1);
    let saved = Saved::read(&session.saved().write().unwrap()).unwrap();
    assert_eq!((saved.files.recent.len(), saved.files.last_folder), (0, Some("/tmp".into())));
    assert_eq!(saved.language, Language::En);
}

fn seen(session: &mut Session, purpose: Purpose, path: &str, fate: ReadOutcome) {
    send(session, FilesCommand::Seen { purpose, path: path.into(), fate });
}

fn recent(session: &Session) -> Vec<String> {
    session.recent_files().iter().map(|file| file.path.display().to_string()).collect()
}

#[test]
fn the_last_ten_files_that_were_read_are_remembered() {
    let mut session = session();
    for number in 0..12 {
        seen(&mut session, Purpose::Import, &format!("/{number}.csv"), ReadOutcome::Read);
    }
    assert_eq!((recent(&session).len(), recent(&session)[0].as_str()), (10, "/11.csv"));
    seen(&mut session, Purpose::Import, "/5.csv", ReadOutcome::Read);
    assert_eq!((recent(&session).len(), recent(&session)[0].as_str()), (10, "/5.csv"));
    seen(&mut session, Purpose::Import, "/9.csv", ReadOutcome::Refused);
    assert_eq!((recent(&session).len(), recent(&session)[0].as_str()), (10, "/5.csv"));
    seen(&mut session, Purpose::Import, "/9.csv", ReadOutcome::Gone);
    assert!(recent(&session).len() == 9 && !recent(&session).contains(&"/9.csv".to_owned()));
    // The user's own tables are read at every start: that is no file that somebody opened.
    seen(&mut session, Purpose::LoadTables, "/tables", ReadOutcome::Read);
    assert_eq!(recent(&session).len(), 9);
    send(&mut session, FilesCommand::ForgetRecent);
    assert!(recent(&session).is_empty() && !session.can(WindowAction::ForgetRecent));
}

#[test]
fn a_recent_file_is_read_again_for_what_it_was_read_for_on_its_page() {
    let contacts = Purpose::OpenCycleFile(CycleFile::Contacts);
    for (purpose, from, page) in [
        (Purpose::Import, Page::Fit, Page::Check),
        (Purpose::OpenTable, Page::Check, Page::Tables),
        (Purpose::OpenProgram, Page::Check, Page::Program),
        (contacts, Page::Check, Page::Cycles),
        (contacts, Page::Program, Page::Program),
        (Purpose::LoadMask, Page::Fit, Page::Fit),
    ] {
        let mut session = session();
        seen(&mut session, purpose, "/a.b", ReadOutcome::Read);
        let (mut again, _) = Session::restore(Saved::read(&session.saved().write().unwrap()).unwrap());
        send(&mut again, Command::OpenPage(from));
        assert_eq!(send(&mut again, FilesCommand::OpenRecent(0)), [Effect::Read(purpose, "/a.b".into())]);
        assert_eq!(again.page(), page, "{purpose:?}");
        assert_eq!(send(&mut again, FilesCommand::OpenRecent(1)), []);
    }
}

#[test]
fn a_kind_of_file_of_a_later_version_is_left_out() {
    let state = b"[files]\n[[files.recent]]\nkind = \"hologram\"\npath = \"/a\"\n[[files.recent]]\nkind = \"mask\"\npath = \"/b\"\n";
    let (session, _) = Session::restore(Saved::read(state).unwrap());
    assert_eq!(recent(&session), ["/b"]);
}

#[test]
fn a_file_is_known_by_its_content_and_its_ending() {
    let cycle = Purpose::OpenCycleFile;
    for (name, head, purpose) in [
        ("part.csv", "id,callout,measured\n", Some(Purpose::Import)),
        ("PART.CSV", "x,y\n1,2\n", Some(Purpose::Import)),
        ("empty.csv", "", Some(Purpose::Import)),
        ("bore.h", "0 BEGIN PGM BORE MM\n", Some(Purpose::OpenProgram)),
        ("flange.nc", "%FLANGE.nc\n", Some(Purpose::OpenProgram)),
        ("sub.NCS", "", Some(Purpose::OpenProgram)),
        ("bore", "0  BEGIN PGM BORE MM\n", Some(Purpose::OpenProgram)),
        ("part.I", "%PART G71 *\n", Some(Purpose::OpenProgram)),
        ("part", "%PART G70*\n", Some(Purpose::OpenProgram)),
        ("part", "%PART\n", None),
        ("hole.TAB", "BEGIN HOLE.TAB MM\n", Some(Purpose::OpenTable)),
        ("hole.bak", "BEGIN HOLE .TAB MM\n", Some(Purpose::OpenTable)),
        ("probes.bak", "BEGIN TCHPROBE.TP MM\n", Some(cycle(CycleFile::Probes))),
        ("tool.t", "", Some(Purpose::OpenTools)),
        ("TOOL.T", "BEGIN TOOL.T MM\n", Some(Purpose::OpenTools)),
        ("tool.bak", "BEGIN TOOL .T MM\n", Some(Purpose::OpenTools)),
        ("tool.old", "BEGIN TOOL.T\n", Some(Purpose::OpenTools)),
        ("tchprobe.tp", "", Some(cycle(CycleFile::Probes))),
        ("bore.toml", "[bore]\n", Some(cycle(CycleFile::Workpiece))),
        ("status.a", "\"%S\", QS2;\n", Some(Purpose::LoadMask)),
        ("part.csv", "\u{1}\u{2}\u{3}\u{4}", None),
        ("notes", "bring the H7 gauge\n", None),
        ("picture.png", "\u{89}PNG\r\n", None),
    ] {
        assert_eq!(Purpose::of_file(name, head.as_bytes()).ok(), purpose, "{name}: {head:?}");
    }
    let log = include_bytes!("../data/samples/logs/en/TCHPR421.TXT");
    for name in ["TCHPR421.TXT", "log.old"] {
        assert_eq!(Purpose::of_file(name, log), Ok(Purpose::Import), "{name}");
    }
}

/// What is done when this is typed into the dialog of a report.
fn saved_as(typed: &str) -> (Session, Vec<Effect>) {
    let mut session = session();
    check(&mut session, "25 H7", "25.012");
    send(&mut session, Command::OpenDialog(csv()));
    send(&mut session, listed("/home/mia", &["reports/", "notes.txt"]));
    send(&mut session, Command::TypePath(typed.into()));
    let effects = send(&mut session, Command::Confirm);
    (session, effects)
}

#[test]
fn a_folder_typed_for_a_file_that_is_written_opens_in_the_list() {
    for (typed, folder) in [
        ("/tmp/reports/", "/tmp/reports"),
        ("/", "/"),
        ("~", "/home/mia"),
        ("~/", "/home/mia"),
        ("reports/", "/home/mia/reports"),
        ("reports", "/home/mia/reports"),
        ("~/reports", "/home/mia/reports"),
        ("..", "/home/mia/.."),
        ("reports/.", "/home/mia/reports"),
    ] {
        let (session, effects) = saved_as(typed);
        assert_eq!(effects, [Effect::List(folder.into())], "{typed}");
        // The proposed name is there again, for a file in that folder.
        assert_eq!((dialog(&session).path.as_str(), dialog(&session).busy), ("25H7-2026-11-21.csv", false), "{typed}");
    }
    let (session, effects) = saved_as("report");
    let Effect::Save(path, _) = asked_for(&session, &effects) else { panic!("a name is a file") };
    assert_eq!(path, Path::new("/home/mia/report.csv"));
}

/// A report is being written, its dialog was closed, and the status window is about to be written from another one.
/// The number is that of the first dialog.
fn overtaken() -> (Session, fitcheck::session::DialogId) {
    let mut session = session();
    check(&mut session, "25 H7", "25.012");
    send(&mut session, Command::OpenDialog(csv()));
    let number = dialog(&session).number;
    for path in ["/tmp/a.csv", "/tmp/b.txt"] {
        send(&mut session, Command::TypePath(path.into()));
        assert_eq!(send(&mut session, Command::Confirm).len(), 1);
        if path == "/tmp/a.csv" {
            send(&mut session, Command::Close);
            send(&mut session, Command::OpenDialog(Purpose::ExportStatus));
        }
    }
    assert!(dialog(&session).busy && dialog(&session).number != number);
    (session, number)
}

#[test]
fn a_late_answer_asks_closes_and_refuses_nothing_in_another_dialog() {
    let path = || PathBuf::from("/tmp/a.csv");
    let exists = || FileError::Exists { path: path() };
    let answers: [Command; 5] = [
        Command::Saved { path: path(), result: Ok(()) },
        Command::Saved { path: path(), result: Err(exists()) },
        Command::MaskRead { path: "a".into(), result: Err(exists().message()) },
        FilesCommand::IsFolder(path()).into(),
        Command::Picked(Some(path())),
    ];
    for late in answers {
        for number in [true, false] {
            let (mut session, first) = overtaken();
            let before = dialog(&session).clone();
            let late = late.clone();
            let late = if number { Command::Answered(first, Box::new(late)) } else { late };
            let is_told = !matches!(&late, Command::Picked(_))
                && !matches!(&late, Command::Answered(_, late) if matches!(**late, Command::Picked(_)));
            assert_eq!(send(&mut session, late.clone()), [], "{late:?}");
            assert_eq!(dialog(&session), &before, "{late:?}");
            assert_eq!(session.notices().len(), usize::from(is_told), "{late:?} is told beside the dialog");
            assert_eq!(send(&mut session, FilesCommand::Replace(true)), [], "{late:?}");
        }
    }
    let (mut session, _) = overtaken();
    answer(&mut session, Command::Saved { path: "/tmp/b.txt".into(), result: Ok(()) });
    assert!(session.dialog().is_none(), "its own answer closes it");
}

#[test]
fn a_proposed_name_keeps_the_meaning_of_the_signs_in_a_callout() {
    for (callout, measured, name) in [
        ("12 ±0.02", "12.01", "12+0.02-0.02-2026-11-21.csv"),
        ("12 +0.01 -0.015", "12", "12+0.01-0.015-2026-11-21.csv"),
        ("12.01/11.985", "12", "12.01_11.985-2026-11-21.csv"),
    ] {
        let mut session = session();
        send(&mut session, CheckCommand::Type(CheckField::Callout, callout.to_owned()));
        send(&mut session, CheckCommand::ChooseFeature(Some(fitcheck::tolerance::Feature::Hole)));
        send(&mut session, CheckCommand::Type(CheckField::Measured, measured.to_owned()));
        send(&mut session, CheckCommand::Measure);
        send(&mut session, Command::OpenDialog(csv()));
        assert_eq!(dialog(&session).path, name, "{callout}");
    }
}
