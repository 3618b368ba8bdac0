//! `fitcheck table new` and `table export`: tables of any classes and sizes, for controls and for other tools.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::builder::PossibleValuesParser;

use crate::cli::{CliError, Io, Outcome, StandardArgs, heard_or_not, read_input, save};
use crate::control::deviations::read_table;
use crate::control::shipped_tables;
use crate::exchange::tables::{TABLE_FORMATS, TableFormat, table_format};
use crate::length::Length;
use crate::tolerance::compare::compare;
use crate::tolerance::iso286;
use crate::tolerance::table_edit::{MakeError, standard_table, table_of_standard};
use crate::tolerance::{DeviationTable, Feature, ToleranceClass};

const NEW_EXAMPLES: &str = "\
Examples:
  fitcheck table new --classes \"H7 H8 JS9\" -o my_hole.tab
  fitcheck table new --classes \"H7 g6 h6\" --to 1000 --generation tnc640 -o my.tab
  fitcheck table new --classes preferred --ends \"3 6 10 18 30 50\" --generation tnc7 -o shop.tab

Holes and shafts never share a table: with classes of both, my.tab becomes my_hole.tab and my_shaft.tab. A cell is empty
where ISO 286 does not define the class, and where a range of --ends has more than one value of it: a warning says so.";

const EXPORT_EXAMPLES: &str = "\
Examples:
  fitcheck table export --format csv                       the built-in tables, to standard output
  fitcheck table export my_hole.tab --format pcdmis -o iso.csv
  fitcheck table export --classes \"H7 h6 g6\" --to 3150 --format pcdmis -o iso.csv

Columns of CSV: class, over_mm, to_mm, upper_um, lower_um. pcdmis: two lines a class, its size bounds and its pairs of upper
and lower deviation in mm.";

/// Which classes and sizes of ISO 286.
#[derive(Debug, clap::Args)]
struct Choice {
    /// Last size in mm, up to 3150
    #[arg(long, value_name = "MM", default_value = "400")]
    to: String,
    /// Ends of the size ranges in mm, instead of those that the classes need
    #[arg(long, value_name = "MM MM ...", conflicts_with = "to")]
    ends: Option<String>,
    #[command(flatten)]
    standard: StandardArgs,
}

/// Make a control table of any classes and sizes of ISO 286
#[derive(Debug, clap::Args)]
#[command(after_help = NEW_EXAMPLES)]
pub(super) struct NewArgs {
    /// Classes such as "H7 H8 js6"; preferred: those of ISO 286-1; control: the 47 of NC-Solution 8255
    #[arg(long, value_name = "CLASSES")]
    classes: String,
    #[command(flatten)]
    choice: Choice,
    /// Which generation of controls the table is for
    #[arg(long, default_value = "itnc530", value_parser = PossibleValuesParser::new(["itnc530", "tnc640", "tnc7"]))]
    generation: String,
    /// The table's file, *.tab
    #[arg(short, long, value_name = "FILE.tab")]
    output: PathBuf,
}

/// Write tables of deviations for other tools
#[derive(Debug, clap::Args)]
#[command(after_help = EXPORT_EXAMPLES)]
pub(super) struct ExportArgs {
    /// Control tables (*.tab); without any the two built-in ones, or ISO 286 with --classes
    #[arg(conflicts_with = "classes")]
    files: Vec<PathBuf>,
    /// Classes of ISO 286, such as "H7 h6", preferred or control
    #[arg(long, value_name = "CLASSES")]
    classes: Option<String>,
    #[command(flatten)]
    choice: Choice,
    /// The format
    #[arg(long, value_parser = PossibleValuesParser::new(TABLE_FORMATS.iter().map(|format| format.name)))]
    format: String,
    /// The file to write; - or nothing is standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl NewArgs {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let classes = classes(&self.classes)?;
        let format = format(&self.generation)?;
        let is_table = self.output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("tab"));
        if !is_table {
            return Err(CliError::Data(format!("{}: the name of a control table ends in .tab", self.output.display())));
        }
        // Everything is made before anything is written.
        let mut files = Vec::new();
        for (path, classes) in self.parts(&classes) {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let table = self.choice.table(&name, &classes, io)?;
            files.push((path, (format.write)(&table).map_err(|error| CliError::Data(format!("{name}: {error}")))?));
        }
        for (path, bytes) in files {
            save(&path, &bytes, io)?;
        }
        Ok(Outcome::Done)
    }

    /// One file, or one for holes and one for shafts.
    fn parts(&self, classes: &[ToleranceClass]) -> Vec<(PathBuf, Vec<ToleranceClass>)> {
        let of = |feature| classes.iter().copied().filter(|class| class.feature() == feature).collect::<Vec<_>>();
        let (holes, shafts) = (of(Feature::Hole), of(Feature::Shaft));
        if holes.is_empty() || shafts.is_empty() {
            return vec![(self.output.clone(), classes.to_vec())];
        }
        let stem = self.output.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let named = |feature: &str| self.output.with_file_name(format!("{stem}_{feature}.tab"));
        vec![(named("hole"), holes), (named("shaft"), shafts)]
    }
}

impl Choice {
    fn table(&self, name: &str, classes: &[ToleranceClass], io: &mut Io<'_>) -> Result<DeviationTable, CliError> {
        let options = self.standard.options();
        let made = match &self.ends {
            Some(ends) => {
                let ends: Result<Vec<_>, _> = ends.split([' ', ';']).filter(|end| !end.is_empty()).map(size).collect();
                table_of_standard(name, classes, ends?, options)
            }
            None => standard_table(name, classes, size(&self.to)?, options),
        };
        let table = made.map_err(|error: MakeError| CliError::Data(error.to_string()))?;
        let mut empty: Vec<_> = compare(&table, options).differences.into_iter().map(|d| (d.class, d.range)).collect();
        empty.dedup();
        for (class, range) in empty {
            let over = range.checked_sub(1).and_then(|before| table.ends().get(before)).copied().unwrap_or_default();
            let to = table.ends().get(range).copied().unwrap_or_default();
            let why = "is left empty: ISO 286 has no single value for all of it";
            io.tell(format_args!("warning: {name}: {class} over {over} up to {to} mm {why}"))?;
        }
        Ok(table)
    }
}

impl ExportArgs {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let format = format(&self.format)?;
        let tables = self.tables(io)?;
        if format.endings.contains(&"tab") && 1 < tables.len() {
            return Err(CliError::Data(
                "a control table is one file: name one table, or classes of one feature".into(),
            ));
        }
        let mut bytes = Vec::new();
        for (number, table) in tables.iter().enumerate() {
            let part = (format.write)(table).map_err(|error| CliError::Data(format!("{}: {error}", table.name())))?;
            // One header, however many tables.
            let header =
                if format.name == "csv" && 0 < number { part.iter().position(|byte| *byte == b'\n') } else { None };
            bytes.extend(part.into_iter().skip(header.map_or(0, |end| end + 1)));
        }
        match self.output.as_deref().filter(|path| *path != Path::new("-")) {
            Some(path) => save(path, &bytes, io)?,
            None => heard_or_not(io.out.write_all(&bytes))?,
        }
        Ok(Outcome::Done)
    }

    fn tables(&self, io: &mut Io<'_>) -> Result<Vec<Arc<DeviationTable>>, CliError> {
        if let Some(text) = &self.classes {
            let classes = classes(text)?;
            let mut tables = Vec::new();
            for (feature, name) in [(Feature::Hole, "iso286_hole.tab"), (Feature::Shaft, "iso286_shaft.tab")] {
                let part: Vec<_> = classes.iter().copied().filter(|class| class.feature() == feature).collect();
                if !part.is_empty() {
                    tables.push(Arc::new(self.choice.table(name, &part, io)?));
                }
            }
            return Ok(tables);
        }
        if self.files.is_empty() {
            return Ok(shipped_tables());
        }
        self.files.iter().map(|path| table_file(path, io)).collect()
    }
}

fn table_file(path: &Path, io: &mut Io<'_>) -> Result<Arc<DeviationTable>, CliError> {
    let (name, bytes) = read_input(path, io)?;
    let read = read_table(&bytes, &name, &name, false);
    let (table, warnings) = read.map_err(|error| CliError::Data(error.to_string()))?;
    for warning in warnings {
        io.tell(format_args!("warning: {warning}"))?;
    }
    table.map(Arc::new).ok_or_else(|| CliError::Data(format!("{name} is no table of deviations")))
}

/// Classes by name, or one of the two lists.
fn classes(text: &str) -> Result<Vec<ToleranceClass>, CliError> {
    let both = [Feature::Hole, Feature::Shaft];
    let found: Vec<_> = match text.trim() {
        "preferred" => both.into_iter().flat_map(iso286::preferred_classes).collect(),
        "control" => {
            let tables = shipped_tables();
            tables.iter().flat_map(|table| table.columns().iter().map(|column| column.class)).collect()
        }
        text => {
            let words = text.split([' ', ',', ';']).filter(|word| !word.is_empty());
            let classes: Result<_, _> = words.map(str::parse::<ToleranceClass>).collect();
            classes.map_err(|error| CliError::Data(error.to_string()))?
        }
    };
    if found.is_empty() { Err(CliError::Data(MakeError::NoClass.to_string())) } else { Ok(found) }
}

fn size(text: &str) -> Result<Length, CliError> {
    text.parse().map_err(|error| CliError::Data(format!("size: {error}")))
}

fn format(name: &str) -> Result<&'static TableFormat, CliError> {
    // Names come from the list, so clap has refused every other.
    table_format(name).ok_or_else(|| CliError::Data(format!("{name} is no format of a table")))
}
