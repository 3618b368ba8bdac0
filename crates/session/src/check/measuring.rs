//! From the fields to a measurement and a record.

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::probing::measure::{ProbePosition, cycle_number, measure as run_cycle};
use fitcheck_core::probing::simulated::{Figure, Lobes, Machine, Probe, Workpiece, WorkpieceError};
use fitcheck_core::probing::{Measurement, Origin};
use fitcheck_core::tolerance::{Feature, Limits, LimitsError, Sources};
use fitcheck_core::verdict::PositionVerdict;
use fitcheck_exchange::journal::Record;
use jiff::civil::DateTime;

use super::inputs::SIMULATION;
use super::{CheckField, CheckInputs, CheckPage, MeasureBy};
use crate::budget::OpenBudget;
use crate::state::PageState as _;
use crate::texts::KeptField as _;

/// The field that measuring refused, and why.
type Refusal = (CheckField, Message);

/// Measures as the fields say.
pub(super) fn measure(page: &CheckPage, budget: Option<&OpenBudget>, now: DateTime) -> Result<Record, Refusal> {
    let asked = &page.asked;
    let Some(limits) = asked.limits.as_ref() else {
        // An error beside the callout says more than "no limits".
        let problem = asked.error(CheckField::Callout).cloned();
        return Err((CheckField::Callout, problem.unwrap_or_else(|| message!("measured-needs-limits"))));
    };
    let (measurement, position) = match page.by {
        MeasureBy::Typing => (typed(asked)?, None),
        MeasureBy::Simulating => simulated(asked, limits).map_err(|(field, problem)| match field {
            CheckField::TrueDiameter if asked.error(field).is_none() => (culprit(page, limits), problem),
            field => (field, problem),
        })?,
    };
    let record = record(page.text(CheckField::Part), asked, limits, (measurement, position), now);
    asked.worth.judge(record, budget)
}

/// The record of a measurement that was brought to 20 °C where a temperature is given.
pub(super) fn record(
    part: &str,
    asked: &CheckInputs,
    limits: &Limits,
    (measurement, position): (Measurement, Option<PositionVerdict>),
    now: DateTime,
) -> Record {
    let callout = asked.callout.map(|callout| callout.of_part(limits.feature));
    let correction = asked.worth.correction(measurement.diameter);
    let record = Record::judged(now, part.trim().to_owned(), callout, limits.clone(), measurement, position);
    match correction {
        Some(correction) => record.corrected(correction),
        None => record,
    }
}

fn typed(asked: &CheckInputs) -> Result<Measurement, Refusal> {
    // An empty field is no mistake: the callout was typed, and the value comes next.
    let missing = || asked.error(CheckField::Measured).cloned().unwrap_or_else(|| message!("measured-needs-value"));
    let measured = asked.length(CheckField::Measured).ok_or_else(|| (CheckField::Measured, missing()))?;
    Ok(Measurement::of_diameter(measured, Origin::Typed))
}

/// The value of a field that must hold one.
fn needed<T>(asked: &CheckInputs, field: CheckField, value: Option<T>) -> Result<T, Refusal> {
    let problem = || asked.error(field).cloned().unwrap_or_else(|| LengthError::Empty.message());
    value.ok_or_else(|| (field, problem()))
}

pub(super) fn length(asked: &CheckInputs, field: CheckField) -> Result<Length, Refusal> {
    needed(asked, field, asked.length(field))
}

fn simulated(asked: &CheckInputs, limits: &Limits) -> Result<(Measurement, Option<PositionVerdict>), Refusal> {
    let position = probe_position(asked)?;
    let seed = needed(asked, CheckField::Seed, asked.seed)?;
    let (workpiece, probe) = workpiece(asked, limits, &position)?;
    let mut machine = Machine::new(workpiece, probe, seed).map_err(|error| (figure(&error), error.message()))?;
    let feature = workpiece.feature;
    let origin = Origin::Simulated { cycle: cycle_number(feature), seed };
    let (measurement, position) = run_cycle(feature, limits, &position, &mut machine, origin)
        .map_err(|error| (CheckField::TrueDiameter, error.message()))?;
    Ok((measurement, Some(position)))
}

/// The field of the figure that an error of the simulated machine names.
fn figure(error: &WorkpieceError) -> CheckField {
    match error.what {
        Figure::CentreX => CheckField::OffsetX,
        Figure::CentreY => CheckField::OffsetY,
        Figure::Ovality => CheckField::Ovality,
        Figure::Lobes => CheckField::Lobes,
        Figure::LobeHeight => CheckField::LobeHeight,
        Figure::SurfaceScatter => CheckField::SurfaceScatter,
        Figure::ProbeScatter => CheckField::ProbeScatter,
        _ => CheckField::TrueDiameter,
    }
}

/// The field because of which a cycle did not reach the workpiece: the one without whose text it does. Where that is
/// none alone, the first that the user has changed.
fn culprit(page: &CheckPage, limits: &Limits) -> CheckField {
    let is_changed = |field: &CheckField| page.text(*field).trim() != field.declared().1;
    let changed: Vec<_> = SIMULATION.into_iter().filter(is_changed).collect();
    let is_it = |field: &&CheckField| {
        let mut texts = page.texts.clone();
        texts.set(**field, field.declared().1);
        simulated(&CheckInputs::read(&texts, page.feature(), page.judging, &Sources::default(), &page.meant), limits)
            .is_ok()
    };
    changed.iter().find(is_it).or(changed.first()).copied().unwrap_or(CheckField::TrueDiameter)
}

fn probe_position(asked: &CheckInputs) -> Result<ProbePosition, Refusal> {
    Ok(ProbePosition {
        centre: [length(asked, CheckField::CentreX)?, length(asked, CheckField::CentreY)?],
        height: length(asked, CheckField::Height)?,
        first_angle: needed(asked, CheckField::FirstAngle, asked.first_angle)?,
        clearance: length(asked, CheckField::Clearance)?,
        centre_tolerance: length(asked, CheckField::CentreTolerance)?,
    })
}

/// What the cycle probes: a hole or a shaft.
fn feature(asked: &CheckInputs, limits: &Limits) -> Result<Feature, Refusal> {
    let problem = || match asked.callout {
        Some(callout) => LimitsError::NoFeature { callout }.message(),
        None => LengthError::Empty.message(),
    };
    limits.feature.ok_or_else(|| (CheckField::Callout, problem()))
}

fn workpiece(asked: &CheckInputs, limits: &Limits, position: &ProbePosition) -> Result<(Workpiece, Probe), Refusal> {
    let mm = |field| length(asked, field).map(Length::to_mm_f64);
    let diameter = match asked.error(CheckField::TrueDiameter) {
        Some(problem) => return Err((CheckField::TrueDiameter, problem.clone())),
        None => asked.length(CheckField::TrueDiameter).unwrap_or_else(|| limits.middle()),
    };
    let [x, y] = position.centre.map(Length::to_mm_f64);
    let count = needed(asked, CheckField::Lobes, asked.lobes)?;
    let workpiece = Workpiece {
        feature: feature(asked, limits)?,
        centre: [x + mm(CheckField::OffsetX)?, y + mm(CheckField::OffsetY)?],
        diameter: diameter.to_mm_f64(),
        ovality: Lobes { count: 2, amplitude: mm(CheckField::Ovality)?, angle: 0.0 },
        lobes: Lobes { count, amplitude: mm(CheckField::LobeHeight)?, angle: 0.0 },
        surface_scatter: mm(CheckField::SurfaceScatter)?,
    };
    Ok((workpiece, Probe { trigger_scatter: mm(CheckField::ProbeScatter)?, ..Probe::STILL }))
}
