//! What is heard of a verdict: a rhythm, which needs no ear for pitch and no look at the screen.

use fitcheck_core::verdict::Status;
use fitcheck_exchange::journal::Record;

/// What is heard of a verdict, the worst last.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Rhythm {
    /// Good: one long tone.
    Long,
    /// Somebody has to look at the part: two tones.
    Two,
    /// Scrap: three short tones.
    Three,
}

impl Rhythm {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Long, Self::Two, Self::Three];

    /// That of a check; a simulated value is not heard: nothing was measured.
    pub(crate) fn of(record: &Record) -> Option<Self> {
        let verdict = &record.verdict;
        let rhythm = match verdict.status() {
            Status::Scrap => Self::Three,
            _ if verdict.asks_for_a_look() => Self::Two,
            _ => Self::Long,
        };
        (!record.measurement.origin.is_simulated()).then_some(rhythm)
    }
}
