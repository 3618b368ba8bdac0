//! Whether a budget is about what is judged with it: its size, its side, its temperature and its material.

use super::warning::BudgetWarning;
use super::{Basis, Budget, Calibrated, Conditions, Contribution, ContributionKind, brief_of};
use crate::length::Length;
use crate::tolerance::fit::thermal::{Correction, Warm};

/// Up to this size a calibrated piece may be as much larger or smaller as [`ALIKE`]; above it by a tenth. ISO 15530-3 asks for a
/// piece that is alike; these figures of its table are general knowledge, not confirmed by a page.
const SMALL: i64 = 250_000_000;
const ALIKE: i64 = 25_000_000;

/// A thousandth of a kelvin or of a millionth per kelvin: temperatures and expansions have three decimals.
const SAME: f64 = 0.0005;

/// What to check about a budget for a measured value.
pub(super) fn doubts(budget: &Budget, conditions: &Conditions) -> Vec<BudgetWarning> {
    match &budget.basis {
        Basis::Calibrated(piece) => of_piece(piece, conditions),
        Basis::Contributions(contributions) => {
            let correction = conditions.correction.as_ref();
            let doubts = contributions.iter().filter_map(|one| of_contribution(one, correction?));
            // One of each kind is enough.
            let mut said: Vec<BudgetWarning> = Vec::new();
            for doubt in doubts {
                if !said.contains(&doubt) {
                    said.push(doubt);
                }
            }
            said
        }
    }
}

fn of_piece(piece: &Calibrated, conditions: &Conditions) -> Vec<BudgetWarning> {
    let mut doubts = Vec::new();
    let allowed = if piece.size.nanometres() <= SMALL { ALIKE } else { piece.size.nanometres() / 10 };
    let is_alike = |size: &Length| size.saturating_sub(piece.size).abs().nanometres() <= allowed;
    if let Some(measured) = conditions.size.filter(|size| !is_alike(size)) {
        doubts.push(BudgetWarning::OtherSize { calibrated: piece.size, measured });
    }
    if conditions.feature.is_some_and(|feature| feature != piece.feature) {
        doubts.push(BudgetWarning::OtherSide { calibrated: piece.feature });
    }
    doubts
}

/// Whether a contribution was made for another temperature or another material than the correction.
fn of_contribution(contribution: &Contribution, correction: &Correction) -> Option<BudgetWarning> {
    let expansion = |warm: Warm| f64::from(warm.expansion.thousandths()) / 1e3;
    let off = |warm: Warm| f64::from(warm.temperature.thousandths()) / 1e3 - 20.0;
    let (budget, given, is_temperature) = match contribution.kind {
        ContributionKind::PartTemperature(alpha) => (alpha * 1e6, expansion(correction.part), false),
        ContributionKind::ScaleTemperature(alpha) => (alpha * 1e6, expansion(correction.scale?), false),
        ContributionKind::PartExpansion(delta) => (delta, off(correction.part), true),
        ContributionKind::ScaleExpansion(delta) => (delta, off(correction.scale?), true),
        ContributionKind::Plain | ContributionKind::Scatter(_) | ContributionKind::Resolution => return None,
    };
    if (budget - given).abs() < SAME {
        return None;
    }
    let contribution = contribution.name.clone();
    let budget = brief_of(budget);
    let given = brief_of(given);
    Some(if is_temperature {
        BudgetWarning::OtherTemperature { contribution, budget, given }
    } else {
        BudgetWarning::OtherExpansion { contribution, budget, given }
    })
}
