//! `fitcheck check`: one verdict, printed through a mask.

use std::path::PathBuf;
use std::str::FromStr;
use std::sync::Arc;

use super::args::dialogue;
use super::judging::{FeatureArg, JudgeArgs};
use super::material::Part;
use super::record::RecordArgs;
use super::said::decided;
use super::{CliError, CliRemark, CliWarning, ErrorSubject, Format, IntoCliError as _, Io, Outcome, TableArgs, budget};
use crate::budget::Assessment;
use crate::control::mask::Mask;
use crate::exchange::contacts::Contacts;
use crate::files;
use crate::journal::{Record, status_window};
use crate::length::{Length, Unit};
use crate::message::IntoArg as _;
use crate::probing::measure::{ProbePosition, cycle_number, measure};
use crate::probing::measurement::{Caveat, measure_contacts};
use crate::probing::simulated::{Machine, Probe, Workpiece};
use crate::probing::{Measurement, Origin};
use crate::report::{csv, json};
use crate::tolerance::fit::materials::Certainty;
use crate::tolerance::fit::thermal::Correction;
use crate::tolerance::{Callout, FigureWarning, Limits, LimitsError, Sources};
use crate::verdict::{Rule, Status};
use crate::words::Dialogue;

const EXAMPLES: &str = "Examples:
  fitcheck check \"25 H7\" --measured 25.012
  fitcheck check \"25 H7\" --measured 25,012 --mask nl
  fitcheck check \"25 H7\" --contacts bore.csv --format json
  fitcheck check \"25 h6\" --simulate --seed 7
  fitcheck check \"25 H7\" --measured 25.0195 --rule iso14253-2017 --u 1.2

Exit codes: 0 good, 10 rework, 11 scrap, 12 re-measure, 13 out of limits,
14 judged, but look first (see fitcheck --help), 1 bad data, 2 wrong usage.";

/// Judge one measured value and print the control's status window
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// "25 H7", "10m", "12 +0.01 -0.015", "12.01/11.985", or with --feature one part of "25 H7/g6"
    callout: String,
    #[command(flatten)]
    source: SourceArgs,
    /// Seed of the simulated scatter; the same seed gives the same contacts
    #[arg(long, value_name = "N", default_value_t = 1, conflicts_with_all = ["measured", "contacts"])]
    seed: u64,
    /// Hole or shaft, for a callout that does not say which: 10m, "12 ±0.02", or one part of "25 H7/g6"
    #[arg(long, value_enum)]
    feature: Option<FeatureArg>,
    /// True diameter of the simulated workpiece in mm; default: the middle of the zone
    #[arg(long, value_name = "MM", conflicts_with_all = ["measured", "contacts"])]
    true_diameter: Option<String>,
    /// Mask of a language (nl, de, en, it) or your own mask file
    #[arg(long, value_name = "LANGUAGE|FILE")]
    mask: Option<MaskArg>,
    /// Language of the status words and of the L_ sections in your own mask; without --mask, also of the mask
    #[arg(long, default_value = "en", value_parser = dialogue())]
    language: Dialogue,
    /// Format of the answer; text prints only the text of the mask
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    by: JudgeArgs,
    #[command(flatten)]
    record: RecordArgs,
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
    /// Contacts as CSV with columns x, y and optionally z, in mm; - reads standard input
    #[arg(long, value_name = "FILE.csv")]
    contacts: Option<PathBuf>,
    /// Measure a simulated workpiece
    #[arg(long)]
    simulate: bool,
}

/// A built-in mask by its language, or a file.
#[derive(Debug, Clone)]
enum MaskArg {
    Shipped(Dialogue),
    Own(PathBuf),
}

impl FromStr for MaskArg {
    type Err = std::convert::Infallible;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let language = Dialogue::ALL.into_iter().find(|language| language.code() == text);
        Ok(language.map_or_else(|| Self::Own(PathBuf::from(text)), Self::Shipped))
    }
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        // Without a budget a wrong rule is refused before anything is read.
        let rule = if self.by.budget.is_none() { Some(self.by.rule.rule()?) } else { None };
        let recorder = self.record.recorder(io)?;
        let sources = self.tables.load(io)?;
        let asked = self.callout.trim();
        let asked = if asked.is_empty() { ErrorSubject::Callout.arg() } else { asked.arg() };
        let callout: Callout = self.callout.parse().about(&asked)?;
        let feature = self.feature.map(FeatureArg::feature);
        let limits = match sources.limits(&callout, feature) {
            Err(error @ LimitsError::NoFeature { .. }) => return Err(CliError::AddFeature { error }),
            Err(error @ LimitsError::Zone(_)) => return Err(CliError::AddWideZone { asked, error }),
            limits => limits.about(&asked)?,
        };
        let measurement = self.measurement(&callout, &limits, io)?;
        let correction = self.by.warm.correction(measurement.diameter)?;
        let callout = callout.of_part(limits.feature);
        let record = Record::judged(super::now(), String::new(), Some(callout), limits, measurement, None);
        let record = match &correction {
            Some((correction, _)) => record.corrected(*correction),
            None => record,
        };
        let (rule, budget) = match rule {
            Some(rule) => (rule, None),
            None => self.rule_by_budget(&record, io)?,
        };
        let record = match &budget {
            Some(found) => record.by_budget(rule, Arc::new(found.provenance())),
            None => record.by(rule),
        };
        let status = record.verdict.status();
        warn(&record, &sources, io);
        if let Some(why) = record.verdict.undecided {
            io.warn(&why);
        }
        if let Some((correction, warmth)) = &correction {
            for doubt in &warmth.doubts {
                io.warn(doubt);
            }
            tell_correction(correction, &warmth.part, io);
        }
        if matches!(self.format, Format::Text) {
            tell_rule(&record, io);
        }
        if status == Status::OutOfLimits {
            let size = &record.verdict.size;
            let (side, beyond) = match size.below_maximum {
                below if below < Length::ZERO => ("above", below.abs()),
                _ => ("below", size.above_minimum.abs()),
            };
            io.remark(&CliRemark::ReworkOrScrap { asked, um: beyond.exact(Unit::Micrometre, 0), side });
        }
        if record.measurement.origin.is_simulated() && matches!(self.format, Format::Text) {
            io.tell(CliRemark::Simulated);
        }
        let printed = match self.format {
            Format::Text => self.print_window(&record, io),
            Format::Json => print_json(&record, budget.as_ref(), io),
            Format::Csv => print_csv(&record, io),
        };
        // It is recorded whoever reads what is printed.
        if let Some(mut recorder) = recorder {
            recorder.size(Arc::new(record), io.files())?;
            recorder.keep(io)?;
        }
        printed?;
        Ok(Outcome::Judged(status))
    }

    /// The rule with the uncertainty that the budget gives for this measurement, and that budget.
    fn rule_by_budget(&self, record: &Record, io: &mut Io<'_>) -> Result<(Rule, Option<Assessment>), CliError> {
        let Some(path) = &self.by.budget else { return Ok((self.by.rule.rule()?, None)) };
        let conditions = record.conditions().about(&ErrorSubject::Option { name: "budget" })?;
        let (found, uncertainty) = budget::assess(path, &conditions, io)?;
        budget::introduce(&found, io);
        Ok((self.by.rule.rule_with(Some(uncertainty))?, Some(found)))
    }

    fn measurement(&self, callout: &Callout, limits: &Limits, io: &mut Io<'_>) -> Result<Measurement, CliError> {
        if let Some(text) = &self.source.measured {
            let diameter = super::diameter(text, ErrorSubject::MeasuredValue)?;
            return Ok(Measurement::of_diameter(diameter, Origin::Typed));
        }
        if let Some(path) = &self.source.contacts {
            let (name, Contacts { contacts, .. }) = super::read_contacts(path, self.by.warm.counted()?, io)?;
            let origin = Origin::Contacts { file: name.as_str().into() };
            return measure_contacts(&contacts, origin).about(&name);
        }
        // A simulated workpiece is a hole or a shaft.
        let no_feature = || CliError::AddFeature { error: LimitsError::NoFeature { callout: *callout } };
        let feature = limits.feature.ok_or_else(no_feature)?;
        let diameter = match &self.true_diameter {
            Some(text) => text.parse().about(&ErrorSubject::TrueDiameter)?,
            None => limits.middle(),
        };
        let workpiece = Workpiece::usual(feature, diameter.to_mm_f64());
        let mut machine = Machine::new(workpiece, Probe::USUAL, self.seed).about(&ErrorSubject::SimulatedWorkpiece)?;
        let origin = Origin::Simulated { cycle: cycle_number(feature), seed: self.seed };
        let position = ProbePosition::default();
        let measured =
            measure(feature, limits, &position, &mut machine, origin).about(&ErrorSubject::SimulatedMeasurement)?;
        Ok(measured.0)
    }

    fn print_window(&self, record: &Record, io: &mut Io<'_>) -> Result<(), CliError> {
        let language = self.language;
        let text = match self.mask.as_ref().unwrap_or(&MaskArg::Shipped(language)) {
            MaskArg::Shipped(language) => status_window(record, *language, None).said()?,
            MaskArg::Own(path) => {
                let name = path.display().to_string();
                let (mask, warnings) = Mask::read(&files::read(path)?).about(&name)?;
                for warning in warnings {
                    io.warn_about(&name, &warning);
                }
                if let Some(warning) = mask.other_languages(language) {
                    io.warn_about(&name, &warning);
                }
                status_window(record, language, Some(&mask)).about(&name)?
            }
        };
        io.people().write_all(text.as_bytes());
        if let Some(removal) = record.verdict.size.removal {
            let limit = removal.to_limit;
            let middle = removal.to_middle;
            io.note(CliRemark::Remove { limit, middle });
        }
        Ok(())
    }
}

/// Warns about the measured value and the figures behind its limits; what else the measurement cannot tell is in CSV
/// and JSON.
fn warn(record: &Record, sources: &Sources, io: &mut Io<'_>) {
    if let Some(doubt) = record.callout.and_then(|callout| sources.zone_doubt(&callout, &record.limits)) {
        io.warn(&doubt);
    }
    if let Some(doubt) = record.doubt {
        io.warn(&doubt);
    }
    for caveat in record.caveats() {
        let is_silent = matches!(
            caveat,
            Caveat::OnlyADiameter
                | Caveat::OnlyACircle
                | Caveat::ThreeContacts
                | Caveat::FourContacts
                | Caveat::FewContacts { .. }
        );
        if !is_silent {
            io.warn(&caveat);
        }
    }
    let figure = record.callout.and_then(|callout| FigureWarning::of_limits(&callout, &record.limits, sources));
    if let Some(warning) = figure {
        io.warn(&warning);
    }
}

/// How the value was brought to 20 °C: never in silence, in any format.
fn tell_correction(correction: &Correction, part: &Part, io: &mut Io<'_>) {
    let Correction { measured, at_reference, part: warm, scale } = *correction;
    io.remark(&CliRemark::Corrected {
        measured,
        temperature: warm.temperature,
        material: part.name.clone().unwrap_or_else(|| "none".to_owned()),
        expansion: warm.expansion,
        change: correction.change().signed_um(),
        at_reference,
    });
    if let Some(scale) = scale {
        io.remark(&CliRemark::Scales { temperature: scale.temperature, expansion: scale.expansion });
    }
    if part.certainty == Certainty::Verify {
        io.warn(&CliWarning::ExpansionUnconfirmed { expansion: warm.expansion });
    }
    if correction.against_exact() != Length::ZERO {
        io.remark(&CliRemark::LinearCorrection { off: correction.against_exact().signed_um() });
    }
}

/// What a decision rule says of the value; nothing by the control's own rule without an uncertainty.
fn tell_rule(record: &Record, io: &mut Io<'_>) {
    let Some(decision) = record.decision() else { return };
    io.remark(&CliRemark::Rule { rule: record.verdict.rule });
    for said in decided(&decision) {
        io.remark(&said);
    }
    if record.verdict.is_beyond_limits() {
        io.warn(&CliWarning::BeyondLimits);
    }
}

fn print_json(record: &Record, budget: Option<&Assessment>, io: &mut Io<'_>) -> Result<(), CliError> {
    let mut object = json::object(record).said()?;
    if let Some(budget) = budget {
        // The object says all that these say.
        object.retain(|name, _value| !name.starts_with("budget"));
        object.insert("budget".to_owned(), super::budget::head(budget).into());
    }
    io.json(&object);
    Ok(())
}

fn print_csv(record: &Record, io: &mut Io<'_>) -> Result<(), CliError> {
    let bytes = csv::render(std::slice::from_ref(record)).said()?;
    io.data().write_all(&bytes);
    Ok(())
}
