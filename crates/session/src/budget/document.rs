//! The text of a budget, and the file that holds it.

use std::path::{Path, PathBuf};

use fitcheck_core::budget::template;
use fitcheck_exchange::journal::chain::Hash;
use jiff::ToSpan as _;
use jiff::civil::Date;

/// What a file is called that has no name yet.
const NEW: &str = "budget.toml";

/// A text and its file. Lines end with a line feed here, whatever the file has.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Document {
    pub text: String,
    /// The file that was opened, or saved last.
    path: Option<PathBuf>,
    /// The text that can be had again.
    kept: String,
    /// SHA-256 of the file's bytes.
    pub sha256: Option<Hash>,
    /// Whether the file's lines end with carriage return and line feed.
    has_returns: bool,
}

impl Document {
    /// A new budget, made today and valid for a year.
    pub fn new(today: Date) -> Self {
        let until = today.checked_add(1.year()).and_then(|day| day.checked_sub(1.day())).unwrap_or(today);
        let text = template::text(today, until);
        Self { kept: text.clone(), text, ..Self::default() }
    }

    /// What a file holds.
    pub fn read(path: PathBuf, text: &str) -> Self {
        let has_returns = text.contains("\r\n");
        let text = text.strip_prefix('\u{feff}').unwrap_or(text).replace("\r\n", "\n");
        Self { kept: text.clone(), text, path: Some(path), sha256: None, has_returns }
    }

    /// The file's name without the folder.
    pub fn name(&self) -> String {
        let name = self.path.as_deref().and_then(Path::file_name);
        name.map_or_else(|| NEW.to_owned(), |name| name.to_string_lossy().into_owned())
    }

    /// The file that holds this very text.
    pub fn file(&self) -> Option<&Path> {
        self.path.as_deref().filter(|_| !self.is_unsaved())
    }

    /// Whether there are changes that no file holds.
    pub fn is_unsaved(&self) -> bool {
        self.text != self.kept
    }

    /// The bytes of its file.
    pub fn bytes(&self) -> Vec<u8> {
        let text = if self.has_returns { self.text.replace('\n', "\r\n") } else { self.text.clone() };
        text.into_bytes()
    }

    /// A file holds this text from now on.
    pub fn saved(&mut self, path: &Path, text: String) {
        let is_this = text == self.text;
        (self.path, self.kept) = (Some(path.to_owned()), text);
        self.sha256 = is_this.then(|| Hash::of_file(&self.bytes()));
    }
}
