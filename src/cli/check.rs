//! `fitcheck check`: one verdict, printed through a mask.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::builder::PossibleValuesParser;

use super::{CliError, Format, Io, Outcome, TableArgs, heard_or_not};
use crate::control::mask::Mask;
use crate::control::status::status_window;
use crate::exchange::contacts;
use crate::files;
use crate::journal::Record;
use crate::length::Length;
use crate::probing::measure::{ProbePosition, cycle_number, measure};
use crate::probing::measurement::measure_contacts;
use crate::probing::simulated::{Machine, Probe, Workpiece};
use crate::probing::{Measurement, Origin};
use crate::report::{csv, json};
use crate::tolerance::{Callout, Feature, Limits, LimitsError, Source};
use crate::verdict::Status;
use crate::words::Language;

const EXAMPLES: &str = "Examples:
  fitcheck check \"25 H7\" --measured 25.012
  fitcheck check \"25 H7\" --measured 25,012 --mask nl
  fitcheck check \"25 H7\" --contacts bore.csv --format json
  fitcheck check \"25 h6\" --simulate --seed 7

Exit codes: 0 good, 10 rework, 11 scrap, 12 re-measure, 1 bad data, 2 wrong usage.";

/// One verdict, printed through a mask
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// "25 H7", "10m", "12 +0.01 -0.015", "12.01/11.985", or with --feature one part of "25 H7/g6"
    callout: String,
    #[command(flatten)]
    source: SourceArgs,
    /// Seed of the simulated scatter: the same seed gives the same contacts
    #[arg(long, value_name = "N", default_value_t = 1, conflicts_with_all = ["measured", "contacts"])]
    seed: u64,
    /// Hole or shaft, for a callout that does not say it: 10m, "12 ±0.02", or one part of "25 H7/g6"
    #[arg(long, value_enum)]
    feature: Option<FeatureArg>,
    /// True diameter of the simulated workpiece in mm; without it the middle of the zone
    #[arg(long, value_name = "MM", conflicts_with_all = ["measured", "contacts"])]
    true_diameter: Option<String>,
    /// Mask of a language (nl, de, en, it) or your own mask file
    #[arg(long, value_name = "LANGUAGE|FILE")]
    mask: Option<MaskArg>,
    /// Language of the status words and of L_ sections in your own mask; without --mask also of the mask
    #[arg(long, default_value = "en", value_parser = PossibleValuesParser::new(Language::ALL.map(Language::code)))]
    language: String,
    /// text prints the mask's text and nothing else
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    tables: TableArgs,
}

/// How to say which part is meant.
const FEATURES: &str = "--feature hole or --feature shaft";

/// Hole or shaft.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum FeatureArg {
    /// An inner size.
    Hole,
    /// An outer size.
    Shaft,
}

impl FeatureArg {
    const fn feature(self) -> Feature {
        match self {
            Self::Hole => Feature::Hole,
            Self::Shaft => Feature::Shaft,
        }
    }
}

/// Where the diameter comes from: exactly one.
#[derive(Debug, clap::Args)]
#[group(required = true, multiple = false)]
struct SourceArgs {
    /// The measured diameter in mm, decimal point or comma
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    measured: Option<String>,
    /// Contacts as CSV with columns x,y and perhaps z, in mm; - reads standard input
    #[arg(long, value_name = "FILE.csv")]
    contacts: Option<PathBuf>,
    /// Measure a simulated workpiece
    #[arg(long)]
    simulate: bool,
}

/// A shipped mask by its language, or a file.
#[derive(Debug, Clone)]
enum MaskArg {
    Shipped(Language),
    Own(PathBuf),
}

impl FromStr for MaskArg {
    type Err = std::convert::Infallible;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let language = Language::ALL.into_iter().find(|language| language.code() == text);
        Ok(language.map_or_else(|| Self::Own(PathBuf::from(text)), Self::Shipped))
    }
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        let asked = Some(self.callout.trim()).filter(|text| !text.is_empty()).unwrap_or("callout");
        let callout: Callout = self.callout.parse().map_err(|error| data(asked, &error))?;
        let feature = self.feature.map(FeatureArg::feature);
        let unstated = feature.is_none() && callout.feature().is_none();
        let limits = if unstated { sources.size_limits(&callout) } else { sources.limits(&callout, feature) };
        let limits = limits.map_err(|error| match error {
            LimitsError::NoFeature { .. } => CliError::Data(format!("{error}: add {FEATURES}")),
            error => data(asked, &error),
        })?;
        if unstated && self.source.simulate {
            let error = LimitsError::NoFeature { callout };
            return Err(CliError::Data(format!("{error}: add {FEATURES}")));
        }
        let measurement = self.measurement(&limits, io)?;
        let measured = measurement.diameter;
        let callout = callout.of_part(limits.feature);
        let record = Record::judged(super::now(), String::new(), Some(callout), limits, measurement, None);
        let status = record.verdict.status();
        if unstated && (status == Status::Rework || status == Status::Scrap) {
            let (minimum, maximum) = (record.limits.minimum(), record.limits.maximum());
            return Err(CliError::Data(format!(
                "{asked}: {measured} mm is outside {minimum} to {maximum} mm; whether that is rework or scrap depends on \
                 hole or shaft: add {FEATURES}"
            )));
        }
        warn(&record, io)?;
        match self.format {
            Format::Text => self.print_window(&record, io)?,
            Format::Json => print_json(&record, unstated, io)?,
            Format::Csv => print_csv(&record, unstated, io)?,
        }
        Ok(Outcome::Judged(record.verdict.status()))
    }

    fn measurement(&self, limits: &Limits, io: &mut Io<'_>) -> Result<Measurement, CliError> {
        if let Some(text) = &self.source.measured {
            let diameter: Length = text.parse().map_err(|error| data("measured value", &error))?;
            if diameter <= Length::ZERO {
                return Err(CliError::Data(format!("measured value: {diameter} mm is not above 0")));
            }
            return Ok(Measurement::of_diameter(diameter, Origin::Typed));
        }
        if let Some(path) = &self.source.contacts {
            return measure_file(path, io);
        }
        let diameter = match &self.true_diameter {
            Some(text) => text.parse().map_err(|error| data("true diameter", &error))?,
            None => limits.middle(),
        };
        let workpiece = Workpiece::usual(limits.feature, diameter.to_mm_f64());
        let mut machine =
            Machine::new(workpiece, Probe::USUAL, self.seed).map_err(|error| data("simulated workpiece", &error))?;
        let origin = Origin::Simulated { cycle: cycle_number(limits.feature), seed: self.seed };
        let position = ProbePosition::default();
        let (measurement, _) =
            measure(limits, &position, &mut machine, origin).map_err(|error| data("simulated measurement", &error))?;
        Ok(measurement)
    }

    fn print_window(&self, record: &Record, io: &mut Io<'_>) -> Result<(), CliError> {
        let language = Language::from_code(&self.language).unwrap_or_default();
        let text = match self.mask.as_ref().unwrap_or(&MaskArg::Shipped(language)) {
            MaskArg::Shipped(language) => {
                status_window(record, *language, None).map_err(|error| CliError::Data(error.to_string()))?
            }
            MaskArg::Own(path) => {
                let name = path.display().to_string();
                let (mask, warnings) = Mask::read(&files::read(path)?).map_err(|error| data(&name, &error))?;
                for warning in warnings {
                    io.tell(format_args!("warning: {name}: {warning}"))?;
                }
                status_window(record, language, Some(&mask)).map_err(|error| data(&name, &error))?
            }
        };
        heard_or_not(io.out.write_all(text.as_bytes()))?;
        if let Some(removal) = record.verdict.size.removal {
            let (limit, middle) = (removal.to_limit, removal.to_middle);
            io.tell(format_args!("remove {limit} mm to the nearest limit, {middle} mm to the middle of the zone"))?;
        }
        Ok(())
    }
}

/// What is odd about the measured value; what the measurement cannot tell stands in CSV and JSON.
fn warn(record: &Record, io: &mut Io<'_>) -> Result<(), CliError> {
    if let Some(doubt) = record.doubt {
        io.tell(format_args!("warning: {doubt}"))?;
    }
    if let Source::Table { instead_of: Some(shipped), name, .. } = &record.limits.source {
        let (upper, lower) = (shipped.upper(), shipped.lower());
        io.tell(format_args!("warning: table {name} differs from ISO 286, which has {upper} and {lower} mm"))?;
    }
    Ok(())
}

fn measure_file(path: &Path, io: &mut Io<'_>) -> Result<Measurement, CliError> {
    let (name, bytes) = super::read_input(path, io)?;
    let read = contacts::read(&bytes).map_err(|error| data(&name, &error))?;
    for column in read.ignored {
        io.tell(format_args!("warning: {name}: column {column} is not used"))?;
    }
    let origin = Origin::Contacts { file: name.as_str().into() };
    measure_contacts(&read.contacts, origin).map_err(|error| data(&name, &error))
}

/// `unstated`: the callout has no letters and nobody said hole or shaft, so the file does not say it either.
fn print_json(record: &Record, unstated: bool, io: &mut Io<'_>) -> Result<(), CliError> {
    let mut object = json::object(record).map_err(|error| CliError::Data(error.to_string()))?;
    if let Some(feature) = object.get_mut("feature").filter(|_| unstated) {
        *feature = serde_json::Value::Null;
    }
    let text = serde_json::to_string_pretty(&object).map_err(|error| CliError::Data(error.to_string()))?;
    heard_or_not(writeln!(io.out, "{text}"))
}

fn print_csv(record: &Record, unstated: bool, io: &mut Io<'_>) -> Result<(), CliError> {
    let render = if unstated { csv::render_without_feature } else { csv::render };
    let bytes = render(std::slice::from_ref(record)).map_err(|error| CliError::Data(error.to_string()))?;
    heard_or_not(io.out.write_all(&bytes))
}

fn data(what: &str, error: &impl std::fmt::Display) -> CliError {
    CliError::Data(format!("{what}: {error}"))
}
