//! A block with its G functions by what they are about, and what each of them reads of it.

use super::super::cursor::{Parsed, Stop};
use super::super::fault::{BlockFault, ExpectedWord};
use super::super::movement::AxisWord;
use super::super::operand::Operand;
use super::modes::{Measure, Modes};
use super::words::{AxisAt, Function, Words, name};

/// Letters of axes.
pub(super) const ALL_AXES: &str = "XYZABCUVW";

/// A block with its G functions by what they are about.
pub(super) struct Block<'w, 'a> {
    pub words: &'w Words<'a>,
    pub main: Option<Function>,
    pub plane: Option<Function>,
    pub compensation: Option<Function>,
    pub measure: Option<Function>,
}

impl Block<'_, '_> {
    /// G90 or G91 in this block.
    pub(super) fn stated(&self) -> Option<Measure> {
        self.measure.map(|measure| if measure.number == 90 { Measure::Absolute } else { Measure::Incremental })
    }

    /// The axes with their values, as they count in this block.
    pub(super) fn axes(&self, modes: &Modes) -> Parsed<Vec<AxisWord>> {
        let Some(first) = self.words.axes.first() else { return Ok(Vec::new()) };
        // Whether it counts for the axes before it is on no page that we found.
        if let Some(late) = self.measure.filter(|measure| first.at < measure.at) {
            return Err(Stop { at: late.at, reason: BlockFault::LeftOver { found: name(late.number) } });
        }
        let Some(measure) = modes.measure else { return Err(measure_unknown(first.at)) };
        let is_incremental = measure == Measure::Incremental;
        let word = |AxisAt { axis, value, at }: AxisAt| match value {
            Some(value) => Ok(AxisWord { axis, is_incremental, value }),
            None => Err(Stop { at, reason: BlockFault::Missing(ExpectedWord::Value) }),
        };
        self.words.axes.iter().copied().map(word).collect()
    }

    /// An error if a G function is there that means nothing here.
    pub(super) fn refuse(&self, function: Option<Function>) -> Parsed<()> {
        match (function, self.main) {
            (None, _) => Ok(()),
            (Some(Function { number, at }), None) => {
                Err(Stop { at, reason: BlockFault::LeftOver { found: name(number) } })
            }
            (Some(Function { number, at }), Some(main)) => {
                Err(Stop { at, reason: BlockFault::NotTogether { one: name(main.number), other: name(number) } })
            }
        }
    }
}

/// The reason that a value could count from either place.
pub(super) const fn measure_unknown(at: usize) -> Stop {
    Stop { at, reason: BlockFault::MeasureUnknown }
}

/// The value of a word that a G function needs.
pub(super) fn needed(block: &Block<'_, '_>, main: Function, word: &'static str) -> Parsed<Operand> {
    block.words.value(word).ok_or(Stop { at: main.at, reason: BlockFault::Missing(ExpectedWord::Word(word)) })
}
