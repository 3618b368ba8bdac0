//! The order of cells as people count: `A2` before `A10`, `9,5` before `10`, empty cells last.

use std::cmp::Ordering;

use fitcheck_core::length::Length;

/// Which of two cells comes first.
pub(super) fn order(one: &str, other: &str) -> Ordering {
    let one = one.trim();
    let other = other.trim();
    match (one.is_empty(), other.is_empty()) {
        (false, false) => {}
        (is_empty, other_is_empty) => return is_empty.cmp(&other_is_empty),
    }
    match (one.parse::<Length>(), other.parse::<Length>()) {
        (Ok(one), Ok(other)) => one.cmp(&other),
        (Ok(_), Err(_)) => Ordering::Less,
        (Err(_), Ok(_)) => Ordering::Greater,
        (Err(_), Err(_)) => {
            let folded = parts(&one.to_lowercase()).cmp(&parts(&other.to_lowercase()));
            folded.then_with(|| one.cmp(other))
        }
    }
}

/// A part of a text: figures, which count by their value, or other signs. Figures come first.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Part {
    /// Figures without zeros before them: the longer number is the larger one.
    Figures(usize, String),
    Signs(String),
}

fn parts(text: &str) -> Vec<Part> {
    let mut parts = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let is_figure = first.is_ascii_digit();
        let end = rest.find(|c: char| c.is_ascii_digit() != is_figure).unwrap_or(rest.len());
        let (part, after) = rest.split_at(end);
        let figures = part.trim_start_matches('0').to_owned();
        parts.push(if is_figure { Part::Figures(figures.len(), figures) } else { Part::Signs(part.to_owned()) });
        rest = after;
    }
    parts
}
