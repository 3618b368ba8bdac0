//! What an entry is found by: read from its body by [`body::found`](super::body::found), and made anew at will.

use std::borrow::Cow;

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::Callout;
use fitcheck_core::verdict::Status;
use unicode_normalization::UnicodeNormalization as _;
use unicode_normalization::char::is_combining_mark;

use super::chain::Hash;
use super::ranges::EntryRanges;

/// Which entries are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FoundEntryKind {
    Check,
    /// A check is taken back.
    Withdrawal,
    /// A file of checks was written: never a check itself.
    Report,
    /// A rule of a control chart fires, or somebody answers that.
    Alarm,
}

/// What an entry is found by, as it was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FoundEntry<'a> {
    pub kind: FoundEntryKind,
    /// When it was written, milliseconds since 1970 in UTC.
    pub at_ms: i64,
    /// The verdict.
    pub status: Option<Status>,
    /// Whether nobody measured.
    pub is_simulated: bool,
    pub part: Cow<'a, str>,
    pub serial: Cow<'a, str>,
    pub feature: Cow<'a, str>,
    /// Who measured.
    pub who: Cow<'a, str>,
    pub station: Cow<'a, str>,
    pub remark: Cow<'a, str>,
    /// What was asked for; `None` for a cycle and a withdrawal.
    pub asked: Option<EntryCallout<'a>>,
    /// The measured value in nanometres; `None` for a cycle without a size and a withdrawal.
    pub measured_nm: Option<i64>,
    /// The number of the entry that it corrects, or of the alarm that it answers.
    pub corrects: Option<u64>,
    /// Why it corrects that, or cause and action of the alarm; empty where there is none.
    pub reason: Cow<'a, str>,
    /// The file that was written; only of a report.
    pub report: Option<FoundReport<'a>>,
}

/// What a report is found by.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FoundReport<'a> {
    /// The file's name without its folder.
    pub name: Cow<'a, str>,
    pub title: Cow<'a, str>,
    /// SHA-256 of the file's bytes.
    pub sha256: Hash,
    /// The entries of the checks that it shows.
    pub checks: EntryRanges,
}

/// What a size was asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EntryCallout<'a> {
    /// The callout; `None` where limits came from a log, which holds none.
    pub callout: Option<Cow<'a, str>>,
    /// The nominal size in nanometres.
    pub nominal_nm: i64,
}

impl FoundEntry<'_> {
    /// The callout as it is listed, since `25 H7` is another one than `25 h7`; empty where there is none.
    pub fn callout(&self) -> Cow<'_, str> {
        match &self.asked {
            Some(EntryCallout { callout: Some(callout), .. }) => Cow::Borrowed(callout),
            Some(EntryCallout { callout: None, nominal_nm }) => {
                let nominal = Length::from_nanometres(*nominal_nm);
                nominal.map_or_else(|_too_large| String::new(), |nominal| format!("Ø {nominal}")).into()
            }
            None => Cow::Borrowed(""),
        }
    }

    /// The tolerance class; empty where there is none.
    pub fn class(&self) -> String {
        let callout = self.asked.as_ref().and_then(|asked| asked.callout.as_ref());
        let class = callout.and_then(|callout| callout.parse::<Callout>().ok()).and_then(|callout| callout.class());
        class.map_or_else(String::new, |class| class.to_string())
    }

    /// The words of part, serial number, feature, name, remark and reason, of a report's file and title, and of the callout with its blanks
    /// and without; the measured value as a number.
    pub fn words(&self) -> Vec<String> {
        let own = [&self.part, &self.serial, &self.feature, &self.who, &self.remark, &self.reason];
        let of_report = self.report.iter().flat_map(|report| [&report.name, &report.title]);
        let texts: Vec<&Cow<'_, str>> = own.into_iter().chain(of_report).collect();
        let callout = self.callout();
        let joined: String = callout.split_whitespace().collect();
        let of_callout = [callout.as_ref(), joined.as_str()].into_iter().flat_map(words_of).collect::<Vec<_>>();
        let numbers = texts.iter().flat_map(|text| decimals_in(text)).chain(self.measured_nm.map(millimetres));
        let numbers = numbers.collect::<Vec<_>>();
        texts.into_iter().flat_map(|text| words_of(text)).chain(of_callout).chain(numbers).collect()
    }

    /// Whether for each of some words it has one that begins so, or has the number that the word is.
    pub fn has_words(&self, number: u64, wanted: &[WantedWord]) -> bool {
        if wanted.is_empty() {
            return true;
        }
        let words = self.words();
        let has = |wanted: &WantedWord| {
            wanted.number == Some(number) || words.iter().any(|word| word.starts_with(wanted.text.as_str()))
        };
        wanted.iter().all(has)
    }
}

/// A word that an entry must have.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WantedWord {
    /// In small letters and without accents; what an entry has may go on behind it.
    pub text: String,
    /// The entry that it is the number of, where it is a plain number.
    pub number: Option<u64>,
}

impl WantedWord {
    /// The words of a text that is looked for.
    pub fn all_of(text: &str) -> Vec<Self> {
        let text = text.trim();
        let is_number = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        let number = if is_number { text.parse().ok() } else { None };
        let words = decimal(text).map_or_else(|| words_of(text), |decimal| vec![decimal]);
        words.into_iter().map(|text| Self { text, number }).collect()
    }
}

/// Stands before each part of a number with a decimal sign, which is one word: `25.012` does not find a 25 beside a 012. No word of a text has
/// it, and to the index it is a letter.
const DECIMAL: char = '\u{b7}';

/// A text that is a number with a decimal sign, or figures with points between them such as a date, as a word; its sign does not count.
fn decimal(text: &str) -> Option<String> {
    let figures = text.strip_prefix(['-', '+', '\u{2212}']).unwrap_or(text);
    let parts: Vec<&str> = figures.split(['.', ',']).collect();
    let is_figures = |part: &&str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    (2 <= parts.len() && parts.iter().all(is_figures)).then(|| joined(&parts))
}

fn joined(parts: &[&str]) -> String {
    parts.iter().flat_map(|part| [DECIMAL.to_string(), (*part).to_owned()]).collect()
}

/// The numbers with a decimal sign in a text; of `26.11.2026` also `11.2026`.
fn decimals_in(text: &str) -> Vec<String> {
    let runs = text.split(|c: char| !c.is_ascii_digit() && c != '.' && c != ',');
    let parts = runs.map(|run| run.split(['.', ',']).collect::<Vec<_>>());
    let parts: Vec<Vec<&str>> = parts.filter(|parts| 2 <= parts.len()).collect();
    let groups = parts.iter().flat_map(|parts| parts.split(|part| part.is_empty()));
    groups
        .flat_map(|group| (0..group.len().saturating_sub(1)).filter_map(|from| group.get(from..)).map(joined))
        .collect()
}

/// A length as such a word: to the nanometre, so that `25.0120` finds 25.012, and `25.01` all that begin so.
fn millimetres(nanometres: i64) -> String {
    let all = nanometres.unsigned_abs();
    format!("{DECIMAL}{}{DECIMAL}{:06}", all / 1_000_000, all % 1_000_000)
}

/// A name as it is looked for: in small letters, without blanks around it, however its accents were composed.
pub fn folded(text: &str) -> Cow<'_, str> {
    let text = text.trim();
    if !text.is_ascii() {
        return text.nfc().collect::<String>().to_lowercase().into();
    }
    if text.bytes().any(|byte| byte.is_ascii_uppercase()) { text.to_ascii_lowercase().into() } else { text.into() }
}

/// The words of a text, in small letters and without accents: letters and digits; everything else stands between words.
pub fn words_of(text: &str) -> Vec<String> {
    let plain = if text.is_ascii() {
        text.to_ascii_lowercase()
    } else {
        text.nfkd().filter(|c| !is_combining_mark(*c)).collect::<String>().to_lowercase()
    };
    plain.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).map(str::to_owned).collect()
}
