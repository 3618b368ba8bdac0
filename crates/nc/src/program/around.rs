//! Blocks around a measurement: what changes the system that it counts in, and what is passed over.
//!
//! Forms and effects: manuals and public programs, see `docs/SOURCES.md`, "Around a measurement".

use super::movement::{Axis, AxisWord, MachineFunction};
use super::operand::Operand;

/// A block that is understood and changes nothing that a measurement depends on: machining, graphics, the machine's own
/// functions. A run passes it over and counts it.
#[derive(Debug, Clone, PartialEq)]
pub struct PassedOver {
    /// Its first words in the language of the program, as they are counted: `APPR LCT`, `CYCL DEF 200`, `G02`.
    pub words: String,
    /// Where the tool is afterwards.
    pub goes: Goes,
    /// Its M functions: these act as in any block.
    pub machine: Vec<MachineFunction>,
}

/// Where the tool is after a block whose path is not followed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Goes {
    /// Whether the path ends at a place of the plane that only the control knows.
    pub is_unknown: bool,
    /// Axes whose end is written.
    pub axes: Vec<AxisWord>,
}

/// What a control is set up for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Mode {
    /// `FUNCTION MODE MILL`: the measuring cycles 4xx run only here (TNC7 basic, user's manual).
    Mill,
    /// `FUNCTION MODE TURN`
    Turn,
    /// `FUNCTION MODE GRIND`
    Grind,
}

/// As it is written.
impl std::fmt::Display for Mode {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Mill => "MILL",
            Self::Turn => "TURN",
            Self::Grind => "GRIND",
        })
    }
}

fitcheck_core::message::as_text!(Mode);

/// A change of the system that coordinates count in. Each stays until it is changed or ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Frame {
    /// `CYCL DEF 7.0 DATUM SHIFT`: a title whose further lines are blocks of their own.
    Title,
    /// `CYCL DEF 7.1 X+60`, `TRANS DATUM AXIS X+10`, `G54`: axes that are not named keep their shift.
    Shift(Vec<AxisWord>),
    /// `TRANS DATUM RESET`
    NoShift,
    /// `CYCL DEF 7.1 #5`, `TRANS DATUM TABLE TABLINE 5`, `G53`: a row of a datum table, which only the control has.
    ShiftFromTable,
    /// `CYCL DEF 247` with Q339, `G247`: a preset of the control's table becomes the zero; ends all other changes.
    Preset(Option<Operand>),
    /// `CYCL DEF 10.1 ROT+30`, `G73`: degrees; 0 ends it.
    Rotation {
        angle: Operand,
        /// Whether it is added to the present one.
        is_incremental: bool,
    },
    /// `CYCL DEF 8.1 X Y`, `G28`: no axis ends it.
    Mirror(Vec<Axis>),
    /// `CYCL DEF 11.1 SCL 0.99`, `G72`: 1 ends it.
    Scaling(Operand),
    /// `CYCL DEF 26.1 X0.99 Y1.01`: scaling axis by axis.
    AxisScaling(Vec<Operand>),
    /// `PLANE SPATIAL SPA+0 SPB+30 SPC+0`, `CYCL DEF 19.1 A+0 B-90`, `G80`: spatial angles; all 0, or none, ends it.
    Tilt {
        /// A, B and C in degrees, as far as they are written.
        angles: Vec<AxisWord>,
        /// Whether the rotary axes stay where they are (`STAY`).
        axes_stay: bool,
    },
    /// A tilt by anything other than angles: `PLANE VECTOR`, `PLANE POINTS`.
    OtherTilt,
    /// `PLANE RESET STAY`: the rotary axes stay where they are.
    NoTilt,
    /// `PLANE RESET TURN`, `PLANE RESET MOVE`: the rotary axes go back to zero.
    TurnedBack,
    /// A change that is not followed here: system data that are written, another kinematics, a cycle of the machine's builder.
    NotFollowed,
}
