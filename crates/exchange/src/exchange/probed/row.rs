//! A row of a print: `SIZE D25.0000 ACTUAL 25.0120 TOL 0.0210 DEV 0.0120`.

use fitcheck_core::length::Unit;
use fitcheck_core::probing::cycle::Axis;

use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use crate::exchange::printed::{Printed, PrintedFault};
use crate::exchange::quantity::Quantity;

/// The words before the figures.
pub(super) const ACTUAL: &str = "ACTUAL";
const TOLERANCE: &str = "TOL";
const DEVIATION: &str = "DEV";

/// A row, taken apart.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Row {
    /// `SIZE`, `POSN` or another word.
    pub(super) kind: String,
    /// `D`, `X` or nothing.
    pub(super) axis: String,
    nominal: String,
    actual: String,
    tolerance: String,
    /// Whether the tolerance is that of the position in all axes together.
    pub(super) is_of_position: bool,
    deviation: String,
}

/// The figures of a row; the tolerance is half of the zone.
#[derive(Debug, Clone, Copy)]
pub(super) struct Figures {
    pub(super) nominal: Printed,
    pub(super) measured: Printed,
    pub(super) tolerance: Option<Printed>,
    pub(super) deviation: Option<Printed>,
}

impl Row {
    /// Takes a line apart; `None` for one that is no row.
    pub(super) fn of(text: &str) -> Option<Self> {
        let mut words = text.split_whitespace();
        let kind = words.next().filter(|word| word.chars().all(|sign| sign.is_ascii_uppercase()))?;
        let mut row = Self {
            kind: kind.to_owned(),
            axis: String::new(),
            nominal: String::new(),
            actual: String::new(),
            tolerance: String::new(),
            is_of_position: false,
            deviation: String::new(),
        };
        let mut into = &mut row.nominal;
        let mut has_actual = false;
        for word in words {
            match word {
                ACTUAL => {
                    has_actual = true;
                    into = &mut row.actual;
                }
                TOLERANCE => into = &mut row.tolerance,
                DEVIATION => into = &mut row.deviation,
                word => into.push_str(word),
            }
        }
        let digits = row.nominal.find(|sign: char| !sign.is_ascii_alphabetic()).unwrap_or(row.nominal.len());
        let nominal = row.nominal.split_off(digits);
        row.axis = std::mem::replace(&mut row.nominal, nominal);
        if row.tolerance.starts_with("TP") {
            row.tolerance = row.tolerance.split_off(2);
            row.is_of_position = true;
        }
        has_actual.then_some(row)
    }

    /// What was measured; `None` for angles and everything unknown.
    pub(super) fn quantity(&self) -> Option<Quantity> {
        let axis = match self.axis.as_str() {
            "X" => Some(Axis::First),
            "Y" => Some(Axis::Second),
            "Z" => Some(Axis::Third),
            _ => None,
        };
        match (self.kind.as_str(), self.axis.as_str(), axis) {
            ("SIZE", "D", _) => Some(Quantity::Diameter),
            ("SIZE", _, Some(_)) => Some(Quantity::Width),
            ("POSN", _, Some(axis)) => Some(Quantity::Coordinate(axis)),
            ("DIST", ..) => Some(Quantity::Length),
            _ => None,
        }
    }

    /// What the print calls it, such as `POSN X`.
    pub(super) fn what(&self) -> String {
        let of_position = if self.is_of_position { " TOL TP" } else { "" };
        shorten(format!("{} {}{of_position}", self.kind, self.axis).trim())
    }

    /// The word that stands for the measured value where nothing was measured along the axis.
    pub(super) fn not_measured(&self) -> Option<&str> {
        let is_none = self.actual.eq_ignore_ascii_case("nan");
        is_none.then_some(self.actual.as_str())
    }

    /// The figures, in mm or in the unit that the user has said.
    ///
    /// # Errors
    /// A figure that is missing or cannot be read.
    pub(super) fn figures(&self, unit: Option<Unit>) -> Result<Figures, ImportErrorKind> {
        let unit = unit.unwrap_or(Unit::Millimetre);
        let read = |column: &str, text: &str| {
            Printed::read(text.trim_start_matches('+'), unit)
                .map_err(|reason| ImportErrorKind::from(PrintedFault::Number { column: column.to_owned(), reason }))
        };
        let some = |column: &str, text: &str| {
            let has_text = !text.is_empty() && !text.eq_ignore_ascii_case("nan");
            has_text.then(|| read(column, text)).transpose()
        };
        if self.actual.is_empty() {
            return Err(PrintedFault::NoValue { column: ACTUAL }.into());
        }
        Ok(Figures {
            nominal: read(&self.kind, &self.nominal)?,
            measured: read(ACTUAL, &self.actual)?,
            tolerance: some(TOLERANCE, &self.tolerance)?,
            deviation: some(DEVIATION, &self.deviation)?,
        })
    }
}
