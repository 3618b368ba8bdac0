//! ASME B89.7.3.1, relaxed acceptance: the zone of accepted values is larger by a multiple of the expanded uncertainty at both
//! limits.

use super::{Bands, Declaration, Use};

pub(super) const DECLARATION: Declaration = Declaration {
    name: "asme-relaxed",
    text: "rule-asme-relaxed",
    how: Use::Relaxed,
    takes_factor: true,
    takes_width: false,
    bands: Some(Bands::expanded),
};
