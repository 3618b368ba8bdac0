//! What cycles make of the datum: a new zero, a basic rotation, a part that a rotary axis has turned.

use fitcheck_core::length::Length;
use fitcheck_core::message::Arg;
use fitcheck_core::probing::Orientation;
use fitcheck_core::probing::cycle::{Angle, Axis, DatumAxis, DatumTarget, NewDatum, Plane};
use fitcheck_core::probing::vector::along;

use super::super::change::Change;
use super::super::fault::FaultKind;
use super::super::presets::{PresetRow, TableRow};
use super::super::remark::Remark;
use super::datum::{Datum, DatumInForce, Row, Turn, Written, in_range, plus};
use super::{Around, ChangingBlock, is_other};

/// The axes of the machine.
const NAMES: [&str; 3] = ["X", "Y", "Z"];

fn sum(one: [Length; 3], [x, y, z]: [Length; 3]) -> [Length; 3] {
    let [to_x, to_y, to_z] = one;
    [plus(to_x, x), plus(to_y, y), plus(to_z, z)]
}

/// A vector in axes that are turned; exact where they are not.
fn out(axes: Orientation, vector: [Length; 3]) -> Result<[Length; 3], FaultKind> {
    if axes.is_level() {
        return Ok(vector);
    }
    let [x, y, z] = axes.out(vector.map(Length::to_mm_f64)).map(in_range);
    Ok([x?, y?, z?])
}

/// How far the zero moves in one axis: the place without the shift gets the coordinate. `None` where it was not measured.
fn moved(of: Option<DatumAxis>, shift: Length) -> Option<Length> {
    let DatumAxis { measured, wanted, .. } = of?;
    Some(plus(measured, shift).saturating_sub(wanted))
}

/// The axes of the machine, as the tool axis makes them the axes of a cycle.
fn by_machine_axis(axes: &[DatumAxis], plane: Plane) -> [Option<DatumAxis>; 3] {
    let of = [Axis::First, Axis::Second, Axis::Third]
        .map(|wanted| axes.iter().copied().find(|measured| measured.axis == wanted));
    let [first, second, third] = of;
    match plane {
        Plane::Xy => of,
        Plane::Zx => [second, third, first],
        Plane::Yz => [third, first, second],
    }
}

/// `X 50.12, Y 29.93`, of the axes that have a value.
fn named(row: Row) -> Arg {
    let named = NAMES.into_iter().zip(row).filter_map(|(name, at)| Some(format!("{name} {}", at?)));
    Arg::Number(named.collect::<Vec<_>>().join(", "))
}

/// An angle as remarks say it.
fn shown(degrees: f64) -> Arg {
    Arg::Number(Angle::nearest(degrees).to_string())
}

impl Around {
    /// The datum in force, where a cycle has set it or a block has turned it.
    pub(in crate::machine) fn datum(&self) -> Option<DatumInForce> {
        let Datum { origin, turned, ref set_by, ref turned_by, .. } = self.datum;
        let rotation = turned_by.clone().map(|set_by| Turn { degrees: [turned], set_by });
        let tilt = self.tilt.as_ref().map(|tilt| Turn { degrees: tilt.angles, set_by: tilt.set_by.clone() });
        let is_set = set_by.is_some() || rotation.is_some() || tilt.is_some();
        is_set.then(|| DatumInForce { zero: origin, set_by: set_by.clone(), rotation, tilt })
    }

    /// The basic rotation in force, degrees.
    pub(in crate::machine) fn basic_rotation(&self) -> f64 {
        self.datum.basic_rotation()
    }

    pub(in crate::machine) const fn is_tilted(&self) -> bool {
        self.tilt.is_some()
    }

    /// The spatial angles of the tilted plane, degrees; all 0 where none is.
    pub(in crate::machine) fn tilted(&self) -> [f64; 3] {
        self.tilt.as_ref().map_or([0.0; 3], |tilt| tilt.angles)
    }

    /// A place of the workpiece from the zero of the machine; where no preset table has said where that is, from that of the workpiece.
    pub(in crate::machine) fn in_machine(&self, place: [f64; 3]) -> [f64; 3] {
        let base = self.datum.base.map(|base| base.map_or(0.0, Length::to_mm_f64));
        along(self.datum.base_axes().out(place), base, 1.0)
    }

    /// Whether a preset table has said where the zero of the machine is.
    pub(in crate::machine) fn knows_machine_zero(&self) -> bool {
        self.datum.base.iter().all(Option::is_some)
    }

    /// Ends the basic rotation, as measuring cycles do: what is to be said of it, where there was one.
    pub(in crate::machine) fn end_rotation(&mut self, made: ChangingBlock) -> Option<Remark> {
        let was = self.datum.basic_rotation();
        if !is_other(was, 0.0) {
            return None;
        }
        let plane = self.datum.plane;
        self.datum.turn(0.0, plane, made.into());
        Some(Remark::RotationEnded { angle: shown(was) })
    }

    /// Sets a basic rotation that a cycle has found; what is written into the preset table.
    pub(in crate::machine) fn set_rotation(&mut self, degrees: f64, row: Option<u32>, made: ChangingBlock) -> TableRow {
        let is_display = row.is_none();
        let row = row.unwrap_or(0);
        // A cycle that has ended the rotation before it measured counts from none.
        let degrees = self.datum.basic_rotation() + degrees;
        if is_display || self.is_active(row) {
            let plane = self.plane();
            self.datum.turn(degrees, plane, made.into());
            self.keep_active(row);
        } else {
            let fresh = || Written { zero: [None; 3], turned: None, by: None };
            let written = self.datum.rows.entry(row).or_insert_with(fresh);
            written.turned = Some(degrees);
            written.by = Some(made.into());
        }
        TableRow { zero: [None; 3], turned: Some(degrees) }
    }

    /// The part was turned by a rotary axis, about a place that only the machine knows: that counts as the active zero, and nothing is
    /// judged until both axes of the plane have a datum again.
    pub(in crate::machine) fn turn_part(&mut self, degrees: f64, made: ChangingBlock) {
        let basic = self.datum.basic_rotation();
        let plane = self.plane();
        let datum = &mut self.datum;
        datum.base_turned = Some(datum.base_turned() - degrees);
        datum.base = [None; 3];
        datum.rows.clear();
        datum.is_moved = true;
        datum.turn(basic, plane, made.clone().into());
        self.not_set = [true; 2];
        self.changes.insert(Change::AxisTurned, made);
    }

    fn is_active(&self, row: u32) -> bool {
        self.preset.is_some_and(|active| (active - f64::from(row)).abs() <= 0.0)
    }

    /// The datum in force is that of this row from here on.
    fn keep_active(&mut self, row: u32) {
        let turned = Some(self.datum.basic_rotation());
        let written = Written { zero: self.datum.origin.map(Some), turned, by: self.datum.set_by.clone() };
        self.datum.rows.insert(row, written);
        self.preset = Some(f64::from(row));
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
    ) -> Result<(Vec<Remark>, TableRow), FaultKind> {
        if let Some(tilt) = &self.tilt {
            return Err(FaultKind::DatumInTilt { line: tilt.set_by.line, text: tilt.set_by.text.clone() });
        }
        let [by_x, by_y, by_z] = self.shift.map(in_range);
        let shift = [by_x?, by_y?, by_z?];
        let [x, y, z] = by_machine_axis(&new.axes, self.plane());
        let [by_x, by_y, by_z] = shift;
        let by = [moved(x, by_x), moved(y, by_y), moved(z, by_z)];
        let rotation = self.datum.rotation();
        let zero = sum(self.datum.origin, out(rotation, by.map(Option::unwrap_or_default))?);
        let is_display = row.is_none();
        let row = row.unwrap_or(0);
        if !is_display && !self.is_active(row) {
            // Only the axes that were measured are written.
            let ([to_x, to_y, to_z], [by_x, by_y, by_z]) = (zero, by);
            let measured = [(to_x, by_x), (to_y, by_y), (to_z, by_z)].map(|(to, by)| by.map(|_| to));
            let from_table = self.datum.row_of(table).unwrap_or_default();
            let fresh = || Written { zero: from_table, turned: None, by: None };
            let written = self.datum.rows.entry(row).or_insert_with(fresh);
            for (axis, measured) in written.zero.iter_mut().zip(measured) {
                *axis = measured.or(*axis);
            }
            written.by = Some(made.into());
            let written = TableRow { zero: self.datum.in_table(measured), turned: None };
            return Ok((vec![Remark::PresetSet { row, zero: named(measured) }], written));
        }
        if !is_display && shift.iter().any(|shift| *shift != Length::ZERO) {
            return Err(FaultKind::ShiftedPreset { row });
        }
        let mut remarks = self.end_shift(&by, shift);
        self.datum.origin = zero;
        self.datum.set_by = Some(made.into());
        self.keep_active(row);
        self.found_again(&new.axes);
        let said = named(zero.map(Some));
        // The controls that correct the active preset by a cycle do so at once.
        remarks.push(if is_display || new.target == DatumTarget::Active {
            Remark::DatumSet { zero: said }
        } else {
            Remark::ActivePresetSet { row, zero: said }
        });
        let turned = Some(self.datum.basic_rotation());
        Ok((remarks, TableRow { zero: self.datum.in_table(zero.map(Some)), turned }))
    }

    /// Axes of the plane that have a datum again after the part was turned.
    fn found_again(&mut self, axes: &[DatumAxis]) {
        let [first, second] = &mut self.not_set;
        for DatumAxis { axis, .. } in axes {
            match axis {
                Axis::First => *first = false,
                Axis::Second => *second = false,
                Axis::Third => {}
            }
        }
        if self.not_set == [false; 2] {
            self.changes.remove(&Change::AxisTurned);
        }
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
