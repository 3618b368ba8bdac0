//! A record from its fields. What was decided stays as it was decided; [`Record::judged_again`] says what is decided today.

use std::sync::Arc;

use fitcheck_core::budget::{BudgetWarning, Provenance, Validity};
use fitcheck_core::length::Length;
use fitcheck_core::probing::{Circle, Measurement, Origin};
use fitcheck_core::tolerance::fit::thermal::{Correction, Expansion, Temperature, Warm};
use fitcheck_core::tolerance::{Base, Callout, Deviations, Limits, Source, Sources};
use fitcheck_core::verdict::rules::{RuleInputs, RuleName, Uncertainty};
use fitcheck_core::verdict::{
    AxisPosition, Doubt, PositionVerdict, Removal, Rule, SizeVerdict, Undecided, Verdict, judge_size,
};
use fitcheck_nc::control::shipped_tables;

use super::texts::{
    bounded, length, long, name, of_contacts, of_fractions, printed, seed, some_length, two_lengths, whole,
};
use super::{BodyError, wire};
use crate::journal::Record;

pub(super) fn record(size: &wire::Size) -> Result<Record, BodyError> {
    let callout = size.callout.as_ref().map(|text| printed::<Callout>("check.size.callout", text)).transpose()?;
    let measurement = measurement(&size.measurement)?;
    let limits = limits(&size.limits, callout.as_ref(), &measurement.origin)?;
    let rule = rule(&size.rule)?;
    Ok(Record {
        time: printed("check.size.local_time", &size.local_time)?,
        id: name("check.size.id", &size.id)?,
        callout,
        verdict: verdict(&size.verdict, rule, judge_size(&limits, measurement.diameter))?,
        limits,
        measurement,
        doubt: size.doubt.as_ref().map(doubt).transpose()?,
        correction: size.correction.as_ref().map(correction).transpose()?,
        budget: size.budget.as_ref().map(budget).transpose()?.map(Arc::new),
    })
}

fn limits(limits: &wire::Limits, callout: Option<&Callout>, origin: &Origin) -> Result<Limits, BodyError> {
    let nominal = length("check.size.limits.nominal_nm", limits.nominal_nm)?;
    let upper = length("check.size.limits.upper_nm", limits.upper_nm)?;
    let lower = length("check.size.limits.lower_nm", limits.lower_nm)?;
    let wrong = |field| BodyError::Contradiction { field };
    let deviations = Deviations::new(upper, lower).map_err(|_order| wrong("check.size.limits.upper_nm"))?;
    let text = long("check.size.limits.source.text", &limits.source.text)?;
    let range = two_lengths("check.size.limits.source.range_nm", limits.source.range_nm)?;
    let recorded = Source::Recorded { text: text.into(), range: range.map(<(Length, Length)>::from) };
    let mut found = Limits::new(limits.feature, nominal, deviations, recorded)
        .ok_or_else(|| BodyError::value("check.size.limits.nominal_nm", limits.nominal_nm))?;
    if found.minimum().nanometres() != limits.min_nm {
        return Err(wrong("check.size.limits.min_nm"));
    }
    if found.maximum().nanometres() != limits.max_nm {
        return Err(wrong("check.size.limits.max_nm"));
    }
    if let Some(live) = live(&found, callout, origin) {
        found.source = live;
    }
    Ok(found)
}

/// The source that says the very same of the very same deviations today, so that it can be said in every language.
fn live(recorded: &Limits, callout: Option<&Callout>, origin: &Origin) -> Option<Source> {
    let text = recorded.source.with_difference();
    let is_same = |source: &Source| source.range() == recorded.source.range() && source.with_difference() == text;
    let standard = Sources::default();
    let control = || Sources::default().with_base(Base::ControlTables, shipped_tables);
    let of_callout = |sources: &Sources| {
        let (deviations, source) = sources.deviations(callout?, recorded.feature).ok()?;
        (deviations == recorded.deviations).then_some(source).filter(is_same)
    };
    let of_file = || match origin {
        Origin::Contacts { file } | Origin::Imported { file } | Origin::ImportedSimulation { file } => {
            Some(Source::File(Arc::clone(file))).filter(is_same)
        }
        Origin::Simulated { .. } | Origin::Typed => None,
    };
    of_callout(&standard).or_else(of_file).or_else(|| of_callout(&control()))
}

fn measurement(measurement: &wire::Measurement) -> Result<Measurement, BodyError> {
    let file = |file: &str| Ok::<_, BodyError>(name("check.size.measurement.origin.file", file)?.into());
    let circle = measurement.circle_mm.as_ref().map(|texts| {
        let [x, y, diameter] = of_fractions("check.size.measurement.circle_mm", texts)?;
        Ok(Circle { x, y, diameter })
    });
    Ok(Measurement {
        diameter: length("check.size.measurement.diameter_nm", measurement.diameter_nm)?,
        centre: two_lengths("check.size.measurement.centre_nm", measurement.centre_nm)?,
        contacts: of_contacts("check.size.measurement.contacts_mm", &measurement.contacts_mm)?,
        circle: circle.transpose()?,
        origin: match &measurement.origin {
            wire::Origin::Simulated { cycle, seed: text } => {
                Origin::Simulated { cycle: *cycle, seed: seed("check.size.measurement.origin.seed", text)? }
            }
            wire::Origin::Contacts { file: of } => Origin::Contacts { file: file(of)? },
            wire::Origin::Imported { file: of } => Origin::Imported { file: file(of)? },
            wire::Origin::ImportedSimulation { file: of } => Origin::ImportedSimulation { file: file(of)? },
            wire::Origin::Typed {} => Origin::Typed,
        },
    })
}

fn correction(correction: &wire::Correction) -> Result<Correction, BodyError> {
    let warm = |warm: &wire::Warm| {
        let temperature = warm.temperature_c_thousandths;
        let expansion = warm.expansion_um_per_m_k_thousandths;
        Ok(Warm {
            temperature: Temperature::from_thousandths(temperature)
                .ok_or_else(|| BodyError::value("check.size.correction.temperature_c_thousandths", temperature))?,
            expansion: Expansion::from_thousandths(expansion)
                .ok_or_else(|| BodyError::value("check.size.correction.expansion_um_per_m_k_thousandths", expansion))?,
        })
    };
    Ok(Correction {
        measured: length("check.size.correction.measured_nm", correction.measured_nm)?,
        at_reference: length("check.size.correction.at_20c_nm", correction.at_20c_nm)?,
        part: warm(&correction.part)?,
        scale: correction.scale.as_ref().map(warm).transpose()?,
    })
}

fn rule(rule: &wire::Rule) -> Result<Rule, BodyError> {
    let unknown = || BodyError::value("check.size.rule.name", &rule.name);
    let uncertainty = match (rule.u_pm, rule.k_thousandths) {
        (None, None) => None,
        (Some(pm), Some(k)) => {
            let wrong = || BodyError::value("check.size.rule.u_pm", pm);
            Some(Uncertainty::of_picometres(pm, k).ok_or_else(wrong)?)
        }
        _ => return Err(BodyError::Contradiction { field: "check.size.rule.k_thousandths" }),
    };
    let given = RuleInputs {
        uncertainty,
        factor: rule.factor_thousandths,
        width: some_length("check.size.rule.width_nm", rule.width_nm)?,
        prover: rule.prover,
    };
    let name = RuleName::of_word(&rule.name).ok_or_else(unknown)?;
    Rule::new(name, given).map_err(|why| BodyError::value("check.size.rule", why))
}

fn budget(budget: &wire::Budget) -> Result<Provenance, BodyError> {
    bounded("check.size.budget.warnings", &budget.warnings)?;
    let validity = [Validity::Valid, Validity::Expired, Validity::NotYet];
    let validity = validity.into_iter().find(|one| one.word() == budget.validity);
    // These two follow from what is kept; the others are texts, for what they were made of is not kept.
    let known = [
        BudgetWarning::Expired { until: budget.valid_until.clone() },
        BudgetWarning::NotYet { date: budget.date.clone() },
    ]
    .map(|warning| (warning.to_string(), warning));
    let warning = |text: &String| {
        let text = long("check.size.budget.warnings", text)?;
        let live = known.iter().find(|(said, _)| *said == text).map(|(_, warning)| warning.clone());
        Ok(live.unwrap_or(BudgetWarning::Recorded { text }))
    };
    Ok(Provenance {
        name: name("check.size.budget.name", &budget.name)?,
        date: printed("check.size.budget.date", &budget.date)?,
        by: name("check.size.budget.by", &budget.by)?,
        valid_until: printed("check.size.budget.valid_until", &budget.valid_until)?,
        counts_contacts: budget.counts_contacts,
        validity: validity.ok_or_else(|| BodyError::value("check.size.budget.validity", &budget.validity))?,
        warnings: budget.warnings.iter().map(warning).collect::<Result<_, BodyError>>()?,
    })
}

/// The verdict as it was given; what only follows from the size is computed.
fn verdict(verdict: &wire::Verdict, rule: Rule, by_limits: SizeVerdict) -> Result<Verdict, BodyError> {
    let removal = match (verdict.to_limit_nm, verdict.to_middle_nm) {
        (None, None) => None,
        (Some(limit), Some(middle)) => Some(Removal {
            to_limit: length("check.size.verdict.to_limit_nm", limit)?,
            to_middle: length("check.size.verdict.to_middle_nm", middle)?,
        }),
        _ => return Err(BodyError::Contradiction { field: "check.size.verdict.to_middle_nm" }),
    };
    let axis = |axis: &wire::Axis| {
        Ok::<_, BodyError>(AxisPosition {
            deviation: length("check.size.verdict.position.deviation_nm", axis.deviation_nm)?,
            tolerance: some_length("check.size.verdict.position.tolerance_nm", axis.tolerance_nm)?,
        })
    };
    let position = verdict.position.as_ref().map(|[one, other]| Ok([axis(one)?, axis(other)?]));
    let undecided = verdict.undecided.as_ref().map(|undecided| {
        let field = "check.size.verdict.undecided.contacts";
        let contacts = usize::try_from(whole(field, undecided.contacts)?);
        let contacts = contacts.map_err(|_range| BodyError::value(field, undecided.contacts))?;
        Ok(Undecided::Contacts { contacts, times: undecided.times_thousandths })
    });
    Ok(Verdict {
        size: SizeVerdict { status: verdict.size, removal, ..by_limits },
        position: position.transpose()?.map(|axes| PositionVerdict { axes }),
        rule,
        undecided: undecided.transpose()?,
    })
}

fn doubt(doubt: &wire::Doubt) -> Result<Doubt, BodyError> {
    let meant = |nm| some_length("check.size.doubt.meant_nm", nm);
    Ok(match *doubt {
        wire::Doubt::TimesInch { meant_nm } => Doubt::TimesInch { meant: meant(meant_nm)? },
        wire::Doubt::Inches { meant_nm } => Doubt::Inches { meant: meant(meant_nm)? },
        wire::Doubt::Double { meant_nm } => Doubt::Double { meant: meant(meant_nm)? },
        wire::Doubt::Half { meant_nm } => Doubt::Half { meant: meant(meant_nm)? },
        wire::Doubt::DecimalSign { meant_nm } => {
            Doubt::DecimalSign { meant: length("check.size.doubt.meant_nm", meant_nm)? }
        }
        wire::Doubt::Far { distance_nm } => {
            Doubt::Far { distance: length("check.size.doubt.distance_nm", distance_nm)? }
        }
        wire::Doubt::Implausible { lower_nm, upper_nm, meant_nm } => {
            let lower = length("check.size.doubt.lower_nm", lower_nm)?;
            let upper = length("check.size.doubt.upper_nm", upper_nm)?;
            if upper <= lower {
                return Err(BodyError::Contradiction { field: "check.size.doubt.upper_nm" });
            }
            Doubt::Implausible { lower, upper, meant: meant(meant_nm)? }
        }
    })
}
