//! From the text of the question to what is asked of the journal. Buttons write into the same text: what is asked is always in sight.

use jiff::civil::DateTime;

use super::{RecordsField, RecordsPage};
use crate::journal::ask::Question;
use crate::session::command::Effect;
use crate::session::shared::Shared;

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
    /// Every one.
    pub const ALL: [Self; 4] = [Self::Today, Self::ThisWeek, Self::NotGood, Self::Measured];

    /// The word.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Today => "today",
            Self::ThisWeek => "week",
            Self::NotGood => "verdict:bad",
            Self::Measured => "measured",
        }
    }
}

impl RecordsPage {
    /// Whether the question has a word.
    pub fn has(&self, shorthand: Shorthand) -> bool {
        self.text(RecordsField::Question).split_whitespace().any(|word| word == shorthand.word())
    }

    /// Puts a word into the question, or takes it out.
    pub(super) fn toggle(&mut self, shorthand: Shorthand) {
        let text = self.text(RecordsField::Question);
        let others = text.split_whitespace().filter(|word| *word != shorthand.word());
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
        match read(self.text(RecordsField::Question), self.now) {
            Ok(question) => {
                self.runs += 1;
                self.asks = self.runs;
                self.asked_at = shared.recording.newest();
                self.listing.ask();
                self.errands.push(Effect::AskRecords { run: self.asks, question: Box::new(question), rests });
            }
            Err((problem, culprit)) => {
                self.errors.insert(RecordsField::Question, problem);
                self.culprit = culprit;
            }
        }
    }
}

type Refused = (crate::message::Message, Option<std::ops::Range<usize>>);

/// What a text asks.
fn read(text: &str, _now: DateTime) -> Result<Question, Refused> {
    Ok(Question { words: text.split_whitespace().map(str::to_owned).collect(), ..Question::default() })
}
