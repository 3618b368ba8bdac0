//! From the text of the question to what is asked of the journal. Buttons write into the same text: what is asked is always in sight.

use std::ops::Range;

use fitcheck_core::message::Say as _;
use fitcheck_exchange::journal::ask::{LocalNow, Question};
use jiff::Timestamp;
use jiff::tz::TimeZone;

use super::{RecordsField, RecordsPage};
use crate::effect::Effect;
use crate::shared::Shared;
use crate::state::PageState as _;

/// A word of the language of questions that has a button.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Shorthand {
    /// Checks of today.
    Today,
    /// Checks of this week.
    ThisWeek,
    /// Checks that are not good.
    NotGood,
    /// Checks that somebody measured.
    Measured,
}

impl Shorthand {
    pub const ALL: [Self; 4] = [Self::Today, Self::ThisWeek, Self::NotGood, Self::Measured];

    pub const fn word(self) -> &'static str {
        match self {
            Self::Today => "today",
            Self::ThisWeek => "week",
            Self::NotGood => "verdict:rework,re-measure,scrap",
            Self::Measured => "measured",
        }
    }
}

/// The words of a question with their places; what is in quotation marks is of one word.
fn words(text: &str) -> Vec<(Range<usize>, &str)> {
    let mut words = Vec::new();
    let mut start = None;
    let mut is_quoted = false;
    for (at, sign) in text.char_indices().chain([(text.len(), ' ')]) {
        is_quoted ^= sign == '"';
        let is_between = sign.is_whitespace() && !is_quoted || at == text.len();
        match (start, is_between) {
            (None, false) => start = Some(at),
            (Some(from), true) => {
                words.extend(text.get(from..at).map(|word| (from..at, word)));
                start = None;
            }
            _ => {}
        }
    }
    words
}

impl RecordsPage {
    /// Whether the question has a word.
    pub fn has(&self, shorthand: Shorthand) -> bool {
        words(self.text(RecordsField::Question)).iter().any(|(_, word)| *word == shorthand.word())
    }

    /// Puts a word into the question, or takes it out.
    pub(super) fn toggle(&mut self, shorthand: Shorthand) {
        let text = self.text(RecordsField::Question);
        let others = words(text).into_iter().map(|(_, word)| word).filter(|word| *word != shorthand.word());
        let added = (!self.has(shorthand)).then_some(shorthand.word());
        let text = others.chain(added).collect::<Vec<_>>().join(" ");
        self.texts.insert(RecordsField::Question, text);
    }

    /// Asks the question. `rests` waits until nobody types.
    pub(super) fn ask(&mut self, shared: &Shared, rests: bool) {
        self.errors.remove(&RecordsField::Question);
        self.culprit = None;
        if !shared.recording.is_on() {
            return;
        }
        let zone = self.zone.clone().unwrap_or(TimeZone::UTC);
        let now = self.now.to_zoned(zone.clone()).map_or(Timestamp::UNIX_EPOCH, |now| now.timestamp());
        match Question::read(self.text(RecordsField::Question), &LocalNow { now, zone }) {
            Ok(question) => {
                self.runs += 1;
                self.asks = self.runs;
                self.asked_at = shared.recording.newest;
                self.listing.ask();
                self.errands.push(Effect::AskRecords { run: self.asks, question: Box::new(question), rests });
            }
            Err(error) => {
                self.errors.insert(RecordsField::Question, error.message());
                self.culprit = Some(error.span);
            }
        }
    }
}
