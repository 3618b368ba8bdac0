//! Constants, charts, rules, EWMA and CUSUM.

use std::sync::Arc;

use fitcheck_core::law::normal;
use fitcheck_statistics::{
    Baseline, ChartKind, ChartPlan, Cusum, Ewma, Method, Reason, Rule, Rules, Sample, Scanner, Stage, c4, chart, count,
    d2, d3,
};

use crate::{data, near, number, numbers, printed, study, within};

pub(crate) fn singles(values: &[f64]) -> Vec<Sample> {
    values.iter().map(|value| Sample::of(vec![*value])).collect()
}

pub(crate) fn groups(of: &serde_json::Value) -> Vec<Vec<f64>> {
    of.as_array().unwrap().iter().map(numbers).collect()
}

fn samples(of: &[Vec<f64>]) -> Vec<Sample> {
    of.iter().cloned().map(Sample::of).collect()
}

/// The mean range of normal values and its standard deviation, from their definitions by another way than the table: the
/// trapezoid rule over the density of the range.
fn integrated(size: i32) -> [f64; 2] {
    let density = |x: f64| (-x * x / 2.0).exp() / (2.0 * std::f64::consts::PI).sqrt();
    let step = 0.05;
    let at_most = |range: f64| {
        let sum: f64 = (-200..=200)
            .map(|at| f64::from(at) * step)
            .map(|x| density(x) * (normal(-x).below - normal(-x - range).below).powi(size - 1))
            .sum();
        f64::from(size) * sum * step
    };
    // Simpson's rule over 0 to 14 for the moments of the range.
    let parts = 1_400;
    let width = 14.0 / f64::from(parts);
    let (mut first, mut second) = (0.0, 0.0);
    for at in 0..=parts {
        let weight = if at == 0 || at == parts {
            1.0
        } else if at % 2 == 1 {
            4.0
        } else {
            2.0
        };
        let range = f64::from(at) * width;
        let above = 1.0 - at_most(range);
        first += weight * above;
        second += weight * 2.0 * range * above;
    }
    let [first, second] = [first, second].map(|sum| sum * width / 3.0);
    [first, (second - first * first).sqrt()]
}

#[test]
fn the_constants_are_those_of_their_definitions() {
    for size in [2, 3, 5, 10, 25] {
        let [mean, deviation] = integrated(size);
        let size = usize::try_from(size).unwrap();
        near(d2(size).unwrap(), mean, 1e-9);
        near(d3(size).unwrap(), deviation, 1e-8);
    }
    for (size, figures) in data("chart_constants.json")["constants"].as_object().unwrap() {
        let size: usize = size.parse().unwrap();
        let root = count(size).sqrt();
        let [d2, d3, c4] = [d2(size).unwrap(), d3(size).unwrap(), c4(size).unwrap()];
        let b = 3.0 * (1.0 - c4 * c4).sqrt() / c4;
        for (name, found) in [
            ("d2", d2),
            ("d3", d3),
            ("c4", c4),
            ("A2", 3.0 / d2 / root),
            ("A3", 3.0 / c4 / root),
            ("D3", (1.0 - 3.0 * d3 / d2).max(0.0)),
            ("D4", 1.0 + 3.0 * d3 / d2),
            ("B3", (1.0 - b).max(0.0)),
            ("B4", 1.0 + b),
            ("E2", 3.0 / d2),
        ] {
            within(found, number(&figures[name]), 1e-11);
        }
    }
    assert_eq!(d2(26), Err(Reason::LargeSubgroup { found: 26, most: 25 }));
    assert_eq!(c4(1), Err(Reason::TooFew { found: 1, needed: 2 }));
    // Both ways to c4, where one begins.
    near(c4(1_001).unwrap(), c4(1_000).unwrap(), 3e-7);
    near(1.0 - c4(1_001).unwrap(), 1.0 / 4.0 / 1_001.0 + 7.0 / 32.0 / 1_002_001.0, 1e-6);
}

#[test]
fn the_cases_of_the_shewhart_package_are_met() {
    let all = data("shewhart_cases.json");
    let case = |at: usize| (&all["cases"][at]["inputs"], &all["cases"][at]["expected"]);
    let (inputs, expected) = case(0);
    let drawn = chart(&singles(&numbers(&inputs["data"])), &ChartPlan::of(ChartKind::Individuals)).unwrap();
    let point = &drawn.points[1];
    let spread = point.spread.unwrap();
    for (name, found) in [
        ("i_center", point.location.centre),
        ("mr_center", spread.centre),
        ("sigma_within", drawn.stages[0].sigma.value),
        ("i_ucl", point.location.upper),
        ("i_lcl", point.location.lower),
        ("mr_ucl", spread.upper),
    ] {
        within(found, number(&expected[name]), 1e-9);
    }
    assert!(drawn.points[0].spread.is_none());
    let (inputs, expected) = case(1);
    let values = numbers(&inputs["frame"]["x"]);
    let pairs: Vec<Vec<f64>> = values.chunks(2).map(<[f64]>::to_vec).collect();
    let drawn = chart(&samples(&pairs), &ChartPlan::of(ChartKind::MeansRanges)).unwrap();
    let point = &drawn.points[0];
    let spread = point.spread.unwrap();
    for (name, found) in [
        ("xbar_center", point.location.centre),
        ("r_center", spread.centre),
        ("sigma_within", drawn.stages[0].sigma.value),
        ("xbar_ucl", point.location.upper),
        ("xbar_lcl", point.location.lower),
        ("r_ucl", spread.upper),
    ] {
        within(found, number(&expected[name]), 1e-9);
    }
}

/// The first 25 subgroups are the baseline; the later ones do not move the limits, and the shift at the end is found.
#[test]
fn the_piston_rings_have_their_published_limits() {
    let rings = data("pistonrings.json");
    let (published, exact) = (&rings["published"], &rings["computed_exact_constants"]);
    let all = samples(&groups(&rings["subgroups"]));
    let stages = vec![Stage { first: 0, baseline: Baseline::Points(0..25) }];
    for (kind, names) in [
        (ChartKind::MeansRanges, ["sigma_rbar_d2", "rbar", "r_ucl"]),
        (ChartKind::MeansDeviations, ["sigma_sbar_c4", "sbar", "s_ucl"]),
    ] {
        let plan = ChartPlan { stages: stages.clone(), ..ChartPlan::of(kind) };
        let drawn = chart(&all, &plan).unwrap();
        assert_eq!(drawn.stages[0].baseline, 25);
        let last = drawn.points.last().unwrap();
        let spread = last.spread.unwrap();
        let mut figures = vec![("xbarbar", last.location.centre), (names[0], drawn.stages[0].sigma.value)];
        figures.extend([(names[1], spread.centre), (names[2], spread.upper)]);
        if kind == ChartKind::MeansRanges {
            figures.extend([("xbar_lcl", last.location.lower), ("xbar_ucl", last.location.upper)]);
            within(spread.lower, number(&exact["r_lcl"]), 1e-15);
        }
        for (name, found) in figures {
            near(found, number(&published[name]), 1e-4);
            near(found, number(&exact[name]), 1e-12);
        }
        let out: Vec<usize> = (1..)
            .zip(&drawn.points)
            .filter(|(_, point)| point.location.fired.has(Rule::BeyondLimits))
            .map(|(number, _)| number)
            .collect();
        assert!(out.iter().all(|number| 25 < *number) && out.contains(&38), "{out:?}");
        // What is drawn of the first points does not depend on those after them.
        let fewer = chart(&all[..30], &plan).unwrap();
        assert_eq!(fewer.points[..], drawn.points[..30]);
    }
}

#[test]
fn the_viscosities_have_their_published_limits() {
    let study = study("individuals_viscosity_qcc");
    let values = numbers(&study["data"]);
    let published = &study["published"];
    let drawn = chart(&singles(&values), &ChartPlan::of(ChartKind::Individuals)).unwrap();
    let point = drawn.points[0].location;
    printed(point.centre, number(&published["mean"]), 6);
    // The source takes d2 as 1.128; the digits with the exact constant stand in its note.
    near(drawn.stages[0].sigma.value, number(&published["sd_moving_range"]) * 1.128 / d2(2).unwrap(), 2e-7);
    printed(drawn.stages[0].sigma.value, 0.507_481_5, 7);
    printed(point.lower, 32.5656, 4);
    printed(point.upper, 35.6104, 4);
    let plan = ChartPlan { method: Method::Deviations, ..ChartPlan::of(ChartKind::Individuals) };
    let drawn = chart(&singles(&values), &plan).unwrap();
    printed(drawn.stages[0].sigma.value, number(&published["sd_sample"]), 7);
    printed(drawn.points[0].location.lower, number(&published["LCL_sample"]), 5);
    printed(drawn.points[0].location.upper, number(&published["UCL_sample"]), 5);
}

/// The points, counted from 1, at which a rule fires.
fn fired(values: &[f64], rule: Rule) -> Vec<usize> {
    let drawn = chart(&singles(values), &ChartPlan { rules: Rules::NONE.with(rule, true), ..plan() }).unwrap();
    let points = (1..).zip(&drawn.points);
    points.filter(|(_, point)| point.location.fired.has(rule)).map(|(number, _)| number).collect()
}

fn plan() -> ChartPlan {
    ChartPlan::of(ChartKind::Individuals)
}

#[test]
fn the_rules_fire_at_the_published_points() {
    let study = study("run_rules_45");
    let values = numbers(&study["data"]);
    for (name, rule) in [
        ("beyond_3s", Rule::BeyondLimits),
        ("same_side_9", Rule::NineOneSide),
        ("monotone_6_points", Rule::SixTrend),
        ("alternating_14_points", Rule::FourteenAlternating),
        ("two_of_three_beyond_2s", Rule::TwoOfThree),
        ("four_of_five_beyond_1s", Rule::FourOfFive),
        ("fifteen_within_1s", Rule::FifteenWithin),
        ("eight_beyond_1s", Rule::EightBeyond),
    ] {
        let expected: Vec<usize> = serde_json::from_value(study["computed"][name].clone()).unwrap();
        assert_eq!(fired(&values, rule), expected, "{rule}");
    }
    // Runs of seven, by the length that the scanner tells.
    let drawn = chart(&singles(&values), &plan()).unwrap();
    let mut scanner = Scanner::default();
    let mut seven = Vec::new();
    for (number, point) in (1..).zip(&drawn.points) {
        scanner
            .next(point.location.value, (point.location.value - point.location.centre) / drawn.stages[0].sigma.value);
        if 7 <= scanner.on_one_side() {
            seven.push(number);
        }
    }
    let expected: Vec<usize> = serde_json::from_value(study["computed"]["same_side_7"].clone()).unwrap();
    assert_eq!(seven, expected);
}

/// A second implementation: each rule looks at its whole window anew.
fn by_windows(z: &[f64], at: usize) -> Rules {
    let last = |size: usize| (size <= at + 1).then(|| &z[at + 1 - size..=at]);
    let all = |size, holds: &dyn Fn(f64) -> bool| last(size).is_some_and(|w| w.iter().all(|z| holds(*z)));
    let one_side = |size| all(size, &|z| 0.0 < z) || all(size, &|z| z < 0.0);
    let of = |wanted: usize, size: usize, zone: f64| {
        let from = (at + 1).saturating_sub(size);
        [1.0, -1.0]
            .iter()
            .any(|sign| zone < z[at] * sign && wanted <= z[from..=at].iter().filter(|z| zone < **z * sign).count())
    };
    let steps = |size| last(size).map(|w| w.windows(2).map(|pair| pair[1] - pair[0]).collect::<Vec<_>>());
    let trend = steps(6).is_some_and(|s| s.iter().all(|step| 0.0 < *step) || s.iter().all(|step| *step < 0.0));
    let turns = steps(14).is_some_and(|s| s.windows(2).all(|pair| pair[0] * pair[1] < 0.0));
    Rules::NONE
        .with(Rule::BeyondLimits, 3.0 < z[at].abs())
        .with(Rule::NineOneSide, one_side(9))
        .with(Rule::EightOneSide, one_side(8))
        .with(Rule::SixTrend, trend)
        .with(Rule::FourteenAlternating, turns)
        .with(Rule::TwoOfThree, of(2, 3, 2.0))
        .with(Rule::FourOfFive, of(4, 5, 1.0))
        .with(Rule::FifteenWithin, all(15, &|z| z.abs() < 1.0))
        .with(Rule::EightBeyond, all(8, &|z| 1.0 < z.abs()))
}

proptest::proptest! {
    #[test]
    fn the_scanner_says_what_windows_say(z in proptest::collection::vec(-8_i32..=8, 1..60)) {
        // Steps of a half, so that equal neighbours and points on the lines occur.
        let z: Vec<f64> = z.into_iter().map(|z| f64::from(z) / 2.0).collect();
        let mut scanner = Scanner::default();
        for at in 0..z.len() {
            proptest::prop_assert_eq!(scanner.next(z[at], z[at]), by_windows(&z, at));
        }
    }
}

/// Eight points on one side are Western Electric's, the ninth is Nelson's, too.
#[test]
fn a_switched_off_rule_is_silent() {
    assert!(Rules::WESTERN_ELECTRIC.has(Rule::EightOneSide) && !Rules::NELSON.has(Rule::EightOneSide));
    assert_eq!(Rules::WESTERN_ELECTRIC.iter().count(), 4);
    assert_eq!(Rules::NELSON.iter().count(), 8);
    let mut scanner = Scanner::default();
    let last = (0..8).map(|_| scanner.next(0.5, 0.5)).last().unwrap();
    assert!(last.has(Rule::EightOneSide) && !last.has(Rule::NineOneSide));
    let last = scanner.next(0.5, 0.5);
    assert!(last.has(Rule::EightOneSide) && last.has(Rule::NineOneSide));
    assert!(Rules::NELSON.with(Rule::NineOneSide, false).both(last).is_empty());
    assert_eq!(Rule::EightOneSide.to_string(), "8 points in a row on one side of the centre line");
}

/// The standard deviation of means, not that of single values, gives the zones: fifteen means within 1 s of means fire.
#[test]
fn the_zones_of_means_are_those_of_means() {
    let all: Vec<Vec<f64>> = (0..16).map(|at| vec![0.9, -0.9 + f64::from(at % 2) * 1e-3, 0.0, 0.0]).collect();
    let plan = ChartPlan::of(ChartKind::MeansDeviations);
    let drawn = chart(&samples(&all), &plan).unwrap();
    assert!(drawn.points[14].location.fired.has(Rule::FifteenWithin));
    let mut shifted = all;
    for group in shifted.iter_mut().skip(8) {
        for value in group {
            *value += 0.8;
        }
    }
    // Each mean is more than 1 s of means off, and less than 1 s of single values.
    let drawn = chart(&samples(&shifted), &plan).unwrap();
    assert!(drawn.points[15].location.fired.has(Rule::EightBeyond));
}

#[test]
fn a_point_that_is_left_out_stays_visible_and_counts_nowhere() {
    let values = [10.0, 12.0, 11.0, 99.0, 13.0, 12.0];
    let mut all = singles(&values);
    all[3].left_out = Some(Arc::from("chip on the probe"));
    let drawn = chart(&all, &plan()).unwrap();
    let without = chart(&singles(&[10.0, 12.0, 11.0, 13.0, 12.0]), &plan()).unwrap();
    assert_eq!(drawn.stages[0].sigma, without.stages[0].sigma);
    within(drawn.stages[0].mean, without.stages[0].mean, 1e-12);
    assert_eq!(drawn.points[3].left_out.as_deref(), Some("chip on the probe"));
    assert!(drawn.points[3].location.fired.is_empty() && drawn.points[3].spread.is_none());
    assert_eq!(drawn.points[4], without.points[3]);
    let all_out: Vec<Sample> =
        all.iter().map(|sample| Sample { left_out: Some(Arc::from("all")), ..sample.clone() }).collect();
    assert_eq!(chart(&all_out, &plan()), Err(Reason::TooFew { found: 0, needed: 2 }));
}

#[test]
fn stages_have_limits_of_their_own_and_runs_end_at_them() {
    let values: Vec<f64> = (0..24).map(|at| f64::from(at % 3) + if at < 12 { 0.0 } else { 100.0 }).collect();
    let stage = |first, baseline| Stage { first, baseline };
    let two = ChartPlan { stages: vec![stage(0, Baseline::All), stage(12, Baseline::All)], ..plan() };
    let drawn = chart(&singles(&values), &two).unwrap();
    within(drawn.stages[1].mean - drawn.stages[0].mean, 100.0, 1e-9);
    assert!(drawn.points[12].spread.is_none());
    assert!(drawn.points.iter().all(|point| point.location.fired.is_empty()));
    let known = Baseline::Known { mean: 1.0, sigma: 2.0 };
    let drawn = chart(&singles(&values), &ChartPlan { stages: vec![stage(0, known)], ..plan() }).unwrap();
    assert_eq!((drawn.points[0].location.lower, drawn.points[0].location.upper), (-5.0, 7.0));
    assert_eq!(drawn.stages[0].sigma.method, Method::Known);
    for wrong in [
        vec![],
        vec![stage(1, Baseline::All)],
        vec![stage(0, Baseline::All), stage(24, Baseline::All)],
        vec![stage(0, Baseline::All), stage(12, Baseline::Points(0..12))],
        vec![stage(0, Baseline::Known { mean: 0.0, sigma: 0.0 })],
    ] {
        let plan = ChartPlan { stages: wrong, ..plan() };
        assert_eq!(chart(&singles(&values), &plan), Err(Reason::NoBaseline));
    }
    let plan = ChartPlan { stages: vec![stage(0, Baseline::Points(2..3))], ..plan() };
    assert_eq!(chart(&singles(&values), &plan), Err(Reason::TooFew { found: 1, needed: 2 }));
}

#[test]
fn subgroups_of_unequal_size_have_limits_of_their_size() {
    let all = samples(&[vec![1.0, 3.0], vec![2.0, 2.5, 4.0], vec![2.0], vec![1.5, 3.5, 2.5, 2.0]]);
    for kind in [ChartKind::MeansRanges, ChartKind::MeansDeviations] {
        let drawn = chart(&all, &ChartPlan::of(kind)).unwrap();
        let stage = &drawn.stages[0];
        near(stage.mean, 24.0 / 10.0, 1e-15);
        let half = |at: usize| drawn.points[at].location.upper - stage.mean;
        near(half(0), 3.0 * stage.sigma.value / 2_f64.sqrt(), 1e-14);
        near(half(3), 3.0 * stage.sigma.value / 2.0, 1e-14);
        assert!(drawn.points[2].spread.is_none());
    }
    // Pooled: squares 2, 2.1667 and 2.1875 over 1 + 2 + 3 degrees of freedom.
    let plan = ChartPlan { method: Method::Pooled, ..ChartPlan::of(ChartKind::MeansDeviations) };
    let squares = 2.0 + (4.0 + 6.25 + 16.0 - 8.5 * 8.5 / 3.0) + (2.25 + 12.25 + 6.25 + 4.0 - 9.5 * 9.5 / 4.0);
    near(chart(&all, &plan).unwrap().stages[0].sigma.value, (squares / 6.0_f64).sqrt(), 1e-14);
    let ones = chart(&singles(&[1.0, 2.0, 3.0]), &ChartPlan::of(ChartKind::MeansRanges));
    assert_eq!(ones, Err(Reason::NoSubgroups));
}

#[test]
fn bad_series_are_refused_with_a_reason() {
    let of = |values: &[f64]| chart(&singles(values), &plan());
    assert_eq!(of(&[]), Err(Reason::Empty));
    assert_eq!(of(&[1.0]), Err(Reason::TooFew { found: 1, needed: 2 }));
    assert_eq!(of(&[1.0, 1.0, 1.0]), Err(Reason::AllEqual));
    assert_eq!(of(&[1.0, f64::INFINITY]), Err(Reason::NotANumber { place: 2 }));
    assert!(of(&[1.0, 2.0]).is_ok());
    assert_eq!(chart(&[Sample::of(vec![])], &plan()), Err(Reason::NoSubgroups));
    let large = samples(&[vec![1.0; 26], vec![2.0; 26]]);
    let found = chart(&large, &ChartPlan::of(ChartKind::MeansRanges));
    assert_eq!(found, Err(Reason::LargeSubgroup { found: 26, most: 25 }));
}

#[test]
fn the_ewma_is_that_of_the_nist_handbook() {
    let study = study("ewma_nist_6324");
    let published = &study["published"];
    let ewma = Ewma { weight: number(&study["lam"]), width: number(&study["L"]) };
    let points = ewma.points(&numbers(&study["data"]), number(&study["target"]), number(&study["s"])).unwrap();
    // The first value of the list is the start.
    for (point, expected) in points.iter().zip(numbers(&published["ewma"]).into_iter().skip(1)) {
        printed(point.value, expected, 2);
    }
    assert!(!points.iter().any(fitcheck_statistics::EwmaPoint::is_out));
    let last = points.last().unwrap();
    within(last.upper, number(&published["UCL"]), 2e-4);
    within(last.lower, number(&published["LCL"]), 2e-4);
    assert!(Ewma { weight: 0.0, width: 3.0 }.points(&[1.0], 0.0, 1.0).is_err());
    assert!(Ewma::default().points(&[1.0], 0.0, 0.0).is_err());
    assert_eq!(Ewma::default().points(&[], 0.0, 1.0), Err(Reason::Empty));
}

/// Montgomery, *Introduction to Statistical Quality Control*, tables 9.1, 9.2 and 9.11: the mean moves from 10 to 11 after the
/// 20th of 30 values; the CUSUM finds it at the 29th (data and figures remembered, not seen on the page).
#[test]
fn the_cusum_finds_the_shift_of_montgomerys_example() {
    let values = [
        9.45, 7.99, 9.29, 11.66, 12.16, 10.18, 8.04, 11.46, 9.20, 10.34, 9.03, 11.47, 10.51, 9.40, 10.08, 9.37, 10.62,
        10.31, 8.52, 10.84, 10.90, 9.33, 12.29, 11.50, 10.60, 11.08, 10.38, 11.62, 11.31, 10.52,
    ];
    let sums = Cusum::default().points(&values, 10.0, 1.0).unwrap();
    let first = sums.iter().position(fitcheck_statistics::CusumPoint::is_out).unwrap();
    assert_eq!((first + 1, sums[first].since), (29, 7));
    within(sums[first].above, 5.28, 0.005);
    within(sums[2].below, 1.77, 0.005);
    let averages = Ewma { weight: 0.1, width: 2.7 }.points(&values, 10.0, 1.0).unwrap();
    within(averages[0].value, 9.945, 1e-9);
    within(averages[1].value, 9.749_5, 1e-9);
    assert!(Cusum { allowance: -0.5, interval: 5.0 }.points(&values, 10.0, 1.0).is_err());
}
