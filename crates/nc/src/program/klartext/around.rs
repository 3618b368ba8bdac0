//! Blocks around a measurement: what changes the system that coordinates count in, and what is passed over.
//!
//! Known by their first words; what is passed over is not checked further. Forms: `docs/SOURCES.md`, "Around a measurement".

use fitcheck_core::probing::cycle::Control;
use fitcheck_core::probing::cycles::cycles_of;

use super::super::around::{Frame, Goes, Mode, PassedOver};
use super::super::block::Body;
use super::super::cursor::{Cursor, Read, Stop};
use super::super::cycle_block::{CycleBlock, CycleLine, CycleValue};
use super::super::fault::{BlockFault, Wanted};
use super::super::movement::{Axis, AxisWord, MachineFunction};
use super::super::operand::Operand;
use super::super::words::AXES;
use super::path_words::{axis_letter, axis_word, is_machine_function, machine_functions};
use crate::control::variables::Parameter;

/// Where the words of a path end up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum End {
    /// At the axes that the block names; the others stay.
    Written,
    /// At a place that only the control computes, apart from axes that are named.
    Computed,
    /// Where it began: poles, roundings.
    Here,
}

/// Paths by their first word.
const PATHS: [(&str, End); 17] = [
    ("LN", End::Written),
    ("LP", End::Computed),
    ("CC", End::Here),
    ("CR", End::Written),
    ("CTP", End::Computed),
    ("CT", End::Written),
    ("CP", End::Computed),
    ("C", End::Written),
    ("RND", End::Here),
    ("CHF", End::Here),
    ("FLT", End::Computed),
    ("FL", End::Computed),
    ("FCT", End::Computed),
    ("FC", End::Computed),
    ("FPOL", End::Here),
    ("FSELECT", End::Here),
    ("SPL", End::Computed),
];

/// Paths onto a contour and away from it; the words with P have a polar end.
const CONTOUR_ENDS: [(&str, &str, End); 16] = [
    ("APPR", "LT", End::Written),
    ("APPR", "LN", End::Written),
    ("APPR", "CT", End::Written),
    ("APPR", "LCT", End::Written),
    ("APPR", "PLT", End::Computed),
    ("APPR", "PLN", End::Computed),
    ("APPR", "PCT", End::Computed),
    ("APPR", "PLCT", End::Computed),
    ("DEP", "LT", End::Computed),
    ("DEP", "LN", End::Computed),
    ("DEP", "CT", End::Computed),
    ("DEP", "LCT", End::Written),
    ("DEP", "PLT", End::Computed),
    ("DEP", "PLN", End::Computed),
    ("DEP", "PCT", End::Computed),
    ("DEP", "PLCT", End::Computed),
];

/// Blocks by their first two words that move nothing.
const SETTINGS: [(&str, &str); 12] = [
    ("BLK", "FORM"),
    ("TOOL", "DEF"),
    ("PATTERN", "DEF"),
    ("CONTOUR", "DEF"),
    ("DECLARE", "CONTOUR"),
    ("SEL", "PATTERN"),
    ("SEL", "CONTOUR"),
    ("SEL", "TABLE"),
    ("RESET", "TCPM"),
    ("SECTION", "MONITORING"),
    ("MONITORING", "SECTION"),
    ("MONITORING", "HEATMAP"),
];

/// Functions after `FUNCTION` that neither change the system nor files.
const FUNCTIONS: [&str; 16] = [
    "TCPM",
    "DWELL",
    "FEED",
    "S-PULSE",
    "TURNDATA",
    "PARAXCOMP",
    "PARAXMODE",
    "PROG",
    "COUNT",
    "LIFTOFF",
    "DCM",
    "AFC",
    "TOOL",
    "DRESS",
    "RESET",
    "MONITORING",
];

/// The last of the control's own cycles whose lines are blocks of their own: 39, a contour on a cylinder.
const MOST_DOTTED: u32 = 39;

/// A block around a measurement, if it is one.
pub(super) fn around(cursor: &mut Cursor<'_>) -> Read<Option<Body>> {
    if cursor.take_words(&["FUNCTION", "MODE"]) {
        return Ok(mode(cursor));
    }
    if cursor.take_word("FUNCTION") {
        let name = FUNCTIONS.into_iter().find(|name| cursor.take_prefix(name));
        let rest = cursor.take_rest();
        let has = |wanted: &str| rest.split_whitespace().any(|word| word.eq_ignore_ascii_case(wanted));
        // FUNCTION COUNT REPEAT LBL jumps; with parallel axes other axes move than those that are named.
        return Ok(name.filter(|_| !has("LBL")).map(|name| match name {
            "PARAXMODE" if !has("OFF") => Body::Frame(Frame::NotFollowed),
            _ => still(&format!("FUNCTION {name}")),
        }));
    }
    if cursor.take_word("POLARKIN") {
        let ends = cursor.take_word("OFF");
        cursor.take_rest();
        return Ok(Some(if ends { still("POLARKIN") } else { Body::Frame(Frame::NotFollowed) }));
    }
    if cursor.take_word("PLANE") {
        return plane(cursor).map(|frame| Some(Body::Frame(frame)));
    }
    if cursor.take_word("TRANS") {
        return transformation(cursor);
    }
    if cursor.take_words(&["PRESET", "SELECT"]) {
        return preset(cursor);
    }
    if cursor.take_words(&["CYCL", "CALL"]) {
        return path(cursor, "CYCL CALL".to_owned(), End::Computed).map(Some);
    }
    if let Some((first, second, end)) =
        CONTOUR_ENDS.into_iter().find(|(first, second, _)| cursor.take_words(&[first, second]))
    {
        return path(cursor, format!("{first} {second}"), end).map(Some);
    }
    if let Some((first, second)) = SETTINGS.into_iter().find(|(first, second)| cursor.take_words(&[first, second])) {
        cursor.take_rest();
        return Ok(Some(still(&format!("{first} {second}"))));
    }
    match PATHS.into_iter().find(|(word, _)| cursor.take_word(word)) {
        Some((word, end)) => path(cursor, word.to_owned(), end).map(Some),
        None => Ok(None),
    }
}

/// A block that is passed over and moves nothing.
pub(super) fn still(words: &str) -> Body {
    Body::PassedOver(PassedOver { words: words.to_owned(), goes: Goes::default(), machine: Vec::new() })
}

/// The rest of a path: axes and M functions are read, everything else is left.
fn path(cursor: &mut Cursor<'_>, words: String, end: End) -> Read<Body> {
    let mut goes = Goes { is_unknown: end == End::Computed, axes: Vec::new() };
    let mut machine: Vec<MachineFunction> = Vec::new();
    while !cursor.is_at_end() {
        if is_machine_function(cursor) {
            machine = machine_functions(cursor)?;
        } else if let Some(word) = axis(cursor)? {
            goes.axes.push(word);
        } else {
            cursor.take_while(|c| !c.is_whitespace());
        }
    }
    if end == End::Here {
        goes.axes.clear();
    }
    Ok(Body::PassedOver(PassedOver { words, goes, machine }))
}

/// `X+10`, `IY - 5`, if it comes next.
fn axis(cursor: &mut Cursor<'_>) -> Read<Option<AxisWord>> {
    let mut ahead = cursor.clone();
    ahead.take_prefix("I");
    let is_value =
        axis_letter(&mut ahead).is_some() && matches!(ahead.next(), Some('0'..='9' | '+' | '-' | '.' | 'Q' | 'q'));
    if is_value { axis_word(cursor) } else { Ok(None) }
}

/// `PRESET SELECT #3`, after the words. With anything behind the number (`KEEP TRANS`) the block is unknown.
fn preset(cursor: &mut Cursor<'_>) -> Read<Option<Body>> {
    let number = if cursor.take('#') { Some(cursor.operand()?) } else { None };
    let is_known = number.is_some() && cursor.is_at_end();
    cursor.take_rest();
    Ok(is_known.then_some(Body::Frame(Frame::Preset(number))))
}

/// `FUNCTION MODE …`, after the words; a name of a kinematics may follow.
fn mode(cursor: &mut Cursor<'_>) -> Option<Body> {
    let modes = [("MILL", Mode::Mill), ("TURN", Mode::Turn), ("GRIND", Mode::Grind)];
    let mode = modes.into_iter().find(|(word, _)| cursor.take_word(word)).map(|(_, mode)| Body::Mode(mode));
    cursor.take_rest();
    mode
}

/// `PLANE …`, after the word.
fn plane(cursor: &mut Cursor<'_>) -> Read<Frame> {
    if cursor.take_word("RESET") {
        let goes_back = cursor.take_word("TURN") || cursor.take_word("MOVE");
        cursor.take_rest();
        return Ok(if goes_back { Frame::TurnedBack } else { Frame::NoTilt });
    }
    if cursor.take_word("VECTOR") {
        return vectors(cursor);
    }
    if !cursor.take_word("SPATIAL") {
        cursor.take_rest();
        return Ok(Frame::OtherTilt);
    }
    let mut angles = Vec::new();
    let mut left = vec!["SPA", "SPB", "SPC"];
    while let Some(at) = left.iter().position(|word| cursor.take_prefix(word)) {
        left.remove(at);
        angles.push(cursor.operand()?);
    }
    cursor.take_rest();
    // Without all three it is not known what the plane is.
    Ok(if left.is_empty() { Frame::Tilt(angles) } else { Frame::OtherTilt })
}

/// `PLANE VECTOR BX1 BY0 BZ0 NX0 NY0 NZ1 …`, after the words: the base along X and the normal along Z tilt nothing.
fn vectors(cursor: &mut Cursor<'_>) -> Read<Frame> {
    let mut is_level = true;
    for (word, is_along) in [("BX", true), ("BY", false), ("BZ", false), ("NX", false), ("NY", false), ("NZ", true)] {
        is_level &= cursor.take_prefix(word)
            && match cursor.operand()? {
                Operand::Number(value) => {
                    if is_along {
                        0.0 < value
                    } else {
                        value.abs() <= 0.0
                    }
                }
                Operand::Parameter { .. } => false,
            };
    }
    cursor.take_rest();
    Ok(if is_level { Frame::Tilt(vec![Operand::Number(0.0)]) } else { Frame::OtherTilt })
}

/// `TRANS …`, after the word: the newer form of cycles 7, 8, 10 and 11.
fn transformation(cursor: &mut Cursor<'_>) -> Read<Option<Body>> {
    let frame = if cursor.take_word("DATUM") {
        if cursor.take_word("AXIS") {
            let shift = axes(cursor)?;
            if !cursor.is_at_end() {
                cursor.take_rest();
                return Ok(None);
            }
            Frame::Shift(shift)
        } else if cursor.take_word("RESET") {
            // A reset of some axes only is no form that is known.
            if !cursor.is_at_end() {
                cursor.take_rest();
                return Ok(None);
            }
            Frame::NoShift
        } else {
            Frame::ShiftFromTable
        }
    } else if cursor.take_word("MIRROR") {
        cursor.take_word("AXIS");
        let is_reset = cursor.take_word("RESET");
        let axes = letters(cursor);
        if axes.is_empty() != is_reset {
            cursor.take_rest();
            return Ok(None);
        }
        Frame::Mirror(axes)
    } else if cursor.take_word("ROTATION") {
        if cursor.take_word("RESET") { rotation(Operand::Number(0.0), false) } else { rotated(cursor)? }
    } else if cursor.take_word("SCALE") {
        if cursor.take_word("RESET") { Frame::Scaling(Operand::Number(1.0)) } else { scaled(cursor)? }
    } else {
        return Ok(None);
    };
    cursor.take_rest();
    Ok(Some(Body::Frame(frame)))
}

/// Axes with their values, up to the first word that is none.
fn axes(cursor: &mut Cursor<'_>) -> Read<Vec<AxisWord>> {
    let mut found: Vec<AxisWord> = Vec::new();
    loop {
        cursor.blanks();
        let at = cursor.at();
        let Some(word) = axis(cursor)? else { return Ok(found) };
        if found.iter().any(|known| known.axis == word.axis) {
            return Err(Stop { at, reason: BlockFault::AxisTwice });
        }
        found.push(word);
    }
}

/// Axes with their values wherever they stand in the rest of a line, and whether everything else there begins with one of these
/// words.
fn axes_among(cursor: &mut Cursor<'_>, known: &[&str]) -> Read<(Vec<AxisWord>, bool)> {
    let mut found = Vec::new();
    let mut is_known = true;
    while !cursor.is_at_end() {
        if known.iter().any(|word| cursor.take_prefix(word)) {
            cursor.take_while(|c| !c.is_whitespace());
        } else {
            let more = axes(cursor)?;
            if more.is_empty() {
                is_known = false;
                cursor.take_while(|c| !c.is_whitespace());
            }
            found.extend(more);
        }
    }
    Ok((found, is_known))
}

/// Letters of axes, up to the first word that is none.
fn letters(cursor: &mut Cursor<'_>) -> Vec<Axis> {
    let mut found = Vec::new();
    while let Some((_, axis)) = AXES.into_iter().find(|(letter, _)| cursor.take_word(letter)) {
        found.push(axis);
    }
    found
}

const fn rotation(angle: Operand, is_incremental: bool) -> Frame {
    Frame::Rotation { angle, is_incremental }
}

/// `ROT+30`, `IROT+10`
fn rotated(cursor: &mut Cursor<'_>) -> Read<Frame> {
    let is_incremental = cursor.take_prefix("I");
    if !cursor.take_prefix("ROT") {
        return Err(cursor.stop(Wanted::Word("ROT")));
    }
    Ok(rotation(cursor.operand()?, is_incremental))
}

/// `SCL 0.99`
fn scaled(cursor: &mut Cursor<'_>) -> Read<Frame> {
    if !cursor.take_prefix("SCL") {
        return Err(cursor.stop(Wanted::Word("SCL")));
    }
    Ok(Frame::Scaling(cursor.operand()?))
}

/// A cycle of `CYCL DEF` whose lines are blocks of their own: `CYCL DEF 7.1 X+60`, after the two words. `None` for the
/// others, which have their lines within one block.
pub(super) fn dotted(cursor: &mut Cursor<'_>) -> Read<Option<Body>> {
    let mut ahead = cursor.clone();
    let Some((number, part)) = ahead.number_text().and_then(|number| number.split_once('.')) else { return Ok(None) };
    let number = number.to_owned();
    let part = part.to_owned();
    *cursor = ahead;
    let frame = match (number.as_str(), part.as_str()) {
        ("7" | "8" | "10" | "11" | "19" | "26", "0") => {
            let says_more = |word: &str| {
                let is_axis = AXES.iter().any(|(letter, _)| letter.eq_ignore_ascii_case(word));
                is_axis || word.contains(|c: char| c.is_ascii_digit())
            };
            // A value on the line of the name is not known to count, nor not to count.
            if cursor.take_rest().split_whitespace().any(says_more) {
                return Ok(Some(Body::Other));
            }
            Frame::Title
        }
        ("7", _) if cursor.take('#') => {
            cursor.take_rest();
            Frame::ShiftFromTable
        }
        ("7", _) => Frame::Shift(axes(cursor)?),
        ("8", "1") => Frame::Mirror(letters(cursor)),
        ("10", "1") => rotated(cursor)?,
        ("11", "1") => scaled(cursor)?,
        ("19", "1") => {
            let angles: Vec<Operand> = axes(cursor)?.into_iter().map(|word| word.value).collect();
            let is_alone = cursor.is_at_end();
            let (more, is_known) = axes_among(cursor, &["ABST", "DIST", "F"])?;
            // Spatial angles and others are not looked at: only a line without words ends a tilt.
            if !is_known || !more.is_empty() || angles.is_empty() && !is_alone {
                return Ok(Some(Body::Frame(Frame::OtherTilt)));
            }
            Frame::Tilt(angles)
        }
        // How the axes get there.
        ("19", _) => {
            let (angles, is_known) = axes_among(cursor, &["ABST", "DIST", "F"])?;
            if angles.is_empty() && is_known { Frame::Title } else { Frame::OtherTilt }
        }
        ("26", "1") => {
            let (factors, is_known) = axes_among(cursor, &["CC"])?;
            if factors.is_empty() || !is_known {
                return Ok(Some(Body::Other));
            }
            Frame::AxisScaling(factors.into_iter().map(|word| word.value).collect())
        }
        // Further lines of these are not followed; cycle 12 makes a program into a cycle, which CYCL CALL would run. `CYCL DEF .47`
        // names no cycle.
        ("" | "8" | "10" | "11" | "12" | "26", _) => {
            cursor.take_rest();
            return Ok(Some(Body::Other));
        }
        _ => {
            cursor.take_rest();
            // Above those of the control are cycles of the machine's builder.
            return Ok(Some(if number.parse::<u32>().is_ok_and(|number| number <= MOST_DOTTED) {
                still(&format!("CYCL DEF {number}"))
            } else {
                Body::CycleDefinition(CycleBlock { number, name: String::new(), lines: Vec::new() })
            }));
        }
    };
    cursor.end()?;
    Ok(Some(Body::Frame(frame)))
}

/// What a cycle of `CYCL DEF` with its lines says: 247 sets a preset, the others are machining.
pub(in super::super) fn defined(cycle: CycleBlock) -> Body {
    // A measuring cycle begins with TCH PROBE.
    if cycles_of(Control::Milling).any(|known| known.code == cycle.number) {
        return Body::Other;
    }
    if cycle.number != "247" {
        return Body::CycleDefinition(cycle);
    }
    // What else it may say, such as which axes, is not known.
    if cycle.lines.iter().any(|line| line.parameter != Parameter::q(339).into()) {
        return Body::Other;
    }
    let is_preset = |line: &&CycleLine| line.parameter == Parameter::q(339).into();
    let mut presets = cycle.lines.iter().filter(is_preset).map(|line| match line.value {
        CycleValue::Number { value, .. } => Some(value),
        CycleValue::Text(_) | CycleValue::Word(_) => None,
    });
    match (presets.next(), presets.next()) {
        (preset, None) => Body::Frame(Frame::Preset(preset.flatten())),
        // Which of two presets counts is not known.
        (_, Some(_)) => Body::Other,
    }
}
