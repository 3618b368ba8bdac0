//! What a file gets: bytes, or a report that is made while it is written.

use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;

use fitcheck_core::words::Words;
use fitcheck_exchange::journal::entry::{Reported, Shown};
use fitcheck_exchange::proof::SeenFile;
use fitcheck_exchange::report::pairing::Format;
use fitcheck_exchange::report::{ChartFile, Rendering, Report};

use crate::pairing::Paired;
use crate::rows::RowsText;

/// What is written into a file.
#[derive(Debug, Clone)]
pub enum Content {
    /// These bytes.
    Bytes(Vec<u8>),
    /// A report, check by check: one of the whole history would fill the memory.
    Report {
        report: Box<Report>,
        /// How it is written.
        rendering: &'static Rendering,
        /// Its texts.
        words: Arc<Words>,
        /// What it shows of the journal; `None` where the journal has none of its checks.
        shown: Option<Box<Shown>>,
    },
    /// The charts of a feature.
    Chart {
        /// As SVG.
        drawing: String,
        format: ChartFile,
    },
    /// Rows of a large file with their verdicts.
    Rows(Box<RowsText>),
    /// The pairs of measured parts.
    Pairs {
        paired: Arc<Paired>,
        /// How they are written.
        format: &'static Format,
    },
}

impl Content {
    /// Writes it.
    ///
    /// # Errors
    /// The stream's own.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        match self {
            Self::Bytes(bytes) => out.write_all(bytes),
            Self::Report { report, rendering, words, .. } => (rendering.render)(report, words, out),
            Self::Chart { drawing, format } => out.write_all(&format.bytes("", drawing)?),
            Self::Rows(rows) => rows.write(out),
            Self::Pairs { paired, format } => (format.write)(&paired.answer, out),
        }
    }

    /// Whether the journal is told of the file.
    pub const fn is_of_journal(&self) -> bool {
        matches!(self, Self::Report { shown: Some(_), .. })
    }

    /// What the journal is told of the file that was written, once it is whole; `None` where it shows nothing of the journal.
    pub fn reported(&self, path: &Path, file: SeenFile) -> Option<Reported> {
        let Self::Report { report, rendering, shown: Some(shown), .. } = self else { return None };
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        Some(file.reported(name, rendering, &report.title, (**shown).clone()))
    }

    /// All of it in memory.
    ///
    /// # Errors
    /// As for [`Self::write`].
    pub fn bytes(&self) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        self.write(&mut bytes)?;
        Ok(bytes)
    }
}

impl From<Vec<u8>> for Content {
    fn from(bytes: Vec<u8>) -> Self {
        Self::Bytes(bytes)
    }
}

/// Reports are equal that are the same: their checks are not compared one by one.
impl PartialEq for Content {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Bytes(bytes), Self::Bytes(others)) => bytes == others,
            (Self::Report { report, .. }, Self::Report { report: other, .. }) => {
                Arc::ptr_eq(&report.checks, &other.checks)
            }
            (Self::Chart { drawing, format }, Self::Chart { drawing: other, format: other_format }) => {
                (drawing, format) == (other, other_format)
            }
            (Self::Rows(rows), Self::Rows(other)) => rows == other,
            (Self::Pairs { paired, format }, Self::Pairs { paired: other, format: other_format }) => {
                Arc::ptr_eq(paired, other) && format.name == other_format.name
            }
            _ => false,
        }
    }
}
