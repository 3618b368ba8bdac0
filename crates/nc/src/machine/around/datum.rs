//! The datum: where the zero of the active preset lies, and what cycles and cycle 247 make of it.
//!
//! All places count from the zero in which the workpiece is given, which is that of the preset that is active first. What a datum cycle
//! writes is kept for the run, and written into the preset table where the program's folders have one (`docs/SOURCES.md`, "Datum cycles"):
//!
//! | target | what happens | how sure |
//! |---|---|---|
//! | the display (Q305 = 0) | the measured place gets its coordinates, the shift ends, the datum is that of row 0 | TNC7; an iTNC 530 may keep the shift |
//! | a row of the preset table | acts with cycle 247 of that row; at once where the row is active | the latter TNC 640 and TNC7, from memory |
//! | the active preset (Q1120) | as a row that is active; where no block has named it, as the display | from memory |
//! | a row of the datum table | refused: that table is on the control only | |

use std::collections::BTreeMap;

use fitcheck_core::length::Length;
use fitcheck_core::message::Arg;
use fitcheck_core::probing::cycle::{Axis, DatumAxis, DatumTarget, NewDatum, Plane};

use super::super::fault::FaultKind;
use super::super::presets::PresetRow;
use super::super::remark::Remark;
use super::{Around, ChangingBlock};

/// The axes of the machine.
const NAMES: [&str; 3] = ["X", "Y", "Z"];

/// A row of the preset table as far as cycles have written it.
type Row = [Option<Length>; 3];

/// Such a row, and what has written it last.
#[derive(Debug, Clone, Default)]
struct Written {
    zero: Row,
    by: Option<SetBy>,
}

/// Where the zero of the preset is, and the rows that cycles have written.
#[derive(Debug, Default)]
pub(super) struct Datum {
    origin: [Length; 3],
    rows: BTreeMap<u32, Written>,
    /// The zero of the workpiece from that of the machine, once a row of the preset table was active.
    base: Row,
    set_by: Option<SetBy>,
}

/// What a datum comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SetBy {
    /// Its line in its program, from 1.
    pub line: usize,
    /// The first line of its block.
    pub text: String,
}

/// The datum that a measurement counts from, where a cycle has set it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DatumInForce {
    /// Where its zero is in the coordinates of the workpiece; without a shift.
    pub zero: [Length; 3],
    pub set_by: SetBy,
}

/// Where the zero of the preset comes to in one axis: the place without the shift gets the coordinate. `None` where it was not measured.
fn moved(of: Option<DatumAxis>, origin: Length, shift: Length) -> Option<Length> {
    let DatumAxis { measured, wanted, .. } = of?;
    Some(plus(origin, plus(measured, shift).saturating_sub(wanted)))
}

fn plus(one: Length, other: Length) -> Length {
    one.saturating_sub(other.negated())
}

/// The axes of the machine, as the tool axis makes them the axes of a cycle.
fn by_machine_axis(axes: &[DatumAxis], plane: Plane) -> [Option<DatumAxis>; 3] {
    let [first, second, third] = [Axis::First, Axis::Second, Axis::Third]
        .map(|wanted| axes.iter().copied().find(|measured| measured.axis == wanted));
    match plane {
        Plane::Xy => [first, second, third],
        Plane::Zx => [second, third, first],
        Plane::Yz => [third, first, second],
    }
}

/// `X 50.12, Y 29.93`, of the axes that have a value.
fn named(row: Row) -> Arg {
    let named = NAMES.into_iter().zip(row).filter_map(|(name, at)| Some(format!("{name} {}", at?)));
    Arg::Number(named.collect::<Vec<_>>().join(", "))
}

impl Datum {
    pub(super) fn origin(&self) -> [f64; 3] {
        self.origin.map(Length::to_mm_f64)
    }

    /// Cycle 247: the row that a cycle has written, the one of the preset table, or the zero of the workpiece. Says whether all of it is
    /// known.
    pub(super) fn activate(&mut self, number: Option<u32>, table: Option<PresetRow>) -> bool {
        let written = number.and_then(|row| self.rows.get(&row)).cloned();
        let from_table = self.row_of(table);
        // The workpiece lies at the row that is active first.
        let lies = table.filter(|_| written.is_none()).map_or([None; 3], |row| row.zero);
        for (base, lies) in self.base.iter_mut().zip(lies) {
            *base = base.or(lies);
        }
        let zero = written.as_ref().map(|written| written.zero).or(from_table);
        self.origin = zero.unwrap_or_default().map(Option::unwrap_or_default);
        self.set_by = written.and_then(|written| written.by);
        zero.is_some_and(|axes| axes.iter().all(Option::is_some))
    }

    /// Where the zero of a row of the preset table is, in the axes in which one was active before.
    fn row_of(&self, table: Option<PresetRow>) -> Option<Row> {
        let [x, y, z] = table?.zero;
        let [base_x, base_y, base_z] = self.base;
        Some([(x, base_x), (y, base_y), (z, base_z)].map(|(at, base)| Some(at?.saturating_sub(base?))))
    }

    /// A zero as the preset table has it, from that of the machine.
    fn in_table(&self, zero: Row) -> Row {
        let [base_x, base_y, base_z] = self.base;
        let [x, y, z] = zero;
        [(x, base_x), (y, base_y), (z, base_z)].map(|(at, base)| Some(plus(at?, base?)))
    }
}

impl Around {
    /// The datum in force, where a cycle has set it.
    pub(in crate::machine) fn datum(&self) -> Option<DatumInForce> {
        let set_by = self.datum.set_by.clone()?;
        Some(DatumInForce { zero: self.datum.origin, set_by })
    }

    /// Sets what a cycle has found, for a row that the preset table may have or for the display, which is row 0: what is to be said of it,
    /// and what is written into that row.
    ///
    /// # Errors
    /// [`FaultKind`] where it is not known what a control would do.
    pub(in crate::machine) fn set_datum(
        &mut self,
        new: &NewDatum,
        (row, table): (Option<u32>, Option<PresetRow>),
        made: ChangingBlock,
    ) -> Result<(Vec<Remark>, Row), FaultKind> {
        let in_range = |mm: f64| Length::from_mm_f64(mm).map_err(|_length| FaultKind::BeyondRange(mm));
        let [by_x, by_y, by_z] = self.shift.map(in_range);
        let shift = [by_x?, by_y?, by_z?];
        let [x, y, z] = by_machine_axis(&new.axes, self.plane());
        let ([to_x, to_y, to_z], [by_x, by_y, by_z]) = (self.datum.origin, shift);
        let moved = [moved(x, to_x, by_x), moved(y, to_y, by_y), moved(z, to_z, by_z)];
        let by = Some(SetBy { line: made.line, text: made.text });
        let is_display = row.is_none();
        let row = row.unwrap_or(0);
        let is_active = self.preset.is_some_and(|active| (active - f64::from(row)).abs() <= 0.0);
        if !is_display && !is_active {
            let from_table = self.datum.row_of(table).unwrap_or_default();
            let fresh = || Written { zero: from_table, by: None };
            let written = self.datum.rows.entry(row).or_insert_with(fresh);
            for (axis, moved) in written.zero.iter_mut().zip(moved) {
                *axis = moved.or(*axis);
            }
            written.by = by;
            return Ok((vec![Remark::PresetSet { row, zero: named(moved) }], self.datum.in_table(moved)));
        }
        if !is_display && shift.iter().any(|shift| *shift != Length::ZERO) {
            return Err(FaultKind::ShiftedPreset { row });
        }
        let mut remarks = self.end_shift(&moved, shift);
        for (axis, moved) in self.datum.origin.iter_mut().zip(moved) {
            *axis = moved.unwrap_or(*axis);
        }
        let zero = self.datum.origin.map(Some);
        self.datum.rows.insert(row, Written { zero, by: by.clone() });
        self.datum.set_by = by;
        self.preset = Some(f64::from(row));
        let said = named(zero);
        // The controls that correct the active preset by a cycle do so at once.
        remarks.push(if is_display || new.target == DatumTarget::Active {
            Remark::DatumSet { zero: said }
        } else {
            Remark::ActivePresetSet { row, zero: said }
        });
        Ok((remarks, self.datum.in_table(zero)))
    }

    /// The display is set: the shift ends in all axes. Those that were measured read what is wanted all the same.
    fn end_shift(&mut self, moved: &Row, shift: [Length; 3]) -> Vec<Remark> {
        self.shift = [0.0; 3];
        let lost = NAMES.into_iter().zip(moved).zip(shift);
        let lost = lost.filter(|((_, moved), shift)| moved.is_none() && *shift != Length::ZERO);
        let axes: Vec<&str> = lost.map(|((name, _), _)| name).collect();
        let axes = axes.join(", ");
        if axes.is_empty() { Vec::new() } else { vec![Remark::ShiftEnded { axes }] }
    }
}
