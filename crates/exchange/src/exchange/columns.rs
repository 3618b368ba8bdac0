//! Finds the columns of a CSV: by the words of its header (English, Dutch, German, Italian) or by content.
//!
//! A file that could be read in two ways is refused. `words` has the words.

use csv::StringRecord;
use fitcheck_core::length::Unit;
use fitcheck_core::tolerance::fit::thermal::Temperature;

use super::beside::BesideColumn;
use super::cells::{
    self, WholeNumbers, decimals, is_blank, is_callout, is_class_with_grade, is_comment, is_data, is_number, is_whole,
    may_be_names, own_callout,
};
use super::delimited::{Item, Rows, SEPARATORS};
use super::error::{ImportErrorKind, ImportWarningKind};
use super::evidence::Evidence;
use super::own::OwnColumns;
use super::quantity::{Free, QuantityColumn};
use super::remarks::RemarkColumn;
use super::role::Role;
use super::row::cells_of;
use super::stated::{self, Stated};
use super::units;
use super::vocabulary::Rank;
use super::warmth;
use super::words;

/// How many rows are examined to find out what a file is.
pub(super) const SAMPLE: usize = 200;

/// The separator of cells that need none: no cell is one half of another.
pub(super) const NO_SEPARATOR: u8 = b'\t';

/// How many bytes of them, 512 KiB: every cell takes memory, and two ways to split them are compared.
const SAMPLE_BYTES: usize = 512 << 10;

/// How many lines may come before a header.
pub(super) const ABOVE_HEADER: usize = 20;

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
    /// Columns that say what was measured.
    pub(super) quantities: Vec<QuantityColumn>,
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
    /// The whole numbers of their own after measured values with a decimal sign, where most of these have one.
    pub(super) behind: Option<WholeNumbers>,
    /// The fewest and the most decimals of the first measured values, without that of a last line that has no line end.
    pub(super) decimals: Option<(usize, usize)>,
    /// What a file of Fitcheck says of its values.
    pub(super) own: OwnColumns,
    /// What is said of how a value came about.
    pub(super) evidence: Evidence,
    /// What is said of a value besides its name.
    pub(super) labels: LabelColumns,
    /// Columns with other sizes near the measured ones.
    pub(super) other_values: Vec<String>,
    /// What stands beside a value and may contradict its answer.
    pub(super) beside: Vec<BesideColumn>,
    /// Columns of no known name.
    pub(super) remarks: Vec<RemarkColumn>,
    /// The line of the first row, where the user has said it.
    pub(super) first: Option<usize>,
    /// What is stated of units beside the names of the columns.
    pub(super) stated: Stated,
}

/// The columns of [`Labels`](super::Labels).
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct LabelColumns {
    pub(super) number: Option<usize>,
    pub(super) part: Option<usize>,
    pub(super) serial: Option<usize>,
    pub(super) who: Option<usize>,
    pub(super) place: [Option<LengthColumn>; 3],
}

impl LabelColumns {
    /// Those of a header beside the columns that are used otherwise.
    fn of(header: &StringRecord, used: &[usize]) -> Self {
        let labels: Vec<_> = (0..).zip(header).filter(|(at, _)| !used.contains(at)).collect();
        let at = |role: Role| labels.iter().find(|(_, name)| words::label(name) == Some(role)).map(|(at, _)| *at);
        let place = |role: Role| {
            let at = at(role)?;
            Some(LengthColumn { at, unit: unit_of(header.get(at).unwrap_or_default()).ok()? })
        };
        Self {
            number: at(Role::Number),
            part: at(Role::Part),
            // A serial number that names the rows is one all the same.
            serial: (0..).zip(header).find(|(_, name)| words::label(name) == Some(Role::Serial)).map(|(at, _)| at),
            who: at(Role::Who),
            place: [Role::X, Role::Y, Role::Z].map(place),
        }
    }

    /// The columns that are read.
    pub(super) fn iter(&self) -> impl Iterator<Item = usize> {
        let texts = [self.number, self.part, self.serial, self.who].into_iter().flatten();
        texts.chain(self.place.iter().flatten().map(|column| column.at))
    }
}

impl Columns {
    /// Whether a line within the quotation marks of a cell looks like a row, with something like a number where measured values are: a mark
    /// is one too many then, or one is missing, and nobody knows which.
    pub(super) fn hides_rows(&self, cells: &StringRecord, separator: u8) -> bool {
        let mut lines =
            cells.iter().filter(|cell| cell.contains(['\n', '\r'])).flat_map(|cell| cell.split(['\n', '\r']));
        let may_be_number = |cell: &str| cell.contains(|c: char| c.is_ascii_digit());
        lines.any(|line| {
            let row = cells_of(line, separator).filter(|row| 1 < row.len() || self.count == 1);
            row.is_some_and(|row| row.get(self.measured.at).is_some_and(may_be_number))
        })
    }

    /// The temperature with which a line beside the rows is compared: none where values were brought to 20 °C already, and above the names,
    /// where each row is compared with what the lines say.
    pub(super) fn counted_at(&self, line: usize, counted: Temperature) -> Option<Temperature> {
        let is_above = self.header.is_some_and(|header| line < header);
        Some(counted).filter(|_| !is_above && !self.own.are_corrected() && !self.evidence.are_corrected)
    }

    /// Measured values are in this unit.
    pub(super) fn set_unit(&mut self, unit: Unit) {
        self.measured.unit = unit;
        self.remarks.iter_mut().for_each(|remark| remark.unit = unit);
    }

    /// The columns that hold something else than what is looked for.
    pub(super) fn used(&self) -> Vec<usize> {
        // Without names, what stands before a callout is taken for a name.
        let id = self.id.filter(|_| self.header.is_some());
        let one = [id, self.tolerance, self.nominal.map(|column| column.at), Some(self.measured.at)];
        let more = [self.simulated].into_iter().chain(self.own.deciding());
        let all = one.into_iter().chain(more).flatten().chain(self.time.iter().copied());
        all.chain(self.own.of_correction()).chain(self.labels.iter()).collect()
    }

    /// That words which say nothing known of what was measured are taken for sizes, and that other sizes are not judged.
    pub(super) fn taken_as_sizes(&self) -> impl Iterator<Item = ImportWarningKind> {
        let taken = self.quantities.iter().filter_map(QuantityColumn::taken);
        let columns = || listed(&self.other_values);
        let others = (!self.other_values.is_empty()).then(|| ImportWarningKind::OtherValues { columns: columns() });
        others.into_iter().chain(
            taken.map(|(column, words)| ImportWarningKind::QuantityUnknown {
                column: column.clone(),
                words: words.clone(),
            }),
        )
    }

    /// The units that unknown names say, where there is one for each column.
    fn with_units(&mut self, names: &StringRecord) -> Result<(), ImportErrorKind> {
        if names.len() == self.count {
            for column in self.nominal.iter_mut().chain([&mut self.measured]) {
                column.unit = unit_of(names.get(column.at).unwrap_or_default())?;
            }
        }
        Ok(())
    }
}

/// The first rows of a text, split at one separator.
pub(super) struct Sample {
    pub(super) separator: u8,
    pub(super) rows: Vec<(usize, StringRecord)>,
    pub(super) header: Option<usize>,
    /// How many rows come before the measurements.
    pub(super) above: usize,
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
            is_last_open: false,
            measured: None,
            comments,
            units_row: None,
            given: None,
            has_place_unit: false,
        };
        sample.find_units_row();
        sample
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
            if let Some((line, names)) = self.above.checked_sub(1).and_then(|at| self.rows.get(at)) {
                columns.header = Some(*line);
                columns.with_units(names)?;
            }
            columns
        };
        let names = self.above.checked_sub(1).map(|last| self.header.unwrap_or(last)).and_then(|at| self.rows.get(at));
        self.look_at_values(&mut columns, names.map_or(&StringRecord::new(), |(_, names)| names));
        if let Some((line, _)) =
            self.rows.iter().take(self.above).find(|(_, row)| columns.hides_rows(row, self.separator))
        {
            return Err(ImportErrorKind::HeaderHidesRows { line: *line });
        }
        stated::decide(self, &mut columns)?;
        Ok(columns)
    }

    /// What the first measured values look like.
    pub(super) fn look_at_values(&self, columns: &mut Columns, names: &StringRecord) {
        let used = columns.used();
        columns.evidence.word = self.says_simulated(columns, &used);
        columns.beside = self.beside(names, columns, &used);
        columns.evidence.warm = self.said_of_all(columns, names);
        columns.other_values = self.other_values(names, columns, &used);
        columns.remarks = RemarkColumn::all(names, columns, &used);
        // What is compared is not skipped.
        let compared = columns.beside.iter().map(BesideColumn::at).chain(columns.evidence.word);
        let compared: Vec<String> = compared.map(|at| name_of(at, names.get(at).unwrap_or_default())).collect();
        columns.ignored.retain(|name| !compared.contains(name));
        columns.ignored.truncate(NAMED + 1);
        let at = columns.measured.at;
        columns.decimal_sign = cells::decimal_sign(self.cells(at));
        columns.behind = self.behind(at);
        columns.decimals = self.decimals(at);
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

    fn by_header(&self, line: usize, header: &StringRecord) -> Result<Columns, ImportErrorKind> {
        let mut roles: Vec<_> = header.iter().map(words::role).collect();
        let own = OwnColumns::of(header);
        for at in own.of_correction() {
            if let Some(role) = roles.get_mut(at) {
                *role = None;
            }
        }
        let quantities = self.quantities(header, names(header, &roles), |at| match header.get(at) {
            // A file of Fitcheck names its values there, whatever they are called.
            Some("id") if own != OwnColumns::default() => Free::No,
            _ => free(header, &roles, at),
        });
        // "Part [°C]" names no part.
        let warm: Vec<usize> = (0..)
            .zip(header)
            .zip(&roles)
            .filter(|((_, name), role)| !matches!(role, Some((Role::Measured, _))) && warmth::of_column(name).is_some())
            .map(|((at, _), _)| at)
            .collect();
        for at in quantities.iter().map(|column| column.at).chain(warm.iter().copied()) {
            if let Some(role) = roles.get_mut(at) {
                *role = None;
            }
        }
        let best = |role: Role, ranks: &[Rank]| best(header, &roles, role, ranks);
        let sure = [Rank::Exact, Rank::Contained];
        let chosen = self.chosen(header, &roles)?;
        let (tolerance, nominal, measured_at) = (chosen.tolerance, chosen.nominal, chosen.measured);
        let time: Vec<usize> =
            (0..).zip(&roles).filter(|(_, r)| matches!(r, Some((Role::Time, _)))).map(|(at, _)| at).take(2).collect();
        let id = names(header, &roles);
        let simulated = best(Role::Simulated, &sure)?;
        let column = |at: usize| -> Result<LengthColumn, ImportErrorKind> {
            Ok(LengthColumn { at, unit: unit_of(header.get(at).unwrap_or_default())? })
        };
        let evidence = Evidence::of(header, measured_at);
        let used: Vec<usize> = [id, tolerance, nominal, simulated, evidence.origin, Some(measured_at)]
            .into_iter()
            .flatten()
            .chain(time.iter().copied())
            .chain(quantities.iter().map(|column| column.at))
            .chain(own.of_correction())
            .collect();
        let labels = LabelColumns::of(header, &[used.as_slice(), &warm].concat());
        let used: Vec<usize> = used.into_iter().chain(labels.iter()).collect();
        let ignored = (0..).zip(header).filter(|(at, name)| !used.contains(at) && !name.trim().is_empty());
        Ok(Columns {
            id,
            tolerance,
            nominal: nominal.map(column).transpose()?,
            measured: column(measured_at)?,
            time,
            simulated,
            quantities,
            count: header.len(),
            header: Some(line),
            names_known: true,
            ignored: ignored.map(|(at, name)| name_of(at, name)).collect(),
            decimal_sign: None,
            behind: None,
            decimals: None,
            own,
            evidence,
            labels,
            other_values: Vec::new(),
            beside: Vec::new(),
            remarks: Vec::new(),
            first: None,
            stated: Stated::default(),
        })
    }

    /// Without a header: the column of callouts, or of classes with the nominal sizes before them, and the only column
    /// of numbers after it, or the only one at all beside a callout. Names of own columns, such as PF, are words like any
    /// other, so they are told apart by the measured value only, and only in callouts.
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
            _ if self.measured.is_some() => self.measured.unwrap_or_default(),
            // Of two numbers before a class, either may be the nominal size.
            ([], [_, ..]) if nominal.is_some() => {
                let before: Vec<usize> = free.iter().copied().chain(nominal).collect();
                return Err(several(Role::Measured, &no_header, &before));
            }
            ([at], _) | ([], [at]) => *at,
            ([], []) => return Err(ImportErrorKind::NoMeasuredColumn),
            ([], several_are) | (several_are, _) => return Err(several(Role::Measured, &no_header, several_are)),
        };
        let first = [tolerance, nominal, Some(measured)].into_iter().flatten().min().unwrap_or_default();
        let id = (0..first).next();
        let used = [id, tolerance, nominal, Some(measured)];
        let is_free = |at: usize| if used.contains(&Some(at)) { Free::No } else { Free::Yes };
        let quantities = self.quantities(&no_header, id, is_free);
        let is_used = |at: usize| used.contains(&Some(at)) || quantities.iter().any(|column| column.at == at);
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
            ignored: (0..count).filter(|at| !is_used(*at)).map(|at| name_of(at, "")).collect(),
            quantities,
            decimal_sign: None,
            behind: None,
            decimals: None,
            own: OwnColumns::default(),
            evidence: Evidence::default(),
            labels: LabelColumns::default(),
            other_values: Vec::new(),
            beside: Vec::new(),
            remarks: Vec::new(),
            first: None,
            stated: Stated::default(),
        })
    }

    /// The column that holds the own callout of more than half of the rows.
    fn own_callouts(&self) -> Option<usize> {
        let data = || self.rows.iter().skip(self.above).map(|(_, cells)| own_callout(cells));
        let first = data().flatten().next()?;
        let (are, all) = data().fold((0, 0), |(are, all), at| (are + usize::from(at == Some(first)), all + 1));
        (all < are * 2).then_some(first)
    }

    /// What stands after the measured values with a decimal sign, where most of these cells are whole numbers.
    fn behind(&self, at: usize) -> Option<WholeNumbers> {
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
    fn decimals(&self, at: usize) -> Option<(usize, usize)> {
        let data = self.rows.len() - usize::from(self.is_last_open && self.above < self.rows.len());
        let data = self.rows.get(..data)?.iter().skip(self.above);
        let all = data.filter_map(|(_, cells)| cells.get(at)).filter(|cell| is_number(cell)).map(decimals);
        all.clone().min().zip(all.max())
    }
}

/// What the names of a header say of the columns.
pub(super) type Roles = [Option<(Role, Rank)>];

/// The column of a role by its name, the surest names first.
pub(super) fn best(
    header: &StringRecord,
    roles: &Roles,
    role: Role,
    ranks: &[Rank],
) -> Result<Option<usize>, ImportErrorKind> {
    for rank in ranks {
        let found: Vec<usize> =
            (0..).zip(roles).filter(|(_, r)| **r == Some((role, *rank))).map(|(at, _)| at).collect();
        match found.as_slice() {
            [] => {}
            [at] => return Ok(Some(*at)),
            _ => return Err(several(role, header, &found)),
        }
    }
    Ok(None)
}

/// The column that names the features. Any of several will do, but a part, a serial number or a number names a value only where nothing
/// else does.
fn names(header: &StringRecord, roles: &Roles) -> Option<usize> {
    let of_rank = |rank: Rank| roles.iter().position(|role| *role == Some((Role::Id, rank)));
    let first = of_rank(Rank::Exact).or_else(|| of_rank(Rank::Contained))?;
    if names_features(header, first) {
        return Some(first);
    }
    let is_id = |at: &usize| matches!(roles.get(*at), Some(Some((Role::Id, _))));
    (0..header.len()).filter(is_id).find(|at| names_features(header, *at)).or(Some(first))
}

/// Whether a column of names has those of features, and of nothing else.
fn names_features(header: &StringRecord, at: usize) -> bool {
    header.get(at).is_none_or(|name| words::label(name).is_none())
}

/// Whether a column may say what was measured.
fn free(header: &StringRecord, roles: &Roles, at: usize) -> Free {
    let name = header.get(at).unwrap_or_default();
    let is_id = |at: usize| names_features(header, at) && matches!(roles.get(at), Some(Some((Role::Id, _))));
    match roles.get(at).copied().flatten() {
        Some((Role::Id, _)) if is_id(at) && (0..header.len()).any(|other| other != at && is_id(other)) => {
            Free::NamesToo
        }
        None | Some((Role::Measured, Rank::Weak)) if words::label(name).is_none() && !words::is_status(name) => {
            Free::Yes
        }
        _ => Free::No,
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

/// Whether a text is a list of contacts: a header x, y or rows of two or three numbers, and no callout.
pub(super) fn are_contacts(text: &str) -> bool {
    SEPARATORS.iter().any(|&separator| {
        let sample = Sample::split(text, 1, separator);
        let Some((_, first)) = sample.rows.first() else { return false };
        let names: Vec<String> = first.iter().map(words::bare).collect();
        let has = |name: &str| names.iter().any(|given| given == name);
        if has("x") && has("y") {
            // Beside a measured value and a callout, or a name that a plan knows, they are the place of a feature.
            let names = |role: Role| first.iter().any(|name| words::role(name).is_some_and(|(named, _)| named == role));
            return !(names(Role::Measured) && [Role::Tolerance, Role::Id, Role::Number].into_iter().any(names));
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

pub(super) fn several(role: Role, header: &StringRecord, columns: &[usize]) -> ImportErrorKind {
    let mut columns = columns.to_vec();
    columns.sort_unstable();
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

/// The unit that a column's name says; millimetres where it says none.
pub(super) fn unit_of(name: &str) -> Result<Unit, ImportErrorKind> {
    let unit = units::unit(name).map_err(|unit| ImportErrorKind::Unit { unit: super::given::shorten(&unit) })?;
    Ok(unit.unwrap_or(Unit::Millimetre))
}

/// The number of a column, and its name where it has one.
pub(super) fn name_of(at: usize, name: &str) -> String {
    let name = name.split_whitespace().collect::<Vec<_>>().join(" ");
    if name.is_empty() { (at + 1).to_string() } else { format!("{} ({})", at + 1, super::given::shorten(&name)) }
}
