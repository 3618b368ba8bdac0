//! The journal of a station: adding a check beside what a bare table needs for the same bytes and the same durability, and questions to a
//! journal of a million checks.
#![expect(clippy::expect_used, clippy::indexing_slicing, reason = "a bench may stop")]

use std::hint::black_box;
use std::ops::ControlFlow;
use std::path::Path;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use fitcheck::journal::Record;
use fitcheck::journal::ask::Question;
use fitcheck::journal::body;
use fitcheck::journal::entry::{About, Check, Checked, Content, Entry, Moment};
use fitcheck::length::Length;
use fitcheck::probing::{Measurement, Origin};
use fitcheck::store::local::{Journal, Opening, Reader, verify};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::Status;
use rusqlite::{Connection, params};

const MILLION: u64 = 1_000_000;
/// 2026-01-01 in UTC.
const NEW_YEAR: i64 = 1_767_225_600_000;

fn moment(utc_ms: i64) -> Moment {
    Moment { utc_ms, offset_min: 60, zone: "Europe/Amsterdam".to_owned() }
}

/// A check of four parts in a thousand lots, one in some thirty of them not good.
fn entry(number: u64) -> Entry {
    let callout =
        ["25 H7", "12 g6", "40 H8", "8 H11"][usize::try_from(number % 4).expect("small")].parse().expect("callout");
    let limits = Sources::default().limits(&callout, None).expect("limits");
    let off = i64::try_from(number * 7919 % 1000).expect("small");
    let width = limits.deviations.width().nanometres();
    let nm = limits.minimum().nanometres() + width * (off - 15) / 970;
    let measurement = Measurement::of_diameter(Length::from_nanometres(nm).expect("length"), Origin::Typed);
    let time = jiff::civil::date(2026, 1, 1).at(8, 0, 0, 0);
    let part = format!("Flange {}", number / 1000);
    let record = Record::judged(time, part.clone(), Some(callout), limits, measurement, None);
    let about = About {
        station: "Mill 3".to_owned(),
        time: moment(NEW_YEAR + i64::try_from(number).expect("small") * 20_000),
        who: ["Anna", "Bert", "Cem"][usize::try_from(number / 4000 % 3).expect("small")].to_owned(),
        part,
        serial: format!("S{number:07}"),
        feature: format!("B{}", number % 4 + 1),
        remark: if number.is_multiple_of(100) { "deburred before measuring".to_owned() } else { String::new() },
    };
    let what = Checked::Size(record.into());
    Entry { about, content: Content::Check(Box::new(Check { what, files: Vec::new(), corrects: None })) }
}

fn open(path: &Path) -> Journal {
    let opening = Opening { anchors: None, ..Opening::new("Mill 3", moment(NEW_YEAR)) };
    Journal::open(path, &opening).expect("journal")
}

/// A table with the same bytes, and nothing that finds or keeps them.
fn bare(path: &Path) -> Connection {
    let connection = Connection::open(path).expect("database");
    connection.query_row("PRAGMA journal_mode = WAL", [], |_row| Ok(())).expect("log");
    connection
        .execute_batch(
            "PRAGMA synchronous = FULL; CREATE TABLE entry(number INTEGER PRIMARY KEY, body BLOB, hash BLOB)",
        )
        .expect("table");
    connection
}

fn appending(criterion: &mut Criterion) {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).expect("folder");
    let mut group = criterion.benchmark_group("one check, on the disk");
    group.sample_size(50);
    let table = bare(&folder.path().join("bare.sqlite"));
    let bytes = body::write(&entry(1)).expect("body");
    group.bench_function("bare SQLite", |bencher| {
        bencher.iter(|| {
            table
                .prepare_cached("INSERT INTO entry(body, hash) VALUES (?1, ?2)")
                .and_then(|mut insert| insert.execute(params![black_box(&bytes), [0_u8; 32]]))
                .expect("row")
        });
    });
    let mut journal = open(&folder.path().join("journal.sqlite"));
    let mut number = 0;
    group.bench_function("journal", |bencher| {
        bencher.iter_batched(
            || {
                number += 1;
                [entry(number)]
            },
            |entries| journal.append(black_box(&entries)).expect("entry"),
            BatchSize::SmallInput,
        );
    });
}

/// A journal of a million checks.
fn make(path: &Path) {
    let mut journal = open(path);
    for lot in 0..MILLION / 10_000 {
        let entries: Vec<Entry> = (lot * 10_000..(lot + 1) * 10_000).map(entry).collect();
        journal.append(&entries).expect("entries");
    }
}

fn asking(criterion: &mut Criterion) {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).expect("folder");
    let path = folder.path().join("journal.sqlite");
    make(&path);
    let reader = Reader::open(&path).expect("journal");
    let text = |text: &str| Some(text.to_owned());
    let hours = |hours: i64| Some(NEW_YEAR + hours * 3_600_000);
    let none = Question::default;
    let mut group = criterion.benchmark_group("first page of a million");
    group.sample_size(10);
    for (name, question) in [
        ("everything", none()),
        ("a part", Question { part: text("flange 500"), ..none() }),
        ("the oldest part", Question { part: text("flange 0"), ..none() }),
        ("no part", Question { part: text("none"), ..none() }),
        ("a serial number", Question { serial: text("s0000017"), ..none() }),
        ("serial numbers that begin so", Question { serial: text("s00000*"), ..none() }),
        ("scrap", Question { verdicts: vec![Status::Scrap], ..none() }),
        ("not good", Question { verdicts: vec![Status::Rework, Status::ReMeasure, Status::Scrap], ..none() }),
        ("who", Question { who: text("anna"), ..none() }),
        ("who and scrap", Question { who: text("anna"), verdicts: vec![Status::Scrap], ..none() }),
        ("who and part, none", Question { who: text("bert"), part: text("flange 0"), ..none() }),
        ("callout and feature, none", Question { callout: text("25 H7"), feature: text("B2"), ..none() }),
        (
            "who and feature and re-measure, none",
            Question { who: text("anna"), feature: text("B2"), verdicts: vec![Status::ReMeasure], ..none() },
        ),
        ("the first day", Question { from_ms: hours(0), before_ms: hours(24), ..none() }),
        (
            "scrap of the first day",
            Question { from_ms: hours(0), before_ms: hours(24), verdicts: vec![Status::Scrap], ..none() },
        ),
        ("the first month", Question { from_ms: hours(0), before_ms: hours(24 * 31), ..none() }),
        (
            "part of a day without it",
            Question { from_ms: hours(0), before_ms: hours(24), part: text("flange 900"), ..none() },
        ),
        ("the last day", Question { from_ms: hours(24 * 231), ..none() }),
        ("a word", Question { words: vec!["deburred".to_owned()], ..none() }),
        ("the beginning of a frequent word", Question { words: vec!["fl".to_owned()], ..none() }),
        ("two words, none", Question { words: vec!["deburred".to_owned(), "s0000001".to_owned()], ..none() }),
        ("a word that is not there", Question { words: vec!["chamfer".to_owned()], ..none() }),
        ("simulated, none", Question { simulated: Some(true), ..none() }),
        ("standing", Question { standing: true, ..none() }),
    ] {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                let numbers = reader.numbers(black_box(&question), None, 200).expect("numbers");
                reader.rows(&numbers).expect("rows").len()
            });
        });
    }
    group.finish();
    let mut group = criterion.benchmark_group("a million");
    group.sample_size(10);
    group.bench_function("verified", |bencher| {
        bencher.iter(|| verify(&path, &[], &mut |_done, _all| ControlFlow::Continue(())).expect("journal").is_whole());
    });
    group.bench_function("all numbers", |bencher| {
        bencher.iter(|| reader.numbers(&none(), None, usize::MAX).expect("numbers").len());
    });
    group.bench_function("good counted", |bencher| {
        bencher.iter(|| reader.count(&Question { verdicts: vec![Status::Good], ..none() }, u64::MAX).expect("count"));
    });
}

criterion_group!(benches, appending, asking);
criterion_main!(benches);
