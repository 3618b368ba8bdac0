//! What the control itself says of the run: the tool in the spindle, axes and positions, in FN 18 and in the parameters from Q108 on.
//!
//! Only what a run knows is answered: the program's own tool calls and M functions, the tool table where there is one, the datum and the
//! position. Everything else stays undefined, and a remark says so. Groups and numbers: datum-cycles, sections 9 and 12 (manuals, named
//! there); which oversizes the radius of Q108 and ID200 has is from memory.

use std::sync::Arc;

use fitcheck_core::length::Length;

use super::super::around::millimetres;
use super::super::fault::FaultKind;
use super::super::values::whole;
use super::Run;
use crate::control::tool_table::{Tool as TableTool, ToolNumber};
use crate::control::variables::Parameter;
use crate::program::{Axis, SystemDatum, Tool};

/// Axes by their index in FN 18.
const AXES: [Axis; 9] = [Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B, Axis::C, Axis::U, Axis::V, Axis::W];

/// The group of places from the zero of the machine.
const IN_MACHINE: u32 = 240;

/// The tool in the spindle.
#[derive(Debug, Clone, Default)]
pub(super) struct SpindleTool {
    /// Its number, where the TOOL CALL or the table says it.
    number: Option<f64>,
    /// What the tool table says of it.
    of_table: Option<TableTool>,
    /// What the last TOOL CALL says besides; `None` where it is in a parameter.
    speed: Option<f64>,
    /// What it adds to the length and to the radius, mm.
    length_added: Option<f64>,
    radius_added: Option<f64>,
}

impl SpindleTool {
    /// Length and radius with all that is added to them, mm.
    fn measures(&self) -> Option<[f64; 2]> {
        let is_empty = self.number.is_some_and(|number| number.abs() <= 0.0);
        if is_empty {
            return Some([0.0; 2]);
        }
        let tool = self.of_table.as_ref()?;
        let sum = |own: Length, delta: Length, added: f64| own.to_mm_f64() + delta.to_mm_f64() + added;
        let length = sum(tool.length, tool.delta_length, self.length_added?);
        Some([length, sum(tool.radius, tool.delta_radius, self.radius_added?)])
    }
}

/// The value of a word behind the tool of a TOOL CALL, 0 where it is not there; `None` where it is in a parameter.
fn word(rest: &str, letters: &str) -> Option<f64> {
    let upper = rest.to_ascii_uppercase();
    let found = upper.split_ascii_whitespace().find_map(|word| {
        let value = word.strip_prefix(letters)?.trim_start_matches('=');
        value.starts_with(|sign: char| sign.is_ascii_digit() || "+-.,Q".contains(sign)).then(|| value.replace(',', "."))
    });
    found.map_or(Some(0.0), |value| value.parse().ok())
}

impl Run {
    /// Takes the tool of a TOOL CALL into the spindle, and sets the parameters that hold what is known of it.
    pub(super) fn take_tool(&mut self, at: usize, tool: Option<&Tool>, rest: &str) -> Result<(), FaultKind> {
        let factor = millimetres(self.flow.unit());
        if tool.is_some() {
            let of_table = self.tools.in_spindle().cloned();
            let number = match tool {
                Some(Tool::Number(number)) => Some(self.values.operand(*number)?),
                _ => of_table.as_ref().and_then(|tool| tool.number.to_string().parse().ok()),
            };
            let added = |letters| word(rest, letters).map(|value| value * factor);
            self.spindle_tool = SpindleTool {
                number,
                of_table,
                speed: word(rest, "S"),
                length_added: added("DL"),
                radius_added: added("DR"),
            };
        } else if word(rest, "S") != Some(0.0) {
            self.spindle_tool.speed = word(rest, "S");
        }
        self.put_tool(at);
        self.put_spindle();
        Ok(())
    }

    /// Q108, Q109 and Q114; nothing of a tool that no table knows.
    fn put_tool(&mut self, at: usize) {
        self.values.preassign(109, self.tool_axis());
        let of_measures = [114, 108];
        let factor = millimetres(self.flow.unit());
        match self.spindle_tool.measures() {
            Some(measures) => {
                for (number, mm) in of_measures.into_iter().zip(measures) {
                    self.values.preassign(number, mm / factor);
                }
            }
            None if self.tools.table().is_some() => {
                let by = Arc::new(self.flow.made(at));
                for number in of_measures {
                    self.values.lose(Parameter::q(number), &by);
                }
            }
            None => {}
        }
    }

    /// A block that was not run may have changed the tool table: what it says of any tool is not known any more.
    pub(super) fn lose_tools(&mut self, at: usize) {
        if self.tools.table().is_none() {
            return;
        }
        self.tools.lose(|| Arc::new(self.flow.made(at)));
        self.spindle_tool.of_table = None;
        self.put_tool(at);
    }

    /// Q110 and Q111.
    pub(super) fn put_spindle(&mut self) {
        self.values.preassign(110, self.around.spindle_state());
        self.values.preassign(111, f64::from(u8::from(self.around.has_coolant())));
    }

    /// 0 for X, 1 for Y, 2 for Z; -1 before the first TOOL CALL.
    fn tool_axis(&self) -> f64 {
        match self.around.tool_axis() {
            Some(Axis::X) => 0.0,
            Some(Axis::Y) => 1.0,
            Some(Axis::Z) => 2.0,
            _ => -1.0,
        }
    }

    /// Whether an answer counts from the zero of the machine, and no preset table has said where that is.
    pub(super) fn assumes_machine_zero(&self, datum: &SystemDatum) -> bool {
        datum.group == IN_MACHINE && !self.around.knows_machine_zero()
    }

    /// What FN 18 answers, mm or degrees; `None` for what only a control knows.
    pub(super) fn system_value(&self, datum: &SystemDatum) -> Option<f64> {
        let value = |operand| self.values.operand(operand).ok();
        let number = datum.number.map_or(Some(0), |number| whole(value(number)?))?;
        let index = datum.index.map(value);
        let axis = || AXES.get(whole(index??)?.checked_sub(1)?).copied();
        let place = |[x, y, z]: [f64; 3]| match axis()? {
            Axis::X => Some(x),
            Axis::Y => Some(y),
            Axis::Z => Some(z),
            _ => None,
        };
        let tool = &self.spindle_tool;
        match (datum.group, number) {
            (10, 1) => Some(if millimetres(self.flow.unit()) > 1.0 { 1.0 } else { 0.0 }),
            (20 | 60, 1) => tool.number,
            (20, 3) | (60, 2) => Some(self.tool_axis()).filter(|axis| 0.0 <= *axis),
            (20, 4) | (60, 3) => tool.number.and(tool.speed),
            (20, 5) => Some(self.around.spindle_state()),
            (20, 8) => Some(f64::from(u8::from(self.around.has_coolant()))),
            (60, 4) => tool.number.and(tool.length_added),
            (60, 5) => tool.number.and(tool.radius_added),
            (50, column) => {
                let of_index = || {
                    let number = ToolNumber::of(index??).ok()?;
                    let table = self.tools.known()?;
                    table.tools().get(table.row_of(number)?)
                };
                column_of(if index.is_some() { of_index()? } else { tool.of_table.as_ref()? }, column)
            }
            (200, 1) => tool.measures().map(|[_, radius]| radius),
            (200, 2) => tool.measures().map(|[length, _]| length),
            (210, 1) => Some(self.around.basic_rotation()),
            (210, 2) => self.around.is_plain().then_some(0.0),
            (210, 5) => self.around.tilted().get(whole(index??)?.checked_sub(1)?).copied(),
            (210, 6) => Some(if self.around.is_tilted() { -1.0 } else { 0.0 }),
            (220, 2) => place(self.around.shift_in_force()?),
            (IN_MACHINE, 1) => place(self.around.in_machine(self.way.place()?)),
            (270, 1) => place(self.around.in_system(self.way.place()?)?),
            (530, 1) => self.around.preset(),
            _ => None,
        }
    }
}

/// A column of the tool table by its number, mm.
fn column_of(tool: &TableTool, column: usize) -> Option<f64> {
    let mm = |length: Length| Some(length.to_mm_f64());
    let or_none = |length: Option<Length>| Some(length.map_or(0.0, Length::to_mm_f64));
    match column {
        1 => mm(tool.length),
        2 => mm(tool.radius),
        4 => mm(tool.delta_length),
        5 => mm(tool.delta_radius),
        7 => Some(f64::from(u8::from(tool.is_locked))),
        8 => tool.replacement.map_or(Some(0.0), |number| number.to_string().parse().ok()),
        21 => or_none(tool.length_breakage),
        22 => or_none(tool.radius_breakage),
        36 => tool.kind.map(f64::from),
        _ => None,
    }
}
