//! One fit in figures, the same in every language.
//!
//! Millimetres and micrometres as the names say, exact, with a point. Missing values are null, and empty in CSV.

use super::answer::{Answer, Equivalent, Measured};
use super::heat::{Heat, Heated};
use super::press::PressFigures;
use crate::cli::Figure;
use crate::cli::material::Part;
use crate::length::Length;
use crate::tolerance::fit::preferred::{Function, Preference, function, preference};
use crate::tolerance::fit::{Basis, basis};
use crate::tolerance::{Limits, PartTolerance};
use crate::verdict::fit::{Actual, Possible};
use crate::verdict::{Status, Verdict};

row! {
    /// One fit, as CSV and JSON have it.
    #[derive(Default)]
    pub(super) struct Figures<'a> of(callout: &'a str, answer: &Answer<'_>) {
        callout: &'a str = callout,
        nominal_mm: Option<Figure> = Some(Figure::mm(answer.fit.nominal(), 0)),
        kind: Option<&'static str> = Some(answer.fit.kind().word()),
        minimum_clearance_um: Option<Figure> = Some(Figure::um(answer.fit.minimum_clearance())),
        maximum_clearance_um: Option<Figure> = Some(Figure::um(answer.fit.maximum_clearance())),
        mean_clearance_um: Option<Figure> = Some(Figure::um(answer.fit.mean_clearance())),
        basis: Option<&'static str> = answer.classes().and_then(|(hole, shaft)| basis(hole, shaft)).map(Basis::word),
        preferred: Option<&'static str> = answer.classes().and_then(|(hole, shaft)| preference(hole, shaft)).map(Preference::word),
        function: Option<&'static str> = answer.classes().and_then(|(hole, shaft)| function(hole, shaft)).map(Function::word),
        hole: Option<PartFigures> = Some(PartFigures::of(answer.hole, answer.fit.hole())),
        shaft: Option<PartFigures> = Some(PartFigures::of(answer.shaft, answer.fit.shaft())),
        equivalent: Option<EquivalentFigures> = answer.equivalent.as_ref().map(EquivalentFigures::of),
        actual: Option<ActualFigures> = match &answer.measured {
            Measured::Both(actual) => Some(ActualFigures::of(actual)),
            Measured::None | Measured::One(_) => None,
        },
        possible: Option<PossibleFigures> = match &answer.measured {
            Measured::One(part) => Some(PossibleFigures::of(part)),
            Measured::None | Measured::Both(_) => None,
        },
        temperature: Option<TemperatureFigures> =
            answer.heated.as_ref().map(|(heat, heated)| TemperatureFigures::of(heat, heated)),
        press: Option<PressFigures> = answer.press.as_ref().map(|(named, press)| PressFigures::of(named, press)),
        error: Option<String> = None,
    }

    struct PartFigures of(part: PartTolerance, limits: &Limits) {
        class: Option<String> = part.class().map(|class| class.to_string()),
        min_mm: Figure = mm(limits.minimum()),
        max_mm: Figure = mm(limits.maximum()),
        lower_um: Figure = Figure::um(limits.deviations.lower()),
        upper_um: Figure = Figure::um(limits.deviations.upper()),
        source: String = limits.source.with_difference(),
    }

    struct EquivalentFigures of(equivalent: &Equivalent) {
        callout: String = equivalent.callout.to_string(),
        exact: Option<bool> = Some(equivalent.fit.as_ref().ok()?.1.is_none()),
        minimum_clearance_um: Option<Figure> = Some(Figure::um(equivalent.fit.as_ref().ok()?.0.minimum_clearance())),
        maximum_clearance_um: Option<Figure> = Some(Figure::um(equivalent.fit.as_ref().ok()?.0.maximum_clearance())),
        error: Option<String> = equivalent.fit.as_ref().err().map(ToString::to_string),
    }

    struct ActualFigures of(actual: &Actual) {
        hole_mm: Figure = mm(actual.hole),
        shaft_mm: Figure = mm(actual.shaft),
        clearance_um: Figure = Figure::um(actual.clearance),
        conforms: bool = actual.conforms,
        hole_status: Status = actual.hole_verdict.status(),
        shaft_status: Status = actual.shaft_verdict.status(),
        hole_remove_um: Option<Figure> = removal(&actual.hole_verdict),
        shaft_remove_um: Option<Figure> = removal(&actual.shaft_verdict),
    }

    struct PossibleFigures of(part: &Possible) {
        feature: &'static str = part.feature.word(),
        measured_mm: Figure = mm(part.measured),
        status: Status = part.verdict.status(),
        remove_um: Option<Figure> = removal(&part.verdict),
        minimum_clearance_um: Figure = Figure::um(part.minimum),
        maximum_clearance_um: Figure = Figure::um(part.maximum),
    }

    struct TemperatureFigures of(heat: &Heat, heated: &Heated) {
        hole_c: Figure = Figure(heat.hole.warm.temperature.to_string()),
        shaft_c: Figure = Figure(heat.shaft.warm.temperature.to_string()),
        change_um: Figure = Figure::um(heated.change),
        minimum_clearance_um: Figure = Figure::um(heated.minimum),
        maximum_clearance_um: Figure = Figure::um(heated.maximum),
        kind: &'static str = heated.kind().word(),
        actual_clearance_um: Option<Figure> = heated.actual.map(Figure::um),
        hole_material: MaterialFigures = MaterialFigures::of(&heat.hole),
        shaft_material: MaterialFigures = MaterialFigures::of(&heat.shaft),
    }

    struct MaterialFigures of(part: &Part) {
        name: Option<String> = part.name.clone(),
        expansion_um_per_m_k: Figure = Figure(part.warm.expansion.to_string()),
        certainty: &'static str = part.certainty.word(),
        source: Option<String> = part.source.clone(),
    }
}

/// Millimetres with at least three decimals, as `limits` prints them.
fn mm(length: Length) -> Figure {
    Figure::mm(length, 3)
}

fn removal(verdict: &Verdict) -> Option<Figure> {
    verdict.size.removal.map(|removal| Figure::um(removal.to_limit))
}

impl<'a> Figures<'a> {
    pub(super) fn refused(callout: &'a str, error: String) -> Self {
        Self { callout, error: Some(error), ..Self::default() }
    }
}
