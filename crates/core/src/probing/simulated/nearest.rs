//! Where a ball meets a wavy contour: nearest points, and the way until none is nearer than the ball's radius.

/// How many of the lowest samples are searched closely: few waves have nearly the same distance.
const CANDIDATES: usize = 4;

/// The ratio of the golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// This close counts as a contact, mm: the last bits of coordinates up to a hundred metres.
const TOUCHING: f64 = 1e-12;

/// This close counts as a contact where the way along the contour is endless, mm.
const GRAZING: f64 = 1e-9;

/// The most steps of one way.
const MOST_STEPS: usize = 2_000;

/// The least value of a function between two places: `samples` samples, then a search to the last bits.
pub(super) fn least(value: impl Fn(f64) -> f64, from: f64, to: f64, samples: u32) -> f64 {
    let step = (to - from) / f64::from(samples.max(2));
    let mut lowest: Vec<(f64, f64)> = Vec::with_capacity(CANDIDATES + 1);
    let mut before = f64::INFINITY;
    let mut here = value(from);
    for sample in 0..=samples.max(2) {
        let place = from + step * f64::from(sample);
        let after = value(place + step);
        if here <= before && here <= after {
            let at = lowest.partition_point(|(known, _)| *known < here);
            lowest.insert(at, (here, place));
            lowest.truncate(CANDIDATES);
        }
        before = here;
        here = after;
    }
    lowest.iter().map(|&(_, place)| section(&value, place - step, place + step)).fold(f64::INFINITY, f64::min)
}

/// The least value between two places with one valley between them.
fn section(value: &impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> f64 {
    let mut left = to - GOLDEN * (to - from);
    let mut right = from + GOLDEN * (to - from);
    let mut at_left = value(left);
    let mut at_right = value(right);
    for _ in 0..80 {
        if at_left <= at_right {
            to = right;
            right = left;
            at_right = at_left;
            left = to - GOLDEN * (to - from);
            at_left = value(left);
        } else {
            from = left;
            left = right;
            at_left = at_right;
            right = from + GOLDEN * (to - from);
            at_right = value(right);
        }
    }
    at_left.min(at_right)
}

/// How far a ball can move until the gap to the contour is closed, at most `farthest`; `None` where it stays open.
///
/// A step as long as the gap never leads through the contour.
pub(super) fn trace(gap: impl Fn(f64) -> f64, farthest: f64) -> Option<f64> {
    let mut gone = 0.0;
    let mut open = gap(gone);
    for _ in 0..MOST_STEPS {
        if open <= TOUCHING {
            return Some(gone);
        }
        gone += open;
        if farthest < gone {
            return None;
        }
        open = gap(gone);
    }
    (open <= GRAZING).then_some(gone)
}

/// The most steps of a way past several features.
const MOST_STEPS_PAST: usize = 100_000;

/// A way past several features.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Way {
    /// It is free to its end.
    Free,
    /// The gap is closed after so much of it.
    Closed(f64),
}

/// Follows a way until the gap is closed, or to its end.
pub(super) fn follow(gap: impl Fn(f64) -> f64, length: f64) -> Way {
    let mut gone = 0.0;
    for _ in 0..MOST_STEPS_PAST {
        let open = gap(gone);
        if open <= TOUCHING {
            return Way::Closed(gone);
        }
        if length <= gone {
            return Way::Free;
        }
        gone = (gone + open).min(length);
    }
    Way::Closed(gone)
}

/// How far a ball can move past several features until the gap to one of them is closed, at most `farthest`; `None`
/// where it stays open.
pub(super) fn advance(gap: impl Fn(f64) -> f64, farthest: f64) -> Option<f64> {
    match follow(&gap, farthest) {
        Way::Closed(gone) => (gap(gone) <= GRAZING).then_some(gone),
        Way::Free => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lowest_valley_is_found_to_the_last_bits() {
        let waves = |x: f64| libm::cos(5.0 * x) + 0.01 * (x - 2.0).powi(2);
        // The valley at 3 π / 5 lies nearest to 2.
        let place = 3.0 * std::f64::consts::PI / 5.0;
        let found = least(waves, 0.0, 6.0, 64);
        assert!((waves(place) - 2e-5..=waves(place)).contains(&found), "{found}");
        assert!((least(|x| (x - 1.0).abs(), 0.0, 3.0, 7)).abs() < 1e-12);
    }

    #[test]
    fn a_way_ends_at_the_contour_or_never() {
        assert!((trace(|gone| 3.0 - gone, 10.0).unwrap() - 3.0).abs() < 1e-12);
        assert_eq!(trace(|gone| 30.0 - gone, 10.0), None);
        assert_eq!(trace(|gone| 1.0 + gone, 10.0), None);
    }
}
