//! The sentences.

use fitcheck_statistics::{Advice, Tolerance, compare, offset, trend};

fn line(step: f64) -> Vec<f64> {
    (1..=50).map(|at| 25.0 + step * f64::from(at) + if at % 2 == 0 { 0.0005 } else { -0.0005 }).collect()
}

#[test]
fn an_offset_is_said_with_what_to_do() {
    let of = |um: f64| {
        let values: Vec<f64> = [-1.0, 1.0, 0.0, 0.5, -0.5, 0.0].iter().map(|off| (um + off) / 1_000.0).collect();
        Advice::of_offset(&offset(&values, 0.0, 0.001, 0.95).unwrap()).to_string()
    };
    assert_eq!(of(-4.2), "correct by +4 µm: the mean is 4.2 µm off the middle of the tolerance, 6 values");
    assert_eq!(of(3.0), "correct by -3 µm: the mean is 3.0 µm off the middle of the tolerance, 6 values");
    assert_eq!(
        of(0.1),
        "do not correct: the mean is 0.1 µm off the middle of the tolerance, which is noise with 6 values"
    );
    assert_eq!(of(0.9), "do not correct: the mean is 0.9 µm off the middle of the tolerance, 6 values");
}

#[test]
fn a_drift_is_said_with_where_the_size_is_now() {
    let found = offset(&line(0.0002), 25.0, 0.001, 0.95).unwrap();
    let said = Advice::of_offset(&found).to_string();
    assert_eq!(said, "correct by -10 µm: the size is now 10.0 µm off the middle of the tolerance, 50 values");
}

#[test]
fn a_trend_is_said_with_the_parts_that_are_left() {
    let limits = Tolerance::new(Some(24.9), Some(25.021)).unwrap();
    let of = |step: f64, limits: Option<&Tolerance>| {
        Advice::of_trend(&trend(&line(step), limits, 3.0, 0.95).unwrap(), 0.95).to_string()
    };
    assert_eq!(of(0.0, Some(&limits)), "no trend: the change from part to part is noise");
    assert_eq!(of(0.0002, None), "the size changes by +0.201 µm per part");
    let found = of(0.0002, Some(&limits));
    let begin = "the size changes by +0.201 µm per part: about 46 parts are left until the limit (95 %: ";
    assert!(found.starts_with(begin), "{found}");
    assert_eq!(
        of(0.001, Some(&limits)),
        "the size changes by +1.001 µm per part, and parts beyond the limit must be expected now"
    );
}

#[test]
fn groups_are_said_to_differ_or_not() {
    let of = |groups: [&[f64]; 2]| Advice::of_groups(&compare(groups, 0.95).unwrap(), 0.95).to_string();
    assert_eq!(of([&[1.0, 2.0, 3.0], &[1.1, 2.1, 2.9]]), "the groups do not differ more than by chance (p = 0.9679)");
    assert_eq!(of([&[1.0, 1.1, 1.2], &[5.0, 5.1, 5.2]]), "the groups differ (p = 0.0000)");
}
