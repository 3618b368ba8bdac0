//! Lines, trends, offsets and groups.

use fitcheck_statistics::{Line, Reason, Tolerance, compare, offset, trend};

use crate::simulated::Simulated;
use crate::{data, near, number, numbers, within};

fn upper(limit: f64) -> Tolerance {
    Tolerance::new(Some(-limit), Some(limit)).unwrap()
}

/// NIST `StRD`, `Norris`.
#[test]
fn the_line_has_its_certified_coefficients() {
    let set = &data("nist_strd.json")["linear"];
    let points: Vec<[f64; 2]> = serde_json::from_value(set["pairs"].clone()).unwrap();
    let line = Line::of(&points).unwrap();
    for (name, found) in [
        ("intercept", line.intercept.value),
        ("intercept_error", line.intercept.error),
        ("slope", line.slope.value),
        ("slope_error", line.slope.error),
        ("deviation", line.deviation),
        ("r2", line.explained),
    ] {
        near(found, number(&set[name]), 1e-11);
    }
}

/// NIST `StRD`, `SiRstv`: resistivity by five instruments.
#[test]
fn the_groups_have_their_certified_table() {
    let set = &data("nist_strd.json")["anova"];
    let groups: Vec<Vec<f64>> = serde_json::from_value(set["groups"].clone()).unwrap();
    let found = compare(groups.iter().map(Vec::as_slice), 0.95).unwrap();
    for (row, name) in [(found.between, "between"), (found.within, "within")] {
        let expected = numbers(&set[name]);
        near(row.degrees, expected[0], 1e-15);
        near(row.squares, expected[1], 1e-9);
        near(row.mean_square(), expected[2], 1e-9);
    }
    near(found.ratio.f, number(&set["f"]), 1e-9);
    near(found.within.mean_square().sqrt(), number(&set["deviation"]), 1e-9);
    near(found.between.squares / (found.between.squares + found.within.squares), number(&set["r2"]), 1e-9);
    // R: pf(1.18046237440255, 4, 20, lower.tail = FALSE).
    within(found.ratio.p, 0.349, 5e-4);
    assert_eq!(found.means.len(), 5);
}

/// Two groups: F is the square of Student's t with pooled variances, with the same probability.
#[test]
fn two_groups_are_compared_as_by_students_test() {
    let found = compare([[1.0, 2.0, 3.0].as_slice(), &[4.0, 6.0]], 0.95).unwrap();
    let pooled = (2.0 + 2.0) / 3.0;
    let t = 3.0 / (pooled * (1.0 / 3.0 + 0.5_f64)).sqrt();
    near(found.ratio.f, t * t, 1e-12);
    near(found.ratio.p, fitcheck_core::law::student_both(3.0, t), 1e-12);
}

#[test]
fn groups_that_cannot_be_compared_are_refused() {
    assert_eq!(compare([[1.0, 2.0].as_slice()], 0.95), Err(Reason::TooFew { found: 1, needed: 2 }));
    assert_eq!(compare([[1.0].as_slice(), &[2.0]], 0.95), Err(Reason::NoSubgroups));
    assert_eq!(compare([[1.0, 1.0].as_slice(), &[2.0, 2.0]], 0.95), Err(Reason::AllEqual));
    assert_eq!(compare([[1.0, 1.5].as_slice(), &[]], 0.95), Err(Reason::Empty));
}

#[test]
fn a_trend_says_how_many_parts_are_left() {
    // Rises by 0.01 a part about a scatter of ±0.01: the line is at 0.5 with the 50th part.
    let values: Vec<f64> = (1..=50).map(|at| 0.01 * f64::from(at) + if at % 2 == 0 { 0.01 } else { -0.01 }).collect();
    let found = trend(&values, Some(&upper(1.0)), 0.0, 0.95).unwrap();
    assert!(found.is_real());
    let reach = found.reach.unwrap();
    within(reach.parts.value, 50.0, 1.0);
    assert!(reach.parts.lower < 50.0 && 50.0 < reach.parts.upper && reach.parts.upper < 60.0);
    // With a reserve of 3 s the answer comes earlier.
    let early = trend(&values, Some(&upper(1.0)), 3.0, 0.95).unwrap().reach.unwrap();
    within(reach.parts.value - early.parts.value, 3.0 * found.line.deviation / found.line.slope.value, 1e-9);
    // Behind the limit no part is left; falling values go to the other limit.
    let over = trend(&values, Some(&upper(0.2)), 3.0, 0.95).unwrap().reach.unwrap();
    within(over.parts.upper, 0.0, 0.0);
    let falling: Vec<f64> = values.iter().map(|value| -value).collect();
    let down = trend(&falling, Some(&upper(1.0)), 0.0, 0.95).unwrap().reach.unwrap();
    within(down.limit, -1.0, 0.0);
    near(down.parts.value, reach.parts.value, 1e-12);
    // There is no limit on that side.
    let one = Tolerance::new(None, Some(1.0)).unwrap();
    assert!(trend(&falling, Some(&one), 3.0, 0.95).unwrap().reach.is_none());
}

#[test]
fn noise_is_no_trend() {
    let mut simulated = Simulated::of(5);
    let found = trend(&simulated.normals(30), Some(&upper(9.0)), 3.0, 0.95).unwrap();
    assert!(!found.is_real() && found.reach.is_none());
    let few = trend(&[1.0, 2.0], None, 3.0, 0.95);
    assert_eq!(few, Err(Reason::TooFew { found: 2, needed: 3 }));
    assert_eq!(trend(&[1.0, 1.0, 1.0], None, 3.0, 0.95), Err(Reason::AllEqual));
    assert_eq!(trend(&[1.0, 2.0, 3.0], None, 3.0, 0.95), Err(Reason::AllEqual));
    assert!(trend(&[1.0, 2.0, 3.5], None, -1.0, 0.95).is_err());
}

/// Of 5 000 series without a trend one in twenty seems to have one; the parts until a limit are held in 95 of 100.
#[test]
fn intervals_of_trends_hold_their_level() {
    let mut simulated = Simulated::of(13);
    let (mut false_alarms, mut held) = (0, 0);
    for _ in 0..5_000 {
        let noise = simulated.normals(30);
        false_alarms += u32::from(trend(&noise, None, 3.0, 0.95).unwrap().is_real());
        let rising: Vec<f64> = (1..).zip(&noise).map(|(at, noise)| 0.2 * f64::from(at) + noise).collect();
        // The line 0.2 x reaches 10 at x = 50, 20 parts after the last.
        let parts = trend(&rising, Some(&upper(10.0)), 0.0, 0.95).unwrap().reach.unwrap().parts;
        held += u32::from(parts.lower <= 20.0 && 20.0 <= parts.upper);
    }
    let [false_alarms, held] = [false_alarms, held].map(|count| f64::from(count) / 5_000.0);
    assert!((0.04..0.06).contains(&false_alarms), "{false_alarms}");
    assert!((0.94..0.96).contains(&held), "{held}");
}

/// The example of the request: the mean of 12 parts is 4.2 µm off the middle, so correct by 4 µm.
#[test]
fn an_offset_is_corrected_in_whole_steps_and_noise_is_left_alone() {
    let scatter = [-1.0, 1.0, 0.5, -0.5, 0.0, 0.0, 1.5, -1.5, 0.2, -0.2, 0.3, -0.3];
    let of = |um: f64| -> Vec<f64> { scatter.iter().map(|scatter| 25.0105 + (um + scatter) / 1_000.0).collect() };
    let found = offset(&of(-4.2), 25.0105, 0.001, 0.95).unwrap();
    assert_eq!(found.count, 12);
    within(found.distance.value, -0.0042, 1e-12);
    within(found.correction.unwrap(), 0.004, 1e-12);
    within(offset(&of(4.9), 25.0105, 0.001, 0.95).unwrap().correction.unwrap(), -0.004, 1e-12);
    assert_eq!(offset(&of(0.3), 25.0105, 0.001, 0.95).unwrap().correction, None);
    // Real, and less than a step.
    let small = offset(&of(0.8), 25.0105, 0.001, 0.95).unwrap();
    assert!(0.0 < small.distance.lower && small.correction.is_none());
    assert_eq!(offset(&[25.0], 25.0105, 0.001, 0.95), Err(Reason::TooFew { found: 1, needed: 2 }));
    assert!(offset(&of(1.0), 25.0105, 0.0, 0.95).is_err());
}

/// A drift that has come to the middle: its mean is off, and the tool is right now.
#[test]
fn a_drift_is_corrected_by_where_it_is_now() {
    let drift = |first: f64| -> Vec<f64> {
        (0..12).map(|at| first + f64::from(at) / 2_000.0 + if at % 2 == 0 { 0.0003 } else { -0.0003 }).collect()
    };
    let found = offset(&drift(25.005), 25.0105, 0.001, 0.95).unwrap();
    assert!(found.is_of_trend && found.correction.is_none(), "{found:?}");
    let mean = drift(25.005).iter().sum::<f64>() / 12.0;
    assert!(mean < 25.008);
    let late = offset(&drift(25.0102), 25.0105, 0.001, 0.95).unwrap();
    within(late.correction.unwrap(), -0.005, 1e-12);
    // The interval of the line at the mean of x is that of the mean of y about the line.
    let line = Line::of(&[[1.0, 2.0], [2.0, 2.5], [3.0, 3.5], [4.0, 3.8]]).unwrap();
    let half = fitcheck_core::law::student_factor(2.0, 0.95) * line.deviation / 2.0;
    near(line.at(2.5, 0.95).upper, 2.95 + half, 1e-12);
}
