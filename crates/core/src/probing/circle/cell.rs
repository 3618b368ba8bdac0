//! One cell of a nearest-point or farthest-point Voronoi diagram, made by clipping a convex polygon.
//!
//! Every side remembers which point's bisector it lies on, and corners are computed from the two lines that meet there,
//! never by walking along a clipped side: a start polygon of any size costs no accuracy.

use super::frame::{cross, dot, midpoint, minus, norm, unit};

/// What a side of a cell lies on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// A border of the polygon that the clipping started with.
    Border,
    /// The bisector against this point, by index.
    Point(usize),
}

/// The points where `normal · x` is at most `offset`; the normal is a unit vector.
#[derive(Debug, Clone, Copy)]
pub(super) struct HalfPlane {
    normal: [f64; 2],
    offset: f64,
}

impl HalfPlane {
    /// The points nearer to `own` than to `other`; if the two coincide, every point.
    pub(super) fn nearer(own: [f64; 2], other: [f64; 2]) -> Self {
        let normal = unit(minus(other, own));
        Self { normal, offset: dot(normal, midpoint(own, other)) }
    }

    /// The points to the left of the line from one corner to the next.
    fn left_of(start: [f64; 2], end: [f64; 2]) -> Self {
        let [x, y] = minus(end, start);
        let normal = unit([y, -x]);
        Self { normal, offset: dot(normal, start) }
    }

    fn height(&self, point: [f64; 2]) -> f64 {
        dot(self.normal, point) - self.offset
    }
}

/// Where the borders of two half-planes cross; `None` when they are parallel.
pub(super) fn crossing(first: &HalfPlane, second: &HalfPlane) -> Option<[f64; 2]> {
    let determinant = cross(first.normal, second.normal);
    let [first_x, first_y] = first.normal;
    let [second_x, second_y] = second.normal;
    let point = [
        (first.offset * second_y - second.offset * first_y) / determinant,
        (second.offset * first_x - first.offset * second_x) / determinant,
    ];
    norm(point).is_finite().then_some(point)
}

/// One side of a cell, from its start to the start of the next one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    /// Where it starts.
    pub(super) start: [f64; 2],
    /// What it lies on.
    pub(super) side: Side,
    line: HalfPlane,
}

/// A convex polygon that can be clipped.
#[derive(Debug, Clone, Default)]
pub(super) struct Cell {
    edges: Vec<Edge>,
    spare: Vec<Edge>,
}

impl Cell {
    /// Starts again with a polygon, corners counter-clockwise.
    pub(super) fn restart(&mut self, corners: &[[f64; 2]]) {
        self.edges.clear();
        let next = corners.iter().cycle().skip(1);
        self.edges.extend(corners.iter().zip(next).map(|(&start, &end)| Edge {
            start,
            side: Side::Border,
            line: HalfPlane::left_of(start, end),
        }));
    }

    /// The sides, counter-clockwise; none when nothing is left.
    pub(super) fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The sides, each with its end.
    pub(super) fn segments(&self) -> impl Iterator<Item = (&Edge, [f64; 2])> {
        let next = self.edges.iter().cycle().skip(1);
        self.edges.iter().zip(next).map(|(edge, next)| (edge, next.start))
    }

    /// Keeps only what lies in a half-plane.
    pub(super) fn clip(&mut self, line: HalfPlane, side: Side) {
        if self.edges.iter().all(|edge| line.height(edge.start) <= 0.0) {
            return;
        }
        let mut kept = std::mem::take(&mut self.spare);
        kept.clear();
        for (edge, end) in self.segments() {
            let start_height = line.height(edge.start);
            let end_height = line.height(end);
            let is_in = start_height <= 0.0;
            let ends_in = end_height <= 0.0;
            let cut = || {
                crossing(&edge.line, &line).unwrap_or_else(|| {
                    // Parallel to the last bit, yet on both sides: any place between the two will do.
                    let part = start_height / (start_height - end_height);
                    let [x, y] = edge.start;
                    let [to_x, to_y] = minus(end, edge.start);
                    [x + part * to_x, y + part * to_y]
                })
            };
            if is_in {
                kept.push(*edge);
            }
            match (is_in, ends_in) {
                (true, false) => kept.push(Edge { start: cut(), side, line }),
                (false, true) => kept.push(Edge { start: cut(), ..*edge }),
                _ => {}
            }
        }
        self.spare = std::mem::replace(&mut self.edges, kept);
    }
}
