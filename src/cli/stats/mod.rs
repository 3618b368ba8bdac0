//! `fitcheck stats`: control chart, capability and advice for one feature from files of measurements.
//!
//! | file | what |
//! |---|---|
//! | `read` | the values of the files |
//! | `print` | the figures as text, CSV and JSON |

mod print;
mod read;

use std::path::PathBuf;

use super::args::one_of;
use super::import::columns;
use super::{CliError, ErrorSubject, Format, IntoCliError as _, Io, Outcome, TableArgs};
use crate::length::Length;
use crate::series::{Answer, Grouping, Series, SeriesError, Wanted};
use crate::statistics::{ChartKind, Family, Rule, Rules};

const EXAMPLES: &str = "\
Values are read as fitcheck import reads them, of one feature, in the order of the files. Limits come from callouts, columns or a plan, \
or from --lower and --upper. A lower limit of 0 that is no coordinate is a natural one: then only the upper limit counts.
Simulated, invalid and doubtful values are left out and counted.

Cp and Cpk have the standard deviation within subgroups, Pp and Ppk that of all values. Every figure states its method. \
Rules are looked at on the chart of single values or means; on ranges and standard deviations only control limits are.

Examples:
  fitcheck stats bores.csv
  fitcheck stats rings.csv --group 5 --rules western-electric
  fitcheck stats --plan flange.toml --feature bore1 monday.dfq tuesday.dfq --by-part
  fitcheck stats roundness.csv --upper 0.008 --law folded-normal --format json

Columns of --format csv: name, value, lower, upper, method, note. Lengths are in mm. A rule has a line for each point at which it fires.

The exit code is 1 if a row or file could not be read or nothing could be computed, 14 if doubtful values were left out, and 0 otherwise: \
what the figures say of the process does not change it.";

/// Control chart, capability and advice for a feature
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Files with measurements of any format that import reads
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,

    /// The feature, where the files have several
    #[arg(long, value_name = "NAME")]
    feature: Option<String>,

    /// Subgroups of this many values in a row
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..), conflicts_with = "by_part")]
    group: Option<u32>,

    /// Subgroups of the values of one part in a row
    #[arg(long)]
    by_part: bool,

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

    /// Chart; default: by the size of the subgroups
    #[arg(long, value_name = "CHART", value_parser = one_of(CHARTS, |chart| chart.0))]
    chart: Option<(&'static str, ChartKind)>,

    /// Rules that are looked at; repeat it for several rules
    #[arg(long = "rules", value_name = "RULES", value_parser = one_of(rules(), |rules| rules.0), default_value = "nelson")]
    rules: Vec<(&'static str, Rules)>,

    /// Control limits from the first N points alone
    #[arg(long, value_name = "N")]
    baseline: Option<usize>,

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

const CHARTS: [(&str, ChartKind); 3] = [
    ("individuals", ChartKind::Individuals),
    ("means-ranges", ChartKind::MeansRanges),
    ("means-deviations", ChartKind::MeansDeviations),
];

/// Sets of rules and single ones by their names.
fn rules() -> impl Iterator<Item = (&'static str, Rules)> {
    let sets = [("nelson", Rules::NELSON), ("western-electric", Rules::WESTERN_ELECTRIC), ("none", Rules::NONE)];
    sets.into_iter().chain(Rule::ALL.map(|rule| (rule.word(), Rules::NONE.with(rule, true))))
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
        let read = read::read(&self.files, &sources, mapping.as_ref(), plan.as_ref(), io);
        let grouping = match self.group {
            Some(size) => Grouping::Of(usize::try_from(size).unwrap_or(usize::MAX)),
            None if self.by_part => Grouping::ByPart,
            None => Grouping::Single,
        };
        let series =
            Series::of(&read.values, self.feature.as_deref(), grouping).map_err(|error| self.refused(error))?;
        let wanted = self.wanted(&series)?;
        let answer = Answer::of(&series, &wanted);
        match self.format {
            Format::Text => print::text(&series, &answer, io),
            Format::Csv => print::csv(&series, &answer, io),
            Format::Json => io.json(&print::json(&series, &answer)),
        }
        if series.has_doubts() {
            io.look_first();
        }
        let is_bad = read.has_failed || answer.is_empty();
        Ok(if is_bad { Outcome::BadData } else { Outcome::Done })
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
        Ok(Wanted {
            limits,
            target: mm("target", &self.target)?,
            chart: self.chart.map(|(_, kind)| kind),
            rules: self.rules.iter().fold(Rules::NONE, |all, (_, rules)| all.or(*rules)),
            baseline: self.baseline,
            law: self.law,
            level: self.level,
        })
    }

    fn refused(&self, error: SeriesError) -> CliError {
        match error {
            SeriesError::Features(names) => CliError::StatsFeatures { names },
            SeriesError::NoFeature(names) => {
                CliError::StatsNoFeature { given: self.feature.clone().into_iter().collect(), names }
            }
            SeriesError::Limits => CliError::StatsLimits,
            SeriesError::NoParts => CliError::StatsNoParts,
        }
    }
}
