//! Parameters that are one of a few numbers: a small picture for each number, the number below it.

use eframe::egui::epaint::PathShape;
use eframe::egui::{Align2, Color32, Pos2, Rect, Stroke, StrokeKind, Vec2, pos2, vec2};

use super::canvas::{Canvas, polar};
use super::scene::Scene;
use crate::probing::cycle::Meaning;

/// Of more numbers than this, only the first are drawn.
const MOST: usize = 5;

const BALL: f32 = 7.0;

pub(super) fn draw(canvas: &Canvas<'_>, scene: Scene, (meaning, numbers): (Meaning, &[i64]), key: &str) {
    canvas.key(canvas.rect.center_top(), Align2::CENTER_TOP, key);
    let left_out = MOST < numbers.len();
    let mut x = 0.0;
    let panels = numbers.iter().take(MOST);
    // At most five.
    let count = panels.clone().fold(0.0, |count, _| count + 1.0_f32);
    let width = (canvas.rect.width() - 8.0 * (count - 1.0).max(0.0)) / count.max(1.0);
    for number in panels {
        let panel = Rect::from_min_size(canvas.at(x, 24.0), vec2(width, 108.0));
        x += width + 8.0;
        canvas.painter.rect_stroke(panel, 4.0, Stroke::new(1.0, canvas.palette.line.0), StrokeKind::Inside);
        let choice = Choice { canvas, scene, panel, middle: panel.center() };
        choice.draw(meaning, *number);
        let name = match (meaning, *number) {
            (Meaning::Tool, 1) => "1 …".to_owned(),
            (Meaning::Direction, 1) => "+1".to_owned(),
            (_, number) => number.to_string().replace('-', "−"),
        };
        canvas.key(panel.center_bottom() + vec2(0.0, 4.0), Align2::CENTER_TOP, &name);
    }
    if left_out {
        canvas.note(canvas.rect.right_top(), Align2::RIGHT_TOP, "…");
    }
}

struct Choice<'a> {
    canvas: &'a Canvas<'a>,
    scene: Scene,
    panel: Rect,
    middle: Pos2,
}

impl Choice<'_> {
    fn draw(&self, meaning: Meaning, number: i64) {
        match meaning {
            Meaning::MoveToClearance => self.move_to_clearance(number == 1),
            Meaning::Traverse => self.traverse(number == 1),
            Meaning::ClearanceMode => self.move_to_clearance(number == 2),
            Meaning::ContactCount => self.contacts(number),
            Meaning::Plane => self.plane(number),
            Meaning::InsideOutside => self.side(number == 1),
            Meaning::Geometries => self.side(matches!(number, 1 | 2)),
            Meaning::MeasuredAxis | Meaning::AxisOfPlane | Meaning::DirectedAxis => self.measured_axis(number),
            Meaning::Direction => self.direction(number < 0),
            Meaning::Log => self.log(number),
            Meaning::ToolAxisProbing => _ = self.tripod((number == 1).then_some(2)),
            // A table is a page.
            Meaning::Transfer => self.log(i64::from(0 <= number)),
            // A rotary axis turns about the axis of the same place: A about X.
            Meaning::CompensationAxis => _ = self.tripod(usize::try_from(number - 4).ok()),
            Meaning::ZeroAfterAlignment | Meaning::RotaryAlignment => _ = self.tripod((0 < number).then_some(2)),
            Meaning::RotationTransfer => _ = self.tripod(usize::try_from(number - 1).ok()),
            Meaning::PresetCorrection => _ = self.tripod((0 < number).then_some(0)),
            Meaning::Stop | Meaning::StopOnScrap => self.go_or_stop(self.middle, 18.0, 0 < number),
            Meaning::StopOnUndersize => self.stop_on(number),
            Meaning::Tool => self.tool(number),
            _ => {}
        }
    }

    /// Between two contacts at measuring height, or over the clearance height.
    fn move_to_clearance(&self, is_over: bool) {
        let panel = self.panel.shrink(8.0);
        let top = panel.top() + 44.0;
        let left = panel.left() + 20.0;
        let right = panel.right() - 20.0;
        let (from, to) = if self.scene.shape.is_outside() {
            self.canvas.cut(Rect::from_min_max(pos2(left + 18.0, top), pos2(right - 18.0, panel.bottom())));
            (pos2(left, top + 24.0), pos2(right, top + 24.0))
        } else {
            self.canvas.cut(Rect::from_min_max(pos2(panel.left(), top), pos2(left, panel.bottom())));
            self.canvas.cut(Rect::from_min_max(pos2(right, top), panel.max));
            (pos2(left + BALL + 1.0, top + 24.0), pos2(right - BALL - 1.0, top + 24.0))
        };
        let high = panel.top() + 12.0;
        self.canvas.ghost(from, BALL);
        self.canvas.ghost(to, BALL);
        if is_over {
            let way = vec![from, pos2(from.x, high), pos2(to.x, high), to];
            self.canvas.polyline(way, self.canvas.strong());
        } else if self.scene.shape.is_outside() {
            // Around the shaft: seen from the side, behind it.
            self.canvas.dashed(&[from, to], self.canvas.strong(), 4.0, 4.0);
        } else {
            self.canvas.line(from, to, self.canvas.strong());
        }
        let along = if is_over { Vec2::Y } else { Vec2::X };
        self.canvas.head(to, along, self.canvas.palette.data.0);
    }

    fn circle(&self, radius: f32, is_stud: bool) {
        let palette = self.canvas.palette;
        if is_stud {
            self.canvas.circle(self.middle, radius, palette.none.0, self.canvas.edge());
        } else {
            self.canvas.painter.rect_filled(self.panel.shrink(6.0), 3.0, palette.none.0);
            self.canvas.circle(self.middle, radius, palette.surface.0, self.canvas.edge());
        }
    }

    fn traverse(&self, is_arc: bool) {
        let is_stud = self.scene.shape.is_outside();
        let radius = if is_stud { 20.0 } else { 40.0 };
        self.circle(radius, is_stud);
        let reach = if is_stud { radius + 14.0 } else { radius - 14.0 };
        let from = polar(self.middle, reach, 0.0);
        let to = polar(self.middle, reach, 90.0);
        self.canvas.ball(from, BALL);
        self.canvas.ghost(to, BALL);
        if is_arc {
            self.canvas.arc_arrow(self.middle, reach, [12.0, 80.0], self.canvas.strong());
        } else {
            self.canvas.arrow(from + (to - from) * 0.2, to - (to - from) * 0.1, self.canvas.strong());
        }
    }

    fn contacts(&self, count: i64) {
        let step = 360.0 / f32::from(u8::try_from(count).unwrap_or(4).max(1));
        let is_stud = self.scene.shape.is_outside();
        let radius = if is_stud { 30.0 } else { 38.0 };
        self.circle(radius, is_stud);
        self.canvas.cross(self.middle, 4.0, self.canvas.thin());
        let mut degrees = 90.0;
        while degrees < 449.0 {
            self.canvas.contact(polar(self.middle, radius, degrees), self.canvas.palette.data.0);
            degrees += step;
        }
    }

    fn side(&self, is_outside: bool) {
        let radius = if is_outside { 24.0 } else { 38.0 };
        self.circle(radius, is_outside);
        let (ball, from) = if is_outside { (radius + BALL, radius + 34.0) } else { (radius - BALL, 4.0) };
        let ball = polar(self.middle, ball, 20.0);
        let from = polar(self.middle, from, 20.0);
        self.canvas.ball(ball, BALL);
        self.canvas.contact(polar(self.middle, radius, 20.0), self.canvas.palette.data.0);
        self.canvas.arrow(from, ball - (ball - from).normalized() * BALL, self.canvas.strong());
    }

    /// Three axes in space: first to the right, second into the drawing, third upwards.
    fn tripod(&self, active: Option<usize>) -> (Pos2, [Vec2; 3]) {
        let origin = self.middle + vec2(-20.0, 28.0);
        let axes = [vec2(46.0, 0.0), vec2(24.0, -20.0), vec2(0.0, -58.0)];
        for (number, (axis, name)) in axes.into_iter().zip(["X", "Y", "Z"]).enumerate() {
            let stroke = if active == Some(number) { self.canvas.strong() } else { self.canvas.thin() };
            self.canvas.arrow(origin, origin + axis, stroke);
            let place = origin + axis + axis.normalized() * 8.0;
            self.canvas.note(place, Align2::CENTER_CENTER, name);
        }
        (origin, axes)
    }

    fn plane(&self, number: i64) {
        let (origin, [x, y, z]) = self.tripod(None);
        let (first, second) = match number {
            1 => (z, x),
            2 => (y, z),
            _ => (x, y),
        };
        let first = first * 0.72;
        let second = second * 0.72;
        let patch = vec![origin, origin + first, origin + first + second, origin + second];
        let fill = self.canvas.palette.tint.0;
        self.canvas.painter.add(PathShape::convex_polygon(patch, fill, self.canvas.strong()));
    }

    /// Onto the face across an axis, along it or against it.
    fn measured_axis(&self, number: i64) {
        let active = usize::try_from(number.abs() - 1).ok();
        let (origin, axes) = self.tripod(active);
        let Some(axis) = active.and_then(|active| axes.get(active)) else { return };
        let (at, along) = if number < 0 { (origin, -*axis) } else { (origin + *axis, *axis) };
        self.canvas.head(at, along, self.canvas.palette.data.0);
    }

    fn direction(&self, is_negative: bool) {
        let sign = if is_negative { -1.0 } else { 1.0 };
        let middle = self.middle - vec2(0.0, 8.0);
        let wall = middle.x + 14.0 * sign;
        let end = middle.x + 42.0 * sign;
        self.canvas.cut(Rect::from_two_pos(pos2(wall, middle.y - 26.0), pos2(end, middle.y + 26.0)));
        let ball = pos2(middle.x - 36.0 * sign, middle.y);
        self.canvas.ball(ball, BALL);
        self.canvas.arrow(ball + vec2(BALL * sign, 0.0), pos2(wall, middle.y), self.canvas.strong());
        let below = self.panel.bottom() - 14.0;
        self.canvas.arrow(pos2(middle.x - 40.0, below), pos2(middle.x + 40.0, below), self.canvas.thin());
        self.canvas.note(pos2(middle.x + 44.0, below), Align2::LEFT_CENTER, "+");
    }

    fn log(&self, number: i64) {
        let page = Rect::from_center_size(self.middle, vec2(38.0, 50.0));
        let lines = |rect: Rect, stroke: Stroke| {
            let mut y = rect.top() + 12.0;
            while y < rect.bottom() - 6.0 {
                self.canvas.line(pos2(rect.left() + 7.0, y), pos2(rect.right() - 7.0, y), stroke);
                y += 8.0;
            }
        };
        match number {
            1 => {
                self.canvas.painter.rect(
                    page,
                    2.0,
                    self.canvas.palette.surface.0,
                    self.canvas.edge(),
                    StrokeKind::Middle,
                );
                lines(page, self.canvas.strong());
            }
            2 => {
                let display = Rect::from_center_size(self.middle - vec2(0.0, 4.0), vec2(62.0, 44.0));
                let fill = self.canvas.palette.surface.0;
                self.canvas.painter.rect(display, 3.0, fill, self.canvas.edge(), StrokeKind::Middle);
                lines(display, self.canvas.strong());
                let foot = display.center_bottom();
                self.canvas.line(foot, foot + vec2(0.0, 8.0), self.canvas.edge());
                self.canvas.line(foot + vec2(-14.0, 8.0), foot + vec2(14.0, 8.0), self.canvas.edge());
            }
            _ => self.nothing(),
        }
    }

    fn nothing(&self) {
        self.canvas.line(self.middle - vec2(12.0, 0.0), self.middle + vec2(12.0, 0.0), self.canvas.edge());
    }

    /// The program goes on, or stops.
    fn go_or_stop(&self, at: Pos2, size: f32, is_stop: bool) {
        let quiet = self.canvas.palette.quiet.0;
        let accent = self.canvas.palette.data.0;
        if is_stop {
            let square = Rect::from_center_size(at, Vec2::splat(size * 1.5));
            self.canvas.painter.rect_filled(square, 2.0, accent);
        } else {
            let points =
                vec![at + vec2(size, 0.0), at + vec2(-size * 0.7, size * 0.9), at + vec2(-size * 0.7, -size * 0.9)];
            self.canvas.painter.add(PathShape::convex_polygon(points, Color32::TRANSPARENT, Stroke::new(2.0, quiet)));
        }
    }

    /// Above the band and below it.
    fn stop_on(&self, number: i64) {
        let band = Rect::from_center_size(self.middle, vec2(self.panel.width() - 20.0, 22.0));
        self.canvas.painter.rect_filled(band, 0.0, self.canvas.palette.zone.0);
        let edge = Stroke::new(1.0, self.canvas.palette.zone_edge.0);
        self.canvas.line(band.left_top(), band.right_top(), edge);
        self.canvas.line(band.left_bottom(), band.right_bottom(), edge);
        let off = vec2(10.0, 31.0);
        self.go_or_stop(self.middle + vec2(off.x, -off.y), 9.0, number == 1);
        self.go_or_stop(self.middle + off, 9.0, 0 < number);
        self.canvas.note(self.middle - vec2(18.0, off.y), Align2::CENTER_CENTER, "+");
        self.canvas.note(self.middle + vec2(-18.0, off.y), Align2::CENTER_CENTER, "−");
    }

    fn tool(&self, number: i64) {
        if number == 0 {
            return self.nothing();
        }
        let top = self.middle - vec2(0.0, 38.0);
        let shank = Rect::from_min_size(top - vec2(9.0, 0.0), vec2(18.0, 30.0));
        let flutes = Rect::from_min_size(shank.left_bottom() - vec2(5.0, 0.0), vec2(28.0, 44.0));
        let fill = self.canvas.palette.none.0;
        for part in [shank, flutes] {
            self.canvas.painter.rect(part, 1.0, fill, self.canvas.edge(), StrokeKind::Middle);
        }
        for share in [0.45, 0.95] {
            let left = flutes.left_top() + vec2(0.0, flutes.height() * share);
            self.canvas.line(left, left + vec2(flutes.width(), -flutes.height() * 0.4), self.canvas.edge());
        }
    }
}
