//! A row of a dimension: an axis with its figures.

use fitcheck_core::length::{Length, LengthError, Unit};
use fitcheck_core::probing::cycle::Axis;

use super::heading::{Column, Columns, MEASURED, Title, words};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use crate::exchange::imported::StatedLimits;
use crate::exchange::printed::{Computed, Printed, PrintedFault};
use crate::exchange::quantity::Quantity;

/// A row, taken apart.
#[derive(Debug)]
pub(super) struct Row {
    /// The axis, in capitals.
    pub(super) axis: String,
    /// What stands below each column; empty where nothing does.
    cells: Vec<String>,
    /// Whether a sign behind the figures shows that the row is whole.
    pub(super) is_complete: bool,
}

/// The figures of a row.
#[derive(Debug)]
pub(super) struct Figures {
    pub(super) measured: Printed,
    pub(super) asked: StatedLimits,
    pub(super) computed: Computed,
    /// The column of the status with its figure, as the report has it.
    pub(super) said: String,
}

/// How the report writes a minus tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum MinusIs {
    /// Without its sign: one with a minus lies above the nominal value.
    Unsigned,
    /// With its sign.
    Signed,
    /// Both readings are possible.
    Open,
}

/// Axes of a dimension as PC-DMIS names them.
const AXES: [&str; 28] = [
    "X", "Y", "Z", "D", "DF", "PD", "SD", "R", "PR", "PA", "A", "L", "W", "H", "T", "S", "RT", "RS", "V", "M", "TP",
    "AR", "D1", "D2", "D3", "RN", "PX", "PY",
];

/// What an axis is the length of; `None` for angles, vectors and areas.
pub(super) fn quantity(axis: &str) -> Option<Quantity> {
    Some(match axis {
        "X" => Quantity::Coordinate(Axis::First),
        "Y" => Quantity::Coordinate(Axis::Second),
        "Z" => Quantity::Coordinate(Axis::Third),
        "D" | "DF" | "PD" | "SD" => Quantity::Diameter,
        "W" => Quantity::Width,
        "A" | "PA" | "V" | "AR" => return None,
        _ => Quantity::Length,
    })
}

impl Row {
    /// Takes a row apart; `None` for a line that begins with no axis.
    ///
    /// # Errors
    /// [`PrintedFault::Cells`] where it is not clear below which columns the figures stand.
    pub(super) fn of(text: &str, columns: &Columns) -> Option<Result<Self, ImportErrorKind>> {
        let mut words = words(text);
        let axis = words.first()?.0.to_uppercase();
        if !AXES.contains(&axis.as_str()) {
            return None;
        }
        words.remove(0);
        let mut is_complete = false;
        // The place of the value in its zone, drawn with signs: `--#-`, `---->`.
        if words.last().is_some_and(|(word, _)| 1 < word.len() && !word.contains(char::is_alphanumeric)) {
            words.pop();
            is_complete = true;
        }
        let expected = columns.0.len();
        let fault = || ImportErrorKind::from(PrintedFault::Cells { found: words.len(), expected });
        if words.len() == expected {
            let cells = words.into_iter().map(|(word, _)| word).collect();
            return Some(Ok(Self { axis, cells, is_complete }));
        }
        if expected < words.len() || text.contains('\t') {
            return Some(Err(fault()));
        }
        let mut cells = vec![String::new(); expected];
        for (word, end) in &words {
            let Some(cell) = below(columns, *end).and_then(|at| cells.get_mut(at)).filter(|cell| cell.is_empty())
            else {
                return Some(Err(fault()));
            };
            word.clone_into(cell);
        }
        Some(Ok(Self { axis, cells, is_complete }))
    }

    /// The text below a column; empty where there is none, or a word or a dash that stands for none.
    fn text(&self, columns: &Columns, column: Column) -> &str {
        let at = columns.0.iter().position(|heading| heading.column == column);
        let text = at.and_then(|at| self.cells.get(at)).map_or("", String::as_str);
        if text.contains(|sign: char| sign.is_ascii_digit()) { text } else { "" }
    }

    fn figure(&self, columns: &Columns, column: Column, unit: Unit) -> Result<Option<Printed>, ImportErrorKind> {
        let text = self.text(columns, column);
        if text.is_empty() {
            return Ok(None);
        }
        let name = || columns.0.iter().find(|heading| heading.column == column).map(|heading| heading.name.clone());
        let read = Printed::read(text.trim_start_matches('+'), unit);
        read.map(Some).map_err(|reason| PrintedFault::Number { column: name().unwrap_or_default(), reason }.into())
    }

    /// What the row says of the sign of minus tolerances: whether its own has a minus, and whether that can be read in one way alone.
    /// Nothing where it has none, or zero.
    pub(super) fn minus(&self, columns: &Columns) -> Option<(bool, bool)> {
        let figure = |column| self.figure(columns, column, Unit::Millimetre).ok().flatten();
        let minus = figure(Column::Minus)?.length;
        let plus = figure(Column::Plus).map(|plus| plus.length);
        // Read the other way it would be the larger limit, or both limits would be one.
        let is_sure = plus.is_some_and(|plus| plus <= minus.abs());
        (minus != Length::ZERO).then_some((minus < Length::ZERO, is_sure))
    }

    /// The figures of the row.
    ///
    /// # Errors
    /// What cannot be read.
    pub(super) fn figures(
        &self,
        columns: &Columns,
        title: &Title,
        unit: Unit,
        minus_is: MinusIs,
    ) -> Result<Figures, ImportErrorKind> {
        let figure = |column| self.figure(columns, column, unit);
        let length = |column| figure(column).map(|read| read.map(|read| read.length));
        let measured = figure(Column::Measured)?.ok_or(PrintedFault::NoValue { column: MEASURED })?;
        let plus = length(Column::Plus)?;
        let minus = length(Column::Minus)?;
        // A form or a place is measured from 0, and has no nominal value in some reports.
        let is_from_zero = self.axis == "TP" || self.axis == "M" && !title.has_nominal();
        let nominal = length(Column::Nominal)?.or_else(|| is_from_zero.then_some(Length::ZERO));
        // What the program granted a position beyond its tolerance, as it computed it. A diameter shows what it gives, and is granted none.
        let bonus = length(Column::Bonus)?.filter(|_| self.axis == "TP").unwrap_or(Length::ZERO);
        if minus.is_some_and(|minus| minus != Length::ZERO) && minus_is == MinusIs::Open {
            return Err(PrintedFault::MinusSign { given: shorten(self.text(columns, Column::Minus)) }.into());
        }
        let lower = minus.map(|minus| if minus_is == MinusIs::Signed { minus } else { minus.negated() });
        let sum = |by: Option<Length>| match nominal.zip(by) {
            None => Ok(None),
            Some((nominal, by)) => nominal.checked_add(by).map(Some).ok_or_else(|| {
                let reason = LengthError::TooLarge { text: by.to_string() };
                ImportErrorKind::from(PrintedFault::Number { column: "+TOL".to_owned(), reason })
            }),
        };
        let asked = StatedLimits {
            nominal,
            minimum: sum(lower)?,
            maximum: sum(plus.and_then(|plus| plus.checked_add(bonus)))?,
        };
        let computed = Computed { deviation: figure(Column::Deviation)?, beyond: figure(Column::Beyond)? };
        let said = format!("OUTTOL {}", self.text(columns, Column::Beyond));
        Ok(Figures { measured, asked, computed, said })
    }
}

/// The column that a figure stands below: figures and names end at the same place, or one sign beside it.
fn below(columns: &Columns, end: usize) -> Option<usize> {
    let off = |heading: &super::heading::Heading| heading.end.abs_diff(end);
    let (at, nearest) = columns.0.iter().enumerate().min_by_key(|(_, heading)| off(heading))?;
    (off(nearest) <= 2).then_some(at)
}
