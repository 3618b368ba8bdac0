//! ASME B89.7.3.1, simple acceptance with a ratio of 4:1: the limits decide, as long as the tolerance is at least four times the
//! interval of the expanded uncertainty, from -U to +U. That this interval is meant is general knowledge, not confirmed by a page.

use super::{Declaration, RuleInputs, Use};
use crate::tolerance::Bounds;

pub(super) const DECLARATION: Declaration = Declaration {
    name: "asme-simple",
    text: "rule-asme-simple",
    how: Use::LimitsWithRatio,
    takes_factor: false,
    takes_width: false,
    bands: None,
};

/// How many times the tolerance must be as wide as the interval of the uncertainty.
const RATIO: i128 = 4;

/// Whether the uncertainty is small enough for the limits to decide.
pub(super) fn is_met(given: &RuleInputs, bounds: &Bounds) -> bool {
    let width = i128::from(bounds.maximum().nanometres()) - i128::from(bounds.minimum().nanometres());
    // Expanded uncertainties are kept in picometres times thousandths.
    given.uncertainty.is_some_and(|uncertainty| RATIO * 2 * uncertainty.expanded_exactly() <= width * 1_000_000)
}
