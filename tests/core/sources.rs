//! Where limits come from: own tables, the control's, ISO 286 and ISO 2768-1, and what each of them refuses.

use std::sync::Arc;

use fitcheck::length::Length;
use fitcheck::tolerance::iso286;
use fitcheck::tolerance::table::Column;
use fitcheck::tolerance::{Absent, DeviationTable, Deviations, DeviationsError, Feature, LimitsError, Source, Sources};
use fitcheck::words::{Language, Words};

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn pair(upper: i32, lower: i32) -> Option<Deviations> {
    Deviations::new(Length::from_micrometres(upper), Length::from_micrometres(lower)).ok()
}

fn table(name: &str, shipped: bool, columns: &[(&str, &[Option<Deviations>])]) -> DeviationTable {
    let columns = columns.iter().map(|(class, cells)| Column { class: class.parse().unwrap(), cells: cells.to_vec() });
    DeviationTable::new(name, shipped, vec![mm("1"), mm("3"), mm("6")], columns.collect()).unwrap()
}

fn shipped() -> Sources {
    Sources::of_tables(vec![
        table(
            "hole.tab",
            true,
            &[("H7", &[pair(10, 0), pair(10, 0), pair(12, 0)]), ("N9", &[None, pair(-4, -29), pair(0, -30)])],
        ),
        table("shaft.tab", true, &[("h7", &[pair(0, -10), pair(0, -10), pair(0, -12)]), ("g6", &[None; 3])]),
    ])
}

#[track_caller]
fn check(tables: &Sources, callout: &str, expected: &str) {
    let said = match tables.limits(&callout.parse().unwrap(), None) {
        Ok(limits) => format!("{} to {} from {}", limits.minimum(), limits.maximum(), limits.source),
        Err(error) => error.to_string(),
    };
    assert_eq!(said, expected, "for {callout}");
}

#[test]
fn a_range_end_belongs_to_the_range() {
    check(&shipped(), "3 H7", "3 to 3.01 from built-in table hole.tab, over 1 up to 3 mm");
    check(&shipped(), "3.000001 H7", "3.000001 to 3.012001 from built-in table hole.tab, over 3 up to 6 mm");
    check(&shipped(), "6 h7", "5.988 to 6 from built-in table shaft.tab, over 3 up to 6 mm");
}

#[test]
fn refusals_tell_the_way_out() {
    let tables = shipped();
    check(
        &tables,
        "6.000001 H7",
        "nominal size 6.000001 mm is beyond table hole.tab, whose last range is over 3 up to and including 6 mm",
    );
    check(&tables, "5 G6", "G6 is a hole class and table hole.tab does not have it; the shaft class is g6");
    check(&tables, "5 Z9", "Z9 is not in table hole.tab; it has H7 N9");
    check(&tables, "1 N9", "N9 is not defined over 0 up to 1 mm in table hole.tab; it is defined over 1 up to 6 mm");
    check(&tables, "5 g6", "g6 is not defined over 3 up to 6 mm in table shaft.tab; it is not defined at any size");
}

#[test]
fn a_users_table_comes_first_and_says_what_it_overrides() {
    let own = table("own.tab", false, &[("H7", &[pair(10, 0), pair(20, 0), None]), ("U1", &[pair(8, 3); 3])]);
    let tables = shipped().with_own(vec![own]);
    check(&tables, "5 U1", "5.003 to 5.008 from table own.tab, over 3 up to 6 mm");
    check(&tables, "2 H7", "2 to 2.02 from table own.tab, over 1 up to 3 mm");
    check(&tables, "5 H7", "H7 is not defined over 3 up to 6 mm in table own.tab; it is defined over 0 up to 3 mm");
    check(&tables, "5 N9", "4.97 to 5 from built-in table hole.tab, over 3 up to 6 mm");
    let instead = |callout: &str| match tables.limits(&callout.parse().unwrap(), None).unwrap().source {
        Source::Table { instead_of, .. } => instead_of,
        _ => None,
    };
    assert_eq!(instead("1 H7"), None, "the same as the standard");
    assert_eq!(instead("2 H7"), pair(10, 0));
    // U1 also happens to be a class of the standard: ES = -18 up to 3 mm.
    assert_eq!(instead("2 U1").map(|standard| standard.upper()), Some(Length::from_micrometres(-18)));
}

#[test]
fn a_users_table_of_the_same_name_takes_the_place() {
    let tables = shipped().with_own(vec![table("HOLE.TAB", false, &[("H7", &[pair(10, 0); 3])])]);
    check(&tables, "5 N9", "N9 is not in table HOLE.TAB; it has H7");
}

#[test]
fn iso_286_answers_what_a_users_table_does_not_hold() {
    let own = table("own.tab", false, &[("H7", &[pair(10, 0), pair(20, 0), None]), ("ABC1", &[pair(8, 3); 3])]);
    let sources = Sources::default().with_own(vec![own]);
    check(&sources, "2 H7", "2 to 2.02 from table own.tab, over 1 up to 3 mm");
    check(&sources, "5 H7", "H7 is not defined over 3 up to 6 mm in table own.tab; it is defined over 0 up to 3 mm");
    check(&sources, "6 ABC1", "6.003 to 6.008 from table own.tab, over 3 up to 6 mm");
    check(&sources, "6.000001 H7", "6.000001 to 6.015001 from ISO 286, over 6 up to 10 mm");
    check(&sources, "5 N9", "4.97 to 5 from ISO 286, over 3 up to 6 mm");
    let beyond = "nominal size 6.5 mm is beyond table own.tab, whose last range is over 3 up to and including 6 mm";
    check(&sources, "6.5 ABC1", beyond);
    check(&sources, "1 N9", "N9 is not defined at 1 mm in ISO 286; it is defined over 1 up to 3150 mm");
}

#[test]
fn absent_own_tables_are_awaited_or_told_with_every_class() {
    let folder: Arc<str> = "tables".into();
    let own = || vec![table("own.tab", false, &[("H7", &[pair(10, 0), pair(20, 0), pair(20, 0)])])];
    let sources = Sources::default().with_own(own());
    assert_eq!((sources.absent(), sources.own().len()), (None, 1));
    let awaited = sources.clone().with_absent(Some(Absent::Awaited(Arc::clone(&folder))));
    assert_eq!(awaited.absent(), Some(&Absent::Awaited(Arc::clone(&folder))));
    let refused = |callout: &str| awaited.limits(&callout.parse().unwrap(), None).unwrap_err();
    for class in ["5 H7", "5 g6"] {
        assert_eq!(refused(class), LimitsError::OwnAwaited { folder: Arc::clone(&folder) });
    }
    // No table has a say in what a callout states itself.
    let size = |sources: &Sources, callout: &str| {
        let limits = sources.limits(&callout.parse().unwrap(), None).unwrap();
        format!("{} to {} from {}", limits.minimum(), limits.maximum(), limits.source)
    };
    assert_eq!(size(&awaited, "12 ±0.01"), "11.99 to 12.01 from the callout itself");
    let unread = sources.with_absent(Some(Absent::Unread(Arc::clone(&folder))));
    let source = |callout: &str| unread.limits(&callout.parse().unwrap(), None).unwrap().source;
    assert!(matches!(source("5 g6"), Source::WithoutOwn { folder: named, .. } if named == folder));
    assert!(matches!(source("5 H7"), Source::Table { shipped: false, .. }));
}

#[test]
fn a_table_under_another_name_is_the_users_own() {
    let table = table("hole.tab", true, &[("H7", &[pair(10, 0); 3])]);
    assert!(table.shipped());
    let named = table.named("mine.tab");
    assert_eq!((named.name(), named.shipped(), named.ends()), ("mine.tab", false, table.ends()));
}

#[test]
fn callouts_without_letters_are_of_a_hole_a_shaft_or_neither() {
    #[track_caller]
    fn check(callout: &str, feature: Option<Feature>, expected: &str) {
        let said = match Sources::default().limits(&callout.parse().unwrap(), feature) {
            Ok(limits) => {
                let feature = limits.feature.map_or("neither", Feature::word);
                format!("{feature} {} to {} from {}", limits.minimum(), limits.maximum(), limits.source)
            }
            Err(error) => error.to_string(),
        };
        assert_eq!(said, expected, "for {callout} {feature:?}");
    }
    let (hole, shaft) = (Some(Feature::Hole), Some(Feature::Shaft));
    check("12 +0.01 -0.015", hole, "hole 11.985 to 12.01 from the callout itself");
    check("12 +0.01 -0.015", None, "neither 11.985 to 12.01 from the callout itself");
    check("12.01/11.985", shaft, "shaft 11.985 to 12.01 from the callout itself");
    // An odd number of nanometres: the middle is not a whole number of them, but the limits are exact.
    check("12.000001/12", shaft, "shaft 12 to 12.000001 from the callout itself");
    check("10m", shaft, "shaft 9.8 to 10.2 from ISO 2768-1 class m, over 6 up to 30 mm");
    check("25 H7/g6", shaft, "shaft 24.98 to 24.993 from ISO 286, over 18 up to 30 mm");
    check("25 H7/g6", hole, "hole 25 to 25.021 from ISO 286, over 18 up to 30 mm");
    check("25 H7/g6", None, "25 H7/g6 does not say whether the hole or the shaft is meant");
    check("10m", None, "neither 9.8 to 10.2 from ISO 2768-1 class m, over 6 up to 30 mm");
    // A cycle probes a hole or a shaft.
    let probed = |callout: &str, feature| {
        Sources::default().feature_limits(&callout.parse().unwrap(), feature).map(|limits| limits.feature)
    };
    let plain = "12 +0.01 -0.015";
    assert_eq!(probed(plain, None), Err(LimitsError::NoFeature { callout: plain.parse().unwrap() }));
    assert_eq!((probed(plain, hole), probed("25 h7", None)), (Ok(hole), Ok(shaft)));
    check("25 H7", shaft, "H7 is a hole class and not a shaft class");
    check("25 g6", hole, "g6 is a shaft class and not a hole class");
}

#[test]
fn rounded_js_is_told_with_the_source() {
    let options = iso286::Options { js: iso286::JsHalves::Rounded, ..iso286::Options::default() };
    let sources = Sources::default().with_options(options);
    check(&sources, "100 JS9", "99.957 to 100.043 from ISO 286, over 80 up to 120 mm; JS rounded as in 1988");
    check(&sources, "100 JS8", "99.973 to 100.027 from ISO 286, over 80 up to 120 mm");
}

#[test]
fn joined_ranges_are_said_in_every_language() {
    let (class, table): (_, Arc<str>) = ("H7".parse().unwrap(), "own.tab".into());
    let defined = [("0", "1"), ("3", "6.5"), ("10", "18")].map(|(over, to)| (mm(over), mm(to))).to_vec();
    let error = LimitsError::NotDefined { class, table, over: mm("1"), to: mm("3"), defined };
    assert_eq!(
        Words::new(Language::Nl).told(&error),
        "H7 is niet gedefinieerd boven 1 tot en met 3 mm in tabel own.tab; wel boven 0 tot en met 1 mm, \
         boven 3 tot en met 6,5 mm, boven 10 tot en met 18 mm"
    );
}

#[test]
fn shapes_that_cannot_be_right_are_refused() {
    let column = |class: &str, cells: usize| Column { class: class.parse().unwrap(), cells: vec![None; cells] };
    let said = |ends: &[&str], columns: Vec<Column>| {
        DeviationTable::new("x", false, ends.iter().map(|end| mm(end)).collect(), columns).unwrap_err().to_string()
    };
    assert_eq!(said(&[], vec![]), "the table has no size range");
    assert_eq!(said(&["3", "3"], vec![]), "size range up to 3 mm does not end above the one before it, 3 mm");
    assert_eq!(said(&["3"], vec![column("H7", 2)]), "column H7 has 2 cells for 1 size ranges");
    assert_eq!(said(&["3"], vec![column("H7", 1), column("H7", 1)]), "column H7 occurs twice");
}

#[test]
fn lengths_in_a_sentence_have_the_sign_of_its_language() {
    let um = Length::from_micrometres;
    let error = DeviationsError { upper: um(-12), lower: um(7) };
    let dutch = "bovenafwijking \u{2212}0,012 mm ligt onder onderafwijking 0,007 mm";
    assert_eq!(Words::new(Language::Nl).told(&error), dutch);
}

#[test]
fn deviations_in_the_wrong_order_are_refused() {
    let um = Length::from_micrometres;
    assert!(Deviations::new(um(0), um(0)).is_ok());
    let error = Deviations::new(um(-1), um(0)).unwrap_err();
    assert_eq!(error.to_string(), "upper deviation -0.001 mm is below lower deviation 0 mm");
}

#[test]
fn how_far_one_pair_of_deviations_lies_above_another_is_told_for_each() {
    let (own, standard) = (pair(25, -3).unwrap(), pair(21, 0).unwrap());
    let um = Length::from_micrometres;
    assert_eq!(own.minus(&standard), (um(4), um(-3)));
    assert_eq!(standard.minus(&own), (um(-4), um(3)));
    assert_eq!(own.minus(&own), (Length::ZERO, Length::ZERO));
}

#[test]
fn the_ends_of_the_steps_are_those_of_the_standard_and_of_all_tables_each_once() {
    let ends = |sources: &Sources| sources.step_ends().iter().map(ToString::to_string).collect::<Vec<_>>();
    let standard: Vec<String> = iso286::step_ends().map(|end| end.to_string()).collect();
    assert_eq!(ends(&Sources::default()), standard);
    assert_eq!(standard.len(), 42);
    let column = |cells: usize| Column { class: "U1".parse().unwrap(), cells: vec![pair(1, 0); cells] };
    let own = DeviationTable::new("own.tab", false, vec![mm("0.5"), mm("6"), mm("4000")], vec![column(3)]).unwrap();
    let all = ends(&Sources::default().with_own([own]));
    assert_eq!((all.len(), all.first(), all.last()), (44, Some(&"0.5".to_owned()), Some(&"4000".to_owned())));
}

#[test]
fn a_class_is_shown_as_it_is_written_also_to_whoever_looks_for_an_error() {
    assert_eq!(format!("{:?}", "js13".parse::<fitcheck::tolerance::ToleranceClass>().unwrap()), "js13");
}
