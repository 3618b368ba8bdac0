//! How long the search for classes takes, over all classes at a size. The budget is 50 ms.
#![expect(clippy::expect_used, reason = "a bench may stop")]

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use fitcheck::tolerance::fit::search::{ClearanceRange, Scope, search};
use fitcheck::tolerance::iso286::Options;

fn searches(criterion: &mut Criterion) {
    for (name, minimum, maximum) in [
        ("a sliding fit, 7 to 41 µm", "0.007", "0.041"),
        ("every pair, -50 to 50 mm", "-50", "50"),
        ("nothing, the nearest miss", "0.0001", "0.0002"),
    ] {
        let length = |text: &str| text.parse().expect("a length");
        let (nominal, wanted) = (length("25"), ClearanceRange { minimum: length(minimum), maximum: length(maximum) });
        criterion.bench_function(name, |bencher| {
            bencher.iter(|| search(black_box(nominal), black_box(wanted), Options::default(), Scope::All, 20));
        });
    }
}

criterion_group!(benches, searches);
criterion_main!(benches);
