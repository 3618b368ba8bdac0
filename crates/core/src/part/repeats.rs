//! Several values of one size: which one counts, and whether they contradict each other.
//!
//! The order of rows and files is no order in time: only times say what was measured last. A later value takes the place of rework, which was
//! machined, or of a doubt. It never takes the place of scrap by itself: what was too large a hole does not become smaller, so that one of the
//! two is of another part, of another feature or wrong. Where nothing decides, the worst one counts until somebody chooses.

use super::taken::SizeValue;
use crate::verdict::Status;

/// Which of several values of a size counts that contradict each other.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Repeats {
    /// Nobody has chosen: the worst one counts, and it has to be looked at first.
    #[default]
    Open,
    /// The last one.
    Last,
    /// The worst one.
    Worst,
}

impl Repeats {
    /// Those that can be chosen.
    pub const CHOICES: [Self; 2] = [Self::Last, Self::Worst];

    /// Its word on the command line.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Last => "last",
            Self::Worst => "worst",
        }
    }
}

/// What counts among the values of a size.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Counting {
    /// Its place.
    pub at: usize,
    /// Whether the others contradict it, and nobody has chosen.
    pub is_contradicted: bool,
}

/// Looks at values with their places, in the order in which they came.
pub(super) fn counting(mut values: impl Iterator<Item = (usize, SizeValue)>, by: Repeats) -> Option<Counting> {
    let first = values.next()?;
    let mut last = first;
    let mut worst = first;
    let mut latest = first;
    let mut is_same = true;
    let mut all_timed = first.1.when.is_some();
    let mut is_latest_mixed = false;
    for value in values {
        is_same &= value.1.status == first.1.status;
        all_timed &= value.1.when.is_some();
        if latest.1.when < value.1.when {
            is_latest_mixed = false;
        } else if latest.1.when == value.1.when {
            is_latest_mixed |= latest.1.status != value.1.status;
        }
        if latest.1.when <= value.1.when {
            latest = value;
        }
        if worst.1.status <= value.1.status {
            worst = value;
        }
        last = value;
    }
    let has_order = all_timed && !is_latest_mixed;
    let newest = if has_order { latest } else { last };
    let replaces_scrap = worst.1.status == Status::Scrap && newest.1.status != Status::Scrap;
    let (value, is_contradicted) = match by {
        _ if is_same => (newest, false),
        Repeats::Last => (newest, false),
        Repeats::Worst => (worst, false),
        Repeats::Open if has_order && !replaces_scrap => (newest, false),
        Repeats::Open => (worst, true),
    };
    Some(Counting { at: value.0, is_contradicted })
}
