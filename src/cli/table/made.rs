//! `fitcheck table new` and `table export`: tables of any classes and sizes, for controls and for other tools.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::cli::args::{classes, one_of};
use crate::cli::io::is_dash;
use crate::cli::{
    CliError, CliRemark, CliWarning, ErrorSubject, IntoCliError as _, Io, Outcome, StandardArgs, put, read_table, save,
};
use crate::control::shipped_tables;
use crate::exchange::tables::{PARQUET, TABLE_FORMATS, TableFormat, parquet_of};
use crate::files;
use crate::length::Length;
use crate::tolerance::compare::{compare, contradiction};
use crate::tolerance::table_edit::{standard_table, table_of_standard};
use crate::tolerance::{DeviationTable, Feature, ToleranceClass};

const NEW_EXAMPLES: &str = "\
Examples:
  fitcheck table new --classes \"H7 H8 JS9\" -o my_hole.tab
  fitcheck table new --classes \"H7 g6 h6\" --to 1000 --generation tnc640 -o my.tab
  fitcheck table new --classes preferred --ends \"3 6 10 18 30 50\" --generation tnc7 -o shop.tab

Holes and shafts never share a table: with classes of both, my.tab becomes my_hole.tab and
my_shaft.tab. A cell is empty if ISO 286 does not define the class, or if a range of --ends has
more than one value of it: a warning says so.";

const EXPORT_EXAMPLES: &str = "\
Examples:
  fitcheck table export --format csv                       the built-in tables, to standard output
  fitcheck table export my_hole.tab --format pcdmis -o iso.csv
  fitcheck table export --classes \"H7 h6 g6\" --to 3150 --format pcdmis -o iso.csv

Columns of CSV: class, over_mm, to_mm, upper_um, lower_um. Columns of Parquet, which programs built
with the feature parquet write: class, hole, over_mm, to_mm, lower_mm, upper_mm. pcdmis: two lines
per class, its size limits and its pairs of upper and lower deviation in mm. The manual of PC-DMIS
shows only H7: in PC-DMIS, check each class whose lower deviation is not 0 before you rely on it. A
control table has the name of its file.";

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
    /// Generation of controls for which the table is made
    #[arg(long, default_value = "itnc530", value_parser = one_of(generations(), |format| format.name))]
    generation: &'static TableFormat,
    /// The table's file, *.tab; - is standard output
    #[arg(short, long, value_name = "FILE.tab")]
    output: PathBuf,
}

/// Write tables of deviations for other tools
#[derive(Debug, clap::Args)]
#[command(after_help = EXPORT_EXAMPLES)]
#[command(mut_args(only_with_classes))]
pub(super) struct ExportArgs {
    /// Control tables (*.tab); default: the two built-in ones, or ISO 286 with --classes
    #[arg(conflicts_with = "classes")]
    files: Vec<PathBuf>,
    /// Classes of ISO 286, such as "H7 h6", preferred or control
    #[arg(long, value_name = "CLASSES")]
    classes: Option<String>,
    #[command(flatten)]
    choice: Choice,
    /// Format of the file
    #[arg(long, value_parser = one_of(TABLE_FORMATS.iter().chain([&PARQUET]), |format| format.name))]
    format: &'static TableFormat,
    /// The file to write; - or no file is standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Options of a table that is made have no effect on one that is copied.
fn only_with_classes(arg: clap::Arg) -> clap::Arg {
    match arg.get_id().as_str() {
        "to" | "ends" | "edition" | "js_rounded" => arg.requires("classes").conflicts_with("files"),
        _ => arg,
    }
}

impl NewArgs {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let classes = classes(&self.classes)?;
        let is_table = self.output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("tab"));
        if !is_table && !is_dash(&self.output) {
            return Err(CliError::TableEnding { path: self.output.clone() });
        }
        // Everything is made before anything is written.
        let mut files = Vec::new();
        for (path, classes) in self.parts(&classes) {
            let name = files::name_of(&path).to_string_lossy().into_owned();
            let table = self.choice.table(&name, &classes, io)?;
            let bytes = (self.generation.write)(&table).about(&name)?;
            files.push((path, name, bytes));
        }
        match files.as_slice() {
            [(path, _, bytes)] if is_dash(path) => io.data().write_all(bytes),
            _ if is_dash(&self.output) => return Err(CliError::Dash),
            [(path, _, bytes)] => save(path, bytes, io)?,
            // One for holes and one for shafts belong together.
            both => {
                let named: Vec<_> = both.iter().map(|(_, name, bytes)| (name.as_str(), bytes.as_slice())).collect();
                let folder = self.output.parent().unwrap_or(Path::new(""));
                for path in files::write_into(folder, &named, true)? {
                    io.note(CliRemark::Wrote { path: path.display().to_string() });
                }
            }
        }
        Ok(Outcome::Done)
    }

    /// One file, or one for holes and one for shafts.
    fn parts(&self, classes: &[ToleranceClass]) -> Vec<(PathBuf, Vec<ToleranceClass>)> {
        let of = |feature| classes.iter().copied().filter(|class| class.feature() == feature).collect::<Vec<_>>();
        let holes = of(Feature::Hole);
        let shafts = of(Feature::Shaft);
        if holes.is_empty() || shafts.is_empty() {
            return vec![(self.output.clone(), classes.to_vec())];
        }
        let stem = self.output.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
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
        let table = made.said()?;
        for (class, range) in compare(&table, options).cells() {
            let Some((over, to)) = table.ranges().nth(range) else { continue };
            io.warn_about(name, &CliWarning::EmptyCell { class, over, to });
        }
        Ok(table)
    }
}

impl ExportArgs {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let format = self.format;
        let output = self.output.as_deref().filter(|path| *path != Path::new("-"));
        if let Some(path) = output.filter(|path| !format.fits(path)) {
            let path = path.to_owned();
            let endings = format.endings.join(", .");
            return Err(CliError::FormatEnding { path, format: format.name, endings });
        }
        let tables = self.tables(io)?;
        if format.endings.contains(&"tab") && 1 < tables.len() {
            return Err(CliError::SeveralTables);
        }
        let bytes =
            if format.name == PARQUET.name { parquet_of(&tables).said()? } else { self.texts(&tables, output)? };
        put(output, &mut |out| out.write_all(&bytes), io)?;
        if let Some(warning) = tables.iter().find_map(|table| (format.warning)(table)) {
            io.tell(crate::cli::said::warning(&warning));
        }
        Ok(Outcome::Done)
    }

    /// The files of all tables, one behind the other.
    fn texts(&self, tables: &[Arc<DeviationTable>], output: Option<&Path>) -> Result<Vec<u8>, CliError> {
        let format = self.format;
        let mut bytes = Vec::new();
        for (number, table) in tables.iter().enumerate() {
            // A control finds a table by its file's name.
            let file = output.and_then(Path::file_name).filter(|_| format.endings.contains(&"tab"));
            let renamed = file.map(|file| table.named(&file.to_string_lossy()));
            let table = renamed.as_ref().unwrap_or(table);
            let part = (format.write)(table).about(table.name())?;
            // One header, however many tables there are.
            let header =
                if format.name == "csv" && 0 < number { part.iter().position(|byte| *byte == b'\n') } else { None };
            bytes.extend(part.into_iter().skip(header.map_or(0, |end| end + 1)));
        }
        Ok(bytes)
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
        let tables: Result<Vec<_>, CliError> =
            self.files.iter().map(|path| Ok(Arc::new(read_table(path, io)?.0))).collect();
        let tables = tables?;
        match contradiction(tables.iter().map(Arc::as_ref)) {
            Some(found) => Err(found).said(),
            None => Ok(tables),
        }
    }
}

/// The formats of control tables.
fn generations() -> impl Iterator<Item = &'static TableFormat> {
    TABLE_FORMATS.iter().filter(|format| format.endings.contains(&"tab"))
}

fn size(text: &str) -> Result<Length, CliError> {
    text.parse().about(&ErrorSubject::Size)
}
