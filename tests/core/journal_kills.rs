//! Two programs record checks in one journal and are killed at random moments, again and again: nothing that was acknowledged is lost.
//!
//! `FITCHECK_KILLS=1000 cargo test --no-default-features --test core journal_kills -- --nocapture` runs the whole campaign.

use std::collections::BTreeSet;
use std::io::Write as _;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use fitcheck::store::local::{Journal, Opening, Reader, verify};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};

use super::local_journal::{check, moment};

/// Where a child records; only set for children.
const JOURNAL: &str = "FITCHECK_KILLED_JOURNAL";

/// Records until it is killed, and writes the serial number of each check behind it, once it is acknowledged.
#[test]
fn a_child_records_until_it_is_killed() {
    let Some(folder) = std::env::var_os(JOURNAL).map(PathBuf::from) else { return };
    let mut journal = Journal::open(&folder.join("journal.sqlite"), &opening(&folder)).unwrap();
    let id = std::process::id();
    let name = folder.join(format!("acknowledged-{id}"));
    let mut acknowledged = std::fs::OpenOptions::new().create(true).append(true).open(name).unwrap();
    for number in 0.. {
        let serial = format!("{id}-{number}");
        journal.append(&[check("25 H7", "25.012", ["Flange", &serial, "Anna"])]).unwrap();
        acknowledged.write_all(format!("{serial}\n").as_bytes()).unwrap();
    }
}

fn opening(folder: &Path) -> Opening {
    Opening { anchors: Some(folder.join("heads.txt")), ..Opening::new("Mill 3", moment(0)) }
}

fn child(folder: &Path) -> Child {
    Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "journal_kills::a_child_records_until_it_is_killed"])
        .env(JOURNAL, folder)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

/// Takes the serial numbers that children wrote behind acknowledged checks; a line without its end was not written whole.
fn acknowledged(folder: &Path) -> Vec<String> {
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let ours = files.filter(|path| path.file_name().unwrap().to_string_lossy().starts_with("acknowledged"));
    let take = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).unwrap();
        std::fs::remove_file(path).unwrap();
        text
    };
    let texts: Vec<String> = ours.map(take).collect();
    let lines = texts.iter().flat_map(|text| text.split_inclusive('\n'));
    lines.filter_map(|line| line.strip_suffix('\n')).map(str::to_owned).collect()
}

fn until_it_records(folder: &Path, child: &Child) {
    let path = folder.join(format!("acknowledged-{}", child.id()));
    let begun = Instant::now();
    while std::fs::metadata(&path).map_or(0, |found| found.len()) == 0 {
        assert!(begun.elapsed() < Duration::from_mins(5), "it never records");
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn nothing_that_was_acknowledged_is_lost_however_often_writers_are_killed() {
    let kills: u32 = std::env::var("FITCHECK_KILLS").map_or(20, |count| count.parse().unwrap());
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let mut random = ChaCha8Rng::seed_from_u64(16);
    let begun = Instant::now();
    let mut all = Vec::new();
    for round in 0..kills.div_ceil(2) {
        let mut pair = [child(folder), child(folder)];
        for one in &mut pair {
            // Every other time while it begins; else once it records, however long the machine takes for that.
            if round % 2 == 0 {
                until_it_records(folder, one);
            }
            std::thread::sleep(Duration::from_millis(u64::from(5 + random.next_u32() % 90)));
            one.kill().unwrap();
        }
        for mut one in pair {
            one.wait().unwrap();
        }
        all.extend(acknowledged(folder));
    }
    let path = folder.join("journal.sqlite");
    let journal = Journal::open(&path, &opening(folder)).unwrap();
    assert!(journal.remarks().is_empty(), "{:?}", journal.remarks());
    let found = verify(&path, &[], &mut |_, _| ControlFlow::Continue(())).unwrap();
    assert!(found.is_whole(), "{found:?}");
    let reader = Reader::open(&path).unwrap();
    let numbers: Vec<u64> = (2..=found.inspected.entries).collect();
    let rows = reader.rows(&numbers).unwrap();
    let kept: Vec<String> = rows.into_iter().map(|row| row.entry.unwrap().about.serial).collect();
    let lost: Vec<&String> = {
        let there: BTreeSet<&String> = kept.iter().collect();
        all.iter().filter(|serial| !there.contains(serial)).collect()
    };
    println!(
        "{kills} kills in {:.1} s: {} checks acknowledged, {} lost, {} kept though never acknowledged, chain of {} whole",
        begun.elapsed().as_secs_f64(),
        all.len(),
        lost.len(),
        kept.len() - (all.len() - lost.len()),
        found.inspected.entries,
    );
    assert!(lost.is_empty(), "{lost:?}");
    assert!(all.len() <= kept.len());
    assert!(all.len() >= usize::try_from(kills / 2).unwrap(), "children record");
}
