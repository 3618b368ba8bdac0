//! A set for one feature: a callout and a place, typed on the command line or on the check page.

use fitcheck_core::message::Say;
use fitcheck_core::part::{Column, Document, Draft, DraftFeature};
use fitcheck_core::tolerance::{Callout, CalloutError, LimitsError, Tolerance};

/// Why a single callout makes no plan for a set.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "nc", error)]
pub enum SingleFault {
    /// It is no callout.
    #[say(transparent)]
    Callout(CalloutError),
    /// Neither the callout nor a cell says hole or shaft.
    #[say(transparent)]
    NoFeature(LimitsError),
    /// A coordinate is not given.
    NoCoordinate {
        /// Its column in a plan.
        column: &'static str,
    },
}

/// The plan of one feature, of its callout and its other cells.
///
/// # Errors
/// [`SingleFault`] where a diameter or a width has no class and no cell says hole or shaft: the cycles need it to tell
/// rework from scrap. A program moves to the feature, so its place is needed, too.
pub fn single(callout: &str, cells: &[(Column, String)]) -> Result<Document, SingleFault> {
    let given = |column: Column| cells.iter().find(|(of, _)| *of == column);
    let is_kind = |word: &str| given(Column::Kind).is_some_and(|(_, kind)| kind.trim().eq_ignore_ascii_case(word));
    if !is_kind("point") {
        let callout = callout.parse::<Callout>().map_err(SingleFault::Callout)?;
        // Every other kind says it itself, and a fit is refused as such by the plan.
        let is_open = given(Column::Kind).is_none() || is_kind("diameter") || is_kind("width");
        let is_fit = matches!(callout.tolerance(), Tolerance::Fit { .. });
        if is_open && !is_fit && callout.feature().is_none() && given(Column::Feature).is_none() {
            return Err(SingleFault::NoFeature(LimitsError::NoFeature { callout }));
        }
    }
    if let Some(column) = [Column::X, Column::Y, Column::Z].into_iter().find(|column| given(*column).is_none()) {
        return Err(SingleFault::NoCoordinate { column: column.key() });
    }
    let feature = DraftFeature::of(cells.iter().cloned().chain([(Column::Callout, callout.to_owned())]));
    Ok(Document::of(Draft::of(vec![feature])))
}
