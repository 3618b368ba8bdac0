//! What an evaluation cannot tell, and what is suspicious about its contacts.

use super::{Evaluation, MOST_FOR_ZONE};
use crate::message::{Say, printed};
use crate::probing::contact::Contact;

/// An arc from here on counts as half a circle or more: rounding may make a half circle a little too short.
const HALF_CIRCLE_DEG: f64 = 180.0 - 1e-6;

/// A chord that is shorter than its diameter by more than this gets a warning: 0.1 µm. Our choice.
const SHORT_CHORD_MM: f64 = 1e-4;

/// From which spread of heights on the contacts may not be those of one circle: half a millimetre, and for large circles a
/// tenth of the diameter. Our choice.
const HEIGHTS_MM: f64 = 0.5;
const HEIGHTS_OF_DIAMETER: f64 = 0.1;

/// At most this many warnings of a kind are listed: a file may hold a million repeated contacts.
const MOST_OF_A_KIND: usize = 5;

/// One warning about an evaluation.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "circle")]
pub enum CircleWarning {
    /// Three contacts.
    ThreeContacts,
    /// Four contacts.
    FourContacts,
    /// Less than half a circle.
    ShortArc {
        /// The covered arc in degrees, one decimal.
        #[say(with = printed)]
        arc: String,
        /// u(D) against 3 x 120°, one decimal.
        #[say(with = printed)]
        factor: String,
    },
    /// The minimum circumscribed circle of a short arc.
    CircumscribedOfShortArc,
    /// Two contacts at one place.
    #[say(id = "circle-counts-twice")]
    Coinciding {
        /// Number of the first, from 1.
        first: usize,
        /// Number of the second.
        second: usize,
    },
    /// No maximum inscribed circle.
    NoInscribed,
    /// A straight strip is narrower than every ring.
    NoZone,
    /// Too many contacts to examine every pair.
    #[say(args(most = MOST_FOR_ZONE))]
    TooManyContacts {
        /// How many.
        contacts: usize,
    },
    /// A two-point size whose chord misses the centre.
    ShortChord {
        /// Number of the first, from 1.
        first: usize,
        /// Number of the second.
        second: usize,
        /// By how much in micrometres, two decimals.
        #[say(with = printed)]
        short: String,
    },
    /// More warnings of the same kind as the one before.
    #[say(id = "circle-more-of-a-kind")]
    More {
        /// How many.
        more: usize,
    },
    /// The contacts lie at very different heights.
    Heights {
        /// The largest height minus the smallest in millimetres, three decimals.
        #[say(with = printed)]
        spread: String,
    },
    /// One contact lies apart from all others.
    Apart {
        /// Its number, from 1.
        contact: usize,
        /// Its residual in millimetres, four decimals.
        #[say(with = printed)]
        apart: String,
    },
}

impl CircleWarning {
    /// Whether it puts the least-squares diameter in doubt, other than by the number of contacts.
    pub const fn is_of_diameter(&self) -> bool {
        matches!(self, Self::ShortArc { .. } | Self::Coinciding { .. } | Self::Apart { .. } | Self::Heights { .. })
    }
}

/// All warnings about an evaluation.
pub(super) fn all(evaluation: &Evaluation, places: &[Contact], repeated: &[[usize; 2]]) -> Vec<CircleWarning> {
    let mut warnings = Vec::new();
    let contacts = evaluation.residuals.len();
    match contacts {
        3 => warnings.push(CircleWarning::ThreeContacts),
        4 => warnings.push(CircleWarning::FourContacts),
        _ => {}
    }
    if evaluation.arc_deg < HALF_CIRCLE_DEG {
        let factor = evaluation.uncertainty.against_three_by_120();
        let arc = format!("{:.1}", evaluation.arc_deg);
        warnings.push(CircleWarning::ShortArc { arc, factor: format!("{factor:.1}") });
        warnings.push(CircleWarning::CircumscribedOfShortArc);
    }
    let spread = heights(places, evaluation.least_squares.diameter);
    warnings.extend(spread.map(|spread| CircleWarning::Heights { spread: format!("{spread:.3}") }));
    let twice = repeated.iter().map(|&[first, second]| CircleWarning::Coinciding { first, second });
    warnings.extend(first_few(twice, repeated.len()));
    warnings.extend(apart(&evaluation.residuals));
    if MOST_FOR_ZONE < contacts {
        warnings.push(CircleWarning::TooManyContacts { contacts });
    } else {
        if evaluation.maximum_inscribed.is_none() {
            warnings.push(CircleWarning::NoInscribed);
        }
        if evaluation.minimum_zone.is_none() {
            warnings.push(CircleWarning::NoZone);
        }
    }
    let short: Vec<_> = evaluation.two_point.iter().filter(|size| SHORT_CHORD_MM < size.short_by).collect();
    let chords = short.iter().map(|size| {
        let [first, second] = size.contacts;
        CircleWarning::ShortChord { first, second, short: format!("{:.2}", size.short_by * 1000.0) }
    });
    warnings.extend(first_few(chords, short.len()));
    warnings
}

/// How much the heights of contacts differ in millimetres, where that is too much for one circle.
pub(in crate::probing) fn heights(contacts: &[Contact], diameter: f64) -> Option<f64> {
    let (least, most) = super::spread(contacts.iter().map(|contact| contact.z));
    let spread = most - least;
    // A spread that was written as half a millimetre is no more, whatever binary fractions make of it.
    (HEIGHTS_MM.max(HEIGHTS_OF_DIAMETER * diameter) + 1e-9 < spread).then_some(spread)
}

/// The first warnings of a kind, and how many more there are.
fn first_few(warnings: impl Iterator<Item = CircleWarning>, count: usize) -> impl Iterator<Item = CircleWarning> {
    let more = count.checked_sub(MOST_OF_A_KIND).filter(|&more| 0 < more);
    warnings.take(MOST_OF_A_KIND).chain(more.map(|more| CircleWarning::More { more }))
}

/// A contact whose residual is more than twice that of any other, among at least six contacts, and more than 1 µm.
fn apart(residuals: &[f64]) -> Option<CircleWarning> {
    let mut largest = 0.0_f64;
    let mut second = 0.0_f64;
    let mut contact = 0;
    for (number, residual) in (1..).zip(residuals) {
        if largest < residual.abs() {
            second = largest;
            largest = residual.abs();
            contact = number;
        } else {
            second = second.max(residual.abs());
        }
    }
    (6 <= residuals.len() && 0.001 < largest && 2.0 * second < largest)
        .then(|| CircleWarning::Apart { contact, apart: format!("{largest:.4}") })
}
