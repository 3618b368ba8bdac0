//! SVG pictures: their shapes are drawn as large as they are shown.

use super::{Dots, LONGEST};
use crate::message::Message;
use crate::report::image::broken;
use crate::report::shapes::{dots, tree};

/// SVG: shapes and texts, in the size in which they are shown.
pub(super) fn shapes(name: &str, bytes: &[u8]) -> Result<Dots, Message> {
    let tree = tree(name, bytes)?;
    let size = tree.size().to_int_size();
    let longest = size.width().max(size.height());
    let scaled = if longest <= LONGEST {
        size
    } else if size.width() < size.height() {
        size.scale_to_height(LONGEST).unwrap_or(size)
    } else {
        size.scale_to_width(LONGEST).unwrap_or(size)
    };
    let dots = dots(name, &tree, [scaled.width(), scaled.height()])?;
    let side = |dots: u32| usize::try_from(dots).map_err(|error| broken(name, &error));
    Ok(([side(scaled.width())?, side(scaled.height())?], dots))
}
