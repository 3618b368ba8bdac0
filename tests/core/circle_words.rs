//! The messages about contacts that make no circle, or a doubtful one.

use fitcheck::probing::Contact;
use fitcheck::probing::circle::{CircleWarning, evaluate};

#[track_caller]
fn check(points: &[[f64; 2]], expected: &str) {
    let contacts: Vec<_> = points.iter().map(|&[x, y]| Contact { x, y, z: 0.0 }).collect();
    let said = match evaluate(&contacts) {
        Ok(evaluation) => format!("{:?}", evaluation.least_squares),
        Err(error) => error.to_string(),
    };
    assert_eq!(said, expected);
}

#[test]
fn says_why_contacts_are_no_circle() {
    check(&[], "a circle needs at least 3 contacts, found 0");
    check(&[[1.0, 2.0], [3.0, 4.0]], "a circle needs at least 3 contacts, found 2");
    let coincide = "contacts 1 and 3 coincide at x = 1, y = 2: a circle needs 3 different points";
    check(&[[1.0, 2.0], [3.0, 4.0], [1.0, 2.0]], coincide);
    check(&[[1.0, 2.0], [3.0, 4.0], [1.0, 2.0], [3.0, 4.0]], coincide);
    let all = "contacts 1 and 2 coincide at x = 5, y = 5: a circle needs 3 different points";
    check(&[[5.0, 5.0]; 4], all);
    check(&[[0.0, 0.0]; 3], "contacts 1 and 2 coincide at x = 0, y = 0: a circle needs 3 different points");
    let line = "all 3 contacts lie on one straight line: no circle goes through them";
    check(&[[0.1, 0.1], [0.2, 0.2], [0.3, 0.3]], line);
    check(&[[1000.1, 7.0], [1000.2, 7.0], [1000.7, 7.0]], line);
    check(&[[1e6 + 0.1, 0.7], [1e6 + 0.2, 1.4], [1e6 + 0.4, 2.8]], line);
    // Upright, and off by the last bit of a coordinate: what counts is the longest distance between two of them.
    check(&[[1e6, 0.0], [1e6 + 1.2e-10, 1.0], [1e6, 500.0]], line);
    // Too small to be told apart, and not divided by their extent.
    check(&[[0.0, 0.0], [1e-310, 0.0], [0.0, 1e-310]], line);
    check(&[[0.0, 0.0], [1.0, f64::NAN], [2.0, 2.0]], "contact 2: y = NaN is not a finite number");
    check(&[[0.0, 0.0], [1.0, 1.0], [f64::NEG_INFINITY, 2.0]], "contact 3: x = -inf is not a finite number");
    check(
        &[[0.0, 0.0], [1.0, 1.0], [0.0, 2e9]],
        "contact 3: y = 2000000000 mm is too large: at most 1000000000 mm either way",
    );
    for (y, shown) in [(1e15, "1e15"), (-1e300, "-1e300"), (999_999_999_999_999.0, "999999999999999")] {
        let said = format!("contact 3: y = {shown} mm is too large: at most 1000000000 mm either way");
        check(&[[0.0, 0.0], [1.0, 1.0], [0.0, y]], &said);
    }
    check(&[[1e9, 0.0], [1e9 - 1.0, 1.0], [1e9 - 2.0, 0.0]], "Circle { x: 999999999.0, y: 0.0, diameter: 2.0 }");
    check(
        &[[0.0, 0.0], [1.0, 1e-3], [2.0, -1e-3], [3.0, 0.0]],
        "the 4 contacts fit a straight line better than any circle",
    );
}

#[test]
fn two_at_one_place_among_three_others_only_warn() {
    check(&[[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [1.0, 0.0]], "Circle { x: 0.0, y: 0.0, diameter: 2.0 }");
}

#[track_caller]
fn check_words(warning: &CircleWarning, expected: &str) {
    assert_eq!(warning.to_string(), expected);
}

#[test]
fn every_warning_has_its_words() {
    let text = ToString::to_string;
    check_words(&CircleWarning::ThreeContacts, "3 contacts: form cannot be measured, the residual is always zero");
    check_words(&CircleWarning::FourContacts, "4 contacts: four lobes are not detected and change the diameter");
    check_words(
        &CircleWarning::ShortArc { arc: text("120.0"), factor: text("3.0") },
        "the contacts cover only 120.0° of arc: scatter in the diameter is 3.0 times that of 3 contacts at 120°",
    );
    check_words(
        &CircleWarning::CircumscribedOfShortArc,
        "the minimum circumscribed circle of a short arc is not the size of the feature",
    );
    check_words(
        &CircleWarning::Coinciding { first: 1, second: 4 },
        "contacts 1 and 4 coincide: this place counts twice",
    );
    check_words(&CircleWarning::NoInscribed, "no maximum inscribed circle: the contacts do not surround one");
    check_words(&CircleWarning::NoZone, "no minimum zone: a straight strip is narrower than any ring");
    check_words(
        &CircleWarning::TooManyContacts { contacts: 100_000 },
        "maximum inscribed circle and minimum zone are not computed for 100000 contacts: at most 3000",
    );
    check_words(
        &CircleWarning::ShortChord { first: 1, second: 3, short: text("0.80") },
        "contacts 1 and 3 are opposite each other but off the centre: this size is 0.80 µm too small",
    );
    check_words(&CircleWarning::More { more: 7 }, "the same applies to 7 more");
    check_words(
        &CircleWarning::Apart { contact: 9, apart: text("3.0123") },
        "contact 9 lies 3.0123 mm off the circle, far more than the others: dust or a false trigger?",
    );
}
