//! What a program sets up around its measurements: tool axis and spindle, mode, global values, and the system that
//! coordinates count in; and what it passes over.
//!
//! | file | what |
//! |---|---|
//! | `datum` | the datum, and the presets |
//! | `set` | what cycles make of it |
//! | `globals` | the values of GLOBAL DEF |
//! | `system` | what changes the system that coordinates count in |
//!
//! Where the rules come from: `docs/SOURCES.md`, "Around a measurement".

mod datum;
mod globals;
mod set;
mod system;

use std::collections::{BTreeMap, BTreeSet};

use datum::{Datum, Tilt};
pub use datum::{DatumInForce, SetBy, Turn};
use fitcheck_core::probing::Orientation;
use fitcheck_core::probing::cycle::Plane;
use fitcheck_core::probing::vector::along;
pub(super) use globals::Global;
use globals::IsProbing;

use super::change::Change;
use super::fault::FaultKind;
use super::path::NcPath;
use super::placement::{Placement, System, plane};
use super::remark::Remark;
use super::tool_call::{Called, Named};
use crate::control::variables::Parameter;
use crate::program::{Axis, CycleBlock, MachineFunction, Mode, Notation, Unit};

/// Millimetres in an inch.
pub(super) const INCH: f64 = 25.4;

/// Millimetres in one unit of a program.
pub(super) fn millimetres(unit: Option<Unit>) -> f64 {
    if unit == Some(Unit::Inch) { INCH } else { 1.0 }
}

/// Whether a value is another one than that which changes nothing.
fn is_other(value: f64, neutral: f64) -> bool {
    value.is_nan() || 0.0 < (value - neutral).abs()
}

/// What a program has set up.
#[derive(Debug)]
pub(super) struct Around {
    /// The plane of the last TOOL CALL that named a tool axis.
    plane: Option<Plane>,
    tool: Called,
    /// The M function that turns the spindle.
    spindle: Option<u32>,
    /// The one that did so last.
    last_spindle: Option<u32>,
    has_coolant: bool,
    mode: Mode,
    /// The values that PREDEF stands for, in mm or degrees, with the factor of their program's unit.
    globals: BTreeMap<(IsProbing, Parameter), Global>,
    datum: Datum,
    /// The shift of cycle 7, mm from the zero of the preset, along the axes of the basic rotation.
    shift: [f64; 3],
    tilt: Option<Tilt>,
    /// Which axes of the plane have no datum since a rotary axis has turned the part.
    not_set: [bool; 2],
    preset: Option<f64>,
    /// Changes in force, and the block that made each.
    changes: BTreeMap<Change, ChangingBlock>,
    /// Rotary axes that are not known to be at zero.
    turned: BTreeSet<Axis>,
    /// Those of them that a cycle has turned and left where they are.
    held: BTreeSet<Axis>,
    selected: Option<NcPath>,
    stops: u64,
    starts: u64,
    passed: BTreeMap<String, usize>,
}

/// What tells whether two measurements are of one feature, before and after rework.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Moment {
    plane: Plane,
    system: System,
    preset: Option<f64>,
    is_turned: bool,
    /// How often the program had stopped: the workpiece may have been changed.
    stops: u64,
    /// How often the spindle had been started: nothing is machined without.
    starts: u64,
}

impl Moment {
    /// The system in force.
    pub(super) const fn system(&self) -> System {
        self.system
    }

    /// The system in force; `None` in another plane than X/Y.
    pub(super) fn system_of_plane_xy(&self) -> Option<System> {
        (self.plane == Plane::Xy).then_some(self.system)
    }

    /// Whether the same workpiece can have been machined between.
    pub(super) fn is_before_rework(&self, later: &Self) -> bool {
        let same = Self { starts: later.starts, ..self.clone() };
        same == *later && !self.is_turned && self.starts < later.starts
    }
}

/// The block that made a change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct ChangingBlock {
    /// Its line in its program, from 1.
    pub line: usize,
    pub text: String,
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

/// What a cycle probes for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    Measurement,
    /// A datum, also where one is missing.
    Datum,
}

/// Something that a block behind it loses where it is taken out of its program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum CarriedState {
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
            last_spindle: None,
            has_coolant: false,
            mode: Mode::Mill,
            globals: BTreeMap::new(),
            datum: Datum::default(),
            shift: [0.0; 3],
            tilt: None,
            not_set: [false; 2],
            preset: None,
            changes: BTreeMap::new(),
            turned: BTreeSet::new(),
            held: BTreeSet::new(),
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
                    self.last_spindle = self.spindle;
                    self.has_coolant |= matches!(function.number, 13 | 14);
                    self.starts += 1;
                }
                5 => self.spindle = None,
                8 => self.has_coolant = true,
                9 => self.has_coolant = false,
                // The control's own: coolant, tool change, ends, and those from 89 on.
                2 | 6 | 7 | 19 | 30 | 89..=199 => {}
                // Stops, and functions of the machine's builder: another pallet may be there.
                _ => self.stops += 1,
            }
        }
    }

    /// 0 after M3, 1 after M4, 2 and 3 where M5 came behind them, -1 before all of them.
    pub(super) const fn spindle_state(&self) -> f64 {
        match (self.spindle, self.last_spindle) {
            (Some(3 | 13), _) => 0.0,
            (Some(_), _) => 1.0,
            (None, Some(3 | 13)) => 2.0,
            (None, Some(_)) => 3.0,
            (None, None) => -1.0,
        }
    }

    pub(super) const fn has_coolant(&self) -> bool {
        self.has_coolant
    }

    /// The tool axis of the last TOOL CALL that named one.
    pub(super) fn tool_axis(&self) -> Option<Axis> {
        self.plane.map(|plane| match plane {
            Plane::Xy => Axis::Z,
            Plane::Zx => Axis::Y,
            Plane::Yz => Axis::X,
        })
    }

    /// The shift of cycle 7, mm; `None` in a tilted plane.
    pub(super) fn shift_in_force(&self) -> Option<[f64; 3]> {
        self.tilt.is_none().then_some(self.shift)
    }

    /// The row of the preset table that is active, where a block has named it.
    pub(super) const fn preset(&self) -> Option<f64> {
        self.preset
    }

    /// A place of the workpiece in the coordinates in force; `None` where they are mirrored, scaled or not known.
    pub(super) fn in_system(&self, place: [f64; 3]) -> Option<[f64; 3]> {
        (self.changes.is_empty() && self.turned.is_empty()).then(|| self.system().within(place))
    }

    /// STOP ends the turning of the spindle.
    pub(super) const fn stop(&mut self) {
        self.spindle = None;
        self.stops += 1;
    }

    /// What tells whether two measurements are of one feature.
    pub(super) fn moment(&self) -> Moment {
        let Self { preset, stops, starts, .. } = *self;
        Moment { plane: self.plane(), system: self.system(), preset, is_turned: !self.turned.is_empty(), stops, starts }
    }

    pub(super) const fn set_mode(&mut self, mode: Mode) {
        self.mode = mode;
    }

    /// `SEL PGM`
    pub(super) fn select(&mut self, path: NcPath) {
        self.selected = Some(path);
    }

    pub(super) const fn selected(&self) -> Option<&NcPath> {
        self.selected.as_ref()
    }

    /// What is in force that is not so at the beginning of a program.
    pub(super) fn kept(&self) -> impl Iterator<Item = CarriedState> {
        let zero = along(self.datum.origin(), self.shift, 1.0);
        let zero = zero.into_iter().any(|part| is_other(part, 0.0)).then_some(CarriedState::Zero);
        let tilt = self.tilt.is_some().then_some(CarriedState::Change(Change::Tilt));
        let turned = (!self.turned.is_empty()).then_some(CarriedState::Turned);
        let plane = (self.plane() != Plane::default()).then_some(CarriedState::Plane);
        let mode = (self.mode != Mode::Mill).then_some(CarriedState::Mode);
        let changes = self.changes.keys().copied().map(CarriedState::Change);
        zero.into_iter().chain(changes).chain(tilt).chain(turned).chain(plane).chain(mode)
    }

    /// Whether coordinates can be followed: under mirroring and its like they cannot.
    pub(super) fn is_plain(&self) -> bool {
        self.changes.keys().all(|change| *change == Change::AxisTurned)
    }

    /// Whether a plane is tilted, or rotary axes are not known to be at zero.
    pub(super) fn is_turned(&self) -> bool {
        self.tilt.is_some() || !self.turned.is_empty()
    }

    /// The plane of the tool axis; X and Y before any tool call.
    pub(super) fn plane(&self) -> Plane {
        self.plane.unwrap_or(Plane::Xy)
    }

    /// The system in force: basic rotation about the datum, the shift along its axes, then the tilt and a shift within it.
    pub(super) fn system(&self) -> System {
        let rotation = self.datum.rotation();
        let shifted = along(self.datum.origin(), rotation.out(self.shift), 1.0);
        let Some(tilt) = &self.tilt else { return System { zero: shifted, axes: rotation } };
        let axes = rotation.then(Orientation::spatial(tilt.angles));
        System { zero: along(shifted, axes.out(tilt.shift), 1.0), axes }
    }

    /// Where a cycle measures; one that sets a datum does so where the part was turned, too.
    ///
    /// # Errors
    /// [`FaultKind`] outside milling mode, without a tool axis unless Z is assumed, and under a change of the system.
    pub(super) fn placement(&self, assumes_tool: bool, purpose: Purpose) -> Result<Placement, FaultKind> {
        if self.mode != Mode::Mill {
            return Err(FaultKind::Mode(self.mode));
        }
        let refused = |change: &Change| !(purpose == Purpose::Datum && *change == Change::AxisTurned);
        if let Some((change, ChangingBlock { line, text })) = self.changes.iter().find(|(change, _)| refused(change)) {
            return Err(FaultKind::Changed { change: *change, line: *line, text: text.clone() });
        }
        match self.plane {
            None if !assumes_tool => Err(FaultKind::NoToolCall),
            _ => Ok(Placement { plane: self.plane(), system: self.system() }),
        }
    }

    /// What is odd about measuring now.
    pub(super) fn odd(&self) -> Vec<Remark> {
        let assumed = self.plane.is_none().then_some(Remark::AxisAssumed);
        let spindle = self.spindle.map(|function| Remark::SpindleTurns { function });
        let axes: Vec<String> = self.turned.iter().map(|axis| format!("{axis:?}")).collect();
        let turned = (!axes.is_empty()).then(|| match self.tilt {
            Some(_) => Remark::AxesAsTilted,
            None => Remark::RotaryMoved { axes: axes.join(", ") },
        });
        assumed.into_iter().chain(spindle).chain(turned).chain(self.tool.odd()).collect()
    }
}
