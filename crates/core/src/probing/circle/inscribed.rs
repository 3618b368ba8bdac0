//! The largest empty circle that the points surround.
//!
//! Of all circles with no point strictly inside and with the centre in the convex hull, this is the largest. Where that
//! one has its centre on the edge of the hull, it could grow further outwards, so there is none. Locally largest
//! circles are not enough (sets `cir2d13`, `scipy_cookbook1`): every Voronoi cell is searched.

use super::cell::{Cell, HalfPlane, Side};
use super::frame::{minus, norm};
use super::hull::{around, neighbours};

/// Circles on the edge of the hull and inside it count as equal within this fraction.
const ROUNDING: f64 = 1e-12;

/// Centre and radius, or `None` where no such circle exists.
pub(super) fn largest(points: &[[f64; 2]], hull: &[[f64; 2]]) -> Option<([f64; 2], f64)> {
    let mut inside: Option<([f64; 2], f64)> = None;
    let mut on_edge: f64 = 0.0;
    let mut cell = Cell::default();
    let points = around(points, hull);
    for (index, &own) in points.iter().enumerate() {
        cell.restart(hull);
        for (other_index, other) in neighbours(&points, index) {
            cell.clip(HalfPlane::nearer(own, other), Side::Point(other_index));
        }
        let last = cell.edges().last().map(|edge| edge.side);
        let before = last.into_iter().chain(cell.edges().iter().map(|edge| edge.side));
        for (edge, before) in cell.edges().iter().zip(before) {
            let radius = norm(minus(edge.start, own));
            if edge.side == Side::Border || before == Side::Border {
                on_edge = on_edge.max(radius);
            } else if inside.is_none_or(|(_, largest)| largest < radius) {
                inside = Some((edge.start, radius));
            }
        }
    }
    inside.filter(|&(_, radius)| on_edge * (1.0 + ROUNDING) < radius)
}
