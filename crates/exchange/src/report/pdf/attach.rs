//! The data of a report as files within the PDF: what JSON and CSV write, byte for byte, so that a machine can read what a person signed.

use std::io::{self, Write};
use std::sync::Arc;

use fitcheck_core::words::Words;
use sha2::{Digest as _, Sha256};

use crate::journal::chain::hex;
use crate::report::seen::ReportSurvey;
use crate::report::{Rendering, Report, csv, json};

/// The largest file that is attached: what is larger is no page to read, and both would be in memory at once.
pub(super) const MOST: usize = 32 << 20;

/// What belongs to a report: how a file of its data is written, its name and what it is.
const DATA: [(&Rendering, &str, &str); 2] =
    [(&json::RENDERING, "report.json", "application/json"), (&csv::RENDERING, "checks.csv", "text/csv")];

/// A file within the PDF.
pub(super) struct Attachment {
    pub name: &'static str,
    pub media: &'static str,
    pub bytes: Arc<Vec<u8>>,
}

/// What belongs to a report.
pub(super) struct Attachments {
    pub files: Vec<Attachment>,
    /// Whether there is one that is too large.
    pub is_left_out: bool,
    /// A name for what the report says: it is the same for the same data alone.
    pub digest: String,
}

impl Attachments {
    /// # Errors
    /// The checks cannot be read.
    pub fn of(report: &Report, words: &Words) -> io::Result<Self> {
        let mut all = Self { files: Vec::new(), is_left_out: false, digest: String::new() };
        for (rendering, name, media) in DATA {
            let file = Kept::of(rendering, report, words)?;
            if all.digest.is_empty() {
                all.digest = hex(&file.digest.finalize());
            }
            match file.bytes {
                Some(bytes) => all.files.push(Attachment { name, media, bytes: Arc::new(bytes) }),
                None => all.is_left_out = true,
            }
        }
        Ok(all)
    }
}

impl Attachments {
    /// Their names alone, for pages that are only looked at. A short report is surely small enough; a longer one is written as far as it may
    /// be attached, and nothing of it is kept.
    ///
    /// # Errors
    /// As for [`Self::of`].
    pub fn named(report: &Report, words: &Words, seen: &ReportSurvey) -> io::Result<Self> {
        let mut all = Self { files: Vec::new(), is_left_out: false, digest: String::new() };
        for (rendering, name, media) in DATA {
            if seen.is_short() || Counted::fits(rendering, report, words)? {
                all.files.push(Attachment { name, media, bytes: Arc::default() });
            } else {
                all.is_left_out = true;
            }
        }
        Ok(all)
    }
}

/// A file of which nothing but its size is known, up to [`MOST`].
#[derive(Default)]
struct Counted {
    bytes: usize,
}

impl Counted {
    fn fits(rendering: &Rendering, report: &Report, words: &Words) -> io::Result<bool> {
        let mut counted = Self::default();
        match (rendering.render)(report, words, &mut counted) {
            Err(_) if MOST < counted.bytes => Ok(false),
            other => other.map(|()| true),
        }
    }
}

impl Write for Counted {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.bytes = self.bytes.saturating_add(bytes.len());
        if MOST < self.bytes { Err(io::ErrorKind::FileTooLarge.into()) } else { Ok(bytes.len()) }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A file as it is written: its digest, and its bytes while they are few enough.
struct Kept {
    digest: Sha256,
    bytes: Option<Vec<u8>>,
}

impl Kept {
    fn of(rendering: &Rendering, report: &Report, words: &Words) -> io::Result<Self> {
        let mut kept = Self { digest: Sha256::new(), bytes: Some(Vec::new()) };
        (rendering.render)(report, words, &mut kept)?;
        Ok(kept)
    }
}

impl Write for Kept {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.digest.update(bytes);
        if let Some(kept) = &mut self.bytes {
            kept.extend_from_slice(bytes);
            if MOST < kept.len() {
                self.bytes = None;
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
