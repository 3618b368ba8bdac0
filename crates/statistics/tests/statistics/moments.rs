//! Means and deviations, with the certified values of the NIST statistical reference datasets (`StRD`), univariate.

use fitcheck_statistics::{Moments, Reason, median};

use crate::{data, near, number, numbers};

/// `NumAcc1` to `NumAcc4`: the digits that change stand behind up to eight that do not.
#[test]
fn values_with_many_equal_digits_keep_their_spread() {
    let series = |first: f64, low: f64, high: f64| {
        let rest = (0..1_000).map(move |at| if at % 2 == 0 { low } else { high });
        std::iter::once(first).chain(rest).collect::<Vec<f64>>()
    };
    let cases = [
        (vec![10_000_001.0, 10_000_003.0, 10_000_002.0], 10_000_002.0, 1.0, 1e-15),
        (series(1.2, 1.1, 1.3), 1.2, 0.1, 1e-13),
        (series(1_000_000.2, 1_000_000.1, 1_000_000.3), 1_000_000.2, 0.1, 2e-9),
        // The decimals of the data themselves are not exact in 64 bits: eight digits are the most that any program gets.
        (series(10_000_000.2, 10_000_000.1, 10_000_000.3), 10_000_000.2, 0.1, 2e-8),
    ];
    for (values, mean, deviation, share) in cases {
        let found = Moments::of(&values).unwrap();
        near(found.mean, mean, 1e-15);
        near(found.deviation().unwrap(), deviation, share);
    }
}

/// `Lew`, `Lottery`, `Mavro`, `Michelso` and `PiDigits`.
#[test]
fn the_reference_sets_have_their_certified_moments() {
    let sets = data("nist_strd.json");
    let sets = sets["univariate"].as_array().unwrap();
    assert_eq!(sets.len(), 5);
    for set in sets {
        let found = Moments::of(&numbers(&set["data"])).unwrap();
        near(found.mean, number(&set["mean"]), 1e-14);
        near(found.deviation().unwrap(), number(&set["deviation"]), 1e-13);
    }
}

#[test]
fn what_has_no_spread_is_refused_with_a_reason() {
    assert_eq!(Moments::of(&[]), Err(Reason::Empty));
    assert_eq!(Moments::of(&[1.0, f64::NAN]), Err(Reason::NotANumber { place: 2 }));
    assert_eq!(Moments::of(&[1.0]).unwrap().deviation(), Err(Reason::TooFew { found: 1, needed: 2 }));
    assert_eq!(Moments::of(&[0.1; 7]).unwrap().deviation(), Err(Reason::AllEqual));
    assert!(Moments::of(&[1.0, 2.0]).unwrap().mean_estimate(1.0).is_err());
}

#[test]
fn the_median_is_the_middle_or_the_mean_of_the_two_middle_ones() {
    assert_eq!(median(&[3.0, 1.0, 2.0]), Ok(2.0));
    assert_eq!(median(&[4.0, 1.0, 2.0, 3.0]), Ok(2.5));
    assert_eq!(median(&[]), Err(Reason::Empty));
}
