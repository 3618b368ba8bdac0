//! Size ranges in words: where something is defined.

use crate::length::Length;
use crate::message::{Message, message};

/// `it is defined over 24 up to 3150 mm`, or that it is not defined at any size. Ranges are above and up to, ascending.
pub(super) fn message(ranges: &[(Length, Length)]) -> Message {
    match ranges {
        [] => message!("limits-defined-nowhere"),
        _ => message!("limits-defined").with("ranges", &joined(ranges)),
    }
}

/// The defined ranges, above and up to, neighbours joined. Each item is the end of a range and whether it is defined.
pub(super) fn where_defined(ends: impl Iterator<Item = (Length, bool)>) -> Vec<(Length, Length)> {
    let mut ranges: Vec<(Length, Length)> = Vec::new();
    let mut over = Length::ZERO;
    for (to, is_defined) in ends {
        match ranges.last_mut() {
            Some(last) if is_defined && last.1 == over => last.1 = to,
            _ if is_defined => ranges.push((over, to)),
            _ => {}
        }
        over = to;
    }
    ranges
}

/// The ranges one after the other; the list is halved each time, so that many ranges do not nest deeply.
fn joined(ranges: &[(Length, Length)]) -> Message {
    match ranges {
        [] => message!("limits-defined-nowhere"),
        [(over, to)] => message!("limits-range").with("over", over).with("to", to),
        _ => {
            let (first, rest) = ranges.split_at(ranges.len() / 2);
            message!("limits-ranges").with("first", &joined(first)).with("rest", &joined(rest))
        }
    }
}
