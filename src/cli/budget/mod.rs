//! `fitcheck budget`: an uncertainty budget for a size and contacts.
//!
//! | file | what |
//! |---|---|
//! | `found` | a budget's file, and what is said of it; for `check`, too |
//! | `figures` | the answer for programs |
//! | `text` | the same for people |

mod figures;
mod found;
mod text;

use std::path::PathBuf;

use jiff::civil::Date;

use super::pair::read_parts;
use super::{CliError, CliWarning, ErrorSubject, Format, IntoCliError as _, Io, Outcome, read_contacts, said};
use crate::budget::{Assessment, Basis, Conditions, ContributionKind, Geometry};
use crate::length::Length;
use crate::report::pairing::PairingParts;
use crate::tolerance::fit::thermal::Temperature;
pub(super) use found::{assess, head, introduce, read};

const EXAMPLES: &str = "\
Examples:
  fitcheck budget station3.toml --size 25
  fitcheck budget station3.toml --size 25 --touches 3 --step 60
  fitcheck budget station3.toml --size 25 --contacts bore.csv --format json
  fitcheck budget ring30.toml --readings ring30.csv
  fitcheck check \"25 H7\" --measured 25.0195 --rule iso14253-2017 --budget station3.toml

The file is TOML: name, date, by, valid_until, and either [[contribution]] tables, combined as in
the GUM, or one table [calibrated] for repeated measurements of a calibrated piece (ISO 15530-3). A
contribution:
  name = \"Setting ring\"    type = \"B\"    law = \"normal\"    expanded_um = 1.0    k = 2
law: normal (standard_um, or expanded_um with k), rectangular, u-shaped, triangular (half_width_um).
kind: scatter of a touch (touches, step_deg), part-temperature and scale-temperature (alpha_per_k, and
standard_k, expanded_k or half_width_k), part-expansion and scale-expansion (delta_k from 20 °C, and
standard_per_k, expanded_per_k or half_width_per_k), resolution (resolution_um). Any may have
sensitivity and degrees_of_freedom; default: 1 and infinite.

The coverage factor is that of Student's law for 95.45 %, to the thousandth. CSV has a row per
contribution, one for the combined uncertainty, and one for each thing that would help most.";

/// Evaluate an uncertainty budget: contributions, combined and expanded uncertainty, what would help most
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// The budget as TOML; - reads standard input
    #[arg(value_name = "FILE.toml")]
    file: PathBuf,
    /// Measured size in mm, for contributions that depend on temperature
    #[arg(long, value_name = "MM")]
    size: Option<String>,
    /// Number of touches, instead of those in the file
    #[arg(long, value_name = "N", requires = "step")]
    touches: Option<u32>,
    /// Angle from one touch to the next in degrees
    #[arg(long, value_name = "DEG", requires = "touches")]
    step: Option<String>,
    /// Contacts that were taken, as CSV with columns x, y and optionally z, in mm
    #[arg(long, value_name = "FILE.csv", conflicts_with = "touches")]
    contacts: Option<PathBuf>,
    /// Readings of the calibrated piece, in any format that import reads, instead of those in the file
    #[arg(long, value_name = "FILE")]
    readings: Option<PathBuf>,
    /// Day on which the budget must be valid; default: today
    #[arg(long, value_name = "YYYY-MM-DD")]
    date: Option<Date>,
    /// Format of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// What was said before the budget was evaluated.
#[derive(Debug, Default)]
struct ReadingMessages {
    /// Readings that cannot be used.
    refused: Vec<String>,
    /// What to check about the readings and the options.
    warnings: Vec<String>,
}

impl ReadingMessages {
    fn of(read: Option<&PairingParts>) -> Self {
        let Some(read) = read else { return Self::default() };
        Self { refused: read.errors.iter().map(ToString::to_string).collect(), warnings: read.warnings() }
    }
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let (name, budget) = read(&self.file, io)?;
        let size =
            self.size.as_ref().map(|text| super::diameter(text, ErrorSubject::Option { name: "size" })).transpose()?;
        let conditions = Conditions { size, geometry: self.geometry(io)?, ..Conditions::default() };
        let read = match (&budget.basis, &self.readings) {
            (Basis::Calibrated(piece), Some(path)) => Some(read_parts(path, piece.feature, io)?),
            _ => None,
        };
        let mut beside = ReadingMessages::of(read.as_ref());
        for option in self.unused(&budget.basis) {
            let warning = CliWarning::BudgetOption { option };
            io.warn(&warning);
            beside.warnings.push(warning.to_string());
        }
        let readings = read.map(|read| read.measured);
        let day = self.date.unwrap_or_else(|| super::now().date());
        let found = Assessment::of(budget, &conditions, readings.as_deref(), day).about(&name)?;
        beside.warnings.extend(found.budget.template_figures().iter().map(ToString::to_string));
        // Nothing is judged here.
        for warning in found.warnings().into_iter().chain(found.budget.template_figures()) {
            io.tell(said::warning(&warning));
        }
        match self.format {
            Format::Json => io.json(&figures::json(&found, &conditions, &beside)),
            Format::Csv => figures::csv(&found, io),
            Format::Text => text::print(&found, &conditions, io),
        }
        Ok(if beside.refused.is_empty() { Outcome::Done } else { Outcome::BadData })
    }

    fn geometry(&self, io: &mut Io<'_>) -> Result<Option<Geometry>, CliError> {
        if let Some(path) = &self.contacts {
            let (name, read) = read_contacts(path, Temperature::REFERENCE, io)?;
            return Geometry::of_contacts(&read.contacts).map(Some).about(&name);
        }
        let (Some(touches), Some(step)) = (self.touches, &self.step) else { return Ok(None) };
        let about = ErrorSubject::Option { name: "step" };
        // A step has the digits of a length: a millionth of a degree.
        let step: Length = step.parse().about(&about)?;
        Geometry::steps(touches, step.to_mm_f64()).map(Some).about(&ErrorSubject::Option { name: "touches" })
    }

    /// Options that change nothing for this budget.
    fn unused(&self, basis: &Basis) -> Vec<&'static str> {
        let has = |wanted: fn(ContributionKind) -> bool| match basis {
            Basis::Contributions(contributions) => contributions.iter().any(|one| wanted(one.kind)),
            Basis::Calibrated(_) => false,
        };
        let has_scatter = has(|kind| matches!(kind, ContributionKind::Scatter(_)));
        let depends_on_size = has(ContributionKind::grows_with_size);
        let is_calibrated = matches!(basis, Basis::Calibrated(_));
        let options = [
            ("size", self.size.is_some(), depends_on_size),
            ("touches", self.touches.is_some(), has_scatter),
            ("contacts", self.contacts.is_some(), has_scatter),
            ("readings", self.readings.is_some(), is_calibrated),
        ];
        options.into_iter().filter(|(_, given, used)| *given && !used).map(|(option, ..)| option).collect()
    }
}
