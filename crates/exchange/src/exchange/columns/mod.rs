//! Which column of a CSV is which: by the words of its header (English, Dutch, German, Italian) or by content.
//!
//! A file that could be read in two ways is refused. `vocabulary` has the words.
//!
//! | file | what |
//! |---|---|
//! | here | what the columns of a file are |
//! | `find` | the columns that the first rows of a file have |
//! | `by_header`, `by_content` | found by the names in a header; found without one |

mod by_content;
mod by_header;
mod find;

use csv::StringRecord;
use fitcheck_core::length::Unit;
use fitcheck_core::tolerance::fit::thermal::Temperature;

use super::beside::BesideColumn;
use super::cells::WholeNumbers;
use super::column::{LengthColumn, listed, unit_of};
use super::error::{ImportErrorKind, ImportWarningKind};
use super::evidence::Evidence;
use super::head::Head;
use super::limits::LimitColumns;
use super::own::OwnColumns;
use super::quantity::QuantityColumn;
use super::remarks::RemarkColumn;
use super::role::Role;
use super::row::cells_of;
use super::stated::Stated;
use super::{samples, words};
use crate::exchange::cell::Cells as _;

/// What the columns of a file are.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Columns {
    pub(super) id: Option<usize>,
    pub(super) tolerance: Option<usize>,
    pub(super) nominal: Option<LengthColumn>,
    pub(super) measured: LengthColumn,
    /// Whether the name of the tolerances says that a number goes both ways: `Tol ±`.
    pub(super) tolerance_goes_both_ways: bool,
    /// Limits in columns of their own.
    pub(super) limits: Option<LimitColumns>,
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
    /// A column of no known name that looks as if it had the callouts, where nothing else has limits.
    pub(super) callouts_unnamed: Option<String>,
    /// Columns of no known name.
    pub(super) remarks: Vec<RemarkColumn>,
    /// The columns of measured values side by side, each as if it were the only one; none where there is one alone.
    pub(super) samples: Vec<Self>,
    /// How messages name them.
    pub(super) samples_named: String,
    /// The name of this one among them.
    pub(super) sample: String,
    /// What lines above the names say of all values.
    pub(super) head: Head,
    /// The line above the names that is a part of them.
    pub(super) top: Option<usize>,
    /// The line of the first row, where the user has said it.
    pub(super) first: Option<usize>,
    /// What is stated of units beside the names of the columns.
    pub(super) stated: Stated,
}

#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct LabelColumns {
    pub(super) number: Option<usize>,
    pub(super) part: Option<usize>,
    pub(super) serial: Option<usize>,
    pub(super) who: Option<usize>,
    pub(super) machine: Option<usize>,
    pub(super) batch: Option<usize>,
    pub(super) place: [Option<LengthColumn>; 3],
    /// Whether the numbers that features are found by may be running ones.
    pub(super) may_be_running: bool,
}

impl LabelColumns {
    /// Those of a header beside the columns that are used otherwise, and beside the one that names the features.
    fn of(header: &StringRecord, id: Option<usize>, used: &[usize]) -> Self {
        let labels: Vec<_> = (0..).zip(header).filter(|(at, _)| !used.contains(at)).collect();
        let at = |role: Role| labels.iter().find(|(_, name)| words::label(name) == Some(role)).map(|(at, _)| *at);
        let place = |role: Role| {
            let at = at(role)?;
            Some(LengthColumn { at, unit: unit_of(header.cell(at)).ok()? })
        };
        let number = at(Role::Number);
        // Without a number the name may be one.
        let numbers = number.or(id);
        Self {
            may_be_running: numbers.is_some_and(|at| words::may_be_running(header.cell(at))),
            number,
            part: at(Role::Part),
            // A serial number that names the rows is one all the same.
            serial: (0..).zip(header).find(|(_, name)| words::label(name) == Some(Role::Serial)).map(|(at, _)| at),
            who: at(Role::Who),
            machine: at(Role::Machine),
            batch: at(Role::Batch),
            place: [Role::X, Role::Y, Role::Z].map(place),
        }
    }

    /// The columns that are read.
    pub(super) fn iter(&self) -> impl Iterator<Item = usize> {
        let texts = [self.number, self.part, self.serial, self.who, self.machine, self.batch].into_iter().flatten();
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

    /// The columns of each value of a row; empty cells beside values are none.
    pub(super) fn of_values<'s>(&'s self, cells: &StringRecord) -> Vec<&'s Self> {
        let is_filled = |sample: &&Self| !cells.cell(sample.measured.at).trim().is_empty();
        let filled: Vec<&Self> = self.samples.iter().filter(is_filled).collect();
        if filled.is_empty() { vec![self] } else { filled }
    }

    /// Does something with the columns of each value.
    pub(super) fn each_value(&mut self, mut change: impl FnMut(&mut Self)) {
        change(self);
        self.samples.iter_mut().for_each(change);
    }

    /// The places of measured values that have a decimal comma.
    pub(super) fn with_decimal_comma(&self) -> Vec<usize> {
        let all = std::iter::once(self).chain(&self.samples);
        all.filter(|own| own.decimal_sign == Some(',')).map(|own| own.measured.at).collect()
    }

    /// The places of the measured values side by side.
    pub(super) fn sample_places(&self) -> Vec<usize> {
        self.samples.iter().map(|sample| sample.measured.at).collect()
    }

    /// The same columns for each of some columns of measured values.
    pub(super) fn split_into(&mut self, samples: &[usize], names: &StringRecord) -> Result<(), ImportErrorKind> {
        if samples.len() < 2 {
            return Ok(());
        }
        self.samples_named = samples::range(names, samples);
        let one = |at: &usize| -> Result<Self, ImportErrorKind> {
            let unit = match self.measured.unit {
                Unit::Millimetre => unit_of(names.cell(*at))?,
                stated => stated,
            };
            let sample = samples::name(names.cell(*at));
            Ok(Self { measured: LengthColumn { at: *at, unit }, samples: Vec::new(), sample, ..self.clone() })
        };
        let all: Result<Vec<Self>, ImportErrorKind> = samples.iter().map(one).collect();
        self.samples = all?;
        Ok(())
    }

    /// Measured values are in this unit.
    pub(super) fn set_unit(&mut self, unit: Unit) {
        self.measured.unit = unit;
        self.remarks.iter_mut().for_each(|remark| remark.unit = unit);
    }

    /// Whether one of them gives limits; where none does, a row alone cannot be judged.
    pub(super) fn have_limits(&self) -> bool {
        self.tolerance.is_some() || self.limits.is_some() || self.own != OwnColumns::default()
    }

    /// The columns that hold something else than what is looked for.
    pub(super) fn used(&self) -> Vec<usize> {
        // Without names, what stands before a callout is taken for a name.
        let id = self.id.filter(|_| self.header.is_some());
        let one = [id, self.tolerance, self.nominal.map(|column| column.at), Some(self.measured.at)];
        let more = [self.simulated].into_iter().chain(self.own.deciding());
        let all = one.into_iter().chain(more).flatten().chain(self.time.iter().copied()).chain(self.sample_places());
        let limits = self.limits.iter().flat_map(LimitColumns::iter).map(|column| column.at);
        all.chain(self.own.of_correction()).chain(self.labels.iter()).chain(limits).collect()
    }

    /// That words which say nothing known of what was measured are taken for sizes, and that other sizes are not judged.
    pub(super) fn taken_as_sizes(&self) -> impl Iterator<Item = ImportWarningKind> {
        let taken = self.quantities.iter().filter_map(QuantityColumn::taken);
        let columns = || listed(&self.other_values);
        let others = (!self.other_values.is_empty()).then(|| ImportWarningKind::OtherValues { columns: columns() });
        let unnamed = self.callouts_unnamed.clone();
        let unnamed = unnamed.map(|column| ImportWarningKind::CalloutsUnnamed { column });
        let samples = || ImportWarningKind::SamplesRead { columns: self.samples_named.clone() };
        let samples = (!self.samples.is_empty()).then(samples);
        let limits = self.limits.iter().flat_map(LimitColumns::told).chain(samples);
        others.into_iter().chain(unnamed).chain(limits).chain(
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
                column.unit = unit_of(names.cell(column.at))?;
            }
        }
        Ok(())
    }
}
