//! What a filter means: classes, letters and grades choose columns, a size marks its row, and differences alone choose both.

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::{DeviationTable, ToleranceClass};

use super::Document;

/// The columns and rows that are shown, and the rows that are marked.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Filter {
    /// The numbers of the columns that are shown, ascending.
    pub columns: Vec<usize>,
    /// The numbers of the size ranges that are shown, ascending.
    pub ranges: Vec<usize>,
    /// The numbers of the size ranges that are marked.
    pub rows: Vec<usize>,
    /// The words that match no column or row.
    pub unmatched: Vec<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Word<'a> {
    /// Letters and a grade, `H7`, or the name of an own column with digits in it, `U1Z1`.
    Class(&'a str),
    /// Letters alone, `h`, or the name of an own column, `PF`.
    Letters(&'a str),
    /// A grade alone, `7`.
    Grade(&'a str),
    /// A size in millimetres.
    Size(Length),
    Unknown,
}

impl Filter {
    /// Reads a filter. Blanks, and commas that no digit follows, separate words; an empty text shows every column.
    ///
    /// Case counts where it tells columns apart; otherwise `h7` finds `H7`, too. A whole number that is a grade of the
    /// table is the grade; `7 mm` and `7.0` are sizes.
    pub fn of(text: &str, table: &DeviationTable) -> Self {
        let mut filter = Self { ranges: (0..table.ends().len()).collect(), ..Self::default() };
        let mut chooses = false;
        let mut shown = vec![false; table.columns().len()];
        let text = text.replace(" mm", "mm");
        for given in
            text.split([' ', ';', '/', '\t']).map(|word| word.trim_matches(',')).filter(|word| !word.is_empty())
        {
            let word = Word::of(given, table);
            let found = match word {
                Word::Size(size) => filter.mark(size, table),
                Word::Unknown => false,
                word => {
                    chooses = true;
                    choose(word, table, &mut shown)
                }
            };
            if !found {
                filter.unmatched.push(given.to_owned());
            }
        }
        let chosen = shown.iter().enumerate().filter(|(_, shown)| **shown || !chooses);
        filter.columns = chosen.map(|(column, _)| column).collect();
        filter
    }

    /// What of it differs from ISO 286: the columns and size ranges with such a cell.
    pub(super) fn differing(mut self, document: &Document) -> Self {
        self.columns.retain(|column| 0 < document.differing_in(*column));
        let cells = document.differing_cells().filter(|(column, _)| self.columns.binary_search(column).is_ok());
        self.ranges = cells.map(|(_, range)| range).collect();
        self.ranges.sort_unstable();
        self.ranges.dedup();
        self
    }

    fn mark(&mut self, size: Length, table: &DeviationTable) -> bool {
        let row = table.ends().partition_point(|&end| end < size);
        let is_there = Length::ZERO < size && row < table.ends().len();
        if is_there && !self.rows.contains(&row) {
            self.rows.push(row);
        }
        is_there
    }
}

impl<'a> Word<'a> {
    fn of(given: &'a str, table: &DeviationTable) -> Self {
        let bare = given.trim_start_matches(['Ø', 'ø', '⌀']);
        let letters = bare.trim_end_matches(|c: char| c.is_ascii_digit());
        let is_letters = bare.starts_with(|c: char| c.is_ascii_alphabetic())
            && bare.bytes().all(|byte| byte.is_ascii_alphanumeric());
        let is_whole = !bare.is_empty() && letters.is_empty();
        let is_grade = || table.columns().iter().any(|column| grade_of(column.class.as_str()) == bare);
        match bare.parse() {
            _ if is_letters && letters.len() == bare.len() => Self::Letters(bare),
            _ if is_letters => Self::Class(bare),
            _ if is_whole && bare.len() == given.len() && is_grade() => Self::Grade(bare),
            Ok(size) => Self::Size(size),
            Err(_no_size) => Self::Unknown,
        }
    }

    fn matches(self, class: ToleranceClass, same: fn(&str, &str) -> bool) -> bool {
        match self {
            Self::Class(wanted) => same(class.as_str(), wanted),
            Self::Letters(wanted) => same(class.letters(), wanted),
            Self::Grade(wanted) => grade_of(class.as_str()) == wanted,
            Self::Size(_) | Self::Unknown => false,
        }
    }
}

/// The grade of a class's text.
fn grade_of(class: &str) -> &str {
    class.trim_start_matches(|c: char| c.is_ascii_alphabetic())
}

/// Shows the columns that a word matches; case counts unless no column matches exactly.
fn choose(word: Word<'_>, table: &DeviationTable, shown: &mut [bool]) -> bool {
    let ways: [fn(&str, &str) -> bool; 2] = [|one, other| one == other, str::eq_ignore_ascii_case];
    ways.into_iter().any(|same| {
        let mut found = false;
        for (column, shown) in table.columns().iter().zip(shown.iter_mut()) {
            let matches = word.matches(column.class, same);
            *shown |= matches;
            found |= matches;
        }
        found
    })
}
