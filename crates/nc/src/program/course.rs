//! Which blocks may run before a block, and whether it runs at all: by labels, jumps, calls and ends alone, whatever the values are.

use super::Program;
use super::block::{Body, Target};

/// The way through a program to one of its blocks.
#[derive(Debug, Clone)]
pub struct Course {
    /// For each block, whether it may run before the block is run, also where that is run again.
    pub before: Vec<bool>,
    /// Whether no block but the next one can follow any of them; labels and their ends aside.
    pub is_straight: bool,
    /// The last block above it that the program comes to, where it does not come to the block.
    pub last: Option<usize>,
    /// The first block from which the program may end without the block.
    pub passes: Option<usize>,
}

/// Where the program may go on: behind each block, and from three places that stand for many.
struct Ways {
    /// Pairs of a place and one that may follow it, sorted.
    on: Vec<(usize, usize)>,
    /// The same the other way round.
    back: Vec<(usize, usize)>,
}

impl Program {
    /// How the program comes to a block.
    pub fn course_to(&self, block: usize) -> Course {
        let count = self.blocks.len();
        // Who calls a subprogram is not told apart: its end may be passed as a label is, or return to any call.
        let all = Ways::of(self, true);
        let reached = Ways::from(&all.on, 0, None, count);
        let leads = Ways::from(&all.back, block, None, count);
        let is = |places: &[bool], place: usize| places.get(place).is_some_and(|is| *is);
        let before: Vec<bool> =
            (0..count).map(|place| place != block && is(&reached, place) && is(&leads, place)).collect();
        let last = (0..block).rev().find(|&place| is(&reached, place)).filter(|_| !is(&reached, block));
        let certain = Ways::of(self, false);
        let ends = Ways::from(&certain.back, count + 1, Some(block), count);
        let without = Ways::from(&certain.on, 0, Some(block), count);
        let branches = |place: usize| 1 < all.next(place).count() && !self.is_end_of_subprogram(place);
        let passes = (0..count).find(|&place| {
            is(&before, place)
                && is(&without, place)
                && branches(place)
                && certain.next(place).any(|next| next != block && is(&ends, next))
        });
        let is_straight = !(0..count).any(|place| is(&before, place) && branches(place));
        Course { before, is_straight, last, passes }
    }

    fn is_end_of_subprogram(&self, block: usize) -> bool {
        self.blocks.get(block).is_some_and(|block| block.body == Body::Label(Target::Number(0)))
    }
}

impl Ways {
    /// `falls`: whether the end of a subprogram may be passed although there are calls.
    fn of(program: &Program, falls: bool) -> Self {
        let count = program.blocks.len();
        let end = count + 1;
        let back_from = count;
        let any_label = count + 2;
        let behind = |place: usize| if place + 1 < count { place + 1 } else { end };
        let is_call = |body: &Body| matches!(body, Body::CallLabel { repeat: None, .. });
        let has_calls = program.blocks.iter().any(|block| is_call(&block.body));
        let mut on = Vec::with_capacity(count);
        for (place, block) in program.blocks.iter().enumerate() {
            let label = |target: &Target| match target {
                Target::Parameter(_) => any_label,
                // Without its label the program stops at the block, with an error.
                target => program.label(target).unwrap_or(place),
            };
            match &block.body {
                Body::End { .. } => on.push((place, end)),
                // It stops with an error.
                Body::Error(_) => {}
                Body::CallLabel { label: target, repeat } => {
                    on.push((place, label(target)));
                    let after = if repeat.is_some() { place } else { back_from };
                    on.push((after, behind(place)));
                }
                Body::Jump { label: target, .. } => on.extend([(place, label(target)), (place, behind(place))]),
                Body::Branch { unless, to } => {
                    on.push((place, *to));
                    on.extend(unless.is_some().then(|| (place, behind(place))));
                }
                Body::Subprogram { behind, .. } => on.push((place, *behind)),
                Body::Label(Target::Number(0)) if has_calls => {
                    on.push((place, back_from));
                    on.extend(falls.then(|| (place, behind(place))));
                }
                body if body.ends_the_program() => on.push((place, end)),
                _ => on.push((place, behind(place))),
            }
            if block.may_be_skipped {
                on.push((place, behind(place)));
            }
            if matches!(block.body, Body::Label(_) | Body::Subprogram { .. }) {
                on.push((any_label, place));
            }
        }
        on.sort_unstable();
        on.dedup();
        let mut back: Vec<_> = on.iter().map(|&(from, to)| (to, from)).collect();
        back.sort_unstable();
        Self { on, back }
    }

    fn next(&self, place: usize) -> impl Iterator<Item = usize> + '_ {
        following(&self.on, place)
    }

    /// All places that these ways lead to from one, which is among them; never through another one.
    fn from(ways: &[(usize, usize)], start: usize, not_through: Option<usize>, blocks: usize) -> Vec<bool> {
        let mut found = vec![false; blocks + 3];
        let mut open = vec![start];
        while let Some(place) = open.pop() {
            if Some(place) == not_through {
                continue;
            }
            if let Some(found) = found.get_mut(place).filter(|found| !**found) {
                *found = true;
                open.extend(following(ways, place));
            }
        }
        found
    }
}

fn following(ways: &[(usize, usize)], place: usize) -> impl Iterator<Item = usize> + '_ {
    let first = ways.partition_point(|(from, _)| *from < place);
    ways.iter().skip(first).take_while(move |(from, _)| *from == place).map(|(_, to)| *to)
}

impl Body {
    /// Whether M2 or M30 ends the program here.
    fn ends_the_program(&self) -> bool {
        let machine = match self {
            Self::MachineFunctions(machine) | Self::Stop(machine) => machine,
            Self::Move(movement) => &movement.machine,
            Self::PassedOver(passed) => &passed.machine,
            _ => return false,
        };
        machine.iter().any(|function| matches!(function.number, 2 | 30))
    }
}
