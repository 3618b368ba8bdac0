//! Pages of a report, drawn with the window's painter: the fonts and colours are those of the file.

use std::sync::Arc;

use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, TextureHandle, Ui, pos2, vec2};

use crate::gui::theme;
use crate::report::pdf::{Canvas, CanvasEdge};

/// A page on the screen.
pub(super) struct PainterCanvas<'a> {
    painter: Painter,
    paper: Rect,
    scale: f32,
    pictures: &'a [Option<TextureHandle>],
}

impl<'a> PainterCanvas<'a> {
    /// A page that fills a place; `scale` dots are a point of it.
    pub fn new(ui: &Ui, paper: Rect, scale: f32, pictures: &'a [Option<TextureHandle>]) -> Self {
        let painter = ui.painter().with_clip_rect(paper.intersect(ui.clip_rect()));
        Self { painter, paper, scale, pictures }
    }

    fn at(&self, [x, y]: [f32; 2]) -> Pos2 {
        self.paper.min + vec2(x, y) * self.scale
    }

    fn area(&self, [x, y, width, height]: [f32; 4]) -> Rect {
        Rect::from_min_size(self.at([x, y]), vec2(width, height) * self.scale)
    }

    fn stroke(&self, edge: Option<CanvasEdge>) -> Stroke {
        edge.map_or(Stroke::NONE, |edge| Stroke::new((edge.width * self.scale).max(0.6), theme::ink(edge.ink)))
    }

    fn outline(&self, corners: Vec<Pos2>, edge: Option<CanvasEdge>) {
        let Some(edge) = edge else { return };
        let stroke = self.stroke(Some(edge));
        let mut line = corners;
        line.extend(line.first().copied());
        if edge.is_dashed {
            self.painter.extend(Shape::dashed_line(&line, stroke, 2.6 * self.scale, 1.9 * self.scale));
        } else {
            self.painter.add(Shape::line(line, stroke));
        }
    }
}

impl Canvas for PainterCanvas<'_> {
    fn text(&mut self, at: [f32; 2], size: f32, is_bold: bool, ink: [u8; 3], text: &str) {
        let size = size * self.scale;
        let font = if is_bold { theme::bold(size) } else { theme::font(size) };
        let galley = self.painter.layout_no_wrap(text.to_owned(), font, theme::ink(ink));
        // Where the base line of the first letter is.
        let base = galley.rows.first().and_then(|row| row.glyphs.first()).map_or(size, |glyph| glyph.pos.y);
        self.painter.galley(self.at(at) - vec2(0.0, base), Arc::clone(&galley), Color32::PLACEHOLDER);
    }

    fn icon(&mut self, middle: [f32; 2], size: f32, ink: [u8; 3], icon: char) {
        theme::Icon::paint_sign(&self.painter, self.at(middle), icon, size * self.scale, theme::ink(ink));
    }

    fn block(&mut self, area: [f32; 4], radius: f32, fill: Option<[u8; 3]>, edge: Option<CanvasEdge>) {
        let rect = self.area(area);
        let radius = radius * self.scale;
        let fill = fill.map_or(Color32::TRANSPARENT, theme::ink);
        match edge {
            Some(edge) if edge.is_dashed => {
                self.painter.rect_filled(rect, radius, fill);
                let corners = [rect.left_top(), rect.right_top(), rect.right_bottom(), rect.left_bottom()];
                self.outline(corners.to_vec(), Some(edge));
            }
            edge => _ = self.painter.rect(rect, radius, fill, self.stroke(edge), StrokeKind::Middle),
        }
    }

    fn polygon(&mut self, corners: &[[f32; 2]], fill: Option<[u8; 3]>, edge: Option<CanvasEdge>) {
        let corners: Vec<Pos2> = corners.iter().map(|corner| self.at(*corner)).collect();
        if let Some(fill) = fill {
            self.painter.add(Shape::convex_polygon(corners.clone(), theme::ink(fill), Stroke::NONE));
        }
        self.outline(corners, edge);
    }

    fn lines(&mut self, lines: &[[[f32; 2]; 2]], within: [f32; 4], edge: CanvasEdge) {
        let clip = self.area(within).intersect(self.painter.clip_rect());
        let painter = self.painter.with_clip_rect(clip);
        for line in lines {
            painter.line_segment(line.map(|place| self.at(place)), self.stroke(Some(edge)));
        }
    }

    fn picture(&mut self, area: [f32; 4], number: usize) {
        let Some(Some(texture)) = self.pictures.get(number) else { return };
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        self.painter.image(texture.id(), self.area(area), whole, theme::paper());
    }
}
