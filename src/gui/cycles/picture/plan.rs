//! Parameters that are seen from above: centres, diameters, angles, points, limits; and the normal, seen at an angle.

use eframe::egui::{Align2, Pos2, Rect, Stroke, Vec2, pos2, vec2};

use super::canvas::{BESIDE, Canvas, polar};
use super::scene::Scene;
use crate::probing::cycle::{Axis, Meaning};
use crate::probing::simulated::Shape;

const DATUM: Pos2 = pos2(46.0, 128.0);
/// The centre of the circle, and its radius.
const CENTRE: Pos2 = pos2(160.0, 62.0);
const RADIUS: f32 = 42.0;
const BALL: f32 = 9.0;
/// The angle of the first contact, and the step to the next.
const FIRST: f32 = 50.0;
const STEP: f32 = 80.0;
/// Half the lengths of a rectangle; a slot or ridge has the first, and ends outside the drawing of its block.
const HALVES: Vec2 = vec2(44.0, 32.0);
const BLOCK: Vec2 = vec2(156.0, 112.0);
/// The face that is touched, seen from above.
const FACE: Rect = Rect { min: pos2(72.0, 20.0), max: pos2(168.0, 112.0) };
/// Below and left of the datum there is room for dimensions.
const BELOW: f32 = 147.0;
const ASIDE: f32 = 20.0;

struct Plan<'a> {
    canvas: &'a Canvas<'a>,
    scene: Scene,
    key: &'a str,
}

pub(super) fn draw(canvas: &Canvas<'_>, scene: Scene, meaning: Meaning, key: &str) {
    let plan = Plan { canvas, scene, key };
    match meaning {
        Meaning::Centre(axis) | Meaning::SecondCentre(axis) | Meaning::NewDatum(axis) => plan.centre(axis),
        Meaning::NewCoordinate if scene.shape == Shape::Face => plan.coordinate(0.0),
        Meaning::NewCoordinate => plan.centre(Axis::First),
        Meaning::ToolAxisPoint(axis) => plan.top(axis),
        Meaning::CentreTolerance(axis) => plan.centre_tolerance(axis),
        Meaning::Diameter | Meaning::SecondDiameter => plan.diameter(),
        Meaning::StartDiameter => plan.start_diameter(),
        Meaning::MaximumDiameter => plan.limit(RADIUS + 10.0),
        Meaning::MinimumDiameter => plan.limit(RADIUS - 8.0),
        Meaning::FirstAngle | Meaning::AlignedAngle => plan.first_angle(),
        Meaning::Step | Meaning::Arc => plan.step(),
        Meaning::Path => plan.path(),
        Meaning::Point(axis) | Meaning::NextPoint(axis) => plan.point(axis),
        Meaning::MaximumCoordinate => plan.coordinate(14.0),
        Meaning::MinimumCoordinate => plan.coordinate(-14.0),
        Meaning::Normal(axis) => plan.normal(axis),
        Meaning::Side(axis) => plan.length(axis, 0.0),
        Meaning::MaximumSide(axis) => plan.length(axis, 9.0),
        Meaning::MinimumSide(axis) => plan.length(axis, -9.0),
        Meaning::Width => plan.length(Axis::First, 0.0),
        Meaning::MaximumWidth => plan.length(Axis::First, 9.0),
        Meaning::MinimumWidth => plan.length(Axis::First, -9.0),
        Meaning::Start(axis) => plan.start(axis),
        Meaning::Shift => plan.shift(),
        Meaning::FirstPoint(axis) => plan.point_of_wall(axis, 1.0),
        Meaning::SecondPoint(axis) => plan.point_of_wall(axis, -1.0),
        _ => super::general::draw(canvas, meaning, key),
    }
}

impl Plan<'_> {
    fn at(&self, place: Pos2) -> Pos2 {
        self.canvas.rect.min + place.to_vec2()
    }

    fn axes(&self) {
        let [first, second, _] = self.scene.axes;
        let origin = self.at(DATUM);
        self.canvas.arrow(origin, self.at(pos2(254.0, DATUM.y)), self.canvas.thin());
        self.canvas.arrow(origin, self.at(pos2(DATUM.x, 6.0)), self.canvas.thin());
        self.canvas.note(self.at(pos2(254.0, DATUM.y + 3.0)), Align2::RIGHT_TOP, first);
        self.canvas.note(self.at(pos2(DATUM.x - 6.0, 6.0)), Align2::RIGHT_TOP, second);
        self.canvas.circle(origin, 3.5, self.canvas.palette.surface.0, self.canvas.edge());
    }

    /// Half the lengths between walls, from their centre.
    fn halves(&self) -> Vec2 {
        match self.scene.shape {
            Shape::Slot | Shape::Ridge => vec2(HALVES.x, BLOCK.y / 2.0),
            _ => HALVES,
        }
    }

    /// What is measured, with its centre.
    fn feature(&self) {
        let centre = self.at(CENTRE);
        let palette = self.canvas.palette;
        let shape = self.scene.shape;
        let block = Rect::from_center_size(centre, BLOCK);
        if !shape.is_outside() {
            self.canvas.block(block);
        }
        let fill = if shape.is_outside() { palette.none.0 } else { palette.surface.0 };
        match shape {
            Shape::Slot | Shape::Ridge | Shape::Pocket | Shape::Boss => {
                let walls = Rect::from_center_size(centre, self.halves() * 2.0);
                self.canvas.painter.rect_filled(walls, 0.0, fill);
                let [left, right] = [walls.x_range().min, walls.x_range().max];
                for x in [left, right] {
                    self.canvas.line(pos2(x, walls.top()), pos2(x, walls.bottom()), self.canvas.edge());
                }
                if matches!(shape, Shape::Pocket | Shape::Boss) {
                    for y in [walls.top(), walls.bottom()] {
                        self.canvas.line(pos2(left, y), pos2(right, y), self.canvas.edge());
                    }
                }
            }
            _ => self.canvas.circle(centre, RADIUS, fill, self.canvas.edge()),
        }
        self.canvas.cross(centre, 5.0, self.canvas.thin());
    }

    /// The ball where it touches the circle in a direction, from the side that is probed.
    fn touching(&self, degrees: f32) -> Pos2 {
        let off = if self.scene.shape.is_outside() { BALL } else { -BALL };
        polar(self.at(CENTRE), RADIUS + off, degrees)
    }

    /// A line from what is measured to its dimension.
    fn extension(&self, from: Pos2, to: Pos2) {
        self.canvas.line(from, to, self.canvas.thin());
    }

    /// A coordinate of a place in an axis.
    fn coordinate_of(&self, place: Pos2, axis: Axis) {
        let origin = self.at(DATUM);
        let place = self.at(place);
        if axis == Axis::First {
            let y = self.at(pos2(0.0, BELOW)).y;
            self.extension(place, pos2(place.x, y + 4.0));
            self.extension(origin, pos2(origin.x, y + 4.0));
            self.canvas.dimension(pos2(origin.x, y), pos2(place.x, y));
            self.canvas.key(pos2(f32::midpoint(origin.x, place.x), y), Align2::CENTER_CENTER, self.key);
        } else {
            let x = self.at(pos2(ASIDE, 0.0)).x;
            self.extension(place, pos2(x - 4.0, place.y));
            self.extension(origin, pos2(x - 4.0, origin.y));
            self.canvas.dimension(pos2(x, origin.y), pos2(x, place.y));
            self.canvas.key(pos2(x, f32::midpoint(origin.y, place.y)), Align2::CENTER_CENTER, self.key);
        }
    }

    fn centre(&self, axis: Axis) {
        self.feature();
        self.axes();
        self.coordinate_of(CENTRE, axis);
        self.canvas.cross(self.at(CENTRE), 7.0, self.canvas.strong());
    }

    /// A place on the top of what is measured, or beside it.
    fn top(&self, axis: Axis) {
        self.feature();
        self.axes();
        let place = CENTRE + if self.scene.shape.is_outside() { vec2(16.0, -10.0) } else { vec2(64.0, -42.0) };
        self.coordinate_of(place, axis);
        self.canvas.ball(self.at(place), BALL);
        self.canvas.contact(self.at(place), self.canvas.palette.data.0);
    }

    fn centre_tolerance(&self, axis: Axis) {
        const HALF: f32 = 22.0;
        self.feature();
        self.axes();
        let centre = self.at(CENTRE);
        let (along, across) = if axis == Axis::First { (Vec2::X, Vec2::Y) } else { (Vec2::Y, Vec2::X) };
        let zone = Rect::from_two_pos(centre - along * HALF - across * 30.0, centre + along * HALF + across * 30.0);
        self.canvas.painter.rect_filled(zone, 0.0, self.canvas.palette.zone.0);
        let edge = Stroke::new(1.0, self.canvas.palette.zone_edge.0);
        for side in [-1.0, 1.0] {
            let place = centre + along * HALF * side;
            self.canvas.line(place - across * 30.0, place + across * 30.0, edge);
        }
        self.canvas.dimension(centre - along * HALF, centre + along * HALF);
        self.canvas.cross(centre, 7.0, self.canvas.edge());
        let text = format!("± {}", self.key);
        if axis == Axis::First {
            self.canvas.key(centre + vec2(0.0, 18.0), Align2::CENTER_CENTER, &text);
        } else {
            self.canvas.key(centre + vec2(BESIDE + 5.0, 0.0), Align2::LEFT_CENTER, &text);
        }
    }

    fn diameter(&self) {
        self.feature();
        self.axes();
        self.across(RADIUS, -25.0);
    }

    /// A dimension through the centre.
    fn across(&self, radius: f32, degrees: f32) {
        let centre = self.at(CENTRE);
        self.canvas.dimension(polar(centre, radius, degrees + 180.0), polar(centre, radius, degrees));
        self.canvas.key(centre, Align2::CENTER_CENTER, self.key);
    }

    fn start_diameter(&self) {
        self.feature();
        self.axes();
        let centre = self.at(CENTRE);
        let radius = RADIUS * 0.7;
        self.canvas.ring(centre, radius, self.canvas.strong());
        for step in 0..3_u8 {
            self.canvas.ball(polar(centre, radius, 60.0 + 120.0 * f32::from(step)), BALL * 0.6);
        }
        self.across(radius, -25.0);
    }

    /// A limit of size, beside the edge.
    fn limit(&self, radius: f32) {
        self.feature();
        self.axes();
        let centre = self.at(CENTRE);
        self.canvas.ring(centre, radius, self.canvas.strong());
        self.across(radius, -25.0);
    }

    fn first_angle(&self) {
        self.feature();
        self.axes();
        let centre = self.at(CENTRE);
        // On the side where the ball is not.
        let radius = if self.scene.shape.is_outside() { RADIUS * 0.65 } else { RADIUS + 14.0 };
        for degrees in [0.0, FIRST] {
            self.canvas.line(centre, polar(centre, radius.max(RADIUS) + 6.0, degrees), self.canvas.thin());
        }
        self.canvas.ball(self.touching(FIRST), BALL);
        self.canvas.contact(polar(centre, RADIUS, FIRST), self.canvas.palette.data.0);
        self.canvas.arc_arrow(centre, radius, [0.0, FIRST], self.canvas.strong());
        let beside = polar(centre, radius.max(RADIUS) + 4.0, FIRST * 0.4);
        self.canvas.key(beside, Align2::LEFT_CENTER, self.key);
    }

    fn step(&self) {
        self.feature();
        self.axes();
        let centre = self.at(CENTRE);
        for (number, touch) in ["1", "2", "3"].into_iter().zip(0_u8..) {
            let degrees = 15.0 + STEP * f32::from(touch);
            self.canvas.line(centre, polar(centre, RADIUS, degrees), self.canvas.thin());
            let colour = if touch < 2 { self.canvas.palette.data.0 } else { self.canvas.palette.text.0 };
            self.canvas.contact(polar(centre, RADIUS, degrees), colour);
            let place = polar(centre, RADIUS - 11.0, degrees + 18.0);
            self.canvas.note(place, Align2::CENTER_CENTER, number);
        }
        self.canvas.arc_arrow(centre, RADIUS * 0.42, [15.0, 15.0 + STEP], self.canvas.strong());
        let place = polar(centre, RADIUS + 14.0, 15.0 + STEP / 2.0);
        self.canvas.key(place + vec2(2.0, 2.0), Align2::LEFT_BOTTOM, self.key);
    }

    fn path(&self) {
        self.feature();
        self.axes();
        let centre = self.at(CENTRE);
        let from = polar(centre, 10.0, 20.0);
        let to = polar(centre, RADIUS + 22.0, 20.0);
        self.canvas.ball(from, BALL);
        self.canvas.ghost(polar(centre, RADIUS - BALL, 20.0), BALL);
        self.canvas.arrow(from, to, self.canvas.strong());
        self.canvas.key(to + vec2(2.0, -5.0), Align2::CENTER_BOTTOM, &format!("+{}", self.key));
        let back = polar(centre, 30.0, 200.0);
        self.canvas.dashed(&[polar(centre, 2.0, 200.0), back], self.canvas.strong(), 4.0, 3.0);
        self.canvas.head(back, polar(Pos2::ZERO, 1.0, 200.0).to_vec2(), self.canvas.palette.data.0);
        self.canvas.key(polar(centre, RADIUS + 8.0, 200.0), Align2::RIGHT_CENTER, &format!("−{}", self.key));
    }

    /// A length from wall to wall, or a limit of it, this far beside the walls.
    fn length(&self, axis: Axis, beside: f32) {
        self.feature();
        self.axes();
        let centre = self.at(CENTRE);
        let halves = self.halves();
        let (along, across, half, reach) = if axis == Axis::First {
            (Vec2::X, Vec2::Y, halves.x, halves.y)
        } else {
            (Vec2::Y, Vec2::X, halves.y, halves.x)
        };
        let ends = [-1.0, 1.0].map(|sign| centre + along * (half + beside) * sign);
        if 0.0 < beside.abs() {
            for end in ends {
                self.canvas.dashed(&[end - across * reach, end + across * reach], self.canvas.strong(), 6.0, 4.0);
            }
        }
        let [from, to] = ends;
        self.canvas.dimension(from, to);
        self.canvas.key(centre, Align2::CENTER_CENTER, self.key);
    }

    /// Where the probe begins in a slot.
    fn start(&self, axis: Axis) {
        self.feature();
        self.axes();
        let start = CENTRE + vec2(8.0, 6.0);
        let ball = self.at(start);
        self.canvas.arrow(ball, self.at(pos2(CENTRE.x + self.halves().x - BALL, start.y)), self.canvas.thin());
        self.canvas.ball(ball, BALL);
        self.coordinate_of(start, axis);
    }

    /// The second contact, shifted along the slot.
    fn shift(&self) {
        const SHIFT: f32 = 44.0;
        self.feature();
        self.axes();
        let centre = self.at(CENTRE);
        let half = self.halves().x;
        let first = centre + vec2(half, SHIFT / 2.0);
        let second = centre + vec2(-half, -SHIFT / 2.0);
        for (wall, towards) in [(first, Vec2::X), (second, -Vec2::X)] {
            let ball = wall - towards * BALL;
            self.canvas.arrow(ball - towards * 26.0, ball - towards * BALL, self.canvas.thin());
            self.canvas.ball(ball, BALL);
            self.canvas.contact(wall, self.canvas.palette.data.0);
        }
        let [low, high] = [first, second].map(|wall| pos2(centre.x, wall.y));
        self.extension(low, first);
        self.extension(high, second);
        self.canvas.dimension(low, high);
        self.canvas.key(centre, Align2::CENTER_CENTER, self.key);
    }

    /// A point on one of the walls of a ridge: the first on the plus side, the second on the minus side.
    fn point_of_wall(&self, axis: Axis, side: f32) {
        self.feature();
        self.axes();
        let point = CENTRE + vec2(self.halves().x * side, 0.0);
        let ball = self.at(point) + vec2(BALL * side, 0.0);
        self.canvas.arrow(ball + vec2(36.0 * side, 0.0), ball + vec2(BALL * side, 0.0), self.canvas.thin());
        self.canvas.ball(ball, BALL);
        self.coordinate_of(point, axis);
        self.canvas.contact(self.at(point), self.canvas.palette.data.0);
    }

    /// The block with the point on its face.
    fn face(&self) -> Pos2 {
        let block = Rect::from_min_max(self.at(FACE.min), self.at(FACE.max));
        self.canvas.block(block);
        self.axes();
        pos2(FACE.right(), FACE.center().y)
    }

    fn point(&self, axis: Axis) {
        let point = self.face();
        let ball = self.at(point) + vec2(BALL, 0.0);
        self.canvas.arrow(ball + vec2(50.0, 0.0), ball + vec2(BALL, 0.0), self.canvas.thin());
        self.canvas.ball(ball, BALL);
        self.coordinate_of(point, axis);
        self.canvas.contact(self.at(point), self.canvas.palette.data.0);
    }

    /// A limit of the face's coordinate, beside the face.
    fn coordinate(&self, off: f32) {
        let point = self.face();
        let top = self.at(pos2(point.x, FACE.top() - 12.0));
        let limit = pos2(point.x + off, point.y);
        let [x, y] = [self.at(limit).x, top.y];
        self.canvas.dashed(&[pos2(x, y), pos2(x, self.at(DATUM).y)], self.canvas.strong(), 6.0, 4.0);
        let ball = self.at(point) + vec2(BALL, 0.0);
        self.canvas.arrow(ball + vec2(50.0, 0.0), ball + vec2(BALL, 0.0), self.canvas.thin());
        self.canvas.ball(ball, BALL);
        let origin = self.at(DATUM);
        let y = self.at(pos2(0.0, BELOW)).y;
        self.extension(pos2(x, origin.y), pos2(x, y + 4.0));
        self.extension(origin, pos2(origin.x, y + 4.0));
        self.canvas.dimension(pos2(origin.x, y), pos2(x, y));
        self.canvas.key(pos2(f32::midpoint(origin.x, x), y), Align2::CENTER_CENTER, self.key);
    }

    /// The normal of a surface in space, and one component of it.
    fn normal(&self, axis: Axis) {
        // Second axis into the drawing.
        let x = vec2(62.0, 0.0);
        let y = vec2(46.0, -28.0);
        let z = vec2(0.0, -66.0);
        let point = self.at(pos2(92.0, 126.0));
        let tip = point + x + y + z;
        self.patch(point, tip - point);
        for (axis, name) in [(x, "X"), (y, "Y"), (z, "Z")] {
            let end = point + axis + axis.normalized() * 20.0;
            self.canvas.arrow(point, end, self.canvas.thin());
            self.canvas.note(end + axis.normalized() * 9.0, Align2::CENTER_CENTER, name);
        }
        // The box whose diagonal the normal is.
        let ways = [[x, y, z], [x, z, y], [y, x, z], [y, z, x], [z, x, y], [z, y, x]];
        for [first, second, third] in ways {
            let one = point + first;
            let two = point + first + second;
            self.canvas.dashed(&[one, two], self.canvas.thin(), 3.0, 3.0);
            self.canvas.dashed(&[two, two + third], self.canvas.thin(), 3.0, 3.0);
        }
        self.canvas.arrow(point, tip, self.canvas.edge());
        let (along, share, off, anchor) = match axis {
            Axis::First => (x, 0.8, vec2(BESIDE, 4.0), Align2::CENTER_TOP),
            Axis::Second => (y, 0.5, vec2(BESIDE, BESIDE), Align2::LEFT_CENTER),
            Axis::Third => (z, 0.8, vec2(-BESIDE, 0.0), Align2::RIGHT_CENTER),
        };
        self.canvas.arrow(point, point + along, self.canvas.strong());
        self.canvas.key(point + along * share + off, anchor, self.key);
        self.canvas.contact(point, self.canvas.palette.text.0);
    }

    /// A piece of the surface, seen at an angle.
    fn patch(&self, centre: Pos2, normal: Vec2) {
        let along = vec2(-normal.y, normal.x).normalized() * 40.0;
        let flat = normal.normalized() * 13.0;
        let points: Vec<Pos2> = (0..48_u8)
            .map(|step| (f32::from(step) * 7.5).to_radians().sin_cos())
            .map(|(sin, cos)| centre + along * cos + flat * sin)
            .collect();
        self.canvas.painter.add(eframe::egui::epaint::PathShape::convex_polygon(
            points,
            self.canvas.palette.none.0,
            self.canvas.edge(),
        ));
    }
}
