//! How long it takes to pair a hundred thousand holes with as many shafts, with groups and what grinding saves. The budget of
//! the whole command, with its files, is 2 s.
#![expect(clippy::expect_used, reason = "a bench may stop")]

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use fitcheck::length::Length;
use fitcheck::pairing::{Ranges, grinding, groups, pair};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};

const COUNT: usize = 100_000;

/// Sizes around a middle, as the sum of four even ones; in nanometres.
fn sizes(seed: u64, middle: i64, spread: u32) -> Vec<Length> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut even = || i64::from(random.next_u32() % spread);
    let mut size = || middle + even() + even() + even() + even() - 2 * i64::from(spread);
    (0..COUNT).map(|_| Length::from_nanometres(size()).expect("a length")).collect()
}

fn pairings(criterion: &mut Criterion) {
    let wanted = "0.010..0.030".parse().expect("clearances");
    let mut group = criterion.benchmark_group("100 000 holes and shafts");
    group.sample_size(10);
    // The nearest shafts are 2 mm too large in the last: every amount of grinding is looked at for all of them.
    for (name, middle) in
        [("in the middle", 24_990_000), ("20 µm off", 25_010_000), ("all left over, out of reach", 27_000_000)]
    {
        let (holes, shafts) = (sizes(1, 25_010_000, 10_000), sizes(2, middle, 12_000));
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                let pairing = pair(black_box(&holes), black_box(&shafts), wanted);
                let ranges = Ranges::measured(&holes, &shafts).expect("sizes");
                let sorted = groups(&holes, &shafts, 10, ranges).expect("groups");
                (grinding(&holes, &shafts, &pairing, wanted), sorted, pairing)
            });
        });
    }
    group.finish();
}

criterion_group!(benches, pairings);
criterion_main!(benches);
