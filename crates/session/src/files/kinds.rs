//! Kinds of files: what each is kept under, which endings it has, and what a file given from outside is opened for.
//!
//! To add a kind of file:
//!
//! 1. Add a variant to [`Purpose`] in `crates/session/src/command.rs`.
//! 2. Add its lines here: `READERS` with its length if it is read, its name in the state file (`kind`), its endings, its page, and
//!    `of_file` if its ending or content tells the kind. A kind that is written has a place in `knows_ending`.
//! 3. Read it in `gui/reading.rs`, or make its bytes in `errand` in `crates/session/src/files/mod.rs`. Both matches have a default, as `page` has here:
//!    the compiler does not name them.
//! 4. Add the title of its dialog in `gui/dialogs.rs`, and there what a dropped file is. Add this text and `file-kind-KIND` to every
//!    folder of `assets/locales`.
//!
//! The dialog, the system's dialog, the last folder, recent files and `fitcheck FILE` follow.

use std::path::Path;

use fitcheck_core::budget::Budget;
use fitcheck_core::message::Say;
use fitcheck_core::part::Document;
use fitcheck_core::probing::simulated::Part;
use fitcheck_core::text::decode;
use fitcheck_core::tolerance::Feature;
use fitcheck_core::words::Words;
use fitcheck_exchange::exchange::{self, tables::TABLE_FORMATS};
use fitcheck_exchange::report::RENDERINGS;
use fitcheck_exchange::report::pairing::FORMATS as PAIR_FORMATS;

use crate::page::Page;
use crate::purpose::{CycleFile, ImportInto, Purpose};

/// How much of a file is looked at to find out what it is.
pub const HEAD: usize = 64 << 10;

/// Endings of packed files: measurements, whatever their name says besides.
const PACKED: [&str; 2] = ["gz", "zst"];

/// Why a file given from outside is not opened.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "open", error)]
pub enum OpenError {
    /// Nothing that the window reads.
    Unknown { name: String },
}

impl Purpose {
    /// Everything that reads a file or a folder.
    const READERS: [Self; 16] = [
        Self::Import,
        Self::LoadMask,
        Self::LoadTables,
        Self::OpenTable,
        Self::OpenProgram,
        Self::OpenPart,
        Self::OpenTools,
        Self::OpenBudget,
        Self::OpenPlan,
        Self::OpenPicture,
        Self::OpenReadings,
        Self::OpenCycleFile(CycleFile::Contacts),
        Self::OpenCycleFile(CycleFile::Workpiece),
        Self::OpenCycleFile(CycleFile::Probes),
        Self::OpenParts(Feature::Hole),
        Self::OpenParts(Feature::Shaft),
    ];

    /// The name of the kind of thing in the state file. What is read and written alike has one folder.
    pub(crate) const fn kind(self) -> &'static str {
        match self {
            Self::Import | Self::ImportValues(_) | Self::AskColumns(_) => "measurements",
            Self::WatchFolder => "watched",
            Self::LoadMask => "mask",
            Self::LoadTables => "own-tables",
            Self::Export(_) | Self::ReportRecords(_) | Self::ReportPart(_) => "report",
            Self::ExportStatus => "status",
            Self::OpenTable | Self::SaveTable(_) => "table",
            Self::OpenCycleFile(CycleFile::Contacts) => "contacts",
            Self::OpenCycleFile(CycleFile::Workpiece) | Self::SaveWorkpiece => "workpiece",
            Self::OpenCycleFile(CycleFile::Probes) => "probes",
            Self::SaveCycleLog => "log",
            Self::OpenProgram => "program",
            Self::OpenPart => "part",
            Self::OpenTools | Self::SaveTools => "tools",
            Self::OpenBudget | Self::UseBudget | Self::SaveBudget => "budget",
            Self::OpenPlan | Self::SavePlan(_) => "plan",
            Self::OpenPicture => "picture",
            Self::OpenReadings => "readings",
            Self::OpenParts(Feature::Hole) => "holes",
            Self::OpenParts(Feature::Shaft) => "shafts",
            Self::SavePairs(_) => "pairs",
        }
    }

    /// The purpose that reads files of a kind.
    pub(crate) fn reading(kind: &str) -> Option<Self> {
        Self::READERS.into_iter().find(|purpose| purpose.kind() == kind)
    }

    /// The endings of its files in lower case, without the point; none where any will do. The first one is what a name
    /// without an ending gets.
    pub fn endings(self) -> Vec<&'static str> {
        match self {
            Self::Import | Self::ImportValues(_) | Self::AskColumns(_) => {
                exchange::endings().into_iter().chain(PACKED).collect()
            }
            Self::OpenReadings => exchange::endings().into_iter().collect(),
            Self::OpenParts(_) => exchange::endings(),
            Self::SavePairs(number) => {
                PAIR_FORMATS.get(number).map(|format| format.endings.to_vec()).unwrap_or_default()
            }
            Self::LoadMask => vec!["a"],
            Self::LoadTables | Self::OpenTable => vec!["tab"],
            Self::Export(number) | Self::ReportRecords(number) | Self::ReportPart(number) => {
                RENDERINGS.get(number).map(|format| format.endings.to_vec()).unwrap_or_default()
            }
            Self::SaveTable(number) => {
                TABLE_FORMATS.get(number).map(|format| format.endings.to_vec()).unwrap_or_default()
            }
            Self::ExportStatus => vec!["txt"],
            Self::OpenCycleFile(CycleFile::Contacts) => vec!["csv", "txt"],
            Self::OpenCycleFile(CycleFile::Workpiece)
            | Self::SaveWorkpiece
            | Self::OpenPart
            | Self::OpenBudget
            | Self::UseBudget
            | Self::SaveBudget => vec!["toml"],
            Self::OpenPlan => exchange::PLAN_ENDINGS.to_vec(),
            Self::OpenPicture => vec!["png", "jpg", "jpeg", "svg"],
            Self::WatchFolder => Vec::new(),
            Self::SavePlan(number) => vec![if number == 0 { "toml" } else { "csv" }],
            Self::OpenCycleFile(CycleFile::Probes) => vec!["tp"],
            // The endings that the control uses: text, and a page.
            Self::SaveCycleLog => vec!["txt", "html"],
            Self::OpenProgram => vec!["h", "i", "nc", "ncs"],
            Self::OpenTools | Self::SaveTools => vec!["t"],
        }
    }

    /// Whether a path ends as some kind of file does that is read or written here: `bore.csv`, and not `bore 12.5H7`.
    pub fn knows_ending(path: &Path) -> bool {
        let Some(ending) = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()) else { return false };
        let reports = (0..RENDERINGS.len()).map(Self::Export);
        let written = [Self::ExportStatus, Self::SaveWorkpiece, Self::SaveCycleLog].into_iter();
        let tables = (0..TABLE_FORMATS.len()).map(Self::SaveTable);
        let pairs = (0..PAIR_FORMATS.len()).map(Self::SavePairs);
        let kinds = Self::READERS.into_iter().chain(written).chain(reports).chain(tables).chain(pairs);
        kinds.flat_map(Self::endings).any(|known| ending == known)
    }

    /// The kind of file with its endings, as the system's dialog lists it: `Measurements (*.csv, *.txt)`.
    pub fn filter_name(self, words: &Words) -> String {
        let kind = words.get(&format!("file-kind-{}", self.kind()));
        let patterns: Vec<_> = self.endings().iter().map(|ending| format!("*.{ending}")).collect();
        format!("{kind} ({})", patterns.join(", "))
    }

    /// The page that shows what is read, when another one is open: `None` where every page uses it.
    pub(crate) fn page(self, open: Page) -> Option<Page> {
        let shows = match self {
            Self::Import | Self::AskColumns(ImportInto::History) => Page::Check,
            Self::OpenTable => Page::Tables,
            Self::OpenBudget | Self::OpenReadings => Page::Budget,
            Self::OpenParts(_) => Page::Pairing,
            Self::OpenPlan
            | Self::OpenPicture
            | Self::ImportValues(_)
            | Self::AskColumns(ImportInto::Part(_))
            | Self::WatchFolder => Page::Parts,
            // Both pages monitor tools with it.
            Self::OpenTools if open == Page::Cycles => open,
            Self::OpenProgram | Self::OpenPart | Self::OpenTools => Page::Program,
            // Both pages measure the workpiece and the contacts.
            Self::OpenCycleFile(CycleFile::Contacts | CycleFile::Workpiece) if open == Page::Program => open,
            Self::OpenCycleFile(_) => Page::Cycles,
            _ => return None,
        };
        (shows != open).then_some(shows)
    }

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
        let purpose = match ending.as_deref().unwrap_or_default() {
            "h" | "i" | "nc" | "ncs" => Some(Self::OpenProgram),
            "tab" => Some(Self::OpenTable),
            "toml" if Document::is_toml(head) => Some(Self::OpenPlan),
            "toml" if Part::is_file(&decode(head)) => Some(Self::OpenPart),
            "toml" if Budget::is_file(&decode(head)) => Some(Self::OpenBudget),
            "toml" => Some(Self::OpenCycleFile(CycleFile::Workpiece)),
            "t" => Some(Self::OpenTools),
            "tp" => Some(Self::OpenCycleFile(CycleFile::Probes)),
            "a" => Some(Self::LoadMask),
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
