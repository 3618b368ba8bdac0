//! A value of a size, as a walk through a part keeps it.

use jiff::civil::DateTime;

use crate::verdict::Status;

/// A value of a size.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SizeValue {
    /// Its verdict.
    pub status: Status,
    /// Whether nobody measured it.
    pub is_simulated: bool,
    /// When it was measured, where that is known.
    pub when: Option<DateTime>,
    /// Whether it counts no more, because somebody measured again or chose another one.
    pub is_settled: bool,
}
