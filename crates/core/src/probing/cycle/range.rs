//! The values that a parameter of a cycle may have.

use super::value::Angle;
use crate::length::Length;
use crate::message::{Message, Say, display, message};

/// The values that a parameter may have; both ends of a range are allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// A length, mm.
    Length {
        /// From.
        least: Length,
        /// To.
        most: Length,
    },
    /// An angle, degrees, at most `most` either way and at least `smallest` in size.
    Angle {
        /// The most either way.
        most: Angle,
        /// The least in size; zero where every size is allowed.
        smallest: Angle,
    },
    /// A nominal value with or without a tolerance, mm, as cycles 14xx take it. Its limits lie in the range, too.
    Nominal {
        /// From.
        least: Length,
        /// To.
        most: Length,
    },
    /// One of a few numbers.
    OneOf(&'static [i64]),
    /// A number without a unit, at most `most` either way.
    Number {
        /// The most either way.
        most: u16,
    },
    /// A whole number from 0.
    Count {
        /// To.
        most: u32,
    },
    /// A tool by number, 0 to 99999.9 with 0 for none, or by name, at most 255 characters.
    Tool,
    /// A tolerance band as in QS400, or none.
    Band,
}

/// The highest number of a tool; the digit after the point is its index.
pub(super) const HIGHEST_TOOL: f64 = 99_999.9;

/// The most characters of a text parameter.
pub(super) const LONGEST_TEXT: usize = 255;

display!(Range);

/// What is allowed, as the second half of a range error.
impl Say for Range {
    fn message(&self) -> Message {
        match self {
            Self::Length { least, most } | Self::Nominal { least, most } => {
                message!("cycle-length-range").number("least", least).number("most", most)
            }
            Self::Angle { most, smallest } if *smallest == Angle::default() => {
                message!("cycle-angle-range").number("most", most)
            }
            Self::Angle { most, smallest } => {
                message!("cycle-angle-size-range").number("smallest", smallest).number("most", most)
            }
            Self::OneOf(allowed) => message!("cycle-one-of").number("allowed", listed(allowed)),
            Self::Number { most } => message!("cycle-number-range").text("most", most),
            Self::Count { most } => message!("cycle-count-range").text("most", most),
            Self::Tool => message!("cycle-tool-range"),
            Self::Band => message!("cycle-band-range"),
        }
    }
}

impl Range {
    /// The unit of the value, where it has one.
    pub const fn unit(&self) -> Option<&'static str> {
        match self {
            Self::Length { .. } | Self::Nominal { .. } | Self::Band => Some("mm"),
            Self::Angle { .. } => Some("°"),
            Self::OneOf(_) | Self::Number { .. } | Self::Count { .. } | Self::Tool => None,
        }
    }

    /// The range as a table shows it: `-99999.9999 … 99999.9999`, `0, 1, 2`.
    pub fn short(&self) -> Message {
        let figures = |text: String| message!("cycle-range").number("range", text);
        match self {
            Self::Length { least, most } | Self::Nominal { least, most } => figures(format!("{least} … {most}")),
            Self::Angle { most, smallest } => {
                let [most, smallest] = [most, smallest].map(|angle| angle.to_string().trim_end_matches('°').to_owned());
                figures(if smallest == "0" {
                    format!("-{most} … {most}")
                } else {
                    format!("±{smallest} … ±{most}")
                })
            }
            Self::OneOf(allowed) => figures(listed(allowed)),
            Self::Number { most } => figures(format!("-{most} … {most}")),
            Self::Count { most } => figures(format!("0 … {most}")),
            Self::Tool => message!("cycle-range-tool").number("highest", HIGHEST_TOOL).text("longest", LONGEST_TEXT),
            Self::Band => message!("cycle-range-band"),
        }
    }
}

fn listed(numbers: &[i64]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}
