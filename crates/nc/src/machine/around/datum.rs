//! The datum: where the zero of the active preset lies and how its axes are turned, and what cycle 247 makes of it; `set` has what cycles do.
//!
//! All places count from the zero in which the workpiece is given, which is that of the preset that is active first, with its rotation. What
//! a datum cycle writes is kept for the run, and written into the preset table where the program's folders have one (`docs/SOURCES.md`,
//! "Datum cycles"):
//!
//! | target | what happens | how sure |
//! |---|---|---|
//! | the display (Q305 = 0) | the measured place gets its coordinates, the shift ends, the datum is that of row 0 | TNC7; an iTNC 530 may keep the shift |
//! | a row of the preset table | acts with cycle 247 of that row; at once where the row is active | the latter TNC 640 and TNC7, from memory |
//! | the active preset (Q1120) | as a row that is active; where no block has named it, as the display | from memory |
//! | a row of the datum table | refused: that table is on the control only | |
//!
//! A basic rotation goes the same ways; it turns the axes about the zero ("Angle and rotation").

use std::collections::BTreeMap;

use fitcheck_core::length::Length;
use fitcheck_core::probing::Orientation;
use fitcheck_core::probing::cycle::Plane;

use super::super::fault::FaultKind;
use super::super::presets::PresetRow;
use super::{ChangingBlock, is_other};

/// A zero as far as it is known.
pub(super) type Row = [Option<Length>; 3];

/// A row of the preset table as far as cycles have written it, and what has done so last.
#[derive(Debug, Clone, Default)]
pub(super) struct Written {
    pub zero: Row,
    /// Degrees against the axes of the machine.
    pub turned: Option<f64>,
    pub by: Option<SetBy>,
}

/// Where the zero of the preset is, and the rows that cycles have written.
#[derive(Debug, Default)]
pub(super) struct Datum {
    pub(super) origin: [Length; 3],
    pub(super) set_by: Option<SetBy>,
    /// How the axes are turned against those of the workpiece: degrees in a plane.
    pub(super) turned: f64,
    pub(super) plane: Plane,
    pub(super) turned_by: Option<SetBy>,
    pub(super) rows: BTreeMap<u32, Written>,
    /// The zero of the workpiece from that of the machine, once a row of the preset table was active.
    pub(super) base: Row,
    /// How the workpiece is turned against the axes of the machine, degrees: as the row of the preset table that was active first, and by
    /// rotary axes since.
    pub(super) base_turned: Option<f64>,
    /// Whether a rotary axis has turned the part: rows that no cycle has written since lie anywhere on it.
    pub(super) is_moved: bool,
}

/// What a datum comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SetBy {
    /// Its line in its program, from 1.
    pub line: usize,
    /// The first line of its block.
    pub text: String,
}

impl From<ChangingBlock> for SetBy {
    fn from(made: ChangingBlock) -> Self {
        Self { line: made.line, text: made.text }
    }
}

/// A tilted plane.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tilt {
    /// The spatial angles A, B and C, degrees.
    pub angles: [f64; 3],
    /// The shift of cycle 7 within it, mm.
    pub shift: [f64; 3],
    pub set_by: SetBy,
}

/// The system that a measurement counts in, where a block has set it.
#[derive(Debug, Clone, PartialEq)]
pub struct DatumInForce {
    /// Where its zero is in the coordinates of the workpiece; without a shift.
    pub zero: [Length; 3],
    /// The cycle that has set it.
    pub set_by: Option<SetBy>,
    /// How its axes are turned in the plane.
    pub rotation: Option<Turn<1>>,
    /// How its plane is tilted: A, B and C.
    pub tilt: Option<Turn<3>>,
}

/// Angles in degrees, and the block that has set them.
#[derive(Debug, Clone, PartialEq)]
pub struct Turn<const COUNT: usize> {
    pub degrees: [f64; COUNT],
    pub set_by: SetBy,
}

pub(super) fn plus(one: Length, other: Length) -> Length {
    one.saturating_sub(other.negated())
}

pub(super) fn in_range(mm: f64) -> Result<Length, FaultKind> {
    Length::from_mm_f64(mm).map_err(|_length| FaultKind::BeyondRange(mm))
}

impl Datum {
    pub(super) fn origin(&self) -> [f64; 3] {
        self.origin.map(Length::to_mm_f64)
    }

    /// How its axes lie in the workpiece.
    pub(super) fn rotation(&self) -> Orientation {
        if self.turned.abs() <= 0.0 { Orientation::default() } else { Orientation::in_plane(self.plane, self.turned) }
    }

    /// The basic rotation: how its axes are turned against those of the machine, degrees.
    pub(super) fn basic_rotation(&self) -> f64 {
        self.turned + self.base_turned()
    }

    pub(super) fn base_turned(&self) -> f64 {
        self.base_turned.unwrap_or_default()
    }

    /// Cycle 247: the row that a cycle has written, the one of the preset table, or the zero of the workpiece. Says whether all of it is
    /// known, and whether the part has moved since it was.
    pub(super) fn activate(
        &mut self,
        number: Option<u32>,
        table: Option<PresetRow>,
        made: &ChangingBlock,
    ) -> [bool; 2] {
        let written = number.and_then(|row| self.rows.get(&row)).cloned();
        let from_table = self.row_of(table);
        let in_table = table.and_then(|row| row.turned);
        // The workpiece lies at the row that is active first, and as that is turned.
        if written.is_none() {
            for (base, lies) in self.base.iter_mut().zip(table.map_or([None; 3], |row| row.zero)) {
                *base = base.or(lies);
            }
            self.base_turned = self.base_turned.or(in_table);
        }
        let zero = written.as_ref().map(|written| written.zero).or(from_table);
        self.origin = zero.unwrap_or_default().map(Option::unwrap_or_default);
        let of_row = written.as_ref().and_then(|written| written.turned).or(in_table);
        self.turn(of_row.unwrap_or_default(), Plane::Xy, made.clone().into());
        let is_moved = self.is_moved && written.is_none();
        self.set_by = written.and_then(|written| written.by);
        [zero.is_some_and(|axes| axes.iter().all(Option::is_some)), is_moved]
    }

    /// Turns the axes to an angle against those of the machine.
    pub(super) fn turn(&mut self, degrees: f64, plane: Plane, by: SetBy) {
        self.turned = degrees - self.base_turned();
        self.plane = plane;
        self.turned_by = is_other(self.turned, 0.0).then_some(by);
    }

    pub(super) fn base_axes(&self) -> Orientation {
        Orientation::in_plane(Plane::Xy, self.base_turned())
    }

    /// Where the zero of a row of the preset table is, in the axes in which one was active before.
    pub(super) fn row_of(&self, table: Option<PresetRow>) -> Option<Row> {
        let [x, y, z] = table?.zero;
        let [base_x, base_y, base_z] = self.base;
        let off = [(x, base_x), (y, base_y), (z, base_z)].map(|(at, base)| Some(at?.saturating_sub(base?)));
        let axes = self.base_axes();
        if axes.is_level() {
            return Some(off);
        }
        let off = axes.within_known(off.map(|off| off.map(Length::to_mm_f64)));
        Some(off.map(|off| in_range(off?).ok()))
    }

    /// A zero as the preset table has it, from that of the machine; `None` in an axis of which it is not known.
    pub(super) fn in_table(&self, zero: Row) -> Row {
        let axes = self.base_axes();
        let zero = if axes.is_level() {
            zero
        } else {
            let off = axes.out_of_known(zero.map(|off| off.map(Length::to_mm_f64)));
            off.map(|off| in_range(off?).ok())
        };
        let [base_x, base_y, base_z] = self.base;
        let [x, y, z] = zero;
        [(x, base_x), (y, base_y), (z, base_z)].map(|(at, base)| Some(plus(at?, base?)))
    }
}
