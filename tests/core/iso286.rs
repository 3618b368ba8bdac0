//! Compares ISO 286 with independent transcriptions of the standard, cell by cell (`tests/data/iso286/README.md`).

use std::collections::{BTreeMap, BTreeSet};

use fitcheck::length::{Length, Unit};
use fitcheck::tolerance::iso286::{self, Grade, Letter, Options};
use fitcheck::tolerance::{Feature, ToleranceClass};
use proptest::prelude::*;

type Record = BTreeMap<String, String>;

fn rows(name: &str) -> Vec<Record> {
    let path = format!("{}/tests/data/iso286/{name}", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::Reader::from_path(path).unwrap();
    reader.deserialize().collect::<Result<_, _>>().unwrap()
}

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn um(text: &str) -> Length {
    Length::parse_in(text, Unit::Micrometre).unwrap()
}

fn nm(nanometres: i64) -> Length {
    Length::from_nanometres(nanometres).unwrap()
}

/// A size just above a bound, in the middle, and on the upper bound.
fn probes(over: Length, to: Length) -> [Length; 3] {
    [nm(over.nanometres() + 1), nm(i64::midpoint(over.nanometres(), to.nanometres())), to]
}

fn grade_number(text: &str) -> usize {
    ["01", "0"].iter().position(|fine| *fine == text).unwrap_or_else(|| text.parse::<usize>().unwrap() + 1)
}

/// All steps of the transcriptions, with the one at 1 mm.
fn steps() -> Vec<(Length, Length)> {
    let ends = "1 3 6 10 14 18 24 30 40 50 65 80 100 120 140 160 180 200 225 250 280 315 355 400 450 500 560 630 710 \
                800 900 1000 1120 1250 1400 1600 1800 2000 2240 2500 2800 3150";
    let ends: Vec<Length> = ends.split_whitespace().map(mm).collect();
    std::iter::once(Length::ZERO).chain(ends.iter().copied()).zip(ends.iter().copied()).collect()
}

/// What the transcriptions say: (class, step number) to upper and lower deviation.
fn transcribed(feature: Feature, edition_1988: bool) -> BTreeMap<(String, usize), (Length, Length)> {
    let steps = steps();
    let within = |row: &Record, (over, to): (Length, Length)| mm(&row["over_mm"]) <= over && to <= mm(&row["to_mm"]);
    let mut widths = BTreeMap::new();
    for row in rows("it_grades.csv") {
        for (number, step) in steps.iter().enumerate() {
            if within(&row, *step) {
                widths.insert((row["grade"].trim_start_matches("IT").to_owned(), number), um(&row["um"]));
            }
        }
    }
    let grades: Vec<String> = Grade::all().map(|grade| grade.to_string()).collect();
    let (file, js) = match feature {
        Feature::Hole => ("fundamental_deviations_holes.csv", "JS"),
        Feature::Shaft => ("fundamental_deviations_shafts.csv", "js"),
    };
    let deltas = rows("delta.csv");
    let delta = |grade: &str, step: (Length, Length)| -> Length {
        let row = deltas.iter().find(|row| within(row, step)).unwrap();
        um(&row[&format!("IT{grade}")])
    };
    let mut cells = BTreeMap::new();
    for ((grade, number), width) in &widths {
        let half = nm(width.nanometres() / 2);
        cells.insert((format!("{js}{grade}"), *number), (half, half.negated()));
    }
    for row in rows(file) {
        if edition_1988 && row["edition"] == "2010" {
            continue;
        }
        let range = grade_number(&row["grade_from"])..=grade_number(&row["grade_to"]);
        for grade in range.map(|number| &grades[number]) {
            for (number, step) in steps.iter().enumerate().filter(|(_, step)| within(&row, **step)) {
                let Some(width) = widths.get(&(grade.clone(), number)) else { continue };
                let mut deviation = um(&row["um"]);
                if row.get("plus_delta").is_some_and(|plus| plus == "yes") {
                    deviation = deviation.checked_add(delta(grade, *step)).unwrap();
                }
                let pair = match row["limit"].to_ascii_lowercase().as_str() {
                    "es" => (deviation, deviation.checked_sub(*width).unwrap()),
                    "ei" => (deviation.checked_add(*width).unwrap(), deviation),
                    other => panic!("{other}"),
                };
                let before = cells.insert((format!("{}{grade}", row["letter"]), number), pair);
                assert_eq!(before, None, "{row:?} twice");
            }
        }
    }
    cells
}

/// Every letter, grade and step, defined or refused; returns how many are defined.
fn agree_in_every_cell(feature: Feature, options: Options) -> usize {
    let cells = transcribed(feature, options.edition == iso286::Edition::Of1988);
    let mut defined = 0;
    for (number, (over, to)) in steps().into_iter().enumerate() {
        for letter in Letter::ALL {
            for grade in Grade::all() {
                let class = iso286::class(feature, letter, grade);
                let expected = cells.get(&(class.to_string(), number));
                defined += usize::from(expected.is_some());
                // Only the ends: a zone is constant within a step, which the 47 classes below show.
                for nominal in [nm(over.nanometres() + 1), to] {
                    let found = iso286::deviations(class, nominal, options);
                    let found = found.ok().map(|cell| (cell.deviations.upper(), cell.deviations.lower()));
                    assert_eq!(found.as_ref(), expected, "{nominal} {class}");
                }
            }
        }
    }
    assert_eq!(defined, cells.len());
    defined
}

#[test]
fn every_hole_class_agrees_with_the_transcriptions_at_every_step() {
    assert!(10_000 < agree_in_every_cell(Feature::Hole, Options::default()));
}

#[test]
fn every_shaft_class_agrees_with_the_transcriptions_at_every_step() {
    assert!(10_000 < agree_in_every_cell(Feature::Shaft, Options::default()));
}

#[test]
fn the_1988_edition_lacks_cd_ef_and_fg_above_10_mm() {
    let old = Options { edition: iso286::Edition::Of1988, ..Options::default() };
    // Three letters, six sub-steps, twenty grades.
    let shafts = agree_in_every_cell(Feature::Shaft, old);
    assert_eq!(transcribed(Feature::Shaft, false).len() - shafts, 3 * 6 * 20);
    for class in ["CD8", "EF8", "FG8"] {
        let defined = |nominal| iso286::deviations(class.parse().unwrap(), mm(nominal), old).is_ok();
        assert!(defined("10") && !defined("10.000001"), "{class}");
    }
}

#[test]
fn the_47_classes_of_the_control_tables_agree_with_published_limits() {
    let rows = rows("limits_47_classes.csv");
    assert_eq!(rows.len(), 1927);
    for row in rows {
        let class: ToleranceClass = row["class"].parse().unwrap();
        for nominal in probes(mm(&row["over_mm"]), mm(&row["to_mm"])) {
            let cell = iso286::deviations(class, nominal, Options::default()).unwrap();
            let expected = (um(&row["upper_um"]), um(&row["lower_um"]));
            assert_eq!((cell.deviations.upper(), cell.deviations.lower()), expected, "{nominal} {class}");
        }
    }
}

#[test]
fn the_classes_offered_first_are_those_of_the_control_tables_and_the_preferred_ones() {
    let control: BTreeSet<String> = rows("limits_47_classes.csv").into_iter().map(|row| row["class"].clone()).collect();
    assert_eq!(control.len(), 47);
    let mut expected = control;
    for feature in [Feature::Hole, Feature::Shaft] {
        let preferred: Vec<String> = iso286::preferred_classes(feature).map(|class| class.to_string()).collect();
        assert_eq!(preferred.len(), 17, "figures 10 and 11 of ISO 286-1:2010");
        expected.extend(preferred);
    }
    let usual = [Feature::Hole, Feature::Shaft].into_iter().flat_map(iso286::usual_classes);
    let usual: Vec<String> = usual.map(|class| class.to_string()).collect();
    assert_eq!(usual.len(), expected.len());
    assert_eq!(usual.into_iter().collect::<BTreeSet<_>>(), expected);
}

#[test]
fn the_spot_checks_are_answered_or_refused() {
    for row in rows("spot_checks.csv") {
        let (nominal, class) = row["callout"].split_once(' ').unwrap();
        let found = iso286::deviations(class.parse().unwrap(), mm(nominal), Options::default());
        let found = found.ok().map(|cell| (cell.deviations.upper(), cell.deviations.lower()));
        let expected = (row["error"].is_empty()).then(|| (um(&row["upper_um"]), um(&row["lower_um"])));
        assert_eq!(found, expected, "{row:?}");
    }
}

#[test]
fn hole_and_shaft_basis_give_the_same_clearances() {
    // Fits Hn/x(n−1) and Xn/h(n−1): K, M, N to n = 8 and P to ZC to n = 7, above 3 up to 500 mm.
    let (mut compared, mut different) = (0, Vec::new());
    for nominal in steps().into_iter().map(|(_, to)| to).filter(|to| mm("3") < *to && *to <= mm("500")) {
        for letter in Letter::ALL.into_iter().filter(|letter| Letter::K <= *letter) {
            for grade in 3..=if letter <= Letter::N { 8 } else { 7 } {
                let get = |feature, letter, grade: u8| {
                    let class = iso286::class(feature, letter, Grade::numbered(grade).unwrap());
                    iso286::deviations(class, nominal, Options::default()).ok().map(|cell| cell.deviations)
                };
                let clearances = |hole_letter, shaft_letter| {
                    let (hole, shaft) =
                        (get(Feature::Hole, hole_letter, grade)?, get(Feature::Shaft, shaft_letter, grade - 1)?);
                    Some((
                        hole.upper().checked_sub(shaft.lower()).unwrap(),
                        hole.lower().checked_sub(shaft.upper()).unwrap(),
                    ))
                };
                let (Some(hole_basis), Some(shaft_basis)) =
                    (clearances(Letter::H, letter), clearances(letter, Letter::H))
                else {
                    continue;
                };
                compared += 1;
                if hole_basis != shaft_basis {
                    different.push((letter, grade, nominal.to_string()));
                }
            }
        }
    }
    // The exceptions that follow from the tables: M6 above 250 up to 315 mm; K3 and K4, where k2 and k3 have ei = 0.
    let stated = |(letter, grade, nominal): &(Letter, u8, String)| match letter {
        Letter::M => *grade == 6 && ["280", "315"].contains(&nominal.as_str()),
        Letter::K => *grade == 3 || *grade == 4,
        _ => false,
    };
    assert!(different.iter().all(stated), "{different:?}");
    assert_eq!(different.iter().filter(|(letter, ..)| *letter == Letter::M).count(), 2);
    assert_eq!(compared, 1812);
}

proptest! {
    #[test]
    fn a_zone_is_as_wide_as_its_standard_tolerance(
        letter in 0..Letter::ALL.len(), grade in 0..20_usize, hole: bool, nanometres in 1..3_150_000_000_i64,
    ) {
        let (feature, nominal) = (if hole { Feature::Hole } else { Feature::Shaft }, nm(nanometres));
        let grade = Grade::all().nth(grade).unwrap();
        let class = iso286::class(feature, Letter::ALL[letter], grade);
        if let Ok(cell) = iso286::deviations(class, nominal, Options::default()) {
            prop_assert!(cell.deviations.lower() <= cell.deviations.upper());
            prop_assert!(cell.over < nominal && nominal <= cell.to);
            prop_assert_eq!(Some(cell.deviations.width()), iso286::standard_tolerance(grade, nominal));
            if Letter::ALL[letter] <= Letter::H {
                let mirror = iso286::deviations(class.other_case(), nominal, Options::default()).unwrap().deviations;
                prop_assert_eq!(cell.deviations.upper(), mirror.lower().negated());
                prop_assert_eq!(cell.deviations.lower(), mirror.upper().negated());
            }
        }
    }
}
