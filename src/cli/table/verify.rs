//! `fitcheck table verify`: compares a control's table with ISO 286, cell by cell.

use std::path::PathBuf;
use std::sync::Arc;

use crate::cli::people::um;
use crate::cli::rows::csv;
use crate::cli::{CliError, Figure, Format, IntoCliError as _, Io, Outcome, StandardArgs, read_table};
use crate::control::shipped_tables;
use crate::control::table::{ControlTable, TableFile};
use crate::length::Length;
use crate::message::{FilePlace, Message, Say};
use crate::tolerance::compare::{Comparison, Difference, compare};
use crate::tolerance::iso286::Undefined;
use crate::tolerance::{DeviationTable, Deviations};

const EXAMPLES: &str = "\
Examples:
  fitcheck table verify my_hole.tab             every cell against ISO 286
  fitcheck table verify tables/*.tab --format csv
  fitcheck table verify                         the two built-in tables

Columns of CSV and names in JSON: file, class, over_mm, to_mm, table_upper_um, table_lower_um,
standard_upper_um, standard_lower_um, upper_by_um, lower_by_um, line, column, reason. An empty
value: the table has no value there, or ISO 286 does not define the class (reason says why).
line and column: the first of the cell's two values that differs in the file, the upper one for an
empty cell. JSON is an array with one object per file: file, classes, size_ranges, cells (compared),
own_columns (not ISO 286 classes, so not compared), differences.
Exit code 1 when a cell differs or a file cannot be read.";

/// Compare control tables with ISO 286, cell by cell
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Control tables (*.tab); default: the two built-in ones
    files: Vec<PathBuf>,
    /// Format of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    standard: StandardArgs,
}

/// A table and the result of its comparison.
struct Verified {
    table: Arc<DeviationTable>,
    found: Comparison,
    /// The file as text, for the places of cells; `None` for a built-in table.
    file: Option<TableFile>,
}

object! {
    struct FileAnswer<'a> of(one: &'a Verified) {
        file: &'a str = one.table.name(),
        classes: usize = one.classes(),
        size_ranges: usize = one.table.ends().len(),
        cells: usize = one.found.compared,
        own_columns: Vec<String> = one.found.unknown.iter().map(ToString::to_string).collect(),
        differences: Vec<DifferenceRow<'a>> = one.rows().collect(),
    }
}

row! {
    /// One difference.
    struct DifferenceRow<'a> of(table: &'a DeviationTable, difference: &Difference, place: Option<&FilePlace>) {
        file: &'a str = table.name(),
        class: String = difference.class.to_string(),
        over_mm: Figure = Figure(difference.over.to_string()),
        to_mm: Figure = Figure(difference.to.to_string()),
        table_upper_um: Option<Figure> = Some(Figure::um(difference.table?.upper())),
        table_lower_um: Option<Figure> = Some(Figure::um(difference.table?.lower())),
        standard_upper_um: Option<Figure> = Some(Figure::um(difference.standard.as_ref().ok()?.upper())),
        standard_lower_um: Option<Figure> = Some(Figure::um(difference.standard.as_ref().ok()?.lower())),
        upper_by_um: Option<Figure> = difference.upper_by().map(Figure::um),
        lower_by_um: Option<Figure> = difference.lower_by().map(Figure::um),
        line: Option<usize> = place?.line,
        column: Option<usize> = place?.column,
        reason: Option<String> = Some(difference.standard.as_ref().err()?.to_string()),
    }
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let mut verified = Vec::new();
        let mut bad = false;
        if self.files.is_empty() {
            let tables = shipped_tables().into_iter();
            verified.extend(tables.map(|table| self.compared(table, None)));
        }
        for path in &self.files {
            match self.file(path, io) {
                Ok(one) => verified.push(one),
                Err(CliError::Stream(error)) => return Err(CliError::Stream(error)),
                // The other files are still compared.
                Err(error) => {
                    bad = true;
                    io.fail(error);
                }
            }
        }
        match self.format {
            Format::Text => verified.iter().for_each(|one| write_text(one, io)),
            Format::Csv => csv(verified.iter().flat_map(Verified::rows), io),
            Format::Json => io.json(&verified.iter().map(FileAnswer::of).collect::<Vec<_>>()),
        }
        let differs = verified.iter().any(|one| !one.found.differences.is_empty());
        Ok(if bad || differs { Outcome::BadData } else { Outcome::Done })
    }

    fn file(&self, path: &std::path::Path, io: &mut Io<'_>) -> Result<Verified, CliError> {
        let (table, name, bytes) = read_table(path, io)?;
        let file = ControlTable::read(&bytes, &name).said()?;
        Ok(self.compared(Arc::new(table), Some(file)))
    }

    fn compared(&self, table: Arc<DeviationTable>, file: Option<TableFile>) -> Verified {
        let found = compare(&table, self.standard.options());
        Verified { table, found, file }
    }
}

impl Verified {
    /// Where the value that differs is in the file: the upper one, unless only the lower one differs.
    fn place(&self, difference: &Difference) -> Option<FilePlace> {
        let file = self.file.as_ref()?;
        let column = file.table.column(difference.class.as_str())?;
        let is_lower = difference.upper_by() == Some(Length::ZERO);
        Some(file.cell_place(difference.range.saturating_mul(2).saturating_add(usize::from(is_lower)), column))
    }

    /// The columns that are classes of ISO 286.
    fn classes(&self) -> usize {
        self.table.columns().len().saturating_sub(self.found.unknown.len())
    }

    fn rows(&self) -> impl Iterator<Item = DifferenceRow<'_>> {
        let differences = self.found.differences.iter();
        differences.map(|difference| DifferenceRow::of(&self.table, difference, self.place(difference).as_ref()))
    }
}

/// The sentences of the text format.
#[derive(Debug, Say)]
#[say(prefix = "cli-verify")]
enum Sentence<'a> {
    /// Both have values.
    Off { place: String, class: &'a str, over: Length, to: Length, table: String, standard: String, by: String },
    /// The cell is empty.
    Missing { place: String, class: &'a str, over: Length, to: Length, standard: String },
    /// A value that ISO 286 does not have.
    Undefined { place: String, class: &'a str, over: Length, to: Length, table: String, reason: Undefined },
    /// The cell and ISO 286 are empty: the class has no value at this size, but has one at others in its range.
    Neither { place: String, class: &'a str, over: Length, to: Length, reason: Undefined },
    /// How far a deviation is off: `upper` or `lower`, `more` or `less`.
    By { side: &'static str, um: String, way: &'static str },
    /// A table and how many cells differ.
    Table { name: &'a str, classes: usize, ranges: usize, cells: usize, differ: usize },
    /// A table without a class of ISO 286.
    Nothing { name: &'a str, classes: usize, ranges: usize, cells: usize },
    /// Columns that are not classes.
    Own { table: Message, own: String },
}

fn write_text(one: &Verified, io: &mut Io<'_>) {
    let table = &one.table;
    let found = &one.found;
    for difference in &found.differences {
        writeln!(io.people(), "{}", sentence(one, difference));
    }
    let name = table.name();
    let classes = one.classes();
    let ranges = table.ends().len();
    let cells = found.compared;
    let told = match cells {
        0 => Sentence::Nothing { name, classes, ranges, cells },
        _ => Sentence::Table { name, classes, ranges, cells, differ: found.cells().len() },
    };
    let own: Vec<String> = found.unknown.iter().map(ToString::to_string).collect();
    let told = if own.is_empty() { told } else { Sentence::Own { table: told.message(), own: own.join(" ") } };
    writeln!(io.people(), "{told}");
}

/// `own.tab:12:8: H7 over 18 up to 30 mm: +22 / 0 µm, ISO 286 has +21 / 0 µm: upper 1 µm more`
fn sentence<'a>(one: &Verified, difference: &'a Difference) -> Sentence<'a> {
    let place = one.place(difference).and_then(|p| Some(format!("{}:{}:{}", p.file?, p.line?, p.column?)));
    let place = place.unwrap_or_else(|| one.table.name().to_owned());
    let class = difference.class.as_str();
    let over = difference.over;
    let to = difference.to;
    match (difference.table.as_ref().map(pair), &difference.standard) {
        (Some(table), Ok(standard)) => {
            let by = [("upper", difference.upper_by()), ("lower", difference.lower_by())];
            let by: Vec<String> = by.into_iter().filter_map(|(side, by)| more_or_less(side, by?)).collect();
            let by = by.join(", ");
            Sentence::Off { place, class, over, to, table, standard: pair(standard), by }
        }
        (None, Ok(standard)) => Sentence::Missing { place, class, over, to, standard: pair(standard) },
        (Some(table), Err(reason)) => Sentence::Undefined { place, class, over, to, table, reason: *reason },
        (None, Err(reason)) => Sentence::Neither { place, class, over, to, reason: *reason },
    }
}

fn more_or_less(side: &'static str, by: Length) -> Option<String> {
    let way = if Length::ZERO < by { "more" } else { "less" };
    let um = um(by.abs());
    (by != Length::ZERO).then(|| Sentence::By { side, um, way }.to_string())
}

/// `+21 / 0 µm`
fn pair(deviations: &Deviations) -> String {
    format!("{} / {} µm", deviations.upper().signed_um(), deviations.lower().signed_um())
}
