//! `fitcheck decide`: what a decision rule makes of limits and an uncertainty, of one value, and of a whole process.

use serde_json::{Map, Value as Json, json};

use super::rule::RuleArgs;
use super::{CliError, ErrorSubject, Format, IntoCliError as _, Io, Outcome};
use crate::length::{Length, Unit};
use crate::tolerance::{Bounds, Deviations, Feature};
use crate::verdict::rules::{Acceptance, Prior, Risks, RuleName, Zones, acceptance_for, percent};
use crate::verdict::{Rule, Status};

const EXAMPLES: &str = "\
Examples:
  fitcheck decide --lower 25 --upper 25.021 --rule iso14253-2017 --u 1.2
  fitcheck decide --lower 25 --upper 25.021 --measured 25.0195 --rule ilac-g8 --expanded 2.4
  fitcheck decide --lower 25 --upper 25.021 --u 1.2 --process-mean 25.012 --process-sd 3
  fitcheck decide --upper 0.002 --u 0.25 --gamma 4,0.25 --consumer-risk 0.001

Conformity is the probability that the true value lies within the limits, by a normal law about the
measured value (JCGM 106). Consumer's risk: a part is bad and accepted. Producer's risk: a part is
good and not accepted.

Exit codes with --measured: 0 good, 10 rework, 11 scrap, 12 re-measure.";

/// Show zones, conformity and risks of a decision rule
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Lower limit in mm; default: none
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    lower: Option<String>,
    /// Upper limit in mm; default: none
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    upper: Option<String>,
    /// Measured value in mm
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    measured: Option<String>,
    /// Which side can be reworked: a hole that is too small, or a shaft that is too large
    #[arg(long, value_name = "FEATURE", default_value = "hole", value_parser = super::args::one_of([Feature::Hole, Feature::Shaft], |feature| feature.word()))]
    feature: Feature,
    #[command(flatten)]
    rule: RuleArgs,
    /// Mean of the process in mm
    #[arg(long, value_name = "MM", requires = "process_sd", allow_hyphen_values = true, help_heading = "Process")]
    process_mean: Option<String>,
    /// Standard deviation of the process in µm
    #[arg(long, value_name = "UM", requires = "process_mean", help_heading = "Process")]
    process_sd: Option<String>,
    /// Gamma law from 0 upwards, by its shape and its scale in µm, instead of mean and standard deviation
    #[arg(long, value_name = "SHAPE,UM", conflicts_with = "process_mean", help_heading = "Process")]
    gamma: Option<String>,
    /// Show the accepted values for this consumer's risk, such as 0.001
    #[arg(long, value_name = "RISK", help_heading = "Process")]
    consumer_risk: Option<String>,
    /// Format of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// What is asked, read.
struct DecisionRequest {
    rule: Rule,
    bounds: Bounds,
    has: [bool; 2],
    measured: Option<Length>,
    prior: Option<Prior>,
    consumer_risk: Option<f64>,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let asked = self.read()?;
        let zones = asked.rule.zones(&asked.bounds);
        let answer = answer(&asked, &zones)?;
        match self.format {
            Format::Json => io.json(&answer),
            Format::Csv => io.data().write_all(csv(&answer).as_bytes()),
            Format::Text => text(&asked, &answer, io),
        }
        let status = asked.measured.map(|measured| zones.status(asked.bounds.feature, measured));
        Ok(status.map_or(Outcome::Done, Outcome::Judged))
    }

    fn read(&self) -> Result<DecisionRequest, CliError> {
        let length = |name, text: &Option<String>| -> Result<Option<Length>, CliError> {
            text.as_ref().map(|text| text.parse::<Length>().about(&ErrorSubject::Option { name })).transpose()
        };
        let lower = length("lower", &self.lower)?;
        let upper = length("upper", &self.upper)?;
        let has = [lower.is_some(), upper.is_some()];
        let minimum = lower.unwrap_or(Length::MAX.negated());
        let maximum = upper.unwrap_or(Length::MAX);
        let bounds =
            Deviations::new(maximum, minimum).ok().and_then(|limits| Bounds::new(self.feature, Length::ZERO, limits));
        let bounds = bounds.filter(|_bounds| has.contains(&true) && minimum < maximum).ok_or(CliError::NoLimits)?;
        let rule = self.rule.rule()?;
        if rule.name() == RuleName::AsmeSimple && has.contains(&false) {
            return Err(CliError::RatioOfOneLimit);
        }
        let prior = self.prior()?;
        if prior.is_some() && rule.uncertainty().is_none() {
            return Err(CliError::RiskWithoutUncertainty);
        }
        let consumer_risk = match &self.consumer_risk {
            Some(text) => {
                if prior.is_none() {
                    return Err(CliError::RiskWithoutProcess);
                }
                let risk = number(text).filter(|risk| 0.0 < *risk && *risk < 1.0);
                Some(risk.ok_or(CliError::NotARisk { given: text.clone() })?)
            }
            None => None,
        };
        Ok(DecisionRequest { rule, bounds, has, measured: length("measured", &self.measured)?, prior, consumer_risk })
    }

    fn prior(&self) -> Result<Option<Prior>, CliError> {
        let um = |name, text: &str| {
            let length = Length::parse_in(text, Unit::Micrometre).about(&ErrorSubject::Option { name })?;
            if length <= Length::ZERO {
                return Err(CliError::NotAboveZero { diameter: length }).about(&ErrorSubject::Option { name });
            }
            Ok(length.to_mm_f64())
        };
        if let (Some(mean), Some(deviation)) = (&self.process_mean, &self.process_sd) {
            let mean = mean.parse::<Length>().about(&ErrorSubject::Option { name: "process-mean" })?.to_mm_f64();
            return Ok(Some(Prior::Normal { mean, deviation: um("process-sd", deviation)? }));
        }
        let Some(gamma) = &self.gamma else { return Ok(None) };
        let read = gamma
            .split_once(',')
            .and_then(|(shape, scale)| Some((number(shape).filter(|shape| 0.0 < *shape && *shape <= 1e6)?, scale)));
        let (shape, scale) = read.ok_or_else(|| CliError::NotAGamma { given: gamma.clone() })?;
        Ok(Some(Prior::Gamma { shape, scale: um("gamma", scale.trim())? }))
    }
}

/// A decimal number.
fn number(text: &str) -> Option<f64> {
    text.trim().replace(',', ".").parse().ok().filter(|number: &f64| number.is_finite())
}

/// Everything, under the names that programs read.
fn answer(asked: &DecisionRequest, zones: &Zones) -> Result<Map<String, Json>, CliError> {
    let DecisionRequest { rule, bounds, has: [has_lower, has_upper], .. } = *asked;
    let mut answer = Map::new();
    let mut put = |name: &str, value: Json| {
        answer.insert(name.to_owned(), value);
    };
    let mm = |length: Length| json!(length.to_mm_f64());
    let where_limit = |has: bool, length: Length| if has { mm(length) } else { Json::Null };
    put("rule", json!(rule.name().word()));
    put("min_mm", where_limit(has_lower, bounds.minimum()));
    put("max_mm", where_limit(has_upper, bounds.maximum()));
    if let Some(uncertainty) = rule.uncertainty() {
        let um = |text: String| text.parse::<f64>().map_or(Json::Null, |number| json!(number));
        put("u_um", um(uncertainty.um()));
        put("expanded_um", um(uncertainty.expanded_um()));
        put("k", um(uncertainty.k()));
    }
    let accepted = zones.accepted;
    put("zone_min_mm", accepted.map_or(Json::Null, |[least, _]| where_limit(has_lower, least)));
    put("zone_max_mm", accepted.map_or(Json::Null, |[_, most]| where_limit(has_upper, most)));
    let [below, above] = zones.rejected;
    // A rule that decides nothing rejects nothing.
    put("rejected_below_mm", where_limit(has_lower && below != Length::MAX.negated(), below));
    put("rejected_above_mm", where_limit(has_upper && above != Length::MAX, above));
    put("accepts_nothing", json!(accepted.is_none()));
    if let Some(measured) = asked.measured {
        put("measured_mm", mm(measured));
        put("status", json!(zones.status(bounds.feature, measured).word()));
        put("proven", json!(zones.is_proven(measured)));
        if let Some(conformity) = rule.conformity(&bounds, measured) {
            put("conformity", json!(conformity.within));
            put("below", json!(conformity.below));
            put("above", json!(conformity.above));
        }
    }
    if let (Some(prior), Some(uncertainty)) = (asked.prior, rule.uncertainty())
        && let Ok(um) = uncertainty.um().parse::<f64>()
    {
        let ends = |has: [bool; 2], [least, most]: [Length; 2]| {
            let end = |has: bool, length: Length, none: f64| if has { length.to_mm_f64() } else { none };
            [end(has[0], least, f64::NEG_INFINITY), end(has[1], most, f64::INFINITY)]
        };
        let limits = ends(asked.has, [bounds.minimum(), bounds.maximum()]);
        let u = um / 1_000.0;
        let accepted_ends = accepted.map_or(limits, |accepted| ends(asked.has, accepted));
        let risks = Risks::of(prior, &Acceptance { limits, accepted: accepted_ends, u });
        // Where nothing is accepted, all that conforms is not.
        let (consumer, producer) = match accepted {
            Some(_) => (risks.consumer, risks.producer),
            None => (0.0, 1.0 - risks.nonconforming),
        };
        put("nonconforming", json!(risks.nonconforming));
        put("consumer_risk", json!(consumer));
        put("producer_risk", json!(producer));
        if let Some(wanted) = asked.consumer_risk {
            let found = acceptance_for(prior, limits, u, wanted).ok_or(CliError::NoZoneForRisk)?;
            let [least, most] = found.accepted.map(|end| if end.is_finite() { json!(end) } else { Json::Null });
            put("risk_zone_min_mm", least);
            put("risk_zone_max_mm", most);
            put("risk_zone_producer_risk", json!(Risks::of(prior, &found).producer));
        }
    }
    Ok(answer)
}

/// Names and values, a line each.
fn csv(answer: &Map<String, Json>) -> String {
    let cell = |value: &Json| {
        value.as_str().map_or_else(|| if value.is_null() { String::new() } else { value.to_string() }, str::to_owned)
    };
    let lines = answer.iter().map(|(name, value)| format!("{name},{}\n", cell(value)));
    std::iter::once("name,value\n".to_owned()).chain(lines).collect()
}

/// The same for people.
fn text(asked: &DecisionRequest, answer: &Map<String, Json>, io: &mut Io<'_>) {
    let shown = |name: &str| match answer.get(name) {
        None | Some(Json::Null) => "–".to_owned(),
        Some(value) => value.to_string(),
    };
    let is_known = |name: &str| answer.get(name).is_some_and(|value| !value.is_null());
    writeln!(io.people(), "rule          {}", asked.rule);
    writeln!(io.people(), "limits        {} to {} mm", shown("min_mm"), shown("max_mm"));
    if answer.get("accepts_nothing") == Some(&Json::Bool(true)) {
        writeln!(io.people(), "accepted      nothing: the rule leaves nothing of this tolerance");
    } else {
        writeln!(io.people(), "accepted      {} to {} mm", shown("zone_min_mm"), shown("zone_max_mm"));
    }
    if is_known("rejected_below_mm") || is_known("rejected_above_mm") {
        let below = shown("rejected_below_mm");
        let above = shown("rejected_above_mm");
        writeln!(io.people(), "rejected      below {below} mm, above {above} mm");
    } else {
        writeln!(io.people(), "rejected      nothing");
    }
    let probability = |name: &str| answer.get(name).and_then(Json::as_f64).map_or_else(String::new, percent);
    if let Some(status) = asked.measured.map(|measured| asked.rule.status(&asked.bounds, measured)) {
        let proven = match answer.get("proven").and_then(Json::as_bool) {
            Some(true) => ", proven",
            Some(false) => ", not proven",
            None => "",
        };
        writeln!(io.people(), "measured      {} mm: {}{proven}", shown("measured_mm"), Status::word(status));
    }
    if is_known("conformity") {
        let within = probability("conformity");
        let below = probability("below");
        let above = probability("above");
        writeln!(io.people(), "conformity    {within} %, too small {below} %, too large {above} %");
    }
    if is_known("consumer_risk") {
        let bad = probability("nonconforming");
        let consumer = probability("consumer_risk");
        writeln!(io.people(), "process       {bad} % do not conform");
        writeln!(
            io.people(),
            "risks         {consumer} % accepted and bad, {} % good and not accepted",
            probability("producer_risk")
        );
    }
    if is_known("risk_zone_producer_risk") {
        let producer = probability("risk_zone_producer_risk");
        // To the nanometre, inwards: what is shown is accepted.
        let to_nm = |name: &str, inwards: fn(f64) -> f64| {
            let mm = answer.get(name).and_then(Json::as_f64);
            mm.map_or_else(|| "–".to_owned(), |mm| format!("{:.6}", inwards(mm * 1e6) / 1e6))
        };
        let (least, most) = (to_nm("risk_zone_min_mm", f64::ceil), to_nm("risk_zone_max_mm", f64::floor));
        writeln!(io.people(), "for this risk {least} to {most} mm accepted, {producer} % good and not accepted");
    }
}
