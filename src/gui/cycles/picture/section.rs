//! Parameters that are seen from the side: heights, clearances, the band along the normal.

use eframe::egui::epaint::PathShape;
use eframe::egui::{Align2, Pos2, Rect, Stroke, Vec2, pos2, vec2};

use super::canvas::{BESIDE, Canvas, arc, polar};
use super::scene::Scene;
use crate::probing::cycle::{Axis, Meaning};
use crate::probing::simulated::Shape;

/// The top of a workpiece, where the datum is.
const DATUM: Pos2 = pos2(46.0, 78.0);
/// The height where the ball touches.
const MEASURING: f32 = 122.0;
/// The height where nothing is in the way.
const CLEARANCE: f32 = 28.0;
/// The drawing's lower edge.
const BOTTOM: f32 = 158.0;
/// Where the dimensions of heights are.
const ASIDE: f32 = 20.0;
const BALL: f32 = 9.0;
/// The clearance that the touch-probe table gives, and that together with the parameter's.
const SET_UP: f32 = 15.0;
const WITH_PARAMETER: f32 = 46.0;
/// The free surface: a large circle; its point, in degrees.
const SURFACE_DATUM: Pos2 = pos2(46.0, 128.0);
const SURFACE_CENTRE: Pos2 = pos2(120.0, 194.0);
const SURFACE_RADIUS: f32 = 130.0;
const SURFACE_POINT: f32 = 62.0;
/// Half the band around it.
const HALF_BAND: f32 = 15.0;

struct Section<'a> {
    canvas: &'a Canvas<'a>,
    scene: Scene,
    key: &'a str,
}

pub(super) fn draw(canvas: &Canvas<'_>, scene: Scene, meaning: Meaning, key: &str) {
    let section = Section { canvas, scene, key };
    match meaning {
        Meaning::Point(axis) | Meaning::NextPoint(axis) => section.point(axis),
        Meaning::SetUpClearance => section.set_up(),
        Meaning::ClearanceHeight => section.clearance_height(),
        Meaning::Difference => section.difference(),
        Meaning::Band => section.band(),
        Meaning::Retract => section.retract(),
        // From above, whatever else is measured.
        Meaning::ToolAxisPoint(axis) | Meaning::NewDatum(axis) => {
            Section { scene: Scene { shape: Shape::Point, ..scene }, ..section }.point(axis);
        }
        _ => section.measuring_height(),
    }
}

impl Section<'_> {
    fn at(&self, place: Pos2) -> Pos2 {
        self.canvas.rect.min + place.to_vec2()
    }

    /// Workpiece and axes; returns the datum, the point that is touched and the direction out of the material.
    fn workpiece(&self, across: &str) -> (Pos2, Pos2, Vec2) {
        let block = |left: f32, right: f32| {
            self.canvas.cut(Rect::from_min_max(self.at(pos2(left, DATUM.y)), self.at(pos2(right, BOTTOM))));
        };
        let (datum, point, normal) = match self.scene.shape {
            Shape::Point => return self.surface(across),
            Shape::Hole | Shape::Slot | Shape::Pocket => {
                block(64.0, 106.0);
                block(200.0, 246.0);
                (DATUM, pos2(200.0, MEASURING), -Vec2::X)
            }
            Shape::Stud | Shape::Ridge | Shape::Boss => {
                block(76.0, 168.0);
                (DATUM, pos2(168.0, MEASURING), Vec2::X)
            }
            Shape::Face => {
                block(64.0, 168.0);
                (DATUM, pos2(168.0, MEASURING), Vec2::X)
            }
        };
        let datum = self.at(datum);
        self.axis_up(datum);
        self.canvas.dashed(&[datum, pos2(self.canvas.rect.right(), datum.y)], self.canvas.thin(), 3.0, 4.0);
        (datum, self.at(point), normal)
    }

    fn axis_up(&self, datum: Pos2) {
        let top = self.at(pos2(DATUM.x, 4.0));
        self.canvas.arrow(datum, top, self.canvas.thin());
        let [.., third] = self.scene.axes;
        self.canvas.note(top + vec2(6.0, 0.0), Align2::LEFT_TOP, third);
        self.canvas.circle(datum, 3.5, self.canvas.palette.surface.0, self.canvas.edge());
    }

    fn surface(&self, across: &str) -> (Pos2, Pos2, Vec2) {
        let datum = self.at(SURFACE_DATUM);
        let centre = self.at(SURFACE_CENTRE);
        let mut outline = arc(centre, SURFACE_RADIUS, 31.0, 119.0);
        outline.push(pos2(outline.last().map_or(datum.x, |last| last.x), datum.y));
        outline.push(pos2(outline.first().map_or(datum.x, |first| first.x), datum.y));
        self.canvas.painter.add(PathShape::convex_polygon(outline, self.canvas.palette.none.0, Stroke::NONE));
        self.canvas.polyline(arc(centre, SURFACE_RADIUS, 31.0, 119.0), self.canvas.edge());
        let right = self.at(pos2(254.0, SURFACE_DATUM.y));
        self.canvas.arrow(datum, right, self.canvas.thin());
        self.canvas.note(right + vec2(0.0, 3.0), Align2::RIGHT_TOP, across);
        self.axis_up(datum);
        let normal = polar(Pos2::ZERO, 1.0, SURFACE_POINT).to_vec2();
        (datum, polar(centre, SURFACE_RADIUS, SURFACE_POINT), normal)
    }

    /// A height above the datum.
    fn height(&self, datum: Pos2, place: Pos2) {
        let x = self.at(pos2(ASIDE, 0.0)).x;
        for from in [datum, place] {
            self.canvas.line(from, pos2(x - 4.0, from.y), self.canvas.thin());
        }
        let from = pos2(x, datum.y);
        let to = pos2(x, place.y);
        self.canvas.dimension(from, to);
        self.canvas.key(from + (to - from) / 2.0, Align2::CENTER_CENTER, self.key);
    }

    fn point(&self, axis: Axis) {
        let (datum, point, normal) = self.workpiece(if axis == Axis::Second { "Y" } else { "X" });
        self.canvas.probe(point + normal * BALL, BALL);
        if axis == Axis::Third {
            self.height(datum, point);
        } else {
            let y = self.at(pos2(0.0, 147.0)).y;
            for from in [datum, point] {
                self.canvas.line(from, pos2(from.x, y + 4.0), self.canvas.thin());
            }
            self.canvas.dimension(pos2(datum.x, y), pos2(point.x, y));
            self.canvas.key(pos2(f32::midpoint(datum.x, point.x), y), Align2::CENTER_CENTER, self.key);
        }
        self.canvas.contact(point, self.canvas.palette.data.0);
    }

    fn measuring_height(&self) {
        let (datum, point, normal) = self.workpiece("X");
        let ball = point + normal * BALL;
        self.canvas.probe(ball, BALL);
        self.height(datum, ball);
        self.canvas.circle(ball, 3.0, self.canvas.palette.data.0, Stroke::NONE);
    }

    fn clearance_height(&self) {
        let (datum, point, normal) = self.workpiece("X");
        let below = point + normal * 3.0 * BALL;
        let ball = pos2(below.x, self.at(pos2(0.0, CLEARANCE)).y);
        if ball.y + 2.5 * BALL < below.y {
            self.canvas.ghost(below, BALL);
            self.canvas.dashed(&[ball, below - vec2(0.0, BALL)], self.canvas.thin(), 3.0, 3.0);
        }
        let line = [pos2(self.at(pos2(ASIDE, 0.0)).x, ball.y), pos2(self.canvas.rect.right(), ball.y)];
        self.canvas.dashed(&line, self.canvas.strong(), 6.0, 4.0);
        self.canvas.probe(ball, BALL);
        self.height(datum, line_start(line));
    }

    /// From the contact: what the table gives, what the parameter adds, the ball.
    fn set_up(&self) {
        let (_, point, normal) = self.workpiece("X");
        let ball = point + normal * (WITH_PARAMETER + BALL);
        self.canvas.probe(ball, BALL);
        self.canvas.contact(point, self.canvas.palette.text.0);
        let [set_up, with] = [SET_UP, WITH_PARAMETER].map(|distance| point + normal * distance);
        // Dimensions are beside the path, above it where it is level.
        let across = if normal.y.abs() < 0.1 { vec2(0.0, -22.0) } else { vec2(-normal.y, normal.x) * 22.0 };
        for place in [point, set_up, with] {
            self.canvas.line(place, place + across * 1.2, self.canvas.thin());
        }
        self.canvas.line(point + across, set_up + across, self.canvas.thin());
        self.canvas.dimension(set_up + across, with + across);
        if normal.y.abs() < 0.1 {
            let middle = set_up + (with - set_up) / 2.0 + across;
            self.canvas.key(middle - vec2(0.0, 6.0), Align2::CENTER_BOTTOM, self.key);
            let beside = point + across - normal * BESIDE;
            let anchor = if normal.x < 0.0 { Align2::LEFT_CENTER } else { Align2::RIGHT_CENTER };
            self.canvas.note_on_ground(beside, anchor, "SET_UP");
        } else {
            let middle = set_up + (with - set_up) / 2.0 + across;
            self.canvas.key(middle + vec2(BESIDE, 6.0), Align2::LEFT_CENTER, self.key);
            self.canvas.note_on_ground(point + across + vec2(BESIDE, 4.0), Align2::LEFT_CENTER, "SET_UP");
        }
    }

    /// Two probings of one contact, much enlarged.
    fn difference(&self) {
        const LARGE: f32 = 34.0;
        let wall = self.at(pos2(186.0, 0.0));
        self.canvas.cut(Rect::from_min_max(pos2(wall.x, self.at(pos2(0.0, 44.0)).y), self.at(pos2(246.0, 150.0))));
        let one = self.at(pos2(186.0 - LARGE, 98.0));
        let other = one - vec2(26.0, 0.0);
        self.canvas.ghost(other, LARGE);
        self.canvas.circle(one, LARGE, eframe::egui::Color32::TRANSPARENT, self.canvas.edge());
        for (ball, number) in [(one, "1"), (other, "2")] {
            self.canvas.contact(ball + vec2(LARGE, 0.0), self.canvas.palette.data.0);
            self.canvas.note(ball - vec2(LARGE - 16.0, 0.0), Align2::CENTER_CENTER, number);
        }
        let y = self.at(pos2(0.0, 30.0)).y;
        let [first, second] = [one, other].map(|ball| pos2(ball.x + LARGE, y));
        for (place, ball) in [(first, one), (second, other)] {
            self.canvas.line(pos2(place.x, y - 4.0), pos2(place.x, ball.y), self.canvas.thin());
        }
        self.canvas.dimension(second, first);
        self.canvas.key(pos2(f32::midpoint(first.x, second.x), y - 8.0), Align2::CENTER_BOTTOM, self.key);
    }

    fn band(&self) {
        // The band of a plane face is drawn like that of a free surface.
        let (_, point, normal) = Section { scene: Scene { shape: Shape::Point, ..self.scene }, ..*self }.workpiece("X");
        let centre = self.at(SURFACE_CENTRE);
        let from = SURFACE_POINT - 20.0;
        let to = SURFACE_POINT + 24.0;
        let fill = Stroke::new(2.0 * HALF_BAND, self.canvas.palette.zone.0);
        self.canvas.polyline(arc(centre, SURFACE_RADIUS, from, to), fill);
        for off in [-HALF_BAND, HALF_BAND] {
            let edge = Stroke::new(1.0, self.canvas.palette.zone_edge.0);
            self.canvas.dashed(&arc(centre, SURFACE_RADIUS + off, from, to), edge, 5.0, 4.0);
        }
        self.canvas.polyline(arc(centre, SURFACE_RADIUS, 31.0, 119.0), self.canvas.edge());
        self.canvas.dimension(point - normal * HALF_BAND, point + normal * HALF_BAND);
        let tip = point + normal * (HALF_BAND + 22.0);
        self.canvas.key(tip + vec2(2.0, -4.0), Align2::CENTER_BOTTOM, self.key);
        for (off, sign) in [(HALF_BAND, "+"), (-HALF_BAND, "−")] {
            let place = polar(centre, SURFACE_RADIUS + off, SURFACE_POINT + 27.0);
            self.canvas.note(place, Align2::CENTER_CENTER, sign);
        }
    }

    fn retract(&self) {
        let (_, point, normal) = self.workpiece("X");
        let ball = point + normal * BALL;
        let back = point + normal * (BALL + 46.0);
        self.canvas.ghost(ball, BALL);
        self.canvas.probe(back, BALL);
        let across = vec2(-normal.y, normal.x) * 20.0;
        for place in [ball, back] {
            self.canvas.line(place, place + across * 1.2, self.canvas.thin());
        }
        self.canvas.dimension(ball + across, back + across);
        let middle = ball + (back - ball) / 2.0 + across;
        self.canvas.key(middle + vec2(BESIDE, 4.0), Align2::LEFT_CENTER, self.key);
        self.canvas.contact(point, self.canvas.palette.text.0);
    }
}

const fn line_start([start, _]: [Pos2; 2]) -> Pos2 {
    start
}
