//! SVG pictures: their shapes are drawn as large as they are shown.

use resvg::tiny_skia::{Pixmap, Transform};

use super::{Dots, LONGEST};
use crate::message::Message;
use crate::report::image::{broken, check_dots};
use crate::report::shapes::tree;

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
    check_dots(name, (scaled.width(), scaled.height()))?;
    let x = ratio(scaled.width(), tree.size().width());
    let y = ratio(scaled.height(), tree.size().height());
    let mut map = Pixmap::new(scaled.width(), scaled.height()).ok_or_else(|| broken(name, &"0 × 0"))?;
    resvg::render(&tree, Transform::from_scale(x, y), &mut map.as_mut());
    let dots = map.pixels().iter().flat_map(|dot| {
        let dot = dot.demultiply();
        [dot.red(), dot.green(), dot.blue(), dot.alpha()]
    });
    let side = |dots: u32| usize::try_from(dots).map_err(|error| broken(name, &error));
    Ok(([side(scaled.width())?, side(scaled.height())?], dots.collect()))
}

/// How much larger something is drawn.
fn ratio(drawn: u32, given: f32) -> f32 {
    u16::try_from(drawn).map_or(1.0, |drawn| f32::from(drawn) / given.max(1e-3))
}
