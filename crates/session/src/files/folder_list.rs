//! The list of a folder in the file dialog: what of it is shown, and which entry is selected.

use std::path::{Path, PathBuf};

use fitcheck_core::message::Message;
use fitcheck_files::{Entry, Listing};

use crate::step::Step;

/// How many entries a page is.
const PAGE: usize = 6;

#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct FolderList {
    /// The endings that fit; none where any will do.
    endings: Vec<&'static str>,
    /// Whether only folders can be chosen.
    wants_folder: bool,
    asked: Option<PathBuf>,
    /// Whether the folder is still to be read.
    is_new: bool,
    read: Option<Box<Listing>>,
    /// Why the folder cannot be read.
    pub problem: Option<Message>,
    filter: String,
    /// Whether files of other kinds and hidden ones are shown.
    pub shows_all: bool,
    /// The entries that are shown, by their numbers.
    shown: Vec<usize>,
    /// Which of the shown entries is selected.
    pub selected: Option<usize>,
}

impl FolderList {
    pub(super) fn new(endings: Vec<&'static str>, wants_folder: bool) -> Self {
        Self { endings, wants_folder, ..Self::default() }
    }

    /// The folder that is shown or being read.
    pub fn folder(&self) -> Option<&Path> {
        self.asked.as_deref().or_else(|| self.read.as_ref().map(|listing| listing.folder.as_path()))
    }

    /// Whether the folder is being read.
    pub const fn is_reading(&self) -> bool {
        self.asked.is_some() && self.problem.is_none()
    }

    /// Whether the folder has more entries than are read.
    pub fn has_more(&self) -> bool {
        self.read.as_ref().is_some_and(|listing| listing.has_more)
    }

    /// How many entries are left out, because they are hidden or of another kind, or because of what was typed.
    pub fn left_out(&self) -> usize {
        self.read.as_ref().map_or(0, |listing| listing.entries.len() - self.shown.len())
    }

    /// How many entries are shown.
    pub const fn len(&self) -> usize {
        self.shown.len()
    }

    /// Whether no entry is shown.
    pub const fn is_empty(&self) -> bool {
        self.shown.is_empty()
    }

    /// A shown entry.
    pub fn entry(&self, number: usize) -> Option<&Entry> {
        self.read.as_ref()?.entries.get(*self.shown.get(number)?)
    }

    /// Whether a path is a folder that the list has, shown or not.
    pub(super) fn has_folder(&self, path: &Path) -> bool {
        let entries = self.read.iter().flat_map(|listing| &listing.entries);
        entries.into_iter().any(|entry| entry.is_folder && entry.path == path)
    }

    pub(super) fn selected_entry(&self) -> Option<&Entry> {
        self.entry(self.selected?)
    }

    /// The folder above.
    pub fn parent(&self) -> Option<&Path> {
        self.folder()?.parent()
    }

    /// Another folder is to be read; its list is empty until then.
    pub(super) fn ask(&mut self, folder: PathBuf) {
        self.asked = Some(folder);
        self.is_new = true;
        self.read = None;
        self.problem = None;
        self.selected = None;
        self.filter.clear();
        self.shown.clear();
    }

    /// The folder to read, once.
    pub(crate) fn take_unread(&mut self) -> Option<PathBuf> {
        std::mem::take(&mut self.is_new).then(|| self.asked.clone()).flatten()
    }

    /// A folder was read; nothing happens where another one is waited for.
    pub(super) fn read(&mut self, folder: &Path, result: Result<Box<Listing>, Message>) {
        if self.asked.as_deref() != Some(folder) {
            return;
        }
        match result {
            Ok(listing) => (self.asked, self.read) = (None, Some(listing)),
            Err(problem) => self.problem = Some(problem),
        }
        self.show();
    }

    pub(super) fn filter(&mut self, typed: &str) {
        // No name in the list contains a path.
        self.filter = if typed.contains(['/', '\\']) { String::new() } else { typed.trim().to_lowercase() };
        self.show();
    }

    pub(super) fn show_all(&mut self, all: bool) {
        self.shows_all = all;
        self.show();
    }

    pub(super) fn select(&mut self, number: usize) {
        self.selected = Some(number).filter(|number| *number < self.shown.len());
    }

    pub(super) fn unselect(&mut self) {
        self.selected = None;
    }

    pub(super) fn step(&mut self, step: Step) {
        let Some(last) = self.shown.len().checked_sub(1) else { return };
        let to = match (self.selected, step) {
            (None, Step::Up | Step::PageUp) | (_, Step::Last | Step::Bottom) => last,
            (None, Step::Down | Step::PageDown) | (_, Step::First | Step::Top) => 0,
            (Some(at), Step::Up) => at.saturating_sub(1),
            (Some(at), Step::Down) => at + 1,
            (Some(at), Step::PageUp) => at.saturating_sub(PAGE),
            (Some(at), Step::PageDown) => at + PAGE,
            (_, Step::Left | Step::Right) => return,
        };
        self.selected = Some(to.min(last));
    }

    /// Works out which entries are shown; what was selected no longer is.
    fn show(&mut self) {
        self.selected = None;
        let Some(listing) = &self.read else { return self.shown.clear() };
        let is_shown = |entry: &Entry| {
            let fits = entry.is_folder || self.endings.is_empty() || entry.ends_with(&self.endings);
            (self.shows_all || (fits && !entry.is_hidden()))
                && (entry.is_folder || !self.wants_folder)
                && entry.name.to_lowercase().contains(&self.filter)
        };
        let numbered = listing.entries.iter().enumerate();
        self.shown = numbered.filter(|(_, entry)| is_shown(entry)).map(|(number, _)| number).collect();
    }
}
