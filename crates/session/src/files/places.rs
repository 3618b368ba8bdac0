//! Where files were: the last folder of each kind, and the files that were read last.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::command::ReadOutcome;
use crate::purpose::Purpose;
use crate::saved::{SavedFile, SavedFiles};

/// How many files are remembered.
const MOST_RECENT: usize = 10;

/// A file that was read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecentFile {
    /// What it was read for.
    pub purpose: Purpose,
    pub path: PathBuf,
}

#[derive(Debug, Default)]
pub(crate) struct Places {
    /// The user's own folder, where there is one.
    pub home: Option<PathBuf>,
    /// By kind of thing.
    folders: BTreeMap<String, PathBuf>,
    /// The one that was used last.
    last: Option<PathBuf>,
    pub recent: Vec<RecentFile>,
}

impl Places {
    pub fn restore(saved: SavedFiles) -> Self {
        // A kind of a later version is left out.
        let recent = saved.recent.into_iter().filter_map(|file| {
            let purpose = Purpose::reading(&file.kind)?;
            Some(RecentFile { purpose, path: file.path })
        });
        let recent = recent.take(MOST_RECENT).collect();
        Self { home: None, folders: saved.folders, last: saved.last_folder, recent }
    }

    /// What survives a restart. A path that is not text cannot be written, and is left out.
    pub fn saved(&self) -> SavedFiles {
        let is_text = |path: &Path| path.to_str().is_some();
        let folders = self.folders.iter().filter(|(_, folder)| is_text(folder));
        let recent = self.recent.iter().filter(|file| is_text(&file.path));
        SavedFiles {
            last_folder: self.last.clone().filter(|folder| is_text(folder)),
            folders: folders.map(|(kind, folder)| (kind.clone(), folder.clone())).collect(),
            recent: recent
                .map(|file| SavedFile { kind: file.purpose.kind().to_owned(), path: file.path.clone() })
                .collect(),
        }
    }

    /// The folder that a dialog begins with: the last one of its kind, else the last one, else the user's own.
    pub fn folder(&self, purpose: Purpose) -> Option<&Path> {
        self.folders.get(purpose.kind()).or(self.last.as_ref()).or(self.home.as_ref()).map(PathBuf::as_path)
    }

    /// Every folder that was used last for something, each once.
    pub fn folders(&self) -> Vec<&Path> {
        let mut folders: Vec<&Path> = Vec::new();
        for folder in self.last.iter().chain(self.folders.values()) {
            if !folders.contains(&folder.as_path()) {
                folders.push(folder);
            }
        }
        folders
    }

    pub fn forget(&mut self) {
        self.recent.clear();
    }

    /// A file was read or written: its folder is the last one.
    pub fn used(&mut self, purpose: Purpose, path: &Path) {
        let Some(folder) = path.parent().filter(|folder| folder.is_absolute()) else { return };
        self.folders.insert(purpose.kind().to_owned(), folder.to_owned());
        self.last = Some(folder.to_owned());
    }

    /// A file was looked for: it comes first among the recent ones, or is taken from them where it is gone.
    pub fn seen(&mut self, purpose: Purpose, path: PathBuf, fate: ReadOutcome) {
        if purpose == Purpose::UseBudget {
            // It is read at every start: that says nothing of what the user does now.
            return;
        }
        if purpose.is_folder() {
            // A folder is no file, and that of tables is read at every start: that says nothing of what the user does now.
            if fate == ReadOutcome::Read {
                self.folders.insert(purpose.kind().to_owned(), path);
            }
            return;
        }
        let file = RecentFile { purpose, path };
        if fate != ReadOutcome::Refused {
            self.recent.retain(|known| *known != file);
        }
        if fate == ReadOutcome::Read {
            self.used(purpose, &file.path);
            self.recent.insert(0, file);
            self.recent.truncate(MOST_RECENT);
        }
    }
}
