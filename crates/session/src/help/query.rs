//! The words that are searched for, and where they stand in a text. A word is found where a word begins; case and a plural do not count.

use std::ops::Range;

/// The words of a query, in small letters and without the `s` of a plural.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct HelpWords(Vec<String>);

impl HelpWords {
    pub(super) fn of(query: &str) -> Self {
        Self(query.split_whitespace().map(singular).filter(|word| !word.is_empty()).collect())
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Those that a text of small letters has. One that it has in two words counts as these: `setup` as `set` and `up`.
    pub(super) fn known_in(&self, text: &str) -> Self {
        let known = |word: &String| match places(text, word).next() {
            Some(_) => vec![word.clone()],
            None => parts_in(text, word),
        };
        Self(self.0.iter().flat_map(known).collect())
    }

    /// Whether a text says this and nothing else.
    pub(super) fn are(&self, text: &str) -> bool {
        let text = Self::of(text);
        let words = match text.0.as_slice() {
            [first, rest @ ..] if matches!(first.as_str(), "the" | "a" | "an") => rest,
            all => all,
        };
        !self.is_empty() && self.0 == words
    }

    /// Whether each of them stands in a text.
    pub(super) fn are_all_in(&self, text: &str) -> bool {
        self.count_in(text) == self.0.len()
    }

    /// How many of them stand in a text.
    pub(super) fn count_in(&self, text: &str) -> usize {
        let small = text.to_ascii_lowercase();
        self.0.iter().filter(|word| places(&small, word).next().is_some()).count()
    }

    /// Whether they stand next to each other in a text, in their order.
    pub(super) fn are_together_in(&self, text: &str) -> bool {
        let found = Self::of(text).0;
        found
            .windows(self.0.len().max(1))
            .any(|some| some.iter().zip(&self.0).all(|(found, word)| found.starts_with(word)))
    }

    /// Where they stand in a text, in its order: whole words where only a plural is longer.
    pub fn places_in(&self, text: &str) -> Vec<Range<usize>> {
        let small = text.to_ascii_lowercase();
        let mut all: Vec<Range<usize>> = self.0.iter().flat_map(|word| places(&small, word)).collect();
        all.sort_by_key(|place| (place.start, place.end));
        let mut apart: Vec<Range<usize>> = Vec::new();
        for place in all {
            match apart.last_mut() {
                Some(last) if place.start < last.end => last.end = last.end.max(place.end),
                _ => apart.push(place),
            }
        }
        apart
    }
}

/// The two words that a text has in the place of one, next to each other; none where it has no such words.
fn parts_in(text: &str, word: &str) -> Vec<String> {
    let halves = word.char_indices().skip(2).filter_map(|(at, _)| word.split_at_checked(at));
    let halves = halves.map(|(first, second)| (first.trim_end_matches('-'), second.trim_start_matches('-')));
    let mut long_ones = halves.filter(|(first, second)| 2 <= first.len() && 2 <= second.len());
    let is_there = |(first, second): &(&str, &str)| {
        ["-", " "].iter().any(|between| places(text, &format!("{first}{between}{second}")).next().is_some())
    };
    let found = long_ones.find(is_there);
    found.map_or_else(Vec::new, |(first, second)| vec![first.to_owned(), second.to_owned()])
}

/// A word without what stands around it and without the `s` of a plural.
fn singular(word: &str) -> String {
    let word = word.trim_matches(|c: char| c.is_ascii_punctuation() && !matches!(c, '+' | '-' | '%' | '±'));
    let word = word.to_ascii_lowercase();
    let is_plural = 3 < word.len() && word.ends_with('s') && !["ss", "us", "is"].iter().any(|end| word.ends_with(end));
    match word.strip_suffix("es") {
        // `inches` is more than one inch.
        Some(stem) if ["ch", "sh", "x"].iter().any(|end| stem.ends_with(end)) => stem.to_owned(),
        _ if is_plural => word.trim_end_matches('s').to_owned(),
        _ => word,
    }
}

/// Where a word begins in a text of small letters; the `s` of a plural belongs to it.
fn places<'a>(text: &'a str, word: &'a str) -> impl Iterator<Item = Range<usize>> + 'a {
    text.match_indices(word).filter_map(|(start, found)| {
        let (before, after) = text.split_at(start);
        let begins = match (before.chars().next_back(), found.chars().next()) {
            (Some(before), Some(first)) => {
                !before.is_alphanumeric() || before.is_numeric() && !first.is_numeric() || !first.is_alphanumeric()
            }
            _ => true,
        };
        let rest = after.strip_prefix(found).unwrap_or(after);
        let takes_es = ["ch", "sh", "x"].iter().any(|end| found.ends_with(end));
        let is_end = |end: &str| rest.strip_prefix(end).is_some_and(|rest| !rest.starts_with(char::is_alphanumeric));
        let plural = match (is_end("s"), takes_es && is_end("es")) {
            (true, _) => 1,
            (_, true) => 2,
            _ => 0,
        };
        let end = start + found.len() + plural;
        begins.then_some(start..end)
    })
}
