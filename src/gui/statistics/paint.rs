//! From a picture to the screen: the one place that gives its marks their colours.

use std::ops::Range;
use std::sync::Arc;

use eframe::egui::epaint::Mesh;
use eframe::egui::{Align2, Color32, Id, Painter, Pos2, Rect, Shape, Stroke, Ui, pos2, vec2};

use crate::gui::shapes::screen;
use crate::gui::theme::{self, Palette, palette, sizes};
use crate::gui::view::View;
use crate::series::Drawn;
use crate::statistics::Reason;
use crate::statistics::picture::{Anchor, Mark, Picture, TEXT_SIZE, Tone};

/// What a drawing was made for: it is kept until something of this changes.
#[derive(Debug, Clone, PartialEq)]
struct Made {
    version: u64,
    feature: Option<usize>,
    size: [f32; 2],
    points: Range<usize>,
    sign: char,
    language: crate::words::Language,
}

/// Paints a chart of the chosen feature in a place; or says there why there is none.
pub(super) fn drawn_ui(ui: &Ui, view: &View<'_>, what: Drawn, rect: Rect) -> Option<Arc<Picture>> {
    let page = view.session.statistics();
    let (_, of) = page.open()?;
    let seen = (page.version(), page.chosen(), page.window());
    let id = Id::unique(("statistics-drawn", what));
    kept_ui(ui, view, (id, seen), rect, |size| of.drawn(what, size, page.window(), view.words))
}

/// Paints the chart of a stability study in a place; or says there why there is none.
pub(super) fn study_ui(ui: &Ui, view: &View<'_>, rect: Rect) {
    let study = &view.session.statistics().study;
    let Some(found) = study.evaluated() else { return };
    let seen = (study.version(), None, 0..0);
    let id = Id::unique("statistics-study-drawn");
    kept_ui(ui, view, (id, seen), rect, |size| found.answer.run_chart(&found.signals, size, view.words));
}

/// Paints what is drawn of a version, a feature and its points; drawn anew only where something of this changed.
fn kept_ui(
    ui: &Ui,
    view: &View<'_>,
    (id, (version, feature, points)): (Id, (u64, Option<usize>, Range<usize>)),
    rect: Rect,
    draw: impl FnOnce([f64; 2]) -> Result<Picture, Reason>,
) -> Option<Arc<Picture>> {
    let (sign, language) = (view.words.decimal_sign(), view.session.language());
    let made = Made { version, feature, size: rect.size().into(), points, sign, language };
    let kept = ui.data(|data| data.get_temp::<(Made, Result<Arc<Picture>, Reason>)>(id));
    let drawn = kept.filter(|(of, _)| *of == made).map_or_else(
        || {
            let drawn = draw(made.size.map(f64::from)).map(Arc::new);
            ui.data_mut(|data| data.insert_temp(id, (made.clone(), drawn.clone())));
            drawn
        },
        |(_, drawn)| drawn,
    );
    match drawn {
        Ok(picture) => {
            paint(&ui.painter().with_clip_rect(rect.intersect(ui.clip_rect())), rect.min, &picture);
            Some(picture)
        }
        Err(why) => {
            let palette = palette(ui.ctx());
            ui.painter().rect_filled(rect, 8.0, palette.sunken.0);
            let font = theme::font(sizes().body);
            let text = ui.painter().layout(view.words.told(&why), font, palette.quiet.0, rect.width() * 0.8);
            ui.painter().galley(rect.center() - text.size() / 2.0, text, palette.quiet.0);
            None
        }
    }
}

/// A place of a picture on the screen.
pub(super) fn place(from: Pos2, at: [f64; 2]) -> Pos2 {
    let [x, y] = at.map(screen);
    from + vec2(x, y)
}

fn paint(painter: &Painter, from: Pos2, picture: &Picture) {
    let palette = palette(painter.ctx());
    let at = |point: [f64; 2]| place(from, point);
    for mark in &picture.marks {
        match mark {
            Mark::Area { from, to, tone } => {
                painter.rect_filled(Rect::from_two_pos(at(*from), at(*to)), 0.0, colour(palette, *tone));
            }
            Mark::Shape { points, tone } => {
                let points: Vec<Pos2> = points.iter().map(|point| at(*point)).collect();
                painter.add(band(&points, colour(palette, *tone)));
            }
            Mark::Line { points, tone, width, is_dashed } => {
                let points: Vec<Pos2> = points.iter().map(|point| at(*point)).collect();
                let stroke = Stroke::new(screen(*width), colour(palette, *tone));
                if *is_dashed {
                    painter.extend(Shape::dashed_line(&points, stroke, 7.0, 4.0));
                } else {
                    painter.add(Shape::line(points, stroke));
                }
            }
            Mark::Dot { at: of, radius, tone } => {
                painter.circle_filled(at(*of), screen(*radius), colour(palette, *tone));
            }
            Mark::Ring { at: of, radius, tone } => {
                painter.circle_stroke(at(*of), screen(*radius), Stroke::new(1.5, colour(palette, *tone)));
            }
            Mark::Text { at: of, anchor, is_bold, tone, text } => {
                let size = screen(TEXT_SIZE);
                let font = if *is_bold { theme::bold(size) } else { theme::font(size) };
                let anchor = match anchor {
                    Anchor::Start => Align2::LEFT_CENTER,
                    Anchor::Middle => Align2::CENTER_CENTER,
                    Anchor::End => Align2::RIGHT_CENTER,
                };
                let of = at(*of);
                painter.text(pos2(of.x, of.y), anchor, text, font, colour(palette, *tone));
            }
        }
    }
}

/// A band between a line and the same number of points back.
fn band(points: &[Pos2], colour: Color32) -> Shape {
    let mut mesh = Mesh::default();
    let pairs = points.iter().zip(points.iter().rev()).take(points.len() / 2);
    for (number, (one, other)) in (0u32..).zip(pairs) {
        mesh.colored_vertex(*one, colour);
        mesh.colored_vertex(*other, colour);
        if 0 < number {
            let first = 2 * (number - 1);
            mesh.add_triangle(first, first + 1, first + 2);
            mesh.add_triangle(first + 1, first + 2, first + 3);
        }
    }
    Shape::mesh(mesh)
}

fn colour(palette: &Palette, tone: Tone) -> Color32 {
    match tone {
        Tone::Text | Tone::Law => palette.text.0,
        Tone::Signal => palette.tint.0,
        Tone::Quiet | Tone::LeftOut => palette.quiet.0,
        Tone::Ground => palette.sunken.0,
        Tone::Grid => palette.line.0,
        Tone::Data | Tone::Centre | Tone::Control => palette.data.0,
        Tone::Bar => palette.data.0.gamma_multiply(0.6),
        Tone::Limit => palette.zone_edge.0,
        Tone::Zone => palette.zone.0.gamma_multiply(0.55),
        Tone::Band => palette.data.0.gamma_multiply(0.18),
    }
}
