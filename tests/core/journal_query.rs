//! A list of records is what a slow look at all of them gives, whatever is added, removed and asked.

use std::collections::BTreeMap;
use std::sync::Arc;

use fitcheck::journal::Record;
use fitcheck::journal::memory::{Memory, Removed};
use fitcheck::journal::query::{Column, FilterWord, Query, RecordId, Records, Searched, Sort};
use fitcheck::length::Length;
use fitcheck::probing::{Measurement, Origin};
use fitcheck::tolerance::{Callout, Sources};
use fitcheck::verdict::Status;
use jiff::ToSpan as _;
use jiff::civil::{DateTime, date};
use proptest::prelude::*;
use proptest::sample::select;

fn now() -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0)
}

/// Records by their numbers.
type Rows = Vec<(RecordId, Arc<Record>)>;

/// Names of parts and callouts, in the order in which a person sorts them.
const PARTS: [&str; 7] = ["", "1", "2", "10", "A2", "A10", "b1"];
const CALLOUTS: [&str; 4] = ["8 H7", "25 h6", "25 H7", "100 g6"];
const ORIGINS: usize = 5;

fn origin(number: usize) -> Origin {
    match number {
        0 => Origin::Typed,
        1 => Origin::Imported { file: "lot 2.csv".into() },
        2 => Origin::Imported { file: "lot 10.csv".into() },
        3 => Origin::Contacts { file: "a.csv".into() },
        _ => Origin::Simulated { cycle: 421, seed: 7 },
    }
}

/// A record by the numbers of its part, callout and origin, its value, µm off the nominal size, and its age in seconds.
fn record((part, callout, origin_number, um, age): (usize, usize, usize, i32, i32)) -> Arc<Record> {
    let callout: Callout = CALLOUTS[callout].parse().unwrap();
    let limits = Sources::default().limits(&callout, None).unwrap();
    let measured = Length::from_nanometres(limits.nominal.nanometres() + i64::from(um) * 1000).unwrap();
    let measurement = Measurement::of_diameter(measured, origin(origin_number));
    let time = now() - age.seconds();
    Arc::new(Record::judged(time, PARTS[part].to_owned(), Some(callout), limits, measurement, None))
}

fn any_record() -> impl Strategy<Value = Arc<Record>> {
    (0..PARTS.len(), 0..CALLOUTS.len(), 0..ORIGINS, -30..40_i32, 0..5_i32).prop_map(record)
}

fn any_query() -> impl Strategy<Value = Query> {
    let word = select(["a", "H7", "h7", "25", "lot", "2.csv", "07", "25,01"].as_slice()).prop_map(|text| {
        let mut word = FilterWord::new(text);
        word.statuses = [Status::Scrap].into_iter().filter(|_| text == "a").collect();
        word.typed = text == "lot";
        word
    });
    let sort =
        (select(Column::ALL.as_slice()), any::<bool>()).prop_map(|(column, ascending)| Sort { column, ascending });
    let words = prop_oneof![3 => Just(Vec::new()), 2 => proptest::collection::vec(word, 1..3)];
    (words, any::<bool>(), proptest::option::weighted(0.8, sort)).prop_map(|(words, only_bad, sort)| Query {
        words,
        only_bad,
        sort,
    })
}

/// What happens to the records.
#[derive(Debug, Clone)]
enum Act {
    Add(Vec<Arc<Record>>),
    /// Takes out everything from a record on; the number is counted round.
    Remove(u64),
    PutBack,
    Ask(Query),
}

fn any_act() -> impl Strategy<Value = Act> {
    prop_oneof![
        3 => proptest::collection::vec(any_record(), 1..4).prop_map(Act::Add),
        1 => proptest::collection::vec(any_record(), 66..70).prop_map(Act::Add),
        1 => any::<u64>().prop_map(Act::Remove),
        1 => Just(Act::PutBack),
        4 => any_query().prop_map(Act::Ask),
    ]
}

/// What a column sorts by: only its own entry is filled.
type Key = (Option<DateTime>, Option<Length>, Option<Status>, Option<usize>);

fn key(column: Column, record: &Record) -> Key {
    let place = |all: &[&str], text: &str| (None, None, None, all.iter().position(|known| *known == text));
    match column {
        Column::Time => (Some(record.time), None, None, None),
        Column::Part => place(&PARTS, &record.id),
        Column::Callout => place(&CALLOUTS, &record.callout.unwrap().to_string()),
        Column::Measured => (None, Some(record.measurement.diameter), None, None),
        Column::Deviation => (None, Some(record.verdict.size.deviation), None, None),
        Column::Status => (None, None, Some(record.verdict.status()), None),
        Column::From => (None, None, None, (0..ORIGINS).position(|n| origin(n) == record.measurement.origin)),
    }
}

/// Records that are looked at and sorted anew for every answer, by rules of their own.
#[derive(Default)]
struct Naive {
    rows: Rows,
    query: Query,
}

impl Naive {
    fn found(&self) -> Rows {
        let finds = |record: &Record| self.query.finds(record, &Searched::of(record));
        let mut found: Vec<_> = self.rows.iter().filter(|(_, record)| finds(record)).cloned().collect();
        let Some(Sort { column, ascending }) = self.query.sort else {
            found.reverse();
            return found;
        };
        found.sort_by_cached_key(|(id, record)| (key(column, record), *id));
        if !ascending {
            found.reverse();
        }
        found
    }
}

/// The kept list answers what the naive one finds.
fn check_same(memory: &Memory, naive: &Naive) {
    let all = naive.found();
    assert_eq!((memory.query(), memory.len(), memory.count()), (&naive.query, naive.rows.len(), all.len()));
    let of_status = |status| all.iter().filter(|(_, record)| record.verdict.status() == status).count();
    assert_eq!(memory.counts(), Status::ALL.map(of_status));
    assert_eq!(memory.page(0..usize::MAX), all);
    for step in [1, 7] {
        let pages = (0..memory.count()).step_by(step).flat_map(|first| memory.page(first..first + step));
        let pages: Rows = pages.collect();
        let ids = |rows: &Rows| rows.iter().map(|(id, _)| *id).collect::<Vec<_>>();
        assert_eq!(ids(&pages), ids(&all), "in pages of {step} every record comes once, in its place");
    }
    let places: BTreeMap<RecordId, usize> = all.iter().enumerate().map(|(place, (id, _))| (*id, place)).collect();
    let records: BTreeMap<RecordId, &Arc<Record>> = naive.rows.iter().map(|(id, record)| (*id, record)).collect();
    for id in (0..=memory.next().0).map(RecordId) {
        assert_eq!(memory.place_of(id), places.get(&id).copied(), "{id:?}");
        assert_eq!(memory.get(id).as_ref().map(Arc::as_ptr), records.get(&id).copied().map(Arc::as_ptr), "{id:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn a_kept_order_answers_like_a_fresh_look(acts in proptest::collection::vec(any_act(), 1..12)) {
        let (mut memory, mut naive) = (Memory::default(), Naive::default());
        let mut removed: Vec<(Removed, Rows)> = Vec::new();
        for act in acts {
            match act {
                Act::Add(records) => {
                    let first = memory.next();
                    naive.rows.extend((first.0..).map(RecordId).zip(records.iter().cloned()));
                    memory.add(records);
                }
                Act::Remove(number) => {
                    let first = RecordId(number % (memory.next().0 + 1));
                    let of_naive = naive.rows.split_off(naive.rows.partition_point(|(id, _)| *id < first));
                    let of_memory = memory.remove(first..RecordId(u64::MAX));
                    assert_eq!((of_memory.len(), of_memory.is_empty()), (of_naive.len(), of_naive.is_empty()));
                    removed.push((of_memory, of_naive));
                }
                Act::PutBack => {
                    if let Some((of_memory, of_naive)) = removed.pop() {
                        memory.put_back(of_memory);
                        naive.rows.extend(of_naive);
                        naive.rows.sort_by_key(|(id, _)| *id);
                    }
                }
                Act::Ask(query) => {
                    memory.ask(query.clone());
                    naive.query = query;
                }
            }
            check_same(&memory, &naive);
        }
    }
}

/// The measured values that a query's words find, of five records.
fn found(words: &[&str]) -> Vec<usize> {
    let records =
        [record((4, 2, 0, 12, 0)), record((5, 1, 1, -2, 0)), record((0, 0, 2, -7, 0)), record((6, 3, 4, 0, 0))];
    let query = Query { words: words.iter().map(|word| FilterWord::new(word)).collect(), ..Query::default() };
    let finds = |record: &Arc<Record>| query.finds(record, &Searched::of(record));
    (0..).zip(&records).filter(|(_, record)| finds(record)).map(|(number, _)| number).collect()
}

#[test]
fn every_word_of_a_filter_must_be_somewhere_in_the_record() {
    for (words, expected) in [
        (vec![], vec![0, 1, 2, 3]),
        (vec!["a2"], vec![0]),
        (vec!["A"], vec![0, 1]),
        // A capital letter of a callout means a hole; small letters find both.
        (vec!["H7"], vec![0, 2]),
        (vec!["h6"], vec![1]),
        (vec!["h"], vec![0, 1, 2]),
        (vec!["25", "H7"], vec![0]),
        (vec!["25.012"], vec![0]),
        (vec!["25,012"], vec![0]),
        (vec!["+12"], vec![0]),
        (vec!["-7"], vec![2]),
        (vec!["\u{2212}7"], vec![2]),
        (vec!["2026-11-21"], vec![0, 1, 2, 3]),
        (vec!["10:42"], vec![0, 1, 2, 3]),
        (vec!["lot", "10.csv"], vec![2]),
        (vec!["lot", "a10"], vec![1]),
        (vec!["nothing"], vec![]),
    ] {
        assert_eq!(found(&words), expected, "{words:?}");
    }
}

#[test]
fn a_number_is_never_given_twice() {
    let mut memory = Memory::default();
    memory.add(vec![record((0, 0, 0, 1, 0)), record((0, 0, 0, 2, 0))]);
    memory.remove(RecordId(1)..RecordId(u64::MAX));
    memory.add(vec![record((0, 0, 0, 3, 0))]);
    let ids: Vec<_> = memory.ids().map(|id| id.0).collect();
    assert_eq!(ids, [0, 2]);
    assert_eq!(memory.get(RecordId(1)), None);
}

#[test]
fn what_is_replaced_stays_in_the_list_and_does_not_count() {
    let mut memory = Memory::default();
    // Good, and too small: rework.
    memory.add(vec![record((0, 0, 0, 12, 0)), record((0, 0, 0, -7, 0))]);
    let all = memory.counts();
    memory.replace(RecordId(1), 9);
    assert_eq!((memory.count(), memory.replaced_by(RecordId(1)), memory.replaced_by(RecordId(0))), (2, Some(9), None));
    assert_eq!(memory.standing().map(|(id, _)| id.0).collect::<Vec<_>>(), [0]);
    assert_eq!((all.iter().sum::<usize>(), memory.counts().iter().sum::<usize>()), (2, 1));
    memory.ask(Query { only_bad: true, ..Query::default() });
    assert_eq!((memory.count(), memory.counts().iter().sum::<usize>()), (0, 0), "what is void is not bad");
    memory.add(vec![record((0, 0, 0, -8, 0))]);
    assert_eq!(memory.count(), 1);
    memory.replace(RecordId(2), 10);
    assert_eq!(memory.count(), 0);
}
