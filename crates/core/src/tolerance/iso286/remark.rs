//! What a reader should know about a figure of the standard: contested, provisional, rounded.

use super::{Grade, JsHalves, Letter, Options, millimetres};
use crate::length::Length;
use crate::message::Say;
use crate::tolerance::deviations::Deviations;

/// Something that a reader should know about a figure. The numbers of the rules are those of `docs/SOURCES.md`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "iso286")]
pub enum Remark {
    /// Half micrometres of JS or js were rounded off, as the 1988 edition allows (rule 5).
    JsRounded,
    /// ef and EF above 18 up to 30 mm: transcriptions differ; 28 is the geometric mean of e and f (rule 8).
    ContestedEf,
    /// IT5 above 800 mm: older catalogues have a narrower row.
    OlderIt5,
    /// IT1 to IT5 above 500 mm are meant for trial use (rule 9).
    TrialUse,
}

impl Remark {
    /// Whether the figure may be another one elsewhere. Rounding was asked for.
    pub const fn is_doubt(self) -> bool {
        matches!(self, Self::ContestedEf | Self::OlderIt5 | Self::TrialUse)
    }
}

/// The most important remark about a cell.
pub(super) fn remark(
    letter: Letter,
    grade: Grade,
    nominal: Length,
    deviations: Deviations,
    options: Options,
) -> Option<Remark> {
    let above = |mm| millimetres(mm) < nominal;
    let is_rounded = || super::standard_tolerance(grade, nominal).is_none_or(|whole| deviations.width() != whole);
    if letter == Letter::Js && options.js == JsHalves::Rounded && is_rounded() {
        Some(Remark::JsRounded)
    } else if letter == Letter::Ef && above(18) && !above(30) {
        Some(Remark::ContestedEf)
    } else if grade == Grade::IT5 && above(800) {
        Some(Remark::OlderIt5)
    } else if grade.at_most(5) && above(500) {
        Some(Remark::TrialUse)
    } else {
        None
    }
}
