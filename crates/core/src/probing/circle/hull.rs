//! The convex hull of points.

use super::frame::{cross, dot, mean, minus, norm};

/// Corners of the convex hull, counter-clockwise, without points on its edges (Andrew's monotone chain).
pub(super) fn convex(sorted: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut corners = chain(sorted.iter().copied());
    let mut upper = chain(sorted.iter().rev().copied());
    // The last corner of a chain is the first one of the other chain.
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

/// The points, ordered by their direction from the middle of the hull.
pub(super) fn around(points: &[[f64; 2]], corners: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let middle = mean(corners);
    let angle = |point: &[f64; 2]| {
        let [x, y] = minus(*point, middle);
        libm::atan2(y, x)
    };
    let mut ordered = points.to_vec();
    ordered.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    ordered
}

/// All other points with their indices, neighbours on both sides first; one or two of the last points come twice.
///
/// Clipping in this order cuts a polygon down to a few sides at once; in any other order, cells of thousands of sides
/// come and go on the way.
pub(super) fn neighbours(ordered: &[[f64; 2]], index: usize) -> impl Iterator<Item = (usize, [f64; 2])> {
    let count = ordered.len();
    let onwards = (0..).zip(ordered.iter().copied()).take(count).cycle().skip(index + 1);
    let backwards = (0..count).rev().zip(ordered.iter().rev().copied()).cycle().skip(count.saturating_sub(index));
    onwards.zip(backwards).take(count / 2).flat_map(|(after, before)| [after, before])
}
