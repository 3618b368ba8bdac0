//! One fit in figures: the names that CSV and JSON share, the same in every language.
//!
//! Millimetres and micrometres as the names say, exact, with a point. Missing values are null, and empty in CSV.

use serde::Serialize;

use super::answer::{Answer, Measured};
use super::heat::{Heat, Heated};
use crate::cli::Figure;
use crate::cli::answers::Cells;
use crate::cli::material::Part;
use crate::length::Length;
use crate::report::columns::{self, Cell as _, Column, columns};
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

/// Millimetres with at least three decimals, as `limits` prints them.
fn mm(length: Length) -> Figure {
    Figure::mm(length, 3)
}

/// Basis, list of preferred fits and function of a pair, as words for machines.
pub(super) fn words(hole: ToleranceClass, shaft: ToleranceClass) -> [Option<&'static str>; 3] {
    let preferred = preference(hole, shaft).map(Preference::word);
    [basis(hole, shaft).map(Basis::word), preferred, function(hole, shaft).map(Function::word)]
}

fn removal(verdict: &Verdict) -> Option<Figure> {
    verdict.size.removal.map(|removal| Figure::um(removal.to_limit))
}

impl PartFigures {
    fn of(class: ToleranceClass, limits: &Limits) -> Self {
        Self {
            class: class.to_string(),
            min_mm: mm(limits.minimum()),
            max_mm: mm(limits.maximum()),
            lower_um: Figure::um(limits.deviations.lower()),
            upper_um: Figure::um(limits.deviations.upper()),
            source: limits.source.with_difference(),
        }
    }
}

impl EquivalentFigures {
    fn of(equivalent: &super::answer::Equivalent) -> Self {
        let fit = equivalent.fit.as_ref().ok();
        Self {
            callout: equivalent.callout.to_string(),
            exact: fit.map(|(_, difference)| difference.is_none()),
            minimum_clearance_um: fit.map(|(fit, _)| Figure::um(fit.minimum_clearance())),
            maximum_clearance_um: fit.map(|(fit, _)| Figure::um(fit.maximum_clearance())),
            error: equivalent.fit.as_ref().err().map(ToString::to_string),
        }
    }
}

impl ActualFigures {
    fn of(actual: &Actual) -> Self {
        Self {
            hole_mm: mm(actual.hole),
            shaft_mm: mm(actual.shaft),
            clearance_um: Figure::um(actual.clearance),
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
            minimum_clearance_um: Figure::um(part.minimum),
            maximum_clearance_um: Figure::um(part.maximum),
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
            change_um: Figure::um(heated.change),
            minimum_clearance_um: Figure::um(heated.minimum),
            maximum_clearance_um: Figure::um(heated.maximum),
            kind: heated.kind().word(),
            actual_clearance_um: heated.actual.map(Figure::um),
            hole_material: material(&heat.hole),
            shaft_material: material(&heat.shaft),
        }
    }
}

impl<'a> Figures<'a> {
    /// The columns of CSV: the names of JSON, joined where one is within another.
    pub(super) const COLUMNS: [Column<Self>; 56] = columns! {
        callout, nominal_mm, kind, minimum_clearance_um, maximum_clearance_um, mean_clearance_um, basis, preferred,
        function,
        hole.class, hole.min_mm, hole.max_mm, hole.lower_um, hole.upper_um, hole.source,
        shaft.class, shaft.min_mm, shaft.max_mm, shaft.lower_um, shaft.upper_um, shaft.source,
        equivalent.callout, equivalent.exact, equivalent.minimum_clearance_um, equivalent.maximum_clearance_um,
        equivalent.error,
        actual.hole_mm, actual.shaft_mm, actual.clearance_um, actual.conforms, actual.hole_status,
        actual.shaft_status, actual.hole_remove_um, actual.shaft_remove_um,
        possible.feature, possible.measured_mm, possible.status, possible.remove_um, possible.minimum_clearance_um,
        possible.maximum_clearance_um,
        temperature.hole_c, temperature.shaft_c, temperature.change_um, temperature.minimum_clearance_um,
        temperature.maximum_clearance_um, temperature.kind, temperature.actual_clearance_um,
        temperature.hole_material.name, temperature.hole_material.expansion_um_per_m_k,
        temperature.hole_material.certainty, temperature.hole_material.source,
        temperature.shaft_material.name, temperature.shaft_material.expansion_um_per_m_k,
        temperature.shaft_material.certainty, temperature.shaft_material.source,
        error,
    };

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
            nominal_mm: Some(Figure::mm(fit.nominal(), 0)),
            kind: Some(fit.kind().word()),
            minimum_clearance_um: Some(Figure::um(fit.minimum_clearance())),
            maximum_clearance_um: Some(Figure::um(fit.maximum_clearance())),
            mean_clearance_um: Some(Figure::um(fit.mean_clearance())),
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
