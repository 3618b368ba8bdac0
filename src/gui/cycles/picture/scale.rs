//! One view of the path of the ball's centre: the same scale on both axes, the nominal surface, moves, ball, contacts.

use eframe::egui::epaint::PathShape;
use eframe::egui::{Align2, Pos2, Rect, Stroke, Vec2, pos2, vec2};

use super::canvas::Canvas;
use super::way::{Eye, Way, ends, part_places, phase_id, place, trace};
use crate::gui::shapes::screen;
use crate::gui::theme::{sizes, space};
use crate::message::Message;
use crate::probing::cycle::{Move, Phase, Plane};
use crate::probing::simulated::{Outline, PartFeature};
use crate::statistics::round::round_down;
use crate::words::Words;

/// The share of the room that is kept free around a view.
const MARGIN: f64 = 0.08;

/// Less than this, mm, is no extent.
const LEAST_MM: f64 = 1e-3;

/// What a view shows of a path that it sees as a point: this share of the path's largest extent.
const SHARE_OF_PATH: f64 = 0.25;

/// Nothing farther away than this is drawn, mm.
const FARTHEST_MM: f64 = 1e9;

/// What a view shows where, with the same scale on both axes.
pub(super) struct Scale {
    eye: Eye,
    rect: Rect,
    /// Where things are drawn: below the title.
    room: Rect,
    /// What is in the middle, mm.
    middle: [f64; 2],
    points_per_mm: f64,
}

impl Scale {
    /// The largest scale at which everything on the path has room.
    pub(super) fn of(way: &Way<'_>, eye: Eye, rect: Rect) -> Self {
        let mut places = way.places(eye);
        let ball = way.ball_radius;
        places.extend(way.zero_beside(eye, &places));
        let mut around = ball;
        places.extend(way.features.iter().flat_map(|feature| part_places(feature, eye)));
        if places.is_empty() {
            places.push([0.0; 2]);
        }
        let nominal = way.nominal.filter(|_| way.features.is_empty());
        match nominal.map(|surface| surface.outline(0.0)) {
            Some(Outline::Circle { centre: [first, second], radius }) if radius < FARTHEST_MM => {
                // From the side only its width counts.
                let height = places.first().map_or(0.0, |[_, height]| *height);
                let across = [first - radius, first + radius];
                match eye {
                    Eye::Above => {
                        places.extend(across.map(|first| [first, second]));
                        places.extend([second - radius, second + radius].map(|second| [first, second]));
                    }
                    _ => places.extend(across.map(|first| [first, height])),
                }
                around = around.max(radius * MARGIN);
            }
            Some(Outline::Walls(corners)) if is_near(corners.as_flattened()) => {
                let height = places.first().map_or(0.0, |[_, height]| *height);
                match eye {
                    Eye::Above => places.extend(corners),
                    _ => places.extend(span(&corners, eye).map(|across| [across, height])),
                }
            }
            Some(Outline::Face { point, .. }) if is_near(&point) => {
                places.push(eye.see(way.plane().within(point)));
            }
            _ => {}
        }
        let fold = |axis: fn(&[f64; 2]) -> f64| {
            let (least, most) = ends(&places, axis);
            (f64::midpoint(least, most), most - least)
        };
        let ((x, wide), (y, high)) = (fold(|[x, _]| *x), fold(|[_, y]| *y));
        // A ball that moves little still gets some room around it, and so does a path that is seen as a point.
        let is_point = wide.max(high) + 2.0 * around < LEAST_MM;
        let least = if is_point { (extent_of(way) * SHARE_OF_PATH).max(1.0) } else { LEAST_MM };
        let size = |extent: f64| ((extent + 2.0 * around) * (1.0 + 2.0 * MARGIN)).max(6.0 * ball).max(least);
        let inner = rect.shrink(space(2.0));
        let room = inner.with_min_y(inner.top() + sizes().small + space(1.0));
        let [width, height] = [room.width(), room.height()].map(|side| f64::from(side.max(1.0)));
        Self { eye, rect, room, middle: [x, y], points_per_mm: (width / size(wide)).min(height / size(high)) }
    }

    pub(super) const fn eye(&self) -> Eye {
        self.eye
    }

    /// Where things are drawn.
    pub(super) const fn room(&self) -> Rect {
        self.room
    }

    pub(super) const fn rect(&self) -> Rect {
        self.rect
    }

    /// A length that reaches beyond the view, mm.
    pub(super) fn reach(&self) -> f64 {
        f64::from(self.rect.size().length()) / self.points_per_mm
    }

    pub(super) fn at(&self, [x, y]: [f64; 2]) -> Pos2 {
        let [middle_x, middle_y] = self.middle;
        let scaled = |off: f64| screen((off * self.points_per_mm).clamp(-1e5, 1e5));
        self.room.center() + vec2(scaled(x - middle_x), -scaled(y - middle_y))
    }

    pub(super) fn length(&self, mm: f64) -> f32 {
        screen((mm * self.points_per_mm).clamp(0.0, 1e5))
    }

    /// Draws the view; `features` draws those of a part.
    pub(super) fn view(
        &self,
        canvas: &Canvas<'_>,
        way: &Way<'_>,
        words: &Words,
        features: impl Fn(&Canvas<'_>, &Self, &[PartFeature]),
    ) {
        let canvas = Canvas::new(&canvas.painter, canvas.palette, self.rect);
        let frame = Stroke::new(1.0, canvas.palette.line.0);
        canvas.painter.rect_filled(self.rect, 4.0, canvas.palette.surface.0);
        if way.features.is_empty() {
            self.nominal(&canvas, way);
        } else {
            features(&canvas, self, way.features);
        }
        canvas.painter.rect_stroke(self.rect, 4.0, frame, eframe::egui::StrokeKind::Inside);
        for (number, one) in way.moves.iter().enumerate().rev() {
            self.go(&canvas, one, way.plane(), number < way.step);
        }
        if let Some(at) = place(way.moves, way.step) {
            let at = self.at(self.eye.see(way.plane().within(at)));
            canvas.ball(at, self.length(way.ball_radius).max(3.0));
        }
        if self.eye == Eye::Above {
            self.contacts(&canvas, way);
        }
        self.names(&canvas, way, words);
    }

    fn nominal(&self, canvas: &Canvas<'_>, way: &Way<'_>) {
        let Some(surface) = way.nominal else { return };
        let is_outside = surface.shape().is_outside();
        let palette = canvas.palette;
        let (out, within) =
            if is_outside { (palette.surface.0, palette.none.0) } else { (palette.none.0, palette.surface.0) };
        // Walls without an end reach beyond the view.
        match surface.outline(self.reach()) {
            Outline::Circle { centre: [first, second], radius } if radius < FARTHEST_MM => {
                if self.eye == Eye::Above {
                    let centre = self.at([first, second]);
                    let radius = self.length(radius);
                    canvas.painter.rect_filled(self.rect, 4.0, out);
                    canvas.circle(centre, radius, within, canvas.edge());
                    canvas.cross(centre, 5.0, canvas.thin());
                } else {
                    self.walls(canvas, way, is_outside, [first - radius, first + radius]);
                }
            }
            Outline::Walls(corners) if is_near(corners.as_flattened()) => {
                if self.eye == Eye::Above {
                    canvas.painter.rect_filled(self.rect, 4.0, out);
                    let corners = corners.map(|corner| self.at(corner)).to_vec();
                    canvas.painter.add(PathShape::convex_polygon(corners, within, canvas.edge()));
                } else {
                    self.walls(canvas, way, is_outside, span(&corners, self.eye));
                }
            }
            Outline::Face { point, normal } if is_near(&point) => {
                let plane = way.plane();
                self.face(canvas, self.eye.see(plane.within(point)), self.eye.see(plane.within(normal)));
            }
            _ => {}
        }
    }

    /// A hole, shaft or walls from the side, as far up as they certainly reach: a ball's radius above the contacts.
    fn walls(&self, canvas: &Canvas<'_>, way: &Way<'_>, is_outside: bool, [left, right]: [f64; 2]) {
        let contacts = way.moves.iter().filter(|one| one.phase == Phase::Contact);
        let heights = contacts.map(|one| self.eye.see(way.plane().within(one.to))).map(|[_, height]| height);
        let Some(top) = heights.reduce(f64::max) else { return };
        let y = self.at([0.0, top + way.ball_radius]).y.min(self.rect.bottom());
        let [left, right] = [left, right].map(|x| self.at([x, top]).x);
        let block = |from: f32, to: f32| {
            let rect = Rect::from_min_max(pos2(from, y), pos2(to, self.rect.bottom() + 4.0));
            if rect.is_positive() {
                canvas.cut(rect);
            }
        };
        if is_outside {
            block(left, right);
        } else {
            block(self.rect.left() - 4.0, left);
            block(right, self.rect.right() + 4.0);
        }
    }

    /// A face as a line with its material behind it; seen from in front, the whole view is its material.
    fn face(&self, canvas: &Canvas<'_>, point: [f64; 2], [normal_x, normal_y]: [f64; 2]) {
        let largest = normal_x.abs().max(normal_y.abs());
        if largest.is_nan() || largest < 1e-9 {
            canvas.painter.rect_filled(self.rect, 4.0, canvas.palette.none.0);
            canvas.cross(self.at(point), 6.0, canvas.thin());
            return;
        }
        let out = vec2(screen(normal_x / largest), -screen(normal_y / largest)).normalized();
        let along = vec2(-out.y, out.x);
        let reach = self.rect.size().length();
        let point = self.at(point);
        canvas.line(point - along * reach, point + along * reach, canvas.edge());
        // Short strokes into the material, along a line across the whole view.
        let mut off = -reach;
        while off < reach {
            let from = point + along * off;
            canvas.line(from, from - out * 7.0 + along * 7.0, Stroke::new(1.0, canvas.palette.quiet.0));
            off += 9.0;
        }
        canvas.cross(point, 4.0, canvas.thin());
    }

    fn go(&self, canvas: &Canvas<'_>, one: &Move, plane: Plane, is_done: bool) {
        let points: Vec<Pos2> = trace(one, plane).into_iter().map(|place| self.at(self.eye.see(place))).collect();
        let (Some(from), Some(to)) = (points.first().copied(), points.last().copied()) else { return };
        if one.phase == Phase::Contact || (to - from).length() < 1.5 {
            return;
        }
        stroke(canvas, &points, one.phase, is_done);
    }

    /// Every contact as a mark on the surface with its number beyond it; several at one place share a mark.
    fn contacts(&self, canvas: &Canvas<'_>, way: &Way<'_>) {
        let mut marks: Vec<(Pos2, Vec2, String, bool)> = Vec::new();
        // From the ball's centre to where it touches, on screen.
        let mut towards = Vec2::ZERO;
        for (number, one) in way.moves.iter().enumerate() {
            let seen = |place| self.at(self.eye.see(way.plane().within(place)));
            if one.phase == Phase::Approach {
                let ([from_x, from_y, from_z], [to_x, to_y, to_z]) = (one.from, one.to);
                let off = [to_x - from_x, to_y - from_y, to_z - from_z];
                let length = off.iter().map(|part| part * part).sum::<f64>().sqrt();
                let unit = off.map(|part| if 0.0 < length { part / length } else { 0.0 });
                let [x, y] = self.eye.see(way.plane().within(unit));
                towards = vec2(screen(x), -screen(y));
            }
            let (Phase::Contact, Some(touch)) = (one.phase, one.touch) else { continue };
            let at = seen(one.to) + towards * self.length(way.ball_radius);
            let is_done = number < way.step;
            match marks.iter_mut().find(|(place, ..)| (*place - at).length() < 4.0) {
                Some((_, _, text, done)) => {
                    *text = format!("{text}, {touch}");
                    *done |= is_done;
                }
                None => marks.push((at, towards, touch.to_string(), is_done)),
            }
        }
        for (at, towards, text, is_done) in marks {
            if is_done {
                canvas.contact(at, canvas.palette.data.0);
            } else {
                canvas.circle(at, 4.0, canvas.palette.surface.0, canvas.thin());
            }
            let beyond = if towards.length() < 0.01 { vec2(14.0, -12.0) } else { towards.normalized() * 15.0 };
            canvas.note(at + beyond, Align2::CENTER_CENTER, &text);
        }
    }

    /// The axes' names, and a length to compare with.
    fn names(&self, canvas: &Canvas<'_>, way: &Way<'_>, words: &Words) {
        let inner = self.rect.shrink(space(2.0));
        let id = if self.eye == Eye::Above { "cycle-picture-from-above" } else { "cycle-picture-from-side" };
        let [first, second] = self.eye.names(way.plane());
        let title = words.say(&Message::new(id).text("first", first).text("second", second));
        let width = |text: &str| {
            let font = crate::gui::theme::font(sizes().small);
            canvas.painter.layout_no_wrap(text.to_owned(), font, canvas.palette.quiet.0).size().x
        };
        // In a narrow view the axes alone say from where it is seen, beside the number of a contact in the middle.
        let has_room = width(&title) < inner.width() / 2.0 - space(4.0);
        let title = if has_room { title } else { format!("{first}/{second}") };
        canvas.note(inner.left_top(), Align2::LEFT_TOP, &title);
        let mm = round_down(f64::from(self.rect.width()) * 0.25 / self.points_per_mm);
        let right = inner.right_bottom();
        let left = right - vec2(self.length(mm), 0.0);
        let text = format!("{} mm", words.number(&format!("{mm}")));
        // On a background of its own: material may be behind it.
        let wide = width(&text);
        let top = right - vec2(self.length(mm).max(wide), sizes().small + space(2.0));
        let ground = Rect::from_two_pos(top, right).expand(space(1.0));
        canvas.painter.rect_filled(ground, 2.0, canvas.palette.surface.0);
        canvas.line(left, right, canvas.edge());
        for end in [left, right] {
            canvas.line(end - vec2(0.0, 3.0), end + vec2(0.0, 3.0), canvas.edge());
        }
        let middle = f32::midpoint(left.x, right.x).min(right.x - wide / 2.0);
        canvas.note(pos2(middle, right.y - 4.0), Align2::CENTER_BOTTOM, &text);
    }
}

/// How far the path reaches in the direction in which it reaches farthest, mm.
fn extent_of(way: &Way<'_>) -> f64 {
    let reach = |eye: Eye, axis: fn(&[f64; 2]) -> f64| {
        let (least, most) = ends(&way.places(eye), axis);
        most - least
    };
    let first = reach(Eye::Above, |[x, _]| *x);
    first.max(reach(Eye::Above, |[_, y]| *y)).max(reach(Eye::Side, |[_, y]| *y))
}

/// Whether a place can be drawn at all.
fn is_near(place: &[f64]) -> bool {
    place.iter().all(|part| part.abs() < FARTHEST_MM)
}

/// How far the corners reach, seen from the side.
fn span(corners: &[[f64; 2]; 4], eye: Eye) -> [f64; 2] {
    let places = corners.map(|[first, second]| if eye == Eye::Front { second } else { first });
    places
        .into_iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], place| [least.min(place), most.max(place)])
}

/// How the phases differ, even without colour: dashes, a full line with an arrow, dots beside it, long dashes.
fn stroke(canvas: &Canvas<'_>, points: &[Pos2], phase: Phase, is_done: bool) {
    let palette = canvas.palette;
    let colour = |done| if is_done { done } else { palette.line.0 };
    let (Some(before), Some(last)) = (points.iter().rev().nth(1), points.last()) else { return };
    match phase {
        Phase::PrePosition => canvas.dashed(points, Stroke::new(1.5, colour(palette.text.0)), 6.0, 4.0),
        Phase::Approach => {
            let stroke = Stroke::new(2.5, colour(palette.data.0));
            canvas.polyline(points.to_vec(), stroke);
            if 12.0 < (*last - *before).length() {
                canvas.head(*last, *last - *before, stroke.color);
            }
        }
        Phase::Retract => {
            // The ball goes back along its approach: drawn beside it.
            let along = (*last - *before).normalized();
            let beside = vec2(-along.y, along.x) * 5.0;
            let points: Vec<Pos2> = points.iter().map(|point| *point + beside).collect();
            canvas.dashed(&points, Stroke::new(2.0, colour(palette.text.0)), 2.0, 4.0);
        }
        Phase::Leave => canvas.dashed(points, Stroke::new(1.5, colour(palette.text.0)), 12.0, 5.0),
        Phase::Contact => {}
    }
}

/// The phases that have a line of their own.
const LINES: [Phase; 4] = [Phase::PrePosition, Phase::Approach, Phase::Retract, Phase::Leave];

/// A sample of each line with its word: in one row, in two where the view is narrow. Returns the height that they take at
/// the bottom of a place.
pub(super) fn legend(canvas: &Canvas<'_>, place: Rect, words: &Words) -> f32 {
    let font = || crate::gui::theme::font(sizes().small);
    let galley = |phase| canvas.painter.layout_no_wrap(words.get(phase_id(phase)), font(), canvas.palette.quiet.0);
    let names = LINES.map(galley);
    let widest = names.iter().map(|name| name.size().x).fold(0.0, f32::max);
    let all = names.iter().map(|name| name.size().x).sum::<f32>();
    // Shorter samples where the view is narrow.
    let row = |[sample, gap]: [f32; 2]| all + 4.0 * space(sample + 1.0) + 3.0 * space(gap);
    let sizes_of_row = [[8.0, 5.0], [4.5, 2.0]];
    let in_one_row = sizes_of_row.into_iter().find(|sizes| row(*sizes) < place.width() - space(1.0));
    let [sample, gap] = in_one_row.unwrap_or([4.5, 2.0]);
    let columns = if in_one_row.is_some() { LINES.len() } else { 2 };
    let line = sizes().small + space(2.0);
    let rows = LINES.len().div_ceil(columns);
    let height = crate::gui::shapes::times(line, rows);
    let mut y = place.bottom() - height + line / 2.0;
    let mut x = place.left() + space(1.0);
    for (number, (phase, name)) in LINES.into_iter().zip(names).enumerate() {
        if 0 < number && number % columns == 0 {
            x = place.left() + space(1.0);
            y += line;
        }
        let from = pos2(x, y);
        let to = pos2(x + space(sample), y);
        stroke(canvas, &[from, to], phase, true);
        let wide = if in_one_row.is_some() { name.size().x } else { widest };
        let at = Align2::LEFT_CENTER.anchor_size(pos2(to.x + space(1.0), y), name.size());
        canvas.painter.galley(at.min, name, canvas.palette.quiet.0);
        x = at.left() + wide + space(gap);
    }
    height
}
