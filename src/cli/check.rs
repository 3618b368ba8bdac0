//! `fitcheck check`: one verdict, printed through a mask.

use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::str::FromStr;

use jiff::civil::DateTime;

use super::{CliError, Format, Io, Outcome, TableArgs};
use crate::control::mask::Mask;
use crate::control::status::status_window;
use crate::exchange::contacts;
use crate::files;
use crate::journal::Record;
use crate::length::{Length, Unit};
use crate::probing::{Measurement, Origin};
use crate::session::simulate;
use crate::tolerance::{Callout, Limits};
use crate::verdict::{self, doubt};
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
    /// Nominal size and tolerance class, such as "25 H7"
    callout: String,
    #[command(flatten)]
    source: SourceArgs,
    /// Seed of the simulated scatter: the same seed gives the same contacts
    #[arg(long, value_name = "N", default_value_t = 1, requires = "simulate")]
    seed: u64,
    /// True diameter of the simulated workpiece in mm; without it the middle of the zone
    #[arg(long, value_name = "MM", requires = "simulate")]
    true_diameter: Option<String>,
    /// Mask of a language (nl, de, en, it) or your own mask file
    #[arg(long, value_name = "LANGUAGE|FILE", default_value = "en")]
    mask: MaskArg,
    /// text prints the mask's text and nothing else
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    tables: TableArgs,
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
        let tables = self.tables.load(io)?;
        let callout: Callout = self.callout.parse().map_err(|error| data(&self.callout, &error))?;
        let limits = tables.limits(&callout).map_err(|error| data(&self.callout, &error))?;
        let measurement = self.measurement(&limits, io)?;
        let measured = measurement.diameter;
        let record = Record {
            time: jiff::Zoned::now().datetime(),
            id: String::new(),
            callout: Some(callout),
            verdict: verdict::judge(&limits, measured, None),
            doubt: doubt(limits.nominal, measured),
            limits,
            measurement,
        };
        for warning in warnings(&record) {
            writeln!(io.err, "warning: {warning}")?;
        }
        match self.format {
            Format::Text => self.print_window(&record, io)?,
            Format::Json => print_json(&record, io)?,
            Format::Csv => print_csv(&record, io)?,
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
            return measure_contacts(path, io);
        }
        let diameter = match &self.true_diameter {
            Some(text) => text.parse().map_err(|error| data("true diameter", &error))?,
            None => limits.middle(),
        };
        simulate(limits, diameter, self.seed).map_err(|error| CliError::Data(error.to_string()))
    }

    fn print_window(&self, record: &Record, io: &mut Io<'_>) -> Result<(), CliError> {
        let text = match &self.mask {
            MaskArg::Shipped(language) => status_window(record, *language, None),
            MaskArg::Own(path) => {
                let in_file = |error: &dyn std::fmt::Display| CliError::Data(format!("{}: {error}", path.display()));
                let (mask, warnings) = Mask::read(&files::read(path)?).map_err(|error| in_file(&error))?;
                for warning in warnings {
                    writeln!(io.err, "warning: {}: {warning}", path.display())?;
                }
                status_window(record, Language::En, Some(&mask)).map_err(|error| return in_file(&error))
                    .map_or_else(|error| Err(error), |text| Ok(Ok(text)))?
            }
        };
        let text = text.map_err(|error| CliError::Data(error.to_string()))?;
        io.out.write_all(text.as_bytes())?;
        if let Some(removal) = record.verdict.size.removal {
            writeln!(
                io.err,
                "remove {} mm to the nearest limit, {} mm to the middle of the zone",
                removal.to_limit, removal.to_middle
            )?;
        }
        Ok(())
    }
}

fn data(what: &str, error: &dyn std::fmt::Display) -> CliError {
    CliError::Data(format!("{what}: {error}"))
}
