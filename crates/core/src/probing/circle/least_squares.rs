//! The circle with the least sum of squared radial deviations.
//!
//! Only the centre is searched for, because the best radius about any centre is the mean distance (Coope 1993). Three
//! points: closed form. More: Taubin's algebraic circle as the start, then full Newton steps where they help and halved
//! Gauss-Newton steps where they do not, and at the end Newton steps to the last bit. A search that stops when the sum
//! of squares stops falling would leave about 1e-8 mm on rough short arcs.
//!
//! The sum of squares may have several valleys, one of them towards a straight line (Chernov & Lesort 2005): where the best
//! circle through three of the points is closer to all of them than what was found, the search begins again from there; among
//! few points far from any circle it begins from every such circle.

use super::frame::{circumcentre, count_f64, cross, dot, mean, midpoint, minus, norm, unit};

/// More steps than any set needs: one point far inside takes plain Gauss-Newton about 50.
const MOST_STEPS: usize = 500;

/// A centre farther away than this many half extents of the contacts makes no circle: at 20 mm its arc rises 10 nm.
const FARTHEST: f64 = 1e6;

/// What distances are rounded by, in half extents of the contacts.
const ROUNDING: f64 = 1e-14;

/// So many points stand for all where the circles through three of them are tried.
const SPREAD: usize = 8;

/// Among more points than these, not every such circle begins a search.
const MOST_FOR_EVERY_START: usize = 64;

/// A least-squares circle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fit {
    /// Centre.
    pub(super) centre: [f64; 2],
    /// Radius.
    pub(super) radius: f64,
    mean_excess: f64,
}

impl Fit {
    fn about(points: &[[f64; 2]], centre: [f64; 2]) -> Self {
        let mean_excess = mean_excess(points, centre);
        Self { centre, radius: norm(centre) + mean_excess, mean_excess }
    }

    /// How far a point lies outside the circle; negative inside.
    pub(super) fn residual(&self, point: [f64; 2]) -> f64 {
        excess(point, self.centre) - self.mean_excess
    }
}

/// How much farther a point lies from `centre` than the origin does.
///
/// Written so that no terms of the size of the radius cancel: on a short arc of a large circle the rounding stays that
/// of the points.
fn excess(point: [f64; 2], centre: [f64; 2]) -> f64 {
    let sum = norm(minus(point, centre)) + norm(centre);
    if sum <= 0.0 { 0.0 } else { (dot(point, point) - 2.0 * dot(point, centre)) / sum }
}

fn mean_excess(points: &[[f64; 2]], centre: [f64; 2]) -> f64 {
    points.iter().map(|&point| excess(point, centre)).sum::<f64>() / count_f64(points.len())
}

/// The least-squares circle through three or more points that are not collinear; `None` where a straight line fits
/// better than any circle.
pub(super) fn fit(points: &[[f64; 2]]) -> Option<Fit> {
    let centre = match points {
        &[first, second, third] => circumcentre(first, second, third)?,
        _ => search(points)?,
    };
    (norm(centre) <= FARTHEST).then(|| Fit::about(points, centre))
}

/// A symmetric two by two matrix.
#[derive(Debug, Clone, Copy)]
struct Symmetric {
    xx: f64,
    xy: f64,
    yy: f64,
}

impl Symmetric {
    /// Solves for the vector that this matrix maps to `right`; `None` unless the matrix is positive definite.
    fn solve(self, [right_x, right_y]: [f64; 2]) -> Option<[f64; 2]> {
        let determinant = self.xx * self.yy - self.xy * self.xy;
        if self.xx + self.yy <= 0.0 || determinant <= 0.0 {
            return None;
        }
        let step = [
            (right_x * self.yy - right_y * self.xy) / determinant,
            (right_y * self.xx - right_x * self.xy) / determinant,
        ];
        norm(step).is_finite().then_some(step)
    }
}

/// The sums over all points that a step from `centre` needs.
struct Sums {
    squares: f64,
    /// Half the downhill gradient.
    downhill: [f64; 2],
    gauss: Symmetric,
    newton: Symmetric,
}

impl Sums {
    fn at(points: &[[f64; 2]], centre: [f64; 2]) -> Self {
        let mean_excess = mean_excess(points, centre);
        let directions: Vec<[f64; 2]> = points.iter().map(|&point| unit(minus(point, centre))).collect();
        let mean = mean(&directions);
        let zero = Symmetric { xx: 0.0, xy: 0.0, yy: 0.0 };
        let mut sums = Self { squares: 0.0, downhill: [0.0; 2], gauss: zero, newton: zero };
        for (&point, &[x, y]) in points.iter().zip(&directions) {
            let distance = norm(minus(point, centre));
            let [off_x, off_y] = minus([x, y], mean);
            let residual = excess(point, centre) - mean_excess;
            sums.squares += residual * residual;
            let [down_x, down_y] = sums.downhill;
            sums.downhill = [down_x + residual * off_x, down_y + residual * off_y];
            sums.gauss.xx += off_x * off_x;
            sums.gauss.xy += off_x * off_y;
            sums.gauss.yy += off_y * off_y;
            if 0.0 < distance {
                let bend = residual / distance;
                sums.newton.xx += bend * y * y;
                sums.newton.xy -= bend * x * y;
                sums.newton.yy += bend * x * x;
            }
        }
        sums.newton.xx += sums.gauss.xx;
        sums.newton.xy += sums.gauss.xy;
        sums.newton.yy += sums.gauss.yy;
        sums
    }

    fn newton_step(&self) -> Option<[f64; 2]> {
        self.newton.solve(self.downhill)
    }

    fn gauss_step(&self) -> Option<[f64; 2]> {
        self.gauss.solve(self.downhill)
    }
}

fn moved([x, y]: [f64; 2], [step_x, step_y]: [f64; 2], part: f64) -> [f64; 2] {
    [x + part * step_x, y + part * step_y]
}

fn search(points: &[[f64; 2]]) -> Option<[f64; 2]> {
    let mut best = start(points).and_then(|start| descend(points, start));
    let others = centres_among(points);
    if is_rough(points, best.as_ref()) && points.len() <= MOST_FOR_EVERY_START {
        for other in others {
            let other = descend(points, other);
            best = other.filter(|(_, sums)| is_less(points, sums.squares, best.as_ref())).or(best);
        }
    } else {
        let other = others.first().filter(|&&other| is_less(points, Sums::at(points, other).squares, best.as_ref()));
        let other = other.and_then(|&other| descend(points, other));
        best = other.filter(|(_, sums)| is_less(points, sums.squares, best.as_ref())).or(best);
    }
    let (centre, sums) = best?;
    // A straight line that fits better leaves no circle.
    (sums.squares < straight_squares(points)).then(|| polish(points, centre, sums))
}

/// Whether what was found is round to no more than half a hundredth of its radius, or of the half extent of the points where they
/// cover only an arc: then there may be many valleys.
fn is_rough(points: &[[f64; 2]], found: Option<&([f64; 2], Sums)>) -> bool {
    found.is_none_or(|&(centre, ref sums)| {
        let radius = norm(centre) + mean_excess(points, centre);
        (0.005 * radius.min(1.0)).powi(2) < sums.squares / count_f64(points.len())
    })
}

/// Whether a sum of squares is less than that of what was found, by more than rounding.
fn is_less(points: &[[f64; 2]], squares: f64, found: Option<&([f64; 2], Sums)>) -> bool {
    let rounding = count_f64(points.len()) * ROUNDING * ROUNDING;
    found.is_none_or(|(_, sums)| squares < sums.squares * (1.0 - 1e-9) - rounding)
}

/// Goes downhill from a centre to where no step helps; `None` towards a straight line.
fn descend(points: &[[f64; 2]], start: [f64; 2]) -> Option<([f64; 2], Sums)> {
    let mut centre = start;
    let mut sums = Sums::at(points, centre);
    for _ in 0..MOST_STEPS {
        let Some((better, better_sums)) = downhill(points, centre, &sums) else { break };
        let step = norm(minus(better, centre));
        centre = better;
        sums = better_sums;
        if FARTHEST < norm(centre) {
            return None;
        }
        if step <= 1e-9 * (1.0 + norm(centre)) {
            break;
        }
    }
    Some((centre, sums))
}

/// The centres of the circles through two (on a diameter) or three of some points, spread over all: that of the circle which is
/// closest to these points first.
fn centres_among(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let apart = points.len().div_ceil(SPREAD).max(1);
    let some: Vec<[f64; 2]> = points.iter().copied().step_by(apart).collect();
    let mut centres = Vec::new();
    for (number, &first) in some.iter().enumerate() {
        for (behind, &second) in some.iter().enumerate().skip(number + 1) {
            centres.push(midpoint(first, second));
            centres.extend(some.iter().skip(behind + 1).filter_map(|&third| circumcentre(first, second, third)));
        }
    }
    centres.retain(|&centre| norm(centre) <= FARTHEST);
    let mut centres: Vec<_> = centres.into_iter().map(|centre| (Sums::at(&some, centre).squares, centre)).collect();
    centres.sort_by(|(one, _), (other, _)| one.total_cmp(other));
    centres.into_iter().map(|(_, centre)| centre).collect()
}

/// A centre with a smaller sum of squares: by a Newton step, or by a Gauss-Newton step halved until it helps.
fn downhill(points: &[[f64; 2]], centre: [f64; 2], sums: &Sums) -> Option<([f64; 2], Sums)> {
    let improved = |step, part| {
        let there = moved(centre, step, part);
        let then = Sums::at(points, there);
        (then.squares < sums.squares).then_some((there, then))
    };
    if let Some(found) = sums.newton_step().and_then(|step| improved(step, 1.0)) {
        return Some(found);
    }
    let step = sums.gauss_step()?;
    let halvings = std::iter::successors(Some(1.0), |part| Some(part / 2.0));
    halvings.take(40).find_map(|part| improved(step, part))
}

/// Newton steps for as long as they get shorter, that is, to the last bit.
fn polish(points: &[[f64; 2]], centre: [f64; 2], sums: Sums) -> [f64; 2] {
    let mut centre = centre;
    let mut sums = sums;
    let mut before = 1e-4 * (1.0 + norm(centre));
    for _ in 0..6 {
        let Some(step) = sums.newton_step() else { break };
        let length = norm(step);
        if before <= length {
            break;
        }
        centre = moved(centre, step, 1.0);
        if length <= 1e-17 * (1.0 + norm(centre)) {
            break;
        }
        before = length;
        sums = Sums::at(points, centre);
    }
    centre
}

/// Means of products of the points' coordinates about their centroid.
struct Moments {
    centroid: [f64; 2],
    xx: f64,
    xy: f64,
    yy: f64,
    xz: f64,
    yz: f64,
    zz: f64,
}

impl Moments {
    fn of(points: &[[f64; 2]]) -> Self {
        let count = count_f64(points.len());
        let centroid = mean(points);
        let mut moments = Self { centroid, xx: 0.0, xy: 0.0, yy: 0.0, xz: 0.0, yz: 0.0, zz: 0.0 };
        for &point in points {
            let [x, y] = minus(point, centroid);
            let square = x * x + y * y;
            moments.xx += x * x / count;
            moments.xy += x * y / count;
            moments.yy += y * y / count;
            moments.xz += x * square / count;
            moments.yz += y * square / count;
            moments.zz += square * square / count;
        }
        moments
    }
}

/// Taubin's algebraic circle (Chernov: Newton's method for its characteristic polynomial), Kasa's where that fails.
fn start(points: &[[f64; 2]]) -> Option<[f64; 2]> {
    let moments = Moments::of(points);
    let Moments { centroid: [x, y], xx, xy, yy, xz, yz, zz } = moments;
    let mean_square = xx + yy;
    let determinant = xx * yy - xy * xy;
    let variance = zz - mean_square * mean_square;
    let cubic = 4.0 * mean_square;
    let quadratic = -3.0 * mean_square * mean_square - zz;
    let linear = variance * mean_square + 4.0 * determinant * mean_square - xz * xz - yz * yz;
    let constant = xz * (xz * yy - yz * xy) + yz * (yz * xx - xz * xy) - variance * determinant;
    let mut root: f64 = 0.0;
    let mut value = f64::INFINITY;
    for _ in 0..30 {
        let there = constant + root * (linear + root * (quadratic + root * cubic));
        let slope = linear + root * (2.0 * quadratic + root * 3.0 * cubic);
        if value <= there.abs() {
            break;
        }
        value = there.abs();
        root -= there / slope;
    }
    let centre = |root: f64| {
        let divisor = 2.0 * (root * root - root * mean_square + determinant);
        let centre = [x + (xz * (yy - root) - yz * xy) / divisor, y + (yz * (xx - root) - xz * xy) / divisor];
        (norm(centre) <= FARTHEST).then_some(centre)
    };
    centre(root).or_else(|| centre(0.0))
}

/// The sum of squared distances from the best straight line.
fn straight_squares(points: &[[f64; 2]]) -> f64 {
    let Moments { centroid, xx, xy, yy, .. } = Moments::of(points);
    // The direction of the line is half the angle of (xx - yy, 2 xy); distances are summed directly, because the
    // smaller eigenvalue of a nearly straight set would cancel.
    let angle = libm::atan2(2.0 * xy, xx - yy) / 2.0;
    let along = [libm::cos(angle), libm::sin(angle)];
    points.iter().map(|&point| cross(along, minus(point, centroid)).powi(2)).sum()
}
