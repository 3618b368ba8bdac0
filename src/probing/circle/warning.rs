//! What an evaluation cannot tell, and what is suspicious about its contacts.

use super::{Evaluation, MOST_FOR_ZONE};
use crate::message::{Message, Say};

/// An arc from here on counts as half a circle or more: a half circle may come out a rounding short.
const HALF_CIRCLE_DEG: f64 = 180.0 - 1e-6;

/// A chord shorter than its diameter by more than this is named: 0.1 µm. Ours.
const SHORT_CHORD_MM: f64 = 1e-4;

/// So many warnings of a kind are listed: a file may hold a million repeated contacts.
const MOST_OF_A_KIND: usize = 5;

/// One remark on an evaluation.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CircleWarning {
    /// Three contacts.
    #[error("3 contacts: form cannot be measured, the residual is always zero")]
    ThreeContacts,
    /// Four contacts.
    #[error("4 contacts: four lobes are not detected and change the diameter")]
    FourContacts,
    /// Less than half a circle.
    #[error(
        "the contacts cover only {arc}° of arc: scatter in the diameter is {factor} times that of 3 contacts at 120°"
    )]
    ShortArc {
        /// The covered arc in degrees, one decimal.
        arc: String,
        /// u(D) against 3 x 120°, one decimal.
        factor: String,
    },
    /// The minimum circumscribed circle of a short arc.
    #[error("the minimum circumscribed circle of a short arc is not the size of the feature")]
    CircumscribedOfShortArc,
    /// Two contacts at one place.
    #[error("contacts {first} and {second} coincide: this place counts twice")]
    Coinciding {
        /// Number of the first, from 1.
        first: usize,
        /// Number of the second.
        second: usize,
    },
    /// No maximum inscribed circle.
    #[error("there is no maximum inscribed circle: the contacts do not surround one")]
    NoInscribed,
    /// A straight strip is narrower than every ring.
    #[error("there is no minimum zone: a straight strip is narrower than every ring")]
    NoZone,
    /// Too many contacts to look at every pair.
    #[error(
        "maximum inscribed circle and minimum zone are not computed for {contacts} contacts: at most {MOST_FOR_ZONE}"
    )]
    TooManyContacts {
        /// How many.
        contacts: usize,
    },
    /// A two-point size beside the centre.
    #[error(
        "contacts {first} and {second} are opposite each other but off the centre: this size is {short} µm too small"
    )]
    ShortChord {
        /// Number of the first, from 1.
        first: usize,
        /// Number of the second.
        second: usize,
        /// By how much in micrometres, two decimals.
        short: String,
    },
    /// More warnings of the same kind as the one before.
    #[error("the same holds for {more} more")]
    More {
        /// How many.
        more: usize,
    },
    /// One contact lies apart from all others.
    #[error("contact {contact} lies {apart} mm off the circle, far more than the others: dust or a false trigger?")]
    Apart {
        /// Its number, from 1.
        contact: usize,
        /// Its residual in millimetres, four decimals.
        apart: String,
    },
}

impl Say for CircleWarning {
    fn message(&self) -> Message {
        match self {
            Self::ThreeContacts => Message::new("circle-three-contacts"),
            Self::FourContacts => Message::new("circle-four-contacts"),
            Self::ShortArc { arc, factor } => Message::new("circle-short-arc").text("arc", arc).text("factor", factor),
            Self::CircumscribedOfShortArc => Message::new("circle-circumscribed-of-short-arc"),
            Self::Coinciding { first, second } => {
                Message::new("circle-counts-twice").text("first", first).text("second", second)
            }
            Self::NoInscribed => Message::new("circle-no-inscribed"),
            Self::NoZone => Message::new("circle-no-zone"),
            Self::TooManyContacts { contacts } => {
                Message::new("circle-too-many-contacts").text("contacts", contacts).text("most", MOST_FOR_ZONE)
            }
            Self::ShortChord { first, second, short } => {
                Message::new("circle-short-chord").text("first", first).text("second", second).text("short", short)
            }
            Self::More { more } => Message::new("circle-more-of-a-kind").text("more", more),
            Self::Apart { contact, apart } => {
                Message::new("circle-apart").text("contact", contact).text("apart", apart)
            }
        }
    }
}

/// All remarks on an evaluation.
pub(super) fn all(evaluation: &Evaluation, repeated: &[[usize; 2]]) -> Vec<CircleWarning> {
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

/// The first warnings of a kind, and how many more there are.
fn first_few(warnings: impl Iterator<Item = CircleWarning>, count: usize) -> impl Iterator<Item = CircleWarning> {
    let more = count.checked_sub(MOST_OF_A_KIND).filter(|&more| 0 < more);
    warnings.take(MOST_OF_A_KIND).chain(more.map(|more| CircleWarning::More { more }))
}

/// A contact whose residual is more than twice that of any other, among at least six contacts, and more than 1 µm.
fn apart(residuals: &[f64]) -> Option<CircleWarning> {
    let (mut largest, mut second, mut contact) = (0.0_f64, 0.0_f64, 0);
    for (number, residual) in (1..).zip(residuals) {
        if largest < residual.abs() {
            (second, largest, contact) = (largest, residual.abs(), number);
        } else {
            second = second.max(residual.abs());
        }
    }
    (6 <= residuals.len() && 0.001 < largest && 2.0 * second < largest)
        .then(|| CircleWarning::Apart { contact, apart: format!("{largest:.4}") })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{Language, Words};

    #[track_caller]
    fn check(warning: &CircleWarning, expected: &str) {
        assert_eq!(warning.to_string(), expected);
        assert_eq!(Words::new(Language::En).told(warning), expected);
        assert_ne!(Words::new(Language::Nl).told(warning), warning.message().id);
    }

    #[test]
    fn every_warning_has_its_words() {
        let text = ToString::to_string;
        check(&CircleWarning::ThreeContacts, "3 contacts: form cannot be measured, the residual is always zero");
        check(&CircleWarning::FourContacts, "4 contacts: four lobes are not detected and change the diameter");
        check(
            &CircleWarning::ShortArc { arc: text("120.0"), factor: text("3.0") },
            "the contacts cover only 120.0° of arc: scatter in the diameter is 3.0 times that of 3 contacts at 120°",
        );
        check(
            &CircleWarning::CircumscribedOfShortArc,
            "the minimum circumscribed circle of a short arc is not the size of the feature",
        );
        check(&CircleWarning::Coinciding { first: 1, second: 4 }, "contacts 1 and 4 coincide: this place counts twice");
        check(&CircleWarning::NoInscribed, "there is no maximum inscribed circle: the contacts do not surround one");
        check(&CircleWarning::NoZone, "there is no minimum zone: a straight strip is narrower than every ring");
        check(
            &CircleWarning::TooManyContacts { contacts: 100_000 },
            "maximum inscribed circle and minimum zone are not computed for 100000 contacts: at most 3000",
        );
        check(
            &CircleWarning::ShortChord { first: 1, second: 3, short: text("0.80") },
            "contacts 1 and 3 are opposite each other but off the centre: this size is 0.80 µm too small",
        );
        check(&CircleWarning::More { more: 7 }, "the same holds for 7 more");
        check(
            &CircleWarning::Apart { contact: 9, apart: text("3.0123") },
            "contact 9 lies 3.0123 mm off the circle, far more than the others: dust or a false trigger?",
        );
    }
}
