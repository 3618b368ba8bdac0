//! Whether a question asks for an entry.

use super::{AskedKinds, Question};
use crate::journal::found::{FoundEntry, FoundEntryKind, WantedWord, folded};

impl Question {
    /// Whether it asks for the entry of a number; `is_corrected` where another one stands in its place or takes it back.
    pub fn finds(&self, number: u64, found: &FoundEntry<'_>, is_corrected: bool) -> bool {
        let names = [
            (&self.part, &found.part),
            (&self.feature, &found.feature),
            (&self.who, &found.who),
            (&self.station, &found.station),
        ];
        let is_check = matches!(found.kind, FoundEntryKind::Check | FoundEntryKind::Withdrawal);
        let is_open_alarm = found.kind == FoundEntryKind::Alarm && found.corrects.is_none();
        let may_stand =
            if self.kinds == AskedKinds::Alarms { is_open_alarm } else { found.kind == FoundEntryKind::Check };
        let is = |asked: &Option<String>, text: &str| asked.as_ref().is_none_or(|asked| asked == text);
        let is_name =
            |asked: &Option<String>, text: &str| asked.as_ref().is_none_or(|asked| folded(asked) == folded(text));
        names.into_iter().all(|(asked, text)| is_name(asked, text))
            && is(&self.callout, &found.callout())
            && (self.class.is_none() || is(&self.class, &found.class()))
            && self.serial.as_ref().is_none_or(|asked| is_serial(&folded(asked), &folded(&found.serial)))
            && (self.verdicts.is_empty() || found.status.is_some_and(|status| self.verdicts.contains(&status)))
            && self.from_ms.is_none_or(|from| from <= found.at_ms)
            && self.before_ms.is_none_or(|before| found.at_ms < before)
            && self.simulated.is_none_or(|simulated| simulated == found.is_simulated && is_check)
            && self.kinds.has(found.kind)
            && (!self.standing || (may_stand && !is_corrected))
            && self.wanted_words().is_some_and(|words| found.has_words(number, &words))
    }

    /// The words that an entry must have; `None` where only signs are asked for, which are in no word.
    pub fn wanted_words(&self) -> Option<Vec<WantedWord>> {
        let words: Vec<WantedWord> = self.words.iter().flat_map(|text| WantedWord::all_of(text)).collect();
        let is_only_signs = words.is_empty() && self.words.iter().any(|text| !text.trim().is_empty());
        (!is_only_signs).then_some(words)
    }
}

impl AskedKinds {
    /// Whether entries of a kind are asked for.
    const fn has(self, kind: FoundEntryKind) -> bool {
        match self {
            Self::All => true,
            Self::Checks => matches!(kind, FoundEntryKind::Check | FoundEntryKind::Withdrawal),
            Self::Reports => matches!(kind, FoundEntryKind::Report),
            Self::Alarms => matches!(kind, FoundEntryKind::Alarm),
        }
    }
}

/// Whether a serial number is the one that is asked for, or with `*` at the end begins so.
fn is_serial(asked: &str, serial: &str) -> bool {
    match asked.strip_suffix('*') {
        Some(start) => !serial.is_empty() && serial.starts_with(start),
        None => serial == asked,
    }
}
