//! The way of the ball's centre, from above and from the side: what is done, what is to come, where the ball is.

use std::f64::consts::{PI, TAU};

use eframe::egui::accesskit::Role;
use eframe::egui::{Align2, Pos2, Rect, Sense, Stroke, Ui, Vec2, WidgetInfo, pos2, vec2};

use super::canvas::{Canvas, screen};
use super::criteria::plain;
use crate::gui::theme::{palette, sizes, space};
use crate::gui::view::View;
use crate::probing::cycle::{Move, Nominal, Phase, Plane};
use crate::tolerance::Feature;
use crate::words::{Message, Words};

/// Points on an arc of the way.
const STEPS: u8 = 48;

/// The share of the room that is left around a view.
const MARGIN: f64 = 0.08;

/// The least that is shown, mm, where the way has no extent.
const LEAST_MM: f64 = 1e-3;

/// The way of the probe after so many moves (`step`, from 0 to their number), with the surface that the cycle expects and
/// the ball to scale (`ball_radius`, mm; 0 where contacts are points of the surface).
pub(in crate::gui) fn path_picture(
    ui: &mut Ui,
    view: &View<'_>,
    path: &[Move],
    step: usize,
    nominal: Option<Nominal>,
    ball_radius: f64,
) {
    let moves: Vec<Move> = path.iter().copied().filter(is_finite).collect();
    // Moves that cannot be drawn are none; the step counts those that can.
    let step = path.iter().take(step).filter(|one| is_finite(one)).count();
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height(ui)), Sense::hover());
    if ui.is_rect_visible(rect) {
        let canvas = Canvas::new(ui.painter(), palette(ui.ctx()), rect);
        let way = Way { moves: &moves, step, nominal, ball_radius: ball_radius.abs().min(1e6) };
        draw(&canvas, &way, view.words);
    }
    let said = describe(view.words, &moves, step);
    response.widget_info(|| WidgetInfo::labeled(Role::Figure, true, &said));
}

/// As high as there is room, in a list that scrolls three quarters of the width.
pub(super) fn height(ui: &Ui) -> f32 {
    let most = (ui.available_width() * 0.75).max(space(40.0));
    ui.available_height().clamp(space(40.0), most)
}

fn is_finite(one: &Move) -> bool {
    let about = one.about.unwrap_or_default();
    one.from.iter().chain(&one.to).chain(&about).all(|value| value.abs() < 1e9)
}

/// The name of a phase's word.
const fn phase_id(phase: Phase) -> &'static str {
    match phase {
        Phase::PrePosition => "cycle-picture-phase-pre-position",
        Phase::Approach => "cycle-picture-phase-approach",
        Phase::Contact => "cycle-picture-phase-contact",
        Phase::Retract => "cycle-picture-phase-retract",
        Phase::Leave => "cycle-picture-phase-leave",
    }
}

fn describe(words: &Words, moves: &[Move], step: usize) -> String {
    let Some(at) = place(moves, step) else { return words.get("cycle-picture-no-path") };
    let [x, y, z] = at.map(|value| words.number(&plain(value, 3)));
    let contacts = moves.iter().filter(|one| one.phase == Phase::Contact).count();
    let message = Message::new("cycle-picture-path").text("step", step).text("moves", moves.len());
    let said = words.say(&message.count("contacts", contacts).text("x", x).text("y", y).text("z", z));
    let Some(now) = step.checked_sub(1).and_then(|last| moves.get(last)) else { return said };
    let phase = words.get(phase_id(now.phase));
    match now.touch {
        Some(touch) => {
            let now = Message::new("cycle-picture-path-touch").text("phase", phase).text("touch", touch);
            format!("{said} {}", words.say(&now))
        }
        None => format!("{said} {phase}"),
    }
}

/// Where the ball is after so many moves.
fn place(moves: &[Move], step: usize) -> Option<[f64; 3]> {
    match step.checked_sub(1).and_then(|last| moves.get(last)) {
        Some(last) => Some(last.to),
        None => moves.first().map(|first| first.from),
    }
}

struct Way<'a> {
    moves: &'a [Move],
    step: usize,
    nominal: Option<Nominal>,
    ball_radius: f64,
}

impl Way<'_> {
    fn plane(&self) -> Plane {
        match self.nominal {
            Some(Nominal::Circle { plane, .. }) => plane,
            _ => Plane::Xy,
        }
    }

    /// Places of the way, in the coordinates of a view.
    fn places(&self, eye: Eye) -> Vec<[f64; 2]> {
        self.moves.iter().flat_map(|one| trace(one, self.plane())).map(|place| eye.see(place)).collect()
    }
}

/// The places of a move in plane coordinates: two ends, or the points of an arc the shorter way round.
fn trace(one: &Move, plane: Plane) -> Vec<[f64; 3]> {
    let (from, to) = (plane.within(one.from), plane.within(one.to));
    let Some(about) = one.about.map(|about| plane.within(about)) else { return vec![from, to] };
    let about_centre = |[x, y, _]: [f64; 3]| {
        let [centre_x, centre_y, _] = about;
        (x - centre_x, y - centre_y)
    };
    let ((from_x, from_y), (to_x, to_y)) = (about_centre(from), about_centre(to));
    let (begin, end) = (from_y.atan2(from_x), to_y.atan2(to_x));
    let turn = (end - begin + PI).rem_euclid(TAU) - PI;
    let (first, last) = (from_x.hypot(from_y), to_x.hypot(to_y));
    let ([_, _, low], [_, _, high]) = (from, to);
    (0..=STEPS)
        .map(|step| {
            let share = f64::from(step) / f64::from(STEPS);
            let (sin, cos) = (begin + turn * share).sin_cos();
            let radius = first + (last - first) * share;
            let [centre_x, centre_y, _] = about;
            [centre_x + radius * cos, centre_y + radius * sin, low + (high - low) * share]
        })
        .collect()
}

/// From where the way is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Eye {
    /// Onto the plane.
    Above,
    /// Along the second axis.
    Side,
    /// Along the first axis.
    Front,
}

impl Eye {
    const fn see(self, [first, second, height]: [f64; 3]) -> [f64; 2] {
        match self {
            Self::Above => [first, second],
            Self::Side => [first, height],
            Self::Front => [second, height],
        }
    }

    /// The side from which a face is seen as a line, where there is one.
    fn beside(nominal: Option<Nominal>) -> Self {
        match nominal {
            Some(Nominal::Face { normal: [x, y, _], .. }) if x.abs() < y.abs() => Self::Front,
            _ => Self::Side,
        }
    }

    const fn names(self, plane: Plane) -> [&'static str; 2] {
        let [first, second] = plane.axes();
        let third = match plane {
            Plane::Xy => "Z",
            Plane::Zx => "Y",
            Plane::Yz => "X",
        };
        match self {
            Self::Above => [first, second],
            Self::Side => [first, third],
            Self::Front => [second, third],
        }
    }
}

fn draw(canvas: &Canvas<'_>, way: &Way<'_>, words: &Words) {
    let line = sizes().small + space(2.0);
    let body = Rect::from_min_max(canvas.rect.min, canvas.rect.max - vec2(0.0, line));
    legend(canvas, Rect::from_min_max(pos2(body.left(), body.bottom()), canvas.rect.max), words);
    if way.moves.is_empty() {
        canvas.note(body.center(), Align2::CENTER_CENTER, &words.get("cycle-picture-no-path"));
        return;
    }
    let gap = space(2.0);
    let (above, side) = if body.height() * 1.15 < body.width() {
        let (left, right) = body.split_left_right_at_fraction(0.58);
        (left.with_max_x(left.right() - gap), right.with_min_x(right.left() + gap))
    } else {
        let (top, bottom) = body.split_top_bottom_at_fraction(0.6);
        (top.with_max_y(top.bottom() - gap), bottom.with_min_y(bottom.top() + gap))
    };
    let beside = Eye::beside(way.nominal);
    for (eye, rect) in [(Eye::Above, above), (beside, side)] {
        Scale::of(way, eye, rect).view(canvas, way, words);
    }
}

/// The same scale on both axes of a view.
struct Scale {
    eye: Eye,
    rect: Rect,
    /// What is in the middle, mm.
    middle: [f64; 2],
    points_per_mm: f64,
}

impl Scale {
    fn of(way: &Way<'_>, eye: Eye, rect: Rect) -> Self {
        let mut places = way.places(eye);
        let ball = way.ball_radius;
        let mut around = ball;
        match way.nominal {
            Some(Nominal::Circle { centre: [first, second], diameter, .. }) if diameter < 1e9 => {
                let radius = diameter / 2.0;
                // From the side only as far as it is wide.
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
            Some(Nominal::Face { point, .. }) if point.iter().all(|value| value.abs() < 1e9) => {
                places.push(eye.see(way.plane().within(point)));
            }
            _ => {}
        }
        let fold = |axis: fn(&[f64; 2]) -> f64| {
            let (least, most) = places
                .iter()
                .map(axis)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)));
            (f64::midpoint(least, most), most - least)
        };
        let ((x, wide), (y, high)) = (fold(|[x, _]| *x), fold(|[_, y]| *y));
        // A ball that moves little still has some room around it.
        let size = |extent: f64| ((extent + 2.0 * around) * (1.0 + 2.0 * MARGIN)).max(6.0 * ball).max(LEAST_MM);
        let room = rect.shrink(space(2.0));
        let [width, height] = [room.width(), room.height()].map(|side| f64::from(side.max(1.0)));
        Self { eye, rect, middle: [x, y], points_per_mm: (width / size(wide)).min(height / size(high)) }
    }

    fn at(&self, [x, y]: [f64; 2]) -> Pos2 {
        let [middle_x, middle_y] = self.middle;
        let scaled = |off: f64| screen((off * self.points_per_mm).clamp(-1e5, 1e5));
        self.rect.center() + vec2(scaled(x - middle_x), -scaled(y - middle_y))
    }

    fn length(&self, mm: f64) -> f32 {
        screen((mm * self.points_per_mm).clamp(0.0, 1e5))
    }

    fn view(&self, canvas: &Canvas<'_>, way: &Way<'_>, words: &Words) {
        let canvas = Canvas::new(&canvas.painter, canvas.palette, self.rect);
        let frame = Stroke::new(1.0, canvas.palette.line.0);
        canvas.painter.rect_filled(self.rect, 4.0, canvas.palette.panel.0);
        self.nominal(&canvas, way);
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
        match way.nominal {
            Some(Nominal::Circle { feature, centre: [first, second], diameter, .. }) if diameter < 1e9 => {
                let radius = diameter / 2.0;
                if self.eye == Eye::Above {
                    let (centre, radius) = (self.at([first, second]), self.length(radius));
                    let (out, within) = match feature {
                        Feature::Hole => (canvas.palette.none.0, canvas.palette.panel.0),
                        Feature::Shaft => (canvas.palette.panel.0, canvas.palette.none.0),
                    };
                    canvas.painter.rect_filled(self.rect, 4.0, out);
                    canvas.circle(centre, radius, within, canvas.edge());
                    canvas.cross(centre, 5.0, canvas.thin());
                } else {
                    self.walls(canvas, way, feature, [first - radius, first + radius]);
                }
            }
            Some(Nominal::Face { point, normal }) if point.iter().all(|value| value.abs() < 1e9) => {
                let plane = way.plane();
                self.face(canvas, self.eye.see(plane.within(point)), self.eye.see(plane.within(normal)));
            }
            _ => {}
        }
    }

    /// A hole or stud from the side, as far up as it is certain to reach: a ball's radius above the contacts.
    fn walls(&self, canvas: &Canvas<'_>, way: &Way<'_>, feature: Feature, [left, right]: [f64; 2]) {
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
        match feature {
            Feature::Hole => {
                block(self.rect.left() - 4.0, left);
                block(right, self.rect.right() + 4.0);
            }
            Feature::Shaft => block(left, right),
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
        // Short strokes into the material, as long as a line of them crosses the view.
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

    /// Every contact as a mark on the surface with its number beyond it; several at one place share their mark.
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
                canvas.contact(at, canvas.palette.accent.0);
            } else {
                canvas.circle(at, 4.0, canvas.palette.panel.0, canvas.thin());
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
        let title = Message::new(id).text("first", first).text("second", second);
        canvas.note(inner.left_top(), Align2::LEFT_TOP, &words.say(&title));
        let mm = round_below(f64::from(self.rect.width()) * 0.25 / self.points_per_mm);
        let right = inner.right_bottom();
        let left = right - vec2(self.length(mm), 0.0);
        let text = format!("{} mm", words.number(&format!("{mm}")));
        // On a ground of its own: material may be behind it.
        let top = right - vec2(self.length(mm).max(space(11.0)), sizes().small + space(2.0));
        let ground = Rect::from_two_pos(top, right).expand(space(1.0));
        canvas.painter.rect_filled(ground, 2.0, canvas.palette.panel.0);
        canvas.line(left, right, canvas.edge());
        for end in [left, right] {
            canvas.line(end - vec2(0.0, 3.0), end + vec2(0.0, 3.0), canvas.edge());
        }
        canvas.note(left + (right - left) / 2.0 - vec2(0.0, 4.0), Align2::CENTER_BOTTOM, &text);
    }
}

/// How the phases differ, also without colour: dashes, a full line with an arrow, dots beside it, long dashes.
fn stroke(canvas: &Canvas<'_>, points: &[Pos2], phase: Phase, is_done: bool) {
    let palette = canvas.palette;
    let colour = |done| if is_done { done } else { palette.line.0 };
    let (Some(before), Some(last)) = (points.iter().rev().nth(1), points.last()) else { return };
    match phase {
        Phase::PrePosition => canvas.dashed(points, Stroke::new(1.5, colour(palette.text.0)), 6.0, 4.0),
        Phase::Approach => {
            let stroke = Stroke::new(2.5, colour(palette.accent.0));
            canvas.polyline(points.to_vec(), stroke);
            if 12.0 < (*last - *before).length() {
                canvas.head(*last, *last - *before, stroke.color);
            }
        }
        Phase::Retract => {
            // It goes back where the approach came: drawn beside it.
            let along = (*last - *before).normalized();
            let beside = vec2(-along.y, along.x) * 5.0;
            let points: Vec<Pos2> = points.iter().map(|point| *point + beside).collect();
            canvas.dashed(&points, Stroke::new(2.0, colour(palette.text.0)), 2.0, 4.0);
        }
        Phase::Leave => canvas.dashed(points, Stroke::new(1.5, colour(palette.text.0)), 12.0, 5.0),
        Phase::Contact => {}
    }
}

/// A sample of each line with its word.
fn legend(canvas: &Canvas<'_>, rect: Rect, words: &Words) {
    let mut x = rect.left() + space(1.0);
    for phase in [Phase::PrePosition, Phase::Approach, Phase::Retract, Phase::Leave] {
        let (from, to) = (pos2(x, rect.center().y), pos2(x + space(8.0), rect.center().y));
        stroke(canvas, &[from, to], phase, true);
        let text = words.get(phase_id(phase));
        let font = crate::gui::theme::font(sizes().small);
        let placed =
            canvas.label(pos2(to.x + space(1.5), to.y), Align2::LEFT_CENTER, &text, font, canvas.palette.quiet.0);
        x = placed.right() + space(5.0);
    }
}

/// The largest of 1, 2 or 5 times a power of ten that is not above a length.
fn round_below(mm: f64) -> f64 {
    let decade = 10_f64.powf(mm.log10().floor());
    [5.0, 2.0].into_iter().map(|step| step * decade).find(|step| *step <= mm).unwrap_or(decade)
}
