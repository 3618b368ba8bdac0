//! The measuring cycles. A new one is a file here and a line in [`CYCLES`].
//!
//! | file | cycle |
//! |---|---|
//! | `circle_cycle` | what 421 and 422 share |
//! | `c421` | 421, measure hole |
//! | `c422` | 422, measure circle outside |

mod c421;
mod c422;
mod circle_cycle;

use super::cycle::Cycle;

/// All cycles, by number.
pub const CYCLES: &[&Cycle] = &[&c421::CYCLE, &c422::CYCLE];

/// A cycle by its number.
pub fn cycle(number: u16) -> Option<&'static Cycle> {
    CYCLES.iter().copied().find(|cycle| cycle.number == number)
}
