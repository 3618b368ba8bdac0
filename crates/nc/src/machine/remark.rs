//! What is worth knowing about a run that went on.

use std::collections::BTreeMap;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Arg, Message, Say};
use fitcheck_core::probing::circle::CircleWarning;
use fitcheck_core::probing::cycle::{self, Control, Cycle, CycleResult, Key};
use fitcheck_core::probing::simulated::{Collision, Mover};

use super::budget::Budget;
use super::fault::BlockPlace;
use super::path::NcPath;
use crate::control::tool_table::ToolNumber;
use crate::control::variables::Parameter;

/// Something worth knowing.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "machine-remark")]
pub enum Remark {
    /// An unknown block was skipped.
    Skipped,
    /// A measuring cycle that nothing here runs was skipped: what it measures is undefined.
    MeasurementSkipped,
    /// A cycle that calibrates the probe or measures a tool: no fit depends on it here.
    CyclePassedOver,
    /// The same for one that may set a datum, too.
    DatumSkipped,
    /// A block that may change the system of coordinates was not run: nothing is measured behind it.
    NotFollowed,
    /// FN 18 asks for what only a control knows; its parameter is undefined from here on.
    NoSystemData { parameter: Parameter },
    /// A cycle without a TOOL CALL before it measured along Z, because the settings of the run say so.
    AxisAssumed,
    /// A cycle has measured a feature again that an earlier run of its block had found to need rework: this run counts.
    MeasuredAgain,
    /// A cycle was called while the spindle turns.
    SpindleTurns {
        /// The M function that turns it.
        function: u32,
    },
    /// Rotary axes have moved, and the workpiece was taken as if they had not.
    RotaryMoved { axes: String },
    /// Another preset became the zero; the workpiece was taken to lie there, too.
    OtherPreset { number: String },
    /// A cycle has set the datum.
    DatumSet {
        /// Where its zero is in the coordinates of the workpiece.
        zero: Arg,
    },
    /// A cycle has written a row of the preset table that is not active.
    PresetSet {
        row: u32,
        /// Where its zero is, in the axes that were measured.
        zero: Arg,
    },
    /// A cycle has written the row of the active preset, and it acts at once.
    ActivePresetSet {
        row: u32,
        /// Where its zero is.
        zero: Arg,
    },
    /// The preset table stays as it is: where the workpiece lies on the machine is not known.
    PresetsLeft { path: NcPath },
    /// A measuring cycle has ended the basic rotation, for good.
    RotationEnded { angle: Arg },
    /// A plane is tilted, and the rotary axes were taken to stand as it needs them.
    AxesAsTilted,
    /// FN 18 asks for a place from the zero of the machine: that of the workpiece was taken.
    MachineZeroAssumed,
    /// The datum shift ended with a new datum, also in axes that the cycle did not measure.
    ShiftEnded { axes: String },
    /// A file is not among those that were given, and the built-in one of that name was read.
    BuiltIn {
        /// The file.
        path: NcPath,
    },
    /// A file was read, and another one has its name in another spelling.
    OtherNames { read: String, others: String },
    /// A called program or a mask can be read, but not all of it means what it seems to.
    Read {
        /// The file.
        path: NcPath,
        /// What is odd, and where.
        what: Message,
    },
    /// The open table has the range column in the other of the two spellings, and that one was taken.
    OtherSpelling {
        /// The table's file name.
        table: String,
        /// The column that the block names.
        column: String,
        /// The column that the table has.
        other: String,
    },
    /// The rows of a table have other numbers in NR than those that FN 27 and FN 28 count from 0.
    RowNumber {
        /// The table's file name.
        table: String,
        /// The first such row, from 0.
        row: usize,
        /// Its number in NR.
        found: String,
    },
    /// A column of type LENGTH was converted between mm and inches.
    LengthConverted {
        /// The table's file name.
        table: String,
        column: String,
    },
    /// M2 or M30 in a called program ended the whole run.
    EndedWithin {
        /// The M function.
        function: u32,
    },
    /// A value that was given before the run takes the place of the block's value.
    GivenWins { parameter: Parameter, value: Arg },
    /// A value that was given before the run was not used: no block read it before another value took its place.
    GivenWithoutEffect { parameter: Parameter },
    /// What a measuring cycle has to say of its inputs, or its contacts of the circle through them.
    Measured {
        /// What it says.
        what: Message,
    },
    /// What a measuring cycle says against its own answer: limits out of all proportion, contacts of somewhere else.
    Doubted {
        /// What it says.
        what: Message,
    },
    /// Parameters that a measuring cycle needs and its block leaves out: a control may refuse it.
    Filled {
        /// Each with the value that was taken.
        parameters: String,
        /// Whether limits are among them: the block may have been meant to judge.
        #[say(skip)]
        are_limits: bool,
    },
    /// Measuring cycles stand behind `END PGM`, where no control reads on.
    MeasurementBehindEnd {
        /// How many.
        count: usize,
    },
    /// A measuring cycle was skipped at request, because of the / before it.
    CycleSkipped,
    /// FN 27 has rounded a value to the decimals of its column.
    Rounded {
        /// The table's file name.
        table: String,
        column: String,
        value: Arg,
        written: Arg,
    },
    /// A measuring cycle has compared nothing with limits.
    NotJudged,
    /// FN 16, FN 27 or a measuring log wrote no file: no folder was chosen.
    NotWritten {
        /// The file.
        path: NcPath,
    },
    /// A program deletes a file: it has done so.
    Deleted {
        /// The file.
        path: NcPath,
    },
    /// A program deletes a file: no folder was chosen in which it may.
    NotDeleted {
        /// The file.
        path: NcPath,
    },
    /// FN 16 prints to an interface, a network drive or a printer: that is a file below the output folder here.
    OtherDevice {
        /// As the program names it.
        given: String,
        /// The file.
        path: NcPath,
    },
    /// FN 16 prints to `SCREEN` without its colon, which is a file.
    ScreenMeant,
    /// A mask has no line: what FN 16 prints is an empty file.
    EmptyMask { mask: NcPath },
    /// A measuring log, or a table that FN 27 has changed before the run failed, could not be written.
    NotSaved {
        /// The file.
        path: NcPath,
        /// Why.
        reason: Message,
    },
    /// `M_APPEND_MAX`: the file has reached its size, so nothing was added.
    Full {
        /// The file.
        path: NcPath,
        /// Its size, kilobytes.
        kilobytes: u32,
    },
    /// FN 27 has changed a table, and the file was written.
    TableWritten {
        /// The file.
        path: NcPath,
    },
    /// The run is over and recorded contacts are left: perhaps the cycles took contacts of other features.
    ContactsLeft {
        /// How many there were.
        count: usize,
        /// How many the cycles took.
        used: usize,
    },
    /// A variable was read that a cycle of a lathe control has set: what it holds is not documented.
    ContentUncertain {
        /// The variable.
        parameter: Parameter,
    },
    /// It was read without G909 behind the cycle: a control reads blocks ahead, and may not have measured yet.
    NotWaited {
        /// The variable.
        parameter: Parameter,
    },
    /// Where the probe is was not known before a cycle of a lathe control, which begins there.
    PositionUnknown,
    /// A move would touch a feature of the simulated part. Told once for a block.
    Collision {
        /// What of the probe touches.
        mover: Mover,
        /// The feature's name.
        feature: String,
        /// Where the centre of the ball is then, X.
        x: Length,
        y: Length,
        z: Length,
    },
    /// Moves, or the stylus, are not looked at with these features of the simulated part. Told once for a run.
    Unchecked { features: String },
    /// The tool axis is not Z: the stylus, which stands in Z on a simulated part, is not looked at. Told once for a run.
    StylusUnchecked,
    /// The TOOL CALL adds to the length or radius of the probe: a simulated probe stays as it is calibrated.
    ToolOffsets {
        /// As written.
        offsets: String,
    },
    /// The cycle names no nominal size: the perfect workpiece has one that its path meets.
    NoNominal,
    /// Tool 0 was called before a measuring cycle: no probe is in the spindle then.
    EmptySpindle,
    /// Every TOOL CALL before a measuring cycle names an axis or a speed, and none a tool.
    NoToolNamed,
    /// Words of a TOOL CALL that it does not have.
    ToolCallWords {
        /// As written.
        words: String,
    },
    /// The tool is not in the touch-probe table; the first probe was used.
    OtherProbe { tool: String, probe: u32 },
    /// The tool that was called before a measuring cycle is locked (TL).
    ToolLocked { tool: ToolNumber },
    /// The tool that was called before a measuring cycle is something else than a touch probe.
    NoProbeTool {
        tool: ToolNumber,
        /// Its TYP.
        kind: u32,
        /// That of touch probes.
        probe: u32,
    },
    /// A called tool is not in the tool table.
    NoSuchTool {
        /// Its number or name.
        tool: Arg,
    },
    /// Several tools have the name in a block; the first one of the tool table was taken.
    SameName {
        /// The name.
        tool: String,
        /// How many others there are.
        more: usize,
    },
}

impl From<Collision> for Remark {
    fn from(Collision { mover, feature, place }: Collision) -> Self {
        let [x, y, z] = place.map(|part| Length::from_mm_f64(part).unwrap_or(Length::MAX));
        Self::Collision { mover, feature, x, y, z }
    }
}

impl Remark {
    /// What is worth knowing about what a cycle found. That three or four contacts tell little of the form is left out:
    /// the block asks for them. A lathe's cycle has no limits; its program compares.
    pub(super) fn of_cycle(cycle: &Cycle, result: &CycleResult) -> Vec<Self> {
        let doubtful = result.warnings().into_iter().filter(CircleWarning::is_of_diameter);
        // Where the datum comes to is told in the axes of the machine.
        let told = result.remarks.iter().filter(|remark| !matches!(remark, cycle::Remark::NewDatum { .. }));
        let said = told.map(|remark| match remark {
            against if against.stands_against() => Self::Doubted { what: against.message() },
            other => Self::Measured { what: other.message() },
        });
        let doubtful = doubtful.map(|warning| Self::Measured { what: warning.message() });
        let mut remarks: Vec<_> = said.chain(doubtful).collect();
        remarks.extend(Self::filled(cycle, result));
        let is_unjudged = cycle.control == Control::Milling && cycle.judges() && result.verdict().is_none();
        remarks.extend(is_unjudged.then_some(Self::NotJudged));
        remarks
    }

    /// Whether something that may have been measured is left out of what is judged, or what it is judged by is doubted or assumed.
    pub const fn stands_against(&self) -> bool {
        matches!(
            self,
            Self::Skipped
                | Self::Filled { are_limits: true, .. }
                | Self::MeasurementBehindEnd { .. }
                | Self::MeasurementSkipped
                | Self::DatumSkipped
                | Self::Doubted { .. }
                | Self::RotaryMoved { .. }
                | Self::OtherPreset { .. }
                | Self::ActivePresetSet { .. }
                | Self::ShiftEnded { .. }
                | Self::ContactsLeft { .. }
        )
    }

    /// Whether a measurement was left out, or its limits: that counts also where nothing was judged. Limits of zero say that none is meant.
    const fn leaves_out_a_measurement(&self) -> bool {
        matches!(
            self,
            Self::Filled { are_limits: true, .. }
                | Self::MeasurementSkipped
                | Self::DatumSkipped
                | Self::MeasurementBehindEnd { .. }
                | Self::ContactsLeft { .. }
        )
    }

    /// What a milling control's block leaves out of what has an effect. Letters of a lathe's cycle may be left out.
    pub fn filled(cycle: &Cycle, result: &CycleResult) -> Option<Self> {
        let mut are_limits = false;
        let left_out = cycle.parameters.iter().filter_map(|parameter| {
            let Key::Q(_) = parameter.key else { return None };
            let is_optional = !parameter.has_effect || parameter.meaning.may_be_left_out();
            let is_needed = !is_optional && !result.inputs.is_given(parameter.key);
            let value = result.inputs.value(parameter.key).filter(|_value| is_needed)?;
            are_limits |= parameter.meaning.other_limit().is_some();
            Some(format!("{} = {}", parameter.key, value.with_unit()))
        });
        let parameters = left_out.collect::<Vec<_>>().join(", ");
        (!parameters.is_empty()).then_some(Self::Filled { parameters, are_limits })
    }

    /// What the reader of a file has to say.
    pub(super) fn read(path: &NcPath, warnings: &[impl Say]) -> Vec<Self> {
        warnings.iter().map(|warning| Self::Read { path: path.clone(), what: warning.message() }).collect()
    }
}

/// The remarks of a run; beyond the limit they are only counted.
#[derive(Debug)]
pub(super) struct Remarks {
    list: Vec<(BlockPlace, Remark)>,
    /// The positions in the list, by block.
    of: BTreeMap<BlockPlace, Vec<usize>>,
    unlisted: usize,
    most: usize,
    stand_against: bool,
    leave_out_a_measurement: bool,
}

impl Remarks {
    pub(super) const fn new(budget: &Budget) -> Self {
        Self {
            list: Vec::new(),
            of: BTreeMap::new(),
            unlisted: 0,
            most: budget.remarks,
            stand_against: false,
            leave_out_a_measurement: false,
        }
    }

    /// Adds a remark, unless the block already has the same one.
    pub(super) fn add(&mut self, place: BlockPlace, remark: Remark) {
        // Also of one that finds no place in the list any more.
        self.stand_against |= remark.stands_against();
        self.leave_out_a_measurement |= remark.leaves_out_a_measurement();
        // Only remarks of the same block are compared: a loop makes the same ones again and again.
        let said = self.of.get(&place).into_iter().flatten();
        if said.filter_map(|number| self.list.get(*number)).any(|(_, said)| *said == remark) {
            return;
        }
        if self.list.len() < self.most {
            self.of.entry(place.clone()).or_default().push(self.list.len());
            self.list.push((place, remark));
        } else {
            self.unlisted += 1;
        }
    }

    /// Adds a remark, unless any block has it.
    pub(super) fn add_once(&mut self, place: &BlockPlace, remark: Remark) {
        if !self.list.iter().any(|(_, said)| *said == remark) {
            self.add(place.clone(), remark);
        }
    }

    /// Whether a collision of a block is listed.
    pub(super) fn has_collision(&self, place: &BlockPlace) -> bool {
        let said = self.of.get(place).into_iter().flatten().filter_map(|number| self.list.get(*number));
        said.into_iter().any(|(_, said)| matches!(said, Remark::Collision { .. }))
    }

    /// Adds several of one block.
    pub(super) fn add_all(&mut self, place: &BlockPlace, remarks: Vec<Remark>) {
        for remark in remarks {
            self.add(place.clone(), remark);
        }
    }

    pub(super) fn list(&self) -> &[(BlockPlace, Remark)] {
        &self.list
    }

    /// Whether one of them stands against what was judged, or says that nothing was judged because a measurement was left out.
    pub(super) const fn stand_against(&self, is_judged: bool) -> bool {
        if is_judged { self.stand_against } else { self.leave_out_a_measurement }
    }

    pub(super) const fn unlisted(&self) -> usize {
        self.unlisted
    }
}
