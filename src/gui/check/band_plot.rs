//! The limit band: deviation from the nominal size, the zone, both sides named and hatched, the measured value.

use eframe::egui::accesskit::Role;
use eframe::egui::{Align2, Color32, Painter, Pos2, Rect, RichText, Stroke, Ui, WidgetInfo, pos2, vec2};
use egui_plot::{AxisHints, GridMark, PlotBounds, PlotTransform, VLine, VPlacement};

use crate::gui::limits::feature_id;
use crate::gui::shapes::{self, Hatch};
use crate::gui::theme::{self, Palette, palette, sizes, space};
use crate::gui::view::{Digits, View, heading, quiet, still_plot};
use crate::journal::Record;
use crate::length::Length;
use crate::message::message;
use crate::report::band::{Band, GuardBand, Guarded, Marker, Side};
use crate::tolerance::{Feature, Limits};
use crate::verdict::Rule;
use crate::verdict::Status;
use crate::words::Words;

/// How far down the band the distance to the lower limit is drawn.
const FIRST_LINE: f32 = 0.68;

/// Heading and plot over the given height.
pub(super) fn band_ui(ui: &mut Ui, view: &View<'_>, height: f32) {
    let record = view.session.check().shown.as_ref().map(|shown| shown.record.as_ref());
    ui.horizontal(|ui| {
        heading(ui, view.text("limit-band"));
        if let Some(limits) = view.session.check().asked.limits.as_ref() {
            quiet(ui, title(view, limits));
        }
        if record.is_some_and(|record| record.measurement.origin.is_simulated()) {
            ui.label(RichText::new(view.text("simulated")).font(theme::bold(sizes().body)));
        }
    });
    let Some(limits) = view.session.check().asked.limits.as_ref() else {
        quiet(ui, view.text("band-empty"));
        return;
    };
    let measured = record.map(|record| record.measurement.diameter);
    // The rule that judged; before anything is measured the one that will.
    let rule = record.map(|record| record.verdict.rule).or_else(|| view.session.rule_ahead());
    let rule = rule.unwrap_or_else(|| {
        // The limits are drawn as if they alone counted, and a rule is chosen that will not judge so.
        quiet(ui, view.text("band-no-guards"));
        Rule::default()
    });
    let band = Band::by(&rule, limits, measured);
    plot_ui(ui, view.words, &band, limits, record, height);
}

fn title(view: &View<'_>, limits: &Limits) -> String {
    let feature = view.text(feature_id(limits.feature));
    match view.session.check().asked.callout {
        Some(callout) => format!("{callout}, {feature}"),
        None => feature,
    }
}

fn plot_ui(ui: &mut Ui, words: &Words, band: &Band, limits: &Limits, record: Option<&Record>, height: f32) {
    let palette = palette(ui.ctx());
    let axis = AxisHints::new_x()
        .formatter(|mark, _| words.number(&format!("{}", (mark.value * 1000.0).round() / 1000.0)))
        .tick_label_font(theme::font(sizes().small))
        .tick_label_color(palette.text.0)
        .label("µm")
        .placement(VPlacement::Bottom);
    let response = still_plot("limit-band", height)
        .custom_x_axes(vec![axis])
        .show_axes([true, false])
        .x_grid_spacer(|_| ticks(band))
        .set_margin_fraction(vec2(0.0, 0.0))
        .show(ui, |plot| {
            plot.set_plot_bounds(PlotBounds::from_min_max([band.axis_min_um, 0.0], [band.axis_max_um, 1.0]));
            plot.vline(VLine::new("nominal", 0.0).color(palette.quiet.0).width(1.0).allow_hover(false));
        });
    let painter = ui.painter().with_clip_rect(response.response.rect);
    Drawing { painter, transform: response.transform, palette, words, band }.draw(record);
    let said = describe(words, limits, record, band);
    response.response.widget_info(|| WidgetInfo::labeled(Role::Figure, true, words.get("limit-band")));
    ui.ctx().accesskit_node_builder(response.response.id, |node| node.set_description(said.clone()));
}

/// The band's own ticks, each with a label.
fn ticks(band: &Band) -> Vec<GridMark> {
    let step_size = match band.ticks.as_slice() {
        [first, second, ..] => second - first,
        _ => band.axis_max_um - band.axis_min_um,
    };
    band.ticks.iter().map(|&value| GridMark { value, step_size }).collect()
}

/// What the picture shows, in words, for users who cannot see it.
fn describe(words: &Words, limits: &Limits, record: Option<&Record>, band: &Band) -> String {
    let zone = message!("band-describe")
        .text("lower", words.signed_um(limits.deviations.lower()))
        .text("upper", words.signed_um(limits.deviations.upper()))
        .text("left", words.get(side_id(limits.feature, true)))
        .text("right", words.get(side_id(limits.feature, false)));
    let mut text = words.say(&zone);
    if let Some(guard) = &band.guard {
        let um = |um: f64| words.number(&format!("{um}"));
        let said = match guard.accepted {
            Some([least, most]) => {
                words.say(&message!("band-describe-accepted").text("least", um(least)).text("most", um(most)))
            }
            None => words.get("band-describe-nothing"),
        };
        text = format!("{text} {said}");
    }
    if let Some(record) = record {
        let measured = message!("band-describe-measured")
            .text("deviation", words.signed_um(record.verdict.size.deviation))
            .text("above", words.signed_um(record.verdict.size.above_minimum))
            .text("below", words.signed_um(record.verdict.size.below_maximum));
        text = format!("{text} {}", words.say(&measured));
    }
    text
}

const fn side_id(feature: Feature, left: bool) -> &'static str {
    match (feature, left) {
        (Feature::Hole, true) | (Feature::Shaft, false) => "side-rework",
        (Feature::Hole, false) | (Feature::Shaft, true) => "side-scrap",
    }
}

struct Drawing<'a> {
    painter: Painter,
    transform: PlotTransform,
    palette: &'a Palette,
    words: &'a Words,
    band: &'a Band,
}

impl Drawing<'_> {
    fn draw(&self, record: Option<&Record>) {
        let frame = *self.transform.frame();
        let body = Rect::from_min_max(
            pos2(frame.left(), frame.top() + space(7.0)),
            pos2(frame.right(), frame.bottom() - space(7.0)),
        );
        let lower = self.x(self.band.lower_um);
        let upper = self.x(self.band.upper_um);
        let left = Rect::from_min_max(body.min, pos2(lower, body.bottom()));
        let right = Rect::from_min_max(pos2(upper, body.top()), body.max);
        self.side(left, self.band.left, Align2::LEFT_TOP);
        self.side(right, self.band.right, Align2::RIGHT_TOP);
        // A zone of no width is still drawn as a line.
        let zone = Rect::from_min_max(pos2(lower, body.top()), pos2(upper.max(lower + 1.0), body.bottom()));
        self.painter.rect_filled(zone, 0.0, self.palette.zone.0);
        self.guard(body);
        for (x, um) in [(lower, self.band.lower_um), (upper, self.band.upper_um)] {
            self.painter.vline(x, body.y_range(), Stroke::new(2.0, self.palette.zone_edge.0));
            let text = format!("{}{}", if 0.0 < um { "+" } else { "" }, self.words.number(&format!("{um}")));
            // On a ground: the line of the nominal size goes up to the edge.
            let colours = (self.palette.surface.0, self.palette.text.0);
            self.label(pos2(x, body.top() - 2.0), Align2::CENTER_BOTTOM, &text, colours);
        }
        let nominal = self.x(0.0);
        self.painter.extend(eframe::egui::Shape::dashed_line(
            &[pos2(nominal, body.top()), pos2(nominal, frame.bottom())],
            Stroke::new(1.5, self.palette.quiet.0),
            5.0,
            4.0,
        ));
        self.guard_marks(body);
        if let (Some(marker), Some(record)) = (self.band.marker, record) {
            self.marker(marker, record, body);
        }
        // Above the distances, where the band is high enough for both.
        let is_high = record.is_none() || sizes().body * 1.3 + sizes().small + space(1.0) < body.height() * FIRST_LINE;
        if space(20.0) < zone.width() && is_high {
            let ground = self.palette.zone.0;
            let colour = self.palette.zone_edge.0;
            let middle = zone.center().x;
            let measured = match self.band.marker.filter(|_| record.is_some()) {
                Some(Marker::InSight(um)) => Some(self.x(um)),
                _ => None,
            };
            // Beside the line of the measured value, not across it.
            let x = match measured {
                Some(x) if (x - middle).abs() < space(8.0) => f32::midpoint(x, zone.right()),
                _ => middle,
            };
            self.label(pos2(x, zone.top() + 4.0), Align2::CENTER_TOP, &self.words.get("zone"), (ground, colour));
        }
    }

    fn x(&self, um: f64) -> f32 {
        self.transform.position_from_point_x(um)
    }

    /// Text without a background.
    fn text(&self, at: Pos2, anchor: Align2, text: &str, colour: Color32) {
        self.label(at, anchor, text, (Color32::TRANSPARENT, colour));
    }

    /// Text on a background, so that lines and hatching do not cross it.
    fn label(&self, at: Pos2, anchor: Align2, text: &str, (ground, colour): (Color32, Color32)) {
        let galley = self.painter.layout_no_wrap(text.to_owned(), theme::font(sizes().body), colour);
        let rect = anchor.anchor_size(at, galley.size());
        // Kept inside the plot, so that no number is cut off.
        let frame = self.transform.frame();
        let shift = (frame.left() - rect.left()).max(0.0) - (rect.right() - frame.right()).max(0.0);
        let rect = rect.translate(vec2(shift, 0.0));
        self.painter.rect_filled(rect.expand2(vec2(3.0, 0.0)), 2.0, ground);
        self.painter.galley(rect.min, galley, colour);
    }

    /// The guard bands: what lies between a limit and where the rule decides.
    fn guard(&self, body: Rect) {
        for band in self.guard_bands() {
            let rect = self.of_band(band, body);
            let (ground, hatch, colour) = match band.guarded {
                Guarded::Undecided => (self.palette.surface.0, Hatch::Upright, self.measure_again()),
                Guarded::AcceptedBeyond => (self.palette.zone.0, Hatch::Falling, self.palette.zone_edge.0),
            };
            self.painter.rect_filled(rect, 0.0, ground);
            shapes::hatch(&self.painter, rect, hatch, Stroke::new(1.0, colour.gamma_multiply(0.8)));
        }
    }

    /// What happens in them: the word, or the shape of the status where the word has no room.
    fn guard_marks(&self, body: Rect) {
        for band in self.guard_bands() {
            let rect = self.of_band(band, body);
            let id = match band.guarded {
                Guarded::Undecided => "guard-band",
                Guarded::AcceptedBeyond => "guard-band-beyond",
            };
            let font = theme::font(sizes().small);
            let galley = self.painter.layout_no_wrap(self.words.get(id), font, self.palette.text.0);
            let at = Align2::CENTER_BOTTOM.anchor_size(rect.center_bottom() - vec2(0.0, 4.0), galley.size());
            let mark =
                Rect::from_center_size(rect.center_bottom() - vec2(0.0, space(4.0)), vec2(space(4.0), space(4.0)));
            if galley.size().x + 6.0 < rect.width() {
                self.painter.rect_filled(at.expand2(vec2(3.0, 0.0)), 2.0, self.palette.surface.0);
                self.painter.galley(at.min, galley, self.palette.text.0);
            } else if band.guarded == Guarded::Undecided && space(5.0) < rect.width() {
                self.painter.rect_filled(mark.expand(2.0), 2.0, self.palette.surface.0);
                shapes::status(&self.painter, mark, Some(Status::ReMeasure), self.palette.text.0);
            }
        }
    }

    fn guard_bands(&self) -> impl Iterator<Item = &GuardBand> {
        self.band.guard.iter().flat_map(|guard| &guard.bands)
    }

    fn of_band(&self, band: &GuardBand, body: Rect) -> Rect {
        Rect::from_x_y_ranges(self.x(band.from_um)..=self.x(band.to_um), body.y_range())
    }

    /// The colour of the status.
    fn measure_again(&self) -> Color32 {
        self.palette.of_status(Some(Status::ReMeasure)).0
    }

    fn side(&self, rect: Rect, side: Side, anchor: Align2) {
        let (id, hatch, colour) = match side {
            Side::Rework => ("side-rework", Hatch::Single, self.palette.hatch_rework.0),
            Side::Scrap => ("side-scrap", Hatch::Cross, self.palette.hatch_scrap.0),
        };
        shapes::hatch(&self.painter, rect, hatch, Stroke::new(1.0, colour.gamma_multiply(0.55)));
        let text = self.words.get(id);
        let galley = self.painter.layout_no_wrap(text.clone(), theme::bold(sizes().body), self.palette.text.0);
        if galley.size().x + space(4.0) < rect.width() {
            let at = anchor.pos_in_rect(&rect.shrink(4.0));
            let ground = anchor.anchor_size(at, galley.size()).expand(3.0);
            self.painter.rect_filled(ground, 3.0, self.palette.surface.0);
            self.painter.galley(anchor.anchor_size(at, galley.size()).min, galley, self.palette.text.0);
        }
    }

    fn marker(&self, marker: Marker, record: &Record, body: Rect) {
        let deviation = record.verdict.size.deviation;
        let said = format!("{} µm", Digits::of(record).signed_um(self.words, deviation));
        let colour = self.palette.text.0;
        let size = space(4.0);
        let tip = |x: f32| pos2(x, body.center().y);
        let triangle = |tip: Pos2, along: eframe::egui::Vec2| {
            let across = vec2(-along.y, along.x) * 0.6;
            let points = vec![tip, tip - along + across, tip - along - across];
            self.painter.add(eframe::egui::epaint::PathShape::convex_polygon(
                points,
                colour,
                Stroke::new(1.0, self.palette.surface.0),
            ));
        };
        match marker {
            Marker::InSight(um) => {
                let x = self.x(um);
                self.painter.vline(x, body.y_range(), Stroke::new(2.0, colour));
                triangle(tip(x), vec2(0.0, -size * 1.4));
                self.distances(x, record, body);
                let frame = self.transform.frame();
                self.text(pos2(x, frame.bottom()), Align2::CENTER_BOTTOM, &said, colour);
            }
            Marker::BeyondLeft(_) => {
                triangle(tip(body.left() + 2.0), vec2(-size * 1.6, 0.0));
                self.label(tip(body.left() + size * 2.4), Align2::LEFT_CENTER, &said, (self.palette.surface.0, colour));
            }
            Marker::BeyondRight(_) => {
                triangle(tip(body.right() - 2.0), vec2(size * 1.6, 0.0));
                self.label(
                    tip(body.right() - size * 2.4),
                    Align2::RIGHT_CENTER,
                    &said,
                    (self.palette.surface.0, colour),
                );
            }
        }
    }

    /// The distances that matter, as lines with their numbers: to both limits inside the zone, to the limit that is
    /// passed outside it.
    fn distances(&self, x: f32, record: &Record, body: Rect) {
        let stroke = Stroke::new(1.5, self.palette.text.0);
        let size = &record.verdict.size;
        let is_outside = size.above_minimum < Length::ZERO || size.below_maximum < Length::ZERO;
        for (limit, distance, share) in [
            (self.x(self.band.lower_um), size.above_minimum, FIRST_LINE),
            (self.x(self.band.upper_um), size.below_maximum, 0.86),
        ] {
            if is_outside && Length::ZERO <= distance {
                continue;
            }
            let y = body.top() + body.height() * share;
            self.painter.hline(x.min(limit)..=x.max(limit), y, stroke);
            self.painter.circle_filled(pos2(limit, y), 3.0, stroke.color);
            let text = format!("{} µm", Digits::of(record).um(self.words, distance.abs()));
            let galley = self.painter.layout_no_wrap(text, theme::font(sizes().small), stroke.color);
            // Beside the triangle, whose foot reaches down to the first line.
            let has_room = galley.size().x + space(7.0) < (x - limit).abs();
            if distance != Length::ZERO && (has_room || is_outside) {
                // Outside the zone it stands on the zone's side of the limit where there is no room between.
                let beside = if x < limit { Align2::LEFT_CENTER } else { Align2::RIGHT_CENTER };
                let (anchor, at) = if has_room {
                    (Align2::CENTER_CENTER, f32::midpoint(x, limit))
                } else {
                    (beside, limit + (limit - x).signum() * space(2.0))
                };
                let at = anchor.anchor_size(pos2(at, y), galley.size());
                self.painter.rect_filled(at.expand2(vec2(3.0, 0.0)), 2.0, self.palette.surface.0);
                self.painter.galley(at.min, galley, stroke.color);
            }
        }
    }
}
