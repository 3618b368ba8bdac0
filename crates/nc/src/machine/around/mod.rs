//! What a program sets up around its measurements: tool axis and spindle, mode, global values, and the system that
//! coordinates count in; and what it passes over.
//!
//! Where the rules come from: `docs/SOURCES.md`, "Around a measurement".

use std::collections::{BTreeMap, BTreeSet};

use fitcheck_core::probing::cycle::Plane;

use super::change::Change;
use super::fault::FaultKind;
use super::path::NcPath;
use super::placement::{Placement, plane};
use super::remark::Remark;
use super::tool_call::{Called, Named};
use super::values::Values;
use crate::control::variables::{Parameter, Value};
use crate::program::{
    Axis, AxisWord, CycleBlock, CycleName, CycleValue, Frame, MachineFunction, Mode, Notation, Operand, Unit,
};

/// Millimetres in an inch.
pub(super) const INCH: f64 = 25.4;

/// Millimetres in one unit of a program.
pub(super) fn millimetres(unit: Option<Unit>) -> f64 {
    if unit == Some(Unit::Inch) { INCH } else { 1.0 }
}

/// What a program has set up.
#[derive(Debug)]
pub(super) struct Around {
    /// The plane of the last TOOL CALL that named a tool axis.
    plane: Option<Plane>,
    tool: Called,
    /// The M function that turns the spindle.
    spindle: Option<u32>,
    mode: Mode,
    /// The values that PREDEF stands for, in mm or degrees, with the factor of their program's unit.
    globals: BTreeMap<(IsProbing, Parameter), Global>,
    zero: [f64; 3],
    preset: Option<f64>,
    /// Changes in force, and the block that made each.
    changes: BTreeMap<Change, Made>,
    /// Rotary axes that are not known to be at zero.
    turned: BTreeSet<Axis>,
    selected: Option<NcPath>,
    stops: u64,
    starts: u64,
    passed: BTreeMap<String, usize>,
}

/// What tells whether two measurements are of one feature, before and after rework.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Moment {
    plane: Plane,
    zero: [f64; 3],
    preset: Option<f64>,
    is_turned: bool,
    /// How often the program had stopped: the workpiece may have been changed.
    stops: u64,
    /// How often the spindle had been started: nothing is machined without.
    starts: u64,
}

impl Moment {
    /// Whether the same workpiece can have been machined between.
    pub(super) fn is_before_rework(&self, later: &Self) -> bool {
        let same = Self { starts: later.starts, ..self.clone() };
        same == *later && !self.is_turned && self.starts < later.starts
    }
}

/// The block that made a change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Made {
    /// Its line in its program, from 1.
    pub line: usize,
    pub text: String,
}

/// The GLOBAL DEF that measuring cycles take their values from (nc-programs, section 1).
const PROBING: &str = "120";

/// Whether a value is from that GLOBAL DEF.
type IsProbing = bool;

/// A value of GLOBAL DEF.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Global {
    /// The value as written.
    pub value: f64,
    /// The unit of the program that gave it.
    pub unit: Option<Unit>,
}

/// The value of an operand in a block; not a number where nobody knows it: it is then never neutral, and no zero.
pub(super) type ValueOf<'a> = dyn Fn(Operand) -> Result<f64, FaultKind> + 'a;

/// Whether a value is another one than that which changes nothing.
fn is_other(value: f64, neutral: f64) -> bool {
    value.is_nan() || 0.0 < (value - neutral).abs()
}

/// M functions that change the datum: M104 makes the one active that was set last, M142 deletes shifts, rotations and the like.
const RESETS: [u32; 2] = [104, 142];

/// Whether M functions of a milling control change the datum.
pub(super) fn reset_datum(functions: &[MachineFunction]) -> bool {
    functions.iter().any(|function| RESETS.contains(&function.number))
}

/// The number of a cycle of the control itself that machines; those of the machine's builder may do anything.
pub(super) fn machining(cycle: &CycleBlock) -> Option<u32> {
    cycle.number.parse().ok().filter(|number: &u32| {
        // Machining, turning and grinding; below them are the control's oldest.
        *number <= 39 || matches!(number, 200..=299 | 800..=899 | 1000..=1099 | 1271..=1274 | 1278 | 1281 | 1282)
    })
}

/// Something that a block behind it loses where it is taken out of its program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kept {
    /// The zero is not where the preset is.
    Zero,
    Change(Change),
    /// A rotary axis is not known to be at zero.
    Turned,
    /// The tool axis is not Z.
    Plane,
    Mode,
}

impl Around {
    /// Before the first block. A lathe has no tool axis to name: its cycles say in which plane they measure.
    pub(super) fn new(notation: Notation) -> Self {
        Self {
            plane: (notation == Notation::DinPlus).then(Plane::default),
            tool: Called::default(),
            spindle: None,
            mode: Mode::Mill,
            globals: BTreeMap::new(),
            zero: [0.0; 3],
            preset: None,
            changes: BTreeMap::new(),
            turned: BTreeSet::new(),
            selected: None,
            stops: 0,
            starts: 0,
            passed: BTreeMap::new(),
        }
    }

    /// How many blocks were passed over, by their first words.
    pub(super) const fn passed(&self) -> &BTreeMap<String, usize> {
        &self.passed
    }

    /// Counts a block that was passed over; after one that speaks to the machine another workpiece may be there.
    pub(super) fn pass_over(&mut self, words: &str) {
        if ["FN 17", "FN 19", "FN 29", "FN 38", "D19", "D29", "FUNCTION COUNT"].contains(&words) {
            self.stops += 1;
        }
        if let Some(count) = self.passed.get_mut(words) {
            *count += 1;
        } else {
            self.passed.insert(words.to_owned(), 1);
        }
    }

    /// TOOL CALL: a tool's axis, if one is named; the spindle stops for another tool. `rest` is what stands behind.
    pub(super) fn call_tool(&mut self, named: Named, axis: Option<Axis>, rest: &str) {
        self.plane = axis.and_then(plane).or(self.plane);
        if named != Named::Nothing {
            self.spindle = None;
        }
        self.tool.call(named, rest);
    }

    /// M3, M4, M13, M14 turn the spindle, M5 stops it.
    pub(super) fn machine_functions(&mut self, functions: &[MachineFunction]) {
        for function in functions {
            match function.number {
                3 | 4 | 13 | 14 => {
                    self.spindle = Some(function.number);
                    self.starts += 1;
                }
                5 => self.spindle = None,
                // The control's own: coolant, tool change, ends, and those from 89 on.
                2 | 6..=9 | 19 | 30 | 89..=199 => {}
                // Stops, and functions of the machine's builder: another pallet may be there.
                _ => self.stops += 1,
            }
        }
    }

    /// STOP ends the turning of the spindle.
    pub(super) const fn stop(&mut self) {
        self.spindle = None;
        self.stops += 1;
    }

    /// What tells whether two measurements are of one feature.
    pub(super) fn moment(&self) -> Moment {
        let Self { zero, preset, stops, starts, .. } = *self;
        Moment { plane: self.plane(), zero, preset, is_turned: !self.turned.is_empty(), stops, starts }
    }

    pub(super) const fn set_mode(&mut self, mode: Mode) {
        self.mode = mode;
    }

    /// GLOBAL DEF: the last one that was run counts.
    ///
    /// # Errors
    /// A parameter that stands twice in one block: which of the two a control takes is not documented.
    pub(super) fn define(&mut self, block: &CycleBlock, unit: Option<Unit>, values: &Values) -> Result<(), FaultKind> {
        let is_probing = block.number == PROBING;
        for (at, line) in block.lines.iter().enumerate() {
            let mut before = block.lines.iter().take(at);
            if before.any(|before| before.parameter == line.parameter) {
                let number = block.number.clone();
                let parameter = line.parameter.clone();
                return Err(FaultKind::GlobalTwice { number, parameter });
            }
            match (&line.parameter, &line.value) {
                (CycleName::Parameter(parameter), CycleValue::Number { value, .. }) => {
                    let value = values.operand(*value)?;
                    self.globals.insert((is_probing, *parameter), Global { value, unit });
                }
                // An earlier value would stay in force.
                _ if is_probing => {
                    let number = block.number.clone();
                    let parameter = line.parameter.clone();
                    return Err(FaultKind::GlobalNotNumber { number, parameter });
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The value of GLOBAL DEF 120 for a parameter of a measuring cycle.
    pub(super) fn global(&self, parameter: Parameter) -> Option<&Global> {
        self.globals.get(&(true, parameter))
    }

    /// `SEL PGM`
    pub(super) fn select(&mut self, path: NcPath) {
        self.selected = Some(path);
    }

    pub(super) const fn selected(&self) -> Option<&NcPath> {
        self.selected.as_ref()
    }

    /// Rotary axes of a move, or of a shift: at zero they change nothing. A move along U, V or W may bring another workpiece.
    pub(super) fn turn(&mut self, axes: &[AxisWord], value: &ValueOf<'_>) {
        for word in axes {
            if matches!(word.axis, Axis::U | Axis::V | Axis::W) {
                self.stops += 1;
            }
            if matches!(word.axis, Axis::A | Axis::B | Axis::C) {
                let is_zero = !word.is_incremental && value(word.value).is_ok_and(|value| value.abs() < 1e-9);
                if is_zero {
                    self.turned.remove(&word.axis);
                } else {
                    self.turned.insert(word.axis);
                }
            }
        }
    }

    /// Changes the system; `made` is the block.
    pub(super) fn change(
        &mut self,
        frame: &Frame,
        made: Made,
        unit: Option<Unit>,
        value: &ValueOf<'_>,
    ) -> Result<Option<Remark>, FaultKind> {
        let is_not = |operand: Operand, neutral: f64| Ok::<_, FaultKind>(is_other(value(operand)?, neutral));
        match frame {
            Frame::Title => {}
            Frame::Shift(axes) => self.shift(axes, unit, value)?,
            Frame::NoShift => {
                self.zero = [0.0; 3];
                self.changes.remove(&Change::DatumTable);
            }
            Frame::ShiftFromTable => self.set(Change::DatumTable, true, made),
            Frame::Preset(number) => return self.activate(*number, value),
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
            Frame::Tilt(angles) => {
                let changed: Result<Vec<bool>, _> = angles.iter().map(|angle| is_not(*angle, 0.0)).collect();
                self.tilt(changed?.contains(&true), made);
            }
            Frame::OtherTilt => self.tilt(true, made),
            Frame::NoTilt => self.set(Change::Tilt, false, made),
            Frame::TurnedBack => {
                self.set(Change::Tilt, false, made);
                self.turned.clear();
            }
            Frame::NotFollowed => {
                self.lose_system(|| made);
                return Ok(Some(Remark::NotFollowed));
            }
        }
        Ok(None)
    }

    /// A tilt may have turned the axes; its end does not turn them back.
    fn tilt(&mut self, is_in_force: bool, made: Made) {
        if is_in_force {
            self.turned.extend([Axis::A, Axis::B, Axis::C]);
        }
        self.set(Change::Tilt, is_in_force, made);
    }

    /// A block was not run that may have set a datum, a rotation or whatever else: nothing ends that, because a preset or datum table
    /// may be what it has written.
    pub(super) fn lose_system(&mut self, made: impl FnOnce() -> Made) {
        self.changes.entry(Change::NotKnown).or_insert_with(made);
    }

    /// Cycle 800 turns the system for turning, 801 ends that.
    pub(super) fn turning(&mut self, number: u32, made: Made) {
        match number {
            800 => self.set(Change::Turning, true, made),
            801 => self.set(Change::Turning, false, made),
            _ => {}
        }
    }

    /// The values of GLOBAL DEF are not known any more.
    pub(super) fn lose_globals(&mut self) {
        self.globals.clear();
    }

    fn set(&mut self, change: Change, is_in_force: bool, made: Made) {
        if is_in_force {
            self.changes.insert(change, made);
        } else {
            self.changes.remove(&change);
        }
    }

    fn shift(&mut self, axes: &[AxisWord], unit: Option<Unit>, value: &ValueOf<'_>) -> Result<(), FaultKind> {
        for word in axes {
            let by = value(word.value)? * millimetres(unit);
            let [x, y, z] = &mut self.zero;
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
        if [Axis::X, Axis::Y, Axis::Z].into_iter().all(is_written) {
            self.changes.remove(&Change::DatumTable);
        }
        Ok(())
    }

    /// Cycle 247: shift, rotation, mirror and scaling end. Fitcheck has no preset table: the workpiece lies at each preset.
    fn activate(&mut self, number: Option<Operand>, value: &ValueOf<'_>) -> Result<Option<Remark>, FaultKind> {
        let number = number.map(value).transpose()?;
        let is_other = self.preset.is_some() && self.preset != number;
        // A preset that is not named may be any.
        self.stops += u64::from(number.is_none());
        self.zero = [0.0; 3];
        self.changes.retain(|change, _| matches!(change, Change::Tilt | Change::NotKnown | Change::Turning));
        self.preset = number.or(self.preset);
        Ok(number.filter(|_| is_other).map(|number| Remark::OtherPreset { number: number.to_string() }))
    }

    /// What is in force that is not so at the beginning of a program.
    pub(super) fn kept(&self) -> impl Iterator<Item = Kept> {
        let zero = self.zero.into_iter().any(|part| is_other(part, 0.0)).then_some(Kept::Zero);
        let turned = (!self.turned.is_empty()).then_some(Kept::Turned);
        let plane = (self.plane() != Plane::default()).then_some(Kept::Plane);
        let mode = (self.mode != Mode::Mill).then_some(Kept::Mode);
        let changes = self.changes.keys().copied().map(Kept::Change);
        zero.into_iter().chain(changes).chain(turned).chain(plane).chain(mode)
    }

    /// Whether coordinates can be followed: under a rotation and its like they cannot.
    pub(super) fn is_plain(&self) -> bool {
        self.changes.is_empty()
    }

    /// The plane of the tool axis; X and Y before any tool call.
    pub(super) fn plane(&self) -> Plane {
        self.plane.unwrap_or(Plane::Xy)
    }

    /// The zero in force, mm from the preset.
    pub(super) const fn zero(&self) -> [f64; 3] {
        self.zero
    }

    /// Where a cycle measures.
    ///
    /// # Errors
    /// [`FaultKind`] outside milling mode, without a tool axis unless Z is assumed, and under a change of the system.
    pub(super) fn placement(&self, assumes_tool: bool) -> Result<Placement, FaultKind> {
        if self.mode != Mode::Mill {
            return Err(FaultKind::Mode(self.mode));
        }
        if let Some((change, Made { line, text })) = self.changes.first_key_value() {
            return Err(FaultKind::Changed { change: *change, line: *line, text: text.clone() });
        }
        match self.plane {
            None if !assumes_tool => Err(FaultKind::NoToolCall),
            _ => Ok(Placement { plane: self.plane(), zero: self.zero }),
        }
    }

    /// What is odd about measuring now.
    pub(super) fn odd(&self) -> Vec<Remark> {
        let assumed = self.plane.is_none().then_some(Remark::AxisAssumed);
        let spindle = self.spindle.map(|function| Remark::SpindleTurns { function });
        let axes: Vec<String> = self.turned.iter().map(|axis| format!("{axis:?}")).collect();
        let turned = (!axes.is_empty()).then(|| Remark::RotaryMoved { axes: axes.join(", ") });
        assumed.into_iter().chain(spindle).chain(turned).chain(self.tool.odd()).collect()
    }

    /// The parameters of a cycle, as a program may read them afterwards.
    ///
    /// A value from a GLOBAL DEF of a program in another unit may be a length or not: it is undefined then.
    pub(super) fn stated(
        &self,
        block: &CycleBlock,
        is_probing: bool,
        unit: Option<Unit>,
        values: &mut Values,
    ) -> Result<(), FaultKind> {
        for line in &block.lines {
            // A word is not a parameter that a program could read.
            let CycleName::Parameter(parameter) = line.parameter else { continue };
            let value = match &line.value {
                CycleValue::Number { value, .. } => values.value(*value)?,
                CycleValue::Word(word) if word.eq_ignore_ascii_case("PREDEF") => {
                    let global = self.globals.get(&(is_probing, parameter)).filter(|global| global.unit == unit);
                    let Some(global) = global else {
                        values.undefine(parameter, false);
                        continue;
                    };
                    Value::Number(global.value)
                }
                CycleValue::Text(_) | CycleValue::Word(_) => continue,
            };
            values.put(parameter, value)?;
        }
        Ok(())
    }
}
