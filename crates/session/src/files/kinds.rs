//! What a file given from outside is opened for: told by its ending and its content.

use std::path::Path;

use fitcheck_core::budget::Budget;
use fitcheck_core::message::Say;
use fitcheck_core::part::Document;
use fitcheck_core::probing::simulated::Part;
use fitcheck_core::text::decode;
use fitcheck_exchange::exchange;

use crate::purpose::{CycleFile, PACKED, Purpose};

/// How much of a file is looked at to find out what it is.
pub const HEAD: usize = 64 << 10;

/// Why a file given from outside is not opened.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "open", error)]
pub enum OpenError {
    /// Nothing that the window reads.
    Unknown { name: String },
}

impl Purpose {
    /// What a file is opened for, by its name and its first [`HEAD`] bytes.
    ///
    /// ```
    /// use fitcheck_session::Purpose;
    ///
    /// assert_eq!(Purpose::of_file("part.csv", b"id,callout,measured\n"), Ok(Purpose::Import));
    /// assert_eq!(Purpose::of_file("bore.h", b"0 BEGIN PGM BORE MM\n"), Ok(Purpose::OpenProgram));
    /// ```
    pub fn of_file(name: &str, head: &[u8]) -> Result<Self, OpenError> {
        let ending = Path::new(name).extension().map(|ending| ending.to_string_lossy().to_lowercase());
        let purpose = match ending.as_deref().unwrap_or("") {
            "h" | "i" | "nc" | "ncs" => Some(Self::OpenProgram),
            "tab" => Some(Self::OpenTable),
            "toml" if Document::is_toml(head) => Some(Self::OpenPlan),
            "toml" if Part::is_file(&decode(head)) => Some(Self::OpenPart),
            "toml" if Budget::is_file(&decode(head)) => Some(Self::OpenBudget),
            "toml" => Some(Self::OpenCycleFile(CycleFile::Workpiece)),
            "t" => Some(Self::OpenTools),
            "tp" => Some(Self::OpenCycleFile(CycleFile::Probes)),
            "a" => Some(Self::LoadMask),
            "ftl" => Some(Self::LoadTexts),
            ending if PACKED.contains(&ending) => Some(Self::Import),
            ending if exchange::endings().contains(&ending) => {
                exchange::FORMATS.iter().any(|format| format.recognises(head, name)).then_some(Self::Import)
            }
            _ => by_content(name, head),
        };
        purpose.ok_or_else(|| OpenError::Unknown { name: name.to_owned() })
    }
}

/// What a file with another ending, or none, is: by marks that only one kind has. A table of measurements has none.
fn by_content(name: &str, head: &[u8]) -> Option<Purpose> {
    if exchange::FORMATS.iter().any(|format| format.has_marks && format.recognises(head, name)) {
        return Some(Purpose::Import);
    }
    let text = decode(head);
    let first = text.lines().find(|line| !line.trim().is_empty())?.to_uppercase();
    let first = first.trim_start_matches(|c: char| c.is_ascii_digit() || c.is_whitespace() || c == '\u{feff}');
    if is_iso(first) {
        return Some(Purpose::OpenProgram);
    }
    let begins = first.strip_prefix("BEGIN ")?;
    if begins.starts_with("PGM ") {
        Some(Purpose::OpenProgram)
    } else if begins.contains(".TAB") {
        Some(Purpose::OpenTable)
    } else if begins.contains(".TP") {
        Some(Purpose::OpenCycleFile(CycleFile::Probes))
    } else if begins.split_whitespace().any(|word| word.rsplit_once('.').is_some_and(|(_, ending)| ending == "T")) {
        Some(Purpose::OpenTools)
    } else {
        None
    }
}

/// The first line of an ISO program in capitals: `%NAME G71 *`.
fn is_iso(line: &str) -> bool {
    let unit = line.strip_prefix('%').map(|line| line.trim_end_matches(['*', ' ']).rsplit(' ').next());
    matches!(unit, Some(Some("G70" | "G71")))
}
