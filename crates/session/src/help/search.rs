//! Which topics a query finds: every word of it stands in the topic. What has the words in its title comes first, then in a heading, then
//! in the text of one section, then anywhere; among equals the one that has them more often.

use std::cmp::Reverse;

use fitcheck_core::words::{Language, Words};

use super::manual::ManualPage;
use super::{HelpPlace, HelpTopic, topics};

/// A topic that was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HelpFound {
    /// Where what was searched for stands.
    pub place: HelpPlace,
    /// The heading there, as the manual has it; `None` at the beginning of a topic.
    pub heading: Option<String>,
}

impl HelpFound {
    const fn topic(topic: HelpTopic) -> Self {
        Self { place: HelpPlace::of(topic), heading: None }
    }
}

/// How well a topic fits, the best first: where the words are, and how often.
type Fit = (u8, Reverse<usize>);

/// What a query finds; every topic for an empty one.
pub(super) fn search(query: &str) -> Vec<HelpFound> {
    let query = query.trim().to_lowercase();
    let words: Vec<&str> = query.split_whitespace().collect();
    if words.is_empty() {
        return topics().map(HelpFound::topic).collect();
    }
    let find = |topic| match topic {
        HelpTopic::Keys => keys(&words),
        HelpTopic::Manual(file) => in_page(ManualPage::of(file)?, &query, &words),
    };
    let mut found: Vec<(Fit, HelpFound)> = topics().filter_map(find).collect();
    // The order of the topics decides between equals.
    found.sort_by_key(|(fit, _)| *fit);
    found.into_iter().map(|(_, found)| found).collect()
}

/// The sheet of keys is found by its title in any language.
fn keys(words: &[&str]) -> Option<(Fit, HelpFound)> {
    let title = |language| HelpTopic::Keys.title(&Words::new(language)).to_lowercase();
    let is_found = Language::all().map(title).any(|title| has_all(&title, words));
    is_found.then(|| ((0, Reverse(usize::MAX)), HelpFound::topic(HelpTopic::Keys)))
}

fn has_all(text: &str, words: &[&str]) -> bool {
    words.iter().all(|word| text.contains(word))
}

fn in_page(page: &ManualPage, query: &str, words: &[&str]) -> Option<(Fit, HelpFound)> {
    let topic = HelpTopic::Manual(page.file);
    let title = page.title.to_lowercase();
    let texts = page.sections.iter().map(|section| section.small_text.as_str());
    let times: usize = texts.map(|text| words.iter().map(|word| text.matches(word).count()).sum::<usize>()).sum();
    let fit = |rank: u8| (rank, Reverse(times));
    if has_all(&title, words) {
        return Some((fit(u8::from(!title.starts_with(query))), HelpFound::topic(topic)));
    }
    let is_whole = |word: &&str| page.sections.iter().any(|section| section.small_text.contains(*word));
    let (rank, section) =
        if let Some(section) = page.sections.iter().find(|section| has_all(&section.small_heading, words)) {
            (2, section)
        } else if let Some(section) = page.sections.iter().find(|section| has_all(&section.small_text, words)) {
            (3, section)
        } else if words.iter().all(is_whole) {
            return Some((fit(4), HelpFound::topic(topic)));
        } else {
            return None;
        };
    // The first heading is the title.
    let is_first = page.sections.first().is_some_and(|first| first.anchor == section.anchor);
    let heading = (!is_first).then(|| section.heading.clone());
    let anchor = (!is_first).then(|| section.anchor.clone());
    Some((fit(rank), HelpFound { place: HelpPlace { topic, anchor }, heading }))
}
