//! What reports that were printed for people have in common: figures with so many decimals, lines that are no measurement, an end that may be
//! missing.
//!
//! | file | what |
//! |---|---|
//! | here | the lines of a report, and the figures of a row |
//! | `error` | what is wrong with a report, and what is said of one |
//! | `row` | a row of a name and figures, judged |
//!
//! A printed figure was rounded: its value lies within half of the last decimal. Figures that a report computed are compared no finer.

mod error;
mod row;

use std::sync::Arc;

pub use error::{PrintedFault, PrintedWarning};
use fitcheck_core::length::{Length, LengthError, Unit};
use fitcheck_core::message::FilePlace;
use fitcheck_core::probing::Origin;
use fitcheck_core::text::{PLAIN_LINE_END_BYTES, PLAIN_LINE_ENDS, plain_lines_from};
use fitcheck_core::verdict::Status;
use jiff::civil::DateTime;
pub(super) use row::{Figure, PrintedRow};

use super::Labels;
use super::claim::Claim;
use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::imported::{Sink, StatedLimits, Unjudged, WhyUnjudged};
use super::index::LONGEST_ROW;
use super::source::{Context, Source};

impl From<PrintedFault> for ImportErrorKind {
    fn from(fault: PrintedFault) -> Self {
        Self::Printed(fault)
    }
}

impl From<PrintedWarning> for ImportWarningKind {
    fn from(warning: PrintedWarning) -> Self {
        Self::Printed(warning)
    }
}

/// A line of a report that is not blank.
#[derive(Debug, Clone, Copy)]
pub(super) struct PrintedLine<'t> {
    /// Its number, from 1.
    pub(super) number: usize,
    pub(super) text: &'t str,
    /// Whether it ends the file without a line end.
    pub(super) is_open: bool,
}

/// Hands out the lines until `take` wants no more; blank ones and rulers are left out.
///
/// # Errors
/// [`ImportErrorKind::Read`] with what the system says.
pub(super) fn each_line(
    source: &mut Source<'_>,
    take: &mut dyn FnMut(PrintedLine<'_>) -> bool,
) -> Result<(), ImportErrorKind> {
    let mut pieces = source.pieces(PLAIN_LINE_END_BYTES)?;
    let mut first = 1;
    while let Some(piece) = pieces.next()? {
        let ends_open = !piece.ends_with(PLAIN_LINE_ENDS);
        let mut lines = plain_lines_from(&piece, first).peekable();
        while let Some((number, text)) = lines.next() {
            first = number + 1;
            let is_open = ends_open && lines.peek().is_none();
            let has_text = text.contains(|sign: char| !sign.is_whitespace() && !"-=_*.#|\u{1a}".contains(sign));
            if has_text && !take(PrintedLine { number, text, is_open }) {
                return Ok(());
            }
        }
    }
    Ok(())
}

impl PrintedLine<'_> {
    /// Why a row cannot be read whatever stands in it: half a number would be judged as a whole one. `is_complete` where something behind
    /// its last figure shows that it is whole.
    pub(super) fn broken(&self, is_complete: bool) -> Option<ImportErrorKind> {
        if LONGEST_ROW < self.text.len() {
            return Some(ImportErrorKind::RowTooLong { most: LONGEST_ROW >> 10 });
        }
        if self.text.contains('\0') {
            return Some(PrintedFault::Zeros.into());
        }
        (self.is_open && !is_complete).then(|| PrintedFault::CutOff.into())
    }
}

/// A number as it was printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Printed {
    pub(super) length: Length,
    /// One of its last decimal, which is how far two figures of a report may differ by rounding.
    pub(super) step: Length,
}

impl Printed {
    /// # Errors
    /// [`LengthError`] where the text is no length.
    pub(super) fn read(text: &str, unit: Unit) -> Result<Self, LengthError> {
        let (length, _) = Length::parse_rounded(text, unit)?;
        let decimals = text.rsplit_once(['.', ',']).map_or(0, |(_, decimals)| decimals.len());
        let one = format!("0.{}1", "0".repeat(decimals.saturating_sub(1)));
        let step = Length::parse_rounded(if decimals == 0 { "1" } else { &one }, unit)?.0;
        Ok(Self { length, step })
    }

    /// How far the value may lie from the figure.
    pub(super) fn rounded_by(self) -> Length {
        Length::from_nanometres(self.step.nanometres() / 2).unwrap_or(Length::ZERO)
    }

    /// Whether it is another length than the figures of its row make, beyond what rounding does.
    fn is_another(self, expected: Length) -> bool {
        self.step < self.length.saturating_sub(expected).abs()
    }
}

/// What a report computed of a value beside it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Computed {
    pub(super) deviation: Option<Printed>,
    /// How far the value is beyond its limits; 0 within them.
    pub(super) beyond: Option<Printed>,
}

impl Computed {
    /// What the report says of the status; `said` is the name of the column with its figure.
    pub(super) fn claim(&self, said: &str) -> Option<Claim> {
        let beyond = self.beyond?;
        let is_within = beyond.length == Length::ZERO;
        Some(if is_within { Claim::of(said, Status::Good) } else { Claim::out(said) })
    }

    /// What is told where the report computed something else than its figures give. That it calls a value good which is none is told with
    /// the verdict.
    pub(super) fn tells(&self, measured: Length, asked: &StatedLimits) -> Vec<PrintedWarning> {
        let mut told = Vec::new();
        if let Some((given, nominal)) = self.deviation.zip(asked.nominal) {
            let expected = measured.saturating_sub(nominal);
            if given.is_another(expected) {
                told.push(PrintedWarning::Deviation { given: given.length, expected });
            }
        }
        let above = asked.maximum.map(|maximum| measured.saturating_sub(maximum));
        let below = asked.minimum.map(|minimum| minimum.saturating_sub(measured));
        let expected = above.into_iter().chain(below).max().filter(|beyond| Length::ZERO < *beyond);
        if let Some((given, expected)) = self.beyond.filter(|given| given.length != Length::ZERO).zip(expected) {
            let size = Printed { length: given.length.abs(), ..given };
            if size.is_another(expected) {
                told.push(PrintedWarning::Beyond { given: size.length, expected });
            }
        }
        told
    }
}

/// Lines that are no measurement, told once.
#[derive(Debug, Default)]
pub(super) struct LeftLines(Option<(usize, usize, String)>);

impl LeftLines {
    /// One more.
    pub(super) fn add(&mut self, line: PrintedLine<'_>) {
        match &mut self.0 {
            Some((_, count, _)) => *count += 1,
            None => self.0 = Some((line.number, 1, shorten(line.text.trim()))),
        }
    }

    /// Tells them.
    pub(super) fn tell(self, sink: &mut Sink<'_>) {
        if let Some((line, count, text)) = self.0 {
            sink.warn(FilePlace::line(line), None, PrintedWarning::Lines { count, text }.into());
        }
    }
}

/// Sets a value aside that is no length, or that the report has no figure for.
pub(super) fn set_aside(
    line: usize,
    id: String,
    labels: Labels,
    time: Option<DateTime>,
    why: WhyUnjudged,
    context: &Context<'_>,
) -> Unjudged {
    Unjudged {
        line,
        id,
        labels,
        time: time.unwrap_or(context.now),
        measured: None,
        origin: Origin::Imported { file: Arc::clone(&context.file) },
        position: None,
        asked: StatedLimits::default(),
        correction: None,
        why,
    }
}
