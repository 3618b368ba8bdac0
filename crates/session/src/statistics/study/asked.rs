//! What is asked of readings: how they are understood, and what they come to.

use std::sync::Arc;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_exchange::series::{
    Answer, Grouping, LeftOut, Series, SeriesError, StudyKind, StudyWanted, Understood, Wanted,
};
use fitcheck_statistics::{Signal, signals};

use super::StudyFile;

/// What is asked.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyAsked {
    pub(super) file: Arc<StudyFile>,
    /// One of several.
    pub(super) feature: Option<String>,
    pub(super) wanted: StudyWanted,
    /// In millimetres; where none is given, those of the file count.
    pub(super) limits: [Option<f64>; 2],
}

/// How readings were understood.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyRead {
    pub understood: Understood,
    /// How many values count.
    pub count: usize,
    /// How many are left out for each reason.
    pub left_out: Vec<(LeftOut, usize)>,
    /// The limits that count, in millimetres.
    pub limits: [Option<f64>; 2],
    /// Whether they are those of the file.
    pub has_own_limits: bool,
}

impl StudyRead {
    /// Whether nothing is missing, and nothing is there too often.
    pub const fn is_whole(&self) -> bool {
        self.understood.faults.is_empty()
    }

    /// Whether the layout looks wrong.
    pub const fn is_doubted(&self) -> bool {
        !self.understood.doubts.is_empty()
    }
}

/// What readings come to.
#[derive(Debug)]
pub struct StudyFound {
    pub answer: Answer,
    /// What fires on the chart of a stability study.
    pub signals: Vec<Signal>,
}

impl StudyAsked {
    fn series(&self) -> Result<Series<'_>, Message> {
        Series::of(&self.file.values, self.feature.as_deref(), Grouping::Single).map_err(|error| refusal(&error))
    }

    /// Whether limits say anything of a study.
    pub(super) fn takes_limits(kind: StudyKind) -> bool {
        kind != StudyKind::Linearity
    }

    /// The limits that count, and whether they are those of the file.
    fn limits(&self, series: &Series<'_>) -> Result<([Option<f64>; 2], bool), Message> {
        if self.limits.iter().any(Option::is_some) || !Self::takes_limits(self.wanted.kind) {
            return Ok((self.limits, false));
        }
        let own = series.limits().map_err(|error| refusal(&error))?;
        Ok((own, own.iter().any(Option::is_some)))
    }

    /// How the readings are understood.
    pub(super) fn understood(&self) -> Result<StudyRead, Message> {
        let series = self.series()?;
        if series.count() == 0 {
            return Err(fitcheck_statistics::Reason::Empty.message());
        }
        let (limits, has_own_limits) = self.limits(&series)?;
        let understood = self.wanted.understood(&series, &Wanted::default()).map_err(|error| error.message())?;
        let left_out = series.left_out().collect();
        Ok(StudyRead { understood, count: series.count(), left_out, limits, has_own_limits })
    }

    /// What they come to.
    ///
    /// # Errors
    /// Why they make no study.
    pub fn evaluate(&self) -> Result<Arc<StudyFound>, Message> {
        let series = self.series()?;
        let (limits, _) = self.limits(&series)?;
        let wanted = Wanted { limits, ..Wanted::default() };
        let answer = Answer::of_study(&series, &wanted, &self.wanted).map_err(|error| error.message())?;
        let signals = answer.chart.as_ref().map_or_else(|_| Vec::new(), signals);
        Ok(Arc::new(StudyFound { answer, signals }))
    }
}

/// Why values are no series of one feature.
fn refusal(error: &SeriesError) -> Message {
    match error {
        SeriesError::Limits => message!("statistics-study-limits-differ"),
        _ => message!("statistics-study-features"),
    }
}
