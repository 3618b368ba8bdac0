//! What changes the system that coordinates count in.

use super::super::change::Change;
use super::super::fault::FaultKind;
use super::super::presets::{PresetRow, row_number};
use super::super::remark::Remark;
use super::datum::Tilt;
use super::{Around, ChangingBlock, is_other, millimetres};
use crate::program::{Axis, AxisWord, Frame, Operand, Unit};

/// The value of an operand in a block; not a number where nobody knows it: it is then never neutral, and no zero.
type ValueOf<'a> = dyn Fn(Operand) -> Result<f64, FaultKind> + 'a;

impl Around {
    /// Rotary axes of a move, or of a shift: at zero they change nothing. A move along U, V or W may bring another workpiece.
    pub(in crate::machine) fn turn(&mut self, axes: &[AxisWord], value: &ValueOf<'_>) {
        for word in axes {
            if matches!(word.axis, Axis::U | Axis::V | Axis::W) {
                self.stops += 1;
            }
            if matches!(word.axis, Axis::A | Axis::B | Axis::C) {
                let is_zero = !word.is_incremental && value(word.value).is_ok_and(|value| value.abs() < 1e-9);
                if is_zero && !self.held.contains(&word.axis) {
                    self.turned.remove(&word.axis);
                } else {
                    self.turned.insert(word.axis);
                }
            }
        }
    }

    /// An axis that a cycle has turned and that does not count as zero there; moving it to zero turns the part back, which nobody measures.
    pub(in crate::machine) fn leave_turned(&mut self, axis: Axis) {
        self.turned.insert(axis);
        self.held.insert(axis);
    }

    /// Changes the system; `made` is the block.
    pub(in crate::machine) fn change(
        &mut self,
        frame: &Frame,
        made: ChangingBlock,
        unit: Option<Unit>,
        value: &ValueOf<'_>,
    ) -> Result<Option<Remark>, FaultKind> {
        let is_not = |operand: Operand, neutral: f64| Ok::<_, FaultKind>(is_other(value(operand)?, neutral));
        match frame {
            Frame::Title => {}
            Frame::Shift(axes) => self.shift_by(axes, unit, value)?,
            Frame::NoShift => self.end_shifts(made),
            Frame::ShiftFromTable => self.set(Change::DatumTable, true, made),
            Frame::Preset(number) => {
                let number = number.map(value).transpose()?;
                return Ok(self.activate(number, None, made));
            }
            Frame::Rotation { angle, is_incremental } => {
                // A whole turn is none.
                let is_turned = is_other(value(*angle)? % 360.0, 0.0);
                let stays = *is_incremental && self.changes.contains_key(&Change::Rotation);
                if !stays {
                    self.set(Change::Rotation, is_turned, made);
                }
            }
            Frame::Mirror(axes) => self.set(Change::Mirror, !axes.is_empty(), made),
            Frame::Scaling(factor) => self.set(Change::Scaling, is_not(*factor, 1.0)?, made),
            Frame::AxisScaling(factors) => {
                let changed: Result<Vec<bool>, _> = factors.iter().map(|factor| is_not(*factor, 1.0)).collect();
                self.set(Change::AxisScaling, changed?.contains(&true), made);
            }
            Frame::Tilt { angles, axes_stay } => {
                let mut tilt = [0.0; 3];
                for word in angles {
                    let [a, b, c] = &mut tilt;
                    *match word.axis {
                        Axis::A => a,
                        Axis::B => b,
                        _ => c,
                    } = value(word.value)?;
                }
                self.tilt(tilt, *axes_stay, made);
            }
            Frame::OtherTilt => {
                self.end_tilt(&made);
                self.turned.extend([Axis::A, Axis::B, Axis::C]);
                self.set(Change::Tilt, true, made);
            }
            Frame::NoTilt => self.end_tilt(&made),
            Frame::TurnedBack => {
                self.end_tilt(&made);
                self.turned.clone_from(&self.held);
            }
            Frame::NotFollowed => {
                self.lose_system(|| made);
                return Ok(Some(Remark::NotFollowed));
            }
        }
        Ok(None)
    }

    /// Tilts the plane by spatial angles; all 0 ends a tilt. Where the axes do not stay they turn as the plane needs it.
    fn tilt(&mut self, angles: [f64; 3], axes_stay: bool, made: ChangingBlock) {
        self.end_tilt(&made);
        if !axes_stay {
            self.turned.clone_from(&self.held);
        }
        if angles.iter().any(|angle| is_other(*angle, 0.0)) {
            if axes_stay {
                self.turned.extend([Axis::A, Axis::B, Axis::C]);
            }
            self.tilt = Some(Tilt { angles, shift: [0.0; 3], set_by: made.into() });
        }
    }

    /// The end of a tilt does not turn the axes back.
    fn end_tilt(&mut self, made: &ChangingBlock) {
        self.set(Change::Tilt, false, made.clone());
        if let Some(tilt) = self.tilt.take() {
            self.turned.extend([Axis::A, Axis::B, Axis::C]);
            let is_shifted = tilt.shift.iter().any(|by| is_other(*by, 0.0));
            if is_shifted {
                self.set(Change::TiltedShift, true, made.clone());
            }
        }
    }

    /// A block was not run that may have set a datum, a rotation or whatever else: nothing ends that, because a preset or datum table
    /// may be what it has written.
    pub(in crate::machine) fn lose_system(&mut self, made: impl FnOnce() -> ChangingBlock) {
        self.changes.entry(Change::NotKnown).or_insert_with(made);
    }

    /// Cycle 800 turns the system for turning, 801 ends that.
    pub(in crate::machine) fn turning(&mut self, number: u32, made: ChangingBlock) {
        match number {
            800 => self.set(Change::Turning, true, made),
            801 => self.set(Change::Turning, false, made),
            _ => {}
        }
    }

    fn set(&mut self, change: Change, is_in_force: bool, made: ChangingBlock) {
        if is_in_force {
            self.changes.insert(change, made);
        } else {
            self.changes.remove(&change);
        }
    }

    /// Ends the shift of the plane in force; what of one before a tilt is left then is not known.
    fn end_shifts(&mut self, made: ChangingBlock) {
        let before = std::mem::take(&mut self.shift);
        self.changes.remove(&Change::DatumTable);
        self.changes.remove(&Change::TiltedShift);
        if let Some(tilt) = &mut self.tilt {
            tilt.shift = [0.0; 3];
            let is_shifted = before.iter().any(|by| is_other(*by, 0.0));
            self.set(Change::TiltedShift, is_shifted, made);
        }
    }

    /// A shift in a tilted plane is one along its axes.
    fn shift_by(&mut self, axes: &[AxisWord], unit: Option<Unit>, value: &ValueOf<'_>) -> Result<(), FaultKind> {
        for word in axes {
            let by = value(word.value)? * millimetres(unit);
            let [x, y, z] = self.tilt.as_mut().map_or(&mut self.shift, |tilt| &mut tilt.shift);
            let zero = match word.axis {
                Axis::X => x,
                Axis::Y => y,
                Axis::Z => z,
                Axis::A | Axis::B | Axis::C | Axis::U | Axis::V | Axis::W => continue,
            };
            *zero = if word.is_incremental { *zero + by } else { by };
        }
        self.turn(axes, value);
        // A shift that is written takes the place of one from a table in the axes that it names.
        let is_written = |axis| axes.iter().any(|word| word.axis == axis && !word.is_incremental);
        if [Axis::X, Axis::Y, Axis::Z].into_iter().all(is_written) && self.tilt.is_none() {
            self.changes.remove(&Change::DatumTable);
            self.changes.remove(&Change::TiltedShift);
        }
        Ok(())
    }

    /// Cycle 247: shift, rotation, mirror and scaling end. The zero is that of the row, as far as cycles have written it or the preset table
    /// has it; else the workpiece lies there.
    pub(in crate::machine) fn activate(
        &mut self,
        number: Option<f64>,
        table: Option<PresetRow>,
        made: ChangingBlock,
    ) -> Option<Remark> {
        let is_other = self.preset.is_some() && self.preset != number;
        // A preset that is not named may be any.
        self.stops += u64::from(number.is_none());
        self.shift = [0.0; 3];
        if let Some(tilt) = &mut self.tilt {
            tilt.shift = [0.0; 3];
        }
        let [is_known, is_moved] = self.datum.activate(number.and_then(row_number), table, &made);
        let stays =
            |change: &Change| matches!(change, Change::Tilt | Change::NotKnown | Change::Turning | Change::AxisTurned);
        self.changes.retain(|change, _| stays(change));
        if is_moved {
            self.set(Change::AxisTurned, true, made.clone());
            self.not_set = [true; 2];
        }
        self.set(Change::Rotation, table.is_some_and(|row| row.is_tilted), made);
        self.preset = number.or(self.preset);
        number.filter(|_| is_other && !is_known).map(|number| Remark::OtherPreset { number: number.to_string() })
    }
}
