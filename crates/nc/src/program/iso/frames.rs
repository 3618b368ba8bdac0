//! G functions that change the system of coordinates.
//!
//! What they do is on the pages that we found; the letters behind G72, G73 and G80 are general knowledge.

use super::super::around::Frame;
use super::super::cursor::{Parsed, Stop};
use super::super::fault::{BlockFault, ExpectedWord};
use super::super::movement::AxisWord;
use super::g_block::{ALL_AXES, Block, measure_unknown, needed};
use super::modes::{Measure, Modes};
use super::words::Function;

/// The change that a block makes.
pub(super) fn frame(block: &Block<'_, '_>, main: Function, modes: &Modes) -> Parsed<Frame> {
    let words = block.words;
    match main.number {
        // A row of a table that only the control has: which one makes no difference.
        53 => {
            words.only("P")?;
            Ok(Frame::ShiftFromTable)
        }
        54 => {
            words.only(ALL_AXES)?;
            let axes = block.axes(modes)?;
            if axes.is_empty() {
                return Err(Stop { at: main.at, reason: BlockFault::Missing(ExpectedWord::Value) });
            }
            Ok(Frame::Shift(axes))
        }
        28 => {
            words.only(ALL_AXES)?;
            match words.axes.iter().find(|word| word.value.is_some()) {
                Some(word) => Err(Stop { at: word.at, reason: BlockFault::LeftOver { found: "+".to_owned() } }),
                None => Ok(Frame::Mirror(words.axes.iter().map(|word| word.axis).collect())),
            }
        }
        72 => {
            words.only("F")?;
            needed(block, main, "F").map(Frame::Scaling)
        }
        73 => {
            words.only("H")?;
            let angle = needed(block, main, "H")?;
            let measure = modes.measure.ok_or_else(|| measure_unknown(main.at))?;
            Ok(Frame::Rotation { angle, is_incremental: measure == Measure::Incremental })
        }
        _ => {
            words.only("ABC")?;
            let angle = |word: &super::words::AxisAt| {
                let value = word.value.ok_or(Stop { at: word.at, reason: BlockFault::Missing(ExpectedWord::Value) })?;
                Ok(AxisWord { axis: word.axis, value, is_incremental: false })
            };
            let angles = words.axes.iter().map(angle).collect::<Parsed<_>>()?;
            Ok(Frame::Tilt { angles, axes_stay: true })
        }
    }
}
