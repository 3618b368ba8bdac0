//! The smallest circle that contains all points.
//!
//! Two or three of them carry it. Starting from any two, the point farthest outside joins the carriers, and the
//! smallest circle about these (at most four) replaces the circle. The radius grows with every round, so the search
//! ends: by less than a bit where a circle only has to move, and then the farthest point has to come nearer. Each round
//! visits every point at most twice; even 100 000 points take only a dozen rounds.

use super::frame::{circumcentre, midpoint, minus, norm};

/// How far outside a point may lie because of rounding, as a fraction of the radius.
const ROUNDING: f64 = 1e-14;

/// Number of rounds after which the answer changes by rounding only.
const MOST_ROUNDS: usize = 1_000;

/// Centre and radius of the smallest circle around the points.
pub(super) fn smallest(points: &[[f64; 2]]) -> ([f64; 2], f64) {
    let mut carriers: Vec<[f64; 2]> = points.first().into_iter().chain(points.last()).copied().collect();
    let mut circle = smallest_about_few(&carriers);
    for _ in 0..MOST_ROUNDS {
        let (centre, radius) = circle;
        let Some((distance, farthest)) = farthest(points, centre) else { break };
        if distance <= radius * (1.0 + ROUNDING) {
            break;
        }
        carriers.push(farthest);
        let (next_centre, next_radius) = smallest_about_few(&carriers);
        let comes_nearer = || self::farthest(points, next_centre).is_some_and(|(next, _)| next < distance);
        if next_radius <= radius && !comes_nearer() {
            break;
        }
        circle = (next_centre, next_radius);
        carriers.retain(|&point| next_radius * (1.0 - 1e-9) <= norm(minus(point, next_centre)));
        keep_three(&mut carriers, circle);
    }
    let (centre, radius) = circle;
    // This radius includes the rounding, so that the circle contains every point.
    (centre, farthest(points, centre).map_or(radius, |(distance, _)| distance))
}

/// Of four carriers on one circle, drops one that the circle does not need.
fn keep_three(carriers: &mut Vec<[f64; 2]>, (_, radius): ([f64; 2], f64)) {
    if carriers.len() <= 3 {
        return;
    }
    for dropped in 0..carriers.len() {
        let mut others = carriers.clone();
        others.remove(dropped);
        if radius * (1.0 - ROUNDING) <= smallest_about_few(&others).1 {
            *carriers = others;
            return;
        }
    }
    // Because of rounding, no three carry the same circle; the newest three come closest.
    carriers.remove(0);
}

fn farthest(points: &[[f64; 2]], centre: [f64; 2]) -> Option<(f64, [f64; 2])> {
    points.iter().map(|&point| (norm(minus(point, centre)), point)).max_by(|(a, _), (b, _)| a.total_cmp(b))
}

/// The smallest circle about a few points: its centre is that of a circle on two or three of them, so of all these centres it is
/// the one from which the farthest point is nearest. Nothing has to be equal to anything else but for rounding.
fn smallest_about_few(points: &[[f64; 2]]) -> ([f64; 2], f64) {
    let mut best = ([0.0; 2], f64::INFINITY);
    let mut consider = |centre: [f64; 2]| {
        let radius = farthest(points, centre).map_or(0.0, |(distance, _)| distance);
        if radius < best.1 {
            best = (centre, radius);
        }
    };
    for (index, &first) in points.iter().enumerate() {
        for (second_index, &second) in points.iter().enumerate().skip(index + 1) {
            consider(midpoint(first, second));
            for &third in points.iter().skip(second_index + 1) {
                if let Some(centre) = circumcentre(first, second, third) {
                    consider(centre);
                }
            }
        }
    }
    best
}
