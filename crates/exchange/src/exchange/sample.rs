//! The first rows of a text or of a sheet: which of them is the header, which one the row of units, and what the cells of a column seem
//! to hold.

use csv::StringRecord;
use fitcheck_core::length::Unit;

use super::cells::{WholeNumbers, decimals, is_blank, is_comment, is_data, is_number, is_whole, may_be_names};
use super::delimited::{Item, Rows, SEPARATORS};
use super::limits::{self, LimitName};
use super::role::Role;
use super::vocabulary::Rank;
use super::{samples, stated, warmth, words};

/// How many rows are examined to find out what a file is.
pub(super) const SAMPLE: usize = 200;

/// The separator of cells that need none: no cell is one half of another.
pub(super) const NO_SEPARATOR: u8 = b'\t';

/// How many bytes of them, 512 KiB: every cell takes memory, and two ways to split them are compared.
const SAMPLE_BYTES: usize = 512 << 10;

/// How many lines may come before a header.
pub(super) const ABOVE_HEADER: usize = 50;

/// The first rows of a text, split at one separator.
pub(super) struct Sample {
    pub(super) separator: u8,
    pub(super) rows: Vec<(usize, StringRecord)>,
    pub(super) header: Option<usize>,
    /// How many rows come before the measurements.
    pub(super) above: usize,
    /// The line above the header that is a part of it.
    pub(super) top: Option<usize>,
    /// Whether the last of the rows ends the text, without a line end.
    is_last_open: bool,
    /// The column of measured values, where the user has said it.
    pub(super) measured: Option<usize>,
    /// Comments that may state a unit or a temperature.
    pub(super) comments: Vec<(usize, StringRecord)>,
    /// The row of units below the header.
    pub(super) units_row: Option<usize>,
    /// The unit of sizes, where the user has said it, and whether that of places is said.
    pub(super) given: Option<Unit>,
    pub(super) has_place_unit: bool,
    /// Columns that the user has said to hold a status, the unit of the row, hole or shaft.
    pub(super) said: Vec<(Role, usize)>,
    /// Whether the user has said which columns are the limits, or that none are.
    pub(super) are_limits_said: bool,
}

impl Sample {
    /// The separator under which the first rows make the most sense.
    pub(super) fn of(text: &str, first_line: usize, separator: Option<u8>) -> Self {
        let tried: &[u8] = separator.as_ref().map_or(&SEPARATORS, std::slice::from_ref);
        let samples = tried.iter().map(|&separator| Self::split(text, first_line, separator));
        // The first of equals: the separators are in order of trust.
        let best = samples.reduce(|best, other| if best.sense() < other.sense() { other } else { best });
        best.unwrap_or_else(|| Self::of_rows(Vec::new(), Vec::new(), b';'))
    }

    fn split(text: &str, first_line: usize, separator: u8) -> Self {
        let mut comments = Vec::new();
        let rows = Rows::new(text, first_line, separator).filter_map(|item| match item {
            Item::Row { line, cells } | Item::Lines { line, cells, .. } => row(line, cells, &mut comments),
            Item::OpenQuote { .. } | Item::TooLong { .. } => None,
        });
        let mut bytes = 0;
        let mut is_enough = |(_, cells): &(usize, StringRecord)| {
            let before = bytes;
            bytes += cells.as_slice().len() + cells.len();
            before < SAMPLE_BYTES
        };
        let mut rows = rows.peekable();
        let mut sample = Vec::new();
        while sample.len() < SAMPLE
            && let Some(row) = rows.next_if(&mut is_enough)
        {
            sample.push(row);
        }
        let is_last_open = !text.ends_with(['\n', '\r']) && rows.next().is_none();
        Self { is_last_open, ..Self::of_rows(sample, comments, separator) }
    }

    /// The first rows of a file that has cells as such, without those that are blank or comments.
    pub(super) fn of_cells(rows: impl Iterator<Item = (usize, StringRecord)>) -> Self {
        let mut comments = Vec::new();
        let rows = rows.filter_map(|(line, cells)| row(line, cells, &mut comments)).take(SAMPLE).collect();
        Self::of_rows(rows, comments, NO_SEPARATOR)
    }

    fn of_rows(rows: Vec<(usize, StringRecord)>, comments: Vec<(usize, StringRecord)>, separator: u8) -> Self {
        let header = header(&rows);
        // Unknown names are not a measurement either.
        let unknown = rows.first().is_some_and(|(_, cells)| may_be_names(cells));
        let above = header.map_or(usize::from(unknown), |header| header + 1);
        let mut sample = Self {
            separator,
            rows,
            header,
            above,
            top: None,
            is_last_open: false,
            measured: None,
            comments,
            units_row: None,
            given: None,
            has_place_unit: false,
            said: Vec::new(),
            are_limits_said: false,
        };
        sample.merge_header();
        sample.find_units_row();
        sample
    }

    /// Makes one header of two rows of names, where both together name more columns than either.
    fn merge_header(&mut self) {
        let Some(at) = self.header else { return };
        let row = |at: Option<usize>| at.and_then(|at| self.rows.get(at)).map(|(_, cells)| cells);
        let can_be = |cells: &StringRecord| may_be_names(cells) || names_samples(cells);
        let pairs = [(Some(at), at.checked_add(1)), (at.checked_sub(1), Some(at))];
        let best = pairs.into_iter().find_map(|(top, bottom)| {
            let (above, below) = (row(top)?, row(bottom)?);
            let names = merged(above, below);
            let is_more = named(above).max(named(below)) < named(&names)
                && 2 <= below.iter().filter(|cell| !cell.trim().is_empty()).count();
            let is_units = stated::is_row_of_units(above, below);
            // A title or a line of the head has few cells.
            // A sheet has no cells behind the last one that is filled: the row below tells how many there are.
            let width = row(bottom.and_then(|at| at.checked_add(1))).map_or(0, StringRecord::len).max(below.len());
            let is_group = 2 <= above.iter().filter(|cell| !cell.trim().is_empty()).count() && above.len() <= width;
            (can_be(above) && can_be(below) && is_group && !is_units && is_more).then_some((top?, bottom?, names))
        });
        let Some((top, bottom, names)) = best else { return };
        self.top = self.rows.get(top).map(|(line, _)| *line);
        self.header = Some(bottom);
        self.above = self.above.max(bottom + 1);
        if let Some((_, cells)) = self.rows.get_mut(bottom) {
            *cells = names;
        }
    }

    /// Finds the row of units below the header: no measurement.
    pub(super) fn find_units_row(&mut self) {
        let at = self.header.map_or(self.above, |header| header + 1);
        let header = at.checked_sub(1).and_then(|header| self.rows.get(header));
        let is_one = |((_, header), (_, cells)): &(&(usize, StringRecord), &(usize, StringRecord))| {
            stated::is_row_of_units(header, cells)
        };
        self.units_row = header.zip(self.rows.get(at)).filter(is_one).map(|_| at);
        if self.units_row.is_some() {
            self.above = self.above.max(at + 1);
        }
    }

    /// Whether the user has said that a column holds something.
    pub(super) fn is_said(&self, role: Role, at: usize) -> bool {
        self.said.contains(&(role, at))
    }

    /// Whether a column has no cells below the header.
    pub(super) fn is_empty(&self, at: usize) -> bool {
        self.cells(at).next().is_none()
    }

    /// How many columns the header names, how many rows hold a callout and a number, and how many rows have cells.
    fn sense(&self) -> (usize, usize, usize) {
        let named = self.header.and_then(|at| self.rows.get(at)).map_or(0, |(_, cells)| named(cells));
        let data = self.rows.iter().filter(|(_, cells)| is_data(cells)).count();
        let split = self.rows.iter().filter(|(_, cells)| 1 < cells.len()).count();
        (named, data, split)
    }

    /// Whether it has rows below what comes before the measurements.
    pub(super) fn has_data(&self) -> bool {
        self.above < self.rows.len()
    }

    /// The cells of a column below the header.
    pub(super) fn cells(&self, at: usize) -> impl Iterator<Item = &str> + Clone {
        let data = self.rows.iter().skip(self.above);
        data.filter_map(move |(_, cells)| cells.get(at)).map(str::trim).filter(|cell| !cell.is_empty())
    }

    /// Whether more than half of a column's cells are of a kind.
    pub(super) fn mostly(&self, at: usize, kind: fn(&str) -> bool) -> bool {
        let (are, all) = self.cells(at).fold((0, 0), |(are, all), cell| (are + usize::from(kind(cell)), all + 1));
        all < are * 2
    }

    /// What stands after the measured values with a decimal sign, where most of these cells are whole numbers.
    pub(super) fn behind(&self, at: usize) -> Option<WholeNumbers> {
        let data = self.rows.iter().skip(self.above);
        let with_sign = data.filter(|(_, cells)| cells.get(at).is_some_and(|cell| cell.contains('.')));
        let mut numbers = WholeNumbers::default();
        let (whole, all) = with_sign.fold((0, 0), |(whole, all), (_, cells)| {
            let behind = cells.get(at + 1).map(str::trim).filter(|behind| is_whole(behind));
            if let Some(behind) = behind {
                numbers.see(behind);
            }
            (whole + usize::from(behind.is_some()), all + 1)
        });
        (all < whole * 2).then_some(numbers)
    }

    /// The fewest and the most decimals of a column's numbers. A last line without a line end is not asked: it may be cut off.
    pub(super) fn decimals(&self, at: usize) -> Option<(usize, usize)> {
        let data = self.rows.len() - usize::from(self.is_last_open && self.above < self.rows.len());
        let data = self.rows.get(..data)?.iter().skip(self.above);
        let all = data.filter_map(|(_, cells)| cells.get(at)).filter(|cell| is_number(cell)).map(decimals);
        all.clone().min().zip(all.max())
    }
}

/// A row of a sample; a comment is none, and kept apart.
fn row(line: usize, cells: StringRecord, comments: &mut Vec<(usize, StringRecord)>) -> Option<(usize, StringRecord)> {
    if is_blank(&cells) {
        return None;
    }
    if is_comment(&cells) {
        if stated::may_state(&cells) || warmth::mentioned(&cells.iter().collect::<Vec<_>>().join(" ")).is_some() {
            comments.push((line, cells));
        }
        return None;
    }
    Some((line, cells))
}

/// The header row: the first that names columns and holds no measurement.
fn header(rows: &[(usize, StringRecord)]) -> Option<usize> {
    let names = |cells: &StringRecord| {
        2 <= named(cells) && (may_be_names(cells) || names_samples(cells)) && !stated::are_units(cells.iter())
    };
    let above = || rows.iter().take(ABOVE_HEADER);
    let first = above().position(|(_, cells)| is_data(cells) || names(cells));
    let is_header = |at: usize| rows.get(at).is_some_and(|(_, cells)| !is_data(cells));
    // Of several lines of names, that of measured values: "Part Name;Plate;Serial;S-7" may be names, too.
    let has_values = |cells: &StringRecord| {
        let is_measured =
            |cell: &str| words::role(cell).is_some_and(|(role, rank)| role == Role::Measured && rank != Rank::Unsure);
        cells.iter().any(is_measured) || names_samples(cells)
    };
    let below = above().position(|(_, cells)| is_data(cells) || names(cells) && has_values(cells));
    let first = below.filter(|at| is_header(*at)).or(first);
    match first {
        Some(at) if is_header(at) => Some(at),
        // A single column that is named, or a name for the measured value alone.
        _ => rows.first().filter(|(_, cells)| 1 <= named(cells) && may_be_names(cells)).map(|_| 0),
    }
}

/// Whether a row names columns of samples by numbers, and others.
fn names_samples(cells: &StringRecord) -> bool {
    let samples = samples::counted(cells);
    let others: StringRecord = (0..).zip(cells).filter(|(at, _)| !samples.contains(at)).map(|(_, cell)| cell).collect();
    !samples.is_empty() && may_be_names(&others)
}

/// The names of two rows as one: what stands above several columns, and what stands below it over each.
fn merged(top: &StringRecord, bottom: &StringRecord) -> StringRecord {
    let mut group = "";
    let name = |at: usize| {
        let below = bottom.get(at).unwrap_or("").trim();
        let above = top.get(at).unwrap_or("").trim();
        if !above.is_empty() || below.is_empty() {
            group = above;
        }
        let both = format!("{group} {below}").trim().to_owned();
        if limits::by_name(&both).is_some_and(LimitName::is_sure) {
            return both;
        }
        let known =
            [below, both.as_str(), group].into_iter().find(|name| words::role(name).is_some()).map(str::to_owned);
        known.unwrap_or(both)
    };
    (0..top.len().max(bottom.len())).map(name).collect()
}

/// How many columns a row would name as a header.
fn named(cells: &StringRecord) -> usize {
    cells.iter().filter(|cell| words::role(cell).is_some()).count()
}

impl Sample {
    /// The columns with a measured value each, by names that are counted; most of their cells are numbers.
    pub(super) fn side_by_side(&self, names: &StringRecord) -> Vec<usize> {
        let found = samples::counted(names);
        let cells = || found.iter().flat_map(|at| self.cells(*at));
        let (numbers, all) =
            cells().fold((0, 0), |(numbers, all), cell| (numbers + usize::from(is_number(cell)), all + 1));
        if all < numbers * 2 { found } else { Vec::new() }
    }
}
