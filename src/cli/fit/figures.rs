//! One fit in figures: the names that CSV and JSON share, in every language the same.
//!
//! Millimetres and micrometres as the name says, exact, with a point. What there is not is null, and empty in CSV.

use serde::Serialize;

use super::answer::{Answer, Measured};
use super::heat::{Heat, Heated, Part};
use crate::cli::answers::Cells;
use crate::cli::{Figure, limits};
use crate::length::{Length, Unit};
use crate::report::columns::{self, Cell as _, Column};
use crate::tolerance::fit::preferred::{Function, Preference, function, preference};
use crate::tolerance::fit::{Basis, basis};
use crate::tolerance::{Limits, ToleranceClass};
use crate::verdict::fit::{Actual, Possible};
use crate::verdict::{Status, Verdict};

/// One fit; the fields' order is that of the columns.
#[derive(Debug, Default, Serialize)]
pub(super) struct Figures<'a> {
    callout: &'a str,
    nominal_mm: Option<Figure>,
    kind: Option<&'static str>,
    minimum_clearance_um: Option<Figure>,
    maximum_clearance_um: Option<Figure>,
    mean_clearance_um: Option<Figure>,
    basis: Option<&'static str>,
    preferred: Option<&'static str>,
    function: Option<&'static str>,
    hole: Option<PartFigures>,
    shaft: Option<PartFigures>,
    equivalent: Option<EquivalentFigures>,
    actual: Option<ActualFigures>,
    possible: Option<PossibleFigures>,
    temperature: Option<TemperatureFigures>,
    error: Option<String>,
}

#[derive(Debug, Serialize)]
struct PartFigures {
    class: String,
    min_mm: Figure,
    max_mm: Figure,
    lower_um: Figure,
    upper_um: Figure,
    source: String,
}

#[derive(Debug, Serialize)]
struct EquivalentFigures {
    callout: String,
    exact: Option<bool>,
    minimum_clearance_um: Option<Figure>,
    maximum_clearance_um: Option<Figure>,
    error: Option<String>,
}

#[derive(Debug, Serialize)]
struct ActualFigures {
    hole_mm: Figure,
    shaft_mm: Figure,
    clearance_um: Figure,
    conforms: bool,
    hole_status: Status,
    shaft_status: Status,
    hole_remove_um: Option<Figure>,
    shaft_remove_um: Option<Figure>,
}

#[derive(Debug, Serialize)]
struct PossibleFigures {
    feature: &'static str,
    measured_mm: Figure,
    status: Status,
    remove_um: Option<Figure>,
    minimum_clearance_um: Figure,
    maximum_clearance_um: Figure,
}

#[derive(Debug, Serialize)]
struct TemperatureFigures {
    hole_c: Figure,
    shaft_c: Figure,
    change_um: Figure,
    minimum_clearance_um: Figure,
    maximum_clearance_um: Figure,
    kind: &'static str,
    actual_clearance_um: Option<Figure>,
    hole_material: MaterialFigures,
    shaft_material: MaterialFigures,
}

#[derive(Debug, Serialize)]
struct MaterialFigures {
    name: Option<String>,
    expansion_um_per_m_k: Figure,
    certainty: &'static str,
    source: Option<String>,
}

/// Millimetres with three decimals or more, as `limits` prints them.
fn mm(length: Length) -> Figure {
    Figure(length.exact(Unit::Millimetre, 3))
}

pub(super) fn um(length: Length) -> Figure {
    Figure(length.exact(Unit::Micrometre, 0))
}

pub(super) fn nominal(length: Length) -> Figure {
    Figure(length.exact(Unit::Millimetre, 0))
}

/// Basis, list of preferred fits and function of a pair, as words for machines.
pub(super) fn words(hole: ToleranceClass, shaft: ToleranceClass) -> [Option<&'static str>; 3] {
    let preferred = preference(hole, shaft).map(Preference::word);
    [basis(hole, shaft).map(Basis::word), preferred, function(hole, shaft).map(Function::word)]
}

fn removal(verdict: &Verdict) -> Option<Figure> {
    verdict.size.removal.map(|removal| um(removal.to_limit))
}

impl PartFigures {
    fn of(class: ToleranceClass, limits: &Limits) -> Self {
        Self {
            class: class.to_string(),
            min_mm: mm(limits.minimum()),
            max_mm: mm(limits.maximum()),
            lower_um: um(limits.deviations.lower()),
            upper_um: um(limits.deviations.upper()),
            source: limits::source(&limits.source),
        }
    }
}

impl EquivalentFigures {
    fn of(equivalent: &super::answer::Equivalent) -> Self {
        let fit = equivalent.fit.as_ref().ok();
        Self {
            callout: equivalent.callout.to_string(),
            exact: fit.map(|(_, difference)| difference.is_none()),
            minimum_clearance_um: fit.map(|(fit, _)| um(fit.minimum_clearance())),
            maximum_clearance_um: fit.map(|(fit, _)| um(fit.maximum_clearance())),
            error: equivalent.fit.as_ref().err().map(ToString::to_string),
        }
    }
}

impl ActualFigures {
    fn of(actual: &Actual) -> Self {
        Self {
            hole_mm: mm(actual.hole),
            shaft_mm: mm(actual.shaft),
            clearance_um: um(actual.clearance),
            conforms: actual.conforms,
            hole_status: actual.hole_verdict.status(),
            shaft_status: actual.shaft_verdict.status(),
            hole_remove_um: removal(&actual.hole_verdict),
            shaft_remove_um: removal(&actual.shaft_verdict),
        }
    }
}

impl PossibleFigures {
    fn of(part: &Possible) -> Self {
        Self {
            feature: part.feature.word(),
            measured_mm: mm(part.measured),
            status: part.verdict.status(),
            remove_um: removal(&part.verdict),
            minimum_clearance_um: um(part.minimum),
            maximum_clearance_um: um(part.maximum),
        }
    }
}

impl TemperatureFigures {
    fn of(heat: &Heat, heated: &Heated) -> Self {
        let material = |part: &Part| MaterialFigures {
            name: part.name.clone(),
            expansion_um_per_m_k: Figure(part.warm.expansion.to_string()),
            certainty: part.certainty.word(),
            source: part.source.clone(),
        };
        Self {
            hole_c: Figure(heat.hole.warm.temperature.to_string()),
            shaft_c: Figure(heat.shaft.warm.temperature.to_string()),
            change_um: um(heated.change),
            minimum_clearance_um: um(heated.minimum),
            maximum_clearance_um: um(heated.maximum),
            kind: heated.kind().word(),
            actual_clearance_um: heated.actual.map(um),
            hole_material: material(&heat.hole),
            shaft_material: material(&heat.shaft),
        }
    }
}

impl<'a> Figures<'a> {
    /// The columns of CSV: the names of JSON, joined where one lies within another.
    pub(super) const COLUMNS: [Column<Self>; 56] = [
        ("callout", |fit| fit.callout.cell()),
        ("nominal_mm", |fit| fit.nominal_mm.cell()),
        ("kind", |fit| fit.kind.cell()),
        ("minimum_clearance_um", |fit| fit.minimum_clearance_um.cell()),
        ("maximum_clearance_um", |fit| fit.maximum_clearance_um.cell()),
        ("mean_clearance_um", |fit| fit.mean_clearance_um.cell()),
        ("basis", |fit| fit.basis.cell()),
        ("preferred", |fit| fit.preferred.cell()),
        ("function", |fit| fit.function.cell()),
        ("hole_class", |fit| fit.hole.as_ref()?.class.cell()),
        ("hole_min_mm", |fit| fit.hole.as_ref()?.min_mm.cell()),
        ("hole_max_mm", |fit| fit.hole.as_ref()?.max_mm.cell()),
        ("hole_lower_um", |fit| fit.hole.as_ref()?.lower_um.cell()),
        ("hole_upper_um", |fit| fit.hole.as_ref()?.upper_um.cell()),
        ("hole_source", |fit| fit.hole.as_ref()?.source.cell()),
        ("shaft_class", |fit| fit.shaft.as_ref()?.class.cell()),
        ("shaft_min_mm", |fit| fit.shaft.as_ref()?.min_mm.cell()),
        ("shaft_max_mm", |fit| fit.shaft.as_ref()?.max_mm.cell()),
        ("shaft_lower_um", |fit| fit.shaft.as_ref()?.lower_um.cell()),
        ("shaft_upper_um", |fit| fit.shaft.as_ref()?.upper_um.cell()),
        ("shaft_source", |fit| fit.shaft.as_ref()?.source.cell()),
        ("equivalent_callout", |fit| fit.equivalent.as_ref()?.callout.cell()),
        ("equivalent_exact", |fit| fit.equivalent.as_ref()?.exact.cell()),
        ("equivalent_minimum_clearance_um", |fit| fit.equivalent.as_ref()?.minimum_clearance_um.cell()),
        ("equivalent_maximum_clearance_um", |fit| fit.equivalent.as_ref()?.maximum_clearance_um.cell()),
        ("equivalent_error", |fit| fit.equivalent.as_ref()?.error.cell()),
        ("actual_hole_mm", |fit| fit.actual.as_ref()?.hole_mm.cell()),
        ("actual_shaft_mm", |fit| fit.actual.as_ref()?.shaft_mm.cell()),
        ("actual_clearance_um", |fit| fit.actual.as_ref()?.clearance_um.cell()),
        ("actual_conforms", |fit| fit.actual.as_ref()?.conforms.cell()),
        ("actual_hole_status", |fit| fit.actual.as_ref()?.hole_status.cell()),
        ("actual_shaft_status", |fit| fit.actual.as_ref()?.shaft_status.cell()),
        ("actual_hole_remove_um", |fit| fit.actual.as_ref()?.hole_remove_um.cell()),
        ("actual_shaft_remove_um", |fit| fit.actual.as_ref()?.shaft_remove_um.cell()),
        ("possible_feature", |fit| fit.possible.as_ref()?.feature.cell()),
        ("possible_measured_mm", |fit| fit.possible.as_ref()?.measured_mm.cell()),
        ("possible_status", |fit| fit.possible.as_ref()?.status.cell()),
        ("possible_remove_um", |fit| fit.possible.as_ref()?.remove_um.cell()),
        ("possible_minimum_clearance_um", |fit| fit.possible.as_ref()?.minimum_clearance_um.cell()),
        ("possible_maximum_clearance_um", |fit| fit.possible.as_ref()?.maximum_clearance_um.cell()),
        ("temperature_hole_c", |fit| fit.temperature.as_ref()?.hole_c.cell()),
        ("temperature_shaft_c", |fit| fit.temperature.as_ref()?.shaft_c.cell()),
        ("temperature_change_um", |fit| fit.temperature.as_ref()?.change_um.cell()),
        ("temperature_minimum_clearance_um", |fit| fit.temperature.as_ref()?.minimum_clearance_um.cell()),
        ("temperature_maximum_clearance_um", |fit| fit.temperature.as_ref()?.maximum_clearance_um.cell()),
        ("temperature_kind", |fit| fit.temperature.as_ref()?.kind.cell()),
        ("temperature_actual_clearance_um", |fit| fit.temperature.as_ref()?.actual_clearance_um.cell()),
        ("temperature_hole_material_name", |fit| fit.temperature.as_ref()?.hole_material.name.cell()),
        ("temperature_hole_material_expansion_um_per_m_k", |fit| {
            fit.temperature.as_ref()?.hole_material.expansion_um_per_m_k.cell()
        }),
        ("temperature_hole_material_certainty", |fit| fit.temperature.as_ref()?.hole_material.certainty.cell()),
        ("temperature_hole_material_source", |fit| fit.temperature.as_ref()?.hole_material.source.cell()),
        ("temperature_shaft_material_name", |fit| fit.temperature.as_ref()?.shaft_material.name.cell()),
        ("temperature_shaft_material_expansion_um_per_m_k", |fit| {
            fit.temperature.as_ref()?.shaft_material.expansion_um_per_m_k.cell()
        }),
        ("temperature_shaft_material_certainty", |fit| fit.temperature.as_ref()?.shaft_material.certainty.cell()),
        ("temperature_shaft_material_source", |fit| fit.temperature.as_ref()?.shaft_material.source.cell()),
        ("error", |fit| fit.error.cell()),
    ];

    pub(super) fn of(callout: &'a str, answer: &Answer<'_>) -> Self {
        let fit = &answer.fit;
        let [basis, preferred, function] = words(answer.hole, answer.shaft);
        let (actual, possible) = match &answer.measured {
            Measured::None => (None, None),
            Measured::One(part) => (None, Some(PossibleFigures::of(part))),
            Measured::Both(actual) => (Some(ActualFigures::of(actual)), None),
        };
        Self {
            callout,
            nominal_mm: Some(nominal(fit.nominal())),
            kind: Some(fit.kind().word()),
            minimum_clearance_um: Some(um(fit.minimum_clearance())),
            maximum_clearance_um: Some(um(fit.maximum_clearance())),
            mean_clearance_um: Some(um(fit.mean_clearance())),
            basis,
            preferred,
            function,
            hole: Some(PartFigures::of(answer.hole, fit.hole())),
            shaft: Some(PartFigures::of(answer.shaft, fit.shaft())),
            equivalent: answer.equivalent.as_ref().map(EquivalentFigures::of),
            actual,
            possible,
            temperature: answer.heated.as_ref().map(|(heat, heated)| TemperatureFigures::of(heat, heated)),
            error: None,
        }
    }

    pub(super) fn refused(callout: &'a str, error: String) -> Self {
        Self { callout, error: Some(error), ..Self::default() }
    }
}

impl Cells for Figures<'_> {
    fn cells(&self) -> Vec<String> {
        columns::cells(&Self::COLUMNS, self).collect()
    }
}
