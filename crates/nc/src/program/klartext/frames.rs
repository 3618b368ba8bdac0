//! Blocks that change the system that coordinates count in: `PLANE`, `TRANS`, `PRESET SELECT`, and the cycles of `CYCL DEF` whose lines are
//! blocks of their own.

use super::super::around::Frame;
use super::super::block::{Body, still};
use super::super::cursor::{Cursor, Parsed, Stop};
use super::super::cycle_block::CycleBlock;
use super::super::fault::{BlockFault, ExpectedWord};
use super::super::movement::{Axis, AxisWord};
use super::super::operand::Operand;
use super::super::words::AXES;
use super::path_words::axis;

/// The last of the control's own cycles whose lines are blocks of their own: 39, a contour on a cylinder.
const MOST_DOTTED: u32 = 39;

/// `PRESET SELECT #3`, after the words. With anything behind the number (`KEEP TRANS`) the block is unknown.
pub(super) fn preset(cursor: &mut Cursor<'_>) -> Parsed<Option<Body>> {
    let number = if cursor.take('#') { Some(cursor.operand()?) } else { None };
    let is_known = number.is_some() && cursor.is_at_end();
    cursor.take_rest();
    Ok(is_known.then_some(Body::Frame(Frame::Preset(number))))
}

/// `PLANE …`, after the word.
pub(super) fn plane(cursor: &mut Cursor<'_>) -> Parsed<Frame> {
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
    let mut left = vec![("SPA", Axis::A), ("SPB", Axis::B), ("SPC", Axis::C)];
    while let Some(at) = left.iter().position(|(word, _)| cursor.take_prefix(word)) {
        let (_, axis) = left.remove(at);
        angles.push(AxisWord { axis, value: cursor.operand()?, is_incremental: false });
    }
    let axes_stay = stays(cursor);
    // Without all three it is not known what the plane is.
    Ok(if left.is_empty() { Frame::Tilt { angles, axes_stay } } else { Frame::OtherTilt })
}

/// `PLANE VECTOR BX1 BY0 BZ0 NX0 NY0 NZ1 …`, after the words: the base along X and the normal along Z tilt nothing.
fn vectors(cursor: &mut Cursor<'_>) -> Parsed<Frame> {
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
    let axes_stay = stays(cursor);
    Ok(if is_level { Frame::Tilt { angles: Vec::new(), axes_stay } } else { Frame::OtherTilt })
}

/// Whether the rotary axes stay, in the rest of a PLANE block.
fn stays(cursor: &mut Cursor<'_>) -> bool {
    cursor.take_rest().split_whitespace().any(|word| word.eq_ignore_ascii_case("STAY"))
}

/// `TRANS …`, after the word: the newer form of cycles 7, 8, 10 and 11.
pub(super) fn transformation(cursor: &mut Cursor<'_>) -> Parsed<Option<Body>> {
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
fn axes(cursor: &mut Cursor<'_>) -> Parsed<Vec<AxisWord>> {
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
fn axes_among(cursor: &mut Cursor<'_>, known: &[&str]) -> Parsed<(Vec<AxisWord>, bool)> {
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

const fn is_rotary(axis: Axis) -> bool {
    matches!(axis, Axis::A | Axis::B | Axis::C)
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
fn rotated(cursor: &mut Cursor<'_>) -> Parsed<Frame> {
    let is_incremental = cursor.take_prefix("I");
    if !cursor.take_prefix("ROT") {
        return Err(cursor.stop(ExpectedWord::Word("ROT")));
    }
    Ok(rotation(cursor.operand()?, is_incremental))
}

/// `SCL 0.99`
fn scaled(cursor: &mut Cursor<'_>) -> Parsed<Frame> {
    if !cursor.take_prefix("SCL") {
        return Err(cursor.stop(ExpectedWord::Word("SCL")));
    }
    Ok(Frame::Scaling(cursor.operand()?))
}

/// A cycle of `CYCL DEF` whose lines are blocks of their own: `CYCL DEF 7.1 X+60`, after the two words. `None` for the
/// others, which have their lines within one block.
pub(super) fn dotted(cursor: &mut Cursor<'_>) -> Parsed<Option<Body>> {
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
            let angles = axes(cursor)?;
            let is_alone = cursor.is_at_end();
            let (more, is_known) = axes_among(cursor, &["ABST", "DIST", "F"])?;
            let are_angles = angles.iter().all(|word| is_rotary(word.axis) && !word.is_incremental);
            // Only a line without words ends a tilt. How the axes get there is said elsewhere.
            if !is_known || !are_angles || !more.is_empty() || angles.is_empty() && !is_alone {
                return Ok(Some(Body::Frame(Frame::OtherTilt)));
            }
            Frame::Tilt { angles, axes_stay: true }
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
                still(format!("CYCL DEF {number}"))
            } else {
                Body::CycleDefinition(CycleBlock { number, name: String::new(), lines: Vec::new() })
            }));
        }
    };
    cursor.end()?;
    Ok(Some(Body::Frame(frame)))
}
