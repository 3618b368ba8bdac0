//! `fitcheck stats`: control chart, capability and advice for features from files of measurements; studies of gauges.
//!
//! | file | what |
//! |---|---|
//! | `read` | the values of the files |
//! | `charts` | the options of the chart |
//! | `study` | studies of gauges and groups: their options, the budget |
//! | `print` | the figures as text, CSV and JSON |
//! | `picture` | all charts on one sheet |
//! | `list` | every feature in a line |

mod charts;
mod list;
mod picture;
mod print;
mod read;
mod study;

use std::path::PathBuf;

use super::args::one_of;
use super::import::columns;
use super::{CliError, ErrorSubject, Format, IntoCliError as _, Io, Outcome, TableArgs};
use crate::length::Length;
use crate::message::Say as _;
use crate::series::{Answer, Factor, Grouping, Series, SeriesError, Wanted, names_are_parts};
use crate::statistics::Family;

const EXAMPLES: &str = "\
Values are read as fitcheck import reads them, of one feature, in the order of the files. Limits come from callouts, columns or a plan, \
or from --lower and --upper. A lower limit of 0 that is no coordinate is a natural one: then only the upper limit counts.
Simulated, invalid and doubtful values are left out and counted.

Cp and Cpk have the standard deviation within subgroups, Pp and Ppk that of all values. Every figure states its method. \
Rules are looked at on the chart of single values or means; on ranges and standard deviations only control limits are.

Examples:
  fitcheck stats bores.csv
  fitcheck stats rings.csv --group 5 --rules western-electric
  fitcheck stats --plan flange.toml --feature bore1 monday.dfq tuesday.dfq --group part
  fitcheck stats roundness.csv --upper 0.008 --law folded-normal --format json
  fitcheck stats bores.csv --chart cusum --stage 31 --leave-out 12='chip in the bore'
  fitcheck stats study.csv --study crossed --lower 24.99 --upper 25.01
  fitcheck stats ring.csv --study type1 --reference 30.0012 --lower 29.99 --upper 30.01
  fitcheck stats bores.csv --compare machine
  fitcheck stats bores.csv --picture bores.png
  fitcheck stats --plan flange.toml monday.dfq --all

A study shows how the file was understood, such as 10 parts, 3 operators, 3 repeats. A layout that looks swapped is refused. A gauge is good enough \
if Cg and Cgk reach 1.33, or if it takes at most 10 % of the tolerance; 10 % to 30 % depends on the use (AIAG MSA).

Columns of --format csv: name, value, lower, upper, method, note. Lengths are in mm. A rule has a line for each point at which it fires. \
Columns with --all: feature, count, outside, signals, ppk, lower, upper, note.

The exit code is 1 if a row or file could not be read or nothing could be computed, 14 if doubtful values were left out, and 0 otherwise: \
what the figures say of the process does not change it.";

/// Control chart, capability and advice for a feature; studies of gauges
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Files with measurements of any format that import reads
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,

    /// The feature, where the files have several
    #[arg(long, value_name = "NAME")]
    feature: Option<String>,

    /// Subgroups: 5 for so many values in a row; part, batch, machine, gauge or who for those in a row that have it in common; 30min, 8h or 2d
    /// for those with no longer pause between them
    #[arg(long, value_name = "N|COLUMN|PAUSE", value_parser = grouping, default_value = "1", hide_default_value = true)]
    group: Grouping,

    /// What the columns of a CSV hold, as in fitcheck import
    #[arg(long, value_name = "LIST|FILE")]
    columns: Option<String>,

    /// Part plan: its features and their limits count
    #[arg(long, value_name = "PLAN")]
    plan: Option<PathBuf>,

    #[command(flatten)]
    tables: TableArgs,

    /// Lower limit in mm instead of that of the files
    #[arg(long, value_name = "MM", allow_hyphen_values = true, help_heading = "Limits")]
    lower: Option<String>,

    /// Upper limit in mm instead of that of the files
    #[arg(long, value_name = "MM", allow_hyphen_values = true, help_heading = "Limits")]
    upper: Option<String>,

    /// Size that is aimed at, in mm; default: the middle between both limits
    #[arg(long, value_name = "MM", allow_hyphen_values = true, help_heading = "Limits")]
    target: Option<String>,

    #[command(flatten)]
    charts: charts::ChartArgs,

    #[command(flatten)]
    gauge: study::StudyArgs,

    /// Every feature in a line, those that need a look first
    #[arg(long, conflicts_with_all = ["feature", "lower", "upper", "target"])]
    all: bool,

    /// Also draw all charts of the feature on one sheet: a file that ends in .svg or .png
    #[arg(long, value_name = "FILE", value_parser = picture::file, conflicts_with = "all")]
    picture: Option<picture::PictureFile>,

    /// Distribution for capability by percentiles, besides the normal figures
    #[arg(long, value_name = "LAW", value_parser = one_of(Family::ALL, |family| family.word()))]
    law: Option<Family>,

    /// Level of the intervals
    #[arg(long, value_name = "LEVEL", default_value = "0.95", value_parser = level)]
    level: f64,

    /// Format of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// Reads `--group`.
fn grouping(text: &str) -> Result<Grouping, String> {
    let text = text.trim();
    let figures = text.trim_end_matches(|character: char| character.is_ascii_alphabetic());
    let unit = text.get(figures.len()..).unwrap_or_default();
    let minutes = [("min", 1), ("h", 60), ("d", 24 * 60)].into_iter().find(|(name, _)| *name == unit);
    let number = figures.trim().parse::<u32>().ok().filter(|number| 0 < *number);
    let found = match (number, minutes) {
        (Some(1), None) if unit.is_empty() => Some(Grouping::Single),
        (Some(size), None) if unit.is_empty() => usize::try_from(size).ok().map(Grouping::Of),
        (Some(number), Some((_, minutes))) => number.checked_mul(minutes).map(Grouping::Pause),
        _ => Factor::ALL.into_iter().find(|factor| factor.word() == text).map(Grouping::By),
    };
    found.ok_or_else(|| {
        "expected a number of values, part, batch, machine, gauge, who, or a pause such as 30min".to_owned()
    })
}

fn level(text: &str) -> Result<f64, String> {
    let found = text.parse().ok().filter(|level: &f64| 0.5 <= *level && *level < 1.0);
    found.ok_or_else(|| "expected a level from 0.5 to below 1, such as 0.95".to_owned())
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        let mapping = self.columns.as_deref().map(columns::mapping).transpose()?;
        let plan = self.plan.as_ref().map(|path| super::plan::read_plan(path, &sources, io)).transpose()?;
        if self.all && self.charts.names_points() {
            return Err(CliError::StatsPoints);
        }
        if self.charts.has_idle_parameters() {
            return Err(CliError::StatsParameters);
        }
        let mut read = read::read(&self.files, &sources, mapping.as_ref(), plan.as_ref(), io);
        // What is missing was told; for people a sheet of nothing would hide it.
        if read.has_failed && read.values.is_empty() && self.format == Format::Text {
            return Ok(Outcome::BadData);
        }
        if self.feature.is_none() && self.gauge.has_parts() {
            names_are_parts(&mut read.values);
        }
        if self.all {
            let wanted = Wanted { law: self.law, level: self.level, ..self.charts.wanted() };
            let is_empty = list::list(&read.values, self.group, &wanted, self.format, io);
            return Ok(if read.has_failed || is_empty { Outcome::BadData } else { Outcome::Done });
        }
        let series =
            Series::of(&read.values, self.feature.as_deref(), self.group).map_err(|error| self.refused(error))?;
        let wanted = self.wanted(&series)?;
        let answer = self.answer(&series, &wanted)?;
        match self.format {
            Format::Text => print::text(&series, &answer, io),
            Format::Csv => print::csv(&series, &answer, io),
            Format::Json => io.json(&print::json(&series, &answer)),
        }
        if let Some(doubt) = &answer.doubt {
            return Err(CliError::StatsLayout { doubt: doubt.message() });
        }
        self.gauge.save(&answer, &self.files, io)?;
        if let Some(picture) = &self.picture {
            picture.save(&series, &answer, io)?;
        }
        if series.has_doubts() {
            io.look_first();
        }
        let is_bad = read.has_failed || answer.is_empty();
        Ok(if is_bad { Outcome::BadData } else { Outcome::Done })
    }

    fn answer(&self, series: &Series<'_>, wanted: &Wanted) -> Result<Answer, CliError> {
        if let Some(kind) = self.gauge.study {
            return Answer::of_study(series, wanted, &self.gauge.wanted(kind)?).said();
        }
        match self.gauge.compare {
            Some(factor) => Answer::of_groups(series, wanted, factor).map_err(|error| self.refused(error)),
            None => Ok(Answer::of(series, wanted)),
        }
    }

    fn wanted(&self, series: &Series<'_>) -> Result<Wanted, CliError> {
        let mm = |name, text: &Option<String>| -> Result<Option<f64>, CliError> {
            let length = text.as_ref().map(|text| text.parse::<Length>().about(&ErrorSubject::Option { name }));
            Ok(length.transpose()?.map(Length::to_mm_f64))
        };
        let given = [mm("lower", &self.lower)?, mm("upper", &self.upper)?];
        if let [Some(lower), Some(upper)] = given
            && upper <= lower
        {
            return Err(CliError::NoLimits);
        }
        let limits = if given.iter().any(Option::is_some) {
            given
        } else {
            series.limits().map_err(|error| self.refused(error))?
        };
        let wanted = Wanted {
            limits,
            target: mm("target", &self.target)?,
            law: self.law,
            level: self.level,
            ..self.charts.wanted()
        };
        wanted.checked(series).map_err(|error| self.refused(error))?;
        Ok(wanted)
    }

    fn refused(&self, error: SeriesError) -> CliError {
        match error {
            SeriesError::Features(names) => CliError::StatsFeatures { names },
            SeriesError::NoFeature(names) => {
                CliError::StatsNoFeature { given: self.feature.clone().into_iter().collect(), names }
            }
            SeriesError::Limits => CliError::StatsLimits,
            SeriesError::NoPoint { point, count } => CliError::StatsNoPoint { point, count },
            SeriesError::Reason(why) => CliError::StatsReason { why: why.message() },
        }
    }
}
