//! Straight lines: where the ball's centre is, and the path that it took.

use fitcheck_core::probing::cycle::{Move, Phase, Plane};

use super::around::{Around, millimetres};
use super::budget::{Budget, UsedUp};
use super::fault::{BlockPlace, FaultKind};
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
    position: [Option<f64>; 3],
    travels: Vec<Travel>,
    most: usize,
    /// Whether X counts as a diameter.
    is_turned: bool,
}

impl Way {
    pub(super) fn new(budget: &Budget, notation: Notation) -> Self {
        let is_turned = notation == Notation::DinPlus;
        let position = [None, is_turned.then_some(0.0), None];
        Self { position, travels: Vec::new(), most: budget.path, is_turned }
    }

    pub(super) const fn position(&self) -> [Option<f64>; 3] {
        self.position
    }

    pub(super) fn travels(&self) -> &[Travel] {
        &self.travels
    }

    /// The place, if all three axes are known.
    pub(super) fn place(&self) -> Option<[f64; 3]> {
        let [x, y, z] = self.position;
        Some([x?, y?, z?])
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
        // M91 and M92 count from the machine's own zero, which is unknown here.
        let is_known = !has([91, 92]) && around.is_plain();
        let to = self.end(&movement.axes, is_known, unit, around.zero(), values)?;
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
        if goes.is_unknown {
            // A lathe goes there in X and Z: Y stays.
            let [_, y, _] = self.position;
            self.position = [None, y.filter(|_| self.is_turned), None];
        }
        self.position = self.end(&goes.axes, around.is_plain(), unit, around.zero(), values)?;
        Ok(())
    }

    /// Where axes end, mm from the preset: as they are written, or nowhere that is known.
    fn end(
        &self,
        axes: &[AxisWord],
        is_known: bool,
        unit: Option<Unit>,
        zero: [f64; 3],
        values: &Values,
    ) -> Result<[Option<f64>; 3], FaultKind> {
        let mut to = self.position;
        let [zero_x, zero_y, zero_z] = zero;
        for word in axes {
            let [x, y, z] = &mut to;
            let (axis, zero) = match word.axis {
                Axis::X => (x, zero_x),
                Axis::Y => (y, zero_y),
                Axis::Z => (z, zero_z),
                // Only the three linear axes are followed; PLANE sets parameters for the others that nobody here knows.
                Axis::A | Axis::B | Axis::C | Axis::U | Axis::V | Axis::W => continue,
            };
            let is_diameter = self.is_turned && word.axis == Axis::X;
            let value = values.operand(word.value)? * millimetres(unit) / if is_diameter { 2.0 } else { 1.0 };
            *axis = match (*axis, word.is_incremental) {
                _ if !is_known => None,
                (old, true) => old.map(|old| old + value),
                (_, false) => Some(value + zero),
            };
        }
        Ok(to)
    }

    /// The path of a cycle.
    pub(super) fn follow(&mut self, block: &BlockPlace, moves: &[Move]) -> Result<(), FaultKind> {
        for step in moves {
            let Move { phase, from, to, about, .. } = *step;
            self.went(Travel { place: block.clone(), from, to, about, kind: TravelKind::Cycle(phase) })?;
            self.position = to.map(Some);
        }
        Ok(())
    }

    fn went(&mut self, travel: Travel) -> Result<(), FaultKind> {
        Budget::one_more(self.travels.len(), self.most, UsedUp::Path)?;
        self.travels.push(travel);
        Ok(())
    }
}
