//! The minimum zone: the ring of least width that holds all points, over all centres. Its width is the roundness.
//!
//! At the best centre four points touch the ring: two outside and two inside, or three and one. Those centres are the
//! corners of the nearest-point and the farthest-point Voronoi diagram and the crossings of an edge of one with an edge
//! of the other; all of them are tried, because the width has local minima. Widths are differences of radii, not of
//! their squares.

use super::cell::{Cell, HalfPlane, Side, crossing};
use super::frame::{Frame, circumcentre, cross, dot, minus, norm};
use super::hull::{around, narrowest_strip, neighbours};

/// Centres are searched for within this many half extents of the points. Farther away a ring is a straight strip.
const REACH: f64 = 1e4;

/// How far beyond its ends an edge is still tried: every centre that is found is measured again.
const BEYOND: f64 = 1e-11;

/// A ring that is narrower by less than this, in half extents of the points, is no better. On an exact circle every
/// edge crosses every other near the centre, and each would be measured again just for its last bit.
const NO_BETTER: f64 = 1e-14;

/// Among so few points the centre of every circle through three of them is tried.
const FEW: usize = 12;

/// The ring of least width that holds all contacts. Lengths in millimetres.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Zone {
    /// Centre in the reference axis.
    pub x: f64,
    /// Centre in the minor axis.
    pub y: f64,
    /// Outer minus inner radius: the roundness.
    pub width: f64,
    /// Diameter of the outer circle.
    pub outer_diameter: f64,
    /// Diameter of the inner circle.
    pub inner_diameter: f64,
}

impl Zone {
    pub(super) fn new(frame: &Frame, ring: Ring) -> Self {
        let [x, y] = frame.point(ring.centre);
        Self {
            x,
            y,
            width: frame.length(ring.width()),
            outer_diameter: frame.length(2.0 * ring.outer),
            inner_diameter: frame.length(2.0 * ring.inner),
        }
    }
}

/// A ring about a centre, by its radii.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ring {
    centre: [f64; 2],
    outer: f64,
    inner: f64,
}

impl Ring {
    fn about(points: &[[f64; 2]], centre: [f64; 2]) -> Self {
        let distances = points.iter().map(|&point| norm(minus(point, centre)));
        let (inner, outer) = distances
            .fold((f64::INFINITY, 0.0), |(inner, outer): (f64, f64), radius| (inner.min(radius), outer.max(radius)));
        Self { centre, outer, inner }
    }

    fn width(&self) -> f64 {
        self.outer - self.inner
    }
}

/// The narrowest ring, or `None` where a straight strip is narrower than every ring.
pub(super) fn narrowest(points: &[[f64; 2]], hull: &[[f64; 2]], start: [f64; 2]) -> Option<Ring> {
    let mut best = Ring::about(points, start);
    if best.width() <= NO_BETTER {
        return Some(best);
    }
    let near = Diagram::new(&around(points, hull), HalfPlane::nearer);
    let far = Diagram::new(&around(hull, hull), |own, other| HalfPlane::nearer(other, own));
    let mut consider = |centre: [f64; 2]| {
        let ring = Ring::about(points, centre);
        if ring.width() < best.width() {
            best = ring;
        }
        best.width()
    };
    let mut width = consider(start);
    for &(centre, outer) in &far.corners {
        // The corner's own radius is the outer one; the first point too far inside ends the search.
        if points.iter().all(|&point| outer - norm(minus(point, centre)) < width - NO_BETTER) {
            width = consider(centre);
        }
    }
    for &(centre, inner) in &near.corners {
        if hull.iter().all(|&corner| norm(minus(corner, centre)) - inner < width - NO_BETTER) {
            width = consider(centre);
        }
    }
    // On a nearly straight set the corners lie far away, and their bisectors cross so flatly that rounding moves them along.
    if points.len() <= FEW {
        for (number, &first) in points.iter().enumerate() {
            for (behind, &second) in points.iter().enumerate().skip(number + 1) {
                for centre in points.iter().skip(behind + 1).filter_map(|&third| circumcentre(first, second, third)) {
                    if norm(centre) < REACH {
                        width = consider(centre);
                    }
                }
            }
        }
    }
    let mut far_edges = far.edges;
    let mut near_edges = near.edges;
    far_edges.sort_by(|a, b| a.least.total_cmp(&b.least));
    near_edges.sort_by(|a, b| b.most.total_cmp(&a.most));
    for outside in &far_edges {
        for inside in &near_edges {
            if width - NO_BETTER <= outside.least - inside.most {
                break;
            }
            let Some(centre) = outside.meets(inside) else { continue };
            if norm(minus(outside.own, centre)) - norm(minus(inside.own, centre)) < width - NO_BETTER {
                width = consider(centre);
            }
        }
    }
    (best.width() < narrowest_strip(hull)).then_some(best)
}

/// Corners and edges of a Voronoi diagram within [`REACH`].
struct Diagram {
    /// Each corner with its distance to the points it belongs to.
    corners: Vec<([f64; 2], f64)>,
    edges: Vec<DiagramEdge>,
}

/// An edge between the cells of two points.
struct DiagramEdge {
    own: [f64; 2],
    start: [f64; 2],
    end: [f64; 2],
    line: HalfPlane,
    /// [`BEYOND`] as a fraction of the edge.
    beyond: f64,
    /// Smallest distance of the edge to the two points.
    least: f64,
    /// Largest distance of the edge to the two points.
    most: f64,
}

impl Diagram {
    /// Points in the order of [`around`].
    fn new(points: &[[f64; 2]], keep: impl Fn([f64; 2], [f64; 2]) -> HalfPlane) -> Self {
        let square = [[-REACH, -REACH], [REACH, -REACH], [REACH, REACH], [-REACH, REACH]];
        let mut diagram = Self { corners: Vec::new(), edges: Vec::new() };
        let mut cell = Cell::default();
        for (index, &own) in points.iter().enumerate() {
            cell.restart(&square);
            for (other_index, other) in neighbours(points, index) {
                cell.clip(keep(own, other), Side::Point(other_index));
            }
            diagram.take(&cell, index, own, points, &keep);
        }
        diagram
    }

    /// Adds the sides and corners of one cell that no earlier cell has added.
    fn take(
        &mut self,
        cell: &Cell,
        index: usize,
        own: [f64; 2],
        points: &[[f64; 2]],
        keep: impl Fn([f64; 2], [f64; 2]) -> HalfPlane,
    ) {
        let mut before = cell.edges().last().map(|edge| edge.side);
        for (edge, end) in cell.segments() {
            if let (Side::Point(other), Some(Side::Point(third))) = (edge.side, before)
                && index < other
                && index < third
            {
                self.corners.push((edge.start, norm(minus(edge.start, own))));
            }
            before = Some(edge.side);
            if let Side::Point(other) = edge.side
                && index < other
                && let Some(&other) = points.get(other)
            {
                self.edges.push(DiagramEdge::new(own, keep(own, other), edge.start, end));
            }
        }
    }
}

impl DiagramEdge {
    fn new(own: [f64; 2], line: HalfPlane, start: [f64; 2], end: [f64; 2]) -> Self {
        let start_distance = norm(minus(own, start));
        let end_distance = norm(minus(own, end));
        let along = minus(end, start);
        let length = norm(along);
        // The nearest place on an edge is an end, unless the foot of the perpendicular lies between.
        let foot = dot(minus(own, start), along);
        let least = if 0.0 < foot && foot < length * length {
            cross(along, minus(own, start)).abs() / length
        } else {
            start_distance.min(end_distance)
        };
        Self { own, start, end, line, beyond: BEYOND / length, least, most: start_distance.max(end_distance) }
    }

    /// Where two edges cross, including a little beyond their ends.
    fn meets(&self, other: &Self) -> Option<[f64; 2]> {
        let along = minus(self.end, self.start);
        let other_along = minus(other.end, other.start);
        let between = minus(other.start, self.start);
        let area = cross(along, other_along);
        let within = |part: f64, edge: &Self| (-edge.beyond..=1.0 + edge.beyond).contains(&part);
        if within(cross(between, other_along) / area, self) && within(cross(between, along) / area, other) {
            crossing(&self.line, &other.line)
        } else {
            None
        }
    }
}
