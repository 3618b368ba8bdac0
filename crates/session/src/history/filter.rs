//! What the words of a filter mean: besides values, dates and names, a verdict as it is called in the user's language.

use fitcheck_core::message::Say as _;
use fitcheck_core::probing::Origin;
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;
use fitcheck_exchange::journal::query::{FilterWord, Query, Records as _};

use super::History;

impl History {
    /// Lists the checks that have every word of a text.
    pub(crate) fn filter(&mut self, text: &str, words: &Words) {
        let wanted = filter_words(text, words);
        if wanted != self.records.query().words {
            self.ask(Query { words: wanted, ..self.records.query().clone() });
        }
    }
}

/// The words of a filter.
pub(crate) fn filter_words(text: &str, words: &Words) -> Vec<FilterWord> {
    let typed = words.say(&Origin::Typed.message());
    let simulated = words.get("simulated");
    let statuses = Status::ALL.map(|status| (status, words.told(&status)));
    let wanted = |word: &str| {
        let mut wanted = FilterWord::new(word);
        let named = statuses.iter().filter(|(_, name)| wanted.is_in(name));
        wanted.statuses = named.map(|(status, _)| *status).collect();
        wanted.simulated = wanted.is_in(&simulated);
        wanted.typed = wanted.is_in(&typed);
        wanted
    };
    text.split_whitespace().map(wanted).collect()
}
