//! The result of a search in figures.

use super::Searched;
use crate::cli::Figure;
use crate::length::Length;
use crate::tolerance::fit::preferred::{Function, Preference, function, preference};
use crate::tolerance::fit::search::{Candidate, NearestMiss};
use crate::tolerance::fit::{Basis, basis};

object! {
    /// The answer for programs.
    pub(super) struct Figures of(searched: &Searched<'_>) {
        nominal_mm: Figure = Figure::mm(searched.size, 0),
        minimum_clearance_um: Option<Figure> = Some(Figure::um(searched.wanted?.0.minimum)),
        maximum_clearance_um: Option<Figure> = Some(Figure::um(searched.wanted?.0.maximum)),
        scope: Option<&'static str> = Some(searched.wanted?.1.word()),
        function: Option<&'static str> = searched.function.map(Function::word),
        total: usize = searched.found.total,
        candidates: Vec<CandidateFigures> =
            searched.found.candidates.iter().map(|one| CandidateFigures::of(searched.size, one)).collect(),
        nearest: Option<MissFigures> = Some(MissFigures::of(searched.size, searched.found.nearest.as_ref()?)),
    }

    struct MissFigures of(size: Length, miss: &NearestMiss) {
        candidate: CandidateFigures = CandidateFigures::of(size, &miss.candidate),
        below_um: Figure = Figure::um(miss.below),
        above_um: Figure = Figure::um(miss.above),
    }
}

row! {
    /// A pair: an entry of the answer, and a line of CSV.
    pub(super) struct CandidateFigures of(size: Length, found: &Candidate) {
        callout: String = format!("{size} {}/{}", found.hole, found.shaft),
        hole: String = found.hole.to_string(),
        shaft: String = found.shaft.to_string(),
        kind: &'static str = found.kind().word(),
        minimum_clearance_um: Figure = Figure::um(found.minimum),
        maximum_clearance_um: Figure = Figure::um(found.maximum),
        basis: Option<&'static str> = basis(found.hole, found.shaft).map(Basis::word),
        preferred: Option<&'static str> = preference(found.hole, found.shaft).map(Preference::word),
        function: Option<&'static str> = function(found.hole, found.shaft).map(Function::word),
    }
}
