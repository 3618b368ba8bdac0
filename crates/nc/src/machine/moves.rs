//! Straight lines: where the ball's centre is, and the path that it took.

use fitcheck_core::probing::cycle::{Move, Phase, Plane};

use super::around::{Around, millimetres};
use super::budget::{Budget, UsedUp};
use super::fault::{BlockPlace, FaultKind};
use super::placement::System;
use super::values::Values;
use crate::program::{Axis, AxisWord, Feed, Goes, Movement, Notation, Unit};

/// A move of the ball's centre, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Travel {
    pub place: BlockPlace,
    /// Where it begins.
    pub from: [f64; 3],
    /// Where it ends.
    pub to: [f64; 3],
    /// For an arc, its centre; the arc takes the shorter way round.
    pub about: Option<[f64; 3]>,
    pub kind: TravelKind,
}

/// What a move is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TravelKind {
    /// A block of the program, at rapid traverse.
    Rapid,
    /// A block of the program, at a feed.
    Feed,
    /// A part of a cycle.
    Cycle(Phase),
}

/// Where the ball's centre is, and the path that it took. An axis is known once a block has moved it to a place in
/// workpiece coordinates.
///
/// Programs of lathe controls write X as a diameter, absolute and incremental; here it is a radius, as Y and Z are distances.
/// Their Y is 0, the middle of the part, until a block moves it (`docs/SOURCES.md`, "DIN PLUS").
#[derive(Debug)]
pub(super) struct Way {
    /// The position in this system, as far as it is known.
    position: [Option<f64>; 3],
    system: System,
    travels: Vec<Travel>,
    most: usize,
    /// Whether X counts as a diameter.
    is_turned: bool,
}

impl Way {
    pub(super) fn new(budget: &Budget, notation: Notation) -> Self {
        let is_turned = notation == Notation::DinPlus;
        let position = [None, is_turned.then_some(0.0), None];
        Self { position, system: System::default(), travels: Vec::new(), most: budget.path, is_turned }
    }

    /// The position in the coordinates of the workpiece, as far as it is known.
    pub(super) fn position(&self) -> [Option<f64>; 3] {
        self.system.out_of_known(self.position)
    }

    pub(super) fn travels(&self) -> &[Travel] {
        &self.travels
    }

    /// The place, if all three axes are known.
    pub(super) fn place(&self) -> Option<[f64; 3]> {
        let [x, y, z] = self.position;
        Some(self.system.out([x?, y?, z?]))
    }

    /// A block that was not run may have moved all axes.
    pub(super) const fn lose(&mut self) {
        self.position = [None; 3];
    }

    /// `L`: axes that are not named stay; radius compensation does not move the ball's centre.
    pub(super) fn travel(
        &mut self,
        block: BlockPlace,
        movement: &Movement,
        unit: Option<Unit>,
        around: &Around,
        values: &Values,
    ) -> Result<(), FaultKind> {
        let has = |functions: [u32; 2]| movement.machine.iter().any(|function| functions.contains(&function.number));
        self.enter(around.system());
        // M91 and M92 count from the machine's own zero, which is unknown here.
        let is_known = !has([91, 92]) && around.is_plain();
        let to = self.end(&movement.axes, is_known, unit, values)?;
        let kind = match movement.feed {
            Some(Feed::Rapid) => TravelKind::Rapid,
            Some(Feed::Value(feed)) => {
                values.operand(feed)?;
                TravelKind::Feed
            }
            Some(Feed::Auto) | None => TravelKind::Feed,
        };
        let from = self.place();
        self.position = to;
        // An axis of the machine is none of a system that is turned.
        if has([91, 92]) && !self.system.axes.is_level() {
            self.position = [None; 3];
        }
        // M140 retracts along the tool axis, as far as only the machine knows.
        if has([140, 140]) {
            let [x, y, z] = &mut self.position;
            match around.plane() {
                Plane::Xy => *z = None,
                Plane::Zx => *y = None,
                Plane::Yz => *x = None,
            }
            return Ok(());
        }
        // M99 and M89 run a machining cycle there, which ends elsewhere.
        if has([89, 99]) {
            self.position = [None; 3];
            return Ok(());
        }
        match (from, self.place()) {
            (Some(from), Some(to)) if from.iter().zip(&to).any(|(from, to)| 0.0 < (to - from).abs()) => {
                self.went(Travel { place: block, from, to, about: None, kind })
            }
            _ => Ok(()),
        }
    }

    /// A block whose path is not followed: only its end counts.
    pub(super) fn jump(
        &mut self,
        goes: &Goes,
        unit: Option<Unit>,
        around: &Around,
        values: &Values,
    ) -> Result<(), FaultKind> {
        self.enter(around.system());
        if goes.is_unknown {
            // A lathe goes there in X and Z: Y stays.
            let [_, y, _] = self.position;
            self.position = [None, y.filter(|_| self.is_turned), None];
        }
        self.position = self.end(&goes.axes, around.is_plain(), unit, values)?;
        Ok(())
    }

    /// Where a probing begins in the system in force, mm; `None` where not all of it is known.
    pub(super) fn start(
        &mut self,
        axes: &[AxisWord],
        unit: Option<Unit>,
        around: &Around,
        values: &Values,
    ) -> Result<Option<[f64; 3]>, FaultKind> {
        self.enter(around.system());
        let [x, y, z] = self.end(axes, around.is_plain(), unit, values)?;
        Ok(x.zip(y).zip(z).map(|((x, y), z)| [x, y, z]))
    }

    /// Counts in the system in force from here on.
    fn enter(&mut self, system: System) {
        if self.system != system {
            self.position = self.system.into(system, self.position);
            self.system = system;
        }
    }

    /// Where axes end, mm in the system in force: as they are written, or nowhere that is known.
    fn end(
        &self,
        axes: &[AxisWord],
        is_known: bool,
        unit: Option<Unit>,
        values: &Values,
    ) -> Result<[Option<f64>; 3], FaultKind> {
        let mut to = self.position;
        for word in axes {
            let [x, y, z] = &mut to;
            let axis = match word.axis {
                Axis::X => x,
                Axis::Y => y,
                Axis::Z => z,
                // Only the three linear axes are followed; PLANE sets parameters for the others that nobody here knows.
                Axis::A | Axis::B | Axis::C | Axis::U | Axis::V | Axis::W => continue,
            };
            let is_diameter = self.is_turned && word.axis == Axis::X;
            let value = values.operand(word.value)? * millimetres(unit) / if is_diameter { 2.0 } else { 1.0 };
            *axis = match (*axis, word.is_incremental) {
                _ if !is_known => None,
                (old, true) => old.map(|old| old + value),
                (_, false) => Some(value),
            };
        }
        Ok(to)
    }

    /// The path of a cycle.
    pub(super) fn follow(&mut self, block: &BlockPlace, moves: &[Move]) -> Result<(), FaultKind> {
        for step in moves {
            let Move { phase, from, to, about, .. } = *step;
            self.went(Travel { place: block.clone(), from, to, about, kind: TravelKind::Cycle(phase) })?;
            (self.position, self.system) = (to.map(Some), System::default());
        }
        Ok(())
    }

    fn went(&mut self, travel: Travel) -> Result<(), FaultKind> {
        Budget::one_more(self.travels.len(), self.most, UsedUp::Path)?;
        self.travels.push(travel);
        Ok(())
    }
}
