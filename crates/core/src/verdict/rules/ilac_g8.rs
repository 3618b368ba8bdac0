//! ILAC-G8:09/2019: the guard band is a multiple of the expanded uncertainty: 1 for a risk of a wrong acceptance below 2.5 %,
//! 0.83 for less than 5 %, 1.5 for less than 0.16 % (metrology.md, section 5).

use super::{Bands, Declaration, Use};

pub(super) const DECLARATION: Declaration = Declaration {
    name: "ilac-g8",
    text: "rule-ilac-g8",
    how: Use::Proof,
    takes_factor: true,
    takes_width: false,
    bands: Some(Bands::expanded),
};
