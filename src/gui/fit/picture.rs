//! The classical picture: zero line, both zones to scale, fundamental deviations, clearances as arrows, actual parts.

use eframe::egui::epaint::PathShape;
use eframe::egui::{Align2, Color32, Painter, Pos2, Rangef, Rect, Sense, Shape, Stroke, Ui, pos2, vec2};

use super::{example_text, part_text};
use crate::gui::limits::feature_id;
use crate::gui::shapes::{self, Hatch, screen};
use crate::gui::spoken;
use crate::gui::theme::{self, Palette, palette, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::length::Length;
use crate::message::message;
use crate::session::{FitField, Mark, MeasuredParts, Picture, PictureZone, extremes};
use crate::tolerance::fit::Fit;
use crate::tolerance::{Feature, Limits};
use crate::words::Words;

/// Heading and picture over a height.
pub(super) fn picture_ui(ui: &mut Ui, view: &View<'_>, height: f32) {
    let page = view.session.fit().seen();
    ui.horizontal_wrapped(|ui| {
        heading(ui, view.text("fit-picture"));
        if let Some(example) = example_text(view) {
            quiet(ui, example);
        } else if page.fit.is_some() {
            quiet(ui, view.text("fit-picture-legend"));
        }
    });
    let (Some(fit), Some(picture)) = (page.fit.as_ref(), page.picture()) else {
        quiet(ui, view.text("fit-picture-empty"));
        return;
    };
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    if ui.is_rect_visible(rect) {
        let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
        Drawing::new(painter, rect, palette(ui.ctx()), view, &picture).draw(fit);
    }
    spoken::picture(ui, &response, view.text("fit-picture"), describe(view, fit, &picture));
}

/// What the picture shows, in words, for users who cannot see it.
fn describe(view: &View<'_>, fit: &Fit, picture: &Picture) -> String {
    let words = view.words;
    let zero = words.say(&message!("fit-describe-zero").number("nominal", fit.nominal()));
    let mut said: Vec<String> =
        example_text(view).map(|example| format!("{example}.")).into_iter().chain([zero]).collect();
    for ((feature, limits), zone) in fit.parts().into_iter().zip([&picture.hole, &picture.shaft]) {
        said.push(describe_zone(view, (feature, limits)));
        if zone.fundamental_um.is_some() {
            let upper = limits.deviations.upper();
            let lower = limits.deviations.lower();
            let deviation = words.signed_um(if zone.fundamental_is_upper { upper } else { lower });
            said.push(words.say(&message!("fit-describe-fundamental").text("deviation", deviation)));
        }
    }
    for (id, amount) in extremes(fit.minimum_clearance(), fit.maximum_clearance()) {
        said.push(format!("{} {} µm.", words.get(id), words.um(amount)));
    }
    for (feature, limits) in fit.parts() {
        if let Some(measured) = view.session.fit().length(FitField::measured(feature)) {
            let deviation = words.signed_um(measured.saturating_sub(limits.nominal));
            let message = message!("fit-describe-measured")
                .text("part", words.get(feature_id(Some(feature))))
                .text("deviation", deviation);
            said.push(words.say(&message));
        }
    }
    said.join(" ")
}

fn describe_zone(view: &View<'_>, (feature, limits): (Feature, &Limits)) -> String {
    // What has been typed may not name a class yet.
    let class = view.session.fit().seen().class(feature).map_or_else(String::new, |class| class.to_string());
    let message = message!("fit-describe-zone")
        .text("part", view.text(feature_id(Some(feature))))
        .text("class", class)
        .text("lower", view.words.signed_um(limits.deviations.lower()))
        .text("upper", view.words.signed_um(limits.deviations.upper()));
    view.words.say(&message)
}

/// Minimum distance between two labels of a zone.
const LINE: f32 = 16.0;

struct Drawing<'a> {
    painter: Painter,
    /// Where deviations are drawn; the names are below it.
    body: Rect,
    whole: Rect,
    palette: &'a Palette,
    /// Of lines and figures: those of an example are quiet.
    ink: Color32,
    view: &'a View<'a>,
    words: &'a Words,
    picture: &'a Picture,
}

impl<'a> Drawing<'a> {
    fn new(painter: Painter, whole: Rect, palette: &'a Palette, view: &'a View<'a>, picture: &'a Picture) -> Self {
        let body = Rect::from_min_max(whole.min, pos2(whole.right(), whole.bottom() - space(9.0)));
        let ink = if view.session.fit().example().is_some() { palette.quiet.0 } else { palette.text.0 };
        Self { painter, body, whole, palette, ink, view, words: view.words, picture }
    }

    fn y(&self, um: f64) -> f32 {
        self.body.bottom() - self.body.height() * screen(self.picture.fraction(um))
    }

    fn draw(&self, fit: &Fit) {
        let width = self.body.width();
        let column = (width * 0.15).max(space(14.0));
        let left = self.body.left() + (width * 0.14).max(space(18.0));
        let hole = Rangef::new(left, left + column);
        let shaft = Rangef::new(hole.max + space(4.0), hole.max + space(4.0) + column);
        let zero = self.y(0.0);
        for (x, zone, feature) in
            [(hole, &self.picture.hole, Feature::Hole), (shaft, &self.picture.shaft, Feature::Shaft)]
        {
            self.zone(x, zone, feature);
        }
        self.painter.hline(self.body.x_range(), zero, Stroke::new(2.0, self.ink));
        self.arrows(fit, hole, Rangef::new(shaft.max + space(15.0), self.body.right()));
        for ((x, zone), part) in [(hole, &self.picture.hole), (shaft, &self.picture.shaft)].into_iter().zip(fit.parts())
        {
            self.fundamental(x, zone, zero);
            self.edges(x, zone, part);
            self.mark(x, zone, part);
            self.name(x, part.0);
        }
        let nominal = format!("{} mm", self.words.number(&fit.nominal().to_string()));
        // On the side of the line away from the last arrow, that of the parts or of the smallest clearance.
        let Picture { hole, shaft, .. } = self.picture;
        let last = match (hole.mark, shaft.mark) {
            (Some(Mark::InSight(hole)), Some(Mark::InSight(shaft))) => hole + shaft,
            _ => hole.lower_um + shaft.upper_um,
        };
        let (anchor, off) = if last < 0.0 { (Align2::RIGHT_BOTTOM, -3.0) } else { (Align2::RIGHT_TOP, 3.0) };
        let at = pos2(self.body.right() - 2.0, zero + off);
        self.label(at, anchor, &nominal, theme::bold(sizes().small));
    }

    /// Text on a background, so that lines do not cross it.
    fn label(&self, at: Pos2, anchor: Align2, text: &str, font: eframe::egui::FontId) {
        let galley = self.painter.layout_no_wrap(text.to_owned(), font, self.ink);
        let rect = anchor.anchor_size(at, galley.size());
        let shift = (self.whole.top() - rect.top()).max(0.0) - (rect.bottom() - self.whole.bottom()).max(0.0);
        // No figure is cut off at an edge of the picture.
        let aside = (self.whole.left() - rect.left()).max(0.0) - (rect.right() - self.whole.right()).max(0.0);
        let rect = rect.translate(vec2(aside, shift));
        self.painter.rect_filled(rect.expand2(vec2(3.0, -1.0)), 2.0, self.palette.surface.0);
        self.painter.galley(rect.min, galley, self.ink);
    }

    /// A zone of no width is still drawn as a line.
    fn zone_rect(&self, x: Rangef, zone: &PictureZone) -> Rect {
        let top = self.y(zone.upper_um);
        let bottom = self.y(zone.lower_um);
        Rect::from_x_y_ranges(x, top..=bottom.max(top + 2.0))
    }

    fn zone(&self, x: Rangef, zone: &PictureZone, part: Feature) {
        let rect = self.zone_rect(x, zone);
        let (fill, hatch) = match part {
            Feature::Hole => (self.palette.hole.0, Hatch::Single),
            Feature::Shaft => (self.palette.shaft.0, Hatch::Falling),
        };
        self.painter.rect_filled(rect, 0.0, fill);
        shapes::hatch(&self.painter, rect, hatch, Stroke::new(1.0, self.palette.quiet.0.gamma_multiply(0.6)));
        let edge = Stroke::new(1.5, self.ink);
        self.painter.rect_stroke(rect, 0.0, edge, eframe::egui::StrokeKind::Middle);
    }

    /// From the zero line to the nearest edge.
    fn fundamental(&self, x: Rangef, zone: &PictureZone, zero: f32) {
        let Some(um) = zone.fundamental_um else { return };
        self.arrow(x.center(), zero, self.y(um), Stroke::new(1.5, self.ink));
    }

    /// Both limit deviations beside the zone, the fundamental one bolder; pushed apart where they would touch.
    fn edges(&self, x: Rangef, zone: &PictureZone, (feature, limits): (Feature, &Limits)) {
        let mut top = self.y(zone.upper_um);
        let mut bottom = self.y(zone.lower_um);
        let lacking = (LINE - (bottom - top)).max(0.0) / 2.0;
        top -= lacking;
        bottom += lacking;
        let (at, anchor, names) = match feature {
            Feature::Hole => (x.min - space(2.0), Align2::RIGHT_CENTER, ["ES", "EI"]),
            Feature::Shaft => (x.max + space(2.0), Align2::LEFT_CENTER, ["es", "ei"]),
        };
        let [upper, lower] = names;
        for (y, name, deviation, is_upper) in
            [(top, upper, limits.deviations.upper(), true), (bottom, lower, limits.deviations.lower(), false)]
        {
            let is_fundamental = zone.fundamental_um.is_some() && zone.fundamental_is_upper == is_upper;
            let font = if is_fundamental { theme::bold(sizes().body) } else { theme::font(sizes().body) };
            self.label(pos2(at, y), anchor, &format!("{name} {}", self.words.signed_um(deviation)), font);
        }
    }

    /// A measured part across its zone, or an arrow at the edge that it is beyond; always with its deviation.
    fn mark(&self, x: Rangef, zone: &PictureZone, (feature, limits): (Feature, &Limits)) {
        let measured = self.view.session.fit().length(FitField::measured(feature));
        let (Some(mark), Some(measured)) = (zone.mark, measured) else { return };
        let text = self.words.signed_um(measured.saturating_sub(limits.nominal));
        let colour = self.ink;
        let font = theme::bold(sizes().body);
        // Towards the other zone: the limit deviations are on the outer side.
        let (side, beside) = match feature {
            Feature::Hole => (10.0, Align2::LEFT_CENTER),
            Feature::Shaft => (-10.0, Align2::RIGHT_CENTER),
        };
        match mark {
            Mark::InSight(um) => {
                let y = self.y(um);
                self.painter.hline(x.expand(4.0), y, Stroke::new(3.0, colour));
                for (tip, along) in [(x.min, 1.0), (x.max, -1.0)] {
                    let head = vec2(along * 9.0, 0.0);
                    let points =
                        vec![pos2(tip, y), pos2(tip, y) - head + vec2(0.0, 5.0), pos2(tip, y) - head - vec2(0.0, 5.0)];
                    self.painter.add(PathShape::convex_polygon(points, colour, Stroke::NONE));
                }
                self.label(pos2(x.center(), y), Align2::CENTER_CENTER, &text, font);
            }
            Mark::Above => {
                let tip = pos2(x.center(), self.body.top() + 8.0);
                shapes::arrow_head(&self.painter, tip, vec2(0.0, -1.0), 12.0, colour);
                self.label(tip + vec2(side, 2.0), beside, &text, font);
            }
            Mark::Below => {
                let tip = pos2(x.center(), self.body.bottom() - 8.0);
                shapes::arrow_head(&self.painter, tip, vec2(0.0, 1.0), 12.0, colour);
                self.label(tip + vec2(side, -2.0), beside, &text, font);
            }
        }
    }

    fn name(&self, x: Rangef, feature: Feature) {
        self.below(x.center(), &part_text(self.view, feature), x.span() + space(4.0));
    }

    /// A name below the picture, on two lines where it is long; none where one of its words has no room: the answer names
    /// the same amounts.
    fn below(&self, x: f32, text: &str, width: f32) {
        let colour = self.ink;
        let font = || theme::font(sizes().small);
        let is_wide = |word: &str| width < self.painter.layout_no_wrap(word.to_owned(), font(), colour).size().x;
        if text.split(' ').any(is_wide) {
            return;
        }
        let mut job = eframe::egui::text::LayoutJob::simple(text.to_owned(), font(), colour, width);
        job.halign = eframe::egui::Align::Center;
        let galley = self.painter.layout_job(job);
        self.painter.galley(pos2(x, self.body.bottom() + space(0.5)), galley, colour);
    }

    /// Both ends of the range as arrows between the zones' edges, and the actual clearance between the parts.
    fn arrows(&self, fit: &Fit, hole: Rangef, space_for: Rangef) {
        let Picture { hole: of_hole, shaft: of_shaft, .. } = *self.picture;
        let [upper, lower] = extremes(fit.minimum_clearance(), fit.maximum_clearance());
        let mut arrows = vec![
            (of_hole.upper_um, of_shaft.lower_um, self.words.get(upper.0), upper.1),
            (of_hole.lower_um, of_shaft.upper_um, self.words.get(lower.0), lower.1),
        ];
        if let (Some(Mark::InSight(hole)), Some(Mark::InSight(shaft))) = (of_hole.mark, of_shaft.mark)
            && let Some(MeasuredParts::Both(actual)) = self.view.session.fit().parts()
        {
            let id = if actual.clearance < Length::ZERO { "fit-arrow-interference" } else { "fit-arrow-clearance" };
            arrows.push((hole, shaft, self.words.get(id), actual.clearance.abs()));
        }
        let step = space_for.span() / f32::from(u8::try_from(arrows.len()).unwrap_or(1));
        let mut x = space_for.min + step / 2.0;
        for (from, to, name, amount) in arrows {
            let from = self.y(from);
            let to = self.y(to);
            for y in [from, to] {
                let ends = [pos2(hole.max, y), pos2(x + space(2.0), y)];
                self.painter.extend(Shape::dashed_line(&ends, Stroke::new(1.0, self.palette.quiet.0), 3.0, 3.0));
            }
            self.arrow(x, from, to, Stroke::new(2.0, self.ink));
            // Beside the line's middle, but not on the zero line.
            let middle = f32::midpoint(from, to);
            let zero = self.y(0.0);
            let middle = if (middle - zero).abs() < LINE / 2.0 { zero - LINE * 0.75 } else { middle };
            let at = pos2(x + space(2.0), middle);
            self.label(at, Align2::LEFT_CENTER, &self.words.um(amount), theme::bold(sizes().limits));
            self.below(x, &name, step - space(1.0));
            x += step;
        }
    }

    /// A vertical arrow with heads at both ends, where there is room for them.
    fn arrow(&self, x: f32, from: f32, to: f32, stroke: Stroke) {
        let top = from.min(to);
        let bottom = from.max(to);
        if bottom - top < 1.0 {
            return;
        }
        self.painter.vline(x, top..=bottom, stroke);
        let size = space(2.25).min((bottom - top) / 3.0);
        self.head(pos2(x, top), vec2(0.0, -1.0), size, stroke.color);
        self.head(pos2(x, bottom), vec2(0.0, 1.0), size, stroke.color);
    }

    /// An arrowhead whose tip touches the place.
    fn head(&self, tip: Pos2, direction: eframe::egui::Vec2, size: f32, colour: Color32) {
        shapes::arrow_head(&self.painter, tip - direction * size * 0.6, direction, size, colour);
    }
}
