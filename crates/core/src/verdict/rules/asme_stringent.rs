//! ASME B89.7.3.1, stringent acceptance: the zone of accepted values is smaller by a multiple of the expanded uncertainty at both
//! limits. What lies between is no scrap yet: it is measured again (ours; the standard rejects it).

use super::{Bands, Declaration, Use};

pub(super) const DECLARATION: Declaration = Declaration {
    name: "asme-stringent",
    text: "rule-asme-stringent",
    how: Use::Stringent,
    takes_factor: true,
    takes_width: false,
    bands: Some(Bands::expanded),
};
