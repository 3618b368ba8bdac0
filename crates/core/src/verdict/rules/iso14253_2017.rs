//! ISO 14253-1:2017: conformity is proven where its probability is 95 % or more, nonconformity where that of conformity is 5 % or
//! less and the value lies beyond a limit: with an uncertainty much larger than the zone it is less everywhere. Both limits count, exactly
//! (metrology.md, section 5: 1.645 u where the tolerance is six or more u wide).

use super::{Bands, Conformity, Declaration, RuleInputs, Use};
use crate::length::Length;
use crate::tolerance::Bounds;

pub(super) const DECLARATION: Declaration = Declaration {
    name: "iso14253-2017",
    text: "rule-iso14253-2017",
    how: Use::Proof,
    takes_factor: false,
    takes_width: false,
    bands: Some(bands),
};

/// The probability that is asked for.
const PROOF: f64 = 0.95;

fn bands(given: &RuleInputs, bounds: &Bounds) -> Bands {
    let Some(uncertainty) = given.uncertainty else {
        return Bands { conforming: Some(Length::ZERO), nonconforming: Length::ZERO };
    };
    let [minimum, maximum] = [bounds.minimum(), bounds.maximum()].map(Length::nanometres);
    let within = |place: i64| {
        let farthest = if place < 0 { Length::MAX.negated() } else { Length::MAX };
        let place = Length::from_nanometres(place).unwrap_or(farthest);
        Conformity::of(bounds, place, uncertainty).within
    };
    // The probability rises from far outside up to the middle, on either side in the same way.
    let half = (maximum - minimum) / 2;
    let conforming = first(0, half, |band| PROOF <= within(minimum + band));
    // Ten standard uncertainties beyond a limit the probability is below 1e-22.
    let far = uncertainty.times(10_000);
    // A missing limit is the largest length there is: nothing lies beyond it.
    let has_minimum = bounds.minimum() != Length::MAX.negated();
    let beyond = |band: i64| if has_minimum { minimum - band } else { maximum + band };
    let nonconforming = first(0, far, |band| within(beyond(band)) <= 1.0 - PROOF).unwrap_or(far);
    let length = |nm: i64| Length::from_nanometres(nm).unwrap_or(Length::MAX);
    Bands { conforming: conforming.map(length), nonconforming: length(nonconforming) }
}

/// The smallest whole number of a range for which something holds that holds for all larger ones.
fn first(least: i64, most: i64, holds: impl Fn(i64) -> bool) -> Option<i64> {
    let mut least = least;
    let mut most = most;
    if !holds(most) {
        return None;
    }
    while least < most {
        let middle = least + (most - least) / 2;
        if holds(middle) {
            most = middle;
        } else {
            least = middle + 1;
        }
    }
    Some(most)
}
