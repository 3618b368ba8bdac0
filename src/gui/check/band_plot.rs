//! The limit band: deviation from the nominal size, the zone, both sides named and hatched, the measured value.

use eframe::egui::{Align2, Color32, Painter, Pos2, Rect, RichText, Sense, Stroke, Ui, pos2, vec2};

use crate::gui::limits::feature_id;
use crate::gui::shapes::{self, Hatch, screen};
use crate::gui::spoken;
use crate::gui::theme::{self, Palette, palette, sizes, space};
use crate::gui::view::{Digits, View, heading, quiet};
use crate::journal::Record;
use crate::length::Length;
use crate::message::message;
use crate::report::band::{Band, GuardBand, Guarded, Marker, Side};
use crate::session::CheckField;
use crate::tolerance::Limits;
use crate::tolerance::callout::Callout;
use crate::verdict::{Rule, Status};
use crate::words::Words;

/// The band of a page on which nothing was typed yet.
const EXAMPLE: &str = "25 H7";

/// Below this height the heading has no more room than its text.
const CLOSE: f32 = 52.0;

/// The height that heading and plot need, so that nothing of them is cut.
pub(super) fn least_height(ui: &Ui) -> f32 {
    let heading = ui.fonts_mut(|fonts| fonts.row_height(&theme::bold(sizes().heading)));
    heading.ceil() + ui.spacing().item_spacing.y + TRACK[0] + ABOVE + BELOW
}

/// Heading and plot over the height there is.
pub(super) fn band_ui(ui: &mut Ui, view: &View<'_>) {
    let record = view.session.check().shown.as_ref().map(|shown| shown.record.as_ref());
    let asked = view.session.check().asked.limits.as_ref();
    let example = if asked.is_none() { example(view) } else { None };
    ui.scope(|ui| {
        // The room around the heading gives way first.
        if ui.available_height() < space(CLOSE) {
            ui.spacing_mut().interact_size.y = 0.0;
        }
        ui.horizontal(|ui| {
            ui.spacing_mut().interact_size.y = 0.0;
            heading(ui, view.text("limit-band"));
            if let Some(limits) = asked {
                quiet(ui, title(view, limits));
            } else if example.is_some() {
                quiet(ui, view.words.say(&message!("band-example").text("callout", EXAMPLE)));
            }
            if record.is_some_and(|record| record.measurement.origin.is_simulated()) {
                ui.label(RichText::new(view.text("simulated")).font(theme::bold(sizes().body)));
            }
        });
    });
    let Some(limits) = asked.or(example.as_ref()) else {
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
    let height = ui.available_height();
    plot_ui(ui, view.words, &band, limits, record, height);
}

/// The band of other limits, with the check of a value where there is one, over the height there is. Guard bands come with the rule that
/// judged.
pub(in crate::gui) fn band_of_ui(ui: &mut Ui, view: &View<'_>, limits: &Limits, record: Option<&Record>) {
    let rule = record.map_or_else(Rule::default, |record| record.verdict.rule);
    let band = Band::by(&rule, limits, record.map(|record| record.measurement.diameter));
    let height = ui.available_height();
    plot_ui(ui, view.words, &band, limits, record, height);
}

/// The limits of the example, for who has not typed anything; where something is typed, no other limits are shown.
fn example(view: &View<'_>) -> Option<Limits> {
    let is_empty = view.session.text(CheckField::Callout).trim().is_empty();
    let callout = is_empty.then(|| EXAMPLE.parse::<Callout>().ok())??;
    view.session.sources().limits(&callout, callout.feature()).ok()
}

fn title(view: &View<'_>, limits: &Limits) -> String {
    let feature = view.text(feature_id(limits.feature));
    match view.session.check().asked.callout {
        Some(callout) => format!("{callout}, {feature}"),
        None => feature,
    }
}

/// The height of what is drawn above and below the track.
const ABOVE: f32 = 46.0;
const BELOW: f32 = 54.0;

/// The track itself, at least and at most.
const TRACK: [f32; 2] = [36.0, 124.0];

fn plot_ui(ui: &mut Ui, words: &Words, band: &Band, limits: &Limits, record: Option<&Record>, height: f32) {
    let palette = palette(ui.ctx());
    let height = height.max(TRACK[0] + ABOVE + BELOW);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
    let track = (height - ABOVE - BELOW).min(TRACK[1]);
    let top = rect.top() + ABOVE + (height - ABOVE - BELOW - track) * 0.4;
    let body = Rect::from_min_size(pos2(rect.left(), top), vec2(rect.width(), track));
    Drawing { painter, body, frame: rect, palette, words, band, limits }.draw(record);
    let said = describe(words, limits, record, band);
    spoken::picture(ui, &response, words.get("limit-band"), said);
}

/// What the picture shows, in words, for users who cannot see it.
fn describe(words: &Words, limits: &Limits, record: Option<&Record>, band: &Band) -> String {
    let zone = message!("band-describe")
        .text("lower", words.signed_um(limits.deviations.lower()))
        .text("upper", words.signed_um(limits.deviations.upper()))
        .text("left", words.get(side_id(band.left)))
        .text("right", words.get(side_id(band.right)));
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

const fn side_id(side: Side) -> &'static str {
    match side {
        Side::Rework => "side-rework",
        Side::Scrap => "side-scrap",
        Side::Out => "side-out",
    }
}

struct Drawing<'a> {
    painter: Painter,
    /// The track: zone, sides and guard bands.
    body: Rect,
    frame: Rect,
    palette: &'a Palette,
    words: &'a Words,
    band: &'a Band,
    limits: &'a Limits,
}

impl Drawing<'_> {
    fn draw(&self, record: Option<&Record>) {
        let body = self.body;
        let lower = self.x(self.band.lower_um);
        let upper = self.x(self.band.upper_um);
        self.painter.rect_filled(body, 10.0, self.palette.sunken.0);
        self.side(Rect::from_min_max(body.min, pos2(lower, body.bottom())), self.band.left);
        self.side(Rect::from_min_max(pos2(upper, body.top()), body.max), self.band.right);
        // A zone of no width is still drawn as a line.
        let zone = Rect::from_min_max(pos2(lower, body.top()), pos2(upper.max(lower + 1.0), body.bottom()));
        self.painter.rect_filled(zone, 0.0, self.palette.zone.0);
        self.guard(body);
        for x in [lower, upper] {
            self.painter.vline(x, body.y_range().expand(7.0), Stroke::new(2.5, self.palette.zone_edge.0));
        }
        self.guard_marks(body);
        self.limits([lower, upper]);
        self.axis();
        match (self.band.marker, record) {
            (Some(marker), Some(record)) => self.marker(marker, record, body),
            _ => self.width_of_zone(zone),
        }
    }

    fn x(&self, um: f64) -> f32 {
        let share = (um - self.band.axis_min_um) / (self.band.axis_max_um - self.band.axis_min_um);
        self.body.left() + self.body.width() * screen(share)
    }

    /// Above the track: which limit it is and its deviation, and its size. Two that are close stand apart.
    fn limits(&self, [lower, upper]: [f32; 2]) {
        let bounds = &self.limits.bounds();
        let texts = [
            ("minimum", self.band.lower_um, bounds.minimum(), lower),
            ("maximum", self.band.upper_um, bounds.maximum(), upper),
        ]
        .map(|(id, um, size, x)| {
            let sign = if 0.0 < um { "+" } else { "" };
            let deviation = self.words.number(&format!("{um}"));
            let name = format!("{} {sign}{deviation}", self.words.get(id));
            let name = self.painter.layout_no_wrap(name, theme::font(sizes().small), self.palette.quiet.0);
            let size = self.words.mm(size, 3);
            let size = self.painter.layout_no_wrap(size, theme::bold(sizes().limits), self.palette.text.0);
            (name, size, x)
        });
        let width = |(name, size, _): &(_, _, f32)| f32::max(galley_width(name), galley_width(size));
        let [of_lower, of_upper] = [width(&texts[0]), width(&texts[1])];
        // The names stay in sight and do not cross.
        let apart = f32::midpoint(of_lower, of_upper) + space(2.0) - (upper - lower);
        let shift = (apart / 2.0).max(0.0);
        let places = [lower - shift, upper + shift].map(|x| {
            let half = of_lower.max(of_upper) / 2.0;
            x.clamp(self.frame.left() + half, (self.frame.right() - half).max(self.frame.left() + half))
        });
        for ((name, size, _), x) in texts.into_iter().zip(places) {
            let bottom = self.body.top() - 9.0;
            let at = pos2(x - size.size().x / 2.0, bottom - size.size().y);
            let above = pos2(x - name.size().x / 2.0, at.y - name.size().y + 1.0);
            self.painter.galley(at, size, self.palette.text.0);
            self.painter.galley(above, name, self.palette.quiet.0);
        }
    }

    /// Below: a line with the band's own ticks, in micrometres from the nominal size.
    fn axis(&self) {
        let y = self.frame.bottom() - 22.0;
        self.painter.hline(self.frame.x_range(), y, Stroke::new(1.0, self.palette.line.0));
        let font = theme::font(sizes().small);
        let unit = self.painter.layout_no_wrap("µm".to_owned(), font.clone(), self.palette.quiet.0);
        let at = pos2(self.frame.right() - unit.size().x, y + 4.0);
        let mut free = at.x - space(2.0);
        self.painter.galley(at, unit, self.palette.quiet.0);
        // From the right, where the unit stands; a number that has no room is left out, its tick is not.
        for um in self.band.ticks.iter().rev() {
            let x = self.x(*um);
            self.painter.vline(x, y - 4.0..=y + 3.0, Stroke::new(1.0, self.palette.edge.0));
            let sign = if 0.0 < *um { "+" } else { "" };
            let number = self.words.number(&format!("{}", (um * 1000.0).round() / 1000.0));
            let text = self.painter.layout_no_wrap(format!("{sign}{number}"), font.clone(), self.palette.quiet.0);
            let half = text.size().x / 2.0;
            if x + half <= free && self.frame.left() <= x - half {
                free = x - half - space(2.0);
                self.painter.galley(pos2(x - half, y + 4.0), text, self.palette.quiet.0);
            }
        }
    }

    /// Before a value is there: how wide the zone is, and where its middle.
    fn width_of_zone(&self, zone: Rect) {
        let stroke = Stroke::new(1.5, self.palette.zone_edge.0);
        let middle = zone.center();
        if zone.width() < space(6.0) {
            return;
        }
        let dots = [pos2(middle.x, zone.top() + 4.0), pos2(middle.x, zone.bottom() - 4.0)];
        self.painter.extend(eframe::egui::Shape::dotted_line(&dots, stroke.color, 6.0, 1.0));
        let um = self.band.upper_um - self.band.lower_um;
        let text = format!("{} µm", self.words.number(&format!("{}", (um * 1000.0).round() / 1000.0)));
        self.dimension(zone.left(), zone.right(), middle.y, &text, self.palette.zone.0);
    }

    /// A dimension line between two places with its number in the middle, on a ground; without arrows where there is no room.
    fn dimension(&self, from: f32, to: f32, y: f32, text: &str, ground: Color32) {
        let colour = self.palette.zone_edge.0;
        let has_number = !text.is_empty();
        let stroke = Stroke::new(1.5, colour);
        let (left, right) = (from.min(to), from.max(to));
        self.painter.hline(left..=right, y, stroke);
        if space(4.0) < right - left {
            for (tip, along) in [(left, 1.0), (right, -1.0)] {
                for across in [-3.5, 3.5] {
                    self.painter.line_segment([pos2(tip, y), pos2(tip + along * 6.0, y + across)], stroke);
                }
            }
        }
        let galley = self.painter.layout_no_wrap(text.to_owned(), theme::bold(sizes().small), colour);
        let rect = Align2::CENTER_CENTER.anchor_size(pos2(f32::midpoint(left, right), y), galley.size());
        if has_number {
            self.painter.rect_filled(rect.expand2(vec2(4.0, 0.0)), 2.0, ground);
            self.painter.galley(rect.min, galley, colour);
        }
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

    /// A side of the zone, hatched, with its name where that has room beside the marker.
    fn side(&self, rect: Rect, side: Side) {
        let id = side_id(side);
        let (hatch, colour) = match side {
            Side::Rework => (Hatch::Single, self.palette.hatch_rework.0),
            Side::Scrap => (Hatch::Cross, self.palette.hatch_scrap.0),
            Side::Out => (Hatch::Cross, self.palette.hatch_out.0),
        };
        shapes::hatch(&self.painter, rect, hatch, Stroke::new(1.2, colour));
        let galley = self.painter.layout_no_wrap(self.words.get(id), theme::bold(sizes().small), self.palette.text.0);
        let marker = match self.band.marker {
            Some(Marker::InSight(um)) => Some(self.x(um)),
            Some(Marker::BeyondLeft(_)) => Some(self.body.left() + space(12.0)),
            Some(Marker::BeyondRight(_)) => Some(self.body.right() - space(12.0)),
            None => None,
        };
        let ground = Align2::CENTER_CENTER.align_size_within_rect(galley.size(), rect).expand2(vec2(6.0, 2.0));
        // The word gives way to the marker and to a distance that has no room beside it.
        let zone = self.x(self.band.upper_um) - self.x(self.band.lower_um);
        let is_near = |x: f32| (rect.distance_to_pos(pos2(x, rect.center().y)) < space(16.0)) && space(4.0) < zone;
        let has_marker = marker.is_some_and(|x| rect.x_range().contains(x) || is_near(x));
        if galley.size().x + space(5.0) < rect.width() && !has_marker {
            self.painter.rect_filled(ground, 6.0, self.palette.surface.0);
            self.painter.galley(ground.center() - galley.size() / 2.0, galley, self.palette.text.0);
        }
    }

    fn marker(&self, marker: Marker, record: &Record, body: Rect) {
        let colour = self.palette.text.0;
        let digits = Digits::of(record);
        let value = digits.mm(self.words, record.measurement.diameter, 3);
        let triangle = |tip: Pos2, along: eframe::egui::Vec2| {
            let across = vec2(-along.y, along.x) * 0.7;
            let points = vec![tip, tip - along + across, tip - along - across];
            let edge = Stroke::new(1.0, self.palette.surface.0);
            self.painter.add(eframe::egui::epaint::PathShape::convex_polygon(points, colour, edge));
        };
        let flag = |x: f32, text: &str| {
            let galley =
                self.painter.layout_no_wrap(text.to_owned(), theme::bold(sizes().body), self.palette.surface.0);
            let size = galley.size() + vec2(20.0, 4.0);
            let half = size.x / 2.0;
            let x = x.clamp(self.frame.left() + half, (self.frame.right() - half).max(self.frame.left() + half));
            let rect = Rect::from_min_size(pos2(x - half, body.bottom() + 8.0), size);
            self.painter.rect_filled(rect, 6.0, colour);
            self.painter.galley(rect.center() - galley.size() / 2.0, galley, self.palette.surface.0);
        };
        match marker {
            Marker::InSight(um) => {
                let x = self.x(um);
                let halo = Stroke::new(6.0, self.palette.surface.0);
                self.painter.vline(x, body.y_range(), halo);
                self.distances(x, record, body);
                self.painter.vline(x, body.y_range().expand(4.0), Stroke::new(3.0, colour));
                triangle(pos2(x, body.bottom()), vec2(0.0, -9.0));
                flag(x, &value);
            }
            Marker::BeyondLeft(_) | Marker::BeyondRight(_) => {
                let is_left = matches!(marker, Marker::BeyondLeft(_));
                let (x, along) = if is_left { (body.left() + 2.0, -14.0) } else { (body.right() - 2.0, 14.0) };
                triangle(pos2(x, body.center().y), vec2(along, 0.0));
                flag(x, &value);
            }
        }
    }

    /// The distances that matter, as lines with their numbers: to both limits inside the zone, to the limit that is
    /// passed outside it.
    fn distances(&self, x: f32, record: &Record, body: Rect) {
        let size = &record.verdict.size;
        let is_outside = size.above_minimum < Length::ZERO || size.below_maximum < Length::ZERO;
        for (limit, distance, share) in [
            (self.x(self.band.lower_um), size.above_minimum, 0.34),
            (self.x(self.band.upper_um), size.below_maximum, 0.66),
        ] {
            if distance == Length::ZERO || (is_outside && Length::ZERO <= distance) {
                continue;
            }
            let text = format!("{} µm", Digits::of(record).um(self.words, distance.abs()));
            let y = body.top() + body.height() * share;
            let ground = if is_outside { self.palette.surface.0 } else { self.palette.zone.0 };
            let width = self.painter.layout_no_wrap(text.clone(), theme::bold(sizes().small), ground).size().x;
            if width + space(5.0) < (x - limit).abs() {
                self.dimension(x, limit, y, &text, ground);
            } else if is_outside {
                // Where there is no room between, the number stands beyond the value.
                self.dimension(x, limit, y, "", ground);
                let is_left = x < limit;
                let room = if is_left { x - self.frame.left() } else { self.frame.right() - x };
                let (end, is_left) = if width + space(4.0) <= room { (x, is_left) } else { (limit, !is_left) };
                let anchor = if is_left { Align2::RIGHT_CENTER } else { Align2::LEFT_CENTER };
                let at = pos2(end + if is_left { -space(3.0) } else { space(3.0) }, y);
                let galley = self.painter.layout_no_wrap(text, theme::bold(sizes().small), self.palette.text.0);
                let rect = anchor.anchor_size(at, galley.size());
                // The line goes on to its number.
                self.painter.hline(end.min(at.x)..=end.max(at.x), y, Stroke::new(1.5, self.palette.zone_edge.0));
                self.painter.rect_filled(rect.expand2(vec2(4.0, 1.0)), 4.0, self.palette.surface.0);
                self.painter.galley(rect.min, galley, self.palette.text.0);
            } else {
                // Within the zone a number beyond the limit would stand where the value is not: the card has it.
                self.dimension(x, limit, y, "", ground);
            }
        }
    }
}

fn galley_width(galley: &std::sync::Arc<eframe::egui::Galley>) -> f32 {
    galley.size().x
}
