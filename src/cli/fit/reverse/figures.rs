//! What a search found in figures, for CSV and JSON.

use serde::Serialize;

use crate::cli::Figure;
use crate::cli::fit::figures::{um, words};
use crate::length::Length;
use crate::tolerance::fit::search::Candidate;

/// The columns of CSV, in order: the names of a candidate.
pub(super) const COLUMNS: [&str; 9] = [
    "callout",
    "hole",
    "shaft",
    "kind",
    "minimum_clearance_um",
    "maximum_clearance_um",
    "basis",
    "preferred",
    "function",
];

/// The answer for programs.
#[derive(Debug, Serialize)]
pub(super) struct Figures {
    pub nominal_mm: Figure,
    pub minimum_clearance_um: Option<Figure>,
    pub maximum_clearance_um: Option<Figure>,
    pub scope: Option<&'static str>,
    pub function: Option<&'static str>,
    pub total: usize,
    pub candidates: Vec<CandidateFigures>,
    pub nearest: Option<MissFigures>,
}

#[derive(Debug, Serialize)]
pub(super) struct CandidateFigures {
    pub callout: String,
    pub hole: String,
    pub shaft: String,
    pub kind: &'static str,
    pub minimum_clearance_um: Figure,
    pub maximum_clearance_um: Figure,
    pub basis: Option<&'static str>,
    pub preferred: Option<&'static str>,
    pub function: Option<&'static str>,
}

#[derive(Debug, Serialize)]
pub(super) struct MissFigures {
    pub candidate: CandidateFigures,
    pub below_um: Figure,
    pub above_um: Figure,
}

impl CandidateFigures {
    pub(super) fn of(size: Length, candidate: &Candidate) -> Self {
        let [basis, preferred, function] = words(candidate.hole, candidate.shaft);
        Self {
            callout: format!("{size} {}/{}", candidate.hole, candidate.shaft),
            hole: candidate.hole.to_string(),
            shaft: candidate.shaft.to_string(),
            kind: candidate.kind().word(),
            minimum_clearance_um: um(candidate.minimum),
            maximum_clearance_um: um(candidate.maximum),
            basis,
            preferred,
            function,
        }
    }

    pub(super) fn cells(&self) -> [&str; 9] {
        let or_empty = |word: Option<&'static str>| word.unwrap_or_default();
        [
            &self.callout,
            &self.hole,
            &self.shaft,
            self.kind,
            &self.minimum_clearance_um.0,
            &self.maximum_clearance_um.0,
            or_empty(self.basis),
            or_empty(self.preferred),
            or_empty(self.function),
        ]
    }
}
