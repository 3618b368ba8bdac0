//! Size ranges in words: where something is defined.

use crate::length::Length;
use crate::message::Message;

/// `it is defined over 24 up to 3150 mm`, or that it is defined nowhere. Ranges are above and up to, ascending.
pub(super) fn text(ranges: &[(Length, Length)]) -> String {
    if ranges.is_empty() {
        return "it is defined nowhere".to_owned();
    }
    let ranges: Vec<String> = ranges.iter().map(|(over, to)| format!("over {over} up to {to} mm")).collect();
    format!("it is defined {}", ranges.join(", "))
}

/// The same for every language.
pub(super) fn message(ranges: &[(Length, Length)]) -> Message {
    match ranges {
        [] => Message::new("limits-defined-nowhere"),
        _ => Message::new("limits-defined").message("ranges", joined(ranges)),
    }
}

/// The ranges one after the other; halved each time, so that many ranges do not nest deeply.
fn joined(ranges: &[(Length, Length)]) -> Message {
    if let Some((first @ [_, ..], rest)) = ranges.split_at_checked(ranges.len() / 2) {
        let ranges = Message::new("limits-ranges").message("first", joined(first));
        return ranges.message("rest", joined(rest));
    }
    let (over, to) = ranges.first().copied().unwrap_or_default();
    Message::new("limits-range").mm("over", over).mm("to", to)
}
