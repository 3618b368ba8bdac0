//! Compares the search with a check of every pair, one `iso286::deviations` at a time.

use std::collections::BTreeSet;

use fitcheck::length::Length;
use fitcheck::tolerance::fit::preferred::{function, preference};
use fitcheck::tolerance::fit::search::{Candidate, ClearanceRange, Scope, SearchError, search, search_in};
use fitcheck::tolerance::fit::{Basis, basis};
use fitcheck::tolerance::iso286::{self, Edition, Grade, Letter, Options};
use fitcheck::tolerance::table::Column;
use fitcheck::tolerance::{DeviationTable, Deviations, Feature, Sources, ToleranceClass};
use proptest::prelude::*;

const SIZES: [&str; 7] = ["1", "3", "24", "25", "300", "501", "3150"];

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn nm(nanometres: i64) -> Length {
    Length::from_nanometres(nanometres).unwrap()
}

fn wanted(minimum: &str, maximum: &str) -> ClearanceRange {
    ClearanceRange { minimum: mm(minimum), maximum: mm(maximum) }
}

type Pair = (ToleranceClass, ToleranceClass);

/// Each class of the grid of letters and grades that is defined, with its limit deviations in nanometres.
fn classes(feature: Feature, nominal: Length, options: Options) -> Vec<(ToleranceClass, i64, i64)> {
    let mut found = Vec::new();
    for letter in Letter::ALL {
        for grade in Grade::all() {
            let class = iso286::class(feature, letter, grade);
            if let Ok(cell) = iso286::deviations(class, nominal, options) {
                found.push((class, cell.deviations.upper().nanometres(), cell.deviations.lower().nanometres()));
            }
        }
    }
    found
}

fn every_pair(nominal: Length, options: Options) -> Vec<(Pair, i64, i64)> {
    let shafts = classes(Feature::Shaft, nominal, options);
    let mut pairs = Vec::new();
    for (hole, upper, lower) in classes(Feature::Hole, nominal, options) {
        pairs.extend(shafts.iter().map(|(shaft, es, ei)| ((hole, *shaft), lower - es, upper - ei)));
    }
    pairs
}

fn found(nominal: Length, wanted: ClearanceRange, scope: Scope) -> Vec<Candidate> {
    let found = search(nominal, wanted, Options::default(), scope, usize::MAX).unwrap();
    assert_eq!(found.total, found.candidates.len());
    assert_eq!(found.nearest.is_some(), found.total == 0);
    found.candidates
}

fn set(candidates: &[Candidate]) -> BTreeSet<Pair> {
    let set: BTreeSet<Pair> = candidates.iter().map(|candidate| (candidate.hole, candidate.shaft)).collect();
    assert_eq!(set.len(), candidates.len(), "a pair is found once");
    set
}

#[test]
fn finds_what_looking_at_every_pair_finds() {
    for size in SIZES {
        let nominal = mm(size);
        let pairs = every_pair(nominal, Options::default());
        for (minimum, maximum) in [
            ("0.007", "0.041"),
            ("-0.042", "-0.001"),
            ("0", "0"),
            ("0", "0.001"),
            ("-0.02", "0.02"),
            ("0", "0.5"),
            ("-1", "0"),
            ("0.099999", "0.200001"),
            ("-50", "50"),
        ] {
            let wanted = wanted(minimum, maximum);
            let (least, most) = (wanted.minimum.nanometres(), wanted.maximum.nanometres());
            let fits = |(_, min, max): &&(Pair, i64, i64)| least <= *min && *max <= most;
            // Long lists are compared pair by pair at one size, and counted at the others.
            let count = pairs.iter().filter(fits).count();
            if 5_000 < count && size != "25" {
                let found = search(nominal, wanted, Options::default(), Scope::All, 1).unwrap();
                assert_eq!(found.total, count, "{size} mm, {minimum} to {maximum}");
                continue;
            }
            let expected: BTreeSet<Pair> = pairs.iter().filter(fits).map(|(pair, ..)| *pair).collect();
            let candidates = found(nominal, wanted, Scope::All);
            assert!(set(&candidates) == expected, "{size} mm, {minimum} to {maximum}");
        }
    }
}

#[test]
fn the_borders_of_a_known_fit_find_it_and_a_nanometre_less_does_not() {
    let all: BTreeSet<&str> =
        "H7/g6 H7/h6 H7/p6 H8/f7 G7/h6 K7/h6 N9/h8 F8/m6 H01/js01 H13/r3 H6/k5".split_whitespace().collect();
    let mut tried = 0;
    for size in ["1", "25", "300", "501"] {
        for ((hole, shaft), min, max) in every_pair(mm(size), Options::default()) {
            if !all.contains(format!("{hole}/{shaft}").as_str()) {
                continue;
            }
            tried += 1;
            let has = |minimum, maximum| {
                let wanted = ClearanceRange { minimum: nm(minimum), maximum: nm(maximum) };
                let candidates = found(mm(size), wanted, Scope::All);
                candidates.iter().any(|found| {
                    assert!(minimum <= found.minimum.nanometres() && found.maximum.nanometres() <= maximum);
                    (found.hole, found.shaft) == (hole, shaft)
                })
            };
            assert!(has(min, max), "{size} {hole}/{shaft}");
            assert!(!has(min + 1, max), "{size} {hole}/{shaft}");
            assert!(!has(min, max - 1), "{size} {hole}/{shaft}");
        }
    }
    assert!(25 < tried, "{tried}");
}

#[test]
fn preferred_fits_come_first_and_the_widest_of_them_before_the_others() {
    let candidates = found(mm("25"), wanted("0.007", "0.041"), Scope::All);
    let names: Vec<String> = candidates.iter().take(4).map(|c| format!("{}/{}", c.hole, c.shaft)).collect();
    // H7/g6 fills the range; H6/g5 (+7 to +29) is narrower; then the same in the shaft basis.
    assert_eq!(names, ["H7/g6", "H6/g5", "G7/h6", "G6/h5"]);
    let first = candidates[0];
    assert_eq!((first.minimum, first.maximum), (mm("0.007"), mm("0.041")));
    assert_eq!(first.preference, preference(first.hole, first.shaft));
    assert_eq!(first.function, function(first.hole, first.shaft));
    assert_eq!(first.basis, Some(Basis::Hole));
}

#[test]
fn the_order_is_by_group_then_by_tolerances_then_by_letters() {
    let letters = |class: ToleranceClass| iso286::parts(class).unwrap();
    for (minimum, maximum) in [("-0.05", "0.05"), ("0", "0.3"), ("-0.2", "-0.01")] {
        let candidates = found(mm("25"), wanted(minimum, maximum), Scope::All);
        assert!(100 < candidates.len());
        let key = |candidate: &Candidate| {
            let (hole, shaft) = (candidate.hole, candidate.shaft);
            let group = match (preference(hole, shaft), function(hole, shaft), basis(hole, shaft)) {
                (Some(list), _, _) => usize::from(list != fitcheck::tolerance::fit::preferred::Preference::HoleBasis),
                (_, Some(_), _) => 2,
                (_, _, Some(Basis::Hole | Basis::Both)) => 3,
                (_, _, Some(Basis::Shaft)) => 4,
                _ => 5,
            };
            let width = candidate.maximum.nanometres() - candidate.minimum.nanometres();
            let tolerance = |class| {
                let cell = iso286::deviations(class, mm("25"), Options::default()).unwrap();
                cell.deviations.width().nanometres()
            };
            let narrower = tolerance(hole).min(tolerance(shaft));
            (group, -width, -narrower, letters(hole), letters(shaft))
        };
        let keys: Vec<_> = candidates.iter().map(key).collect();
        assert!(keys.windows(2).all(|two| two[0] < two[1]));
    }
}

#[test]
fn a_limit_gives_the_first_of_all() {
    let wanted = wanted("-0.05", "0.05");
    let all = found(mm("25"), wanted, Scope::All);
    for limit in [0, 1, 7, 100, all.len() - 1, all.len(), all.len() + 1] {
        let some = search(mm("25"), wanted, Options::default(), Scope::All, limit).unwrap();
        assert_eq!(some.total, all.len());
        assert_eq!(some.candidates, all[..limit.min(all.len())]);
    }
}

#[test]
fn scopes_are_parts_of_the_whole() {
    for size in SIZES {
        let wanted = wanted("-0.1", "0.1");
        let all = set(&found(mm(size), wanted, Scope::All));
        let some: BTreeSet<Pair> = all.iter().filter(|(hole, shaft)| basis(*hole, *shaft).is_some()).copied().collect();
        assert_eq!(set(&found(mm(size), wanted, Scope::Basis)), some);
        let known = |(hole, shaft): &&Pair| preference(*hole, *shaft).is_some() || function(*hole, *shaft).is_some();
        let preferred: BTreeSet<Pair> = all.iter().filter(known).copied().collect();
        assert_eq!(set(&found(mm(size), wanted, Scope::Preferred)), preferred);
    }
}

#[test]
fn the_edition_decides_which_classes_there_are() {
    let of1988 = Options { edition: Edition::Of1988, ..Options::default() };
    let count = |options| {
        let found = search(mm("25"), wanted("-50", "50"), options, Scope::All, 1).unwrap();
        found.total
    };
    assert_eq!(count(Options::default()), every_pair(mm("25"), Options::default()).len());
    assert_eq!(count(of1988), every_pair(mm("25"), of1988).len());
    assert!(count(of1988) < count(Options::default()));
}

#[test]
fn where_nothing_fits_the_nearest_miss_is_named() {
    for size in SIZES {
        for (minimum, maximum) in [("0.1", "0.1"), ("0.0001", "0.0002"), ("-60", "-60"), ("60", "70")] {
            let wanted = wanted(minimum, maximum);
            let found = search(mm(size), wanted, Options::default(), Scope::All, 10).unwrap();
            let miss = found.nearest.unwrap();
            let (least, most) = (wanted.minimum.nanometres(), wanted.maximum.nanometres());
            let reach = |min: i64, max: i64| (least - min).max(0) + (max - most).max(0);
            let smallest = every_pair(mm(size), Options::default()).iter().map(|(_, min, max)| reach(*min, *max)).min();
            assert_eq!(Some(miss.below.nanometres() + miss.above.nanometres()), smallest, "{size} {minimum} {maximum}");
            let candidate = miss.candidate;
            assert_eq!(miss.below.nanometres(), (least - candidate.minimum.nanometres()).max(0));
            assert_eq!(miss.above.nanometres(), (candidate.maximum.nanometres() - most).max(0));
        }
    }
    let found = search(mm("25"), wanted("0.008", "0.041"), Options::default(), Scope::Preferred, 10).unwrap();
    assert_eq!(found.total, 0, "{:?}", found.candidates);
    let miss = found.nearest.unwrap();
    assert_eq!((miss.candidate.hole.as_str(), miss.candidate.shaft.as_str()), ("H7", "g6"));
    assert_eq!((miss.below, miss.above), (mm("0.001"), Length::ZERO));
}

#[test]
fn own_tables_count_for_the_classes_that_they_hold() {
    let own = |class: &str, upper: &str, lower: &str| {
        let cells = vec![Deviations::new(mm(upper), mm(lower)).ok()];
        let columns = vec![Column { class: class.parse().unwrap(), cells }];
        DeviationTable::new(&format!("{class}.tab"), false, vec![mm("400")], columns).unwrap()
    };
    let tables = [own("H7", "0.005", "0"), own("g6", "-0.007", "-0.01"), own("SPEC1", "0.003", "0.001")];
    let search = |sources: &Sources, wanted| search_in(mm("25"), wanted, sources, Scope::All, usize::MAX).unwrap();
    let has = |sources: &Sources, minimum, maximum, hole: &str, shaft: &str| {
        let found = search(sources, wanted(minimum, maximum));
        found.candidates.iter().any(|one| (one.hole.as_str(), one.shaft.as_str()) == (hole, shaft))
    };
    let standard = Sources::default().with_own(tables.clone());
    assert!(has(&standard, "0.007", "0.015", "H7", "g6"));
    assert!(!has(&Sources::default(), "0.007", "0.015", "H7", "g6"));
    assert!(has(&standard, "0.008", "0.013", "SPEC1", "g6"));
    assert!(has(&standard, "0", "0.026", "H6", "h6"), "the standard answers for what the tables do not have");
    let control = Sources::of_tables(tables);
    assert_eq!(search(&control, wanted("-1", "1")).total, 2);
    let beyond = search_in(mm("400.5"), wanted("-1", "1"), &control, Scope::All, 1).unwrap_err();
    assert_eq!(beyond.to_string(), "the tables have no classes for both hole and shaft at 400.5 mm");
}

#[test]
fn what_cannot_be_searched_is_refused() {
    let search = |size: &str, wanted| search(mm(size), wanted, Options::default(), Scope::All, 1).unwrap_err();
    let order = search("25", wanted("0.041", "0.007"));
    assert_eq!(order.to_string(), "smallest clearance 0.041 mm is above largest clearance 0.007 mm");
    assert_eq!(search("0", wanted("0", "1")), SearchError::NotPositive { nominal: mm("0") });
    assert_eq!(search("3150.000001", wanted("0", "1")), SearchError::TooLarge { nominal: mm("3150.000001") });
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn finds_the_same_at_any_size_and_for_any_range(
        size in 1_i64..600_000_000, middle in -100_000_i64..100_000, width in 0_i64..200_000,
    ) {
        let wanted = ClearanceRange { minimum: nm(middle), maximum: nm(middle + width) };
        let expected: BTreeSet<Pair> = every_pair(nm(size), Options::default())
            .iter()
            .filter(|(_, min, max)| middle <= *min && *max <= middle + width)
            .map(|(pair, ..)| *pair)
            .collect();
        prop_assert!(set(&found(nm(size), wanted, Scope::All)) == expected);
    }
}
