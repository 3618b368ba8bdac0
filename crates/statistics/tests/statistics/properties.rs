//! What must hold of any series, and how long charts run.

use fitcheck_statistics::gauge::{StudyPlan, crossed};
use fitcheck_statistics::{
    CapabilityPlan, ChartKind, ChartPlan, Cusum, Ewma, Method, Rules, Sample, Scanner, Tolerance, capability, chart,
    compare, count, trend,
};
use proptest::prelude::*;

use crate::near;
use crate::simulated::Simulated;

/// Values with a spread, of sizes as shops measure them.
fn series() -> impl Strategy<Value = Vec<f64>> {
    proptest::collection::vec(-1_000_i32..1_000, 8..60)
        .prop_filter("no spread", |values| values.iter().any(|value| value != &values[0]))
        .prop_map(|values| values.into_iter().map(|value| 25.0 + f64::from(value) / 1e5).collect())
}

fn indices(values: &[f64], limits: [f64; 2]) -> Option<[f64; 6]> {
    let plan = CapabilityPlan::of(Tolerance::new(Some(limits[0]), Some(limits[1])).unwrap(), Method::MovingRange);
    let found = capability(values.chunks(1), &plan).unwrap();
    let inside = found.within.ok()?;
    let overall = found.overall;
    let cp = inside.potential.unwrap();
    Some([cp.value, cp.upper, inside.actual.value, overall.actual.lower, overall.ppm.value, overall.ppm.upper])
}

proptest! {
    /// Another unit and another zero change no index.
    #[test]
    fn shift_and_scale_change_no_index(values in series(), scale in 0.1_f64..40.0, shift in -50.0_f64..50.0) {
        let moved = |value: f64| scale * value + shift;
        let there: Vec<f64> = values.iter().map(|value| moved(*value)).collect();
        let limits = [24.99, 25.008];
        let (here, there) = (indices(&values, limits), indices(&there, limits.map(moved)));
        let (here, there) = (here.unwrap(), there.unwrap());
        for (here, there) in here.into_iter().zip(there) {
            prop_assert!((here - there).abs() <= 1e-6 * here.abs().max(1e-3), "{here} and {there}");
        }
    }

    /// Values and limits turned about 25: Cpk stays, the sides change places.
    #[test]
    fn reflection_exchanges_the_sides(values in series()) {
        let turned: Vec<f64> = values.iter().map(|value| 50.0 - value).collect();
        let of = |values: &[f64], lower, upper| {
            let plan = CapabilityPlan::of(Tolerance::new(Some(lower), Some(upper)).unwrap(), Method::Overall);
            capability(values.chunks(1), &plan).unwrap().overall
        };
        let (here, there) = (of(&values, 24.99, 25.008), of(&turned, 24.992, 25.01));
        near(there.actual.value, here.actual.value, 1e-8);
        near(there.lower.unwrap().index.upper, here.upper.unwrap().index.upper, 1e-8);
        near(there.about_target.unwrap().value, here.about_target.unwrap().value, 1e-8);
    }

    /// A chart turned upside down fires the same rules.
    #[test]
    fn reflection_fires_the_same_rules(values in series()) {
        let of = |values: &[f64]| {
            let samples: Vec<Sample> = values.iter().map(|value| Sample::of(vec![*value])).collect();
            let plan = ChartPlan { rules: Rules::NELSON, ..ChartPlan::of(ChartKind::Individuals) };
            chart(&samples, &plan).unwrap()
        };
        // About zero, so that the differences are exact.
        let small: Vec<f64> = values.iter().map(|value| ((value - 25.0) * 1e5).round()).collect();
        let turned: Vec<f64> = small.iter().map(|value| -value).collect();
        for (here, there) in of(&small).points.iter().zip(of(&turned).points) {
            prop_assert_eq!(here.location.fired, there.location.fired);
        }
    }

    /// The order of groups and of the values in them counts for nothing where time does not.
    #[test]
    fn the_order_of_groups_changes_nothing(mut groups in proptest::collection::vec(proptest::collection::vec(0.0_f64..1.0, 2..6), 2..8), turn in 0_usize..7) {
        let before = compare(groups.iter().map(Vec::as_slice), 0.95).unwrap();
        let limits = Tolerance::new(Some(-0.5), Some(1.5)).unwrap();
        let capable = |groups: &[Vec<f64>]| capability(groups.iter().map(Vec::as_slice), &CapabilityPlan::of(limits, Method::Ranges)).unwrap();
        let was = capable(&groups);
        let turn = turn % groups.len();
        groups.rotate_left(turn);
        for group in &mut groups {
            group.reverse();
        }
        let after = compare(groups.iter().map(Vec::as_slice), 0.95).unwrap();
        prop_assert!((before.ratio.f - after.ratio.f).abs() <= 1e-8 * (1.0 + before.ratio.f));
        let is = capable(&groups);
        near(is.within.unwrap().actual.value, was.within.unwrap().actual.value, 1e-9);
    }

    /// Squares add up, and a study's components do not change with the order of its parts.
    #[test]
    fn the_squares_of_a_study_add_up(cells in proptest::collection::vec(proptest::collection::vec(proptest::collection::vec(0.0_f64..1.0, 3), 2), 3..6)) {
        let plan = StudyPlan { keeps: 1.0, ..StudyPlan::default() };
        let found = crossed(&cells, &plan).unwrap();
        let all = cells.concat().concat();
        let mean = all.iter().sum::<f64>() / count(all.len());
        let total: f64 = all.iter().map(|value| (value - mean).powi(2)).sum();
        let sum = found.part.0.squares + found.operator.unwrap().0.squares + found.interaction.unwrap().0.squares + found.repeatability.squares;
        prop_assert!((sum - total).abs() <= 1e-9 * total);
        let turned: Vec<_> = cells.iter().rev().cloned().collect();
        let turned = crossed(&turned, &plan).unwrap();
        prop_assert!((turned.gauge.upper - found.gauge.upper).abs() <= 1e-9);
    }

    /// The slope of a series turned in time is the other way round.
    #[test]
    fn a_series_backwards_has_the_slope_backwards(values in series()) {
        let backwards: Vec<f64> = values.iter().rev().copied().collect();
        if let (Ok(here), Ok(there)) = (trend(&values, None, 3.0, 0.95), trend(&backwards, None, 3.0, 0.95)) {
            prop_assert!((here.slope.value + there.slope.value).abs() <= 1e-9 * here.slope.value.abs().max(1e-6));
        }
    }
}

/// The mean number of points until an alarm, with its standard error.
fn run_length(runs: usize, mut until: impl FnMut() -> f64) -> [f64; 2] {
    let lengths: Vec<f64> = (0..runs).map(|_| until()).collect();
    let mean = lengths.iter().sum::<f64>() / count(runs);
    let square = lengths.iter().map(|length| (length - mean).powi(2)).sum::<f64>() / count(runs);
    [mean, (square / count(runs)).sqrt()]
}

#[track_caller]
fn is_about([mean, error]: [f64; 2], published: f64, share: f64) {
    assert!((mean - published).abs() <= 3.5 * error + share * published, "{mean} ± {error} is not {published}");
}

/// Champ and Woodall 1987 (figures remembered): 370.40 points for one beyond 3 s, 91.75 for the four rules of Western Electric.
#[test]
fn rules_run_as_long_as_published() {
    let mut simulated = Simulated::of(17);
    for (rules, shift, published) in [
        (Rules::NONE.with(fitcheck_statistics::Rule::BeyondLimits, true), 0.0, 370.40),
        (Rules::WESTERN_ELECTRIC, 0.0, 91.75),
        (Rules::WESTERN_ELECTRIC, 1.0, 9.22),
    ] {
        let found = run_length(8_000, || {
            let mut scanner = Scanner::default();
            let mut points = 0.0;
            loop {
                points += 1.0;
                let z = simulated.normal() + shift;
                if !rules.both(scanner.next(z, z)).is_empty() {
                    return points;
                }
            }
        });
        is_about(found, published, 5e-4);
    }
}

/// Nelson's rules in a stable process: how many points in ten thousand fire (computed over four million points elsewhere).
#[test]
fn rules_fire_as_seldom_as_computed() {
    let mut simulated = Simulated::of(19);
    let mut scanner = Scanner::default();
    let number = 2_000_000;
    let mut fired = [0.0; 9];
    for _ in 0..number {
        let z = simulated.normal();
        let rules = scanner.next(z, z);
        for (count, rule) in fired.iter_mut().zip(fitcheck_statistics::Rule::ALL) {
            *count += f64::from(u8::from(rules.has(rule)));
        }
    }
    for (found, expected) in fired.iter().zip([27.0, 39.0, 28.0, 45.0, 21.0, 45.0, 33.0, 1.0]) {
        let found = found / f64::from(number) * 1e4;
        assert!((found - expected).abs() <= 2.5, "{found} is not {expected}");
    }
}

/// Montgomery, table 9.3 (remembered): k = 0.5 and h = 5 run 465 points, 10.4 at a shift of 1 s, 4.01 at 2 s; h = 4 runs 168.
/// Lucas and Saccucci 1990 (remembered): λ = 0.1 and L = 2.814 run 500 points and 10.3 at 1 s, with steady limits.
#[test]
fn cusum_and_ewma_run_as_long_as_published() {
    let mut simulated = Simulated::of(23);
    let mut of = |cusum: Cusum, shift: f64| {
        run_length(2_000, || {
            let values: Vec<f64> = (0..4_000).map(|_| simulated.normal() + shift).collect();
            let points = cusum.points(&values, 0.0, 1.0).unwrap();
            count(1 + points.iter().position(fitcheck_statistics::CusumPoint::is_out).unwrap_or(values.len()))
        })
    };
    is_about(of(Cusum::default(), 0.0), 465.0, 5e-3);
    is_about(of(Cusum::default(), 1.0), 10.4, 5e-3);
    is_about(of(Cusum::default(), 2.0), 4.01, 5e-3);
    is_about(of(Cusum { allowance: 0.5, interval: 4.0 }, 0.0), 168.0, 5e-3);
    let mut of = |shift: f64| {
        run_length(2_000, || {
            let values: Vec<f64> = (0..4_000).map(|_| simulated.normal() + shift).collect();
            let ewma = Ewma { weight: 0.1, width: 2.814 };
            let points = ewma.points(&values, 0.0, 1.0).unwrap();
            // The limits of the source are those of many points.
            let limit = points.last().unwrap().upper;
            count(1 + points.iter().position(|point| limit < point.value.abs()).unwrap_or(values.len()))
        })
    };
    is_about(of(0.0), 500.0, 5e-3);
    is_about(of(1.0), 10.3, 5e-3);
}
