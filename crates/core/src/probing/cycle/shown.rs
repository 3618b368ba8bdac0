//! How a control shows and writes a result: its status window and its measuring log, as a cycle declares them.

use super::meaning::{Axis, Meaning};
use super::result::ResultName;

/// The status window that a cycle's result is drawn in.
#[derive(Debug, Clone, Copy)]
pub enum Window {
    /// None: the cycle judges nothing.
    None,
    /// The one of program 82551, which shows a diameter.
    Diameter,
    /// One with a mask of the cycle's own, by its name: `427` is drawn with `427_nl.a` and so on.
    Own(&'static str),
}

/// The measuring log of a cycle.
#[derive(Debug, Clone, Copy)]
pub enum Log {
    /// None at all.
    None,
    /// None; the control shows the result on its screen.
    Screen,
    /// A text with the same sections for all cycles, requested by Q281.
    Text(TextLog),
    /// A page of points with their deviations along the normal; written after every run.
    Points {
        /// The name of the file.
        file: &'static str,
    },
}

/// A log as a text: sections of nominal values, limits, actual values and deviations.
#[derive(Debug, Clone, Copy)]
pub struct TextLog {
    /// The name of the file.
    pub file: &'static str,
    /// Its figures, in the order that every section uses.
    pub figures: &'static [LogFigure],
}

/// A measured value in the sections of a log.
#[derive(Debug, Clone, Copy)]
pub struct LogFigure {
    /// The result that is its actual value.
    pub what: ResultName,
    /// Its words in `assets/logs`: those of the value, its maximum and its minimum.
    pub word: &'static str,
    /// What is given besides the actual value.
    pub kind: FigureKind,
}

/// What is given besides the actual value of a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FigureKind {
    /// A coordinate of a centre: nominal value, symmetrical limits, deviation. Outside the limits it is scrap.
    Centre(Axis),
    /// A size: the nominal value from the parameter of this meaning, limits (0 and 0 monitor nothing), deviation.
    Size(Meaning),
    /// A coordinate: limits (0 and 0 monitor nothing); a nominal value and a deviation only where the log has them.
    Coordinate,
    /// Nothing: the value is for information only.
    Information,
}

impl LogFigure {
    /// Whether it has a nominal value, limits and a deviation.
    pub fn is_limited(&self) -> bool {
        self.kind != FigureKind::Information
    }
}

impl TextLog {
    /// The figures that have nominal values, limits and deviations.
    pub fn limited(&self) -> impl Iterator<Item = &'static LogFigure> + use<> {
        self.figures.iter().filter(|figure| figure.is_limited())
    }
}

impl Log {
    /// The name of the file; `None` where there is none.
    pub const fn file(&self) -> Option<&'static str> {
        match self {
            Self::None | Self::Screen => None,
            Self::Text(log) => Some(log.file),
            Self::Points { file } => Some(file),
        }
    }
}
