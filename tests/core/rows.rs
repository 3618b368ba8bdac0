//! The rows of a large file: what is kept of them agrees with what `batch` writes, wherever blocks are cut, and the session
//! counts, filters and walks them by it.

use fitcheck::session::CheckAction;
use std::collections::BTreeSet;
use std::io::Cursor;
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck::batch::{Input, Manner, Packing, Sink, Watch, run, run_into};
use fitcheck::exchange::batch::{
    Block, Csv, Cutter, Filter, Layout, Marks, Part, RowFate, Store, StreamJudging, Tally, pick,
};
use fitcheck::exchange::import;
use fitcheck::message::Message;
use fitcheck::session::action::Action;
use fitcheck::session::{CheckCommand, Command, Effect, End, Large, News, Rows, RowsCommand, Session, Step};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::Status;
use fitcheck::words::Language;
use jiff::civil::DateTime;
use proptest::prelude::*;

fn now() -> DateTime {
    jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0)
}

/// Collects the parts of a run.
#[derive(Default)]
struct Collected {
    store: Store,
    parts: Vec<Arc<Part>>,
    tally: Tally,
}

impl Sink<Marks> for Collected {
    fn take(&mut self, made: &mut Marks, block: &Block, tally: &Tally) -> std::io::Result<()> {
        self.parts.push(Arc::new(self.store.part(made, block, tally)));
        self.tally.add(tally.clone());
        Ok(())
    }
}

/// The parts of a text, cut into blocks of about so many bytes.
fn parts(text: &[u8], step: usize, workers: usize, sources: &Sources) -> (Layout, Collected) {
    let layout = Layout::of(text, true, "test.csv").unwrap();
    let mut found = Collected::default();
    {
        let court = StreamJudging::new(&layout, sources);
        let mut rows = Cursor::new(&text[layout.skip..]);
        let input = Input { stream: &mut rows, cutter: Cutter::new(layout.separator(), step, true) };
        let making: (usize, &(dyn Fn() -> Marks + Sync)) = (workers, &Marks::default);
        run_into(input, &court, making, &mut found, &Watch::default(), &mut |_| {}).unwrap();
    }
    (layout, found)
}

/// What `batch` writes: the class's text and the status of each row, and whether it is refused.
fn written(text: &[u8], sources: &Sources) -> Vec<(String, RowFate)> {
    let layout = Layout::of(text, true, "test.csv").unwrap();
    let court = StreamJudging::new(&layout, sources);
    let mut rows = Cursor::new(&text[layout.skip..]);
    let input = Input { stream: &mut rows, cutter: Cutter::new(layout.separator(), 1 << 20, true) };
    let manner = Manner { workers: 1, packing: Packing::Plain, prefix: "" };
    let mut out = Csv::header(&layout, "");
    run::<Csv>(input, &court, manner, &mut out, &Watch::default(), &mut |_| {}).unwrap();
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(out.as_slice());
    let rows = reader.records().map(|row| {
        let row = row.unwrap();
        let status = &row[row.len() - 3];
        let fate = RowFate::ALL.into_iter().find(|fate| fate.status().is_some_and(|known| known.word() == status));
        // A class of its own column; rows without a verdict count as those without a class.
        let class = row[1].split(' ').next_back().unwrap_or_default().to_owned();
        (class, fate.unwrap_or(RowFate::NotJudged), row[row.len() - 1].is_empty() && status.is_empty())
    });
    rows.filter(|(_, _, is_no_row)| !is_no_row).map(|(class, fate, _)| (class, fate)).collect()
}

fn row() -> impl Strategy<Value = String> {
    let callout = prop::sample::select(vec!["25 H7", "25 h6", "40 g6", "12 X99", "25 +0.1 -0.1 H", "\"25 H7\"", ""]);
    let measured = prop::sample::select(vec!["25.01", "24.99", "25.5", "39.98", "12.0", "abc", "\"25.01\"", ""]);
    let rest = prop::sample::select(vec!["", "note", "\"two\nlines\"", "\"open"]);
    (callout, measured, rest).prop_map(|(callout, measured, rest)| format!("p,{callout},{measured},{rest}\n"))
}

proptest! {
    #[test]
    fn the_marks_agree_with_what_batch_writes(
        rows in prop::collection::vec(row(), 1..80),
        step in 20_usize..400,
        workers in 1_usize..4,
        fates in prop::collection::btree_set(prop::sample::select(RowFate::ALL.to_vec()), 0..3),
    ) {
        let text = format!("id,callout,measured,note\np,25 H7,25.01,\n{}", rows.concat());
        let sources = Sources::default();
        let expected = written(text.as_bytes(), &sources);
        let (layout, found) = parts(text.as_bytes(), step, workers, &sources);
        let court = StreamJudging::new(&layout, &sources);
        let class = |number: usize| number.checked_sub(1).map(|at| found.store.classes[at].to_string());
        let kept: Vec<_> = found.parts.iter().flat_map(|part| (0..part.len()).map(|at| part.row(at).unwrap())).collect();
        // An open quotation mark is read otherwise by the reader of this test.
        let is_comparable = !text.contains("\"open");
        if is_comparable {
            let fates = |fates: &mut dyn Iterator<Item = RowFate>| fates.collect::<Vec<_>>();
            prop_assert_eq!(fates(&mut kept.iter().map(|row| row.0)), fates(&mut expected.iter().map(|row| row.1)));
        }
        for ((fate, number), (text, _)) in kept.iter().zip(&expected).filter(|_| is_comparable) {
            if *fate != RowFate::NotJudged && let Some(class) = class(*number) {
                prop_assert_eq!(&class, text);
            }
        }
        // The counts of a filter are the rows that it lists.
        for classes in [BTreeSet::new(), [0].into(), [1].into(), [0, 1].into()] {
            let filter = Filter { fates: fates.clone(), classes };
            let sieve = filter.sieve(found.store.classes.len());
            for part in &found.parts {
                let listed: Vec<_> = part.listed(&sieve).collect();
                prop_assert_eq!(listed.len(), part.count(&sieve));
                let takes = |at: &usize| {
                    let (fate, class) = part.row(*at).unwrap();
                    (filter.fates.is_empty() || filter.fates.contains(&fate)) && (filter.classes.is_empty() || filter.classes.contains(&class))
                };
                prop_assert_eq!(listed, (0..part.len()).filter(takes).collect::<Vec<_>>());
            }
        }
        // Every row is read again where it stands.
        let lines: Vec<&str> = text.split_inclusive('\n').collect();
        for part in &found.parts {
            let start = layout.skip + usize::try_from(part.start).unwrap();
            let bytes = &text.as_bytes()[start..start + part.bytes];
            let wanted: Vec<usize> = (0..part.len()).collect();
            let picked = pick(bytes.to_vec(), part, &wanted, &court).unwrap();
            for row in &picked {
                let line = layout.line + row.line;
                prop_assert!(lines[line - 1].starts_with(&row.cells[0]), "line {}: {:?}", line, row.cells);
                let imported = row.imported(&layout, "test.csv", &sources, now());
                prop_assert_eq!(imported.records.len(), usize::from(row.judged.is_some()));
                if let (Some(record), Some(judged)) = (imported.records.first(), row.judged) {
                    prop_assert_eq!(record.verdict.size, judged.verdict());
                }
                prop_assert_eq!(row.why.is_some(), row.judged.is_none());
            }
            prop_assert_eq!(picked.len(), part.len());
        }
    }
}

#[test]
fn other_bytes_in_the_place_of_a_part_are_no_rows_of_it() {
    let text = b"id,callout,measured\n1,25 H7,25.01\n2,25 H7,24.99\n".to_vec();
    let sources = Sources::default();
    let (layout, found) = parts(&text, 1 << 20, 1, &sources);
    let court = StreamJudging::new(&layout, &sources);
    let part = &found.parts[0];
    let rows = text[layout.skip..].to_vec();
    assert_eq!(pick(rows.clone(), part, &[1], &court).unwrap()[0].named, ["2", "25 H7"]);
    // Another verdict, another number of rows, another length.
    let other = String::from_utf8(rows.clone()).unwrap();
    for other in [other.replace("25.01", "24.91"), other.replace("\n2", " 2"), other + "3,25 H7,25.01\n"] {
        assert_eq!(pick(other.into_bytes(), part, &[1], &court), None);
    }
}

/// A text with good, rework and scrap parts, and one row that cannot be read.
fn some(count: usize) -> String {
    let row = |number: usize| match number % 10 {
        0 => format!("P{number},25 H7,24.99\n"),
        1 => format!("P{number},40 g6,39.9\n"),
        _ => format!("P{number},25 H7,25.01\n"),
    };
    let rows: String = (0..count).map(row).collect();
    format!("id,callout,measured\n{rows}X,25 H7,\n")
}

fn news(text: &str, take: usize, end: Option<End>) -> News {
    let (layout, found) = parts(text.as_bytes(), 400, 1, &Sources::default());
    News {
        layout: Some(Arc::new(layout)),
        parts: found.parts.into_iter().take(take).collect(),
        classes: found.store.classes,
        tally: found.tally,
        bytes: (1, Some(2)),
        elapsed_ms: 10,
        end,
        ..News::default()
    }
}

/// A session in which a large file was opened.
fn opened() -> Session {
    let mut session = Session::new(Language::En);
    let result = Ok((PathBuf::from("big.csv"), Large::Bytes(5 << 20)));
    let effects = session.apply(RowsCommand::Opened { name: "big.csv".to_owned(), result }.into(), now());
    assert_eq!(effects, [Effect::StopRows, Effect::JudgeRows { run: 1, path: PathBuf::from("big.csv") }]);
    session
}

fn rows(session: &Session) -> &Rows {
    session.check().rows.as_ref().unwrap()
}

fn send(session: &mut Session, command: RowsCommand) -> Vec<Effect> {
    session.apply(command.into(), now())
}

/// The worker says something; at the end the worst row is read, which is shown.
fn judged(session: &mut Session, run: u64, news: News) -> Vec<Effect> {
    let effects = send(session, RowsCommand::Judged { run, news: Box::new(news) });
    assert!(effects.iter().all(|effect| matches!(effect, Effect::ReadRows { .. })), "{effects:?}");
    effects
}

/// Answers the effects that read rows again.
fn answer(session: &mut Session, text: &str, effects: Vec<Effect>) {
    let layout = Layout::of(text.as_bytes(), true, "big.csv").unwrap();
    let sources = Sources::default();
    let court = StreamJudging::new(&layout, &sources);
    for effect in effects {
        let Effect::ReadRows { run, wanted } = effect else { panic!("{effect:?}") };
        let mut all = Vec::new();
        for (part, wanted) in wanted {
            let start = layout.skip + usize::try_from(part.start).unwrap();
            let bytes = text.as_bytes()[start..start + part.bytes].to_vec();
            let picked = pick(bytes, &part, &wanted, &court).unwrap();
            all.extend(picked.into_iter().map(|row| (part.first + u64::try_from(row.number).unwrap(), Arc::new(row))));
        }
        assert!(send(session, RowsCommand::Read { run, result: Ok(all) }).is_empty());
    }
}

#[test]
fn a_cancelled_run_keeps_its_rows_and_says_that_it_is_not_whole() {
    let (text, mut session) = (some(100), opened());
    judged(&mut session, 1, news(&text, 2, None));
    assert!(rows(&session).is_running());
    let count = rows(&session).count();
    assert!(0 < count && count < 101, "{count}");
    // Escape does it, also while somebody types.
    let escape = Action::from(CheckAction::CancelRows).shortcuts().next().unwrap();
    for (is_typing, part) in [(false, None), (true, None), (false, Some(fitcheck::session::focused::ROWS))] {
        let keys = session.keys(part, is_typing);
        let first = keys.iter().find(|(shortcut, _)| *shortcut == escape).map(|(_, action)| *action);
        assert_eq!(first, Some(CheckAction::CancelRows.into()));
    }
    assert_eq!(send(&mut session, RowsCommand::Cancel), [Effect::StopRows]);
    assert!(!session.can(CheckAction::CancelRows) && session.can(CheckAction::JudgeRowsAgain));
    // At once, whatever its worker waits for.
    assert_eq!(rows(&session).end.as_ref(), Some(&End::Cancelled));
    assert_eq!((rows(&session).count(), rows(&session).listed()), (count, usize::try_from(count).unwrap()));
    // What comes too late changes nothing, nor does a second cancel.
    judged(&mut session, 1, news(&text, 9, Some(End::Done)));
    assert_eq!((rows(&session).count(), rows(&session).end.as_ref()), (count, Some(&End::Cancelled)));
    assert!(send(&mut session, RowsCommand::Cancel).is_empty());
}

#[test]
fn another_file_ends_the_first_and_its_late_answers_are_not_heard() {
    let (text, mut session) = (some(100), opened());
    judged(&mut session, 1, news(&text, 1, None));
    let result = Ok((PathBuf::from("other.csv.gz"), Large::Packed));
    let effects = send(&mut session, RowsCommand::Opened { name: "other.csv.gz".to_owned(), result });
    assert_eq!(effects, [Effect::StopRows, Effect::JudgeRows { run: 2, path: PathBuf::from("other.csv.gz") }]);
    judged(&mut session, 1, news(&text, 9, Some(End::Done)));
    assert_eq!((rows(&session).name.as_str(), rows(&session).count()), ("other.csv.gz", 0));
    assert!(rows(&session).is_running());
    // An import ends it, too, and goes in front; the rows stay at hand.
    let imported = Box::new(import("small.csv", b"id,callout,measured\n1,25 H7,25.01\n", &Sources::default(), now()));
    let command = CheckCommand::Imported { name: "small.csv".to_owned(), result: Ok(imported) };
    assert_eq!(session.apply(command.into(), now()), [Effect::StopRows]);
    assert!(!session.check().shows_rows() && session.check().rows.is_some());
}

#[test]
fn rows_are_filtered_by_verdict_and_class_and_walked() {
    let (text, mut session) = (some(100), opened());
    judged(&mut session, 1, news(&text, usize::MAX, Some(End::Done)));
    let counts = rows(&session).fates().map(|(_, count)| count);
    assert_eq!(counts, [80, 10, 0, 0, 10, 1]);
    let classes: Vec<_> = rows(&session)
        .classes()
        .map(|(number, class, counts)| (number, class.map(|class| class.to_string()), counts.iter().sum::<u64>()))
        .collect();
    assert_eq!(classes, [(1, Some("H7".to_owned()), 90), (2, Some("g6".to_owned()), 10), (0, None, 1)]);
    for (commands, listed) in [
        (vec![RowsCommand::Fate(RowFate::Judged(Status::Scrap))], 10),
        (vec![RowsCommand::Fate(RowFate::Judged(Status::Rework))], 20),
        (vec![RowsCommand::Class(1)], 10),
        (vec![RowsCommand::Class(0), RowsCommand::Class(1)], 0),
        (vec![RowsCommand::AllClasses, RowsCommand::Fate(RowFate::Judged(Status::Rework))], 10),
        (vec![RowsCommand::Fate(RowFate::NotJudged)], 11),
        (vec![RowsCommand::Fate(RowFate::Judged(Status::Scrap))], 1),
        (vec![RowsCommand::Fate(RowFate::NotJudged)], 101),
    ] {
        for command in commands {
            assert!(send(&mut session, command).is_empty());
        }
        assert_eq!(rows(&session).listed(), listed);
        let all: Vec<u64> = (0..listed).map(|place| rows(&session).at(place).unwrap().number).collect();
        assert!(all.is_sorted_by(|one, other| one < other) && rows(&session).at(listed).is_none());
    }
    send(&mut session, RowsCommand::Fate(RowFate::Judged(Status::Scrap)));
    for (step, number) in [
        // The keys are at the worst row.
        (Step::Down, 11),
        (Step::Last, 91),
        (Step::Down, 91),
        (Step::Up, 81),
        (Step::PageUp, 1),
        (Step::PageDown, 91),
        (Step::First, 1),
    ] {
        send(&mut session, RowsCommand::Move(step));
        assert_eq!(rows(&session).cursor, Some(number), "{step:?}");
    }
    // A cursor that the filter leaves out is not lost.
    send(&mut session, RowsCommand::Fate(RowFate::Judged(Status::Scrap)));
    assert_eq!(rows(&session).look().1, Some(1));
}

#[test]
fn the_check_of_a_row_is_the_one_that_an_import_makes() {
    let (text, mut session) = (some(100), opened());
    let effects = judged(&mut session, 1, news(&text, usize::MAX, Some(End::Done)));
    answer(&mut session, &text, effects);
    assert_eq!(rows(&session).shown.as_ref().unwrap().number, 1, "the first of the worst");
    let imported = import("big.csv", text.as_bytes(), &Sources::default(), now());
    for number in [0_u64, 1, 57, 99] {
        let effects = send(&mut session, RowsCommand::Check(number));
        answer(&mut session, &text, effects);
        let shown = session.check().shown.as_ref().unwrap();
        assert_eq!(*shown.record, imported.records[usize::try_from(number).unwrap()]);
        let row = rows(&session).shown.as_ref().unwrap();
        assert_eq!((row.number, row.line), (number, 2 + usize::try_from(number).unwrap()));
        assert_eq!(row.cells[0], ("id".to_owned(), format!("P{number}")));
    }
    assert!(session.history().is_empty(), "it is not kept");
    send(&mut session, RowsCommand::Keep);
    assert_eq!(session.history().len(), 1);
    // A row without a verdict takes the check away, and says why.
    let effects = send(&mut session, RowsCommand::Check(100));
    answer(&mut session, &text, effects);
    assert!(session.check().shown.is_none());
    let why = rows(&session).shown.as_ref().unwrap().why.clone().unwrap();
    assert_eq!(why.to_string(), "measured: a length is missing");
    // Any edit takes the row away, too.
    session.apply(CheckCommand::Clear.into(), now());
    assert!(rows(&session).shown.is_none());
}

#[test]
fn rows_in_sight_are_asked_for_once_and_a_file_that_has_changed_is_said() {
    let (text, mut session) = (some(100), opened());
    judged(&mut session, 1, news(&text, usize::MAX, Some(End::Done)));
    let effects = send(&mut session, RowsCommand::See(0..10));
    assert_eq!(effects.len(), 1);
    assert!(send(&mut session, RowsCommand::See(0..10)).is_empty(), "they are being read");
    answer(&mut session, &text, effects);
    assert!(send(&mut session, RowsCommand::See(0..10)).is_empty(), "they are read");
    assert_eq!(rows(&session).at(0).unwrap().read.unwrap().named, ["P0", "25 H7"]);
    let effects = send(&mut session, RowsCommand::See(60..70));
    assert_eq!(effects.len(), 1);
    send(&mut session, RowsCommand::Read { run: 1, result: Err(Message::new("rows-changed")) });
    assert!(rows(&session).unread.is_some());
    assert!(send(&mut session, RowsCommand::See(60..70)).is_empty(), "nothing is asked for again and again");
}

#[test]
fn other_limits_judge_the_file_again() {
    let (text, mut session) = (some(100), opened());
    judged(&mut session, 1, news(&text, usize::MAX, Some(End::Done)));
    send(&mut session, RowsCommand::Fate(RowFate::NotJudged));
    let effects = session.apply(Command::NoOwnTables, now());
    assert_eq!(effects, [Effect::StopRows, Effect::JudgeRows { run: 2, path: PathBuf::from("big.csv") }]);
    assert_eq!((rows(&session).count(), rows(&session).is_running()), (0, true));
    assert!(rows(&session).filter.fates.contains(&RowFate::NotJudged), "the filter stays");
}

/// Only here so that a change of the size is noticed: millions of rows take two bytes each.
#[test]
fn a_row_takes_two_bytes() {
    let text = some(20_000);
    let (_, found) = parts(text.as_bytes(), 1 << 18, 1, &Sources::default());
    let rows: usize = found.parts.iter().map(|part| part.len()).sum();
    assert_eq!(rows, 20_001);
    let marks: usize = found.parts.iter().map(|part| part.bytes_kept()).sum();
    assert!(marks < rows * 2 + found.parts.len() * 512, "{marks}");
}
