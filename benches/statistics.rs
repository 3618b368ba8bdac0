//! How long everything of one feature takes, from its values to its figures, rules and charts. The budget is a second for a million values, and a frame of
//! 4 ms for drawing what the window shows at most.
#![expect(clippy::expect_used, reason = "a bench may stop")]

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use fitcheck::journal::natural::Natural;
use fitcheck::length::Length;
use fitcheck::series::{Answer, Drawn, FeatureKey, FeatureSeries, Grouping, Look, Origin, Series, Value, Wanted};
use fitcheck::words::{Language, Words};

/// As many values as the page Statistics shows at most.
const MOST_SHOWN: usize = 100_000;

/// Values that scatter by sums of steps of a linear congruential generator, in tenths of a micrometre.
fn values(count: usize) -> Vec<Value> {
    let mut state = 1_u64;
    let mut step = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i64::try_from(state >> 33).expect("31 bits") * 100 / (1 << 31)
    };
    let limits = [25_000_000, 25_021_000].map(|nanometres| Length::from_nanometres(nanometres).ok());
    let value = |_| {
        let sum: i64 = (0..12).map(|_| step()).sum();
        let measured = Length::from_nanometres(25_010_000 + (sum - 600) * 30).expect("a length");
        Value { name: String::new(), measured, nominal: None, limits, origin: Origin::default(), left_out: None }
    };
    (0..count).map(value).collect()
}

fn of_a_feature(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("statistics of a feature");
    group.sample_size(10);
    let words = Words::new(Language::default());
    let values = values(1_000_000);
    let series = Series::of(&values, None, Grouping::Single).expect("one feature");
    let wanted = Wanted { limits: series.limits().expect("one pair"), ..Wanted::default() };
    group.bench_function("figures and rules of a million values", |bencher| {
        bencher.iter(|| Answer::of(black_box(&series), black_box(&wanted)));
    });
    let answer = Answer::of(&series, &wanted);
    group.bench_function("all charts of a million values", |bencher| {
        bencher.iter(|| answer.sheet(black_box(&series), Some(25.0), &words));
    });
    let nobody = || Natural(String::new());
    let limits = values.first().map_or([None, None], |value| value.limits);
    let key = FeatureKey { part: nobody(), name: nobody(), callout: "25 H7".to_owned(), nominal: None, limits };
    let shown = FeatureSeries { key, values: values.into_iter().take(MOST_SHOWN).collect() };
    let evaluated = shown.evaluate(&Look::default());
    for (name, what) in [
        ("run chart", Drawn::Run),
        ("spread", Drawn::Spread),
        ("histogram", Drawn::Histogram),
        ("probability plot", Drawn::Probability),
    ] {
        group.bench_function(format!("{name} of {MOST_SHOWN} values"), |bencher| {
            bencher.iter(|| evaluated.drawn(what, [900.0, 400.0], 0..MOST_SHOWN, &words));
        });
    }
}

criterion_group!(benches, of_a_feature);
criterion_main!(benches);
