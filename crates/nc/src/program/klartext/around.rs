//! Blocks around a measurement by their first words, and what is passed over.
//!
//! Known by their first words; what is passed over is not checked further. Forms: `docs/SOURCES.md`, "Around a measurement".

use fitcheck_core::probing::cycle::Control;
use fitcheck_core::probing::cycles::cycles_of;

use super::super::around::{Frame, Goes, Mode, PassedOver};
use super::super::block::{Body, FileFunction, still};
use super::super::cursor::{Cursor, Parsed};
use super::super::cycle_block::{CycleBlock, CycleLine, CycleValue};
use super::super::movement::MachineFunction;
use super::frames::{plane, preset, transformation};
use super::path_words::{axis, is_machine_function, machine_functions};
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

/// A block around a measurement, if it is one.
pub(super) fn around(cursor: &mut Cursor<'_>) -> Parsed<Option<Body>> {
    if cursor.take_words(&["FUNCTION", "MODE"]) {
        return Ok(mode(cursor));
    }
    if let Some(function) = file_function(cursor)? {
        return Ok(Some(Body::File(function)));
    }
    if cursor.take_word("FUNCTION") {
        let name = FUNCTIONS.into_iter().find(|name| cursor.take_prefix(name));
        let rest = cursor.take_rest();
        let has = |wanted: &str| rest.split_whitespace().any(|word| word.eq_ignore_ascii_case(wanted));
        // FUNCTION COUNT REPEAT LBL jumps; with parallel axes other axes move than those that are named.
        return Ok(name.filter(|_| !has("LBL")).map(|name| match name {
            "PARAXMODE" if !has("OFF") => Body::Frame(Frame::NotFollowed),
            _ => still(format!("FUNCTION {name}")),
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
        return Ok(Some(still(format!("{first} {second}"))));
    }
    match PATHS.into_iter().find(|(word, _)| cursor.take_word(word)) {
        Some((word, end)) => path(cursor, word.to_owned(), end).map(Some),
        None => Ok(None),
    }
}

/// `FUNCTION FILECOPY "a" TO "b"`; newer controls write `FUNCTION FILE COPY`. A path may stand in a QS parameter.
fn file_function(cursor: &mut Cursor<'_>) -> Parsed<Option<FileFunction>> {
    let mut ahead = cursor.clone();
    let is_file = ahead.take_word("FUNCTION");
    let does = ["COPY", "MOVE", "DELETE"]
        .into_iter()
        .find(|word| ahead.take_word(&format!("FILE{word}")) || ahead.take_words(&["FILE", word]));
    let Some(does) = does.filter(|_| is_file) else { return Ok(None) };
    *cursor = ahead;
    let from = cursor.path(Some(' '))?;
    if does == "DELETE" {
        return Ok(Some(FileFunction::Delete(from)));
    }
    cursor.expect_word("TO")?;
    let to = cursor.path(Some(' '))?;
    Ok(Some(if does == "COPY" { FileFunction::Copy { from, to } } else { FileFunction::Move { from, to } }))
}

/// The rest of a path: axes and M functions are read, everything else is left.
fn path(cursor: &mut Cursor<'_>, words: String, end: End) -> Parsed<Body> {
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

/// `FUNCTION MODE …`, after the words; a name of a kinematics may follow.
fn mode(cursor: &mut Cursor<'_>) -> Option<Body> {
    let modes = [("MILL", Mode::Mill), ("TURN", Mode::Turn), ("GRIND", Mode::Grind)];
    let mode = modes.into_iter().find(|(word, _)| cursor.take_word(word)).map(|(_, mode)| Body::Mode(mode));
    cursor.take_rest();
    mode
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
