//! A row with its verdict: its limits, its value, its status.

use std::cmp::Reverse;

use fitcheck_core::length::{Length, Window};
use fitcheck_core::tolerance::Bounds;
use fitcheck_core::verdict::{SizeVerdict, Status, judge_bounds, verdict_of};

/// What rows are compared by, the worst one the least: scrap before rework before good before no verdict, then by how far
/// the value is beyond a limit or from the nearer one.
pub type Rank = (Reverse<Option<Status>>, Length);

/// A row that was judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Judged {
    /// Its limits and nominal size.
    pub bounds: Bounds,
    pub measured: Length,
    /// Good, rework or scrap.
    pub status: Status,
}

impl Judged {
    #[expect(clippy::inline_always, reason = "its answer stays in registers, for each of millions of rows")]
    #[inline(always)]
    pub(super) fn new(bounds: Bounds, measured: Length) -> Self {
        Self { bounds, measured, status: judge_bounds(&bounds, measured).status }
    }

    /// The whole verdict; what nobody asks of it is not computed.
    #[expect(clippy::inline_always, reason = "as above")]
    #[inline(always)]
    pub fn verdict(&self) -> SizeVerdict {
        verdict_of(&self.bounds, self.measured, self.status)
    }

    /// Its rank among all rows.
    pub(super) fn rank(&self) -> Rank {
        let verdict = self.verdict();
        (Reverse(Some(self.status)), verdict.above_minimum.min(verdict.below_maximum))
    }

    /// Appends the limits in millimetres and the deviation in micrometres, each behind a separator.
    #[expect(clippy::inline_always, reason = "as above")]
    #[inline(always)]
    pub(super) fn put_figures(&self, separator: u8, out: &mut Window<'_>) {
        out.push(separator);
        self.bounds.minimum().put_mm(3, out);
        out.push(separator);
        self.bounds.maximum().put_mm(3, out);
        out.push(separator);
        self.verdict().deviation.put_um(0, out);
    }
}
