//! A page as a picture: the same plain values as in the file, filled with grey dots.

use std::io;

use skrifa::MetadataProvider as _;
use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use tiny_skia::{
    Color, FillRule, Mask, Paint, Path, PathBuilder, Pixmap, PremultipliedColorU8, Rect, Stroke, StrokeDash, Transform,
};

use super::brush::MIDDLE;
use super::fonts::{Drawn, Fonts, Weight};
use super::pages::{Canvas, CanvasEdge, Pages};

/// The first page in so many dots: a byte for each, row by row, from black to white.
///
/// # Errors
/// There is no room for so many dots, or a font cannot be read.
pub(in crate::report) fn raster(pages: &Pages, [width, height]: [u32; 2]) -> io::Result<Vec<u8>> {
    let mut dots = Pixmap::new(width, height).ok_or_else(|| io::Error::other("no room for the dots of a page"))?;
    dots.fill(Color::WHITE);
    let fonts = Fonts::new()?;
    let [page_width, page_height] = pages.size();
    let scale = Transform::from_scale(whole(width) / page_width, whole(height) / page_height);
    pages.draw(0, &mut Raster { fonts: &fonts, dots: &mut dots, scale });
    Ok(dots.pixels().iter().map(|dot| grey(*dot)).collect())
}

/// How bright a dot is (ITU-R BT.601, in thousandths).
fn grey(dot: PremultipliedColorU8) -> u8 {
    let bright = 299 * u32::from(dot.red()) + 587 * u32::from(dot.green()) + 114 * u32::from(dot.blue());
    u8::try_from((bright + 500) / 1_000).unwrap_or(u8::MAX)
}

/// A number of dots, of which no page has more than 65 535 on a side.
fn whole(dots: u32) -> f32 {
    f32::from(u16::try_from(dots).unwrap_or(u16::MAX))
}

struct Raster<'a> {
    fonts: &'a Fonts,
    dots: &'a mut Pixmap,
    scale: Transform,
}

impl Raster<'_> {
    fn fill(&mut self, path: &Path, ink: [u8; 3], is_smooth: bool) {
        self.dots.fill_path(path, &paint(ink, is_smooth), FillRule::Winding, self.scale, None);
    }

    fn stroke(&mut self, path: &Path, edge: CanvasEdge, within: Option<&Mask>) {
        let dash = edge.is_dashed.then(|| StrokeDash::new(vec![2.6, 1.9], 0.0)).flatten();
        let stroke = Stroke { width: edge.width, dash, ..Stroke::default() };
        self.dots.stroke_path(path, &paint(edge.ink, true), &stroke, self.scale, within);
    }

    /// A glyph from a place of its base line on.
    fn glyph(&mut self, (font, number, _): &Drawn, [x, y]: [f32; 2], size: f32, ink: [u8; 3]) {
        let Some(outline) = font.outline_glyphs().get(*number) else { return };
        let units = font.metrics(Size::unscaled(), LocationRef::default()).units_per_em;
        let mut pen = Pen { path: PathBuilder::new(), at: [x, y], scale: size / f32::from(units) };
        // A glyph of a built-in font that cannot be drawn is one that has no outline, such as a blank.
        if outline.draw(DrawSettings::unhinted(Size::unscaled(), LocationRef::default()), &mut pen).is_ok()
            && let Some(path) = pen.path.finish()
        {
            self.fill(&path, ink, true);
        }
    }
}

impl Canvas for Raster<'_> {
    fn text(&mut self, [mut x, y]: [f32; 2], size: f32, is_bold: bool, ink: [u8; 3], text: &str) {
        let fonts = self.fonts;
        for drawn in fonts.drawn(text, if is_bold { Weight::Semibold } else { Weight::Regular }) {
            self.glyph(&drawn, [x, y], size, ink);
            x += drawn.2 * size;
        }
    }

    fn icon(&mut self, [x, y]: [f32; 2], size: f32, ink: [u8; 3], icon: char) {
        if let Some(drawn) = self.fonts.drawn_icon(icon) {
            self.glyph(&drawn, [x - drawn.2 * size / 2.0, y + MIDDLE * size], size, ink);
        }
    }

    fn block(&mut self, area: [f32; 4], radius: f32, fill: Option<[u8; 3]>, edge: Option<CanvasEdge>) {
        let Some(path) = block(area, radius) else { return };
        if let Some(fill) = fill {
            // The squares of a code have edges that a scanner finds.
            self.fill(&path, fill, 0.0 < radius);
        }
        if let Some(edge) = edge {
            self.stroke(&path, edge, None);
        }
    }

    fn polygon(&mut self, corners: &[[f32; 2]], fill: Option<[u8; 3]>, edge: Option<CanvasEdge>) {
        let mut path = PathBuilder::new();
        for (number, [x, y]) in corners.iter().enumerate() {
            if number == 0 { path.move_to(*x, *y) } else { path.line_to(*x, *y) }
        }
        path.close();
        let Some(path) = path.finish() else { return };
        if let Some(fill) = fill {
            self.fill(&path, fill, true);
        }
        if let Some(edge) = edge {
            self.stroke(&path, edge, None);
        }
    }

    fn lines(&mut self, lines: &[[[f32; 2]; 2]], within: [f32; 4], edge: CanvasEdge) {
        let mut path = PathBuilder::new();
        for [[x1, y1], [x2, y2]] in lines {
            path.move_to(*x1, *y1);
            path.line_to(*x2, *y2);
        }
        let Some(path) = path.finish() else { return };
        let mut mask = Mask::new(self.dots.width(), self.dots.height());
        if let (Some(mask), Some(area)) = (&mut mask, block(within, 0.0)) {
            mask.fill_path(&area, FillRule::Winding, true, self.scale);
        }
        self.stroke(&path, edge, mask.as_ref());
    }

    // A label has no room for pictures.
    fn picture(&mut self, _area: [f32; 4], _number: usize) {}
}

fn paint([red, green, blue]: [u8; 3], is_smooth: bool) -> Paint<'static> {
    let mut paint = Paint { anti_alias: is_smooth, ..Paint::default() };
    paint.set_color_rgba8(red, green, blue, u8::MAX);
    paint
}

/// A rectangle with round corners.
fn block([x, y, width, height]: [f32; 4], radius: f32) -> Option<Path> {
    let rect = Rect::from_xywh(x, y, width, height)?;
    if radius <= 0.0 {
        return Some(PathBuilder::from_rect(rect));
    }
    let (left, top, right, bottom) = (rect.left(), rect.top(), rect.right(), rect.bottom());
    let r = radius.min(width / 2.0).min(height / 2.0);
    // Where the handles of a quarter of a circle are.
    let k = r * 0.447_715;
    let mut path = PathBuilder::new();
    path.move_to(left + r, top);
    path.line_to(right - r, top);
    path.cubic_to(right - k, top, right, top + k, right, top + r);
    path.line_to(right, bottom - r);
    path.cubic_to(right, bottom - k, right - k, bottom, right - r, bottom);
    path.line_to(left + r, bottom);
    path.cubic_to(left + k, bottom, left, bottom - k, left, bottom - r);
    path.line_to(left, top + r);
    path.cubic_to(left, top + k, left + k, top, left + r, top);
    path.close();
    path.finish()
}

/// Takes the outline of a glyph, which is in units of its font and has its y upwards.
struct Pen {
    path: PathBuilder,
    at: [f32; 2],
    scale: f32,
}

impl Pen {
    fn to(&self, x: f32, y: f32) -> (f32, f32) {
        (self.at[0] + x * self.scale, self.at[1] - y * self.scale)
    }
}

impl OutlinePen for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.to(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.to(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        let ((cx, cy), (x, y)) = (self.to(cx, cy), self.to(x, y));
        self.path.quad_to(cx, cy, x, y);
    }

    fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
        let ((ax, ay), (bx, by), (x, y)) = (self.to(ax, ay), self.to(bx, by), self.to(x, y));
        self.path.cubic_to(ax, ay, bx, by, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}
