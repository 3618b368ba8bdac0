//! What a page edits and a file holds: opened, changed, saved, and never lost without a question.
//!
//! A page has one [`OpenDocument`] or a list of documents. The trait `PageState` asks it what has unsaved changes, tells it of files that
//! were written, and gives it the answer whether changes may be lost.

use std::ops::{Deref, DerefMut};
use std::path::{Path, PathBuf};

/// Something that is edited and has a file.
pub trait Document {
    /// The name of its file without the folder, or the one that it would get.
    fn name(&self) -> String;

    /// Whether there are changes that no file holds.
    fn is_unsaved(&self) -> bool;
}

/// The file of a document, and what it holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct DocumentFile<T> {
    /// The file that was opened, or saved last.
    path: Option<PathBuf>,
    /// What can be had again: what the file holds, or what a new document begins with.
    kept: Option<T>,
    /// A file that is being written, and what it will hold.
    saving: Option<(PathBuf, T)>,
}

impl<T: Default> Default for DocumentFile<T> {
    /// An empty document.
    fn default() -> Self {
        Self::unnamed(T::default())
    }
}

impl<T> DocumentFile<T> {
    /// A document that nothing holds.
    pub const fn missing() -> Self {
        Self { path: None, kept: None, saving: None }
    }

    /// A document without a file that can be made again as it is.
    pub const fn unnamed(kept: T) -> Self {
        Self { path: None, kept: Some(kept), saving: None }
    }

    /// A document that was read.
    pub const fn read(path: PathBuf, kept: T) -> Self {
        Self { path: Some(path), kept: Some(kept), saving: None }
    }

    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// The file's name without the folder; `new` as long as there is none.
    pub fn name(&self, new: &str) -> String {
        let name = self.path().and_then(Path::file_name);
        name.map_or_else(|| new.to_owned(), |name| name.to_string_lossy().into_owned())
    }

    /// What can be had again.
    pub const fn kept(&self) -> Option<&T> {
        self.kept.as_ref()
    }

    /// The document is being written with this content.
    pub fn save(&mut self, path: &Path, content: T) {
        self.saving = Some((path.to_owned(), content));
    }

    /// A file was written, or not; whether this document was saved by that. One that was not written is forgotten: whatever is written
    /// under its name later is not this document.
    pub fn written(&mut self, path: &Path, is_whole: bool) -> bool {
        let written = self.saving.take_if(|(saving, _)| saving == path).filter(|_| is_whole);
        let is_saved = written.is_some();
        if let Some((path, content)) = written {
            self.path = Some(path);
            self.kept = Some(content);
        }
        is_saved
    }
}

/// The document of a page, and another one that waits for the answer whether unsaved changes may be lost.
///
/// It is used as the document that it shows.
#[derive(Debug, Default)]
pub struct OpenDocument<D> {
    shown: D,
    waiting: Option<D>,
    /// How many documents were opened.
    pub opened: u64,
}

impl<D> Deref for OpenDocument<D> {
    type Target = D;

    fn deref(&self) -> &D {
        &self.shown
    }
}

impl<D> DerefMut for OpenDocument<D> {
    fn deref_mut(&mut self) -> &mut D {
        &mut self.shown
    }
}

impl<D: Document> OpenDocument<D> {
    /// The name of its file without the folder, or the one that it would get.
    pub fn name(&self) -> String {
        self.shown.name()
    }

    /// Whether there are changes that no file holds.
    pub fn is_unsaved(&self) -> bool {
        self.shown.is_unsaved()
    }

    /// Shows another document, or asks first whether changes may be lost; whether it is shown.
    pub(crate) fn open_or_ask(&mut self, document: D) -> bool {
        let opens = !self.shown.is_unsaved();
        if opens {
            self.open(document);
        } else {
            self.waiting = Some(document);
        }
        opens
    }

    /// Shows another document.
    pub(crate) fn open(&mut self, document: D) {
        self.shown = document;
        self.waiting = None;
        self.opened += 1;
    }

    /// The name of the document whose changes are asked about.
    pub(crate) fn asks_about(&self) -> Option<String> {
        self.waiting.as_ref().map(|_| self.shown.name())
    }

    /// It is said whether the changes may be lost; whether another document is shown now.
    pub(crate) fn answer(&mut self, loses: bool) -> bool {
        let waiting = self.waiting.take().filter(|_| loses);
        let opens = waiting.is_some();
        if let Some(document) = waiting {
            self.open(document);
        }
        opens
    }

    /// The name of a document with unsaved changes.
    pub(crate) fn unsaved(&self) -> Vec<String> {
        Some(&self.shown).filter(|shown| shown.is_unsaved()).map(D::name).into_iter().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A document that is one line.
    #[derive(Debug, Default)]
    struct Line {
        text: String,
        file: DocumentFile<String>,
    }

    impl Line {
        fn read(path: &str, text: &str) -> Self {
            Self { text: text.to_owned(), file: DocumentFile::read(PathBuf::from(path), text.to_owned()) }
        }
    }

    impl Document for Line {
        fn name(&self) -> String {
            self.file.name("new")
        }

        fn is_unsaved(&self) -> bool {
            self.file.kept() != Some(&self.text)
        }
    }

    #[test]
    fn changes_wait_for_an_answer_before_they_are_lost() {
        let mut open = OpenDocument::<Line>::default();
        assert!(!open.is_unsaved() && open.name() == "new");
        assert!(open.open_or_ask(Line::read("/a/one.txt", "one")), "nothing is lost with an empty document");
        open.text = "changed".to_owned();
        assert!(!open.open_or_ask(Line::read("/a/two.txt", "two")));
        assert_eq!((open.asks_about(), open.unsaved()), (Some("one.txt".to_owned()), vec!["one.txt".to_owned()]));
        assert!(!open.answer(false) && open.text == "changed" && open.asks_about().is_none());
        assert!(!open.answer(true), "nothing waits any more");
        open.open_or_ask(Line::read("/a/two.txt", "two"));
        assert!(open.answer(true) && open.text == "two" && !open.is_unsaved());
        assert_eq!(open.opened, 2);
    }

    #[test]
    fn a_document_is_saved_as_it_was_when_it_was_written() {
        let path = Path::new("/a/two.txt");
        let mut line = Line::read("/a/one.txt", "one");
        line.text = "two".to_owned();
        line.file.save(path, line.text.clone());
        line.text = "three".to_owned();
        assert!(!line.file.written(Path::new("/a/other.txt"), true), "another file");
        assert!(line.file.written(path, true));
        assert!(line.is_unsaved() && line.name() == "two.txt");
        line.text = "two".to_owned();
        assert!(!line.is_unsaved());
    }

    #[test]
    fn a_file_that_was_not_written_saves_nothing_later() {
        let path = Path::new("/a/two.txt");
        let mut line = Line::read("/a/one.txt", "one");
        line.text = "two".to_owned();
        line.file.save(path, line.text.clone());
        assert!(!line.file.written(path, false) && !line.file.written(path, true));
        assert!(line.is_unsaved() && line.name() == "one.txt");
    }
}
