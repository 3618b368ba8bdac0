use fitcheck_core::words::{Language, Words};
use fitcheck_statistics::picture::{
    Mark, Picture, Tone, View, histogram, memory_chart, probability_plot, run_chart, sheet, spread_chart, svg,
    value_range,
};
use fitcheck_statistics::{
    Chart, ChartKind, ChartPlan, Cusum, Family, Fitted, MemoryPoint, Place, Rule, Sample, Signal, Tolerance, chart,
    signals,
};
use proptest::prelude::*;

use crate::data;

/// Diameters of piston rings in their groups, mm.
fn rings() -> Vec<Vec<f64>> {
    let all = data("pistonrings.json");
    let rows = all["subgroups"].as_array().unwrap();
    rows.iter().map(|row| row.as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect()).collect()
}

fn individuals(values: &[f64]) -> Chart {
    let samples: Vec<Sample> = values.iter().map(|value| Sample::of(vec![*value])).collect();
    chart(&samples, &ChartPlan::of(ChartKind::Individuals)).unwrap()
}

fn english() -> Words {
    Words::new(Language::En)
}

fn view<'a>(chart: &Chart, tolerance: Option<&Tolerance>, words: &'a Words) -> View<'a> {
    let points = 0..chart.points.len();
    View { size: [900.0, 400.0], values: value_range(chart, tolerance, &points), points, base: 25.0, words }
}

fn texts(picture: &Picture) -> Vec<&str> {
    picture
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Text { text, .. } => Some(text.as_str()),
            _ => None,
        })
        .collect()
}

fn places(picture: &Picture) -> Vec<[f64; 2]> {
    let of = |mark: &Mark| match mark {
        Mark::Area { from, to, .. } => vec![*from, *to],
        Mark::Shape { points, .. } | Mark::Line { points, .. } => points.clone(),
        Mark::Dot { at, .. } | Mark::Ring { at, .. } | Mark::Text { at, .. } => vec![*at],
    };
    picture.marks.iter().flat_map(of).collect()
}

#[test]
fn a_run_chart_names_its_limits_its_mean_and_its_control_limits() {
    let values = [25.010, 25.012, 25.009, 25.011, 25.010, 25.013, 25.008];
    let chart = individuals(&values);
    let tolerance = Tolerance::new(Some(25.0), Some(25.021)).unwrap();
    let words = english();
    let drawn = run_chart(&chart, Some(&tolerance), &signals(&chart), &view(&chart, Some(&tolerance), &words));
    // Mean 25.010429; mean moving range 0.002667 (16 µm in six steps), over d2 = 1.128379 and times 3: 7.0898 µm.
    for said in ["maximum 25.021", "minimum 25.000", "mean +10.4", "upper +17.5", "lower +3.3", "+21", "0", "1", "7"] {
        assert!(texts(&drawn).contains(&said), "{said} in {:?}", texts(&drawn));
    }
    assert_eq!(drawn.spots.len(), 7);
}

#[test]
fn in_german_a_chart_has_commas_and_true_minus_signs() {
    let chart = individuals(&[24.998, 25.001, 24.999, 25.002]);
    let words = Words::new(Language::from_code("de").unwrap());
    let drawn = run_chart(&chart, None, &[], &view(&chart, None, &words));
    assert!(texts(&drawn).contains(&"untere \u{2212}7,1"), "{:?}", texts(&drawn));
}

#[test]
fn a_point_that_is_left_out_is_a_circle_beside_the_line() {
    let mut samples: Vec<Sample> =
        [25.010, 25.012, 25.030, 25.011, 25.010].map(|value| Sample::of(vec![value])).to_vec();
    samples[2].left_out = Some("chip".into());
    let chart = chart(&samples, &ChartPlan::of(ChartKind::Individuals)).unwrap();
    let words = english();
    let drawn = run_chart(&chart, None, &signals(&chart), &view(&chart, None, &words));
    let rings = drawn.marks.iter().filter(|mark| matches!(mark, Mark::Ring { tone: Tone::LeftOut, .. }));
    assert_eq!(rings.count(), 1);
    assert_eq!(drawn.spots.len(), 5, "it can be pointed at");
    let line = drawn.marks.iter().find_map(|mark| match mark {
        Mark::Line { points, tone: Tone::Data, .. } => Some(points.len()),
        _ => None,
    });
    assert_eq!(line, Some(4));
}

#[test]
fn patterns_that_touch_each_other_are_one_stretch() {
    // Eleven points above the centre line: the rule of nine fires three times.
    let mut values = vec![25.000, 25.004, 24.996, 25.000, 25.004, 24.996, 25.000, 24.990, 24.990, 24.990, 24.990];
    values.extend([25.006, 25.005, 25.006, 25.005, 25.006, 25.005, 25.006, 25.005, 25.006, 25.005, 25.006]);
    let found = signals(&individuals(&values));
    let nine: Vec<&Signal> = found.iter().filter(|signal| signal.rule == Rule::NineOneSide).collect();
    assert_eq!(nine.len(), 1);
    assert_eq!(nine[0].stretches.as_slice(), std::slice::from_ref(&(11..22)));
    assert_eq!((nine[0].count(), nine[0].place), (11, Place::Location));
}

#[test]
fn the_bars_of_a_histogram_hold_every_value_once() {
    let values = rings().concat();
    let chart = individuals(&values);
    let words = english();
    let view = View { base: 74.0, ..view(&chart, None, &words) };
    let drawn = histogram(&values, None, None, &view);
    let (left, right) = (52.0, 888.0);
    let bars: Vec<f64> = drawn
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Area { from, to, tone: Tone::Bar } => Some(to[0] - from[0]),
            _ => None,
        })
        .collect();
    let widest = bars.iter().copied().fold(0.0, f64::max);
    // The widest bar leaves 8 % of the field free.
    assert!((widest - (right - left) / 1.08).abs() < 1e-6);
    // Bars are whole numbers of values: some number of values in the widest makes all of them whole, and their sum is 200.
    let is_whole = |most: u32| {
        let counts: Vec<f64> = bars.iter().map(|bar| bar / widest * f64::from(most)).collect();
        let is_whole = counts.iter().all(|count| (count - count.round()).abs() < 1e-6);
        is_whole && (counts.iter().sum::<f64>() - f64::from(u32::try_from(values.len()).unwrap())).abs() < 1e-6
    };
    assert!((1..=200).any(is_whole), "{bars:?}");
}

#[test]
fn an_empty_size_an_empty_series_and_equal_values_are_drawn_without_a_panic() {
    let words = english();
    let chart = individuals(&[25.0, 25.001]);
    let small = View { size: [100.0, 50.0], ..view(&chart, None, &words) };
    assert_eq!(run_chart(&chart, None, &[], &small), Picture::default());
    let nowhere = View { points: 5..9, ..view(&chart, None, &words) };
    run_chart(&chart, None, &signals(&chart), &nowhere);
    spread_chart(&chart, &signals(&chart), &nowhere);
    histogram(&[], None, None, &nowhere);
    probability_plot(&[], None, None, 0.95, &nowhere);
    histogram(&[25.0, 25.0], None, None, &View { values: [25.0, 25.0], ..nowhere.clone() });
    probability_plot(&[25.0, 25.0], None, None, 0.95, &nowhere);
}

#[test]
fn a_sheet_is_a_well_formed_file_with_its_sentence() {
    let values = rings().concat();
    let groups: Vec<Sample> = rings().into_iter().map(Sample::of).collect();
    let chart = chart(&groups, &ChartPlan::of(ChartKind::MeansRanges)).unwrap();
    let tolerance = Tolerance::new(Some(73.95), Some(74.05)).unwrap();
    let drawn = sheet(&chart, &values, (Some(&tolerance), Family::Normal), (74.0, 0.95), &[], &english());
    let file = svg(&drawn, "A <chart> & more");
    assert!(file.contains("<title>A &lt;chart&gt; &amp; more</title>"));
    assert_eq!(file.matches('<').count(), file.matches('>').count());
    for title in ["Means of groups in µm from 74, oldest left", "Histogram", "Range of groups, µm"] {
        assert!(file.contains(title), "{title}");
    }
    let sums = sums(&values, 74.001, 0.01);
    let taller = sheet(&chart, &values, (Some(&tolerance), Family::Normal), (74.0, 0.95), &sums, &english());
    assert!(drawn.size[1] < taller.size[1] && texts(&taller).contains(&"Sums of deviations from the mean (CUSUM)"));
}

/// The sums of values about a mean, as numbered points.
fn sums(values: &[f64], mean: f64, sigma: f64) -> Vec<(usize, MemoryPoint)> {
    let points = Cusum::default().points(values, mean, sigma).unwrap();
    (1..).zip(points.into_iter().map(MemoryPoint::Sums)).collect()
}

/// Ten values on the mean and ten that are two standard deviations above it: the sum grows by 1.5 s a point, and is beyond 5 s from the
/// fourth of them on.
#[test]
fn sums_beyond_the_decision_interval_are_marked_and_the_axis_counts_from_zero() {
    let values: Vec<f64> = (0..20).map(|at| if at < 10 { 25.0 } else { 25.002 }).collect();
    let words = english();
    let chart = individuals(&[25.0, 25.001]);
    let view = View { points: 0..20, ..view(&chart, None, &words) };
    let drawn = memory_chart(&sums(&values, 25.0, 0.001), &view);
    let rings = drawn.marks.iter().filter(|mark| matches!(mark, Mark::Ring { .. })).count();
    assert_eq!((rings, drawn.spots.len()), (7, 20));
    let texts = texts(&drawn);
    assert!(texts.contains(&"upper +5.0") && texts.contains(&"lower −5.0"), "{texts:?}");
    let narrow = memory_chart(&sums(&values, 25.0, 0.001), &View { points: 0..13, ..view });
    assert!(!narrow.marks.iter().any(|mark| matches!(mark, Mark::Ring { .. })), "what is in sight is drawn");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn of_many_values_few_marks_are_drawn_and_the_extremes_stay(
        values in prop::collection::vec(0..2_000_i32, 2_000..6_000),
        least in 0..2_000_usize,
        greatest in 0..2_000_usize,
    ) {
        prop_assume!(least != greatest);
        let mut values: Vec<f64> = values.into_iter().map(|nm| 25.0 + f64::from(nm) * 1e-6).collect();
        values[least] = 24.9;
        values[greatest] = 25.1;
        let chart = individuals(&values);
        let words = english();
        let drawn = run_chart(&chart, None, &[], &view(&chart, None, &words));
        let shown: Vec<usize> = drawn.spots.iter().map(|spot| spot.number).collect();
        prop_assert!(shown.contains(&least) && shown.contains(&greatest));
        prop_assert!(shown.windows(2).all(|pair| pair[0] < pair[1]));
        prop_assert!(drawn.spots.len() <= 2 * 360 && drawn.marks.len() < 100);
    }

    #[test]
    fn every_mark_is_within_its_drawing(
        values in prop::collection::vec(-5_000_000..5_000_000_i32, 2..400),
        size in (160..2_000_u32, 100..900_u32),
    ) {
        let values: Vec<f64> = values.into_iter().map(|nm| 25.0 + f64::from(nm) * 1e-6).collect();
        let Ok(chart) = std::panic::catch_unwind(|| individuals(&values)) else { return Ok(()) };
        let tolerance = Tolerance::new(Some(24.999), Some(25.021)).unwrap();
        let words = english();
        let view = View { size: [f64::from(size.0), f64::from(size.1)], ..view(&chart, Some(&tolerance), &words) };
        let law = Fitted::of(&values, Family::Normal).ok();
        let fired = signals(&chart);
        for drawn in [
            run_chart(&chart, Some(&tolerance), &fired, &view),
            spread_chart(&chart, &fired, &view),
            memory_chart(&sums(&values, 25.0, 0.001), &view),
            histogram(&values, law.as_ref(), Some(&tolerance), &view),
            probability_plot(&values, law.as_ref(), Some(&tolerance), 0.95, &view),
        ] {
            for [x, y] in places(&drawn) {
                prop_assert!((-1.0..=view.size[0] + 1.0).contains(&x) && (-9.0..=view.size[1] + 9.0).contains(&y), "{x} {y}");
            }
        }
    }
}
