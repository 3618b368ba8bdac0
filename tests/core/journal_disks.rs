//! A journal on a disk that is full, that may not be written to, or that fails: each is told in its own words, and nothing that was
//! acknowledged is lost. Needs the right to mount; without it each test says that it was skipped.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::Command;

use fitcheck::journal::entry::Entry;
use fitcheck::store::StoreError;
use fitcheck::store::local::{Journal, Opening, Reader, verify};
use tempfile::TempDir;

use super::local_journal::{check, moment};

/// A small disk of its own; unmounted when it goes.
struct Disk {
    folder: TempDir,
}

impl Disk {
    /// `None` where nothing may be mounted.
    fn of(size: &str) -> Option<Self> {
        let disk = Self { folder: tempfile::tempdir().unwrap() };
        let options = format!("size={size}");
        if run(&["mount", "-t", "tmpfs", "-o", &options, "tmpfs"], disk.path()) {
            return Some(disk);
        }
        println!("skipped: no right to mount a small disk");
        None
    }

    fn path(&self) -> &Path {
        self.folder.path()
    }

    fn journal(&self) -> PathBuf {
        self.path().join("journal.sqlite")
    }

    fn open(&self) -> Result<Journal, StoreError> {
        Journal::open(&self.journal(), &Opening { anchors: None, ..Opening::new("Mill 3", moment(0)) })
    }

    fn acknowledged(&self) -> u64 {
        let found = verify(&self.journal(), &[], &mut |_, _| ControlFlow::Continue(())).unwrap();
        assert!(found.is_whole(), "{found:?}");
        found.inspected.entries
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        run(&["umount", "-l"], self.path());
    }
}

fn run(command: &[&str], path: &Path) -> bool {
    Command::new(command[0]).args(&command[1..]).arg(path).output().is_ok_and(|output| output.status.success())
}

fn good(number: u64) -> Entry {
    check("25 H7", "25.012", ["Flange", &number.to_string(), "Anna"])
}

#[test]
fn a_full_disk_is_told_and_loses_nothing() {
    let Some(disk) = Disk::of("1m") else { return };
    let mut journal = disk.open().unwrap();
    let mut acknowledged = 1;
    let error = loop {
        match journal.append(&[good(acknowledged)]) {
            Ok(_) => acknowledged += 1,
            Err(error) => break error,
        }
    };
    assert_eq!(error, StoreError::Full { path: disk.journal() });
    assert!(error.to_string().contains("no space is left"), "{error}");
    assert_eq!(Reader::open(&disk.journal()).unwrap().head().unwrap().number, acknowledged);
    // The same again, and after a restart.
    assert_eq!(journal.append(&[good(0)]), Err(StoreError::Full { path: disk.journal() }));
    drop(journal);
    assert_eq!(disk.acknowledged(), acknowledged);
    // There is room again.
    assert!(run(&["mount", "-o", "remount,size=4m"], disk.path()));
    let mut journal = disk.open().unwrap();
    journal.append(&[good(0)]).unwrap();
    drop(journal);
    assert_eq!(disk.acknowledged(), acknowledged + 1);
    println!("{acknowledged} entries acknowledged before the disk was full, none lost");
}

#[test]
fn a_disk_that_turns_read_only_is_told_and_still_read() {
    let Some(disk) = Disk::of("4m") else { return };
    let mut journal = disk.open().unwrap();
    journal.append(&[good(1)]).unwrap();
    drop(journal);
    assert!(run(&["mount", "-o", "remount,ro"], disk.path()));
    let read_only = StoreError::ReadOnly { path: disk.journal() };
    let error = disk.open().map(drop).unwrap_err();
    assert_eq!(error, read_only);
    assert!(error.to_string().contains("may not be written to"), "{error}");
    assert_eq!(Reader::open(&disk.journal()).unwrap().head().unwrap().number, 2);
    assert_eq!(disk.acknowledged(), 2);
    // No journal can be begun there either.
    let path = disk.path().join("another/journal.sqlite");
    let opening = Opening { anchors: None, ..Opening::new("Mill 3", moment(0)) };
    assert_eq!(Journal::open(&path, &opening).map(drop).unwrap_err(), StoreError::ReadOnly { path });
}
