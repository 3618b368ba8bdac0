//! Any bytes as tolerances of GEOPAK without names of columns: no row is lost, and none is rework or scrap.

use super::shared::printed;

pub fn run(bytes: &[u8]) {
    printed(bytes, "geopak");
}
