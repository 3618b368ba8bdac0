//! The convex hull of points.

use super::frame::{cross, dot, minus, norm};

/// Corners of the convex hull, counter-clockwise, without points on its edges (Andrew's monotone chain).
pub(super) fn convex(sorted: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut corners = chain(sorted.iter().copied());
    let mut upper = chain(sorted.iter().rev().copied());
    // Each chain ends where the other begins.
    corners.pop();
    upper.pop();
    corners.append(&mut upper);
    corners
}

fn chain(points: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    let mut corners: Vec<[f64; 2]> = Vec::new();
    for point in points {
        while let [.., before, last] = *corners.as_slice() {
            if 0.0 < cross(minus(last, before), minus(point, last)) {
                break;
            }
            corners.pop();
        }
        corners.push(point);
    }
    corners
}

/// Width of the narrowest strip between two parallel lines that holds the hull: the ring of infinite radius.
pub(super) fn narrowest_strip(corners: &[[f64; 2]]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let width = |(&start, &end): (&[f64; 2], &[f64; 2])| {
        let edge = minus(end, start);
        let rise = |&corner: &[f64; 2]| cross(edge, minus(corner, start)) / norm(edge);
        if dot(edge, edge) <= 0.0 { f64::INFINITY } else { corners.iter().map(rise).fold(0.0, f64::max) }
    };
    corners.iter().zip(next).map(width).fold(f64::INFINITY, f64::min)
}
