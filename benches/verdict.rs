//! How long limits and a verdict take for one callout, with the tables loaded.
#![expect(clippy::expect_used, reason = "a bench may stop")]

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use fitcheck::control::shipped_tables;
use fitcheck::length::Length;
use fitcheck::tolerance::{Callout, Sources};
use fitcheck::verdict::judge;

fn verdicts(criterion: &mut Criterion) {
    let standard = Sources::default();
    let tables = Sources::of_tables(shipped_tables());
    let callouts: Vec<(Callout, Length)> = ["25 H7", "120.0001 s7", "8 JS7", "400 H13", "3 k6", "0.5 D10"]
        .into_iter()
        .map(|text| {
            let callout: Callout = text.parse().expect("a callout");
            (callout, callout.nominal())
        })
        .collect();
    for (name, sources) in [("ISO 286", &standard), ("the control's tables", &tables)] {
        let mut next = callouts.iter().cycle();
        criterion.bench_function(&format!("limits and verdict of one callout, {name}"), |bencher| {
            bencher.iter(|| {
                let (callout, measured) = next.next().expect("endless");
                let limits = sources.limits(black_box(callout), None).expect("limits");
                judge(&limits, black_box(*measured), None).status()
            });
        });
    }
    let texts = ["25 H7", "120.0001 s7", "8 JS7", "400 H13", "3 k6", "0.5 D10"];
    let mut next = texts.iter().cycle();
    criterion.bench_function("the same from the callout's text", |bencher| {
        bencher.iter(|| {
            let callout: Callout = black_box(*next.next().expect("endless")).parse().expect("a callout");
            let limits = standard.limits(&callout, None).expect("limits");
            judge(&limits, callout.nominal(), None).status()
        });
    });
    criterion.bench_function("loading both shipped tables", |bencher| bencher.iter(shipped_tables));
}

criterion_group!(benches, verdicts);
criterion_main!(benches);
