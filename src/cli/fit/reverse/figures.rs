//! The result of a search in figures, for CSV and JSON.

use serde::Serialize;

use crate::cli::Figure;
use crate::cli::fit::figures::words;
use crate::length::Length;
use crate::report::columns::{Cell as _, Column, columns};
use crate::tolerance::fit::search::Candidate;

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
    /// The columns of CSV.
    pub(super) const COLUMNS: [Column<Self>; 9] = columns! {
        callout, hole, shaft, kind, minimum_clearance_um, maximum_clearance_um, basis, preferred, function,
    };

    pub(super) fn of(size: Length, candidate: &Candidate) -> Self {
        let [basis, preferred, function] = words(candidate.hole, candidate.shaft);
        Self {
            callout: format!("{size} {}/{}", candidate.hole, candidate.shaft),
            hole: candidate.hole.to_string(),
            shaft: candidate.shaft.to_string(),
            kind: candidate.kind().word(),
            minimum_clearance_um: Figure::um(candidate.minimum),
            maximum_clearance_um: Figure::um(candidate.maximum),
            basis,
            preferred,
            function,
        }
    }
}
