//! Figures of plain rows: a number of a cell, and what limits in columns of their own make of several.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::tolerance::Deviations;

use crate::exchange::column::LengthColumn;
use crate::exchange::limits::LimitColumns;
use crate::exchange::row::{Part, TextRow};

/// A cell that is a plain number, and its decimal sign.
#[expect(clippy::inline_always, reason = "its answer stays in registers, for each of millions of rows")]
#[inline(always)]
pub(super) fn number(row: &TextRow<'_>, (at, unit): (usize, Unit)) -> Option<(Length, Option<u8>)> {
    let part = row.part(at)?;
    part.number(unit).or_else(|| wrapped_number(part, unit))
}

/// A number in quotation marks or between blanks.
#[cold]
fn wrapped_number(part: Part<'_>, unit: Unit) -> Option<(Length, Option<u8>)> {
    part.plain()?.number(unit)
}

/// A number that may have a sign.
#[inline]
fn signed(row: &TextRow<'_>, column: LengthColumn, said: Option<Unit>) -> Option<Length> {
    let unit = said.unwrap_or(column.unit);
    match row.cell(column.at)? {
        [sign @ (b'+' | b'-'), ..] => {
            let (length, _) = row.part(column.at)?.split(1).1.number(unit)?;
            Some(if *sign == b'-' { length.negated() } else { length })
        }
        _ => Some(number(row, (column.at, unit))?.0),
    }
}

/// The nominal size and the deviations of a row by its limits.
#[inline]
pub(super) fn bounds_of(
    row: &TextRow<'_>,
    limits: &LimitColumns,
    nominal: Option<Length>,
    said: Option<Unit>,
) -> Option<(Length, Deviations)> {
    let upper = signed(row, limits.upper?, said)?;
    let lower = signed(row, limits.lower?, said)?;
    limits.bounds(nominal, [upper, lower])
}
