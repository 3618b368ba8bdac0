//! How a line of a program looks: number, words, parameters, comments, and the marks before it that need no colour.

use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Color32, Painter, Rect, Shape, Stroke, pos2, vec2};

use crate::gui::shapes;
use crate::gui::theme::{self, Palette, sizes};
use crate::nc::program::Notation;
use crate::session::program::{State, Token, tokens_of};
use crate::text::Within as _;
use crate::verdict::Status;

/// The most bytes of a line that are drawn.
const LONGEST: usize = 2_000;

/// A line with its parts distinguished.
pub(super) fn line(notation: Notation, text: &str, begins: bool, palette: &Palette) -> LayoutJob {
    let text = text.within(..text.floor_char_boundary(LONGEST));
    let mut job = LayoutJob { break_on_newline: false, ..LayoutJob::default() };
    for (range, token) in tokens_of(notation, text, begins) {
        let part = text.within(range);
        // A control character has no shape.
        if part.contains(char::is_control) {
            let part: String = part.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
            job.append(&part, 0.0, format(token, palette));
        } else {
            job.append(part, 0.0, format(token, palette));
        }
    }
    job
}

/// Colours are quiet: the line reads the same without them.
fn format(token: Token, palette: &Palette) -> TextFormat {
    let colour = match token {
        Token::Plain | Token::Text | Token::Heading => palette.text.0,
        Token::Number | Token::Comment => palette.quiet.0,
        Token::Keyword => palette.keyword.0,
        Token::Parameter => palette.data.0,
    };
    let plain = TextFormat::simple(theme::mono(sizes().mono), colour);
    match token {
        Token::Comment => TextFormat { italics: true, ..plain },
        _ => plain,
    }
}

/// A breakpoint: a filled circle.
pub(super) fn breakpoint(painter: &Painter, rect: Rect, colour: Color32) {
    painter.circle_filled(rect.center(), rect.height() * 0.26, colour);
}

/// The block that runs next: an arrow. One that failed: a cross.
pub(super) fn current(painter: &Painter, rect: Rect, failed: bool, palette: &Palette) {
    if failed {
        let inner = Rect::from_center_size(rect.center(), vec2(rect.height(), rect.height()) * 0.7);
        return shapes::status(painter, inner, Some(Status::Scrap), palette.error.0);
    }
    let at = rect.center();
    let half = rect.height() * 0.3;
    let tail = pos2(rect.left() + 1.0, at.y);
    painter.line_segment([tail, pos2(rect.right() - half, at.y)], Stroke::new(2.0, palette.data.0));
    let points = vec![
        pos2(rect.right(), at.y),
        pos2(rect.right() - half * 1.4, at.y - half),
        pos2(rect.right() - half * 1.4, at.y + half),
    ];
    painter.add(Shape::convex_polygon(points, palette.data.0, Stroke::NONE));
}

/// The state of a run, as on a player: triangle, two bars, square, cross.
pub(super) fn state(painter: &Painter, rect: Rect, state: Option<State>, palette: &Palette) {
    let rect = rect.shrink(rect.height() * 0.15);
    let colour = palette.text.0;
    match state {
        Some(State::Running) => {
            let points = vec![rect.left_top(), rect.right_center(), rect.left_bottom()];
            painter.add(Shape::convex_polygon(points, palette.data.0, Stroke::NONE));
        }
        Some(State::Paused) => {
            let bar = vec2(rect.width() * 0.32, rect.height());
            painter.rect_filled(Rect::from_min_size(rect.left_top(), bar), 0.0, colour);
            painter.rect_filled(Rect::from_min_size(rect.right_top() - vec2(bar.x, 0.0), bar), 0.0, colour);
        }
        Some(State::Ended) => _ = painter.rect_filled(rect.shrink(1.0), 0.0, colour),
        Some(State::Faulted) => shapes::status(painter, rect, Some(Status::Scrap), palette.error.0),
        None => shapes::status(painter, rect, None, palette.quiet.0),
    }
}
