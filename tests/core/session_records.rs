//! What the session records, and the records page: without a window, a file or a thread.

use fitcheck::session::{CheckAction, RecordsAction, WindowAction};
use std::sync::Arc;

use fitcheck::journal::Record;
use fitcheck::journal::chain::{ChainId, Hash, Head};
use fitcheck::journal::entry::{About, Check, Checked, Content, Correction, Entry, FileRole, Moment};
use fitcheck::length::Length;
use fitcheck::message::Message;
use fitcheck::probing::{Measurement, Origin};
use fitcheck::session::records::{FoundNumbers, Numbers, PAGE, Shorthand, Walk};
use fitcheck::session::{
    CheckCommand, CheckField, Command, CyclesCommand, Effect, Field, ListCommand, MeasureBy, OpenJournal, Page,
    ProgramCommand, RESTORED, RecordRow, Recorded, RecordsCommand, RecordsField, Saved, Session, Step,
};
use fitcheck::tolerance::{Feature, Sources};
use fitcheck::words::Language;
use jiff::civil::{DateTime, date};
use jiff::tz::{TimeZone, offset};

fn now() -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0)
}

pub(crate) fn send(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), now())
}

pub(crate) fn typed(session: &mut Session, field: impl Into<Field>, text: &str) -> Vec<Effect> {
    let command = field.into().typed(text.to_owned());
    session.apply(command, now())
}

fn begin(session: &mut Session) -> Vec<Effect> {
    let (usual, zone) = (Some("/data/journal.sqlite".into()), TimeZone::fixed(offset(1)));
    send(session, RecordsCommand::Begin { usual, station: "Mill 3".to_owned(), zone })
}

pub(crate) fn head(number: u64) -> Head {
    Head { number, hash: Hash([u8::try_from(number % 251).unwrap(); 32]) }
}

fn journal(number: u64) -> OpenJournal {
    OpenJournal { chain: ChainId([1; 16]), head: head(number), remarks: Vec::new() }
}

/// A session whose journal is open.
pub(crate) fn recording() -> Session {
    let mut session = Session::new(Language::En);
    begin(&mut session);
    send(&mut session, RecordsCommand::Opened(Ok((Box::new(journal(1)), Vec::new()))));
    session
}

pub(crate) fn measure(session: &mut Session, callout: &str, measured: &str) -> Vec<Effect> {
    typed(session, CheckField::Callout, callout);
    typed(session, CheckField::Measured, measured);
    send(session, CheckCommand::Measure)
}

/// What an effect wants to be kept.
#[track_caller]
pub(crate) fn kept(effects: &[Effect]) -> (u64, Vec<Entry>) {
    let [Effect::Keep { run, entries }] = effects else { panic!("{effects:?}") };
    (*run, entries.clone())
}

fn size(entry: &Entry) -> &Record {
    match &entry.check().unwrap().what {
        Checked::Size(record) => record,
        Checked::Cycle(cycle) => panic!("{cycle:?}"),
    }
}

fn record(part: &str, um: i64) -> Record {
    let callout: fitcheck::tolerance::Callout = "25 H7".parse().unwrap();
    let limits = Sources::default().limits(&callout, None).unwrap();
    let measured = Length::from_nanometres(25_000_000 + um * 1_000).unwrap();
    Record::judged(
        now(),
        part.to_owned(),
        Some(callout),
        limits,
        Measurement::of_diameter(measured, Origin::Typed),
        None,
    )
}

fn about(part: &str) -> About {
    let time = Moment { utc_ms: 1_795_254_127_000, offset_min: 60, zone: String::new() };
    let [station, who] = ["Mill 3", "Anna"].map(str::to_owned);
    About {
        station,
        time,
        who,
        part: part.to_owned(),
        serial: String::new(),
        feature: String::new(),
        remark: String::new(),
    }
}

pub(crate) fn row(number: u64, content: Content, corrected_by: Option<u64>) -> RecordRow {
    let entry = Ok(Entry { about: about(&format!("P{number}")), content });
    RecordRow { head: head(number), entry, corrected_by, went_back: false }
}

pub(crate) fn check_row(number: u64, um: i64, corrected_by: Option<u64>) -> RecordRow {
    let what = Checked::Size(Arc::new(record(&format!("P{number}"), um)));
    row(number, Content::Check(Box::new(Check { what, files: Vec::new(), corrects: None })), corrected_by)
}

#[test]
fn the_window_opens_the_usual_journal_or_the_one_of_the_state_file_or_none() {
    let opens = |saved: &str| {
        let (mut session, _) = Session::restore(Saved::read(saved.as_bytes()).unwrap());
        let file = begin(&mut session).iter().find_map(|effect| match effect {
            Effect::OpenJournal { file, station, newest } if station == "Mill 3" && *newest == RESTORED => {
                Some(file.display().to_string())
            }
            _ => None,
        });
        (file, session.recording().is_on())
    };
    assert_eq!(opens("version = 1"), (Some("/data/journal.sqlite".to_owned()), true));
    assert_eq!(opens("version = 1\n[records]\nfile = \"/other.sqlite\""), (Some("/other.sqlite".to_owned()), true));
    assert_eq!(opens("version = 1\n[records]\noff = true"), (None, false));
    let mut session = Session::new(Language::En);
    let zone = TimeZone::UTC;
    assert_eq!(send(&mut session, RecordsCommand::Begin { usual: None, station: String::new(), zone }), []);
    assert_eq!(measure(&mut session, "25 H7", "25.012"), []);
    assert_eq!(session.check_recorded(), None);
}

#[test]
fn a_check_is_recorded_with_who_part_serial_and_remark_and_counts_once_it_is_on_disk() {
    let mut session = recording();
    send(&mut session, RecordsCommand::UseName(" Anna ".to_owned()));
    for (field, text) in [(CheckField::Part, "Flange"), (CheckField::Serial, "S-1"), (CheckField::Remark, "first")] {
        typed(&mut session, field, text);
    }
    let (run, entries) = kept(&measure(&mut session, "25 H7", "24.998"));
    let told = &entries[0].about;
    let texts = [&told.station, &told.who, &told.part, &told.serial, &told.feature, &told.remark];
    assert_eq!(texts, ["Mill 3", "Anna", "Flange", "S-1", "", "first"]);
    assert_eq!(told.time.utc_ms, 0, "the clock is outside");
    assert_eq!(size(&entries[0]).verdict.status().to_string(), "REWORK");
    assert_eq!(session.check_recorded(), Some(Recorded::Waiting));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(7)]) });
    assert_eq!(session.check_recorded(), Some(Recorded::Kept(7)));
    assert!(session.notices().is_empty());
    // The name goes with what is saved, the newest first.
    send(&mut session, RecordsCommand::UseName("Bert".to_owned()));
    let saved = session.saved().records;
    assert_eq!((saved.who.as_str(), saved.names), ("Bert", vec!["Bert".to_owned(), "Anna".to_owned()]));
}

#[test]
fn simulated_checks_are_recorded_as_simulated() {
    let mut session = recording();
    typed(&mut session, CheckField::Callout, "25 H7");
    send(&mut session, CheckCommand::MeasureBy(MeasureBy::Simulating));
    let (_, entries) = kept(&send(&mut session, CheckCommand::Measure));
    assert!(entries[0].check().unwrap().is_simulated());
}

#[test]
fn what_fails_stays_and_is_written_again_in_its_order() {
    let mut session = recording();
    let (first, entries) = kept(&measure(&mut session, "25 H7", "25.012"));
    let why = Message::new("records-page-no-thread");
    send(&mut session, RecordsCommand::Kept { run: first, result: Err(why.clone()) });
    assert_eq!(session.check_recorded(), Some(Recorded::Failed(&why)));
    let (second, _) = kept(&measure(&mut session, "25 H7", "25.013"));
    send(&mut session, RecordsCommand::Kept { run: second, result: Err(why.clone()) });
    assert_eq!(session.notices().len(), 1, "one notice for both");
    assert!(session.would_lose() && session.recording().failed() == 2);
    assert!(!send(&mut session, Command::AskToLeave).contains(&Effect::Leave));
    send(&mut session, Command::Leave(false));
    let again = send(&mut session, RecordsCommand::TryAgain);
    let runs = again.iter().filter_map(|effect| match effect {
        Effect::Keep { run, .. } => Some(*run),
        _ => None,
    });
    let runs: Vec<u64> = runs.collect();
    assert_eq!(runs, [first, second]);
    assert!(again.contains(&Effect::Keep { run: first, entries }));
    for (run, number) in [(first, 2), (second, 3)] {
        send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(number)]) });
    }
    assert_eq!(session.check_recorded(), Some(Recorded::Kept(3)));
    assert!(!session.would_lose() && !session.can(WindowAction::RecordAgain) && session.notices().is_empty());
}

#[test]
fn a_journal_that_cannot_be_opened_is_told_and_opened_again() {
    let mut session = Session::new(Language::En);
    begin(&mut session);
    let (run, _) = kept(&measure(&mut session, "25 H7", "25.012"));
    let why = Message::new("records-page-no-thread");
    send(&mut session, RecordsCommand::Opened(Err(why.clone())));
    send(&mut session, RecordsCommand::Kept { run, result: Err(why) });
    let again = send(&mut session, RecordsCommand::TryAgain);
    assert!(matches!(again.as_slice(), [Effect::OpenJournal { .. }, Effect::Keep { .. }]), "{again:?}");
}

#[test]
fn the_newest_checks_of_the_journal_are_the_history_without_those_that_stand_no_longer() {
    let mut session = Session::new(Language::En);
    begin(&mut session);
    // A check that was made before the journal answered is the newest.
    let (run, _) = kept(&measure(&mut session, "25 H7", "25.012"));
    let back = Correction { target: head(3), reason: "test".to_owned(), by: "Bert".to_owned() };
    let rows = vec![
        check_row(2, 4, None),
        check_row(3, 5, Some(4)),
        row(4, Content::Withdrawal(back), None),
        check_row(5, -3, None),
    ];
    send(&mut session, RecordsCommand::Opened(Ok((Box::new(journal(5)), rows))));
    let parts: Vec<_> = session.history().iter().map(|record| record.id.clone()).collect();
    assert_eq!(parts, ["P2", "P5", ""]);
    assert!(session.notices().is_empty());
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(6)]) });
    for (step, number) in [(Step::Bottom, 2), (Step::Up, 5), (Step::Up, 6)] {
        send(&mut session, ListCommand::Move(step));
        let cursor = session.history().cursor.unwrap();
        send(&mut session, CheckCommand::Show(cursor));
        assert_eq!(session.check_recorded(), Some(Recorded::Kept(number)));
    }
    // Undo takes back what was done here, and nothing else.
    send(&mut session, CheckCommand::Undo);
    assert_eq!(session.history().len(), 2);
    assert!(!session.can(WindowAction::Undo));
}

#[test]
fn cycles_and_programs_record_each_verdict_once() {
    let mut session = recording();
    let block = "TCH PROBE 421 ~\nQ273=0~\nQ274=0~\nQ262=25~\nQ275=25.02~\nQ276=25";
    for command in [CyclesCommand::TypeBlock(block.into()), CyclesCommand::TakeBlock] {
        send(&mut session, command);
    }
    let (_, entries) = kept(&send(&mut session, CyclesCommand::Run));
    let Checked::Cycle(cycle) = &entries[0].check().unwrap().what else { panic!("a cycle") };
    assert_eq!((cycle.cycle, cycle.origin.is_simulated()), (421, true));
    assert_eq!(cycle.limits, Some(["25", "25.02"].map(|mm| mm.parse().unwrap())));
    assert!(cycle.parameters.contains(&("Q262".to_owned(), "25".to_owned())), "{:?}", cycle.parameters);
    send(&mut session, Command::OpenPage(Page::Program));
    let mut sent = Vec::new();
    sent.extend(send(&mut session, ProgramCommand::Run));
    while session.program().is_running() {
        sent.extend(send(&mut session, ProgramCommand::Tick));
    }
    sent.extend(send(&mut session, ProgramCommand::Tick));
    let (_, entries) = kept(&sent);
    let check = entries[0].check().unwrap();
    assert_eq!(entries.len(), 1);
    assert_eq!(check.files[0].role, FileRole::Program);
    let Checked::Cycle(cycle) = &check.what else { panic!("a cycle") };
    assert!(cycle.block.as_ref().is_some_and(|(_, line)| 1 < *line), "{:?}", cycle.block);
}

#[test]
fn a_question_is_read_at_every_change_and_an_older_answer_is_dropped() {
    let mut session = recording();
    let asked = send(&mut session, Command::OpenPage(Page::Records));
    let [Effect::AskRecords { run, rests: false, .. }] = asked.as_slice() else { panic!("{asked:?}") };
    let first = *run;
    let asked = typed(&mut session, RecordsField::Question, "part:P7");
    let [Effect::AskRecords { run, question, rests: true }] = asked.as_slice() else { panic!("{asked:?}") };
    assert_eq!(question.part.as_deref(), Some("P7"));
    let found = |numbers| Ok(FoundNumbers { numbers, is_end: true });
    send(&mut session, RecordsCommand::Found { run: first, result: found(Numbers::All { newest: 9, oldest: 2 }) });
    assert_eq!(session.records().listing.count(), 0, "an answer to another question");
    send(&mut session, RecordsCommand::Found { run: *run, result: found(Numbers::These(vec![7])) });
    assert_eq!(session.records().listing.count(), 1);
    // What is wrong is said with its place, and what was found stays.
    assert_eq!(typed(&mut session, RecordsField::Question, "part:P7 verdict:bent"), []);
    assert!(session.error(RecordsField::Question).is_some());
    assert_eq!(session.culprit(RecordsField::Question).map(|span| span.start), Some(16));
    assert_eq!(session.records().listing.count(), 1);
}

#[test]
fn buttons_write_their_word_into_the_question_and_take_it_out() {
    let mut session = recording();
    send(&mut session, Command::OpenPage(Page::Records));
    typed(&mut session, RecordsField::Question, "part:\"today  works\"");
    assert!(!session.records().has(Shorthand::Today), "within quotation marks it is another word");
    let asked = send(&mut session, RecordsCommand::Toggle(Shorthand::Today));
    assert_eq!(session.text(RecordsField::Question), "part:\"today  works\" today");
    let [Effect::AskRecords { question, .. }] = asked.as_slice() else { panic!("{asked:?}") };
    // Midnight in a zone an hour ahead of UTC.
    assert_eq!(question.from_ms, Some(1_795_215_600_000));
    for shorthand in [Shorthand::NotGood, Shorthand::Today, Shorthand::NotGood] {
        let asked = send(&mut session, RecordsCommand::Toggle(shorthand));
        assert!(matches!(asked.as_slice(), [Effect::AskRecords { .. }]), "{asked:?}");
    }
    assert_eq!(session.text(RecordsField::Question), "part:\"today  works\"");
}

#[test]
fn not_good_asks_for_nothing_that_is_void() {
    let mut session = recording();
    send(&mut session, Command::OpenPage(Page::Records));
    let asked = send(&mut session, RecordsCommand::Toggle(Shorthand::NotGood));
    assert_eq!(session.text(RecordsField::Question), "verdict:rework,re-measure,scrap standing");
    let [Effect::AskRecords { question, .. }] = asked.as_slice() else { panic!("{asked:?}") };
    assert!(question.standing && session.records().has(Shorthand::NotGood));
    send(&mut session, RecordsCommand::Toggle(Shorthand::NotGood));
    assert_eq!(session.text(RecordsField::Question), "");
}

#[test]
fn a_verdict_is_filtered_by_as_the_window_calls_it() {
    let mut session = recording();
    send(&mut session, Command::SetLanguage(Language::Nl));
    send(&mut session, Command::OpenPage(Page::Records));
    send(&mut session, RecordsCommand::FilterBy("verdict"));
    typed(&mut session, RecordsField::Filter, "goed");
    send(&mut session, RecordsCommand::AddFilter);
    assert_eq!(session.text(RecordsField::Question), "verdict:good standing");
    send(&mut session, RecordsCommand::FilterBy("verdict"));
    typed(&mut session, RecordsField::Filter, "afgekeurd");
    let filtered = send(&mut session, RecordsCommand::AddFilter);
    assert_eq!(session.text(RecordsField::Question), "standing verdict:scrap");
    let asked = typed(&mut session, RecordsField::Question, "afgekeurd");
    let question = |effects: &[Effect]| match effects {
        [Effect::AskRecords { question, .. }] => question.clone(),
        effects => panic!("{effects:?}"),
    };
    assert_eq!(question(&filtered), question(&asked), "the word asks for what the filter asks for");
    let question = question(&asked);
    assert_eq!(question.verdicts, [fitcheck::verdict::Status::Scrap]);
    assert_eq!(session.records().filters[0].key, "verdict");
}

/// A page over so many records, all of which are listed.
fn listed(count: u64) -> Session {
    let mut session = recording();
    let asked = send(&mut session, Command::OpenPage(Page::Records));
    let [Effect::AskRecords { run, .. }] = asked.as_slice() else { panic!("{asked:?}") };
    let found = FoundNumbers { numbers: Numbers::All { newest: count + 1, oldest: 2 }, is_end: true };
    send(&mut session, RecordsCommand::Found { run: *run, result: Ok(found) });
    session
}

fn read(session: &mut Session, effects: Vec<Effect>) -> usize {
    let mut pages = 0;
    for effect in effects {
        if let Effect::ReadRecords(numbers) = effect {
            let rows = numbers.iter().map(|number| Arc::new(check_row(*number, 4, None))).collect();
            send(session, RecordsCommand::Read { numbers, result: Ok(rows) });
            pages += 1;
        }
    }
    pages
}

#[test]
fn of_a_million_records_pages_in_sight_and_the_next_one_are_read_and_few_are_kept() {
    let mut session = listed(1_000_000);
    let last = 1_000_000 - 10;
    let effects = send(&mut session, RecordsCommand::See(0..20));
    assert_eq!(effects.len(), 2, "the page in sight and the next one");
    assert_eq!(read(&mut session, effects), 2);
    assert_eq!(send(&mut session, RecordsCommand::See(0..20)), []);
    for start in (0..last).step_by(20_011) {
        let effects = send(&mut session, RecordsCommand::See(start..start + 20));
        read(&mut session, effects);
        assert!(session.records().listing.row(1_000_001 - u64::try_from(start).unwrap()).is_some());
        assert!(session.records().listing.read() <= 20 * PAGE);
    }
    // The last row is the first check.
    let effects = send(&mut session, RecordsCommand::See(last..1_000_000));
    read(&mut session, effects);
    let listing = &session.records().listing;
    assert_eq!((listing.at(999_999), listing.at(1_000_000), listing.place_of(2)), (Some(2), None, Some(999_999)));
    assert!(listing.row(2).is_some());
    send(&mut session, RecordsCommand::Move(Step::Last));
    assert_eq!(session.records().cursor, Some(2));
}

#[test]
fn a_report_of_all_that_is_listed_reads_it_first_and_then_asks_for_a_file() {
    let mut session = listed(450);
    let words = fitcheck::words::Words::new(Language::En);
    let report = fitcheck::session::Action::from(RecordsAction::ReportRecords(0));
    assert_eq!(report.text(&session, &words), "Report of 450…");
    let effects = send(&mut session, RecordsCommand::Report(0));
    assert!(session.dialog().is_none(), "nothing is read yet");
    assert_eq!(read(&mut session, effects), 3);
    assert_eq!(session.dialog().map(|dialog| dialog.purpose), Some(fitcheck::session::Purpose::ReportRecords(0)));
    assert_eq!((session.records().reported(), session.records().chosen_count()), (450, 0));
    send(&mut session, Command::Close);
    // Ctrl+A chooses all of them.
    let effects = send(&mut session, RecordsCommand::ChooseAll);
    read(&mut session, effects);
    assert_eq!(session.records().chosen_count(), 450);
    send(&mut session, RecordsCommand::ChooseNone);
}

#[test]
fn a_report_of_too_many_records_is_refused_with_what_to_do() {
    let mut session = listed(10_001);
    assert_eq!(send(&mut session, RecordsCommand::Report(0)), []);
    assert!(told(&session).contains("10\u{a0}001 records are listed") && told(&session).contains("narrow the list"));
    assert!(session.dialog().is_none());
    assert_eq!(send(&mut session, RecordsCommand::ChooseAll), []);
    assert_eq!(session.records().chosen_count(), 0);
}

#[test]
fn rows_that_cannot_be_read_are_said_and_not_asked_for_again_and_again() {
    let mut session = listed(1_000);
    let effects = send(&mut session, RecordsCommand::See(0..20));
    let Some(Effect::ReadRecords(numbers)) = effects.into_iter().next() else { panic!("rows") };
    let why = Message::new("records-page-no-thread");
    send(&mut session, RecordsCommand::Read { numbers, result: Err(why.clone()) });
    assert_eq!(session.records().listing.unread.as_ref(), Some(&why));
    assert!(!session.records().listing.lacks(&(0..20)));
    assert_eq!(send(&mut session, RecordsCommand::See(0..20)), []);
}

/// A page with these records, the first of them open.
pub(crate) fn opened(rows: Vec<RecordRow>) -> Session {
    let mut session = recording();
    open(&mut session, rows);
    session
}

pub(crate) fn open(session: &mut Session, rows: Vec<RecordRow>) {
    let asked = send(session, Command::OpenPage(Page::Records));
    let [Effect::AskRecords { run, .. }] = asked.as_slice() else { panic!("{asked:?}") };
    let numbers: Vec<u64> = rows.iter().map(|row| row.head.number).collect();
    let found = FoundNumbers { numbers: Numbers::These(numbers.clone()), is_end: true };
    send(session, RecordsCommand::Found { run: *run, result: Ok(found) });
    let first = numbers[0];
    let rows = rows.into_iter().map(Arc::new).collect();
    send(session, RecordsCommand::Read { numbers, result: Ok(rows) });
    send(session, RecordsCommand::Open(first));
}

#[test]
fn a_correction_needs_a_reason_and_something_else_and_names_what_it_corrects() {
    let mut session = opened(vec![check_row(8, -3, None)]);
    send(&mut session, RecordsCommand::Correct(true));
    // What is typed next is the reason.
    let focus = |field: RecordsField| vec![Effect::Focus(field.into())];
    assert_eq!(send(&mut session, RecordsCommand::SendCorrection), focus(RecordsField::Reason));
    assert!(session.error(RecordsField::Reason).is_some());
    typed(&mut session, RecordsField::Reason, " typed wrongly ");
    let effects = send(&mut session, RecordsCommand::SendCorrection);
    assert_eq!(effects, focus(RecordsField::Reason), "nothing is different");
    typed(&mut session, RecordsField::Measured, "25.0O3");
    assert_eq!(send(&mut session, RecordsCommand::SendCorrection), focus(RecordsField::Measured));
    assert!(session.error(RecordsField::Measured).is_some());
    typed(&mut session, RecordsField::Measured, "25,003");
    typed(&mut session, RecordsField::Measurer, "Bert");
    let (run, entries) = kept(&send(&mut session, RecordsCommand::SendCorrection));
    let Some(Correction { target, reason, .. }) = entries[0].corrects() else { panic!("a correction") };
    assert_eq!((*target, reason.as_str()), (head(8), "typed wrongly"));
    let corrected = size(&entries[0]);
    assert_eq!((corrected.verdict.status().to_string().as_str(), corrected.time), ("GOOD", now()));
    assert_eq!(entries[0].about.who, "Bert");
    assert_eq!(send(&mut session, RecordsCommand::SendCorrection), [], "it is sent once");
    let effects = send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(9)]) });
    assert!(session.records().correcting.is_none());
    assert!(effects.contains(&Effect::ReadRecords(vec![9])), "the new one is opened: {effects:?}");
}

#[test]
fn corrections_are_undone_one_after_another_and_always_in_the_place_of_what_stands() {
    let mut session = recording();
    let (run, first) = kept(&measure(&mut session, "25 H7", "25.001"));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(2)]) });
    let mut entries = first;
    let stand = |session: &Session| -> Vec<String> {
        session.history().iter().map(|record| record.measured().to_string()).collect()
    };
    for (number, value) in [(2, "25.002"), (3, "25.003")] {
        let row = RecordRow { entry: Ok(entries[0].clone()), ..check_row(number, 0, None) };
        send(&mut session, RecordsCommand::CorrectNumber(number));
        send(&mut session, RecordsCommand::Read { numbers: vec![number], result: Ok(vec![Arc::new(row)]) });
        typed(&mut session, RecordsField::Measured, value);
        typed(&mut session, RecordsField::Reason, "digits swapped");
        let (run, sent) = kept(&send(&mut session, RecordsCommand::SendCorrection));
        send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(number + 1)]) });
        assert_eq!(stand(&session), [value]);
        entries = sent;
    }
    // The first undo stands in the place of record 4, and the second one in the place of the first.
    for (number, corrected, value) in [(5, 4, "25.002"), (6, 5, "25.001")] {
        let undo = WindowAction::Undo.command(&session).unwrap();
        let (run, sent) = kept(&send(&mut session, undo));
        let correction = sent[0].corrects().unwrap();
        assert_eq!((correction.target, correction.reason.as_str()), (head(corrected), "Correction undone"));
        send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(number)]) });
        assert_eq!(stand(&session), [value]);
    }
    // Then the check itself: what stands in its place now is withdrawn.
    let undo = WindowAction::Undo.command(&session).unwrap();
    let (_, sent) = kept(&send(&mut session, undo));
    assert_eq!(withdrawn(&sent), [(6, "undone", "")]);
    assert!(session.history().is_empty() && WindowAction::Undo.command(&session).is_none());
}

#[test]
fn a_correction_is_judged_by_what_its_record_was_judged_by_whatever_the_page_says_now() {
    let mut session = recording();
    for (field, text) in [(CheckField::Uncertainty, "1"), (CheckField::PartTemperature, "30")] {
        typed(&mut session, field, text);
    }
    send(&mut session, CheckCommand::UseRule(fitcheck::verdict::rules::RuleName::Iso14253Of2017));
    let (run, before) = kept(&measure(&mut session, "25 H7", "25.012"));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(8)]) });
    // The next part is measured in another way.
    send(&mut session, CheckCommand::UseRule(fitcheck::verdict::rules::RuleName::Simple));
    typed(&mut session, CheckField::PartTemperature, "");
    let row = RecordRow { entry: Ok(before[0].clone()), ..check_row(8, 0, None) };
    send(&mut session, RecordsCommand::CorrectNumber(8));
    send(&mut session, RecordsCommand::Read { numbers: vec![8], result: Ok(vec![Arc::new(row)]) });
    typed(&mut session, RecordsField::Measured, "25.020");
    typed(&mut session, RecordsField::Callout, "25 H8");
    typed(&mut session, RecordsField::Reason, "digits swapped");
    let (_, entries) = kept(&send(&mut session, RecordsCommand::SendCorrection));
    let (old, new) = (size(&before[0]), size(&entries[0]));
    assert_eq!(new.verdict.rule, old.verdict.rule);
    assert_eq!(new.correction.map(|correction| correction.part), old.correction.map(|correction| correction.part));
    assert_eq!(new.measured().to_string(), "25.02");
    // Steel expands by 11.5 parts in a million per kelvin: 25.020 mm are 2.877 µm less at 20 °C, and 25 H8 goes up to 25.033.
    assert!((new.measurement.diameter.to_mm_f64() - 25.017_123).abs() < 2e-6, "{}", new.measurement.diameter);
    assert_eq!(new.limits.maximum().to_string(), "25.033");
}

#[test]
fn a_withdrawal_and_what_is_corrected_already_cannot_be_corrected() {
    let back = Correction { target: head(3), reason: "test".to_owned(), by: "Bert".to_owned() };
    for row in [check_row(8, 4, Some(9)), row(9, Content::Withdrawal(back), None)] {
        let mut session = opened(vec![row]);
        assert!(!session.can(RecordsAction::CorrectRecord));
        send(&mut session, RecordsCommand::Correct(true));
        assert!(session.records().correcting.is_none());
    }
    let mut session = opened(vec![check_row(8, 4, None)]);
    send(&mut session, RecordsCommand::Correct(true));
    send(&mut session, RecordsCommand::Withdraw(true));
    typed(&mut session, RecordsField::Reason, "was a test");
    let (_, entries) = kept(&send(&mut session, RecordsCommand::SendCorrection));
    assert!(matches!(entries[0].content, Content::Withdrawal(_)));
}

#[test]
fn what_is_taken_back_leaves_the_history_of_checks_too_and_undo_does_not_bring_it_back() {
    let mut session = recording();
    for (number, measured) in [(7, "25.001"), (8, "25.004")] {
        let (run, _) = kept(&measure(&mut session, "25 H7", measured));
        send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(number)]) });
    }
    let history = |session: &Session| -> Vec<String> {
        session.history().iter().map(|record| record.measurement.diameter.to_string()).collect()
    };
    assert_eq!(history(&session).len(), 2);
    open(&mut session, vec![check_row(8, 4, None)]);
    send(&mut session, RecordsCommand::Correct(true));
    send(&mut session, RecordsCommand::Withdraw(true));
    typed(&mut session, RecordsField::Reason, "was a test");
    let (run, _) = kept(&send(&mut session, RecordsCommand::SendCorrection));
    assert_eq!(history(&session).len(), 2, "it stands until the journal has answered");
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(9)]) });
    assert_eq!(history(&session), ["25.001"]);
    if let Some(undo) = WindowAction::Undo.command(&session) {
        send(&mut session, undo);
    }
    assert!(!history(&session).contains(&"25.004".to_owned()));
}

#[test]
fn a_value_of_the_journal_comes_back_with_the_decimal_sign_of_the_window() {
    for (language, typed) in [(Language::En, "25.004"), (Language::Nl, "25,004")] {
        let mut session = Session::new(language);
        begin(&mut session);
        send(&mut session, RecordsCommand::Opened(Ok((Box::new(journal(8)), vec![check_row(8, 4, None)]))));
        let (id, _) = session.history().listed().page(0..1).remove(0);
        send(&mut session, CheckCommand::Show(id));
        assert_eq!(session.text(CheckField::Measured), typed);
    }
}

#[test]
fn measure_again_takes_callout_part_serial_and_rule() {
    let mut session = opened(vec![check_row(8, -3, None)]);
    let again = RecordsAction::MeasureAgain.command(&session).unwrap();
    send(&mut session, again);
    assert_eq!(session.page(), Page::Check);
    assert_eq!((session.text(CheckField::Callout), session.text(CheckField::Part)), ("25 H7", "P8"));
    assert!(session.check().shown.is_none());
    let (_, entries) = kept(&measure(&mut session, "25 H7", "25.003"));
    assert_eq!(entries[0].about.part, "P8");
}

#[test]
fn a_walk_that_was_cancelled_says_so_and_its_late_answer_is_dropped() {
    let mut session = recording();
    send(&mut session, Command::OpenPage(Page::Records));
    let effects = send(&mut session, RecordsCommand::Verify);
    let [Effect::VerifyRecords { run }] = effects.as_slice() else { panic!("{effects:?}") };
    send(&mut session, RecordsCommand::Verifying { run: *run, done: 10, of: 20 });
    assert_eq!(session.records().walk, Walk::Running { done: 10, of: 20 });
    assert_eq!(send(&mut session, RecordsCommand::CancelVerify), [Effect::StopVerify]);
    let result = Err(Message::new("store-interrupted"));
    send(&mut session, RecordsCommand::Verified { run: *run, result, at: now() });
    assert_eq!(session.records().walk, Walk::Cancelled);
}

#[test]
fn a_row_that_can_be_no_entry_holds_no_other_up_and_is_told() {
    let mut session = recording();
    let bytes = format!("id;callout;measured\nA;25 H7;25,012\n{};25 H7;24,998\nC;25 H7;25,001\n", "B".repeat(2_000));
    let imported = fitcheck::exchange::import("lot.csv", bytes.as_bytes(), &Sources::default(), now());
    let effects = send(&mut session, CheckCommand::Imported { name: "lot.csv".into(), result: Ok(Box::new(imported)) });
    let (run, entries) = kept(&effects);
    let parts: Vec<_> = entries.iter().map(|entry| entry.about.part.as_str()).collect();
    assert_eq!(parts, ["A", "C"]);
    assert!(session.notices().iter().any(|notice| notice.message.id == "records-page-refused"));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(2), head(3)]) });
    let mut recorded = Vec::new();
    for id in session.history().listed().page(0..3).into_iter().map(|(id, _)| id) {
        send(&mut session, CheckCommand::Show(id));
        recorded.push(match session.check_recorded() {
            Some(Recorded::Kept(number)) => number,
            other => {
                assert!(matches!(other, Some(Recorded::Failed(_))), "{other:?}");
                0
            }
        });
    }
    assert_eq!(recorded, [3, 0, 2]);
    // Nothing is to be tried again, and nothing more is lost with the window.
    assert!(!session.can(WindowAction::RecordAgain) && !session.would_lose());
}

#[test]
fn a_file_that_was_used_is_named_with_its_hash() {
    let mut session = recording();
    let bytes = b"id;callout;measured\nA;25 H7;25,012\nB;25 H7;24,998\n";
    let sha256 = Hash::of_file(bytes);
    typed(&mut session, CheckField::Serial, "S-1");
    send(&mut session, RecordsCommand::Measured { name: "lot.csv".to_owned(), sha256 });
    let imported = fitcheck::exchange::import("lot.csv", bytes, &Sources::default(), now());
    let effects =
        send(&mut session, CheckCommand::Imported { name: "lot.csv".to_owned(), result: Ok(Box::new(imported)) });
    let (_, entries) = kept(&effects);
    assert_eq!(entries.len(), 2);
    for (entry, part) in entries.iter().zip(["A", "B"]) {
        let file = &entry.check().unwrap().files[0];
        assert_eq!((file.role, &*file.name, file.sha256), (FileRole::Measurements, "lot.csv", sha256));
        // Each row is another part: no serial number is that of all of them.
        assert_eq!((entry.about.part.as_str(), entry.about.serial.as_str()), (part, ""));
    }
}

/// The password of an address that is typed goes outside with it, and is nowhere in the session afterwards.
#[test]
fn records_are_sent_to_the_server_that_is_named_and_its_password_is_not_kept() {
    let mut session = recording();
    send(&mut session, Command::OpenPage(Page::Records));
    assert_eq!(session.recording().server(), None);
    send(&mut session, RecordsCommand::AskForServer(true));
    let given = "postgres://mill3:secret@shop.example/checks";
    typed(&mut session, RecordsField::Server, given);
    assert_eq!(send(&mut session, RecordsCommand::TakeServer), [Effect::SendTo(Some(given.to_owned()))]);
    let wrong = Message::new("records-page-no-shop");
    send(&mut session, RecordsCommand::Server(Err(wrong.clone())));
    assert_eq!(session.error(RecordsField::Server), Some(&wrong));
    assert_eq!(session.recording().server(), None);
    let shown = "postgres://mill3@shop.example/checks";
    send(&mut session, RecordsCommand::Server(Ok(shown.to_owned())));
    assert_eq!(session.recording().server(), Some(shown));
    assert!(!session.recording().asks_for_server());
    assert_eq!(session.text(RecordsField::Server), "");
    let saved = session.saved();
    assert!(!format!("{saved:?}{session:?}").contains("secret"));

    // A record that is on disk wakes the sender.
    let (run, _) = kept(&measure(&mut session, "25 H7", "25.012"));
    let woken = send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(2)]) });
    assert_eq!(woken, [Effect::WakeSender]);
    let trouble = Some(Message::new("records-page-no-shop"));
    send(&mut session, RecordsCommand::Sent { unsent: Some(2), trouble: trouble.clone() });
    assert_eq!((session.recording().unsent(), session.recording().trouble()), (Some(2), trouble.as_ref()));
    assert_eq!(send(&mut session, RecordsCommand::SendAgain), [Effect::SendAgain]);

    // The next start sends to it again, once the journal is open.
    let (mut again, _) = Session::restore(saved);
    begin(&mut again);
    let opened = send(&mut again, RecordsCommand::Opened(Ok((Box::new(journal(2)), Vec::new()))));
    assert!(opened.contains(&Effect::SendTo(Some(shown.to_owned()))), "{opened:?}");

    assert_eq!(send(&mut session, RecordsCommand::LeaveServer), [Effect::SendTo(None)]);
    send(&mut session, RecordsCommand::Sent { unsent: Some(1), trouble: None });
    assert_eq!((session.recording().server(), session.recording().unsent()), (None, None));
    assert_eq!(session.saved().records.server, None);
}

/// What the newest notice says.
pub(crate) fn told(session: &Session) -> String {
    let words = fitcheck::words::Words::new(session.language());
    session.notices().last().map_or_else(String::new, |notice| words.say(&notice.message))
}

/// The records that entries withdraw, with the reason and who.
fn withdrawn(entries: &[Entry]) -> Vec<(u64, &str, &str)> {
    let of = |entry: &Entry| assert!(matches!(entry.content, Content::Withdrawal(_)), "{entry:?}");
    entries.iter().for_each(of);
    let corrects = entries.iter().filter_map(Entry::corrects);
    corrects.map(|Correction { target, reason, by }| (target.number, reason.as_str(), by.as_str())).collect()
}

#[test]
fn undo_withdraws_the_record_of_the_check_that_it_takes_back() {
    let mut session = recording();
    send(&mut session, RecordsCommand::UseName("Anna".to_owned()));
    typed(&mut session, CheckField::Part, "Flange");
    let (run, _) = kept(&measure(&mut session, "25 H7", "24.998"));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(88)]) });
    let (run, entries) = kept(&send(&mut session, CheckCommand::Undo));
    assert_eq!(withdrawn(&entries), [(88, "undone", "Anna")]);
    assert_eq!((entries[0].about.part.as_str(), entries[0].corrects().unwrap().target), ("Flange", head(88)));
    assert_eq!(session.history().len(), 0);
    assert_eq!(told(&session), "", "the journal has not answered");
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(89)]) });
    assert_eq!(told(&session), "1 check taken back; record 88 is withdrawn");
    assert!(!session.would_lose());
}

#[test]
fn a_record_that_undo_takes_back_while_it_is_written_is_withdrawn_once_it_has_its_number() {
    let mut session = recording();
    let (run, _) = kept(&measure(&mut session, "25 H7", "24.998"));
    assert_eq!(send(&mut session, CheckCommand::Undo), []);
    let (run, entries) = kept(&send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(7)]) }));
    assert_eq!(withdrawn(&entries), [(7, "undone", "")]);
    // Not withdrawn: it is told, and tried again.
    let why = Message::new("records-page-no-thread");
    send(&mut session, RecordsCommand::Kept { run, result: Err(why) });
    assert!(told(&session).starts_with("Record 7 still counts and could not be withdrawn: "), "{}", told(&session));
    let again = kept(&send(&mut session, RecordsCommand::TryAgain));
    assert_eq!(again, (run, entries));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(8)]) });
    assert_eq!(told(&session), "1 check taken back; record 7 is withdrawn");
}

#[test]
fn a_check_that_could_not_be_written_is_not_written_after_undo() {
    let mut session = recording();
    let (run, _) = kept(&measure(&mut session, "25 H7", "24.998"));
    send(&mut session, RecordsCommand::Kept { run, result: Err(Message::new("records-page-no-thread")) });
    assert_eq!(send(&mut session, CheckCommand::Undo), []);
    assert_eq!(told(&session), "1 check taken back; it was not recorded yet and will not be");
    assert_eq!(send(&mut session, RecordsCommand::TryAgain), []);
    assert!(!session.would_lose());
}

#[test]
fn undo_of_a_long_import_withdraws_its_records_as_one_batch() {
    let mut session = recording();
    let rows: Vec<_> = (0..600).map(|at| format!("B{at},25 H7,25.01")).collect();
    let rows = format!("id,callout,measured\n{}\n", rows.join("\n"));
    let result = Ok(Box::new(fitcheck::exchange::import("lot.csv", rows.as_bytes(), session.sources(), now())));
    let (run, entries) = kept(&send(&mut session, CheckCommand::Imported { name: "lot.csv".to_owned(), result }));
    let heads = |from: u64| (from..from + 600).map(head).collect();
    assert_eq!(entries.len(), 600);
    send(&mut session, RecordsCommand::Kept { run, result: Ok(heads(2)) });
    let (run, entries) = kept(&send(&mut session, CheckCommand::Undo));
    assert_eq!(
        withdrawn(&entries).iter().map(|(number, ..)| *number).collect::<Vec<_>>(),
        (2..602).collect::<Vec<_>>()
    );
    send(&mut session, RecordsCommand::Kept { run, result: Ok(heads(602)) });
    assert_eq!(told(&session), "600 checks taken back; records 2 … 601 are withdrawn");
}

#[test]
fn hole_or_shaft_is_said_of_one_value_or_of_a_whole_file_and_the_journal_has_corrections() {
    let table = b"id,nominal,lower_limit,upper_limit,measured\nA,8,7.9,8.1,8.0\nB,8,7.9,8.1,8.2\nC,8,7.9,8.1,7.8\n";
    let mut session = recording();
    let imported = fitcheck::exchange::import("lengths.csv", table, session.sources(), now());
    let read = CheckCommand::Imported { name: "lengths.csv".to_owned(), result: Ok(Box::new(imported)) };
    let (run, entries) = kept(&send(&mut session, read));
    assert_eq!(entries.len(), 3);
    send(&mut session, RecordsCommand::Kept { run, result: Ok((2..5).map(head).collect()) });
    let counts = |session: &Session| session.check().lot.as_ref().unwrap().counts().map(|(_, n)| n).collect::<Vec<_>>();
    let statuses =
        |session: &Session| session.history().iter().map(|record| record.verdict.status().word()).collect::<Vec<_>>();
    assert_eq!(statuses(&session), ["GOOD", "OUT OF LIMITS", "OUT OF LIMITS"]);
    assert!(session.check().is_open());
    // One choice is for the value on screen, the worst of the file.
    let effects = send(&mut session, CheckCommand::ChooseFeature(Some(Feature::Hole)));
    assert_eq!(statuses(&session), ["GOOD", "SCRAP", "OUT OF LIMITS"]);
    assert_eq!(counts(&session), [1, 0, 0, 1, 1]);
    let (run, corrections) = kept(&effects);
    assert_eq!(corrections.iter().filter_map(Entry::corrects).map(|old| old.target.number).collect::<Vec<_>>(), [3]);
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(5)]) });
    // It can be said otherwise, and undone.
    let (run, _) = kept(&send(&mut session, CheckCommand::ChooseFeature(Some(Feature::Shaft))));
    assert_eq!(statuses(&session), ["GOOD", "REWORK", "OUT OF LIMITS"]);
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(6)]) });
    for number in [7, 8] {
        let undo = WindowAction::Undo.command(&session).unwrap();
        let (run, _) = kept(&send(&mut session, undo));
        send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(number)]) });
    }
    assert_eq!(statuses(&session), ["GOOD", "OUT OF LIMITS", "OUT OF LIMITS"]);
    // The other one is for all.
    assert!(session.can(CheckAction::JudgeAllAs(Feature::Shaft)));
    let effects = send(&mut session, CheckCommand::JudgeAllAs(Feature::Shaft));
    assert_eq!(statuses(&session), ["GOOD", "REWORK", "SCRAP"]);
    assert_eq!(counts(&session), [1, 1, 0, 0, 1]);
    assert!(!session.can(CheckAction::JudgeAllAs(Feature::Shaft)));
    let names: Vec<_> = session.history().iter().map(|record| record.limits.feature).collect();
    assert_eq!(names, [None, Some(Feature::Shaft), Some(Feature::Shaft)], "what was good stays as it was");
    let (_, corrections) = kept(&effects);
    let said = |entry: &Entry| {
        let corrects = entry.corrects().unwrap();
        (entry.about.part.clone(), corrects.target.number, corrects.reason.clone(), size(entry).verdict.status().word())
    };
    let reason = "said after the verdict: shaft".to_owned();
    assert_eq!(
        corrections.iter().map(said).collect::<Vec<_>>(),
        [("B".to_owned(), 8, reason.clone(), "REWORK"), ("C".to_owned(), 4, reason, "SCRAP")]
    );
    assert!(!session.check().is_open());
    assert!(session.notices().iter().any(|notice| notice.message.to_string().starts_with("2 values outside")));
}

#[test]
fn a_flatness_is_never_a_hole() {
    let table = b"id,nominal,lower_limit,upper_limit,measured\nF,0,0,0.02,0.03\nB,8,7.9,8.1,8.2\n";
    let mut session = recording();
    let imported = fitcheck::exchange::import("lengths.csv", table, session.sources(), now());
    let read = CheckCommand::Imported { name: "lengths.csv".to_owned(), result: Ok(Box::new(imported)) };
    let (run, _) = kept(&send(&mut session, read));
    send(&mut session, RecordsCommand::Kept { run, result: Ok((2..4).map(head).collect()) });
    let features = |session: &Session| session.history().iter().map(|record| record.limits.feature).collect::<Vec<_>>();
    assert_eq!(features(&session), [None, None]);
    send(&mut session, CheckCommand::JudgeAllAs(Feature::Hole));
    assert_eq!(features(&session), [None, Some(Feature::Hole)]);
}
