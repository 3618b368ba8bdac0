//! What was found of a chain, and how far it is.

use indicatif::{ProgressBar, ProgressStyle};

use crate::journal::chain::Head;
use crate::journal::inspection::{Break, Inspected};

/// A line that changes; nothing where standard error is no terminal.
pub(super) fn bar() -> ProgressBar {
    let bar = ProgressBar::new(0);
    if let Ok(style) = ProgressStyle::with_template("{bar:20} {percent} %, {human_pos} entries, {eta} left") {
        bar.set_style(style);
    }
    bar
}

object! {
    /// What was found of a chain: its last entry, and what is not as it was written.
    pub(super) struct InspectedAnswer of(inspected: &Inspected) {
        head: HeadAnswer = HeadAnswer::of(inspected.head),
        first_bad: Option<u64> = inspected.breaks.first().map(Break::number),
        break_count: u64 = inspected.count,
        breaks: Vec<BreakAnswer> = inspected.breaks.iter().map(BreakAnswer::of).collect(),
    }

    pub(super) struct HeadAnswer of(head: Head) {
        number: u64 = head.number,
        hash: String = head.hash.to_string(),
    }

    struct BreakAnswer of(one: &Break) {
        number: u64 = one.number(),
        what: String = one.to_string(),
    }
}
