//! Simple acceptance: the limits decide. The rule of the measuring cycles of HEIDENHAIN controls and the default here
//! (metrology.md, section 5).

use super::{Declaration, Use};

pub(super) const DECLARATION: Declaration = Declaration {
    name: "simple",
    text: "rule-simple",
    how: Use::Limits,
    takes_factor: false,
    takes_width: false,
    bands: None,
};
