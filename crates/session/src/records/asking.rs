//! From the text of the question to what is asked of the journal. Buttons write into the same text: what is asked is always in sight.

use std::ops::Range;

use fitcheck_core::message::Say as _;
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;
use fitcheck_exchange::journal::ask::{AskError, KEYS, LocalNow, Question, SWITCHES, asking, verdict_of};
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
    /// Checks that no other entry corrects or takes back.
    Standing,
}

impl Shorthand {
    pub const ALL: [Self; 5] = [Self::Today, Self::ThisWeek, Self::NotGood, Self::Measured, Self::Standing];

    /// The words of the question that it stands for. What was corrected or withdrawn is not good either, and nobody has to do anything
    /// about it.
    pub const fn words(self) -> &'static [&'static str] {
        match self {
            Self::Today => &["today"],
            Self::ThisWeek => &["week"],
            Self::NotGood => &[NOT_GOOD, STANDING],
            Self::Measured => &["measured"],
            Self::Standing => &[STANDING],
        }
    }
}

/// Every verdict that asks for something to be done.
pub const NOT_GOOD: &str = "verdict:rework,re-measure,scrap";

/// Asks for checks that are not void.
const STANDING: &str = "standing";

/// The verdicts as the window calls them, and as it called them before it had the user's own words.
fn named(words: &Words) -> Vec<(String, Status)> {
    let built_in = words.own().map(|_| Words::new(words.language()));
    let told = |words: &Words| Status::ALL.map(|status| (words.told(&status), status));
    told(words).into_iter().chain(built_in.iter().flat_map(told)).collect()
}

/// A word of the question that has a name: it stands beside the question, where it can be taken out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Filter {
    /// What it asks about, or the switch that it is, in the language of questions.
    pub key: &'static str,
    /// What it asks for; nothing of a switch.
    pub value: String,
    /// As it stands in the question.
    pub word: String,
}

impl Filter {
    /// Nothing of a word that is searched for, and of one that is still being typed.
    fn of(word: &str, named: &[(String, Status)]) -> Option<Self> {
        let is = |of: &&str| of.eq_ignore_ascii_case(word);
        if let Some(key) = SWITCHES.into_iter().find(|switch| is(switch)) {
            return Some(Self { key, value: String::new(), word: word.to_owned() });
        }
        if let Some(status) = verdict_of(word, named) {
            return Some(Self { key: "verdict", value: status.key().to_owned(), word: word.to_owned() });
        }
        let (given, value) = word.split_once(':')?;
        let key = KEYS.into_iter().find(|key| key.eq_ignore_ascii_case(given))?;
        let plain = value.strip_prefix('"').and_then(|value| value.strip_suffix('"'));
        let value = plain.map_or_else(|| value.to_owned(), |plain| plain.replace("\"\"", "\""));
        (!value.is_empty()).then(|| Self { key, value, word: word.to_owned() })
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

/// What a text asks of the journal.
///
/// # Errors
/// Which part of it is no question.
pub(crate) fn question(text: &str, shared: &Shared) -> Result<Question, AskError> {
    let zone = shared.recording.zone.clone().unwrap_or(TimeZone::UTC);
    let now = shared.recording.now.to_zoned(zone.clone()).map_or(Timestamp::UNIX_EPOCH, |now| now.timestamp());
    Question::read_named(text, &LocalNow { now, zone }, &named(&shared.words()))
}

impl RecordsPage {
    /// Whether the question has a word.
    pub fn has(&self, shorthand: Shorthand) -> bool {
        let asked = words(self.text(RecordsField::Question));
        shorthand.words().iter().all(|wanted| asked.iter().any(|(_, word)| word == wanted))
    }

    /// Takes a word out of the question, and asks it.
    pub(super) fn remove(&mut self, word: &str, shared: &Shared) {
        let text = self.text(RecordsField::Question);
        let others: Vec<&str> =
            words(text).into_iter().map(|(_, other)| other).filter(|other| *other != word).collect();
        let text = others.join(" ");
        self.texts.insert(RecordsField::Question, text);
        self.ask(shared, false);
    }

    /// What the field of a new filter asks about.
    pub fn filter_key(&self) -> &'static str {
        self.filter_key.unwrap_or("part")
    }

    /// Puts the filter of the form into the question, in the place of one about the same, and asks it.
    pub(super) fn add_filter(&mut self, shared: &Shared) {
        let key = self.filter_key();
        let named = named(&shared.words());
        let value = self.text(RecordsField::Filter).trim();
        // A verdict as the window calls it is asked for in the language of questions.
        let verdict = Some(value).filter(|_| key == "verdict").and_then(|value| verdict_of(value, &named));
        let value = verdict.map_or_else(|| value.to_owned(), |status| status.key().to_owned());
        let added = asking(key, &value);
        let text = self.text(RecordsField::Question);
        let is_of = |word: &str| Filter::of(word, &named).is_some_and(|filter| filter.key == key);
        let others = words(text).into_iter().map(|(_, word)| word).filter(|word| !is_of(word));
        let mut asked: Vec<&str> = others.chain([added.as_str()]).collect();
        // As the word of a verdict alone: what is void has none that counts.
        if key == "verdict" && !asked.contains(&STANDING) {
            asked.push(STANDING);
        }
        let text = asked.join(" ");
        self.texts.insert(RecordsField::Question, text);
        self.texts.remove(&RecordsField::Filter);
        self.ask(shared, false);
    }

    /// Puts a word into the question, or takes it out, and asks it.
    pub(super) fn toggle(&mut self, shorthand: Shorthand, shared: &Shared) {
        let text = self.text(RecordsField::Question);
        let others = words(text).into_iter().map(|(_, word)| word).filter(|word| !shorthand.words().contains(word));
        let added = if self.has(shorthand) { &[] } else { shorthand.words() };
        let text = others.chain(added.iter().copied()).collect::<Vec<_>>().join(" ");
        self.texts.insert(RecordsField::Question, text);
        self.ask(shared, false);
    }

    /// Asks the question. `rests` waits until nobody types.
    pub(super) fn ask(&mut self, shared: &Shared, rests: bool) {
        self.errors.remove(&RecordsField::Question);
        self.culprit = None;
        // What is read for a report is another list.
        self.gathering = None;
        let of_window = shared.words();
        let named = named(&of_window);
        let asked = words(self.text(RecordsField::Question));
        self.filters = asked.iter().filter_map(|(_, word)| Filter::of(word, &named)).collect();
        if !shared.recording.is_on() {
            return;
        }
        match question(self.text(RecordsField::Question), shared) {
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
