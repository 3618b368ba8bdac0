//! One fit in figures: the names that CSV and JSON share, in every language the same.
//!
//! Millimetres and micrometres as the name says, exact, with a point. What there is not is null, and empty in CSV.

use serde::Serialize;

use super::answer::{Answer, Measured};
use super::heat::{Heat, Heated, Part};
use crate::cli::{Figure, limits};
use crate::length::{Length, Unit};
use crate::tolerance::fit::preferred::{Function, Preference, function, preference};
use crate::tolerance::fit::{Actual, Basis, Possible, basis};
use crate::tolerance::{Limits, ToleranceClass};
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

    fn cells(&self) -> [String; 6] {
        let [min, max, lower, upper] =
            [&self.min_mm, &self.max_mm, &self.lower_um, &self.upper_um].map(|figure| figure.0.clone());
        [self.class.clone(), min, max, lower, upper, self.source.clone()]
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

    fn cells(&self) -> [String; 5] {
        let exact = self.exact.map(|exact| exact.to_string()).unwrap_or_default();
        let [minimum, maximum] = [&self.minimum_clearance_um, &self.maximum_clearance_um].map(figure);
        [self.callout.clone(), exact, minimum, maximum, self.error.clone().unwrap_or_default()]
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

    fn cells(&self) -> [String; 8] {
        let [hole, shaft, clearance] = [&self.hole_mm, &self.shaft_mm, &self.clearance_um].map(|it| it.0.clone());
        let [hole_status, shaft_status] = [self.hole_status, self.shaft_status].map(|status| status.to_string());
        let [hole_remove, shaft_remove] = [&self.hole_remove_um, &self.shaft_remove_um].map(figure);
        let conforms = self.conforms.to_string();
        [hole, shaft, clearance, conforms, hole_status, shaft_status, hole_remove, shaft_remove]
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

    fn cells(&self) -> [String; 6] {
        let [measured, minimum, maximum] =
            [&self.measured_mm, &self.minimum_clearance_um, &self.maximum_clearance_um].map(|it| it.0.clone());
        let status = self.status.to_string();
        [self.feature.to_owned(), measured, status, figure(&self.remove_um), minimum, maximum]
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

    fn cells(&self) -> [String; 15] {
        let figures =
            [&self.hole_c, &self.shaft_c, &self.change_um, &self.minimum_clearance_um, &self.maximum_clearance_um];
        let [hole, shaft, change, minimum, maximum] = figures.map(|figure| figure.0.clone());
        let [hole_name, hole_expansion, hole_certainty, hole_source] = self.hole_material.cells();
        let [shaft_name, shaft_expansion, shaft_certainty, shaft_source] = self.shaft_material.cells();
        [
            hole,
            shaft,
            change,
            minimum,
            maximum,
            self.kind.to_owned(),
            figure(&self.actual_clearance_um),
            hole_name,
            hole_expansion,
            hole_certainty,
            hole_source,
            shaft_name,
            shaft_expansion,
            shaft_certainty,
            shaft_source,
        ]
    }
}

impl MaterialFigures {
    fn cells(&self) -> [String; 4] {
        let [name, source] = [&self.name, &self.source].map(|text| text.clone().unwrap_or_default());
        [name, self.expansion_um_per_m_k.0.clone(), self.certainty.to_owned(), source]
    }
}

impl<'a> Figures<'a> {
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

    /// The cells of CSV, in the order of [`super::columns::COLUMNS`].
    pub(super) fn columns(&self) -> Vec<String> {
        let words = [self.kind, self.basis, self.preferred, self.function];
        let [kind, basis, preferred, function] = words.map(|word| word.unwrap_or_default().to_owned());
        let clearances = [&self.minimum_clearance_um, &self.maximum_clearance_um, &self.mean_clearance_um].map(figure);
        let mut cells = vec![self.callout.to_owned(), figure(&self.nominal_mm), kind];
        cells.extend(clearances);
        cells.extend([basis, preferred, function]);
        cells.extend(part_cells(self.hole.as_ref(), PartFigures::cells));
        cells.extend(part_cells(self.shaft.as_ref(), PartFigures::cells));
        cells.extend(part_cells(self.equivalent.as_ref(), EquivalentFigures::cells));
        cells.extend(part_cells(self.actual.as_ref(), ActualFigures::cells));
        cells.extend(part_cells(self.possible.as_ref(), PossibleFigures::cells));
        cells.extend(part_cells(self.temperature.as_ref(), TemperatureFigures::cells));
        cells.push(self.error.clone().unwrap_or_default());
        cells
    }
}

/// The cells of a part that may not be there.
fn part_cells<T, const N: usize>(part: Option<&T>, cells: impl Fn(&T) -> [String; N]) -> [String; N] {
    part.map_or_else(|| [const { String::new() }; N], cells)
}

#[expect(clippy::ref_option, reason = "maps arrays of references to fields")]
fn figure(figure: &Option<Figure>) -> String {
    figure.as_ref().map(|figure| figure.0.clone()).unwrap_or_default()
}
