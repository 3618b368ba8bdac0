//! Cycles 0 and 1, which probe one point. Each is written in blocks of its own (`TCH PROBE 0.0`, `0.1`); what they say stands in the line.
//!
//! Forms and meaning are remembered (`docs/SOURCES.md`, "One point").

use super::cursor::Cursor;
use super::cycle_block::CycleBlock;
use super::klartext::axis;
use super::movement::{Axis, AxisWord};
use super::operand::Operand;
use super::words::AXES;
use crate::control::variables::Parameter;

/// What a block of cycle 0 or 1 says.
#[derive(Debug, Clone, PartialEq)]
pub enum PointProbe {
    /// `TCH PROBE 0.0 REF. PLANE Q5 X-`: along an axis; the coordinate goes into a parameter.
    Plane {
        /// Q, QL or QR.
        to: Parameter,
        axis: Axis,
        is_negative: bool,
    },
    /// `TCH PROBE 1.0 POLAR PRESET`: the direction follows.
    Polar,
    /// `TCH PROBE 1.1 X ANGLE: +30`: so many degrees from an axis of the plane.
    Direction { from: Axis, angle: Operand },
    /// `TCH PROBE 0.1 X+5 Y+0 Z-5`, `TCH PROBE 1.2 X+5 Y+0 Z-5`: where the probing begins.
    At(Vec<AxisWord>),
}

impl CycleBlock {
    /// What a block of cycle 0 or 1 says; `None` for another one, and for one that says something else.
    pub fn point(&self) -> Option<PointProbe> {
        if !self.lines.is_empty() {
            return None;
        }
        match self.number.as_str() {
            "0.0" => plane(&self.name),
            "1.0" => Some(PointProbe::Polar),
            "1.1" => direction(&self.name),
            "0.1" | "1.2" => place(&self.name),
            _ => None,
        }
    }
}

/// `REF. PLANE Q5 X-`: the last two words count.
fn plane(text: &str) -> Option<PointProbe> {
    let mut words = text.split_whitespace().rev();
    let (last, before) = (words.next()?, words.next()?);
    // The sign may stand apart from its axis.
    let (axis, sign, parameter) = match last {
        "+" | "-" => (before, last, words.next()?),
        _ => {
            let (axis, sign) = last.split_at_checked(last.len().checked_sub(1)?)?;
            (axis, sign, before)
        }
    };
    let (_, axis) = AXES.into_iter().find(|(letter, _)| letter.eq_ignore_ascii_case(axis))?;
    let is_linear = matches!(axis, Axis::X | Axis::Y | Axis::Z) && matches!(sign, "+" | "-");
    let mut cursor = Cursor::new(parameter);
    let to = cursor.parameter().ok().flatten().filter(|_| is_linear)?;
    cursor.is_at_end().then_some(PointProbe::Plane { to, axis, is_negative: sign == "-" })
}

/// `X ANGLE: +30`, with the word for the angle in any language.
fn direction(text: &str) -> Option<PointProbe> {
    let (letter, rest) = text.trim().split_once(char::is_whitespace)?;
    let (_, from) = AXES.into_iter().find(|(known, _)| known.eq_ignore_ascii_case(letter))?;
    let (_, angle) = rest.split_once([':', '='])?;
    let mut cursor = Cursor::new(angle);
    let angle = cursor.operand().ok().filter(|_| matches!(from, Axis::X | Axis::Y | Axis::Z))?;
    cursor.is_at_end().then_some(PointProbe::Direction { from, angle })
}

/// `X+5 Y+0 Z-5`: linear axes, each once.
fn place(text: &str) -> Option<PointProbe> {
    let mut cursor = Cursor::new(text);
    let mut axes: Vec<AxisWord> = Vec::new();
    while !cursor.is_at_end() {
        let word = axis(&mut cursor).ok().flatten()?;
        let is_new = axes.iter().all(|known| known.axis != word.axis);
        axes.push(Some(word).filter(|word| is_new && matches!(word.axis, Axis::X | Axis::Y | Axis::Z))?);
    }
    (!axes.is_empty()).then_some(PointProbe::At(axes))
}
