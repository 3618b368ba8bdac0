//! Finds the columns of a CSV: by the words of its header (English, Dutch, German, Italian) or by content.
//!
//! A file that could be read in two ways is refused. `words` has the words.

use csv::StringRecord;

use super::delimited::{Item, Rows, SEPARATORS};
use super::error::{ImportErrorKind, Role};
use super::words::{self, Rank};
use crate::length::{Length, Unit};
use crate::tolerance::{Callout, ToleranceClass};

/// How many rows are examined to find out what a file is.
const SAMPLE: usize = 200;

/// How many bytes of them, 512 KiB: every cell takes memory, and two ways to split them are compared.
const SAMPLE_BYTES: usize = 512 << 10;

/// How many lines may come before a header.
const ABOVE_HEADER: usize = 20;

/// How many columns a message names at most.
const NAMED: usize = 8;

/// A column with lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct LengthColumn {
    pub(super) at: usize,
    pub(super) unit: Unit,
}

/// What the columns of a file are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Columns {
    pub(super) id: Option<usize>,
    pub(super) tolerance: Option<usize>,
    pub(super) nominal: Option<LengthColumn>,
    pub(super) measured: LengthColumn,
    /// A column with date and time, or one for each.
    pub(super) time: Vec<usize>,
    /// A column that says whether nobody measured.
    pub(super) simulated: Option<usize>,
    /// How many cells a row has.
    pub(super) count: usize,
    /// The line of the header; `None` where there is none.
    pub(super) header: Option<usize>,
    /// Whether the columns were found by their names.
    pub(super) names_known: bool,
    /// Names of the skipped columns: no more than are listed, and one.
    pub(super) ignored: Vec<String>,
    /// The decimal sign of the measured values, if any has one.
    pub(super) decimal_sign: Option<char>,
    /// Whether the cells after measured values with a decimal sign are whole numbers of their own.
    pub(super) whole_numbers_behind: bool,
}

/// The first rows of a text, split at one separator.
pub(super) struct Sample {
    pub(super) separator: u8,
    rows: Vec<(usize, StringRecord)>,
    header: Option<usize>,
    /// How many rows come before the measurements.
    above: usize,
}

impl Sample {
    /// The separator under which the first rows make the most sense.
    pub(super) fn of(text: &str, first_line: usize, separator: Option<u8>) -> Self {
        let tried: &[u8] = separator.as_ref().map_or(&SEPARATORS, std::slice::from_ref);
        let samples = tried.iter().map(|&separator| Self::split(text, first_line, separator));
        // The first of equals: the separators are in order of trust.
        let best = samples.reduce(|best, other| if best.sense() < other.sense() { other } else { best });
        best.unwrap_or(Self { separator: b';', rows: Vec::new(), header: None, above: 0 })
    }

    fn split(text: &str, first_line: usize, separator: u8) -> Self {
        let rows = Rows::new(text, first_line, separator).filter_map(|item| match item {
            Item::Row { line, cells } if !is_blank(&cells) && !is_comment(&cells) => Some((line, cells)),
            Item::Row { .. } | Item::OpenQuote { .. } | Item::TooLong { .. } => None,
        });
        let mut bytes = 0;
        let is_enough = |(_, cells): &(usize, StringRecord)| {
            let before = bytes;
            bytes += cells.as_slice().len() + cells.len();
            before < SAMPLE_BYTES
        };
        let rows: Vec<_> = rows.take(SAMPLE).take_while(is_enough).collect();
        let header = header(&rows);
        // Unknown names are not a measurement either.
        let unknown = rows.first().is_some_and(|(_, cells)| may_be_names(cells));
        let above = header.map_or(usize::from(unknown), |header| header + 1);
        Self { separator, rows, header, above }
    }

    /// How many columns the header names, how many rows hold a callout and a number, and how many rows have cells.
    fn sense(&self) -> (usize, usize, usize) {
        let named = self.header.and_then(|at| self.rows.get(at)).map_or(0, |(_, cells)| named(cells));
        let data = self.rows.iter().filter(|(_, cells)| is_data(cells)).count();
        let split = self.rows.iter().filter(|(_, cells)| 1 < cells.len()).count();
        (named, data, split)
    }

    /// What the columns are.
    ///
    /// # Errors
    /// A reason that concerns the whole file.
    pub(super) fn columns(&self) -> Result<Columns, ImportErrorKind> {
        if self.rows.is_empty() {
            return Err(ImportErrorKind::NoRows);
        }
        let mut columns = if let Some((line, cells)) = self.header.and_then(|at| self.rows.get(at)) {
            self.by_header(*line, cells)?
        } else {
            let mut columns = self.by_content()?;
            columns.header = self.above.checked_sub(1).and_then(|at| self.rows.get(at)).map(|(line, _)| *line);
            columns
        };
        columns.decimal_sign = self.decimal_sign(columns.measured.at);
        columns.whole_numbers_behind = self.whole_numbers_behind(columns.measured.at);
        Ok(columns)
    }

    /// The cells of a column below the header.
    fn cells(&self, at: usize) -> impl Iterator<Item = &str> {
        let data = self.rows.iter().skip(self.above);
        data.filter_map(move |(_, cells)| cells.get(at)).map(str::trim).filter(|cell| !cell.is_empty())
    }

    /// Whether more than half of a column's cells are of a kind.
    fn mostly(&self, at: usize, kind: fn(&str) -> bool) -> bool {
        let (are, all) = self.cells(at).fold((0, 0), |(are, all), cell| (are + usize::from(kind(cell)), all + 1));
        all < are * 2
    }

    fn by_header(&self, line: usize, header: &StringRecord) -> Result<Columns, ImportErrorKind> {
        let roles: Vec<_> = header.iter().map(words::role).collect();
        let best = |role: Role, ranks: &[Rank]| -> Result<Option<usize>, ImportErrorKind> {
            for rank in ranks {
                let found: Vec<usize> =
                    (0..).zip(&roles).filter(|(_, r)| **r == Some((role, *rank))).map(|(at, _)| at).collect();
                match found.as_slice() {
                    [] => {}
                    // Any of several names will do.
                    [at, ..] if found.len() == 1 || role == Role::Id => return Ok(Some(*at)),
                    _ => return Err(several(role, header, &found)),
                }
            }
            Ok(None)
        };
        let sure = [Rank::Exact, Rank::Contained];
        let measured = best(Role::Measured, &sure)?;
        // "diameter" is the measured value where no other column is; otherwise it may be the nominal size.
        let measured_at = match measured {
            Some(at) => at,
            None => best(Role::Measured, &[Rank::Weak])?.ok_or(ImportErrorKind::NoMeasuredColumn)?,
        };
        let tolerance = best(Role::Tolerance, &[Rank::Exact, Rank::Contained, Rank::Weak])?;
        let has_class = tolerance.is_some_and(|at| self.mostly(at, is_class));
        let mut nominal = best(Role::Nominal, &sure)?;
        if nominal.is_none() && has_class && measured.is_some() {
            nominal = best(Role::Measured, &[Rank::Weak])?;
        }
        let time: Vec<usize> =
            (0..).zip(&roles).filter(|(_, r)| matches!(r, Some((Role::Time, _)))).map(|(at, _)| at).take(2).collect();
        let id = best(Role::Id, &sure)?;
        let simulated = best(Role::Simulated, &sure)?;
        let column = |at: usize| -> Result<LengthColumn, ImportErrorKind> {
            let unit =
                words::unit(header.get(at).unwrap_or_default()).map_err(|unit| ImportErrorKind::Unit { unit })?;
            Ok(LengthColumn { at, unit: unit.unwrap_or(Unit::Millimetre) })
        };
        let used: Vec<usize> = [id, tolerance, nominal, simulated, Some(measured_at)]
            .into_iter()
            .flatten()
            .chain(time.iter().copied())
            .collect();
        let ignored = (0..).zip(header).filter(|(at, name)| !used.contains(at) && !name.trim().is_empty());
        Ok(Columns {
            id,
            tolerance,
            nominal: nominal.map(column).transpose()?,
            measured: column(measured_at)?,
            time,
            simulated,
            count: header.len(),
            header: Some(line),
            names_known: true,
            ignored: ignored.take(NAMED + 1).map(|(at, name)| name_of(at, name)).collect(),
            decimal_sign: None,
            whole_numbers_behind: false,
        })
    }

    /// Without a header: the column of callouts, or of classes with the nominal sizes before them, and the only column
    /// of numbers after it, or the only one at all. Names of own columns, such as PF, are words like any other, so they are
    /// told apart by the measured value only, and only in callouts.
    fn by_content(&self) -> Result<Columns, ImportErrorKind> {
        let width = self.rows.iter().map(|(_, cells)| cells.len()).max().unwrap_or_default();
        // The count that most rows have; a longer row is reported.
        let count = (1..=width)
            .max_by_key(|&n| self.rows.iter().filter(|(_, cells)| cells.len() == n).count())
            .unwrap_or(width);
        let all = |kind: fn(&str) -> bool| -> Vec<usize> { (0..count).filter(|&at| self.mostly(at, kind)).collect() };
        let no_header = StringRecord::new();
        let callout = match all(is_callout).as_slice() {
            [] => None,
            [at] => Some(*at),
            several_are => return Err(several(Role::Tolerance, &no_header, several_are)),
        };
        let numbers = all(is_number);
        let class = all(is_class_with_grade)
            .into_iter()
            .find(|&at| at.checked_sub(1).is_some_and(|before| numbers.binary_search(&before).is_ok()));
        let (tolerance, nominal) = match (callout, class) {
            (Some(at), _) => (Some(at), None),
            (None, Some(at)) => (Some(at), at.checked_sub(1)),
            (None, None) => (self.own_callouts(), None),
        };
        let free: Vec<usize> = numbers.into_iter().filter(|at| Some(*at) != nominal).collect();
        let behind: Vec<usize> =
            free.iter().copied().filter(|at| tolerance.is_some_and(|before| before < *at)).collect();
        let measured = match (behind.as_slice(), free.as_slice()) {
            ([at], _) | ([], [at]) => *at,
            ([], []) => return Err(ImportErrorKind::NoMeasuredColumn),
            ([], several_are) | (several_are, _) => return Err(several(Role::Measured, &no_header, several_are)),
        };
        let first = [tolerance, nominal, Some(measured)].into_iter().flatten().min().unwrap_or_default();
        let id = (0..first).next();
        let used = [id, tolerance, nominal, Some(measured)];
        Ok(Columns {
            id,
            tolerance,
            nominal: nominal.map(|at| LengthColumn { at, unit: Unit::Millimetre }),
            measured: LengthColumn { at: measured, unit: Unit::Millimetre },
            time: Vec::new(),
            simulated: None,
            count,
            header: None,
            names_known: false,
            ignored: (0..count)
                .filter(|at| !used.contains(&Some(*at)))
                .take(NAMED + 1)
                .map(|at| name_of(at, ""))
                .collect(),
            decimal_sign: None,
            whole_numbers_behind: false,
        })
    }

    /// The column that holds the own callout of more than half of the rows.
    fn own_callouts(&self) -> Option<usize> {
        let data = || self.rows.iter().skip(self.above).map(|(_, cells)| own_callout(cells));
        let first = data().flatten().next()?;
        let (are, all) = data().fold((0, 0), |(are, all), at| (are + usize::from(at == Some(first)), all + 1));
        (all < are * 2).then_some(first)
    }

    fn whole_numbers_behind(&self, at: usize) -> bool {
        let data = self.rows.iter().skip(self.above);
        let with_sign = data.filter(|(_, cells)| cells.get(at).is_some_and(|cell| cell.contains('.')));
        let (whole, all) = with_sign.fold((0, 0), |(whole, all), (_, cells)| {
            (whole + usize::from(cells.get(at + 1).is_some_and(is_whole)), all + 1)
        });
        all < whole * 2
    }

    /// The decimal sign that most values of a column have; in a tie, the first one.
    fn decimal_sign(&self, at: usize) -> Option<char> {
        let signs = || {
            self.cells(at).filter_map(|cell| match (cell.contains('.'), cell.contains(',')) {
                (true, false) => Some('.'),
                (false, true) => Some(','),
                _ => None,
            })
        };
        let first = signs().next()?;
        let (same, all) = signs().fold((0, 0), |(same, all), sign| (same + usize::from(sign == first), all + 1));
        let other = if first == '.' { ',' } else { '.' };
        Some(if same * 2 < all { other } else { first })
    }
}

/// Whether a cell is nothing but digits: one half of a number whose decimal comma was taken for a separator.
pub(super) fn is_whole(cell: &str) -> bool {
    let cell = cell.trim();
    !cell.is_empty() && cell.bytes().all(|byte| byte.is_ascii_digit())
}

/// Whether a text is a list of contacts: a header x, y or rows of two or three numbers, and no callout.
pub(super) fn are_contacts(text: &str) -> bool {
    SEPARATORS.iter().any(|&separator| {
        let sample = Sample::split(text, 1, separator);
        let Some((_, first)) = sample.rows.first() else { return false };
        let names: Vec<String> = first.iter().map(words::bare).collect();
        let has = |name: &str| names.iter().any(|given| given == name);
        if has("x") && has("y") {
            return true;
        }
        let is_contact = |cells: &StringRecord| {
            matches!(cells.len(), 2..=3)
                && cells.iter().all(|cell| cell.trim().replace(',', ".").parse::<f64>().is_ok())
        };
        // Most rows are enough: the reader of contacts reports one with letters.
        let contacts = sample.rows.iter().filter(|(_, cells)| is_contact(cells)).count();
        sample.header.is_none() && sample.rows.len() < contacts * 2
    })
}

/// The header row: the first that names columns and holds no measurement.
fn header(rows: &[(usize, StringRecord)]) -> Option<usize> {
    let first = rows
        .iter()
        .take(ABOVE_HEADER)
        .position(|(_, cells)| is_data(cells) || 2 <= named(cells) && may_be_names(cells));
    let is_header = |at: usize| rows.get(at).is_some_and(|(_, cells)| !is_data(cells));
    match first {
        Some(at) if is_header(at) => Some(at),
        // A single column that is named, or a name for the measured value alone.
        _ => rows.first().filter(|(_, cells)| 1 <= named(cells) && may_be_names(cells)).map(|_| 0),
    }
}

/// How many columns a row would name as a header.
fn named(cells: &StringRecord) -> usize {
    cells.iter().filter(|cell| words::role(cell).is_some()).count()
}

/// Whether a row holds no figures: neither numbers nor callouts, nor anything meant as one.
fn may_be_names(cells: &StringRecord) -> bool {
    let begins_with_digit =
        |cell: &str| cell.trim().trim_start_matches(['Ø', '⌀']).starts_with(|c: char| c.is_ascii_digit());
    !has_number(cells) && !cells.iter().any(begins_with_digit)
}

fn has_number(cells: &StringRecord) -> bool {
    cells.iter().any(is_number)
}

/// Whether a row holds a callout or class, and a number.
pub(super) fn is_data(cells: &StringRecord) -> bool {
    has_number(cells)
        && (cells.iter().any(|cell| is_callout(cell) || is_class_with_grade(cell)) || own_callout(cells).is_some())
}

pub(super) fn is_blank(cells: &StringRecord) -> bool {
    cells.iter().all(|cell| cell.trim().is_empty())
}

pub(super) fn is_comment(cells: &StringRecord) -> bool {
    cells.get(0).is_some_and(|cell| cell.trim_start().starts_with('#'))
}

fn is_number(cell: &str) -> bool {
    Length::parse_in(cell, Unit::Millimetre).is_ok()
}

fn is_callout(cell: &str) -> bool {
    // Deviations and limits look like dates and part numbers: 2024-03-14, 17-3. "3 pcs" may be a callout, and seldom is.
    cell.parse::<Callout>().is_ok_and(|callout| callout.class().is_some_and(ToleranceClass::has_grade))
}

/// The cell with the callout of an own column: `25 PF` and not `3 pcs`, because another cell holds a number within a tenth
/// of its nominal size.
fn own_callout(cells: &StringRecord) -> Option<usize> {
    let nominal = |cell: &str| {
        let callout = cell.parse::<Callout>().ok()?;
        callout.class().map(|_class| callout.nominal())
    };
    let is_near = |cell: &str, nominal: Length| {
        let number = Length::parse_in(cell, Unit::Millimetre).unwrap_or_default();
        let apart = number.saturating_sub(nominal).abs();
        apart.nanometres() <= nominal.nanometres() / 10
    };
    let has_measured = |nominal: Length| cells.iter().any(|cell| is_near(cell, nominal));
    cells.iter().position(|cell| nominal(cell).is_some_and(has_measured))
}

/// Whether a cell of a column that is named is a class.
fn is_class(cell: &str) -> bool {
    cell.parse::<ToleranceClass>().is_ok()
}

/// Whether a cell of a column without a name is a class: there a word such as GOOD is none.
fn is_class_with_grade(cell: &str) -> bool {
    cell.parse::<ToleranceClass>().is_ok_and(ToleranceClass::has_grade)
}

fn several(role: Role, header: &StringRecord, columns: &[usize]) -> ImportErrorKind {
    let columns = columns.iter().take(NAMED + 1);
    let names: Vec<String> = columns.map(|&at| name_of(at, header.get(at).unwrap_or_default())).collect();
    ImportErrorKind::SeveralColumns { role, columns: listed(&names) }
}

/// The first names of columns as one text, with an ellipsis where there are more.
pub(super) fn listed(names: &[String]) -> String {
    let mut list = names.get(..NAMED).unwrap_or(names).join(", ");
    if NAMED < names.len() {
        list.push_str(", …");
    }
    list
}

/// The number of a column, and its name where it has one.
fn name_of(at: usize, name: &str) -> String {
    let name = name.split_whitespace().collect::<Vec<_>>().join(" ");
    if name.is_empty() { (at + 1).to_string() } else { format!("{} ({})", at + 1, super::error::shorten(&name)) }
}
