//! Pairing measured holes with measured shafts, against every way in which they could be paired.

use std::collections::BTreeSet;

use fitcheck::length::Length;
use fitcheck::pairing::{Grinding, MOST_AMOUNTS, Pair, PairClearances, Pairing, Range, Ranges, grinding, groups, pair};
use proptest::prelude::*;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng as _;

fn nm(nanometres: i64) -> Length {
    Length::from_nanometres(nanometres).unwrap()
}

fn all_nm(nanometres: &[i64]) -> Vec<Length> {
    nanometres.iter().copied().map(nm).collect()
}

fn wanted(minimum: i64, maximum: i64) -> PairClearances {
    PairClearances::new(nm(minimum), nm(maximum)).unwrap()
}

/// Sizes by their positions.
fn sizes(all: &[Length], positions: impl IntoIterator<Item = usize>) -> Vec<i64> {
    positions.into_iter().map(|at| all[at].nanometres()).collect()
}

/// A pairing as figures: hole and shaft of each pair, in order.
fn figures(holes: &[Length], shafts: &[Length], pairing: &Pairing) -> Vec<(i64, i64)> {
    pairing.pairs.iter().map(|pair| (holes[pair.hole].nanometres(), shafts[pair.shaft].nanometres())).collect()
}

#[track_caller]
fn check(holes: &[i64], shafts: &[i64], (minimum, maximum): (i64, i64), expected: &[(i64, i64)]) {
    let (holes, shafts) = (all_nm(holes), all_nm(shafts));
    let pairing = pair(&holes, &shafts, wanted(minimum, maximum));
    assert_eq!(figures(&holes, &shafts, &pairing), expected);
    is_sound(&holes, &shafts, wanted(minimum, maximum), &pairing);
}

/// Every part is in one pair or left over, every clearance is the pair's and wanted, and all is in order of size.
#[track_caller]
fn is_sound(holes: &[Length], shafts: &[Length], wanted: PairClearances, pairing: &Pairing) {
    let each_once = |used: Vec<usize>, left: &[usize], count: usize| {
        let all: Vec<usize> = used.into_iter().chain(left.iter().copied()).collect();
        assert_eq!(all.len(), count);
        assert_eq!(all.into_iter().collect::<BTreeSet<_>>(), (0..count).collect());
    };
    each_once(pairing.pairs.iter().map(|pair| pair.hole).collect(), &pairing.holes, holes.len());
    each_once(pairing.pairs.iter().map(|pair| pair.shaft).collect(), &pairing.shafts, shafts.len());
    for one in &pairing.pairs {
        let apart = holes[one.hole].nanometres() - shafts[one.shaft].nanometres();
        assert_eq!(one.clearance.nanometres(), apart);
        assert!(wanted.minimum() <= one.clearance && one.clearance <= wanted.maximum());
    }
    let widest = pairing.pairs.iter().map(|pair| wanted.band(pair.clearance)).max();
    assert_eq!(pairing.band, widest.unwrap_or_default());
    assert!(sizes(holes, pairing.pairs.iter().map(|pair| pair.hole)).is_sorted());
    assert!(sizes(shafts, pairing.pairs.iter().map(|pair| pair.shaft)).is_sorted());
    assert!(sizes(holes, pairing.holes.iter().copied()).is_sorted());
    assert!(sizes(shafts, pairing.shafts.iter().copied()).is_sorted());
}

/// How good a way to pair is: its pairs, and the sum of their squared distances from the middle in half nanometres.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Worth {
    pairs: usize,
    squares: i64,
}

impl Worth {
    const NOTHING: Self = Self { pairs: 0, squares: 0 };

    fn with(self, off: i64) -> Self {
        Self { pairs: self.pairs + 1, squares: self.squares + off * off }
    }

    fn is_better_than(self, other: Self) -> bool {
        (other.pairs, self.squares) < (self.pairs, other.squares)
    }

    fn of(pairing: &Pairing, wanted: PairClearances) -> Self {
        let offs = pairing.pairs.iter().map(|pair| wanted.band(pair.clearance).nanometres());
        offs.fold(Self::NOTHING, Self::with)
    }
}

/// The best of all ways to pair. Every hole is given to nobody and to each shaft in turn.
fn best(holes: &[i64], shafts: &[i64], (minimum, maximum): (i64, i64)) -> Worth {
    fn look(holes: &[i64], shafts: &[i64], bounds: (i64, i64), used: u32, so_far: Worth) -> Worth {
        let Some((hole, others)) = holes.split_first() else { return so_far };
        let mut best = look(others, shafts, bounds, used, so_far);
        for (number, shaft) in shafts.iter().enumerate() {
            let clearance = hole - shaft;
            if used & (1 << number) != 0 || clearance < bounds.0 || bounds.1 < clearance {
                continue;
            }
            let off = (clearance * 2 - bounds.0 - bounds.1).abs();
            let found = look(others, shafts, bounds, used | 1 << number, so_far.with(off));
            if found.is_better_than(best) {
                best = found;
            }
        }
        best
    }
    look(holes, shafts, (minimum, maximum), 0, Worth::NOTHING)
}

/// The best of all ways to pair, for more parts: of those in order of size, among which there is a best one, the most pairs and
/// their least sum of squares for every number of smallest holes and of smallest shafts.
fn best_in_order(holes: &[i64], shafts: &[i64], (minimum, maximum): (i64, i64)) -> Worth {
    let mut row = vec![Worth::NOTHING; shafts.len() + 1];
    for hole in holes {
        let mut next = vec![Worth::NOTHING];
        for (number, shaft) in shafts.iter().enumerate() {
            let is_wanted = (minimum..=maximum).contains(&(hole - shaft));
            let paired = is_wanted.then(|| row[number].with(((hole - shaft) * 2 - minimum - maximum).abs()));
            let all = [row[number + 1], next[number]].into_iter().chain(paired);
            next.push(all.reduce(|best, one| if one.is_better_than(best) { one } else { best }).unwrap());
        }
        row = next;
    }
    *row.last().unwrap()
}

fn sorted(mut all: Vec<i64>) -> Vec<i64> {
    all.sort_unstable();
    all
}

struct Cases(ChaCha8Rng);

impl Cases {
    fn below(&mut self, end: u32) -> i64 {
        i64::from(self.0.next_u32() % end)
    }

    /// Up to five sizes a few nanometres apart, so that many are equal and many are at a bound.
    fn sizes(&mut self, spread: u32) -> Vec<i64> {
        let count = self.below(6);
        (0..count).map(|_| 1_000 + self.below(spread)).collect()
    }

    fn next(&mut self) -> (Vec<i64>, Vec<i64>, (i64, i64)) {
        let spread = [4, 12, 40][usize::try_from(self.below(3)).unwrap()];
        let minimum = self.below(spread) - i64::from(spread) / 2;
        let width = self.below(spread / 2 + 1);
        (self.sizes(spread), self.sizes(spread), (minimum, minimum + width))
    }
}

#[test]
fn ten_thousand_small_cases_have_the_best_of_all_pairings() {
    let mut cases = Cases(ChaCha8Rng::seed_from_u64(25));
    let (mut with_pairs, mut with_leftovers) = (0, 0);
    for number in 0..10_000 {
        let (holes, shafts, bounds) = cases.next();
        let expected = best(&holes, &shafts, bounds);
        let (hole_sizes, shaft_sizes) = (all_nm(&holes), all_nm(&shafts));
        let pairing = pair(&hole_sizes, &shaft_sizes, wanted(bounds.0, bounds.1));
        let worth = Worth::of(&pairing, wanted(bounds.0, bounds.1));
        assert_eq!(worth, expected, "case {number}: {holes:?} {shafts:?} {bounds:?}");
        assert_eq!(best_in_order(&sorted(holes), &sorted(shafts), bounds), expected);
        is_sound(&hole_sizes, &shaft_sizes, wanted(bounds.0, bounds.1), &pairing);
        with_pairs += usize::from(1 < expected.pairs);
        with_leftovers += usize::from(!pairing.holes.is_empty() && !pairing.shafts.is_empty());
    }
    assert!(2_000 < with_pairs && 2_000 < with_leftovers, "{with_pairs} {with_leftovers}");
}

/// Thirty bores, and thirty shafts that are a little too small for them: of 27 pairs, some have almost 30 µm.
#[test]
fn bores_and_shafts_of_a_lot_are_paired_closest_to_the_middle() {
    let tenths = |whole: i64, all: [i64; 30]| all.map(|tenth| whole + tenth * 100).to_vec();
    let bores = tenths(
        40_000_000,
        [
            143, 156, 159, 251, 83, 126, 293, 13, 94, 135, 134, 149, 111, 147, 128, 171, 11, 72, 125, 63, 62, 163, 86,
            163, 170, 143, 155, 119, 40, 123,
        ],
    );
    let shafts = tenths(
        39_900_000,
        [
            844, 814, 827, 852, 804, 849, 886, 813, 834, 825, 876, 839, 857, 809, 830, 830, 777, 873, 857, 778, 852,
            826, 843, 841, 785, 824, 875, 813, 799, 789,
        ],
    );
    let bounds = (10_000, 30_000);
    let (hole_sizes, shaft_sizes) = (all_nm(&bores), all_nm(&shafts));
    let pairing = pair(&hole_sizes, &shaft_sizes, wanted(bounds.0, bounds.1));
    is_sound(&hole_sizes, &shaft_sizes, wanted(bounds.0, bounds.1), &pairing);
    // 1772.34 µm², in quarters of square nanometres.
    let expected = Worth { pairs: 27, squares: 4 * 1_772_340_000 };
    assert_eq!(Worth::of(&pairing, wanted(bounds.0, bounds.1)), expected);
    assert_eq!(best_in_order(&sorted(bores), &sorted(shafts), bounds), expected);
    let first: Vec<_> = pairing.pairs[..3].iter().map(|pair| (pair.hole + 1, pair.shaft + 1)).collect();
    assert_eq!(first, [(17, 30), (8, 29), (29, 5)]);
    let left = [&pairing.holes, &pairing.shafts].map(|left| left.iter().map(|at| at + 1).collect::<Vec<_>>());
    assert_eq!(left, [vec![16, 4, 7], vec![17, 20, 25]]);
}

#[test]
fn the_least_sum_of_squares_is_taken() {
    // The last pair is at the end of what is wanted, whatever the others do.
    check(&[30, 100], &[2, 9, 12, 70], (10, 30), &[(30, 9), (100, 70)]);
    check(&[100, 110, 1_000], &[80, 83, 96, 970], (10, 30), &[(100, 80), (110, 96), (1_000, 970)]);
    // One pair at 5 from the middle and one at none are better than two at 4.
    check(&[100, 104], &[80, 79, 88], (10, 30), &[(100, 80), (104, 88)]);
    // Of the same sum, the smaller parts.
    check(&[100, 104], &[82], (10, 30), &[(100, 82)]);
}

#[test]
fn a_bound_belongs_to_the_wanted_clearances_and_a_nanometre_more_does_not() {
    let hole = 25_020_000;
    for (clearance, is_pair) in
        [(9_999, false), (10_000, true), (10_001, true), (29_999, true), (30_000, true), (30_001, false)]
    {
        let shaft = hole - clearance;
        let expected: &[(i64, i64)] = if is_pair { &[(hole, shaft)] } else { &[] };
        check(&[hole], &[shaft], (10_000, 30_000), expected);
    }
    for (clearance, is_pair) in [(-20_001, false), (-20_000, true), (-5_000, true), (-4_999, false)] {
        let shaft = hole - clearance;
        let expected: &[(i64, i64)] = if is_pair { &[(hole, shaft)] } else { &[] };
        check(&[hole], &[shaft], (-20_000, -5_000), expected);
    }
}

#[test]
fn more_pairs_come_before_better_ones() {
    // 30 with 20 would be in the middle, and leave 40 and 12 alone.
    check(&[30, 40], &[20, 12], (8, 28), &[(30, 12), (40, 20)]);
    // A band of an odd width has its middle on a half nanometre.
    check(&[100, 101], &[90], (8, 13), &[(100, 90)]);
    check(&[101, 102], &[90], (8, 13), &[(101, 90)]);
    // Bounds that are one size.
    check(&[100, 101, 102], &[91, 93, 92], (9, 9), &[(100, 91), (101, 92), (102, 93)]);
}

#[test]
fn without_parts_or_within_reach_of_none_nothing_is_paired() {
    check(&[], &[], (0, 10), &[]);
    check(&[10], &[], (0, 10), &[]);
    check(&[], &[10], (0, 10), &[]);
    check(&[10], &[11], (0, 10), &[]);
    let most = Length::MAX.nanometres();
    check(&[most, 1], &[1, most], (-most, most), &[(1, 1), (most, most)]);
    check(&[most], &[1], (-most, -most), &[]);
}

#[test]
fn of_equal_sizes_the_first_goes_first() {
    let (holes, shafts) = (all_nm(&[50, 40, 50, 50]), all_nm(&[40, 30, 40]));
    let pairing = pair(&holes, &shafts, wanted(0, 10));
    let pairs: Vec<_> = pairing.pairs.iter().map(|pair| (pair.hole, pair.shaft)).collect();
    assert_eq!(pairs, [(1, 1), (0, 0), (2, 2)]);
    assert_eq!((pairing.holes, pairing.shafts), (vec![3], vec![]));
}

fn parts() -> impl Strategy<Value = (Vec<i64>, Vec<i64>, (i64, i64))> {
    let all = || prop::collection::vec(1_000_i64..1_400, 0..40);
    (all(), all(), -150_i64..150, 0_i64..200).prop_map(|(holes, shafts, low, wide)| (holes, shafts, (low, low + wide)))
}

proptest! {
    #[test]
    fn more_parts_have_the_best_pairing_too((holes, shafts, bounds) in parts()) {
        let pairing = pair(&all_nm(&holes), &all_nm(&shafts), wanted(bounds.0, bounds.1));
        let worth = Worth::of(&pairing, wanted(bounds.0, bounds.1));
        prop_assert_eq!(worth, best_in_order(&sorted(holes), &sorted(shafts), bounds));
    }

    #[test]
    fn the_order_of_the_rows_changes_no_size_of_a_pair((holes, shafts, bounds) in parts(), seed: u64) {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut shuffled = |all: &[i64]| {
            let mut keyed: Vec<(u32, i64)> = all.iter().map(|one| (random.next_u32(), *one)).collect();
            keyed.sort_unstable();
            keyed.into_iter().map(|(_, one)| one).collect::<Vec<_>>()
        };
        let told = |holes: &[i64], shafts: &[i64]| {
            let (holes, shafts) = (all_nm(holes), all_nm(shafts));
            let pairing = pair(&holes, &shafts, wanted(bounds.0, bounds.1));
            let left = (sizes(&holes, pairing.holes.clone()), sizes(&shafts, pairing.shafts.clone()));
            let ground = grinding(&holes, &shafts, &pairing, wanted(bounds.0, bounds.1));
            (figures(&holes, &shafts, &pairing), left, ground.and_then(|ground| Some(ground.best?.amount)))
        };
        prop_assert_eq!(told(&shuffled(&holes), &shuffled(&shafts)), told(&holes, &shafts));
    }

    #[test]
    fn every_part_is_used_once_and_every_pair_is_wanted((holes, shafts, bounds) in parts()) {
        let (holes, shafts) = (all_nm(&holes), all_nm(&shafts));
        let wanted = wanted(bounds.0, bounds.1);
        let pairing = pair(&holes, &shafts, wanted);
        is_sound(&holes, &shafts, wanted, &pairing);
        // In the place of a part of a pair, no leftover is closer to the middle.
        let off = |hole: usize, shaft: usize| wanted.band(holes[hole].saturating_sub(shafts[shaft]));
        for one in &pairing.pairs {
            let paired = wanted.band(one.clearance);
            prop_assert!(pairing.holes.iter().all(|hole| paired <= off(*hole, one.shaft)));
            prop_assert!(pairing.shafts.iter().all(|shaft| paired <= off(one.hole, *shaft)));
        }
        // No pair is left among the leftovers.
        for (hole, shaft) in pairing.holes.iter().flat_map(|hole| pairing.shafts.iter().map(move |shaft| (hole, shaft))) {
            prop_assert!(!wanted.allows(holes[*hole].saturating_sub(shafts[*shaft])));
        }
    }

    /// The same distance added to every size changes nothing, and mirrored parts have as many pairs as close to the middle.
    #[test]
    fn neither_a_shift_nor_a_mirror_changes_the_pairing((holes, shafts, bounds) in parts(), shift in 0_i64..5_000) {
        let told = |holes: &[i64], shafts: &[i64]| {
            let pairing = pair(&all_nm(holes), &all_nm(shafts), wanted(bounds.0, bounds.1));
            Worth::of(&pairing, wanted(bounds.0, bounds.1))
        };
        let moved = |all: &[i64]| all.iter().map(|one| one + shift).collect::<Vec<_>>();
        let mirrored = |all: &[i64]| all.iter().map(|one| 3_000 - one).collect::<Vec<_>>();
        let expected = told(&holes, &shafts);
        prop_assert_eq!(told(&moved(&holes), &moved(&shafts)), expected);
        prop_assert_eq!(told(&mirrored(&shafts), &mirrored(&holes)), expected);
    }
}

fn ground(holes: &[i64], shafts: &[i64], (minimum, maximum): (i64, i64)) -> Option<Grinding> {
    let (holes, shafts) = (all_nm(holes), all_nm(shafts));
    let pairing = pair(&holes, &shafts, wanted(minimum, maximum));
    grinding(&holes, &shafts, &pairing, wanted(minimum, maximum))
}

/// The smallest amount with the most pairs among what is left over, by looking at every amount and every way to pair.
fn best_amount(holes: &[i64], shafts: &[i64], (minimum, maximum): (i64, i64), most: i64) -> Option<(i64, usize)> {
    let mut found: Option<(i64, usize)> = None;
    for amount in (1..=most).map(|um| um * 1_000) {
        let ground: Vec<i64> = shafts.iter().map(|shaft| shaft - amount).filter(|shaft| 0 < *shaft).collect();
        let count = best(holes, &ground, (minimum, maximum)).pairs;
        if found.map_or(0, |(_, count)| count) < count {
            found = Some((amount, count));
        }
    }
    found
}

#[test]
fn the_smallest_amount_that_saves_most_is_found() {
    let mut cases = Cases(ChaCha8Rng::seed_from_u64(7));
    let mut saved = 0;
    for number in 0..1_500 {
        let in_um =
            |all: Vec<i64>, scatter: i64| all.iter().map(|one| (one - 990) * 1_000 + scatter).collect::<Vec<_>>();
        let (holes, shafts, bounds) = cases.next();
        let (holes, shafts) = (in_um(holes, cases.below(1_000)), in_um(shafts, cases.below(1_000)));
        let bounds = (bounds.0 * 1_000, bounds.1 * 1_000 + cases.below(900));
        let (hole_sizes, shaft_sizes) = (all_nm(&holes), all_nm(&shafts));
        let pairing = pair(&hole_sizes, &shaft_sizes, wanted(bounds.0, bounds.1));
        let found = grinding(&hole_sizes, &shaft_sizes, &pairing, wanted(bounds.0, bounds.1));
        let (left_holes, left_shafts) = (sizes(&hole_sizes, pairing.holes), sizes(&shaft_sizes, pairing.shafts));
        assert_eq!(found.is_none(), left_holes.is_empty() || left_shafts.is_empty());
        let Some(found) = found else { continue };
        let expected = best_amount(&left_holes, &left_shafts, bounds, 120);
        let said = found.best.as_ref().map(|saving| (saving.amount.nanometres(), saving.pairs.len()));
        assert_eq!(said, expected, "case {number}: {holes:?} {shafts:?} {bounds:?}");
        assert!(!found.is_bounded());
        let Some(saving) = found.best else { continue };
        saved += 1;
        for &Pair { hole, shaft, clearance } in &saving.pairs {
            assert_eq!(clearance.nanometres(), holes[hole] - (shafts[shaft] - saving.amount.nanometres()));
            assert!(wanted(bounds.0, bounds.1).allows(clearance));
        }
    }
    assert!(300 < saved, "{saved}");
}

#[test]
fn an_amount_is_a_whole_number_of_micrometres_and_at_most_a_millimetre() {
    let told = |holes: &[i64], shafts: &[i64], bounds| {
        let found = ground(holes, shafts, bounds).unwrap();
        let best = found.best.as_ref().map(|saving| (saving.amount.nanometres(), saving.pairs.len()));
        (best, found.tried.nanometres(), found.is_bounded())
    };
    // 4.001 µm short: 5 µm.
    assert_eq!(told(&[25_000_000], &[24_994_001], (10_000, 30_000)), (Some((5_000, 1)), 5_000, false));
    assert_eq!(told(&[25_000_000], &[24_994_000], (10_000, 30_000)), (Some((4_000, 1)), 4_000, false));
    // Between two whole micrometres nothing is looked at.
    assert_eq!(told(&[25_000_000], &[24_994_500], (10_000, 10_000)), (None, 5_000, false));
    // Grinding makes too much clearance larger.
    assert_eq!(told(&[25_000_000], &[24_900_000], (10_000, 30_000)), (None, 0, false));
    // One millimetre is the last amount.
    let most = MOST_AMOUNTS * 1_000;
    assert_eq!(told(&[25_000_000], &[24_990_000 + most], (10_000, 30_000)), (Some((most, 1)), most, false));
    assert_eq!(told(&[25_000_000], &[24_990_001 + most], (10_000, 30_000)), (None, most, true));
    // What is bounded says so also where something nearer is saved.
    let both = told(&[20_000_000, 25_000_000], &[24_994_000], (10_000, 30_000));
    assert_eq!(both, (Some((4_000, 1)), most, true));
    // A shaft of 3 µm is gone when 3 µm are taken off.
    assert_eq!(told(&[1_000], &[3_000], (1_000, 2_000)), (None, 3_000, false));
    assert_eq!(ground(&[25_000_000], &[], (10_000, 30_000)), None);
    assert_eq!(ground(&[25_000_000], &[24_980_000], (10_000, 30_000)), None);
}

#[test]
fn a_size_at_the_end_of_a_group_belongs_to_the_next_one() {
    let range = |from, to| Range { from: nm(from), to: nm(to) };
    let ranges = Ranges { holes: range(100, 110), shafts: range(90, 99) };
    let holes = [99, 100, 103, 104, 106, 107, 110, 111];
    let shafts = [90, 92, 93, 95, 96, 99];
    let sorted = groups(&all_nm(&holes), &all_nm(&shafts), 3, ranges).unwrap();
    // 10 nm in three groups: 103.3 and 106.7 are rounded up to the first nanometre that is in the group.
    assert_eq!(sorted.holes, [None, Some(0), Some(0), Some(1), Some(1), Some(2), Some(2), None]);
    assert_eq!(sorted.shafts, [Some(0), Some(0), Some(1), Some(1), Some(2), Some(2)]);
    assert_eq!(sorted.outside(), (2, 0));
    let ends: Vec<_> = sorted.all.iter().map(|group| (group.hole_range, group.shaft_range)).collect();
    assert_eq!(
        ends,
        [(range(100, 104), range(90, 93)), (range(104, 107), range(93, 96)), (range(107, 110), range(96, 99)),]
    );
    let clearances: Vec<_> = sorted.all.iter().map(|group| group.clearances).collect();
    let both = |smallest, largest| Some((nm(smallest), nm(largest)));
    assert_eq!(clearances, [both(8, 13), both(9, 13), both(8, 14)]);
    let within: Vec<_> = sorted.all.iter().map(|group| group.all_within(wanted(8, 13))).collect();
    assert_eq!(within, [Some(true), Some(true), Some(false)]);
}

#[test]
fn groups_need_sizes_and_a_width() {
    let refused = |holes: &[i64], shafts: &[i64], count| {
        let (holes, shafts) = (all_nm(holes), all_nm(shafts));
        let ranges = Ranges::measured(&holes, &shafts);
        ranges.and_then(|ranges| groups(&holes, &shafts, count, ranges)).unwrap_err().to_string()
    };
    let narrow =
        "shafts from 0.000005 to 0.000006 mm cannot be sorted into 2 groups: a group has at least one nanometre";
    assert_eq!(refused(&[10, 20], &[5, 6], 2), narrow);
    assert_eq!(refused(&[], &[5, 6], 2), "there are no holes to sort");
    assert_eq!(refused(&[1], &[5], 0), "0 groups: expected 1 to 1000");
    assert_eq!(refused(&[1], &[5], 1_001), "1001 groups: expected 1 to 1000");
    // One group needs no width.
    let (holes, shafts) = (all_nm(&[10]), all_nm(&[5]));
    let one = groups(&holes, &shafts, 1, Ranges::measured(&holes, &shafts).unwrap()).unwrap();
    assert_eq!((one.holes, one.shafts, one.all[0].pairs()), (vec![Some(0)], vec![Some(0)], 1));
}

proptest! {
    #[test]
    fn every_size_is_in_the_group_that_its_ends_say((holes, shafts, _) in parts(), count in 1_usize..30) {
        let (holes, shafts) = (all_nm(&holes), all_nm(&shafts));
        let sorted = Ranges::measured(&holes, &shafts).and_then(|ranges| groups(&holes, &shafts, count, ranges));
        let Ok(sorted) = sorted else { return Ok(()) };
        let last = sorted.all.len() - 1;
        for (hole, group) in holes.iter().zip(&sorted.holes) {
            let number = group.unwrap();
            let range = sorted.all[number].hole_range;
            prop_assert!(range.from <= *hole && (*hole < range.to || number == last && *hole == range.to));
        }
        prop_assert_eq!(sorted.all.iter().map(|group| group.holes).sum::<usize>(), holes.len());
        prop_assert_eq!(sorted.all.iter().map(|group| group.shafts).sum::<usize>(), shafts.len());
        // Ends meet, and widths differ by a nanometre at most.
        for both in sorted.all.windows(2) {
            prop_assert_eq!(both[0].hole_range.to, both[1].hole_range.from);
        }
        let widths: Vec<_> = sorted.all.iter().map(|group| group.hole_range.to.saturating_sub(group.hole_range.from)).collect();
        let apart = widths.iter().max().unwrap().saturating_sub(*widths.iter().min().unwrap());
        prop_assert!(apart <= nm(1) || count == 1);
    }
}

#[test]
fn wanted_clearances_are_two_lengths_with_two_points_between() {
    let read = |text: &str| {
        text.parse::<PairClearances>().map(|wanted| (wanted.minimum().nanometres(), wanted.maximum().nanometres()))
    };
    assert_eq!(read("0.010..0.030"), Ok((10_000, 30_000)));
    assert_eq!(read("-0,020 .. -0,005"), Ok((-20_000, -5_000)));
    assert_eq!(read("-20 µm..+5um"), Ok((-20_000, 5_000)));
    assert_eq!(read("0.01..0.01"), Ok((10_000, 10_000)));
    let refused = |text: &str| text.parse::<PairClearances>().unwrap_err().to_string();
    let form = "expected the smallest and the largest in mm with two points between them, such as 0.010..0.030";
    assert_eq!(refused("0.010"), format!("clearances 0.010: {form}"));
    assert_eq!(refused("0.03..0.01"), "the smallest clearance 0.03 mm is larger than the largest, 0.01 mm");
    assert_eq!(refused("x..0.01"), "smallest clearance: x is not a number");
    assert_eq!(refused("0.01.."), "largest clearance: a length is missing");
    assert_eq!(refused("0.0000001..1"), "smallest clearance: 0.0000001 is finer than a nanometre");
}
