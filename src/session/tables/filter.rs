//! What a filter's text means: classes, letters and grades choose columns, a size marks its row.

use crate::length::Length;
use crate::tolerance::{DeviationTable, ToleranceClass};

/// The columns that are shown and the rows that are marked.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Filter {
    columns: Vec<usize>,
    rows: Vec<usize>,
    unmatched: Vec<String>,
}

/// A word of the filter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Word<'a> {
    /// Letters and a grade, `H7`.
    Class(&'a str),
    /// Letters alone, `h`.
    Letters(&'a str),
    /// A grade alone, `7`.
    Grade(&'a str),
    /// A size in millimetres.
    Size(Length),
    Unknown,
}

impl Filter {
    /// Reads a filter. Words are apart by blanks or commas that no digit follows; an empty text shows every column.
    ///
    /// Case counts where it tells columns apart; otherwise `h7` finds `H7`, too. A whole number that is a grade of the
    /// table is the grade; `7 mm` and `7.0` are sizes.
    pub fn of(text: &str, table: &DeviationTable) -> Self {
        let mut filter = Self::default();
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

    /// The numbers of the columns that are shown, ascending.
    pub fn columns(&self) -> &[usize] {
        &self.columns
    }

    /// The numbers of the rows that are marked.
    pub fn rows(&self) -> &[usize] {
        &self.rows
    }

    /// The words that no column or row answers to.
    pub fn unmatched(&self) -> &[String] {
        &self.unmatched
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
        let is_letters = !letters.is_empty() && letters.bytes().all(|byte| byte.is_ascii_alphabetic());
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

/// Shows the columns of a word; the other case only where none has this one.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::table::Column;

    fn table(classes: &str) -> DeviationTable {
        let column = |class: &str| Column { class: class.parse().unwrap(), cells: vec![None; 4] };
        let ends = [3, 6, 18, 30].map(|mm| Length::from_micrometres(mm * 1000)).to_vec();
        DeviationTable::new("own.tab", false, ends, classes.split(' ').map(column).collect()).unwrap()
    }

    /// The classes that are shown, the ends of the marked rows, and what is not there.
    #[track_caller]
    fn check(classes: &str, text: &str, expected: &str) {
        let table = table(classes);
        let filter = Filter::of(text, &table);
        let shown: Vec<_> = filter.columns().iter().map(|&column| table.columns()[column].class.to_string()).collect();
        let rows: Vec<_> = filter.rows().iter().map(|&row| table.ends()[row].to_string()).collect();
        let said = format!("{} | {} | {}", shown.join(" "), rows.join(" "), filter.unmatched().join(" "));
        assert_eq!(said, expected, "for {text:?}");
    }

    #[test]
    fn classes_letters_and_grades_choose_columns() {
        let holes = "H6 H7 JS7 J7 H25";
        check(holes, "", "H6 H7 JS7 J7 H25 |  | ");
        check(holes, "H7", "H7 |  | ");
        check(holes, "H7 js7", "H7 JS7 |  | ");
        check(holes, "h", "H6 H7 H25 |  | ");
        check(holes, "7", "H7 JS7 J7 |  | ");
        check(holes, "j", "J7 |  | ");
        check(holes, "H7, J7;h6", "H6 H7 J7 |  | ");
        check(holes, "g6", " |  | g6");
        check(holes, "H7/g6", "H7 |  | g6");
    }

    #[test]
    fn case_counts_where_it_tells_columns_apart() {
        check("H7 h7 g6", "h7", "h7 |  | ");
        check("H7 h7 g6", "H", "H7 |  | ");
        check("H7 h7 g6", "G6", "g6 |  | ");
    }

    #[test]
    fn a_size_marks_its_row_and_belongs_to_the_range_that_it_ends() {
        let holes = "H6 H7";
        check(holes, "25", "H6 H7 | 30 | ");
        check(holes, "18", "H6 H7 | 18 | ");
        check(holes, "18.000001", "H6 H7 | 30 | ");
        check(holes, "2,5", "H6 H7 | 3 | ");
        check(holes, "7 mm", "H6 H7 | 18 | ");
        check(holes, "7.0", "H6 H7 | 18 | ");
        check(holes, "Ø7", "H6 H7 | 18 | ");
        check(holes, "25 H7", "H7 | 30 | ");
        check(holes, "31", "H6 H7 |  | 31");
        check(holes, "0", "H6 H7 |  | 0");
        check(holes, "-5 ?", "H6 H7 |  | -5 ?");
    }
}
