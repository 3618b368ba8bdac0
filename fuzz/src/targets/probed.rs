//! Any bytes as a print of a probing macro: every row is a record, set aside or an error, with a line of its own; none is rework or scrap, because such a print says
//! neither hole nor shaft.

use super::shared::printed;

pub fn run(bytes: &[u8]) {
    printed(bytes, "probed");
}
