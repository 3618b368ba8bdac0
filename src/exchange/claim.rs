//! What a file itself says of a value's status: told where the verdict is another one.

use super::error::{ImportWarningKind, shorten};
use crate::control::status::status_of;
use crate::verdict::Status;

/// Words and marks of a value within its limits, without their stops and blanks.
const GOOD: &str = "ok|pass|passed|accept|accepted|conform|conforms|conforming|io|inordnung|oke|akkoord|goedgekeurd|conforme|intolerance|\
    intol|withintolerance|withinlimits|gut|goed|buono|bestanden|freigegeben|innerhalb|idoneo|accettato|✓|✔|✅|☑";

/// The same of one out of its limits.
const OUT: &str = "nok|notok|ng|fail|failed|reject|rejected|nio|nichtinordnung|nietok|nietakkoord|afgekeurd|nonconform|nonconforme|\
    nonconforming|nonok|ko|bad|schlecht|slecht|scrapped|outoftolerance|outoftol|outoflimits|oot|zurückgewiesen|gesperrt|nichtbestanden|\
    außerhalb|ausserhalb|fout|fuoritolleranza|nonidoneo|respinto|✗|✘|✕|❌|☒";

/// Words that say how far a value has come, and nothing of its verdict.
const NO_VERDICT: &str =
    "measured|done|complete|completed|finished|gemessen|fertig|erledigt|gemeten|gereed|klaar|misurato|na|none|nv|nvt";

/// Marks that say something without a letter.
const MARKS: &str = "✓✔✅☑✗✘✕❌☒?!+";

fn letters(word: &str) -> String {
    word.to_lowercase().chars().filter(|c| c.is_alphanumeric()).collect()
}

fn says_nothing(text: &str) -> bool {
    let small = letters(text);
    NO_VERDICT.split('|').any(|known| known == small)
}

/// What a file says of a value's status.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Claim {
    /// As the file says it.
    pub said: String,
    /// The verdicts that agree with it: all of them where nothing known is said.
    pub agrees: &'static [Status],
}

impl Claim {
    /// A claim of one status.
    pub(super) fn of(said: &str, status: Status) -> Self {
        let agrees: &'static [Status] = match status {
            Status::Good => &[Status::Good],
            Status::Rework => &[Status::Rework],
            Status::Scrap => &[Status::Scrap],
            Status::ReMeasure => &[Status::ReMeasure],
        };
        Self { said: shorten(said), agrees }
    }

    /// That a value is out of its limits, or that something else is wrong with it.
    pub(super) fn out(said: &str) -> Self {
        // Whoever knows no rework calls it so as well.
        Self { said: shorten(said), agrees: &[Status::Rework, Status::Scrap] }
    }

    /// A claim that no verdict agrees with.
    pub(super) fn unknown(said: &str) -> Self {
        Self { said: shorten(said), agrees: &[] }
    }

    /// What a cell of a table claims; `None` where it says nothing of a verdict.
    pub(super) fn of_cell(text: &str) -> Option<Self> {
        let is_said = text.contains(|c: char| c.is_alphanumeric() || MARKS.contains(c)) && !says_nothing(text);
        let not_known = || Self { said: shorten(text), agrees: &Status::ALL };
        is_said.then(|| Self::of_word(text).unwrap_or_else(not_known))
    }

    /// What a word claims; `None` for one that is not known.
    fn of_word(word: &str) -> Option<Self> {
        if let Some(status) = status_of(word) {
            return Some(Self::of(word, status));
        }
        let small = letters(word);
        let is = |list: &str| list.split('|').any(|known| known == small || known == word.trim());
        if is(GOOD) {
            return Some(Self::of(word, Status::Good));
        }
        if is(OUT) {
            return Some(Self::out(word));
        }
        // "n.i.O. (scratch)", "rejected - burr"
        let (first, _) = word.split_once(" (").or_else(|| word.split_once(" - ")).or_else(|| word.split_once(": "))?;
        Some(Self { said: shorten(word), ..Self::of_word(first)? })
    }

    /// What is to be told beside a verdict: that the file says another one, or something that is not known.
    pub(super) fn tells(&self, status: Status) -> Option<ImportWarningKind> {
        if self.agrees.len() == Status::ALL.len() {
            return Some(ImportWarningKind::StatusUnknown {
                given: self.said.clone(),
                status: status.word().to_owned(),
            });
        }
        self.differs(status)
    }

    /// The warning where a verdict is another one.
    pub(super) fn differs(&self, status: Status) -> Option<ImportWarningKind> {
        let warning =
            || ImportWarningKind::StatusDiffers { given: self.said.clone(), status: status.word().to_owned() };
        (!self.agrees.contains(&status)).then(warning)
    }
}
