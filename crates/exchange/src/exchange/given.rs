//! What was given, as errors and warnings repeat it.

use std::borrow::Cow;

use fitcheck_core::message::shortened;

/// The longest text that errors repeat, in characters.
const LONGEST_GIVEN: usize = 60;

/// A cell as errors repeat it.
pub(super) fn shorten(cell: &str) -> String {
    shortened(cell, LONGEST_GIVEN)
}

/// The same, without a copy of a cell that stays as it is.
pub(super) fn shorten_cell(cell: &str) -> Cow<'_, str> {
    let is_plain = cell.len() <= LONGEST_GIVEN && cell.bytes().all(|byte| (b' '..0x7f).contains(&byte));
    if is_plain { Cow::Borrowed(cell) } else { Cow::Owned(shorten(cell)) }
}
