//! A feature of a plan measured by its cycle on a perfect part: what a walk through the plan takes where nothing is at hand.

use super::kind::{FeatureKind, Towards, WidthAxis};
use super::plan::PlanFeature;
use crate::length::Length;
use crate::message::{Message, Say as _, message};
use crate::probing::cycle::{Axis, Cycle, Inputs, Meaning, Parameter};
use crate::probing::simulated::Part;
use crate::probing::{Measurement, Origin};
use crate::tolerance::{Feature, Limits};

impl PlanFeature {
    /// Measures it by its cycle on [`Self::on_part`], with a point as the probe: a measurement for each of its sizes, marked as simulated.
    ///
    /// # Errors
    /// Why it cannot be: without a place or a cycle, or what the cycle says.
    pub fn simulated(&self, seed: u64) -> Result<Vec<Measurement>, Message> {
        let name = || self.name.clone();
        let on_part = self.on_part().ok_or_else(|| message!("plan-simulated-no-place").text("name", name()))?;
        let cycle = self.cycle.ok_or_else(|| message!("plan-simulated-no-cycle").text("name", name()))?;
        let mut part = Part::perfect(vec![on_part]);
        part.seed = seed;
        let mut machine = part.machine().map_err(|error| error.message())?;
        let inputs = self.inputs(cycle)?;
        let result = cycle.measure(&inputs, &mut machine).map_err(|error| error.message())?;
        let origin = Origin::Simulated { cycle: cycle.number, seed };
        if let (FeatureKind::Diameter(_), Some(found)) = (&self.kind, &result.circle) {
            let circle = Measurement::of_circle(found.circle, result.plane_contacts(), origin);
            return circle.map(|circle| vec![circle]).map_err(|error| error.message());
        }
        let measured = result.checks.iter().map(|check| Measurement::of_diameter(check.measured, origin.clone()));
        let measured: Vec<_> = measured.collect();
        if measured.len() == self.limits.len() {
            Ok(measured)
        } else {
            Err(message!("plan-simulated-no-cycle").text("name", name()))
        }
    }

    /// The parameters of a cycle that measures it, by their meaning; those that the plan gives besides come last.
    fn inputs(&self, cycle: &'static Cycle) -> Result<Inputs, Message> {
        let mut inputs = Inputs::new();
        for parameter in cycle.parameters {
            if let Some(value) = self.parameters.value(parameter.key) {
                inputs = inputs.with(parameter.key, value.clone());
            } else if let Some(text) = self.text_of(parameter) {
                inputs = inputs.with(parameter.key, parameter.read(&text).map_err(|error| error.message())?);
            }
        }
        Ok(inputs)
    }

    /// What a parameter gets, as people type it; `None` keeps its default.
    fn text_of(&self, parameter: &Parameter) -> Option<String> {
        let [x, y, z] = self.place?;
        let limits = |side: usize| self.limits.get(side).map(Limits::bounds);
        let nominal = |side: usize| self.limits.get(side).map(between);
        let length = |length: Length| Some(length.to_string());
        let side = |axis: Axis| usize::from(axis == Axis::Second);
        match parameter.meaning {
            Meaning::Centre(Axis::First) | Meaning::Start(Axis::First) | Meaning::Point(Axis::First) => length(x),
            Meaning::Centre(Axis::Second) | Meaning::Start(Axis::Second) | Meaning::Point(Axis::Second) => length(y),
            Meaning::MeasuringHeight | Meaning::Point(Axis::Third) => length(z),
            Meaning::FirstPoint(axis) => length(self.wall(axis, nominal(0)?, true)?),
            Meaning::SecondPoint(axis) => length(self.wall(axis, nominal(0)?, false)?),
            Meaning::Diameter | Meaning::Width => length(nominal(0)?),
            Meaning::Side(axis) => length(nominal(side(axis))?),
            Meaning::MaximumDiameter | Meaning::MaximumWidth | Meaning::MaximumCoordinate => {
                length(limits(0)?.maximum())
            }
            Meaning::MinimumDiameter | Meaning::MinimumWidth | Meaning::MinimumCoordinate => {
                length(limits(0)?.minimum())
            }
            Meaning::MaximumSide(axis) => length(limits(side(axis))?.maximum()),
            Meaning::MinimumSide(axis) => length(limits(side(axis))?.minimum()),
            Meaning::FirstAngle => Some(self.angle.to_string()),
            Meaning::SetUpClearance => length(self.clearance),
            Meaning::ClearanceHeight => length(self.clearance_height),
            Meaning::Band => Some(self.kind.asked()),
            Meaning::AxisOfPlane | Meaning::MeasuredAxis | Meaning::Direction | Meaning::Normal(_) => {
                self.direction(parameter.meaning)
            }
            // As the built-in program moves: over a shaft, along the walls of a hole.
            Meaning::MoveToClearance => Some(if self.feature() == Some(Feature::Shaft) { "1" } else { "0" }.to_owned()),
            Meaning::Shift | Meaning::Log | Meaning::Stop | Meaning::StopOnUndersize | Meaning::CentreTolerance(_) => {
                Some("0".to_owned())
            }
            Meaning::Tool => Some("0".to_owned()),
            _ => None,
        }
    }

    /// Which way a width, a face or a point is measured.
    fn direction(&self, meaning: Meaning) -> Option<String> {
        let number = |axis: Axis| match axis {
            Axis::First => "1",
            Axis::Second => "2",
            Axis::Third => "3",
        };
        match (meaning, &self.kind) {
            (Meaning::AxisOfPlane, FeatureKind::Width(_, axis)) => Some(number(axis_of(*axis)).to_owned()),
            (Meaning::MeasuredAxis, FeatureKind::Face(_, Towards { axis, .. })) => Some(number(*axis).to_owned()),
            (Meaning::Direction, FeatureKind::Face(_, Towards { is_plus, .. })) => {
                Some(if *is_plus { "1" } else { "-1" }.to_owned())
            }
            (Meaning::Normal(axis), FeatureKind::Point(_, direction)) => {
                let [x, y, z] = direction.normal();
                let part = match axis {
                    Axis::First => x,
                    Axis::Second => y,
                    Axis::Third => z,
                };
                Some(part.to_string())
            }
            _ => None,
        }
    }

    /// A wall of a ridge at nominal size in one axis, the one with the larger coordinate first.
    fn wall(&self, axis: Axis, nominal: Length, is_larger: bool) -> Option<Length> {
        let [x, y, _] = self.place?;
        let place = if axis == Axis::First { x } else { y };
        let FeatureKind::Width(_, across) = &self.kind else { return Some(place) };
        if axis_of(*across) != axis {
            return Some(place);
        }
        let half = nominal.midpoint(Length::ZERO);
        if is_larger { place.checked_add(half) } else { place.checked_sub(half) }
    }
}

const fn axis_of(axis: WidthAxis) -> Axis {
    match axis {
        WidthAxis::X => Axis::First,
        WidthAxis::Y => Axis::Second,
    }
}

/// The nominal size, moved between the limits where it lies outside: a cycle refuses one that does.
fn between(limits: &Limits) -> Length {
    limits.nominal.clamp(limits.minimum(), limits.maximum())
}
