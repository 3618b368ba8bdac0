//! A guard band of a given width at both limits, whatever the uncertainty is.

use super::{Bands, Declaration, RuleInputs, Use};
use crate::length::Length;
use crate::tolerance::Bounds;

pub(super) const DECLARATION: Declaration = Declaration {
    name: "fixed",
    text: "rule-fixed",
    how: Use::Proof,
    takes_factor: false,
    takes_width: true,
    bands: Some(bands),
};

fn bands(given: &RuleInputs, _bounds: &Bounds) -> Bands {
    let width = given.width.unwrap_or(Length::ZERO);
    Bands { conforming: Some(width), nonconforming: width }
}
