//! The measuring cycles. A new one is a file here, its `mod` line and a line in [`CYCLES`].
//!
//! | file | cycle |
//! |---|---|
//! | `circle_cycle` | what 421 and 422 share |
//! | `rectangle_cycle` | what 423 and 424 share |
//! | `width_cycle` | what 425 and 426 share |
//! | `round` | the circle through contacts |
//! | `judged` | sizes and centres against their limits |
//! | `probed` | the clearance before a surface, and the point where the ball met the surface |
//! | `c421` | 421, measure hole |
//! | `c422` | 422, measure circle outside |
//! | `c423` | 423, measure rectangle inside |
//! | `c424` | 424, measure rectangle outside |
//! | `c425` | 425, measure inside width |
//! | `c426` | 426, measure ridge width |
//! | `c427` | 427, measure coordinate |
//! | `c444` | 444, probing in 3-D |
//! | `g785` | G785 of lathe controls, circle measurement |

mod c421;
mod c422;
mod c423;
mod c424;
mod c425;
mod c426;
mod c427;
mod c444;
mod circle_cycle;
mod g785;
mod judged;
mod probed;
mod rectangle_cycle;
mod round;
mod width_cycle;

use super::cycle::{Control, Cycle};
use crate::tolerance::Feature;

/// All cycles, by number.
pub const CYCLES: &[&Cycle] = &[
    &c421::CYCLE,
    &c422::CYCLE,
    &c423::CYCLE,
    &c424::CYCLE,
    &c425::CYCLE,
    &c426::CYCLE,
    &c427::CYCLE,
    &c444::CYCLE,
    &g785::CYCLE,
];

/// The cycle that measures a hole, or the one that measures a shaft.
pub const fn measuring(feature: Feature) -> &'static Cycle {
    match feature {
        Feature::Hole => &c421::CYCLE,
        Feature::Shaft => &c422::CYCLE,
    }
}

/// The cycles of a control.
pub fn cycles_of(control: Control) -> impl Iterator<Item = &'static Cycle> {
    CYCLES.iter().copied().filter(move |cycle| cycle.control == control)
}

/// A cycle by its number.
pub fn cycle(number: u16) -> Option<&'static Cycle> {
    CYCLES.iter().copied().find(|cycle| cycle.number == number)
}

/// A cycle by the name that people type: `421`, `G421`, `g785`.
pub fn cycle_named(name: &str) -> Option<&'static Cycle> {
    let bare = name.trim().trim_start_matches(['G', 'g']);
    CYCLES.iter().copied().find(|cycle| cycle.code.trim_start_matches('G') == bare)
}
