//! A row: a characteristic with its value.

use fitcheck_core::length::{Length, LengthError, Unit};
use fitcheck_core::probing::cycle::Axis;

use super::columns::{Column, Columns};
use super::error::{CalypsoFault, CalypsoWarning};
use crate::exchange::characteristic::{Characteristic, CharacteristicKind, Value};
use crate::exchange::claim::Claim;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use crate::exchange::imported::WhyUnjudged;
use crate::exchange::quantity::Quantity;
use crate::exchange::{Labels, units};

/// The word of a diameter; it stands under `type` or under `idsymbol`.
const DIAMETER: &str = "diameter";

/// The word for how far a value is out of its limits.
const EXCEED: &str = "exceed";

/// Words of lengths that are the size of nothing: how they begin, in small letters.
const LENGTHS: [&str; 18] = [
    "radius",
    "distance",
    "length",
    "width",
    "depth",
    "height",
    "flatness",
    "straightness",
    "roundness",
    "cylindricity",
    "parallelism",
    "perpendicularity",
    "position",
    "concentricity",
    "coaxiality",
    "symmetry",
    "runout",
    "profile",
];

/// The length that a word means, besides a diameter; angles and everything unknown are none.
fn length(word: &str) -> Option<Quantity> {
    let small = word.to_lowercase();
    Some(match small.as_str() {
        "xvalue" => Quantity::Coordinate(Axis::First),
        "yvalue" => Quantity::Coordinate(Axis::Second),
        "zvalue" => Quantity::Coordinate(Axis::Third),
        _ => LENGTHS.iter().any(|known| small.starts_with(known)).then_some(Quantity::Length)?,
    })
}

/// What was read.
#[derive(Debug)]
pub(super) struct CalypsoRow {
    pub(super) characteristic: Characteristic,
    /// None where the cell of the actual value is empty.
    pub(super) value: Option<Value>,
    /// Whether no unit is given.
    pub(super) is_unit_assumed: bool,
    /// Whether the value had figures beyond the nanometre.
    pub(super) is_rounded: bool,
    deviation: Option<Length>,
    exceed: Option<Length>,
}

/// Why a row is not used.
pub(super) struct RefusedRow<'t> {
    pub(super) kind: ImportErrorKind,
    /// The number of the cell.
    pub(super) column: Option<usize>,
    pub(super) given: &'t str,
}

/// The cells of a row, in a unit.
struct CalypsoCells<'a, 't> {
    columns: &'a Columns,
    texts: Vec<&'t str>,
    unit: Unit,
}

impl CalypsoRow {
    /// Reads a row.
    pub(super) fn read<'t>(
        line: usize,
        text: &'t str,
        columns: &Columns,
        given: Option<Unit>,
    ) -> Result<Self, RefusedRow<'t>> {
        let mut cells: Vec<&str> = text.split('\t').collect();
        // A tab at the end makes a cell that is none.
        while columns.count < cells.len() && cells.last().is_some_and(|cell| cell.trim().is_empty()) {
            cells.pop();
        }
        if columns.count < cells.len() {
            let kind = ImportErrorKind::RowLong { found: cells.len(), expected: columns.count };
            return Err(RefusedRow { kind, column: None, given: text });
        }
        let symbol = columns.text(&cells, Column::Symbol);
        let short = columns.text(&cells, Column::Type);
        let is_diameter = [symbol, short].iter().any(|text| text.eq_ignore_ascii_case(DIAMETER));
        let (unit, is_unit_assumed) = match columns.text(&cells, Column::Unit) {
            "" => (Some(given.unwrap_or(Unit::Millimetre)), given.is_none()),
            unit => (units::known(unit), false),
        };
        let actual = Some(columns.text(&cells, Column::Actual)).filter(|actual| !actual.is_empty());
        let Some(unit) = unit else {
            let unit = columns.text(&cells, Column::Unit);
            let (column, _) = columns.named(Column::Unit);
            return Err(RefusedRow { kind: ImportErrorKind::Unit { unit: shorten(unit) }, column, given: unit });
        };
        let cells = CalypsoCells { columns, texts: cells, unit };
        let parsed = actual.map(|actual| cells.parse(actual)).transpose();
        let measured = parsed.map_err(|reason| cells.refused(Column::Actual, reason))?;
        let nominal = cells.length(Column::Nominal)?;
        let limit = |column| -> Result<Option<Length>, RefusedRow<'t>> {
            let Some((nominal, deviation)) = nominal.zip(cells.length(column)?) else { return Ok(None) };
            let too_large = || LengthError::TooLarge { text: cells.text(column).to_owned() };
            nominal.checked_add(deviation).map(Some).ok_or_else(|| cells.refused(column, too_large()))
        };
        let word = if symbol.is_empty() { short } else { symbol };
        let place = [Column::X, Column::Y, Column::Z].map(|column| cells.length(column));
        let [x, y, z] = place;
        let labels = Labels {
            part: cells.text(Column::Plan).to_owned(),
            serial: cells.text(Column::Part).to_owned(),
            place: [x?, y?, z?],
            quantity: if is_diameter { Some(Quantity::Diameter) } else { length(word) },
            // The table has no column for it.
            is_axis_assumed: true,
            ..Labels::default()
        };
        let characteristic = Characteristic {
            name: cells.text(Column::Id).to_owned(),
            what: match &labels.quantity {
                Some(Quantity::Diameter) => CharacteristicKind::Size,
                Some(_) => CharacteristicKind::Length(WhyUnjudged::NotASize { what: shorten(word) }),
                None => CharacteristicKind::Other(shorten(word)),
            },
            class: String::new(),
            feature: None,
            nominal,
            minimum: limit(Column::Lower)?,
            maximum: limit(Column::Upper)?,
            expanded: None,
            labels: Labels { serial: String::new(), ..labels.clone() },
        };
        let deviation = cells.length(Column::Deviation)?;
        let exceed = cells.length(Column::Exceed)?;
        let out = exceed.filter(|exceed| *exceed != Length::ZERO);
        let claims =
            out.map(|_| Claim::out(&format!("{} {}", EXCEED, cells.text(Column::Exceed)))).into_iter().collect();
        let labels = Labels { claims, ..labels };
        let is_rounded = measured.is_some_and(|(_, is_rounded)| is_rounded);
        let value = measured.map(|(measured, _)| Value { line, measured, time: None, labels, is_simulated: false });
        Ok(Self { characteristic, value, is_unit_assumed, is_rounded, deviation, exceed })
    }

    /// What the table says of the value, and its own figures do not.
    pub(super) fn doubts(&self, measured: Length) -> Vec<CalypsoWarning> {
        let Characteristic { nominal, minimum, maximum, .. } = self.characteristic;
        let mut doubts = Vec::new();
        if let Some((given, nominal)) = self.deviation.zip(nominal) {
            let expected = measured.saturating_sub(nominal);
            if is_another(given, expected) {
                doubts.push(CalypsoWarning::Deviation { given, expected });
            }
        }
        // An empty cell is one of a value within its tolerance.
        let given = self.exceed.unwrap_or(Length::ZERO);
        if let Some((minimum, maximum)) = minimum.zip(maximum).filter(|(minimum, maximum)| minimum <= maximum) {
            let expected = if maximum < measured {
                measured.saturating_sub(maximum)
            } else if measured < minimum {
                measured.saturating_sub(minimum)
            } else {
                Length::ZERO
            };
            if is_another(given, expected) {
                doubts.push(CalypsoWarning::Exceed { given, expected });
            }
        }
        doubts
    }
}

/// Whether a length is another one, beyond what rounding to the nanometre makes.
fn is_another(given: Length, expected: Length) -> bool {
    2 < given.saturating_sub(expected).nanometres().unsigned_abs()
}

impl<'t> CalypsoCells<'_, 't> {
    fn text(&self, column: Column) -> &'t str {
        self.columns.text(&self.texts, column)
    }

    fn parse(&self, text: &str) -> Result<(Length, bool), LengthError> {
        Length::parse_rounded(text, self.unit)
    }

    /// A length, rounded to the nanometre; `None` where the cell is empty.
    fn length(&self, column: Column) -> Result<Option<Length>, RefusedRow<'t>> {
        let text = self.text(column);
        if text.is_empty() {
            return Ok(None);
        }
        self.parse(text).map(|(length, _)| Some(length)).map_err(|reason| self.refused(column, reason))
    }

    fn refused(&self, column: Column, reason: LengthError) -> RefusedRow<'t> {
        let given = self.text(column);
        let (at, column) = self.columns.named(column);
        RefusedRow { kind: CalypsoFault::Number { column, reason }.into(), column: at, given }
    }
}
