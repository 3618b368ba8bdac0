//! What an entry is found by: derived from its body by [`body::found`](super::body::found), and made anew at will.

use crate::verdict::Status;

/// Which entries are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A check.
    Check,
    /// A check is taken back.
    Withdrawal,
}

/// What an entry is found by. Names are folded: in small letters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Found {
    /// What it is.
    pub kind: Kind,
    /// When it was written, milliseconds since 1970 in UTC.
    pub at_ms: i64,
    /// The verdict.
    pub status: Option<Status>,
    /// Whether nobody measured.
    pub is_simulated: bool,
    /// The part.
    pub part: String,
    /// Its serial number.
    pub serial: String,
    /// The feature.
    pub feature: String,
    /// The callout as it is written, since `25 H7` is another one than `25 h7`.
    pub callout: String,
    /// The tolerance class as it is written.
    pub class: String,
    /// Who measured.
    pub who: String,
    /// The station.
    pub station: String,
    /// The number of the entry that it corrects.
    pub corrects: Option<u64>,
    /// The words of part, serial number, feature, name and remark.
    pub words: String,
}

/// A name as it is looked for: in small letters, without blanks around it.
pub fn folded(text: &str) -> String {
    text.trim().to_lowercase()
}

/// The words of a text, in small letters: letters and digits; everything else stands between words.
pub fn words_of(text: &str) -> impl Iterator<Item = String> + '_ {
    text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).map(str::to_lowercase)
}
