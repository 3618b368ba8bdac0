//! Which entries a query finds: every word of it stands in one name of the entry. What begins with the query comes first, then names of
//! which a word begins with it, then the rest; then headings of the manual of which words begin with it; what cannot be done now comes
//! last.

use super::entry::PaletteEntry;

/// How many headings of the manual are found at most: the search of the help page finds all.
const MOST_HEADINGS: usize = 8;

/// How well a name fits; the smaller, the better.
fn rank(query: &str, words: &[&str], name: &str) -> Option<u8> {
    if !words.iter().all(|word| name.contains(word)) {
        return None;
    }
    let begins = |word: &&str| name.split(|c: char| !c.is_alphanumeric()).any(|part| part.starts_with(*word));
    Some(match () {
        () if name.starts_with(query) => 0,
        () if words.iter().all(begins) => 1,
        () => WITHIN,
    })
}

/// The rank of a name that has a word of the query somewhere within one of its own.
const WITHIN: u8 = 2;

/// The entries that a query finds, group by group; all of them for an empty one.
pub(super) fn found(query: &str, all: &[PaletteEntry]) -> Vec<PaletteEntry> {
    let query = query.trim().to_lowercase();
    let words: Vec<&str> = query.split_whitespace().collect();
    let rank_of = |entry: &PaletteEntry| entry.names.iter().filter_map(|name| rank(&query, &words, name)).min();
    let mut found: Vec<_> = all
        .iter()
        .filter(|entry| !query.is_empty() || !entry.is_heading())
        .filter_map(|entry| Some((rank_of(entry)?, entry)))
        .filter(|(rank, entry)| *rank < WITHIN || !entry.is_heading())
        .collect();
    // The order of the list decides between equals.
    // Enter never removes anything because its name was the best match.
    found.sort_by_key(|(rank, entry)| (!entry.is_possible, entry.removes(), entry.is_heading(), *rank));
    let mut headings = 0;
    found.retain(|(_, entry)| {
        headings += usize::from(entry.is_heading());
        !entry.is_heading() || headings <= MOST_HEADINGS
    });
    let best = |group| found.iter().position(|(_, entry)| entry.group == group).unwrap_or(usize::MAX);
    let mut ordered: Vec<_> = found.iter().map(|(_, entry)| *entry).collect();
    // The group of the best match comes first.
    ordered.sort_by_key(|entry| best(entry.group));
    ordered.into_iter().cloned().collect()
}
