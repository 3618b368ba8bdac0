//! What a query finds in the manual: one hit for each heading below which every word of it stands, with the line where it stands. A
//! heading that is the word comes first, then a definition of it, titles and other headings, then texts; what only lists pages comes last.
//! Where no place has every word, those that the manual does not know are left out, and `setup` finds `set-up`.

use std::cmp::Reverse;
use std::sync::LazyLock;

use fitcheck_core::words::{Language, Words};

use super::manual::{Line, ManualPage, Section, manual};
use super::query::HelpWords;
use super::{CONTENTS, HelpMark, HelpPlace, HelpTopic, topics};

/// The page that explains words: of equal hits it has the first.
pub(crate) const TERMS: &str = "terms.md";

/// Pages with a little about much: of equal hits they have the last.
const LAST: [&str; 2] = ["fields.md", "licences.md"];

/// How many hits are listed.
const MOST: usize = 80;

/// How much of a line stands before its first word that is searched for, and how long a line is at most; characters.
const BEFORE: usize = 40;
const LONGEST: usize = 240;

/// A place that was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HelpFound {
    /// Where what was searched for stands.
    pub place: HelpPlace,
    /// The heading there, as the manual has it; `None` at the beginning of a topic.
    pub heading: Option<String>,
    /// The line that it was found in; empty for a topic as a whole.
    pub line: Vec<LinePart>,
}

/// A part of a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LinePart {
    pub text: String,
    /// Whether it was searched for.
    pub is_found: bool,
}

impl HelpFound {
    const fn topic(topic: HelpTopic) -> Self {
        Self { place: HelpPlace::of(topic), heading: None, line: Vec::new() }
    }
}

/// How well a place fits, the best first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Fit {
    /// The heading says it and nothing else.
    Heading,
    /// A line begins with it and explains it.
    Definition,
    /// The title of the page has every word, at its beginning or anywhere.
    TitleBegins,
    Title,
    /// The heading has every word.
    InHeading,
    /// The words stand together in a line.
    Together,
    /// A line has every word.
    Line,
    /// The section has every word.
    Section,
    /// Only the page has every word.
    Page,
}

/// What hits are sorted by: what only lists pages is last, then the fit, the page, and how often.
type Rank = (bool, Fit, u8, Reverse<usize>);

/// What a query finds; every topic for an empty one.
pub(super) fn search(query: &str) -> Vec<HelpFound> {
    let words = HelpWords::of(query);
    if words.is_empty() {
        return topics().map(HelpFound::topic).collect();
    }
    let mut found = all_of(&words);
    if found.is_empty() {
        found = all_of(&words.known_in(manual_text()));
    }
    // The order of the topics decides between equals.
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().map(|(_, found)| found).take(MOST).collect()
}

/// Whether a line or a heading of the manual has every word of a query.
pub(crate) fn is_in_a_line(query: &str) -> bool {
    all_of(&HelpWords::of(query)).iter().any(|((_, fit, ..), _)| *fit <= Fit::Line)
}

/// The places that have every one of some words, in the order of the topics; none for no words.
fn all_of(words: &HelpWords) -> Vec<(Rank, HelpFound)> {
    if words.is_empty() {
        return Vec::new();
    }
    let find = |topic| match topic {
        HelpTopic::Keys => keys(words),
        HelpTopic::Manual(file) => ManualPage::of(file).map(|page| in_page(page, words)).unwrap_or_default(),
    };
    topics().flat_map(find).collect()
}

/// Every heading and every line of the manual, in small letters.
fn manual_text() -> &'static str {
    static TEXT: LazyLock<String> = LazyLock::new(|| {
        let sections = manual().iter().flat_map(|page| &page.sections);
        let texts = sections
            .flat_map(|section| [&section.heading].into_iter().chain(section.lines.iter().map(|line| &line.text)));
        texts.flat_map(|text| [text.as_str(), "\n"]).collect::<String>().to_ascii_lowercase()
    });
    &TEXT
}

/// The sheet of keys is found by its title in any language.
fn keys(words: &HelpWords) -> Vec<(Rank, HelpFound)> {
    let title = |language| HelpTopic::Keys.title(&Words::new(language));
    let is_found = Language::all().map(title).any(|title| words.are_all_in(&title));
    let found = HelpFound::topic(HelpTopic::Keys);
    is_found.then_some(((false, Fit::TitleBegins, 0, Reverse(usize::MAX)), found)).into_iter().collect()
}

fn in_page(page: &ManualPage, words: &HelpWords) -> Vec<(Rank, HelpFound)> {
    let hits: Vec<_> =
        page.sections.iter().enumerate().filter_map(|(at, section)| in_section(page, (at, section), words)).collect();
    if !hits.is_empty() {
        return hits;
    }
    // Its words stand in several sections.
    let all: Vec<&Line> = page.sections.iter().flat_map(|section| &section.lines).collect();
    let whole: String = all.iter().flat_map(|line| [line.text.as_str(), "\n"]).collect();
    if !words.are_all_in(&whole) {
        return Vec::new();
    }
    let with_line = page.sections.iter().filter_map(|section| Some((section, best(&section.lines, words)?)));
    let best = with_line.max_by_key(|(_, line)| words.count_in(&line.text));
    let hit = best.map(|(section, line)| hit(page, section, (Fit::Page, line), words));
    hit.into_iter().collect()
}

/// The hit of a section, where it has every word.
fn in_section(page: &ManualPage, (at, section): (usize, &Section), words: &HelpWords) -> Option<(Rank, HelpFound)> {
    let first = section.lines.first();
    let of_heading = if words.are(&section.heading) {
        // A page with a little about much says less than the page that it leads to.
        Some(if LAST.contains(&page.file) { Fit::InHeading } else { Fit::Heading })
    } else if !words.are_all_in(&section.heading) {
        None
    } else if 0 < at {
        Some(Fit::InHeading)
    } else if words.places_in(&section.heading).first().is_some_and(|place| place.start == 0) {
        Some(Fit::TitleBegins)
    } else {
        Some(Fit::Title)
    };
    let of_lines = section.lines.iter().filter_map(|line| Some((fit_of(line, words)?, line)));
    // The first of equal lines.
    let of_lines = of_lines.min_by_key(|(fit, _)| *fit);
    let found = match (of_heading, of_lines) {
        (Some(fit), Some((of_line, line))) if of_line < fit => (of_line, line),
        // What a heading promises stands in the first line below it.
        (Some(fit), of_line) => (fit, first.or(of_line.map(|(_, line)| line))?),
        (None, Some(found)) => found,
        (None, None) => {
            let whole: String = section.lines.iter().flat_map(|line| [line.text.as_str(), "\n"]).collect();
            let whole = format!("{}\n{whole}", section.heading);
            words.are_all_in(&whole).then(|| best(&section.lines, words))?.map(|line| (Fit::Section, line))?
        }
    };
    Some(hit(page, section, found, words))
}

fn fit_of(line: &Line, words: &HelpWords) -> Option<Fit> {
    if !line.is_contents && line.term.as_ref().is_some_and(|term| words.are(term)) {
        Some(Fit::Definition)
    } else if words.are_together_in(&line.text) {
        Some(Fit::Together)
    } else {
        words.are_all_in(&line.text).then_some(Fit::Line)
    }
}

/// The line with the most of the words.
fn best<'a>(lines: &'a [Line], words: &HelpWords) -> Option<&'a Line> {
    let most = lines.iter().map(|line| words.count_in(&line.text)).max()?;
    lines.iter().find(|line| words.count_in(&line.text) == most)
}

fn hit(page: &ManualPage, section: &Section, (fit, line): (Fit, &Line), words: &HelpWords) -> (Rank, HelpFound) {
    let topic = HelpTopic::Manual(page.file);
    // The first heading is the title.
    let is_first = page.sections.first().is_some_and(|first| first.anchor == section.anchor);
    let heading = (!is_first).then(|| section.heading.clone());
    let anchor = (!is_first).then(|| section.anchor.clone());
    let mark = HelpMark { block: line.block, row: line.row, words: words.clone() };
    // A title that is found begins at the top.
    let is_title = is_first && matches!(fit, Fit::Heading | Fit::TitleBegins | Fit::Title);
    let place = HelpPlace { topic, anchor, mark: (!is_title).then_some(mark) };
    let weight = match page.file {
        TERMS => 0,
        file if LAST.contains(&file) => 2,
        _ => 1,
    };
    let times = words.places_in(&line.text).len();
    let is_contents = page.file == CONTENTS || line.is_contents && Fit::InHeading < fit;
    let rank = (is_contents, fit, weight, Reverse(times));
    // Below a heading that is found, the line is read from its beginning.
    let is_headed = matches!(fit, Fit::Heading | Fit::TitleBegins | Fit::Title | Fit::InHeading);
    (rank, HelpFound { place, heading, line: parts(&line.text, words, is_headed) })
}

/// A line in parts, from its beginning or from a little before the first word that is searched for.
fn parts(text: &str, words: &HelpWords, is_whole: bool) -> Vec<LinePart> {
    let places = words.places_in(text);
    let first = places.first().map_or(0, |place| place.start);
    let start = if is_whole { 0 } else { beginning(text, first) };
    let mut parts = Vec::new();
    if 0 < start {
        parts.push(LinePart { text: "…".to_owned(), is_found: false });
    }
    let end = text.char_indices().map(|(at, _)| at).filter(|at| start <= *at).nth(LONGEST);
    let end = end.unwrap_or(text.len());
    let mut from = start;
    let mut push = |range: std::ops::Range<usize>, is_found| {
        if let Some(text) = text.get(range).filter(|text| !text.is_empty()) {
            parts.push(LinePart { text: text.to_owned(), is_found });
        }
    };
    for place in places.into_iter().filter(|place| place.end <= end) {
        push(from..place.start, false);
        from = place.end;
        push(place, true);
    }
    push(from..end, false);
    if end < text.len() {
        parts.push(LinePart { text: "…".to_owned(), is_found: false });
    }
    parts
}

/// Where a line begins whose first word stands there: at its own beginning, or at a word a little before.
fn beginning(text: &str, first: usize) -> usize {
    let before = text.get(..first).unwrap_or_default();
    if before.chars().count() <= BEFORE {
        return 0;
    }
    let near = before.char_indices().rev().nth(BEFORE - 1).map_or(0, |(at, _)| at);
    let rest = before.get(near..).unwrap_or_default();
    rest.find(' ').map_or(first, |space| near + space + 1)
}
