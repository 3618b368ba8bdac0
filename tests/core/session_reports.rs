//! What the window tells the journal of reports that it has written, without a window, a file or a thread.

use std::path::Path;
use std::sync::Arc;

use fitcheck::journal::chain::Hash;
use fitcheck::journal::entry::{Content as Told, Correction, Reported, Shown};
use fitcheck::journal::ranges::EntryRanges;
use fitcheck::message::Message;
use fitcheck::proof::SeenFile;
use fitcheck::report::pdf::Pages;
use fitcheck::session::records::LeftOut;
use fitcheck::session::{
    CheckCommand, Command, Content, Drawing, Effect, Page, Purpose, RecordRow, RecordsAction, RecordsCommand, ReportOf,
    ReportsCommand, Session,
};

use crate::session_records::{check_row, head, kept, measure, opened, recording, row, send, told};

/// Measures a bore and records it with a number.
fn recorded(session: &mut Session, measured: &str, number: u64) {
    let (run, _) = kept(&measure(session, "25 H7", measured));
    send(session, RecordsCommand::Kept { run, result: Ok(vec![head(number)]) });
}

/// Confirms the open dialog, and gives what is to be written.
#[track_caller]
fn written(session: &mut Session, name: &str) -> Content {
    send(session, Command::TypePath(format!("/reports/{name}")));
    let effects = send(session, Command::Confirm);
    let [Effect::ForDialog(_, effect)] = effects.as_slice() else { panic!("{effects:?}") };
    let Effect::Save(_, content @ Content::Report { .. }) = effect.as_ref() else { panic!("{effect:?}") };
    content.clone()
}

fn reported(content: &Content, name: &str) -> Option<Reported> {
    content.reported(Path::new(name), SeenFile { sha256: Hash([7; 32]), bytes: 9 })
}

fn report_row(number: u64, checks: &[u64]) -> RecordRow {
    let shown = Shown { checks: EntryRanges::of(checks.iter().copied()), unrecorded: 0, head: Some(head(number - 1)) };
    let report = Reported {
        name: "flange.html".to_owned(),
        format: "html".to_owned(),
        sha256: Hash([7; 32]),
        bytes: 9,
        title: String::new(),
        shown,
    };
    row(number, Told::Report(report), None)
}

#[test]
fn a_report_of_the_history_names_the_records_of_its_checks_and_counts_the_others() {
    let mut session = recording();
    recorded(&mut session, "25.012", 2);
    recorded(&mut session, "25.013", 5);
    measure(&mut session, "25 H7", "25.014");
    send(&mut session, Command::OpenDialog(Purpose::Export(1)));
    let content = written(&mut session, "lot.csv");
    assert!(content.is_of_journal());
    let report = reported(&content, "/reports/lot.csv").unwrap();
    assert_eq!((report.name.as_str(), report.format.as_str(), report.bytes), ("lot.csv", "csv", 9));
    let Shown { checks, unrecorded, head: known } = report.shown.clone();
    assert_eq!((checks.to_string(), unrecorded, known), ("2, 5".to_owned(), 1, Some(head(5))));
    let (run, entries) = kept(&send(&mut session, RecordsCommand::Reported(Box::new(report.clone()))));
    assert_eq!(entries[0].content, Told::Report(report));
    assert_eq!((entries[0].about.part.as_str(), entries[0].about.station.as_str()), ("", "Mill 3"));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(6)]) });
    assert_eq!(session.recording().failed(), 0);
    assert_eq!(session.recording().newest, 6);
}

#[test]
fn a_report_without_recorded_checks_is_not_told_to_the_journal() {
    let mut session = recording();
    measure(&mut session, "25 H7", "25.014");
    send(&mut session, Command::OpenDialog(Purpose::Export(1)));
    let content = written(&mut session, "lot.csv");
    assert!(!content.is_of_journal());
    assert_eq!(reported(&content, "/reports/lot.csv"), None);
}

#[test]
fn a_report_that_cannot_be_recorded_is_told_once_and_no_check_fails() {
    let mut session = recording();
    recorded(&mut session, "25.012", 2);
    send(&mut session, Command::OpenDialog(Purpose::Export(2)));
    let report = reported(&written(&mut session, "lot.json"), "/reports/lot.json").unwrap();
    let (run, _) = kept(&send(&mut session, RecordsCommand::Reported(Box::new(report.clone()))));
    let why = Message::new("records-page-no-thread");
    send(&mut session, RecordsCommand::Kept { run, result: Err(why) });
    let said = told(&session);
    assert!(said.contains("lot.json is written, but the journal does not know it: the system cannot start"), "{said}");
    assert_eq!((session.recording().failed(), session.recording().unwritten()), (0, 0));
    assert_eq!(send(&mut session, RecordsCommand::TryAgain), [], "the file is written again where it is to be known");
    // More ranges than an entry has.
    let checks = EntryRanges::of((1..=1_001).map(|number| 2 * number));
    let shown = Shown { checks, head: Some(head(2_002)), ..report.shown.clone() };
    let many = Reported { name: "many.json".to_owned(), shown, ..report };
    assert_eq!(send(&mut session, RecordsCommand::Reported(Box::new(many))), []);
    let all = session.notices().iter().any(|notice| format!("{notice:?}").contains("many.json"));
    assert!(all, "{:?}", session.notices());
}

#[test]
fn a_report_of_chosen_records_knows_entries_that_this_window_has_not_seen() {
    let mut session = opened(vec![report_row(9, &[7, 8]), check_row(8, 4, None), check_row(7, 5, None)]);
    send(&mut session, RecordsCommand::ChooseAll);
    assert_eq!(session.records().left_out(), LeftOut { reports: 1, ..LeftOut::default() });
    assert_eq!(session.records().reported(), 2);
    send(&mut session, RecordsCommand::Report(0));
    let report = reported(&written(&mut session, "two.html"), "two.html").unwrap();
    assert_eq!(report.shown.checks.to_string(), "7 to 8");
    assert_eq!(report.shown.head, Some(head(8)), "other programs have written it");
}

#[test]
fn an_open_record_asks_for_its_reports_and_shows_those_that_come() {
    let mut session = opened(vec![check_row(8, 4, None), report_row(9, &[8])]);
    let effects = send(&mut session, RecordsCommand::Open(8));
    assert!(effects.contains(&Effect::ReadReports(8)), "{effects:?}");
    let rows = vec![Arc::new(report_row(9, &[8]))];
    send(&mut session, RecordsCommand::ReportsRead { number: 7, result: Ok(rows.clone()) });
    assert_eq!(session.records().open.as_ref().unwrap().reports, Ok(Vec::new()), "another record's");
    send(&mut session, RecordsCommand::ReportsRead { number: 8, result: Ok(rows.clone()) });
    assert_eq!(session.records().open.as_ref().unwrap().reports, Ok(rows));
}

#[test]
fn a_report_is_neither_corrected_nor_measured_again() {
    let session = opened(vec![report_row(9, &[7, 8])]);
    assert!(!session.records().can_correct() && !session.records().can_measure_again());
    assert!(!session.can(RecordsAction::CorrectRecord));
}

#[test]
fn what_is_void_is_in_no_report() {
    let mut session = recording();
    recorded(&mut session, "25.012", 2);
    recorded(&mut session, "25.013", 3);
    let (run, entries) = kept(&send(&mut session, CheckCommand::Undo));
    assert!(matches!(&entries[0].content, Told::Withdrawal(Correction { target, .. }) if target.number == 3));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(4)]) });
    send(&mut session, Command::OpenPage(Page::Check));
    send(&mut session, Command::OpenDialog(Purpose::Export(2)));
    let report = reported(&written(&mut session, "lot.json"), "lot.json").unwrap();
    assert_eq!((report.shown.checks.to_string(), report.shown.head), ("2".to_owned(), Some(head(4))));
}

/// What a report notes.
fn notes(content: &Content) -> Vec<String> {
    let Content::Report { report, .. } = content else { panic!("{content:?}") };
    report.notes.iter().map(ToString::to_string).collect()
}

#[test]
fn a_report_of_records_says_what_was_corrected_or_withdrawn() {
    let mut corrected = check_row(9, 4, None);
    let Ok(entry) = &mut corrected.entry else { panic!("{corrected:?}") };
    let Told::Check(check) = &mut entry.content else { panic!() };
    check.corrects = Some(Correction { target: head(7), reason: "typing error".to_owned(), by: String::new() });
    let mut session = opened(vec![corrected, check_row(8, 4, None), check_row(7, 5, Some(9))]);
    send(&mut session, RecordsCommand::ChooseAll);
    send(&mut session, RecordsCommand::Report(0));
    let notes = notes(&written(&mut session, "three.html"));
    for said in ["1 corrected or withdrawn record is left out", "1 value stands in place of a corrected record"] {
        assert!(notes.iter().any(|note| note == said), "{said}: {notes:?}");
    }
}

#[test]
fn pages_that_are_stopped_say_so_and_those_of_another_choice_are_drawn_anew() {
    let mut session = recording();
    recorded(&mut session, "25.012", 2);
    let drawn = |effects: &[Effect]| {
        effects.iter().find_map(|effect| match effect {
            Effect::DrawReport { run, content } => Some((*run, content.clone())),
            _ => None,
        })
    };
    let (run, content) = drawn(&send(&mut session, Command::OpenPage(Page::Reports))).unwrap();
    let Content::Report { report, words, .. } = *content else { panic!() };
    assert_eq!(session.reports().at_work().map(Drawing::checks), Some(0));
    send(&mut session, ReportsCommand::Stop);
    let why = Pages::of(&report, &words).unwrap_err();
    assert!(why.to_string().starts_with("Stopped: the pages are not laid out"), "{why}");
    let stopped = || Err(Message::new("reports-page-nothing"));
    assert_eq!(drawn(&send(&mut session, ReportsCommand::Drawn { run, result: stopped() })).map(|(run, _)| run), None);
    let said = session.reports().pages().unwrap().unwrap_err().to_string();
    assert!(said.starts_with("Stopped"), "{said}");
    // Another choice: what is on its way is stopped, and nobody hears of it.
    let (run, _) = drawn(&send(&mut session, ReportsCommand::Template("report-template-list".to_owned()))).unwrap();
    assert!(drawn(&send(&mut session, ReportsCommand::Template("report-template-label".to_owned()))).is_none());
    let (next, content) = drawn(&send(&mut session, ReportsCommand::Drawn { run, result: stopped() })).unwrap();
    let Content::Report { report, words, .. } = *content else { panic!() };
    let pages = Pages::of(&report, &words).unwrap();
    send(&mut session, ReportsCommand::Drawn { run: next, result: Ok(Arc::new(pages)) });
    assert_eq!(session.reports().pages().unwrap().unwrap().count(), 1);
    assert!(session.reports().at_work().is_none());
}

#[test]
fn a_report_of_the_list_says_which_rows_of_a_file_are_no_checks() {
    let mut session = recording();
    let table = b"id,callout,measured\nA,25 H7,25.012\nB,25 H7,NG\nC,,25\nD,25 H7,25.03\n";
    let imported = fitcheck::exchange::import(
        "lot.csv",
        table,
        session.sources(),
        jiff::civil::DateTime::constant(2026, 11, 29, 7, 0, 0, 0),
    );
    send(&mut session, CheckCommand::Imported { name: "lot.csv".to_owned(), result: Ok(Box::new(imported)) });
    send(&mut session, Command::OpenPage(Page::Reports));
    assert_eq!(session.report_of(), Some(ReportOf::List), "the whole file, and not its worst row");
    send(&mut session, Command::OpenDialog(Purpose::Report(0)));
    let content = written(&mut session, "lot.html");
    let said = notes(&content);
    assert!(said.iter().any(|note| note.contains("lot.csv") && note.contains("NG")), "{said:?}");
    assert!(said.iter().any(|note| note == "lot.csv, line 4: not judged: no callout given"), "{said:?}");
    let Content::Report { report, .. } = &content else { panic!("{content:?}") };
    assert!(report.is_partial, "no certificate says that all conform");
    // What is undone is no gap any more.
    send(&mut session, Command::OpenPage(Page::Check));
    send(&mut session, CheckCommand::Undo);
    recorded(&mut session, "25.01", 9);
    send(&mut session, Command::OpenDialog(Purpose::Export(0)));
    assert!(notes(&written(&mut session, "one.html")).iter().all(|note| !note.contains("lot.csv")));
}
