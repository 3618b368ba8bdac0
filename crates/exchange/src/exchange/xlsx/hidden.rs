//! What a spreadsheet program does not show of a sheet: rows and columns that were hidden or filtered out. They are read like the
//! others, and told.

use std::fmt::Write as _;

use super::sheet;
use crate::exchange::xml::Start;

/// The most runs that are named.
const MOST_NAMED: usize = 8;

/// What one sheet hides.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Hidden {
    /// Hidden rows that hold anything, from 1: first and last of each of the first runs.
    runs: Vec<(usize, usize)>,
    /// How many rows these are, and all behind them.
    rows: usize,
    /// Hidden columns, from 1: first and last.
    columns: Vec<(usize, usize)>,
    /// The row that the cells which follow are in, from 1.
    row: usize,
    /// Whether that is hidden and not yet counted.
    is_uncounted: bool,
}

impl Hidden {
    /// Takes note of an element of a sheet.
    pub(super) fn see(&mut self, start: &Start) {
        match start.name.as_str() {
            "row" => {
                self.row = start.attribute("r").parse().unwrap_or(self.row.saturating_add(1));
                self.is_uncounted = is_true(start.attribute("hidden"));
            }
            // A row of empty cells hides nothing.
            "v" | "is" if std::mem::take(&mut self.is_uncounted) => self.count(),
            "col" if is_true(start.attribute("hidden")) && self.columns.len() <= MOST_NAMED => {
                let number = |name: &str| start.attribute(name).parse::<usize>().ok();
                self.columns.extend(number("min").zip(number("max")));
            }
            _ => {}
        }
    }

    fn count(&mut self) {
        self.rows += 1;
        let is_full = MOST_NAMED < self.runs.len();
        match self.runs.last_mut() {
            Some((_, last)) if last.saturating_add(1) == self.row => *last = self.row,
            _ if is_full => {}
            _ => self.runs.push((self.row, self.row)),
        }
    }

    /// How many rows that hold anything are hidden, and which; `None` where none are.
    pub(super) fn rows(&self) -> Option<(usize, String)> {
        let name = |row: usize| row.to_string();
        (0 < self.rows).then(|| (self.rows, listed(&self.runs, name)))
    }

    /// The hidden columns by their letters; `None` where none are among the first `count`.
    pub(super) fn columns(&self, count: usize) -> Option<String> {
        let name = |column: usize| sheet::letters(column.saturating_sub(1));
        let within = self.columns.iter().filter(|(first, _)| *first <= count);
        let runs: Vec<_> = within.map(|&(first, last)| (first, last.min(count))).collect();
        (!runs.is_empty()).then(|| listed(&runs, name))
    }
}

fn is_true(value: &str) -> bool {
    matches!(value, "1" | "true" | "on")
}

/// `4, 7\u{2013}9`, and dots for more.
fn listed(runs: &[(usize, usize)], name: impl Fn(usize) -> String) -> String {
    let mut text = String::new();
    for (number, &(first, last)) in runs.iter().enumerate() {
        if 0 < number {
            text.push_str(", ");
        }
        if number == MOST_NAMED {
            text.push('\u{2026}');
            break;
        }
        text.push_str(&name(first));
        if first < last {
            // Writing to a text cannot fail.
            let _written = write!(text, "\u{2013}{}", name(last));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_listed_as_people_write_them() {
        let name = |row: usize| row.to_string();
        assert_eq!(listed(&[(4, 4), (7, 9)], name), "4, 7\u{2013}9");
        let many: Vec<_> = (1..20).map(|row| (row * 2, row * 2)).collect();
        assert_eq!(listed(&many, name), "2, 4, 6, 8, 10, 12, 14, 16, \u{2026}");
    }
}
