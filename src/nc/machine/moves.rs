//! Straight lines: where the ball's centre is, and the path that it took.

use super::budget::{Budget, UsedUp};
use super::fault::{BlockPlace, FaultKind};
use super::values::Values;
use crate::nc::program::{Axis, Feed, Movement, Unit};
use crate::probing::cycle::{Move, Phase};

/// Millimetres in an inch.
const INCH: f64 = 25.4;

/// A move of the ball's centre, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Travel {
    /// The block.
    pub place: BlockPlace,
    /// Where it begins.
    pub from: [f64; 3],
    /// Where it ends.
    pub to: [f64; 3],
    /// For an arc, its centre; the arc takes the shorter way round.
    pub about: Option<[f64; 3]>,
    /// What it is.
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
#[derive(Debug)]
pub(super) struct Way {
    position: [Option<f64>; 3],
    travels: Vec<Travel>,
    most: usize,
}

impl Way {
    pub(super) const fn new(budget: &Budget) -> Self {
        Self { position: [None; 3], travels: Vec::new(), most: budget.path }
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

    /// `L`: axes that are not named stay; radius compensation does not move the ball's centre.
    pub(super) fn travel(
        &mut self,
        block: BlockPlace,
        movement: &Movement,
        unit: Option<Unit>,
        values: &Values,
    ) -> Result<(), FaultKind> {
        // M91 and M92 count from the machine's own zero, which is unknown here.
        let is_of_machine = movement.machine.iter().any(|function| matches!(function.number, 91 | 92));
        let factor = if unit == Some(Unit::Inch) { INCH } else { 1.0 };
        let mut to = self.position;
        for word in &movement.axes {
            let value = values.operand(word.value)? * factor;
            let [x, y, z] = &mut to;
            let axis = match word.axis {
                Axis::X => x,
                Axis::Y => y,
                Axis::Z => z,
                Axis::A | Axis::B | Axis::C | Axis::U | Axis::V | Axis::W => continue,
            };
            *axis = match (*axis, word.is_incremental) {
                _ if is_of_machine => None,
                (old, true) => old.map(|old| old + value),
                (_, false) => Some(value),
            };
        }
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
        match (from, self.place()) {
            (Some(from), Some(to)) if from.iter().zip(&to).any(|(from, to)| 0.0 < (to - from).abs()) => {
                self.went(Travel { place: block, from, to, about: None, kind })
            }
            _ => Ok(()),
        }
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
