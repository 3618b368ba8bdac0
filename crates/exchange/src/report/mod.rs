//! The inspection report: one model, one file per rendering.
//!
//! | file | what |
//! |---|---|
//! | `html` | one self-contained page that prints well on A4 |
//! | `pdf` | pages to sign and to keep: A4 or letter, tagged, with the data attached |
//! | `png` | a label as a picture, for printers of labels |
//! | `markdown` | a page of headings and tables, for wikis and tickets |
//! | `xlsx` | a workbook: a sheet a part, one for the lot, one for all checks |
//! | `csv`, `json` | the checks in figures, for spreadsheets and programs, the same in every language |
//! | `dfq`, `qif` | the values with their characteristics, for statistics and measuring software |
//! | `given` | the values of a report as these two have them |
//! | `part`, `image` | a whole part by its plan, and its picture |
//! | `pairing` | which parts go together, and its files |
//! | `band` | the limit band's geometry, for the report and the window |
//! | `picture` | the limit band and the verdict's sign as SVG |
//! | `changes` | what changed since an earlier report of the part |
//! | `shapes` | the picture of a part as shapes, for drawing |
//! | `paper` | what pages are printed on |
//! | `template` | what a report for people shows, and in which order |
//! | `chart_file` | charts as files of their own |
//! | `statistics` | the figures and charts of each feature, where the template shows them |
//! | `told` | a check and a part in words, for the cells of tables |
//! | `text` | sentences about status, source of the limits, size and position |
//! | `head`, `said`, `origins`, `seen`, `shared` | what pages for people say of the report, of a part, of a check and of all checks |
//!
//! A report is made from records and nothing else: no clock, no window, no table. The same report always gives the same
//! bytes. Templates are in `assets/report`.
//!
//! To add a rendering:
//!
//! 1. Write a file with its `RENDERING`: for people after the model of `markdown`, for programs after `csv`. Add its `mod` line, its line in
//!    [`RENDERINGS`] and its row above. Its line comes last: Ctrl+S saves as the first one.
//! 2. For people it says what is simulated, corrected, in doubt and guarded, the rule and the caveats of each check, the notes, what parts
//!    lack, and the statement of its template (`closing`); a text from outside stays a text.
//! 3. Test it in `tests/core/renderings`, and say in `crates/exchange/tests/pdf/twelve.rs` what it has to have. Add a call of
//!    `fitcheck report` to the corpus and record the answers (`tests/core/corpus.rs`). The tests `report`, `memory` and `told_again` look at every
//!    rendering: checks are written one by one, and what Fitcheck reads back is what it wrote.
//! 4. Describe it in the help of `src/cli/report/mod.rs`, in `docs/manual/reports.md`, in `docs/manual/formats.md` and in `CHANGELOG.md`.
//!
//! The formats of the command line, the entries of the window's menus and the filters of its dialogs follow.

pub mod band;
pub mod changes;
mod chart_file;
pub mod csv;
pub mod dfq;
mod given;
mod head;
pub mod html;
pub mod image;
pub mod json;
pub mod markdown;
mod origins;
pub mod pairing;
pub mod paper;
pub mod part;
pub mod pdf;
mod picture;
pub mod png;
pub mod qif;
mod said;
mod seen;
pub mod shapes;
mod shared;
mod statistics;
pub mod template;
pub mod text;
mod told;
pub mod xlsx;

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;

use changes::EarlierReport;
pub use chart_file::ChartFile;
use fitcheck_core::message::{Message, Say};
use fitcheck_core::words::Words;
use jiff::civil::DateTime;
use paper::Paper;
use part::PartSheet;
use template::{HeadField, Template};

use crate::journal::Record;
use crate::journal::chain::{ChainId, Head};
use crate::series::EvaluatedSeries;

/// What an inspection report says.
///
/// The language is not part of it: it comes in with the [`Words`] of a rendering.
#[derive(Debug, Clone)]
pub struct Report {
    /// Title; when empty, the language's own word for an inspection report.
    pub title: String,
    /// Local date and time of the report.
    pub created: DateTime,
    /// Name and version of the program that made it.
    pub program: String,
    /// Part or drawing number.
    pub part: Option<String>,
    pub order: Option<String>,
    /// Who inspected.
    pub inspector: Option<String>,
    /// The checks, in the order of the report.
    pub checks: Arc<dyn Checks>,
    /// Errors and warnings: nothing is left out in silence.
    pub notes: Vec<Message>,
    /// Whether rows of the input are no checks: refused, not judged, or not read. The notes say which; such a report states no conformity.
    pub is_partial: bool,
    /// The earlier report that it is compared with.
    pub earlier: Option<Arc<EarlierReport>>,
    /// The whole parts whose values the checks are.
    pub parts: Vec<PartSheet>,
    /// The series that its statistics are of; those of the checks where there are none.
    pub series: EvaluatedSeries,
    /// What renderings with pages of their own are printed on.
    pub paper: Paper,
    /// What such renderings show, and in which order.
    pub template: Arc<Template>,
    /// What else stands in its head, besides what the fields above say.
    pub given: BTreeMap<HeadField, String>,
    /// Where its records stand; `None` where they are in no journal.
    pub journal: Option<ReportJournal>,
}

/// Where the records of a report stand.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReportJournal {
    pub chain: ChainId,
    /// The last entry of the journal when the report was made: it proves all entries before it.
    pub head: Head,
    /// The newest entry that the report shows: its hash is in the code on the pages.
    pub newest: Option<Head>,
    /// The numbers of the entries that it shows, in words: `12, 14–18`.
    pub numbers: String,
}

/// The checks of a report, one after the other, as often as a rendering asks for them: a report of many checks is
/// written without all of them in memory.
pub trait Checks: std::fmt::Debug + Send + Sync {
    /// Shows every check in order, up to the first error.
    ///
    /// # Errors
    /// The error of what it was shown to.
    fn each(&self, see: &mut dyn FnMut(&Record) -> io::Result<()>) -> io::Result<()>;

    /// Which columns the checks need besides those of every file.
    ///
    /// # Errors
    /// As for [`Self::each`].
    fn more(&self) -> io::Result<csv::More> {
        let mut more = csv::More::default();
        self.each(&mut |record| {
            more.see(record);
            Ok(())
        })?;
        Ok(more)
    }
}

impl<T: Checks> Checks for Arc<T> {
    fn each(&self, see: &mut dyn FnMut(&Record) -> io::Result<()>) -> io::Result<()> {
        self.as_ref().each(see)
    }

    fn more(&self) -> io::Result<csv::More> {
        self.as_ref().more()
    }
}

impl Checks for &[Record] {
    fn each(&self, see: &mut dyn FnMut(&Record) -> io::Result<()>) -> io::Result<()> {
        self.iter().try_for_each(see)
    }
}

impl Checks for Vec<Record> {
    fn each(&self, see: &mut dyn FnMut(&Record) -> io::Result<()>) -> io::Result<()> {
        self.iter().try_for_each(see)
    }
}

impl Checks for Vec<Arc<Record>> {
    fn each(&self, see: &mut dyn FnMut(&Record) -> io::Result<()>) -> io::Result<()> {
        self.iter().try_for_each(|record| see(record))
    }
}

impl Report {
    /// Whether it is of series alone: with no check among so many it states no verdict.
    pub(crate) fn is_of_series(&self, checks: usize) -> bool {
        checks == 0 && !self.series.features.is_empty()
    }

    /// A report of the given checks, made by this version of Fitcheck; all else is empty.
    pub fn new(created: DateTime, checks: impl Checks + 'static) -> Self {
        Self {
            title: String::new(),
            created,
            program: concat!("Fitcheck ", env!("CARGO_PKG_VERSION")).to_owned(),
            part: None,
            order: None,
            inspector: None,
            checks: Arc::new(checks),
            notes: Vec::new(),
            is_partial: false,
            earlier: None,
            parts: Vec::new(),
            series: EvaluatedSeries::default(),
            paper: Paper::default(),
            template: Template::usual(),
            given: BTreeMap::new(),
            journal: None,
        }
    }

    /// Puts something into its head. Blanks around it do not count, and an empty text is nothing.
    pub fn tell(&mut self, field: HeadField, text: &str) {
        let text = Some(text.trim().to_owned()).filter(|text| !text.is_empty());
        match (field, text) {
            (HeadField::Part, text) => self.part = text,
            (HeadField::Order, text) => self.order = text,
            (HeadField::Inspector, text) => self.inspector = text,
            (_, Some(text)) => _ = self.given.insert(field, text),
            (_, None) => _ = self.given.remove(&field),
        }
    }

    /// The parts without their values, and no checks: a sheet that is filled in by hand.
    fn blank(&self) -> Self {
        let parts = self.parts.iter().map(PartSheet::unmeasured).collect();
        Self { parts, checks: Arc::new(Vec::<Record>::new()), ..self.clone() }
    }

    /// The same, by a template and on its paper.
    #[must_use]
    pub fn by(self, template: &Arc<Template>) -> Self {
        Self { paper: template.paper, template: Arc::clone(template), ..self }
    }
}

/// What the files of a rendering have a place for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Holds {
    /// Checks alone, no title, part, order, inspector or notes of the report. The command line says so.
    Checks,
    /// Everything but the statistics of a template.
    Report,
    /// Everything.
    ReportAndStatistics,
    /// Labels alone: it takes no other paper.
    Label,
}

/// One way to write a report.
#[derive(Debug, Clone, Copy)]
pub struct Rendering {
    /// Its name on the command line.
    pub name: &'static str,
    /// What its format is called, in every language.
    pub title: &'static str,
    /// Whether a person reads the file; otherwise it is for spreadsheets and programs.
    pub is_for_people: bool,
    /// What its files have a place for.
    pub holds: Holds,
    /// Endings of its files without the point, the usual one first.
    pub endings: &'static [&'static str],
    /// Writes the file check by check. Machine-readable renderings do not use the words.
    ///
    /// # Errors
    /// The stream's own; what was written until then is no report.
    pub render: fn(&Report, &Words, &mut dyn Write) -> io::Result<()>,
}

impl Rendering {
    /// Why it cannot write reports on this paper; `None` where it can.
    pub fn refusal(&self, paper: Paper) -> Option<RenderError> {
        (self.holds == Holds::Label && !paper.is_label()).then_some(RenderError::LabelAlone { format: self.title })
    }

    /// The file in memory.
    ///
    /// # Errors
    /// [`RenderError`] if the writer of the format fails.
    pub fn bytes(&self, report: &Report, words: &Words) -> Result<Vec<u8>, RenderError> {
        let mut bytes = Vec::new();
        (self.render)(report, words, &mut bytes).map_err(|error| RenderError::writer(self.name, &error))?;
        Ok(bytes)
    }
}

/// Every rendering: a new one is a line here.
pub const RENDERINGS: &[Rendering] = &[
    html::RENDERING,
    csv::RENDERING,
    json::RENDERING,
    markdown::RENDERING,
    xlsx::RENDERING,
    dfq::RENDERING,
    qif::RENDERING,
    pdf::RENDERING,
    png::RENDERING,
];

/// The renderings that take any paper, by their numbers: where nobody has chosen a template.
pub fn of_any_paper() -> impl Iterator<Item = usize> {
    RENDERINGS.iter().enumerate().filter(|(_, rendering)| rendering.holds != Holds::Label).map(|(number, _)| number)
}

/// Why a report could not be turned into bytes. No rendering fails on a record by itself, but the writers that they use
/// may fail, and an incomplete report must not be saved.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "report-error", error)]
pub enum RenderError {
    /// The writer of the format failed.
    Writer {
        /// The rendering's name.
        format: &'static str,
        /// What the writer says.
        reason: String,
    },
    /// Statistics without checks, for which the format has no place.
    NoStatistics {
        /// What the format is called.
        format: &'static str,
    },
    /// A page where only a label can be written.
    LabelAlone {
        /// What the format is called.
        format: &'static str,
    },
}

impl RenderError {
    fn writer(format: &'static str, reason: &impl std::fmt::Display) -> Self {
        Self::Writer { format, reason: reason.to_string() }
    }
}

/// Why there is no rendering for a file name.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "report-ending", error)]
pub enum EndingError {
    /// The name has no ending.
    #[say(args(endings = endings()))]
    Missing {
        /// The file name.
        file: String,
    },
    /// No rendering has this ending.
    #[say(args(endings = endings()))]
    Unknown {
        /// The ending without its point.
        ending: String,
    },
}

/// Every ending with its point: `.html .htm .csv` and so on.
pub fn endings() -> String {
    let all: Vec<String> = RENDERINGS.iter().flat_map(|r| r.endings).map(|ending| format!(".{ending}")).collect();
    all.join(" ")
}

/// The rendering that a file's ending asks for, in capitals or small letters.
///
/// # Errors
/// [`EndingError`] names the known endings.
pub fn rendering_for(path: &Path) -> Result<&'static Rendering, EndingError> {
    let Some(ending) = path.extension().map(|ending| ending.to_string_lossy()) else {
        return Err(EndingError::Missing { file: path.display().to_string() });
    };
    let known = |rendering: &&Rendering| rendering.endings.iter().any(|known| known.eq_ignore_ascii_case(&ending));
    RENDERINGS.iter().find(known).ok_or_else(|| EndingError::Unknown { ending: ending.into_owned() })
}
