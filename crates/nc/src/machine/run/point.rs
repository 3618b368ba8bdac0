//! Cycles 0 and 1: one contact, from a place in a direction. They judge nothing; cycle 0 puts a coordinate into a parameter.

use fitcheck_core::probing::cycle::{CycleError, Move, Phase, Plane};
use fitcheck_core::probing::{Contact, NoContact, Orientation};

use super::super::around::{Purpose, millimetres};
use super::super::budget::Settings;
use super::super::cycles::put_contact;
use super::super::fault::FaultKind;
use super::super::placement::Placement;
use super::Run;
use crate::control::variables::Parameter;
use crate::program::{Axis, AxisWord, CycleBlock, Expression, Operand, PointProbe};

/// What the first blocks of cycle 0 or 1 say.
#[derive(Debug, Clone, Copy)]
pub(super) struct PointStart {
    /// What errors call the cycle.
    cycle: &'static str,
    /// The axis whose coordinate is measured, and where it goes.
    measured: Option<(Axis, Parameter)>,
    /// The unit vector of the probing in the system; `None` before it is said.
    direction: Option<[f64; 3]>,
}

const fn along(axis: Axis) -> [f64; 3] {
    match axis {
        Axis::X => [1.0, 0.0, 0.0],
        Axis::Y => [0.0, 1.0, 0.0],
        _ => [0.0, 0.0, 1.0],
    }
}

impl Run {
    /// Does what a block of cycle 0 or 1 says; `None` for another one, and where an unknown cycle is to be skipped.
    pub(super) fn probe_point(
        &mut self,
        at: usize,
        block: &CycleBlock,
        settings: &Settings,
    ) -> Option<Result<(), FaultKind>> {
        let said = block.point()?;
        if self.cycles.probed().is_perfect() {
            return (!settings.skip_unknown).then_some(Err(FaultKind::PointWithoutPart));
        }
        let before = self.point.take();
        let (start, direction) = match (said, before) {
            (PointProbe::Plane { to, axis, is_negative }, _) => {
                let direction = Some(along(axis).map(|part| if is_negative { -part } else { part }));
                self.point = Some(PointStart { cycle: "0", measured: Some((axis, to)), direction });
                return Some(Ok(()));
            }
            (PointProbe::Polar, _) => {
                self.point = Some(PointStart { cycle: "1", measured: None, direction: None });
                return Some(Ok(()));
            }
            (PointProbe::Direction { from, angle }, Some(start)) => {
                return Some(self.values.operand(angle).map(|angle| {
                    let turned = Orientation::in_plane(self.around.plane(), angle).out(along(from));
                    self.point = Some(PointStart { direction: Some(turned), ..start });
                }));
            }
            (PointProbe::At(axes), Some(start)) => match start.direction {
                Some(direction) => ((start, axes), direction),
                None => return None,
            },
            (PointProbe::Direction { .. } | PointProbe::At(_), None) => return None,
        };
        Some(self.touch_point(at, start, direction, settings))
    }

    /// Probes from a place and goes back there.
    fn touch_point(
        &mut self,
        at: usize,
        (start, axes): (PointStart, Vec<AxisWord>),
        direction: [f64; 3],
        settings: &Settings,
    ) -> Result<(), FaultKind> {
        let placement = self.around.placement(settings.assumes_tool, Purpose::Measurement)?;
        // The axes of the block are those of the machine, whatever the tool axis is.
        let placement = Placement { plane: Plane::Xy, ..placement };
        let unit = self.flow.unit();
        let from = self.way.start(&axes, unit, &self.around, &self.values)?.ok_or(FaultKind::PointFromNowhere)?;
        let refused =
            |error: NoContact| FaultKind::Cycle { cycle: start.cycle, error: Box::new(CycleError::from(error)) };
        let [_, _, up] = direction;
        if 0.0 < up.abs() && !self.cycles.probed().has_heights() {
            return Err(refused(NoContact::NoHeight { number: 1 }));
        }
        let place = self.flow.place_of(at);
        let odd = self.around.odd();
        self.remarks.add_all(&place, odd);
        let touched = self.cycles.touch((from, direction), placement)?.ok_or(FaultKind::PointWithoutPart)?;
        let (contact, ball_radius) = touched.map_err(refused)?;
        let met = contact.place();
        let step = |phase, from, to| Move { phase, touch: Some(1), from, to, about: None };
        let path = [step(Phase::Approach, from, met), step(Phase::Contact, met, met), step(Phase::Retract, met, from)];
        let way = placement.moves(&path);
        if let (Some(before), Some(first)) = (self.way.place(), way.first()) {
            self.way.follow(&place, &[step(Phase::PrePosition, before, first.from)])?;
        }
        self.way.follow(&place, &way)?;
        put_contact(&way, unit, &mut self.values)?;
        let Some((axis, to)) = start.measured else { return Ok(()) };
        let surface = coordinate(&contact, axis) + direction.into_iter().sum::<f64>() * ball_radius;
        let value = Expression::Value(Operand::Number(surface / millimetres(unit)));
        let given = self.values.assign(to, &value, self.is_main())?;
        self.note_given(at, to, given);
        Ok(())
    }
}

const fn coordinate(contact: &Contact, axis: Axis) -> f64 {
    match axis {
        Axis::X => contact.x,
        Axis::Y => contact.y,
        _ => contact.z,
    }
}
