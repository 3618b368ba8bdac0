//! A set for one feature: a callout and a place, typed on the command line or on the check page.

use fitcheck_core::message::Say;
use fitcheck_core::part::{Column, Document, Draft, DraftFeature};
use fitcheck_core::tolerance::{Callout, CalloutError, Tolerance};

use super::error::FeatureFault;

/// Why a single callout makes no plan for a set.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "nc", error)]
pub enum SingleFault {
    /// It is no callout.
    #[say(transparent)]
    Callout(CalloutError),
    /// A control cannot measure it.
    #[say(transparent)]
    Feature(FeatureFault),
    /// A coordinate is not given.
    NoCoordinate {
        /// Its column in a plan.
        column: &'static str,
    },
}

/// The plan of one feature, of its callout and its other cells.
///
/// # Errors
/// [`SingleFault`] where the callout has no class: no cell says hole or shaft, and the programs look limits up by class.
/// A program moves to the feature, so its place is needed, too.
pub fn single(callout: &str, cells: &[(Column, String)]) -> Result<Document, SingleFault> {
    let given = |column: Column| cells.iter().find(|(of, _)| *of == column);
    let is_point = given(Column::Kind).is_some_and(|(_, kind)| kind.trim().eq_ignore_ascii_case("point"));
    if !is_point {
        let callout = callout.parse::<Callout>().map_err(SingleFault::Callout)?;
        if !matches!(callout.tolerance(), Tolerance::Class(_) | Tolerance::Fit { .. }) {
            return Err(SingleFault::Feature(FeatureFault::NoClass { callout }));
        }
    }
    if let Some(column) = [Column::X, Column::Y, Column::Z].into_iter().find(|column| given(*column).is_none()) {
        return Err(SingleFault::NoCoordinate { column: column.key() });
    }
    let feature = DraftFeature::of(cells.iter().cloned().chain([(Column::Callout, callout.to_owned())]));
    Ok(Document::of(Draft::of(vec![feature])))
}
