//! The text of a budget, and the file that holds it.

use std::path::{Path, PathBuf};

use fitcheck_core::budget::template;
use fitcheck_exchange::journal::chain::Hash;
use jiff::ToSpan as _;
use jiff::civil::Date;

use crate::document::{Document, DocumentFile};

/// What a file is called that has no name yet.
const NEW: &str = "budget.toml";

/// A text and its file. Lines end with a line feed here, whatever the file has.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct BudgetDocument {
    pub text: String,
    file: DocumentFile<String>,
    /// SHA-256 of the file's bytes.
    pub(super) sha256: Option<Hash>,
    /// Whether the file's lines end with carriage return and line feed.
    has_returns: bool,
}

impl BudgetDocument {
    /// A new budget, made today and valid for a year.
    pub(super) fn new(today: Date) -> Self {
        let until = today.checked_add(1.year()).and_then(|day| day.checked_sub(1.day())).unwrap_or(today);
        let text = template::text(today, until);
        Self { file: DocumentFile::unnamed(text.clone()), text, ..Self::default() }
    }

    /// What a file holds.
    pub(super) fn read(path: PathBuf, text: &str) -> Self {
        let has_returns = text.contains("\r\n");
        let text = text.strip_prefix('\u{feff}').unwrap_or(text).replace("\r\n", "\n");
        Self { file: DocumentFile::read(path, text.clone()), text, sha256: None, has_returns }
    }

    /// The file that holds this very text.
    pub(super) fn file(&self) -> Option<&Path> {
        self.file.path().filter(|_| !self.is_unsaved())
    }

    fn bytes(&self) -> Vec<u8> {
        let text = if self.has_returns { self.text.replace('\n', "\r\n") } else { self.text.clone() };
        text.into_bytes()
    }

    /// It is being written: the bytes of its file.
    pub(crate) fn save(&mut self, path: &Path) -> Vec<u8> {
        self.file.save(path, self.text.clone());
        self.bytes()
    }

    /// A file was written, or not; whether this budget was saved by that, as it was then.
    pub(super) fn written(&mut self, path: &Path, is_whole: bool) -> bool {
        let is_saved = self.file.written(path, is_whole);
        if is_saved {
            self.sha256 = (!self.is_unsaved()).then(|| Hash::of_file(&self.bytes()));
        }
        is_saved
    }
}

impl Document for BudgetDocument {
    fn name(&self) -> String {
        self.file.name(NEW)
    }

    fn is_unsaved(&self) -> bool {
        self.file.kept() != Some(&self.text)
    }
}
