//! Words of the rows of a large file.

use crate::exchange::batch::RowFate;
use crate::words::Words;

/// The name of what became of a row.
pub(super) fn fate_text(words: &Words, fate: RowFate) -> String {
    fate.status().map_or_else(|| words.get("rows-not-judged"), |status| words.told(&status))
}
