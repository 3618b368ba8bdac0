//! The names in folders, in any case: a folder is listed once, and its names are remembered while it stays as it is.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// How many entries of a folder are compared with a name that differs only by case.
const MOST_ENTRIES: usize = 10_000;
/// How many names of all folders together are remembered: some megabytes.
const MOST_NAMES: usize = 100_000;
/// How many folders are remembered.
const MOST_FOLDERS: usize = 100;

/// The names in the folders that were looked into.
#[derive(Debug, Clone, Default)]
pub(super) struct Names {
    /// The folder that was used last comes first.
    known: Vec<Known>,
    listed: u64,
}

/// The names in a folder.
#[derive(Debug, Clone)]
struct Known {
    folder: PathBuf,
    /// When the folder last changed: its names are those of this time.
    changed: SystemTime,
    /// In the order of their small letters.
    names: Vec<OsString>,
}

impl Names {
    /// The entries of a folder that have this name in any case, in order.
    pub(super) fn find(&mut self, folder: &Path, name: &str) -> Vec<OsString> {
        let wanted = OsStr::new(name).to_ascii_lowercase();
        let Some(known) = self.of(folder) else { return Vec::new() };
        let at = known.names.partition_point(|known| known.to_ascii_lowercase() < wanted);
        let same = known.names.iter().skip(at).take_while(|known| known.eq_ignore_ascii_case(&wanted));
        let mut same: Vec<OsString> = same.cloned().collect();
        same.sort_unstable();
        same
    }

    /// How many times a folder was listed.
    pub(super) const fn listed(&self) -> u64 {
        self.listed
    }

    /// What is remembered of a folder that has not changed since; otherwise it is listed.
    fn of(&mut self, folder: &Path) -> Option<&Known> {
        let changed = changed(folder)?;
        let at = self.known.iter().position(|known| known.folder == folder);
        let known = at.map(|at| self.known.remove(at)).filter(|known| known.changed == changed);
        let known = if let Some(known) = known {
            known
        } else {
            self.listed += 1;
            Known { folder: folder.to_owned(), changed, names: list(folder)? }
        };
        self.known.insert(0, known);
        self.forget();
        self.known.first()
    }

    /// Forgets the folders that were not used for the longest time, if there are too many; never the one used last.
    fn forget(&mut self) {
        let mut names = 0;
        let fits = |known: &Known| {
            names += known.names.len();
            names <= MOST_NAMES
        };
        let kept = self.known.iter().map(fits).take(MOST_FOLDERS).take_while(|fits| *fits).count();
        self.known.truncate(kept.max(1));
    }

    /// Writes into a folder; the new name is remembered with the others, so that the folder need not be listed again.
    pub(super) fn writing<T>(&mut self, folder: &Path, name: &str, write: impl FnOnce() -> T) -> T {
        let before = changed(folder);
        let done = write();
        let is_there = folder.join(name).symlink_metadata().is_ok();
        let after = changed(folder).filter(|_| is_there);
        let known = self.known.iter_mut().find(|known| known.folder == folder && Some(known.changed) == before);
        if let (Some(known), Some(after)) = (known, after) {
            known.changed = after;
            let name = OsString::from(name);
            let key = name.to_ascii_lowercase();
            let at = known.names.partition_point(|known| known.to_ascii_lowercase() < key);
            if known.names.get(at..).is_none_or(|rest| !rest.contains(&name)) {
                known.names.insert(at, name);
            }
        }
        done
    }
}

fn changed(folder: &Path) -> Option<SystemTime> {
    folder.metadata().ok().filter(std::fs::Metadata::is_dir)?.modified().ok()
}

fn list(folder: &Path) -> Option<Vec<OsString>> {
    let entries = std::fs::read_dir(folder).ok()?.take(MOST_ENTRIES).flatten();
    let mut names: Vec<OsString> = entries.map(|entry| entry.file_name()).collect();
    names.sort_by_cached_key(|name| name.to_ascii_lowercase());
    Some(names)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_in_any_case_and_a_folder_is_listed_once_until_it_changes() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path();
        std::fs::create_dir(path.join("Fit")).unwrap();
        let mut names = Names::default();
        for name in ["fit", "FIT", "none", "Fit", "fi", "fitt"] {
            let is_there = name.eq_ignore_ascii_case("fit");
            assert_eq!(names.find(path, name), Vec::from_iter(is_there.then(|| OsString::from("Fit"))), "{name}");
        }
        assert_eq!(names.listed(), 1);
        std::fs::create_dir(path.join("Other")).unwrap();
        // The clock of a file system may stand still between two changes.
        let later = SystemTime::now() + std::time::Duration::from_secs(1);
        std::fs::File::open(path).unwrap().set_modified(later).unwrap();
        assert_eq!((names.find(path, "other"), names.listed()), (vec!["Other".into()], 2));
        names.writing(path, "Third", || std::fs::create_dir(path.join("Third"))).unwrap();
        assert_eq!((names.find(path, "third"), names.listed()), (vec!["Third".into()], 2));
        assert!(names.find(&path.join("none"), "x").is_empty());
    }

    #[test]
    fn only_so_many_folders_are_remembered() {
        let folder = tempfile::tempdir().unwrap();
        let path = |number: usize| folder.path().join(number.to_string());
        let mut names = Names::default();
        for number in 0..2 * MOST_FOLDERS {
            std::fs::create_dir(path(number)).unwrap();
            assert!(names.find(&path(number), "x").is_empty());
        }
        assert_eq!(names.known.len(), MOST_FOLDERS);
        assert_eq!(names.known[0].folder, path(2 * MOST_FOLDERS - 1));
    }
}
