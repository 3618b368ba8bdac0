//! `fitcheck table verify`: a control's table against ISO 286, cell by cell.

use std::path::PathBuf;
use std::sync::Arc;

use serde::Serialize;

use crate::cli::{CliError, Figure, Format, Io, Outcome, Refused as _, StandardArgs, heard_or_not, read_table};
use crate::control::shipped_tables;
use crate::control::table::{ControlTable, Place, TableFile};
use crate::length::{Length, Unit};
use crate::tolerance::compare::{Comparison, Difference, compare};
use crate::tolerance::{DeviationTable, Deviations};

const EXAMPLES: &str = "\
Examples:
  fitcheck table verify my_hole.tab             every cell against ISO 286
  fitcheck table verify tables/*.tab --format csv
  fitcheck table verify                         the two built-in tables

Columns of CSV and names in JSON: file, class, over_mm, to_mm, table_upper_um, table_lower_um,
standard_upper_um, standard_lower_um, upper_by_um, lower_by_um, line, column, reason. An empty
figure: the table has no value there, or ISO 286 does not define the class (reason says why).
line and column: the first of the cell's two values that differs in the file, the upper one for an
empty cell. JSON is an array with one object a file: file, classes, size_ranges, cells (compared),
own_columns (no class of ISO 286, so not compared), differences.
Exit code 1 when a cell differs or a file cannot be read.";

/// Compare control tables with ISO 286, cell by cell
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Control tables (*.tab); without any the two built-in ones
    files: Vec<PathBuf>,
    /// How to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    standard: StandardArgs,
}

/// A table with what came of it.
struct Verified {
    table: Arc<DeviationTable>,
    found: Comparison,
    /// The file as text, for the places of cells; none for a built-in table.
    file: Option<TableFile>,
}

#[derive(Debug, Serialize)]
struct FileAnswer<'a> {
    file: &'a str,
    classes: usize,
    size_ranges: usize,
    cells: usize,
    own_columns: Vec<String>,
    differences: Vec<Row<'a>>,
}

/// One difference. The order is that of the columns.
#[derive(Debug, Serialize)]
struct Row<'a> {
    file: &'a str,
    class: String,
    over_mm: Figure,
    to_mm: Figure,
    table_upper_um: Option<Figure>,
    table_lower_um: Option<Figure>,
    standard_upper_um: Option<Figure>,
    standard_lower_um: Option<Figure>,
    upper_by_um: Option<Figure>,
    lower_by_um: Option<Figure>,
    line: Option<usize>,
    column: Option<usize>,
    reason: Option<String>,
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
                // The other files are compared all the same.
                Err(error) => {
                    bad = true;
                    io.fail(error)?;
                }
            }
        }
        match self.format {
            Format::Text => verified.iter().try_for_each(|one| write_text(one, io))?,
            Format::Csv => write_csv(&verified, io)?,
            Format::Json => write_json(&verified, io)?,
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
    /// Where the value that differs stands in the file: the upper one, unless the lower one differs alone.
    fn place(&self, difference: &Difference) -> Option<Place> {
        let file = self.file.as_ref()?;
        let column = file.table.column(difference.class.as_str())?;
        let is_lower = difference.upper_by() == Some(Length::ZERO);
        Some(file.cell_place(difference.range.saturating_mul(2).saturating_add(usize::from(is_lower)), column))
    }

    /// The columns that are classes of ISO 286.
    fn classes(&self) -> usize {
        self.table.columns().len().saturating_sub(self.found.unknown.len())
    }

    fn row<'a>(&'a self, difference: &Difference) -> Row<'a> {
        let um = |length: Length| Figure(length.exact(Unit::Micrometre, 0));
        let place = self.place(difference);
        let standard = difference.standard.as_ref();
        Row {
            file: self.table.name(),
            class: difference.class.to_string(),
            over_mm: Figure(difference.over.to_string()),
            to_mm: Figure(difference.to.to_string()),
            table_upper_um: difference.table.map(|pair| um(pair.upper())),
            table_lower_um: difference.table.map(|pair| um(pair.lower())),
            standard_upper_um: standard.ok().map(|pair| um(pair.upper())),
            standard_lower_um: standard.ok().map(|pair| um(pair.lower())),
            upper_by_um: difference.upper_by().map(um),
            lower_by_um: difference.lower_by().map(um),
            line: place.as_ref().map(|place| place.line),
            column: place.as_ref().map(|place| place.column),
            reason: standard.err().map(ToString::to_string),
        }
    }
}

fn write_text(one: &Verified, io: &mut Io<'_>) -> Result<(), CliError> {
    let (table, found) = (&one.table, &one.found);
    for difference in &found.differences {
        heard_or_not(writeln!(io.out, "{}", sentence(one, difference)))?;
    }
    let own: Vec<String> = found.unknown.iter().map(ToString::to_string).collect();
    let own =
        if own.is_empty() { String::new() } else { format!("; not compared, no class of ISO 286: {}", own.join(" ")) };
    let (name, cells) = (table.name(), counted(found.compared, "cell"));
    let (classes, ranges) = (counted_as(one.classes(), "class", "classes"), counted(table.ends().len(), "size range"));
    let result = match cells_that_differ(found) {
        0 if found.compared == 0 => "nothing to compare with ISO 286".to_owned(),
        0 => "all agree with ISO 286".to_owned(),
        1 => "1 differs from ISO 286".to_owned(),
        count => format!("{count} differ from ISO 286"),
    };
    heard_or_not(writeln!(io.out, "{name}: {classes}, {ranges}, {cells} compared: {result}{own}"))
}

/// `1 cell`, `504 cells`
fn counted(count: usize, noun: &str) -> String {
    counted_as(count, noun, &format!("{noun}s"))
}

fn counted_as(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}

/// Cells, not differences: a range that covers several steps may differ in more than one of them.
fn cells_that_differ(found: &Comparison) -> usize {
    let mut cells: Vec<_> = found.differences.iter().map(|difference| (difference.class, difference.range)).collect();
    cells.dedup();
    cells.len()
}

/// `own.tab:12:8: H7 over 18 up to 30 mm: +22 / 0 µm, ISO 286 has +21 / 0 µm: upper 1 µm more`
fn sentence(one: &Verified, difference: &Difference) -> String {
    let place = one.place(difference);
    let place = place.map_or_else(|| one.table.name().to_owned(), |p| format!("{}:{}:{}", p.file, p.line, p.column));
    let Difference { class, over, to, table, standard, .. } = difference;
    let here = format!("{place}: {class} over {over} up to {to} mm");
    match (table, standard) {
        (Some(table), Ok(standard)) => {
            let by = [("upper", difference.upper_by()), ("lower", difference.lower_by())];
            let by: Vec<String> = by.into_iter().filter_map(|(which, by)| more_or_less(which, by?)).collect();
            format!("{here}: {}, ISO 286 has {}: {}", pair(table), pair(standard), by.join(", "))
        }
        (None, Ok(standard)) => format!("{here}: no value, ISO 286 has {}", pair(standard)),
        (Some(table), Err(undefined)) => format!("{here}: {}, but {undefined}", pair(table)),
        (None, Err(undefined)) => format!("{here}: {undefined}"),
    }
}

fn more_or_less(which: &str, by: Length) -> Option<String> {
    let word = if Length::ZERO < by { "more" } else { "less" };
    (by != Length::ZERO).then(|| format!("{which} {} µm {word}", by.abs().exact(Unit::Micrometre, 0)))
}

/// `+21 / 0 µm`
fn pair(deviations: &Deviations) -> String {
    let signed = |length: Length| {
        let plus = if Length::ZERO < length { "+" } else { "" };
        format!("{plus}{}", length.exact(Unit::Micrometre, 0))
    };
    format!("{} / {} µm", signed(deviations.upper()), signed(deviations.lower()))
}

fn write_csv(verified: &[Verified], io: &mut Io<'_>) -> Result<(), CliError> {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    let names = [
        "file",
        "class",
        "over_mm",
        "to_mm",
        "table_upper_um",
        "table_lower_um",
        "standard_upper_um",
        "standard_lower_um",
        "upper_by_um",
        "lower_by_um",
        "line",
        "column",
        "reason",
    ];
    writer.write_record(names)?;
    for one in verified {
        for difference in &one.found.differences {
            writer.serialize(one.row(difference))?;
        }
    }
    let bytes = writer.into_inner().map_err(csv::IntoInnerError::into_error)?;
    heard_or_not(io.out.write_all(&bytes))
}

fn write_json(verified: &[Verified], io: &mut Io<'_>) -> Result<(), CliError> {
    let answers: Vec<FileAnswer<'_>> = verified
        .iter()
        .map(|one| FileAnswer {
            file: one.table.name(),
            classes: one.classes(),
            size_ranges: one.table.ends().len(),
            cells: one.found.compared,
            own_columns: one.found.unknown.iter().map(ToString::to_string).collect(),
            differences: one.found.differences.iter().map(|difference| one.row(difference)).collect(),
        })
        .collect();
    io.json(&answers)
}
