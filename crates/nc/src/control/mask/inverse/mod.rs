//! A mask read backwards: from what it printed to the values that it printed.
//!
//! The literal texts of a mask and its formats tell where a value begins and ends: blanks match any run of blanks, a number has the
//! digits of its format and a point or a comma, a text reaches to the next literal text. A mask whose values cannot be told apart is
//! refused; a print that can be read in two ways is told by [`PrintMatch::Ambiguous`].

mod search;

use super::{Format, FormatLetter, Keyword, Line, Mask, Name, Part, Record};
use crate::control::variables::{Family, Parameter};
use fitcheck_core::message::{FilePlace, Located, Say};
use search::Search;

/// The most lines that a mask prints at a time to be read back.
const MOST_LINES: usize = 200;

/// Why a mask cannot be read backwards, with line and column.
pub type InverseError = Located<InverseFault>;

/// Why a mask cannot be read backwards.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "mask-inverse", error)]
pub enum InverseFault {
    /// Two fields with nothing between them.
    Touching {
        first: String,
        /// The second one.
        second: String,
    },
    /// Two texts with nothing but blanks between them: a text may have blanks, too.
    Blanks {
        first: String,
        /// The second one.
        second: String,
    },
    /// No literal text tells where a print begins.
    NoMark,
    /// More lines than are read back.
    TooLong {
        /// What is allowed.
        most: usize,
    },
    /// It prints no number.
    NoNumber,
}

/// What a field of a mask prints.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FieldContent {
    Parameter(Parameter),
    /// A part of date and time, and the path of the program, by their words: `DAY`, `CALL_PATH`.
    Word(&'static str),
}

impl std::fmt::Display for FieldContent {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Parameter(parameter) => parameter.fmt(f),
            Self::Word(word) => f.write_str(word),
        }
    }
}

/// A field of a mask, in the mask's order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Slot {
    /// What it prints.
    pub of: FieldContent,
    /// How many digits a number has after its decimal sign; `None` for a text.
    pub digits: Option<usize>,
    /// The literal text before it on its line, down to the field before; without blanks around it.
    pub label: String,
    /// The line of the mask that prints it, from 1.
    pub line: usize,
}

/// What was printed at one time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Printed {
    /// How many lines it has.
    pub lines: usize,
    /// The values with the numbers of their fields, from 0: texts without blanks around them, numbers as they were printed.
    pub values: Vec<(usize, String)>,
}

/// What stands at a place of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PrintMatch {
    /// A whole print.
    Printed(Printed),
    /// One that can be read in more than one way, and how many lines it has at least.
    Ambiguous(usize),
    /// The beginning of one: so many lines, and then another one than that of this line of the mask.
    Broken(usize, usize),
    /// Nothing of the mask.
    Nothing,
}

/// A mask that is read backwards.
#[derive(Debug, Clone)]
pub struct Inverse {
    slots: Vec<Slot>,
    /// What is printed in one language, for each that makes a difference.
    prints: Vec<Vec<Step>>,
}

/// A record of a mask.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Step {
    /// The line of the mask, from 1.
    line: usize,
    /// Whether it is left out where a text parameter is empty.
    hides: bool,
    lines: Vec<Vec<Piece>>,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum Piece {
    Literal(String),
    Slot { number: usize, format: Format, is_text_parameter: bool },
}

type Values = Vec<(usize, String)>;

impl Mask {
    /// The mask as a reader of what it prints.
    ///
    /// ```
    /// use fitcheck_nc::control::mask::{PrintMatch, Mask};
    ///
    /// let (mask, _) = Mask::read(b"\"MIN:%9.4LF MAX:%9.4LF\", Q33, Q23;")?;
    /// let inverse = mask.inverse()?;
    /// let PrintMatch::Printed(printed) = inverse.at(&["MIN:  25.0000 MAX:  25.0210"]) else { panic!() };
    /// assert_eq!(printed.values, [(0, "25.0000".to_owned()), (1, "25.0210".to_owned())]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InverseError`] where its values cannot be told apart.
    pub fn inverse(&self) -> Result<Inverse, InverseError> {
        let mut slots = Vec::new();
        let mut steps: Vec<(Option<&str>, Step)> = Vec::new();
        let mut language = None;
        let mut hides = false;
        for line in &self.lines {
            match line {
                Line::Language(word) => language = word.as_deref(),
                Line::Keyword(Keyword::EmptyHide) => hides = true,
                Line::Keyword(Keyword::EmptyShow) => hides = false,
                Line::Keyword(Keyword::Close | Keyword::File(_)) => {}
                Line::Record(record) => steps.push((language, step(record, hides, &mut slots)?)),
            }
        }
        let mut languages: Vec<Option<&str>> = steps.iter().map(|(language, _)| *language).collect();
        languages.push(None);
        let mut prints: Vec<Vec<Step>> = Vec::new();
        for spoken in languages {
            let printed = steps.iter().filter(|(language, _)| language.is_none() || *language == spoken);
            let print: Vec<Step> = printed.map(|(_, step)| step.clone()).collect();
            if !print.is_empty() && !prints.contains(&print) {
                prints.push(print);
            }
        }
        let whole = |what| Located { what, place: FilePlace::default() };
        if slots.iter().all(|slot: &Slot| slot.digits.is_none() || matches!(slot.of, FieldContent::Word(_))) {
            return Err(whole(InverseFault::NoNumber));
        }
        for print in &prints {
            let lines: Vec<&Vec<Piece>> = print.iter().flat_map(|step| &step.lines).collect();
            if MOST_LINES < lines.len() {
                return Err(whole(InverseFault::TooLong { most: MOST_LINES }));
            }
            if 1 < lines.len() && !lines.iter().any(|line| line.iter().any(Piece::is_mark)) {
                return Err(whole(InverseFault::NoMark));
            }
        }
        Ok(Inverse { slots, prints })
    }
}

/// A record with its fields numbered.
fn step(record: &Record, hides: bool, slots: &mut Vec<Slot>) -> Result<Step, InverseError> {
    let mut lines = vec![Vec::new()];
    let mut before: Option<(&Format, &Name)> = None;
    // The text field before nothing but blanks.
    let mut text: Option<&Name> = None;
    let mut label = "";
    for part in &record.parts {
        match part {
            Part::Text(literal) => {
                if let Some((left, first)) = before
                    && left.decimals() == Some(0)
                    && literal.starts_with(|c: char| c.is_ascii_digit())
                {
                    let what = InverseFault::Touching { first: first.to_string(), second: literal.trim().to_owned() };
                    return Err(Located::in_line(record.line, what));
                }
                for (number, line) in literal.split('\n').enumerate() {
                    if 0 < number {
                        lines.push(Vec::new());
                    }
                    if let Some(last) = lines.last_mut().filter(|_| !line.is_empty()) {
                        last.push(Piece::Literal(line.to_owned()));
                    }
                }
                label = literal.rsplit('\n').next().unwrap_or(literal).trim();
                before = None;
                text = text.filter(|_| literal.chars().all(|c| c == ' '));
            }
            Part::Field { format, name, column } => {
                let at = |what| Located { what, place: FilePlace::in_line(record.line, *column) };
                let names = |first: &Name| (first.to_string(), name.to_string());
                if let Some((left, first)) = before
                    && !left.is_bounded()
                {
                    let (first, second) = names(first);
                    return Err(at(InverseFault::Touching { first, second }));
                }
                if let Some(first) = text.filter(|_| format.is_text()) {
                    let (first, second) = names(first);
                    return Err(at(InverseFault::Blanks { first, second }));
                }
                before = Some((format, name));
                text = (format.is_text() && !format.is_bounded()).then_some(name);
                let is_text_parameter = matches!(name, Name::Parameter(parameter) if parameter.family == Family::Qs);
                if let Some(last) = lines.last_mut() {
                    last.push(Piece::Slot { number: slots.len(), format: *format, is_text_parameter });
                }
                let label = std::mem::take(&mut label).to_owned();
                slots.push(Slot { of: name.of(), digits: format.decimals(), label, line: record.line });
            }
        }
    }
    Ok(Step { line: record.line, hides, lines })
}

impl Name {
    fn of(self) -> FieldContent {
        match self {
            Self::Parameter(parameter) => FieldContent::Parameter(parameter),
            other => {
                FieldContent::Word(super::NAMES.iter().find(|(_, name)| *name == other).map_or("", |(word, _)| *word))
            }
        }
    }
}

impl Format {
    const fn is_text(&self) -> bool {
        matches!(self.kind, FormatLetter::Text | FormatLetter::Raw)
    }

    /// How many digits a number has after its sign.
    fn decimals(&self) -> Option<usize> {
        match self.kind {
            FormatLetter::Text | FormatLetter::Raw => None,
            FormatLetter::Decimal => Some(self.digits.unwrap_or(6)),
            FormatLetter::Whole => Some(0),
        }
    }

    /// Whether it ends by itself: after the last decimal, or in a column.
    fn is_bounded(&self) -> bool {
        match self.kind {
            FormatLetter::Text => self.columns().is_some(),
            FormatLetter::Raw => false,
            FormatLetter::Decimal | FormatLetter::Whole => self.decimals().is_some_and(|digits| 0 < digits),
        }
    }

    /// The width of a text that is neither narrower nor wider.
    fn columns(&self) -> Option<usize> {
        self.digits.filter(|digits| self.kind == FormatLetter::Text && 0 < *digits && *digits == self.width)
    }
}

impl Piece {
    /// Whether it shows where a print is.
    fn is_mark(&self) -> bool {
        matches!(self, Self::Literal(text) if text.contains(|c: char| c.is_alphanumeric()))
    }
}

impl Inverse {
    /// The fields of the mask.
    pub fn slots(&self) -> &[Slot] {
        &self.slots
    }

    /// The values of a print by what they are: of a parameter that is printed several times, at its first field, the one with the most
    /// decimals.
    #[must_use]
    pub fn by_parameter(&self, printed: Printed) -> Printed {
        let of = |at: usize| self.slots.get(at).map(|slot| slot.of);
        let first = |at: usize| self.slots.iter().position(|slot| Some(slot.of) == of(at)).unwrap_or(at);
        let decimals = |value: &str| value.rsplit_once(['.', ',']).map_or(0, |(_, decimals)| decimals.len());
        let mut values: Values = Vec::new();
        for (at, value) in printed.values {
            let at = first(at);
            match values.iter_mut().find(|(known, _)| *known == at) {
                Some((_, known)) if decimals(known) < decimals(&value) => *known = value,
                Some(_) => {}
                None => values.push((at, value)),
            }
        }
        Printed { values, ..printed }
    }

    /// The most lines of a print.
    pub fn most_lines(&self) -> usize {
        let lines = |print: &Vec<Step>| print.iter().map(|step| step.lines.len()).sum();
        self.prints.iter().map(lines).fold(0, usize::max)
    }

    /// What stands at the beginning of some lines: as many as a print has at most, or all that are left.
    pub fn at(&self, lines: &[&str]) -> PrintMatch {
        let mut ways: Vec<Printed> = Vec::new();
        let mut broken = (0, 0);
        for print in &self.prints {
            let search = Search::of(print, lines);
            if search.left == 0 {
                return PrintMatch::Ambiguous(1);
            }
            broken = broken.max(search.furthest);
            for way in search.ways {
                if ways.iter().all(|known| !self.is_same(known, &way)) {
                    ways.push(way);
                }
            }
        }
        match ways.as_slice() {
            [] if 0 < broken.0 => PrintMatch::Broken(broken.0, broken.1),
            [] => PrintMatch::Nothing,
            [_] => ways.pop().map_or(PrintMatch::Nothing, PrintMatch::Printed),
            _ => PrintMatch::Ambiguous(ways.iter().map(|way| way.lines).min().unwrap_or(1)),
        }
    }

    /// Whether two ways to read a print have the same values of the same parameters, as the sections of two languages may.
    fn is_same(&self, one: &Printed, other: &Printed) -> bool {
        let named = |printed: &Printed| -> Vec<(Option<FieldContent>, String)> {
            printed.values.iter().map(|(at, value)| (self.slots.get(*at).map(|slot| slot.of), value.clone())).collect()
        };
        one.lines == other.lines && named(one) == named(other)
    }
}
