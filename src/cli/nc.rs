//! `fitcheck nc`: the programs, tables and mask with which a control measures features itself.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, TypedValueParser};

use super::args::dialogue;
use super::io::{not_dash, unless_forced, write_new};
use super::plan::{is_plan_file, read_named, whole};
use super::{CliError, CliRemark, IntoCliError as _, Io, Outcome, TableArgs};
use crate::files;
use crate::nc::sets::{Control, ControlFolder, FeatureError, MOST_PARTS, NcSet, SetError, SingleFault, Target, single};
use crate::part::{Column, DEFAULT_CLEARANCE_HEIGHT, Plan};
use crate::tolerance::Sources;
use crate::words::Dialogue;

const EXAMPLES: &str = "\
Examples:
  fitcheck nc \"25 H7\" --x 40 --y 30 --z -8 --control tnc7 -o folder
  fitcheck nc \"35 +0.2/0\" --feature hole --x 40 --y 30 --z -8 --control tnc640 -o folder
  fitcheck nc plan.csv --control itnc530 --language de -o set.zip
  fitcheck nc plan.csv --control tnc620 --folder 'TNC:\\nc_prog\\order_12' -o order_12
  fitcheck nc plan.csv --control tnc640 --series=200 -o series

A plan is a TOML file, or a CSV or workbook with one feature per line; docs/PLANS.md
describes each column. The columns of a feature, in any order:
  {columns}
A set uses these of them:
  callout, x, y, z          size such as 25 H7 or 35 +0.2/0; centre and measuring height in mm
  feature                   hole or shaft, for a diameter or width whose callout has no class
  kind                      diameter (of a hole or shaft, default), width (of a slot or ridge), face,
                            pocket or boss (four walls), point (of any surface)
  axis                      of a width: X (default) or Y; of a face: where the probe moves, such as -Z;
                            its coordinate is the nominal size, with a shaft class: 40 h9; of a point:
                            where the probe moves, such as -Z or three components such as 0.5 0 -1
  callout2                  of a pocket or boss: the side along Y, while callout is the side along X;
                            default: the same
  name                      letters, digits and _; names the file with the result; default: F1, F2 ...
  angle                     of the first contact from +X, degrees; default: 0
  clearance                 set-up clearance in mm, added to MP6140 or SET_UP; default: 2
  clearance_height          where the probe moves freely, mm; default: 50

The callout of a point is the band about its nominal place along the normal, such as ±0.05 or
+0.1/-0.05: above it is rework, below it scrap. An iTNC 530 has no cycle for points.

The set holds a main program, the program that it calls, the tables 82553 (FIT_HOLE.TAB and
FIT_SHAFT.TAB for later controls), the mask and a page that says what goes where. The tables have
the 47 classes of NC-Solution 8255 and an extra column for each other class of the plan. The limits
of a callout without a class, such as 35 +0.2/0 or 10m, stand in the main program. The set judges by
the limits alone: a rule, an uncertainty or a material of the plan is named in a remark and in
README.TXT. A plan that names a cycle or parameters is refused.

With --tolerance-texts a TNC7 judges diameters itself, by ISO 286 and the text of its cycle; the
tables then serve the window. A set whose limits are not those of the text is refused.

--series writes a main program that measures the next part of a series each time it is started,
without asking. Each part becomes a row of a table and a block of a protocol, with mean, range and
worst status so far; a part that is scrap stops the program. fitcheck import reads both back: the
table as it is, the protocol through the mask of the set; with --plan every value finds its feature.
The table has a row for each of PARTS parts, 100 where no number is given.

A name that ends in .zip becomes one file, any other a folder. Existing files are kept:
--force overwrites them.

Exit codes: 0 done, 1 bad data, 2 wrong usage.";

/// The help with the columns that a plan has now, a line of at most 100 characters each.
fn help() -> String {
    let mut lines = vec![String::new()];
    for column in Column::ALL {
        let line = lines.last_mut().filter(|line| line.len() + column.key().len() < 98);
        match line {
            Some(line) if line.is_empty() => line.push_str(column.key()),
            Some(line) => *line = format!("{line}, {}", column.key()),
            None => lines.push(column.key().to_owned()),
        }
    }
    EXAMPLES.replace("{columns}", &lines.join(",\n  "))
}

/// Write programs, tables and mask with which a control measures fits
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Args {
    /// A callout such as "25 H7", a plan as CSV, or - for a plan from standard input
    #[arg(value_name = "CALLOUT|PLAN.csv")]
    what: String,
    /// Control for which the files are written; an iTNC 530 needs NC software 340 49x-07 or 606 42x-02, or later
    #[arg(long, value_parser = control())]
    control: Control,
    /// Folder or .zip to write
    #[arg(short, long, value_name = "FOLDER|FILE.zip")]
    output: PathBuf,
    /// Language of comments, status words and mask
    #[arg(long, default_value = "en", value_parser = dialogue())]
    language: Dialogue,
    /// Measure a series: one part after the other, in a table for so many parts
    #[arg(
        long,
        value_name = "PARTS",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "100",
        value_parser = clap::value_parser!(u16).range(1..=i64::from(MOST_PARTS))
    )]
    series: Option<u16>,
    /// Folder on the control; default: the control's usual one
    #[arg(long, value_name = "TNC:\\FOLDER")]
    folder: Option<String>,
    /// Also write the plan as a simulated workpiece for fitcheck run, with every feature in the middle of its zone
    #[arg(long, value_name = "FILE.toml")]
    workpiece_out: Option<PathBuf>,
    /// Measure holes and shafts by the cycle of a TNC7 that takes the tolerance as a text, such as 25H7
    #[arg(long)]
    tolerance_texts: bool,
    /// Overwrite existing files
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    position: Position,
    #[command(flatten)]
    tables: TableArgs,
}

/// Where a single feature is.
#[derive(Debug, clap::Args)]
struct Position {
    /// Centre in X, mm
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    x: Option<String>,
    /// Centre in Y, mm
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    y: Option<String>,
    /// Measuring height in Z, mm
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    z: Option<String>,
    /// Angle of the first contact from +X, degrees [default: 0]
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true)]
    angle: Option<String>,
    /// Set-up clearance, mm, added to the probe's own [default: 2]
    #[arg(long, value_name = "MM")]
    clearance: Option<String>,
    /// Height at which the probe moves freely, mm [default: 50]
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    clearance_height: Option<String>,
    /// What is measured: diameter, width of a slot or ridge, face, pocket, boss or point [default: diameter]
    #[arg(long)]
    kind: Option<String>,
    /// Measured axis of a width, X or Y; direction in which a face or point is probed, such as -Z or "0.5 0 -1"
    #[arg(long, allow_hyphen_values = true)]
    axis: Option<String>,
    /// The side of a pocket or boss along Y [default: as along X]
    #[arg(long, value_name = "CALLOUT")]
    callout2: Option<String>,
    /// Hole or shaft, for a callout that does not say which: 10m, "12 ±0.02"
    #[arg(long, value_parser = ["hole", "shaft"])]
    feature: Option<String>,
    /// Name of the feature [default: F1]
    #[arg(long)]
    name: Option<String>,
}

/// A control by its name: TNC 320 and TNC 620 take the same files as TNC 640.
fn control() -> impl TypedValueParser<Value = Control> {
    let names = PossibleValuesParser::new(["itnc530", "tnc640", "tnc620", "tnc320", "tnc7"]);
    names.try_map(|name| Control::from_code(&name).ok_or(std::fmt::Error))
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        let target = self.target()?;
        let (name, plan) = self.plan(&sources, io)?;
        let set = named(NcSet::make(&plan, &target, &sources), name.as_deref(), io)?;
        for remark in &set.remarks {
            io.remark(remark);
        }
        if !self.is_plan() && self.position.clearance_height.is_none() {
            io.remark(&CliRemark::ClearanceHeight { height: DEFAULT_CLEARANCE_HEIGHT });
        }
        // Nothing is written where the second of the two would be refused.
        if let Some(path) = self.workpiece_out.as_ref().filter(|path| !self.force && path.exists()) {
            return Err(unless_forced(files::FileError::Exists { path: path.clone() }, self.force));
        }
        self.save(&set, io)?;
        if let Some(path) = &self.workpiece_out {
            let text = plan.workpiece().write().map_err(|error| SetError::Workpiece { reason: error.to_string() });
            write_new(path, text.said()?.as_bytes(), self.force)?;
            io.note(CliRemark::Wrote { path: path.display().to_string() });
        }
        Ok(Outcome::Done)
    }

    fn is_plan(&self) -> bool {
        is_plan_file(Path::new(&self.what))
    }

    fn target(&self) -> Result<Target, CliError> {
        let new = Target::new(self.control, self.language);
        let usual = Target { by_text: self.tolerance_texts, parts: self.series, ..new };
        let Some(folder) = &self.folder else { return Ok(usual) };
        let folder: ControlFolder = folder.parse().said()?;
        Ok(Target { folder, ..usual })
    }

    fn plan(&self, sources: &Sources, io: &mut Io<'_>) -> Result<(Option<String>, Plan), CliError> {
        if self.is_plan() {
            if let Some(option) = self.position.given() {
                return Err(CliError::OptionBesidePlan { option });
            }
            let (name, plan) = read_named(Path::new(&self.what), sources, io)?;
            return Ok((Some(name), plan));
        }
        let document = single(&self.what, &self.position.cells()).or_else(|fault| match fault {
            SingleFault::Callout(error) => Err(error).about(&self.what),
            SingleFault::NoFeature(error) => Err(CliError::AddFeature { error }),
            // Every coordinate is an option of its column's name.
            SingleFault::NoCoordinate { column } => Err(CliError::OptionMissing { option: column }),
        })?;
        Ok((None, whole(&document, None, sources, io)?))
    }

    fn save(&self, set: &NcSet, io: &mut Io<'_>) -> Result<(), CliError> {
        not_dash(&self.output)?;
        if self.output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("zip")) {
            let bytes = set.zip().said()?;
            write_new(&self.output, &bytes, self.force)?;
            let path = self.output.display().to_string();
            io.note(CliRemark::WroteFiles { path, count: set.files.len() });
            return Ok(());
        }
        let files: Vec<(&str, &[u8])> =
            set.files.iter().map(|file| (file.name.as_str(), file.bytes.as_slice())).collect();
        for path in
            files::write_folder(&self.output, &files, self.force).map_err(|error| unless_forced(error, self.force))?
        {
            io.note(CliRemark::Wrote { path: path.display().to_string() });
        }
        Ok(())
    }
}

/// Adds the plan's file to its errors, and tells all of them.
fn named(set: Result<NcSet, SetError>, name: Option<&str>, io: &mut Io<'_>) -> Result<NcSet, CliError> {
    let about = |error: FeatureError| match name {
        Some(name) => Err(error).about(name),
        None => Err(error).said(),
    };
    match set {
        Err(SetError::Feature(error)) => about(error),
        Err(SetError::Features { first, others }) => {
            let mut last: Result<NcSet, CliError> = about(*first);
            for error in others {
                if let Err(before) = std::mem::replace(&mut last, about(error)) {
                    io.fail(before);
                }
            }
            last
        }
        set => set.said(),
    }
}

impl Position {
    /// Every option with its name, and the column of a plan that it fills.
    fn all(&self) -> [(&'static str, Column, Option<&String>); 11] {
        [
            ("x", Column::X, self.x.as_ref()),
            ("y", Column::Y, self.y.as_ref()),
            ("z", Column::Z, self.z.as_ref()),
            ("angle", Column::Angle, self.angle.as_ref()),
            ("clearance", Column::Clearance, self.clearance.as_ref()),
            ("clearance-height", Column::ClearanceHeight, self.clearance_height.as_ref()),
            ("feature", Column::Feature, self.feature.as_ref()),
            ("name", Column::Name, self.name.as_ref()),
            ("kind", Column::Kind, self.kind.as_ref()),
            ("axis", Column::Axis, self.axis.as_ref()),
            ("callout2", Column::SecondCallout, self.callout2.as_ref()),
        ]
    }

    /// The first option that was given.
    fn given(&self) -> Option<&'static str> {
        self.all().into_iter().find(|(.., given)| given.is_some()).map(|(option, ..)| option)
    }

    /// What was given, as cells of a plan.
    fn cells(&self) -> Vec<(Column, String)> {
        self.all().into_iter().filter_map(|(_, column, text)| Some((column, text?.clone()))).collect()
    }
}
