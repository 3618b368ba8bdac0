//! The number of a tool: 0 to 32767, with an index from 1 to 9 behind a point for its further steps.

use std::fmt;
use std::str::FromStr;

use fitcheck_core::message::as_text;

/// The highest number without an index (manual TNC7, tool table).
const HIGHEST: u32 = 32_767;

/// The number of a tool, such as 5 or 5.1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ToolNumber {
    /// Tenths: 51 is 5.1.
    tenths: u32,
}

as_text!(ToolNumber);

/// A text or a value that is not the number of a tool: 0 to 32767, with at most one decimal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NoToolNumber;

impl ToolNumber {
    /// The tool that a parameter's value names.
    ///
    /// # Errors
    /// [`NoToolNumber`] beyond 32767.9, below 0 and with more than one decimal.
    pub fn of(value: f64) -> Result<Self, NoToolNumber> {
        // The shortest decimals of 5.1 are 5.1.
        value.to_string().parse()
    }
}

impl FromStr for ToolNumber {
    type Err = NoToolNumber;

    fn from_str(text: &str) -> Result<Self, NoToolNumber> {
        let (number, index) = text.split_once(['.', ',']).unwrap_or((text, "0"));
        let is_number = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        if !is_number(number) || !is_number(index) || 1 < index.len() {
            return Err(NoToolNumber);
        }
        match (number.parse::<u32>(), index.parse::<u32>()) {
            (Ok(number @ ..=HIGHEST), Ok(index)) => Ok(Self { tenths: number * 10 + index }),
            _ => Err(NoToolNumber),
        }
    }
}

impl fmt::Display for ToolNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.tenths / 10, self.tenths % 10) {
            (number, 0) => write!(f, "{number}"),
            (number, index) => write!(f, "{number}.{index}"),
        }
    }
}
