//! Any bytes as a printed report of CALYPSO: every row is a record, set aside or an error, with a line of its own; none is rework or scrap,
//! because such a report says neither hole nor shaft.

use super::shared::printed;

pub fn run(bytes: &[u8]) {
    printed(bytes, "calypso-text");
}
