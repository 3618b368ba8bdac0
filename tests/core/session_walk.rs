//! The walk through a part, without a window: values from everywhere, recorded, interrupted and brought back; the watched folder.

use fitcheck::session::{PartsAction, WalkField};
use std::path::PathBuf;

use fitcheck::control::mask::Mask;
use fitcheck::exchange::{Item, import_each};
use fitcheck::journal::Record;
use fitcheck::journal::chain::{ChainId, Hash, Head};
use fitcheck::journal::entry::{Checked, Entry};
use fitcheck::message::{Message, Say as _};
use fitcheck::part::{Column, Document};
use fitcheck::session::parts::{PlanCommand, WalkCommand, WatchNews, WatchedFile};
use fitcheck::session::{
    Action, CheckField, Command, Effect, Field, FilesCommand, OpenJournal, Page, PartsCommand, Purpose, RecordRow,
    RecordsCommand, Saved, Session, Step,
};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::Status;
use fitcheck::words::{Dialogue, Language, Words};
use jiff::ToSpan as _;
use jiff::civil::{DateTime, date};
use jiff::tz::{TimeZone, offset};

const PLAN: &str = r#"fitcheck_plan = 1
part = "Flange"

[[feature]]
number = "1"
name = "BORE"
callout = "12 F9"
x = 50
y = 65
z = -8

[[feature]]
number = "2"
name = "PIN"
callout = "20 g6"
x = 100
y = 65
z = -8

[[feature]]
number = "3"
name = "K1"
kind = "pocket"
callout = "40 H7"
callout2 = "25 H8"
x = 150
y = 65
z = -8

[[feature]]
number = "4"
name = "TOP"
kind = "face"
axis = "-Z"
callout = "10 h9"
x = 220
y = 30
z = 10
"#;

pub fn now() -> DateTime {
    date(2026, 11, 24).at(10, 42, 7, 0)
}

pub fn send(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    session.apply(command.into(), now())
}

pub fn typed(session: &mut Session, field: impl Into<Field>, text: &str) {
    let command = field.into().typed(text.to_owned());
    session.apply(command, now());
}

pub fn act(session: &mut Session, action: Action) -> Vec<Effect> {
    let command = action.command(session).unwrap_or_else(|| panic!("{action:?} is not possible"));
    session.apply(command, now())
}

pub fn said(message: &Message) -> String {
    Words::new(Language::En).say(message)
}

pub fn head(number: u64) -> Head {
    Head { number, hash: Hash([u8::try_from(number % 251).unwrap(); 32]) }
}

pub fn begin_records(session: &mut Session) {
    let (usual, zone) = (Some("/data/journal.sqlite".into()), TimeZone::fixed(offset(1)));
    send(session, RecordsCommand::Begin { usual, station: "Mill 3".to_owned(), zone });
}

pub fn open_journal(session: &mut Session, newest: u64) -> Vec<Effect> {
    let journal = OpenJournal { chain: ChainId([1; 16]), head: head(newest), remarks: Vec::new() };
    send(session, RecordsCommand::Opened(Ok((Box::new(journal), Vec::new()))))
}

pub fn read_plan(session: &mut Session, text: &str) -> Vec<Effect> {
    let document = Document::read(text.as_bytes()).unwrap();
    let read = PlanCommand::Read { path: PathBuf::from("/plans/flange.toml"), result: Ok(Box::new(document)) };
    send(session, PartsCommand::Plan(read))
}

/// A session that records, with the plan, and a part begun.
fn walking() -> Session {
    walking_by(PLAN)
}

/// The same by another plan.
pub fn walking_by(plan: &str) -> Session {
    let mut session = Session::new(Language::En);
    begin_records(&mut session);
    open_journal(&mut session, 7);
    send(&mut session, Command::OpenPage(Page::Parts));
    read_plan(&mut session, plan);
    assert_eq!(session.parts().document.findings().len(), 0);
    typed(&mut session, WalkField::Serial, "A-0099");
    let effects = act(&mut session, PartsAction::BeginPart.into());
    assert_eq!(effects, [Effect::Focus(WalkField::Value.into())]);
    session
}

/// All but that rules of control charts are looked at.
fn without_alarms(mut effects: Vec<Effect>) -> Vec<Effect> {
    effects.retain(|effect| !matches!(effect, Effect::FindAlarms(_)));
    effects
}

pub fn take(session: &mut Session, text: &str) -> Vec<Effect> {
    typed(session, WalkField::Value, text);
    act(session, PartsAction::TakeValue.into())
}

/// Does an action some milliseconds later.
pub fn act_after(session: &mut Session, action: Action, milliseconds: i64) -> Vec<Effect> {
    let command = action.command(session).unwrap_or_else(|| panic!("{action:?} is not possible"));
    session.apply(command, now().checked_add(milliseconds.milliseconds()).unwrap())
}

#[track_caller]
pub fn kept(effects: &[Effect]) -> (u64, Vec<Entry>) {
    let keep = effects.iter().find_map(|effect| match effect {
        Effect::Keep { run, entries } => Some((*run, entries.clone())),
        _ => None,
    });
    keep.unwrap_or_else(|| panic!("{effects:?}"))
}

pub fn size(entry: &Entry) -> &Record {
    match &entry.check().unwrap().what {
        Checked::Size(record) => record,
        Checked::Cycle(cycle) => panic!("{cycle:?}"),
    }
}

pub fn asked(session: &Session) -> Option<String> {
    session.parts().walking.asked().map(|size| size.name())
}

pub fn standing(session: &Session) -> String {
    said(&session.parts().walking.standing().message())
}

pub fn items(text: &str) -> Vec<Item> {
    let mut items = Vec::new();
    import_each("m.csv", text.as_bytes(), &Sources::default(), now(), &mut |item| items.push(item));
    items
}

/// The answer of a file that is read for the part of now.
pub fn imported(session: &Session, items: Vec<Item>) -> WalkCommand {
    WalkCommand::Imported { run: session.parts().walking.run, name: "m.csv".to_owned(), result: Ok(items) }
}

pub fn import(session: &mut Session, text: &str) -> Vec<Effect> {
    send(session, RecordsCommand::Measured { name: "m.csv".to_owned(), sha256: Hash([3; 32]) });
    let command = imported(session, items(text));
    send(session, command)
}

#[test]
fn a_typed_value_is_judged_recorded_and_the_next_size_is_asked_for() {
    let mut session = walking();
    assert_eq!(asked(&session).as_deref(), Some("BORE"));
    let (_, entries) = kept(&take(&mut session, "12,03"));
    let entry = &entries[0];
    assert_eq!(
        (entry.about.part.as_str(), entry.about.serial.as_str(), entry.about.feature.as_str()),
        ("Flange", "A-0099", "BORE")
    );
    assert_eq!(size(entry).verdict.status(), Status::Good);
    assert_eq!(asked(&session).as_deref(), Some("PIN"));
    assert_eq!(session.text(WalkField::Value), "");
    let walking = &session.parts().walking;
    let (at, value) = walking.shown().unwrap();
    assert_eq!((at, walking.name(at)), (0, "BORE"));
    assert_eq!(
        said(&value.remarks[0]),
        "The plan has no rule; judged by the rule on the check page: no guard band, limits belong to the zone"
    );
    assert_eq!(standing(&session), "1 measured, 4 missing, 0 skipped");
    assert_eq!(walking.status(), None, "a part is not good while something is missing");
    assert_eq!(session.history().len(), 1);
}

#[test]
fn a_gauge_types_its_line_and_what_was_taken_is_said() {
    let mut session = walking();
    take(&mut session, "\u{2}01A+0012.030\u{3}");
    let (_, value) = session.parts().walking.shown().unwrap();
    assert_eq!(value.record.measurement.diameter.to_string(), "12.03");
    let remarks: Vec<_> = value.remarks.iter().map(said).collect();
    assert!(remarks.contains(&"from channel 01".to_owned()), "{remarks:?}");
    take(&mut session, "20 12");
    assert!(said(session.error(WalkField::Value).unwrap()).contains("20 12"));
    assert_eq!(asked(&session).as_deref(), Some("PIN"), "nothing was taken");
}

#[test]
fn a_doubtful_value_is_asked_about_first() {
    let mut session = walking();
    assert_eq!(take(&mut session, "1.203"), []);
    assert!(session.parts().walking.question.is_some());
    assert_eq!(asked(&session).as_deref(), Some("BORE"));
    // Enter once more takes it.
    kept(&act_after(&mut session, PartsAction::TakeValue.into(), 600));
    assert_eq!(session.parts().walking.shown().unwrap().1.record.measurement.diameter.to_string(), "1.203");
}

#[test]
fn a_size_is_measured_again_and_both_values_stay() {
    let mut session = walking();
    take(&mut session, "12.07");
    assert_eq!(session.parts().walking.status(), Some(Status::Scrap));
    act(&mut session, PartsAction::SizeAgain.into());
    assert_eq!(asked(&session).as_deref(), Some("BORE"));
    take(&mut session, "12.03");
    assert_eq!(session.parts().walking.values(0).len(), 2);
    assert_eq!(session.parts().walking.status(), None);
    assert_eq!(session.history().len(), 2);
    assert_eq!(asked(&session).as_deref(), Some("PIN"));
}

#[test]
fn every_kind_is_simulated_by_its_cycle_and_a_simulated_part_is_never_good() {
    let mut session = walking();
    let mut recorded = Vec::new();
    while asked(&session).is_some() {
        let effects = act(&mut session, PartsAction::SimulateValue.into());
        let refusal = session.parts().walking.refusal.as_ref().map(said);
        assert_eq!(refusal, None);
        recorded.extend(kept(&effects).1);
    }
    let names: Vec<_> = recorded.iter().map(|entry| entry.about.feature.as_str()).collect();
    // The cycle of a pocket measures both sides: the one that was asked for comes last.
    assert_eq!(names, ["BORE", "PIN", "K1 Y", "K1 X", "TOP"]);
    for entry in &recorded {
        let record = size(entry);
        assert!(record.measurement.origin.is_simulated(), "{}", record.id);
        assert_eq!(record.measurement.diameter, record.limits.middle(), "{}", record.id);
        assert_eq!(record.verdict.status(), Status::Good, "{}", record.id);
    }
    let walking = &session.parts().walking;
    assert_eq!((walking.standing().simulated, walking.standing().is_complete()), (5, false));
    assert_eq!(walking.status(), None);
}

#[test]
fn a_size_is_left_out_for_a_reason_alone() {
    let mut session = walking();
    act(&mut session, PartsAction::SkipSize.into());
    assert!(session.parts().walking.is_skipping);
    typed(&mut session, WalkField::Reason, "  ");
    act(&mut session, PartsAction::SkipFor.into());
    assert!(session.error(WalkField::Reason).is_some());
    assert_eq!(asked(&session).as_deref(), Some("BORE"));
    typed(&mut session, WalkField::Reason, "probe broken");
    act(&mut session, PartsAction::SkipFor.into());
    assert_eq!(asked(&session).as_deref(), Some("PIN"));
    assert_eq!(standing(&session), "0 measured, 4 missing, 1 skipped");
    // Measured later all the same.
    send(&mut session, WalkCommand::Go(0));
    take(&mut session, "12.03");
    assert_eq!(standing(&session), "1 measured, 4 missing, 0 skipped");
}

#[test]
fn the_next_part_counts_up_and_what_is_missing_is_said_first() {
    let mut session = walking();
    take(&mut session, "12.03");
    assert_eq!(act(&mut session, PartsAction::NextPart.into()), []);
    assert!(session.parts().walking.is_warned && session.parts().walking.is_begun());
    assert_eq!(act(&mut session, PartsAction::NextPart.into()), [Effect::Focus(WalkField::Serial.into())]);
    assert!(!session.parts().walking.is_begun());
    assert_eq!(session.text(WalkField::Serial), "A-0100");
    act(&mut session, PartsAction::CountUp.into());
    assert_eq!(session.text(WalkField::Serial), "A-0101");
}

#[test]
fn the_list_is_walked_by_key() {
    let mut session = walking();
    for (step, name) in [(Step::Down, "PIN"), (Step::Last, "TOP"), (Step::Up, "K1 Y"), (Step::First, "BORE")] {
        act(&mut session, PartsAction::MoveSize(step).into());
        assert_eq!(asked(&session).as_deref(), Some(name));
    }
}

#[test]
fn a_file_fills_the_walk_and_what_finds_no_feature_is_listed() {
    let mut session = walking();
    let effects = import(&mut session, "name;measured\nBORE;12.03\nPIN;19.985\nNOBODY;3\nTOP;9.98\n");
    let (_, entries) = kept(&effects);
    assert_eq!(entries.len(), 3, "one batch");
    assert!(entries.iter().all(|entry| entry.about.serial == "A-0099" && entry.about.part == "Flange"));
    assert_eq!(entries[0].check().unwrap().files[0].sha256, Hash([3; 32]));
    assert_eq!(standing(&session), "3 measured, 2 missing, 0 skipped");
    let notice = session.notices().last().unwrap();
    assert_eq!(said(&notice.message), "m.csv: 3 imported, 1 not");
    assert!(notice.details.iter().any(|line| said(line).contains("no feature of the plan")), "{:?}", notice.details);
    assert_eq!(asked(&session).as_deref(), Some("K1 X"));
}

#[test]
fn a_file_that_is_dropped_on_a_walk_is_read_for_it() {
    let mut session = walking();
    let path = PathBuf::from("/in/m.csv");
    let effects = send(&mut session, FilesCommand::Open(Purpose::Import, path.clone()));
    assert_eq!(effects, [Effect::Read(Purpose::ImportValues(1), path)]);
    assert_eq!(session.page(), Page::Parts);
    // It comes when the part was ended already.
    act(&mut session, PartsAction::NextPart.into());
    act(&mut session, PartsAction::NextPart.into());
    assert_eq!(import(&mut session, "name;measured\nBORE;12.03\n"), []);
    assert!(session.history().is_empty());
}

#[test]
fn values_of_another_serial_number_are_recorded_under_it_and_said() {
    let mut session = walking();
    let mut items = items("name;measured\nBORE;12.03\nPIN;19.985\n");
    let serials = ["B-7", "A-0099"];
    for item in &mut items {
        let (labels, at) = match item {
            Item::Unjudged(unjudged) => (&mut unjudged.labels, unjudged.line - 2),
            Item::Record { labels, line, .. } => (labels, *line - 2),
            _ => continue,
        };
        labels.serial = serials[at].to_owned();
    }
    let command = imported(&session, items);
    let (_, entries) = kept(&send(&mut session, command));
    let serials: Vec<_> = entries.iter().map(|entry| entry.about.serial.as_str()).collect();
    assert_eq!(serials, ["B-7", "A-0099"]);
    assert_eq!(standing(&session), "1 measured, 4 missing, 0 skipped");
    let notice = session.notices().last().unwrap();
    assert!(notice.details.iter().any(|line| said(line).contains("B-7")), "{:?}", notice.details);
}

#[test]
fn the_plans_rule_counts_and_else_the_rule_of_the_check_page() {
    let mut session = walking();
    typed(&mut session, CheckField::Uncertainty, "not a number");
    assert_eq!(take(&mut session, "12.03"), [], "a rule that cannot be read judges nothing");
    assert!(session.error(WalkField::Value).is_some());
    typed(&mut session, CheckField::Uncertainty, "");
    kept(&take(&mut session, "12.03"));
    // At 30 °C a steel pin of 20 mm is 2.3 µm longer.
    typed(&mut session, CheckField::PartTemperature, "30");
    kept(&take(&mut session, "19.985"));
    let record = &session.parts().walking.shown().unwrap().1.record;
    assert!(record.correction.is_some());
    assert!(record.measurement.diameter < "19.985".parse().unwrap());
}

/// The rows that a journal would give for what was sent.
pub fn rows(entries: &[Entry], first: u64) -> Vec<RecordRow> {
    let row = |(number, entry): (u64, &Entry)| RecordRow {
        head: head(number),
        entry: Ok(entry.clone()),
        corrected_by: None,
        went_back: false,
    };
    (first..).zip(entries).map(row).collect()
}

#[test]
fn an_interrupted_part_comes_back_with_its_values_and_reasons() {
    let mut session = walking();
    let mut entries = kept(&take(&mut session, "12.07")).1;
    act(&mut session, PartsAction::SizeAgain.into());
    entries.extend(kept(&take(&mut session, "12.03")).1);
    send(&mut session, WalkCommand::Skip("probe broken".to_owned()));
    let saved = Saved::read(&session.saved().write().unwrap()).unwrap();
    let (mut back, effects) = Session::restore(saved);
    assert_eq!(effects, [Effect::Read(Purpose::OpenPlan, "/plans/flange.toml".into())]);
    begin_records(&mut back);
    assert!(!back.parts().walking.is_begun());
    read_plan(&mut back, PLAN);
    let effects = open_journal(&mut back, 9);
    let asks = effects.iter().find_map(|effect| match effect {
        Effect::ReadPart { run, question, .. } => Some((*run, question.clone())),
        _ => None,
    });
    let (run, question) = asks.unwrap();
    assert_eq!((question.part.as_deref(), question.serial.as_deref()), (Some("Flange"), Some("A-0099")));
    // A part of the same number that was measured before this one was begun is another one.
    let mut came = rows(&entries[..1], 5);
    came.extend(rows(&entries, 8));
    send(&mut back, WalkCommand::Came { run, result: Ok(came) });
    let walking = &back.parts().walking;
    assert_eq!((walking.serial(), walking.values(0).len()), ("A-0099", 2));
    assert_eq!(standing(&back), "1 measured, 3 missing, 1 skipped");
    assert_eq!(asked(&back).as_deref(), Some("K1 X"));
    assert_eq!(said(&back.notices().last().unwrap().message), "The interrupted part A-0099 was restored with 2 values");
    // Once more, too late: nothing is there twice.
    send(&mut back, WalkCommand::Came { run, result: Ok(rows(&entries, 8)) });
    assert_eq!(back.parts().walking.values(0).len(), 2);
    // Ended, it does not come back.
    act(&mut back, PartsAction::NextPart.into());
    act(&mut back, PartsAction::NextPart.into());
    assert_eq!(back.saved().walk, Saved::default().walk);
}

#[test]
fn without_a_journal_an_interrupted_part_comes_back_without_values_and_says_so() {
    let mut session = walking();
    take(&mut session, "12.03");
    let (mut back, _) = Session::restore(session.saved());
    read_plan(&mut back, PLAN);
    assert!(!back.parts().walking.is_begun(), "nobody has said yet where records are kept");
    let zone = TimeZone::fixed(offset(1));
    send(&mut back, RecordsCommand::Begin { usual: None, station: "Mill 3".to_owned(), zone });
    assert!(back.parts().walking.is_begun());
    assert!(said(&back.notices().last().unwrap().message).contains("without its values"));
}

pub fn watched(session: &mut Session) -> u64 {
    let effects = send(session, WalkCommand::Watch { folder: "/in".into(), is_folder: true });
    match &effects[..] {
        [Effect::Watch { run, folder, .. }] => {
            assert_eq!(folder, &PathBuf::from("/in"));
            *run
        }
        other => panic!("{other:?}"),
    }
}

pub fn look(session: &Session, number: u64, text: &str) -> WatchNews {
    let plan = session.parts().document.plan().unwrap();
    let by_plan = fitcheck::exchange::ByPlan::new(plan);
    let mut judged = Vec::new();
    for item in items(text) {
        by_plan.item(item, &mut |item| judged.push(item));
    }
    let file = WatchedFile { name: "m.csv".to_owned(), sha256: Hash([9; 32]), items: judged, remarks: Vec::new() };
    WatchNews::Look { number, files: vec![file] }
}

#[test]
fn what_comes_into_the_watched_folder_is_taken_once_it_is_on_disk_and_not_before() {
    let mut session = walking();
    let run = watched(&mut session);
    let news = look(&session, 1, "name;measured\nBORE;12.03\nPIN;20.1\n");
    let effects = send(&mut session, WalkCommand::Watched { run, news: Box::new(news) });
    let (batch, entries) = kept(&effects);
    assert_eq!((effects.len(), entries.len()), (1, 2), "one batch, and nothing is taken yet");
    assert_eq!(entries[0].check().unwrap().files[0].sha256, Hash([9; 32]));
    assert!(session.parts().watched.is_recording());
    assert_eq!(standing(&session), "2 measured, 3 missing, 0 skipped");
    assert_eq!(session.parts().walking.status(), Some(Status::Rework));
    // A full disk: it is tried again, and still not taken.
    let full = Err(Message::new("records-page-no-thread"));
    assert_eq!(send(&mut session, RecordsCommand::Kept { run: batch, result: full }), []);
    let effects = send(&mut session, RecordsCommand::TryAgain);
    assert!(matches!(effects[..], [Effect::Keep { .. }]), "{effects:?}");
    let effects = send(&mut session, RecordsCommand::Kept { run: batch, result: Ok(vec![head(8), head(9)]) });
    assert_eq!(without_alarms(effects), [Effect::WatchTaken { run, look: 1 }]);
    let files: Vec<_> = session.parts().watched.files().collect();
    assert_eq!((files[0].name.as_str(), files[0].counts.iter().map(|(_, count)| count).sum()), ("m.csv", 2_usize));
    // A look without a value has nothing to be recorded.
    let news = look(&session, 2, "name;measured\nNOBODY;3\n");
    let effects = send(&mut session, WalkCommand::Watched { run, news: Box::new(news) });
    assert_eq!(effects, [Effect::WatchTaken { run, look: 2 }]);
    assert_eq!(session.parts().watched.files().next().unwrap().said.len(), 1);
}

#[test]
fn a_watch_begins_anew_only_once_what_it_found_before_is_on_disk() {
    for stops in [false, true] {
        let mut session = walking();
        let run = watched(&mut session);
        let news = look(&session, 1, "name;measured\nBORE;12.03\n");
        let (batch, _) = kept(&send(&mut session, WalkCommand::Watched { run, news: Box::new(news) }));
        // What is on its way to the disk is not known there yet.
        if stops {
            assert_eq!(act(&mut session, PartsAction::StopWatch.into()), [Effect::StopWatch]);
            let again = send(&mut session, WalkCommand::Watch { folder: "/in".into(), is_folder: true });
            assert_eq!(again, []);
        } else {
            assert_eq!(send(&mut session, Command::SetLanguage(Language::Nl)), []);
        }
        assert!(session.parts().watched.is_recording());
        let full = Err(Message::new("records-page-no-thread"));
        assert_eq!(send(&mut session, RecordsCommand::Kept { run: batch, result: full }), []);
        let effects = send(&mut session, RecordsCommand::TryAgain);
        assert!(matches!(effects[..], [Effect::Keep { .. }]), "{effects:?}");
        let effects = send(&mut session, RecordsCommand::Kept { run: batch, result: Ok(vec![head(8)]) });
        let effects = without_alarms(effects);
        let [Effect::Watch { run: anew, .. }] = effects[..] else { panic!("{effects:?}") };
        assert!(run < anew && !session.parts().watched.is_recording());
    }
}

#[test]
fn a_watch_begins_anew_when_values_are_brought_to_20_degrees_from_another_temperature() {
    let mut session = walking();
    let run = watched(&mut session);
    let mut edit = |field: CheckField, text: &str| send(&mut session, Field::from(field).typed(text.to_owned()));
    assert_eq!(edit(CheckField::PartExpansion, "11.5"), []);
    let effects = edit(CheckField::PartTemperature, "35");
    let [Effect::Watch { run: anew, .. }] = effects[..] else { panic!("{effects:?}") };
    assert!(run < anew);
    assert_eq!(edit(CheckField::Uncertainty, "0.001"), []);
}

#[test]
fn a_watch_that_was_ended_changes_nothing_any_more() {
    let mut session = walking();
    let run = watched(&mut session);
    assert_eq!(act(&mut session, PartsAction::StopWatch.into()), [Effect::StopWatch]);
    let news = look(&session, 1, "name;measured\nBORE;12.03\n");
    assert_eq!(send(&mut session, WalkCommand::Watched { run, news: Box::new(news) }), []);
    assert!(session.history().is_empty());
    // A file is no folder.
    assert_eq!(send(&mut session, WalkCommand::Watch { folder: "/in/a.csv".into(), is_folder: false }), []);
    assert!(session.parts().watched.folder.is_none());
}

#[test]
fn a_folder_is_watched_once_the_journal_is_open() {
    let mut session = Session::new(Language::En);
    begin_records(&mut session);
    send(&mut session, Command::OpenPage(Page::Parts));
    read_plan(&mut session, PLAN);
    assert_eq!(send(&mut session, WalkCommand::Watch { folder: "/in".into(), is_folder: true }), []);
    let effects = without_alarms(open_journal(&mut session, 1));
    assert!(matches!(effects[..], [Effect::Watch { .. }]), "{effects:?}");
}

/// A folder that is watched by a plan, with no part begun.
fn watching_alone() -> (Session, u64) {
    let mut session = Session::new(Language::En);
    begin_records(&mut session);
    open_journal(&mut session, 7);
    send(&mut session, Command::OpenPage(Page::Parts));
    read_plan(&mut session, PLAN);
    let run = watched(&mut session);
    (session, run)
}

#[test]
fn a_watched_value_of_no_part_is_said_to_have_no_serial_number() {
    let (mut session, run) = watching_alone();
    let news = look(&session, 1, "name;measured\nBORE;12.03\nPIN;20.1\n");
    let (_, entries) = kept(&send(&mut session, WalkCommand::Watched { run, news: Box::new(news) }));
    assert_eq!(entries[0].about.serial, "");
    let told: Vec<String> = session.parts().watched.files().next().unwrap().said.iter().map(said).collect();
    assert!(told[0].starts_with("2 values are recorded without a serial number"), "{told:?}");
    // With a serial number of its own, or of a part that is being measured, it is somebody's.
    let (mut session, run) = watching_alone();
    let news = look(&session, 1, "name;serial;measured\nBORE;Z-9;12.03\n");
    send(&mut session, WalkCommand::Watched { run, news: Box::new(news) });
    let told: Vec<String> = session.parts().watched.files().next().unwrap().said.iter().map(said).collect();
    assert!(!told.iter().any(|text| text.contains("without a serial number")), "{told:?}");
}

#[test]
fn watched_values_are_of_the_part_of_the_plan_that_they_are_judged_by() {
    let (mut session, run) = watching_alone();
    let news = look(&session, 1, "name;measured\nBORE;12.03\n");
    read_plan(&mut session, &PLAN.replace("Flange", "Cover"));
    let (_, entries) = kept(&send(&mut session, WalkCommand::Watched { run, news: Box::new(news) }));
    assert_eq!(entries[0].about.part, "Flange");
}

fn change(session: &mut Session, callout: &str) {
    send(session, PartsCommand::Plan(PlanCommand::Go(0, Column::Callout, false)));
    send(session, PartsCommand::Plan(PlanCommand::Edit(Some(callout.to_owned()))));
    send(session, PartsCommand::Plan(PlanCommand::Take(None)));
}

fn read_other_plan(session: &mut Session) {
    let document = Document::read(PLAN.replace("Flange", "Cover").as_bytes()).unwrap();
    let read = PlanCommand::Read { path: PathBuf::from("/plans/cover.toml"), result: Ok(Box::new(document)) };
    send(session, PartsCommand::Plan(read));
}

#[test]
fn another_plan_is_asked_about_while_a_part_is_not_finished_and_its_first_part_has_no_number_of_the_other() {
    let mut session = walking();
    take(&mut session, "12.03");
    assert!(!session.parts().asks_which_plan());
    read_other_plan(&mut session);
    assert!(session.parts().asks_which_plan());
    assert_eq!(session.parts().both_plans(), ["flange.toml", "cover.toml"]);
    let told = session.notices().iter().map(|notice| said(&notice.message)).collect::<Vec<_>>();
    assert!(told.iter().any(|told| told.starts_with("A part measured by flange.toml is not finished")), "{told:?}");
    // What is missing of this part is said first.
    act(&mut session, PartsAction::BeginByOpenPlan.into());
    assert!(session.parts().walking.is_begun() && session.parts().walking.is_warned);
    act(&mut session, PartsAction::BeginByOpenPlan.into());
    assert!(!session.parts().walking.is_begun());
    assert_eq!(session.text(WalkField::Serial), "");
    act(&mut session, PartsAction::BeginPart.into());
    assert_eq!(session.parts().walking.plan.as_ref().unwrap().head.part, "Cover");
    assert!(!session.parts().asks_which_plan());
}

#[test]
fn a_part_goes_on_by_its_own_plan_once_that_is_said() {
    let mut session = walking();
    read_other_plan(&mut session);
    act(&mut session, PartsAction::KeepMeasuring.into());
    assert!(!session.parts().asks_which_plan() && session.parts().is_other_open());
    take(&mut session, "12.03");
    assert_eq!(session.parts().walking.values(0).len(), 1);
}

#[test]
fn a_number_that_was_counted_up_is_not_that_of_another_plans_first_part() {
    let mut session = walking();
    act(&mut session, PartsAction::NextPart.into());
    act(&mut session, PartsAction::NextPart.into());
    assert_eq!(session.text(WalkField::Serial), "A-0100");
    read_other_plan(&mut session);
    assert_eq!(session.text(WalkField::Serial), "");
}

#[test]
fn a_folder_that_is_judged_by_an_older_plan_says_so() {
    let (mut session, _) = watching_alone();
    assert!(!session.parts().watches_other_plan() && session.parts().watched.comes_back());
    change(&mut session, "12 H7");
    assert!(session.parts().watches_other_plan());
    send(&mut session, PartsCommand::Plan(PlanCommand::Undo));
    assert!(!session.parts().watches_other_plan());
    // A part that is begun is judged by the plan as it is, and so is the folder from then on.
    change(&mut session, "12 H7");
    let effects = act(&mut session, PartsAction::BeginPart.into());
    assert!(matches!(effects[..], [_, Effect::Watch { .. }] | [Effect::Watch { .. }, _]), "{effects:?}");
    assert!(!session.parts().watches_other_plan());
}

#[test]
fn a_folder_that_is_watched_by_a_plan_that_no_file_holds_is_not_watched_by_an_older_file_after_a_restart() {
    let (mut session, _) = watching_alone();
    change(&mut session, "12 H7");
    let again = send(&mut session, WalkCommand::Watch { folder: "/in".into(), is_folder: true });
    assert!(matches!(again[..], [Effect::Watch { .. }]), "{again:?}");
    assert!(!session.parts().watched.comes_back() && session.saved().walk.watched.is_none());
    // Saved, it can be read again.
    act(&mut session, PartsAction::SavePlan(0).into());
    send(&mut session, Command::TypePath("/plans/new.toml".to_owned()));
    let effects = send(&mut session, Command::Confirm);
    let [Effect::ForDialog(number, _)] = &effects[..] else { panic!("{effects:?}") };
    let saved = Command::Saved { path: "/plans/new.toml".into(), result: Ok(()) };
    send(&mut session, Command::Answered(*number, Box::new(saved)));
    assert_eq!(session.saved().walk.watched.unwrap().plan, PathBuf::from("/plans/new.toml"));
}

#[test]
fn what_waits_for_a_plan_that_has_faults_now_is_told() {
    let mut session = walking();
    watched(&mut session);
    let saved = Saved::read(&session.saved().write().unwrap()).unwrap();
    let (mut back, _) = Session::restore(saved);
    begin_records(&mut back);
    open_journal(&mut back, 10);
    let faulty = PLAN.replace("12 F9", "12 F99");
    assert_eq!(read_plan(&mut back, &faulty), []);
    let told: Vec<String> = back.notices().iter().map(|notice| said(&notice.message)).collect();
    let ends = ["is restored once its plan has no faults", "is watched again once the plan has no faults"];
    assert_eq!(ends.map(|end| told.iter().filter(|text| text.ends_with(end)).count()), [1, 1], "{told:?}");
}

fn own_mask() -> Command {
    let (mask, _) = Mask::read(include_bytes!("../../assets/masks/82552_en.a")).unwrap();
    Command::MaskRead { path: "/masks/own.a".into(), result: Ok((Box::new(mask), Vec::new())) }
}

/// A session of a folder that is watched, and of a mask of the user's own, after a restart.
fn watching_by_mask() -> Session {
    let mut session = walking();
    watched(&mut session);
    send(&mut session, own_mask());
    let saved = Saved::read(&session.saved().write().unwrap()).unwrap();
    let (mut back, effects) = Session::restore(saved);
    assert!(effects.contains(&Effect::Read(Purpose::LoadMask, "/masks/own.a".into())), "{effects:?}");
    begin_records(&mut back);
    open_journal(&mut back, 10);
    let effects = read_plan(&mut back, PLAN);
    assert!(effects.contains(&Effect::Read(Purpose::WatchFolder, "/in".into())), "{effects:?}");
    assert_eq!(send(&mut back, WalkCommand::Watch { folder: "/in".into(), is_folder: true }), []);
    back
}

#[test]
fn a_folder_is_watched_again_once_the_own_mask_is_read() {
    let mut back = watching_by_mask();
    // What prints are read back through is waited for by files, too.
    assert_eq!(send(&mut back, FilesCommand::Open(Purpose::ImportValues(0), "/in/a.txt".into())), []);
    let effects = send(&mut back, own_mask());
    let [Effect::Watch { .. }, Effect::Read(Purpose::ImportValues(_), _)] = &effects[..] else { panic!("{effects:?}") };
    assert_eq!(back.own_masks()[0].0, "own.a");
    assert_eq!(back.saved().mask, Some("/masks/own.a".into()));
}

#[test]
fn without_the_own_mask_no_folder_is_watched_until_another_one_is_chosen() {
    let mut back = watching_by_mask();
    let result = Err(Message::new("walk-page-nothing-asked"));
    assert_eq!(send(&mut back, Command::MaskRead { path: "/masks/own.a".into(), result }), []);
    let trouble = said(back.parts().watched.trouble.as_ref().unwrap());
    assert!(trouble.starts_with("Your own mask /masks/own.a cannot be read"), "{trouble}");
    assert_eq!(back.saved().mask, Some("/masks/own.a".into()), "it may be there the next time");
    let effects = send(&mut back, Command::SetMask(None));
    assert!(matches!(effects[..], [Effect::Watch { .. }]), "{effects:?}");
    assert!(back.parts().watched.trouble.is_none() && back.saved().mask.is_none());
}

#[test]
fn a_mask_that_was_still_being_read_does_not_come_in_the_place_of_a_chosen_one() {
    let mut back = watching_by_mask();
    let effects = send(&mut back, Command::SetMask(Some(Dialogue::Nl)));
    assert!(matches!(effects[..], [Effect::Watch { .. }]), "{effects:?}");
    assert_eq!(send(&mut back, own_mask()), []);
    assert!(back.own_masks().is_empty() && back.saved().mask.is_none());
}

/// The first feature measures 12.07 of 12 F9, 12.016 to 12.059, which is too large: it was 12.05.
#[test]
fn a_value_that_is_corrected_counts_as_corrected_in_the_place_of_the_old_one() {
    let mut session = walking();
    let (run, entries) = kept(&take(&mut session, "12.07"));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(8)]) });
    assert_eq!(session.parts().walking.status(), Some(Status::Scrap));
    let row = RecordRow { head: head(8), ..rows(&entries, 8).remove(0) };
    send(&mut session, RecordsCommand::Open(8));
    send(&mut session, RecordsCommand::Read { numbers: vec![8], result: Ok(vec![std::sync::Arc::new(row.clone())]) });
    send(&mut session, RecordsCommand::Correct(true));
    typed(&mut session, fitcheck::session::RecordsField::Measured, "12.05");
    typed(&mut session, fitcheck::session::RecordsField::Reason, "misread");
    let (run, correction) = kept(&send(&mut session, RecordsCommand::SendCorrection));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(9)]) });
    let values = |session: &Session| -> Vec<String> {
        let values = session.parts().walking.values(0);
        values.iter().map(|value| value.record.measurement.diameter.to_string()).collect()
    };
    assert_eq!(
        (values(&session), standing(&session)),
        (vec!["12.05".to_owned()], "1 measured, 4 missing, 0 skipped".to_owned())
    );
    assert!(
        said(&session.notices().last().unwrap().message).contains("the corrected one applies"),
        "{:?}",
        session.notices()
    );
    // It was measured again before the first value was corrected: what was measured last counts, after a restart as well.
    act(&mut session, PartsAction::SizeAgain.into());
    let (_, again) = kept(&take(&mut session, "12.03"));
    let saved = Saved::read(&session.saved().write().unwrap()).unwrap();
    let (mut back, _) = Session::restore(saved);
    begin_records(&mut back);
    read_plan(&mut back, PLAN);
    let effects = open_journal(&mut back, 10);
    let run = effects.iter().find_map(|effect| match effect {
        Effect::ReadPart { run, .. } => Some(*run),
        _ => None,
    });
    let corrected = RecordRow { corrected_by: Some(10), ..row };
    let came = [vec![corrected], rows(&again, 9), rows(&correction, 10)].concat();
    send(&mut back, WalkCommand::Came { run: run.unwrap(), result: Ok(came) });
    assert_eq!(
        (values(&back), standing(&back)),
        (vec!["12.05".to_owned(), "12.03".to_owned()], "1 measured, 4 missing, 0 skipped".to_owned())
    );
}

#[test]
fn a_value_that_is_withdrawn_counts_no_more() {
    let mut session = walking();
    let (run, _) = kept(&take(&mut session, "12.07"));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(8)]) });
    let (run, entries) = kept(&take(&mut session, "19.985"));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(9)]) });
    assert_eq!(session.parts().walking.status(), Some(Status::Scrap));
    // On the records page: the first one is withdrawn.
    send(&mut session, RecordsCommand::Open(8));
    let row = RecordRow { head: head(8), ..rows(&entries, 8).remove(0) };
    send(&mut session, RecordsCommand::Read { numbers: vec![8], result: Ok(vec![std::sync::Arc::new(row)]) });
    send(&mut session, RecordsCommand::Correct(true));
    send(&mut session, RecordsCommand::Withdraw(true));
    typed(&mut session, fitcheck::session::RecordsField::Reason, "wrong part");
    let (run, _) = kept(&send(&mut session, RecordsCommand::SendCorrection));
    send(&mut session, RecordsCommand::Kept { run, result: Ok(vec![head(10)]) });
    assert_eq!(standing(&session), "1 measured, 4 missing, 0 skipped");
    assert!(said(&session.notices().last().unwrap().message).contains("BORE"), "{:?}", session.notices());
}
