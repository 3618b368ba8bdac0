//! Every fuzz target on its seeds and on changes of them, in this process and without an engine.
//!
//! Each target gets `FUZZ_INPUTS` changes of its seeds, the same on every machine: they follow from `FUZZ_SEED` alone.
//! With `FUZZ_SECONDS` all targets together take this time instead, and with `FUZZ_TARGET` only one of them runs.
//! `fuzz/campaign` searches with coverage, and for hours.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use crate::fuzz_targets::{TARGETS, Target};

/// Inputs for each target where nothing else is asked for.
const INPUTS: usize = 400;

/// The longest input that is made.
const LONGEST: usize = 4096;

/// Longer than any input takes, even on a slow machine that does other things as well.
const SLOW: Duration = Duration::from_mins(2);

fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus")
}

pub(crate) fn variable<T: FromStr>(name: &str) -> Option<T> {
    let text = std::env::var(name).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{name}={text} is not a number")))
}

/// The seeds of a target in the order of their names.
fn seeds(target: &Target) -> Vec<Vec<u8>> {
    let folder = corpus().join(target.name);
    let files = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
    paths.sort();
    paths.into_iter().map(|path| std::fs::read(path).unwrap()).collect()
}

/// The words of a dictionary of libFuzzer: `"a\x0a"` a line.
fn words(dictionary: &str) -> Vec<Vec<u8>> {
    let lines = dictionary.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
    let word = |line: &str| {
        let mut bytes = line.strip_prefix('"').and_then(|line| line.strip_suffix('"')).unwrap().bytes();
        let mut word = Vec::new();
        while let Some(byte) = bytes.next() {
            word.push(match (byte, if byte == b'\\' { bytes.next().unwrap() } else { 0 }) {
                (b'\\', b'x') => {
                    let digits = [bytes.next().unwrap(), bytes.next().unwrap()];
                    u8::from_str_radix(std::str::from_utf8(&digits).unwrap(), 16).unwrap()
                }
                (b'\\', escaped) => escaped,
                (byte, _) => byte,
            });
        }
        word
    };
    lines.map(word).collect()
}

/// Random numbers that follow from a seed (`SplitMix64`).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) const fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    pub(crate) fn below(&mut self, end: usize) -> usize {
        usize::try_from(self.next() % u64::try_from(end.max(1)).unwrap()).unwrap()
    }

    fn range(&mut self, length: usize) -> std::ops::Range<usize> {
        let start = self.below(length + 1);
        start..start + self.below((length - start).min(64) + 1)
    }

    fn byte(&mut self) -> u8 {
        self.next().to_le_bytes()[0]
    }
}

/// Numbers at the borders of something, and texts that are nearly numbers.
const NUMBERS: [&str; 12] =
    ["0", "1", "-1", "0.000001", "0.0000001", "99999.9999", "3.000001", "1e9", "1000000000", "65536", "1.2.3", "٣"];

/// One to six changes of an input.
fn changed(input: &mut Vec<u8>, others: &[Vec<u8>], words: &[Vec<u8>], random: &mut Random) {
    for _ in 0..=random.below(6) {
        let (length, at) = (input.len(), random.below(input.len() + 1));
        match random.below(10) {
            0 if at < length => input[at] ^= 1_u8 << random.below(8),
            1 if at < length => input[at] = random.byte(),
            2 => drop(input.splice(at..at, [random.byte()])),
            3 => drop(input.drain(random.range(length))),
            4 => {
                let copy = input[random.range(length)].to_vec();
                drop(input.splice(at..at, copy));
            }
            5 | 6 if !words.is_empty() => {
                let word = &words[random.below(words.len())];
                // In place of something, or in between.
                let end = if random.below(2) == 0 { at } else { (at + word.len()).min(length) };
                drop(input.splice(at..end, word.iter().copied()));
            }
            7 => {
                let is_digit = |byte: &u8| byte.is_ascii_digit();
                if let Some(start) = input[at..].iter().position(is_digit).map(|digit| at + digit) {
                    let end =
                        input[start..].iter().position(|byte| !is_digit(byte)).map_or(length, |digits| start + digits);
                    drop(input.splice(start..end, NUMBERS[random.below(NUMBERS.len())].bytes()));
                }
            }
            8 if !others.is_empty() => {
                let other = &others[random.below(others.len())];
                let part = other[random.range(other.len())].to_vec();
                drop(input.splice(at..at, part));
            }
            _ => input.truncate(at),
        }
    }
    input.truncate(LONGEST);
}

/// What runs now, since when; a thread watches it.
type Watched = Arc<Mutex<Option<(&'static str, Vec<u8>, Instant)>>>;

fn watch() -> Watched {
    let watched: Watched = Arc::default();
    let watching = Arc::downgrade(&watched);
    let watch = move || {
        while let Some(now) = watching.upgrade() {
            if let Some((name, input, since)) = now.lock().unwrap_or_else(PoisonError::into_inner).as_ref()
                && SLOW < since.elapsed()
            {
                eprintln!("{}", found(name, input, "takes too long"));
                std::process::abort();
            }
            std::thread::sleep(Duration::from_millis(500));
        }
    };
    std::thread::Builder::new().name("watch".to_owned()).spawn(watch).unwrap();
    watched
}

/// Keeps an input and says where.
fn found(name: &str, input: &[u8], what: &str) -> String {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("fuzz-{name}"));
    let kept = std::fs::File::create(&path).and_then(|mut file| std::io::Write::write_all(&mut file, input));
    let mut said = format!("{name}: {what}\n{:?}\n", String::from_utf8_lossy(input));
    writeln!(said, "kept as {} ({kept:?})", path.display()).unwrap();
    said
}

fn run(target: &Target, input: &[u8], watched: &Watched) {
    let set = |now| *watched.lock().unwrap_or_else(PoisonError::into_inner) = now;
    set(Some((target.name, input.to_vec(), Instant::now())));
    let answer = catch_unwind(AssertUnwindSafe(|| (target.run)(input)));
    set(None);
    assert!(answer.is_ok(), "{}", found(target.name, input, "does not hold"));
}

#[test]
fn every_target_holds_on_its_seeds_and_on_changes_of_them() {
    let (seconds, asked): (Option<f64>, Option<usize>) = (variable("FUZZ_SECONDS"), variable("FUZZ_INPUTS"));
    let most = asked.unwrap_or(INPUTS);
    let mut random = Random(variable("FUZZ_SEED").unwrap_or(1));
    let watched = watch();
    let only: Option<String> = variable("FUZZ_TARGET");
    let chosen: Vec<&Target> =
        TARGETS.iter().filter(|target| only.as_ref().is_none_or(|only| target.name == only)).collect();
    assert!(!chosen.is_empty(), "FUZZ_TARGET={only:?} is no target");
    for (number, target) in (0_u32..).zip(&chosen) {
        let (begin, seeds, words) = (Instant::now(), seeds(target), words(target.words));
        for seed in &seeds {
            run(target, seed, &watched);
        }
        let mut own = Random(random.next() ^ u64::from(number));
        let time =
            seconds.map(|seconds| Duration::from_secs_f64(seconds / f64::from(u32::try_from(chosen.len()).unwrap())));
        let mut inputs = 0;
        while time.map_or(inputs < most, |time| begin.elapsed() < time) {
            let mut input = seeds[own.below(seeds.len())].clone();
            changed(&mut input, &seeds, &words, &mut own);
            run(target, &input, &watched);
            inputs += 1;
        }
        if time.is_some() || asked.is_some() {
            let took = begin.elapsed().as_secs_f64();
            println!("{:16} {:4} seeds {inputs:8} changes of them {took:6.1} s", target.name, seeds.len());
        }
    }
}

#[test]
fn every_target_has_seeds_and_every_folder_of_seeds_its_target() {
    let folders: BTreeSet<String> =
        std::fs::read_dir(corpus()).unwrap().map(|folder| folder.unwrap().file_name().into_string().unwrap()).collect();
    let names: BTreeSet<String> = TARGETS.iter().map(|target| target.name.to_owned()).collect();
    assert_eq!(folders, names);
    let sizes: Vec<usize> = TARGETS.iter().flat_map(seeds).map(|seed| seed.len()).collect();
    assert!(sizes.iter().sum::<usize>() < 300_000, "seeds of {} bytes", sizes.iter().sum::<usize>());
}

#[test]
fn the_fuzzing_readme_lists_every_target() {
    let readme = std::fs::read_to_string(corpus().with_file_name("README.md")).unwrap();
    let rows = readme.lines().filter_map(|line| line.strip_prefix("| `")?.split_once('`'));
    let named: Vec<&str> = rows.map(|(name, _)| name).collect();
    assert_eq!(named, TARGETS.iter().map(|target| target.name).collect::<Vec<_>>());
}

#[test]
fn words_of_a_dictionary_are_their_bytes() {
    assert_eq!(words("# x\n\"a\\x0a\\\"\\\\\"\n\n\"\\xef\""), [b"a\n\"\\".to_vec(), vec![0xef]]);
}
