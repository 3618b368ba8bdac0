//! How long it takes to take in a file of many rows, in one run with what `fitcheck batch` does with the same file: the budget of every
//! lot is twice that. The lot of the window keeps a mark for each row and hashes the file as it is read; the pairing page keeps the
//! sizes, of half as many rows, which is all that it takes; an import makes a whole check of each row.
#![expect(clippy::expect_used, reason = "a bench may stop")]

use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, Cursor, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use fitcheck::batch::{Input, Manner, Packing, Sink, Stream, Watch, run, run_into, workers};
use fitcheck::exchange::batch::{BLOCK, Block, Csv, Cutter, Marks, Part, Store, StreamJudging, Tally};
use fitcheck::exchange::{ImportInputs, import_from, sizes};
use fitcheck::files;
use fitcheck::journal::chain::FileHash;
use fitcheck::tolerance::{Feature, Sources};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};

/// So many rows of holes of usual classes, with values around their zones.
fn rows(folder: &Path, count: u64) -> PathBuf {
    const CLASSES: [&str; 8] = ["H7", "H8", "JS7", "K7", "F8", "G7", "H6", "D10"];
    let mut random = ChaCha8Rng::seed_from_u64(8255);
    let mut even = |most: u32| random.next_u32() % most;
    let mut text = "id;callout;measured\n".to_owned();
    for row in 0..count {
        let (tenths, class) =
            (60 + even(3_900), CLASSES.iter().cycle().nth(usize::try_from(even(8)).unwrap_or_default()));
        let nm = u64::from(tenths) * 100_000 + u64::from(even(500)) * 100;
        let class = class.expect("a class");
        writeln!(text, "P{row:08};{}.{} {class};{}.{:04}", tenths / 10, tenths % 10, nm / 1_000_000, nm / 100 % 10_000)
            .expect("memory");
    }
    let path = folder.join(format!("{count}.csv"));
    files::write(&path, text.as_bytes()).expect("a file");
    path
}

/// Reads a file and hashes what is read.
struct Hashed(File, FileHash);

impl Read for Hashed {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        let read = self.0.read(to)?;
        self.1.see(to.get(..read).unwrap_or_default());
        Ok(read)
    }
}

/// What the window keeps.
#[derive(Default)]
struct Kept {
    store: Store,
    parts: Vec<Arc<Part>>,
    tally: Tally,
}

impl Sink<Marks> for Kept {
    fn take(&mut self, made: &mut Marks, block: &Block, tally: &Tally) -> io::Result<()> {
        self.parts.push(Arc::new(self.store.part(made, block, tally)));
        self.tally.add(tally.clone());
        Ok(())
    }
}

/// As `fitcheck batch FILE -o FILE` does it.
fn batch(path: &Path, to: &Path, sources: &Sources) -> u64 {
    let mut stream = Stream::of(Box::new(File::open(path).expect("the rows"))).expect("a head");
    let layout = stream.layout(true, "rows.csv").expect("a head").expect("columns");
    let court = StreamJudging::new(&layout, sources);
    let mut input = Cursor::new(stream.head.get(layout.skip..).unwrap_or_default()).chain(stream.input);
    let mut rows = 0;
    files::write_with(to, &mut |out| {
        let input = Input { stream: &mut input, cutter: Cutter::new(layout.separator(), BLOCK, true) };
        let manner = Manner { workers: workers(), packing: Packing::Plain, prefix: "" };
        rows = run::<Csv>(input, &court, manner, out, &Watch::default(), &mut |_| {}).expect("verdicts").tally.rows;
        Ok(())
    })
    .expect("a file");
    rows
}

/// As the window does it with a file that is dropped on the check page.
fn lot(path: &Path, sources: &Sources) -> usize {
    let input = Hashed(File::open(path).expect("the rows"), FileHash::default());
    let mut stream = Stream::of(Box::new(input)).expect("a head");
    let layout = stream.layout(true, "rows.csv").expect("a head").expect("columns");
    let court = StreamJudging::new(&layout, sources);
    let mut kept = Kept::default();
    let mut input = Cursor::new(stream.head.get(layout.skip..).unwrap_or_default()).chain(stream.input);
    let input = Input { stream: &mut input, cutter: Cutter::new(layout.separator(), BLOCK, true) };
    let making: (usize, &(dyn Fn() -> Marks + Sync)) = (workers(), &Marks::default);
    run_into(input, &court, making, &mut kept, &Watch::default(), &mut |_| {}).expect("verdicts");
    kept.parts.iter().map(|part| part.len()).sum()
}

fn lots(criterion: &mut Criterion) {
    let folder = tempfile::tempdir().expect("a folder");
    let (sources, now) = (Sources::default(), jiff::civil::date(2026, 11, 24).at(10, 42, 7, 0));
    for count in [1_000_000, 500_000] {
        let path = rows(folder.path(), count);
        let mut group = criterion.benchmark_group(format!("{count} rows"));
        group.sample_size(10).throughput(Throughput::Elements(count));
        group.bench_function("batch", |bencher| {
            bencher.iter(|| assert_eq!(batch(&path, &folder.path().join("verdicts.csv"), &sources), count));
        });
        group.bench_function("the lot of the window", |bencher| {
            bencher.iter(|| assert_eq!(u64::try_from(lot(&path, &sources)), Ok(count)));
        });
        if count <= 500_000 {
            group.bench_function("sizes for pairing", |bencher| {
                bencher.iter(|| {
                    let bytes = files::read(&path).expect("the rows");
                    assert_eq!(u64::try_from(sizes("rows.csv", &bytes, Feature::Hole).measured.len()), Ok(count));
                });
            });
        }
        group.bench_function("checks of an import", |bencher| {
            bencher.iter(|| {
                let mut made = 0;
                let mut file = File::open(&path).expect("the rows");
                import_from("rows.csv", &mut file, ImportInputs::new(&sources, now), &mut |_| made += 1);
                assert!(count <= made);
            });
        });
        group.finish();
    }
}

criterion_group!(benches, lots);
criterion_main!(benches);
