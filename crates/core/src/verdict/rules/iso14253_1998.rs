//! ISO 14253-1:1998: the guard band is the expanded uncertainty, at both limits (metrology.md, section 5).

use super::{Bands, Declaration, Use};

pub(super) const DECLARATION: Declaration = Declaration {
    name: "iso14253-1998",
    text: "rule-iso14253-1998",
    how: Use::Proof,
    takes_factor: false,
    takes_width: false,
    bands: Some(Bands::expanded),
};
