//! The measuring cycles. A new one is a file here and a line in [`CYCLES`].
//!
//! | file | cycle |
//! |---|---|
//! | `circle_cycle` | what 421 and 422 share |
//! | `round` | from contacts to a circle |
//! | `c421` | 421, measure hole |
//! | `c422` | 422, measure circle outside |
//! | `c427` | 427, measure coordinate |
//! | `c444` | 444, probing in 3-D |
//! | `g785` | G785 of lathe controls, circle measurement |

mod c421;
mod c422;
mod c427;
mod c444;
mod circle_cycle;
mod g785;
mod round;

use super::cycle::Cycle;

/// All cycles, by number.
pub const CYCLES: &[&Cycle] = &[&c421::CYCLE, &c422::CYCLE, &c427::CYCLE, &c444::CYCLE, &g785::CYCLE];

/// A cycle by its number.
pub fn cycle(number: u16) -> Option<&'static Cycle> {
    CYCLES.iter().copied().find(|cycle| cycle.number == number)
}

/// A cycle by the name that people type: `421`, `G421`, `g785`.
pub fn cycle_named(name: &str) -> Option<&'static Cycle> {
    let bare = name.trim().trim_start_matches(['G', 'g']);
    CYCLES.iter().copied().find(|cycle| cycle.code.trim_start_matches('G') == bare)
}
