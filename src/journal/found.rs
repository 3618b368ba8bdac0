//! What an entry is found by: derived from it, and made anew at will.

use super::entry::{Check, Checked, Content, Entry};
use super::query::callout;
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

impl Found {
    /// What an entry is found by; `None` for the first entry of a chain, which is no check.
    pub fn of(entry: &Entry) -> Option<Self> {
        let about = &entry.about;
        let kind = match &entry.content {
            Content::Begin(_) => return None,
            Content::Check(_) => Kind::Check,
            Content::Withdrawal(_) => Kind::Withdrawal,
        };
        let [part, serial, feature, who, station] =
            [&about.part, &about.serial, &about.feature, &about.who, &about.station].map(|text| folded(text));
        let texts = [&about.part, &about.serial, &about.feature, &about.who, &about.remark];
        let words: Vec<String> = texts.iter().flat_map(|text| words_of(text)).collect();
        let (callout, class) = entry.check().map(asked).unwrap_or_default();
        Some(Self {
            kind,
            at_ms: about.time.utc_ms,
            status: entry.check().and_then(Check::status),
            is_simulated: entry.check().is_some_and(Check::is_simulated),
            part,
            serial,
            feature,
            callout,
            class,
            who,
            station,
            corrects: entry.corrects().map(|correction| correction.target.number),
            words: words.join(" "),
        })
    }
}

/// The callout and the tolerance class of a check.
fn asked(check: &Check) -> (String, String) {
    match &check.what {
        Checked::Size(record) => {
            let class = record.callout.and_then(|callout| callout.class());
            (callout(record), class.map(|class| class.to_string()).unwrap_or_default())
        }
        Checked::Cycle(_) => (String::new(), String::new()),
    }
}

/// A name as it is looked for: in small letters, without blanks around it.
pub fn folded(text: &str) -> String {
    text.trim().to_lowercase()
}

/// The words of a text, in small letters: letters and digits; everything else stands between words.
pub fn words_of(text: &str) -> impl Iterator<Item = String> + '_ {
    text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).map(str::to_lowercase)
}
