//! What files are read and written for.
//!
//! To add a kind of file in the window:
//!
//! 1. Add a variant to [`Purpose`] and its line to `row`; one that is read again from the list of recent files, or whose ending is to be
//!    known on the command line, stands in `all`.
//! 2. Where its ending or content tells the kind, say so in `of_file` in `files/kinds.rs`.
//! 3. Read it in `src/gui/reading.rs`, or make its bytes in `errand` in `files/mod.rs`. Both matches have a default: the compiler does not
//!    name them. What a file does that is dropped on a page is in the page's folder of `gui`.
//! 4. Add the title of its dialog and `file-kind-KIND` to every folder of `assets/locales`.

use std::path::Path;

use fitcheck_core::tolerance::Feature;
use fitcheck_core::words::Words;
use fitcheck_exchange::batch::FORMS as ROW_FORMS;
use fitcheck_exchange::exchange::{self, tables::TABLE_FORMATS};
use fitcheck_exchange::report::pairing::FORMATS as PAIR_FORMATS;
use fitcheck_exchange::report::{ChartFile, RENDERINGS, of_any_paper};

use crate::page::Page;
use crate::rows::row_forms;

/// What a file dialog is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Purpose {
    /// Reading measurements.
    Import,
    /// Reading a mask.
    LoadMask,
    /// Reading a file of own texts.
    LoadTexts,
    /// Reading a folder of tables.
    LoadTables,
    /// Writing the history or the chosen checks in a format of the report's list, by its number there.
    Export(usize),
    /// Writing the listed rows of a large file in a form of text, by its number among all forms.
    ExportRows(usize),
    /// Writing the status window's text.
    ExportStatus,
    /// Reading one table for the table page.
    OpenTable,
    /// Writing the shown table in a format of the tables' list, by its number there.
    SaveTable(usize),
    /// Reading something for the cycles page.
    OpenCycleFile(CycleFile),
    /// Writing the simulated workpiece.
    SaveWorkpiece,
    /// Writing the measuring log of the cycle that was run.
    SaveCycleLog,
    /// Reading an NC program.
    OpenProgram,
    /// Reading a simulated part of several features.
    OpenPart,
    /// Reading a tool table.
    OpenTools,
    /// Writing the tool table as a run has changed it.
    SaveTools,
    /// Reading an uncertainty budget.
    OpenBudget,
    /// Reading the budget that checks used the last time.
    UseBudget,
    /// Writing the budget of the budget page.
    SaveBudget,
    /// Reading a part plan.
    OpenPlan,
    /// Reading measurements into the part that is walked through, by its number among all that were begun.
    ImportValues(u64),
    /// Reading measurements whose columns are to be seen first.
    AskColumns(ImportInto),
    /// Reading settings for a whole shop.
    ImportSettings,
    /// Writing them.
    ExportSettings,
    /// Watching a folder that files are dropped into.
    WatchFolder,
    /// Writing the plan: as TOML, or as CSV.
    SavePlan(usize),
    /// Choosing the picture of a plan.
    OpenPicture,
    /// Reading an earlier report, to say what changed since.
    CompareReport,
    /// Reading readings of a calibrated piece.
    OpenReadings,
    /// Reading readings of a gauge for a study.
    OpenStudy,
    /// Writing what the study gives an uncertainty budget.
    SaveStudyBudget,
    /// Writing the charts of a feature on one sheet.
    SaveChart,
    /// Reading measured holes or shafts for the pairing page.
    OpenParts(Feature),
    /// Writing the pairs in a format of their list, by its number there.
    SavePairs(usize),
    /// Writing the report of the reports page in a format of their list, by its number there.
    Report(usize),
    /// Writing the chosen records in a format of the report's list, by its number there.
    ReportRecords(usize),
    /// Writing the files for a control into a folder.
    CreateSet,
    /// Writing the part that is being measured in a format of the report's list, by its number there.
    ReportPart(usize),
}

/// What is to be known of a purpose: one line each, from which dialogs, recent files, the state file and `fitcheck FILE` follow.
struct PurposeRow {
    way: Way,
    /// The name of the kind of thing in the state file. What is read and written alike has one folder.
    kind: &'static str,
    /// The id of the dialog's title.
    title: &'static str,
    endings: Endings,
    /// The pages that show what is read; the first one is opened where none of them is. None where every page uses it.
    pages: &'static [Page],
}

/// Whether a dialog asks for what is read or written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    Read,
    ReadFolder,
    Write,
    WriteFolder,
}

/// The endings of files, in lower case and without the point; the first one is what a name without an ending gets.
enum Endings {
    Listed(&'static [&'static str]),
    /// Those of every format of measurements.
    Measurements,
    /// The same, and those of packed files.
    Packable,
    /// Those of a format of reports, of pairs or of tables, by its number in their list.
    Report(usize),
    Pairs(usize),
    Table(usize),
    Rows(usize),
}

impl Endings {
    fn list(&self) -> Vec<&'static str> {
        match self {
            Self::Listed(endings) => endings.to_vec(),
            Self::Measurements => exchange::endings(),
            Self::Packable => exchange::endings().into_iter().chain(PACKED).collect(),
            Self::Report(number) => {
                RENDERINGS.iter().skip(*number).take(1).flat_map(|format| format.endings).copied().collect()
            }
            Self::Rows(number) => {
                ROW_FORMS.iter().skip(*number).take(1).flat_map(|(.., endings)| *endings).copied().collect()
            }
            Self::Pairs(number) => {
                PAIR_FORMATS.iter().skip(*number).take(1).flat_map(|format| format.endings).copied().collect()
            }
            Self::Table(number) => {
                TABLE_FORMATS.iter().skip(*number).take(1).flat_map(|format| format.endings).copied().collect()
            }
        }
    }
}

/// Endings of packed files: measurements, whatever their name says besides.
pub(crate) const PACKED: [&str; 2] = ["gz", "zst"];

const TOML: Endings = Endings::Listed(&["toml"]);

const fn reads(kind: &'static str, title: &'static str, endings: Endings, pages: &'static [Page]) -> PurposeRow {
    PurposeRow { way: Way::Read, kind, title, endings, pages }
}

const fn reads_folder(
    kind: &'static str,
    title: &'static str,
    endings: &'static [&'static str],
    pages: &'static [Page],
) -> PurposeRow {
    PurposeRow { way: Way::ReadFolder, kind, title, endings: Endings::Listed(endings), pages }
}

const fn writes(kind: &'static str, title: &'static str, endings: Endings) -> PurposeRow {
    PurposeRow { way: Way::Write, kind, title, endings, pages: &[] }
}

impl Purpose {
    /// Everything that is read, and everything that is written.
    fn all() -> impl Iterator<Item = Self> {
        let reports = of_any_paper().map(Self::Export);
        let tables = (0..TABLE_FORMATS.len()).map(Self::SaveTable);
        let pairs = (0..PAIR_FORMATS.len()).map(Self::SavePairs);
        let rows = row_forms().map(Self::ExportRows);
        let one = [
            Self::Import,
            Self::LoadMask,
            Self::LoadTexts,
            Self::LoadTables,
            Self::OpenTable,
            Self::OpenProgram,
            Self::OpenPart,
            Self::OpenTools,
            Self::OpenBudget,
            Self::OpenPlan,
            Self::OpenPicture,
            Self::OpenReadings,
            Self::OpenStudy,
            Self::OpenCycleFile(CycleFile::Contacts),
            Self::OpenCycleFile(CycleFile::Workpiece),
            Self::OpenCycleFile(CycleFile::Probes),
            Self::OpenParts(Feature::Hole),
            Self::OpenParts(Feature::Shaft),
            Self::ExportStatus,
            Self::SaveWorkpiece,
            Self::SaveCycleLog,
        ];
        one.into_iter().chain(reports).chain(tables).chain(pairs).chain(rows)
    }

    const fn row(self) -> PurposeRow {
        use Endings::{Listed, Measurements, Packable, Pairs, Report, Rows, Table};
        match self {
            Self::Import => reads("measurements", "dialog-import", Packable, &[Page::Check]),
            Self::ImportValues(_) => reads("measurements", "dialog-import", Packable, &[Page::Parts]),
            Self::AskColumns(ImportInto::History) => {
                reads("measurements", "columns-page-dialog", Packable, &[Page::Check])
            }
            Self::AskColumns(ImportInto::Part(_)) => {
                reads("measurements", "columns-page-dialog", Packable, &[Page::Parts])
            }
            Self::AskColumns(ImportInto::Study) => reads("study", "columns-page-dialog", Packable, &[Page::Statistics]),
            Self::OpenStudy => reads("study", "statistics-study-dialog", Packable, &[Page::Statistics]),
            Self::WatchFolder => reads_folder("watched", "walk-page-dialog-watch", &[], &[Page::Parts]),
            Self::LoadMask => reads("mask", "dialog-mask", Listed(&["a"]), &[]),
            Self::LoadTexts => reads("own-texts", "dialog-own-texts", Listed(&["ftl"]), &[]),
            Self::LoadTables => reads_folder("own-tables", "dialog-tables", &["tab"], &[]),
            Self::OpenTable => reads("table", "tables-dialog-open", Listed(&["tab"]), &[Page::Tables]),
            Self::SaveTable(format) => writes("table", "tables-dialog-save", Table(format)),
            Self::Export(format) | Self::Report(format) | Self::ReportRecords(format) | Self::ReportPart(format) => {
                writes("report", "dialog-export", Report(format))
            }
            Self::ExportRows(form) => writes("rows", "dialog-export-rows", Rows(form)),
            Self::ExportStatus => writes("status", "dialog-export-status", Listed(&["txt"])),
            Self::OpenCycleFile(CycleFile::Contacts) => {
                reads("contacts", "cycles-dialog-contacts", Listed(&["csv", "txt"]), &[Page::Cycles, Page::Program])
            }
            Self::OpenCycleFile(CycleFile::Workpiece) => {
                reads("workpiece", "cycles-dialog-workpiece", TOML, &[Page::Cycles, Page::Program])
            }
            Self::OpenCycleFile(CycleFile::Probes) => {
                reads("probes", "cycles-dialog-probes", Listed(&["tp"]), &[Page::Cycles])
            }
            Self::SaveWorkpiece => writes("workpiece", "cycles-dialog-save-workpiece", TOML),
            // The endings that the control uses: text, and a page.
            Self::SaveCycleLog => writes("log", "cycles-dialog-save-log", Listed(&["txt", "html"])),
            Self::OpenProgram => {
                reads("program", "program-page-dialog-open", Listed(&["h", "i", "nc", "ncs"]), &[Page::Program])
            }
            Self::OpenPart => reads("part", "program-page-dialog-part", TOML, &[Page::Program]),
            Self::OpenTools => reads("tools", "tools-dialog-open", Listed(&["t"]), &[Page::Program, Page::Cycles]),
            Self::SaveTools => writes("tools", "tools-dialog-save", Listed(&["t"])),
            Self::OpenBudget => reads("budget", "budget-page-dialog-open", TOML, &[Page::Budget]),
            Self::UseBudget => reads("budget", "budget-page-dialog-open", TOML, &[]),
            Self::SaveBudget | Self::SaveStudyBudget => writes("budget", "budget-page-dialog-save", TOML),
            Self::SaveChart => writes("chart", "statistics-page-dialog-chart", Listed(&ChartFile::ENDINGS)),
            Self::OpenPlan => reads("plan", "parts-page-dialog-open", Listed(&exchange::PLAN_ENDINGS), &[Page::Parts]),
            Self::ImportSettings => reads("settings", "settings-page-dialog-import", TOML, &[]),
            Self::ExportSettings => writes("settings", "settings-page-dialog-export", TOML),
            Self::SavePlan(0) => writes("plan", "parts-page-dialog-save", TOML),
            Self::SavePlan(_) => writes("plan", "parts-page-dialog-save", Listed(&["csv"])),
            Self::OpenPicture => {
                reads("picture", "parts-page-dialog-picture", Listed(&["png", "jpg", "jpeg", "svg"]), &[Page::Parts])
            }
            Self::CompareReport => {
                reads("report", "reports-page-dialog-earlier", Listed(&["pdf", "json"]), &[Page::Reports])
            }
            Self::OpenReadings => reads("readings", "budget-page-dialog-readings", Measurements, &[Page::Budget]),
            Self::OpenParts(Feature::Hole) => {
                reads("holes", "pairing-page-dialog-holes", Measurements, &[Page::Pairing])
            }
            Self::OpenParts(Feature::Shaft) => {
                reads("shafts", "pairing-page-dialog-shafts", Measurements, &[Page::Pairing])
            }
            Self::CreateSet => PurposeRow {
                way: Way::WriteFolder,
                ..writes("set", "program-page-dialog-create", Listed(&["h", "tab", "a", "txt"]))
            },
            Self::SavePairs(format) => writes("pairs", "pairing-page-dialog-save", Pairs(format)),
        }
    }

    /// Whether a folder is asked for, and no file.
    pub fn is_folder(self) -> bool {
        matches!(self.row().way, Way::ReadFolder | Way::WriteFolder)
    }

    /// Whether something is read; otherwise a file is written.
    pub fn is_reading(self) -> bool {
        matches!(self.row().way, Way::Read | Way::ReadFolder)
    }

    /// The id of what a dialog asks for.
    pub const fn title(self) -> &'static str {
        self.row().title
    }

    pub(crate) const fn kind(self) -> &'static str {
        self.row().kind
    }

    /// The purpose that reads files of a kind.
    pub(crate) fn reading(kind: &str) -> Option<Self> {
        Self::all().find(|purpose| purpose.is_reading() && purpose.kind() == kind)
    }

    /// The endings of its files in lower case, without the point; none where any will do. The first one is what a name
    /// without an ending gets.
    pub fn endings(self) -> Vec<&'static str> {
        self.row().endings.list()
    }

    /// What a name without an ending gets.
    pub(crate) fn ending(self) -> &'static str {
        self.endings().first().copied().unwrap_or("txt")
    }

    /// Whether a path ends as some kind of file does that is read or written here: `bore.csv`, and not `bore 12.5H7`.
    pub fn knows_ending(path: &Path) -> bool {
        let Some(ending) = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()) else { return false };
        Self::all().flat_map(Self::endings).any(|known| ending == known)
    }

    /// The kind of file with its endings, as the system's dialog lists it: `Measurements (*.csv, *.txt)`.
    pub fn filter_name(self, words: &Words) -> String {
        let kind = words.get(&format!("file-kind-{}", self.kind()));
        let patterns: Vec<_> = self.endings().iter().map(|ending| format!("*.{ending}")).collect();
        format!("{kind} ({})", patterns.join(", "))
    }

    /// The page that is opened for what is read: `None` where the open one shows it.
    pub fn page(self, open: Page) -> Option<Page> {
        let pages = self.row().pages;
        pages.first().copied().filter(|_| !pages.contains(&open))
    }
}

/// Where measurements of a file go.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ImportInto {
    /// The history of the check page.
    History,
    /// The part that is walked through, by its number among all that were begun: it may be another one when the file is read.
    Part(u64),
    /// The study of a gauge.
    Study,
}

impl ImportInto {
    /// The purpose that reads them there.
    pub const fn purpose(self) -> Purpose {
        match self {
            Self::History => Purpose::Import,
            Self::Part(run) => Purpose::ImportValues(run),
            Self::Study => Purpose::OpenStudy,
        }
    }
}

/// A file that the cycles page reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CycleFile {
    /// Recorded contacts.
    Contacts,
    /// A simulated workpiece and probe.
    Workpiece,
    /// A touch-probe table.
    Probes,
}
