//! The fit page without a window: what its fields mean and what its commands do.

#![cfg(test)]

use fitcheck::length::Length;
use fitcheck::session::{
    Action, CheckCommand, CheckField, Command, Field, FitCommand, FitField, Mark, MeasuredParts, Page, Session, Step,
    extremes,
};
use fitcheck::tolerance::fit::FitKind;
use fitcheck::tolerance::fit::search::Scope;
use fitcheck::tolerance::iso286::Letter;
use fitcheck::tolerance::table::Column;
use fitcheck::tolerance::{Base, DeviationTable, Deviations, Feature, ToleranceClass};
use fitcheck::verdict::Status;
use fitcheck::words::{Language, Words};
use jiff::civil::date;

fn apply(session: &mut Session, command: Command) {
    assert_eq!(session.apply(command, date(2026, 11, 21).at(10, 42, 7, 0)), []);
}

fn with(fields: &[(FitField, &str)]) -> Session {
    let mut session = Session::new(Language::En);
    apply(&mut session, Command::OpenPage(Page::Fit));
    for (field, text) in fields {
        apply(&mut session, Field::from(*field).typed((*text).to_owned()));
    }
    session
}

fn fit(callout: &str) -> Session {
    with(&[(FitField::Callout, callout)])
}

fn class(text: &str) -> ToleranceClass {
    text.parse().unwrap()
}

fn um(um: i32) -> Length {
    Length::from_micrometres(um)
}

fn told(session: &Session, field: FitField) -> String {
    session.error(field).map(|error| Words::new(Language::En).say(error)).unwrap_or_default()
}

#[test]
fn the_kind_and_its_clearances() {
    #[track_caller]
    fn check(callout: &str, kind: FitKind, minimum: i32, maximum: i32) {
        let session = fit(callout);
        let fit = session.fit().fit.as_ref().unwrap();
        assert_eq!((fit.kind(), fit.minimum_clearance(), fit.maximum_clearance()), (kind, um(minimum), um(maximum)));
    }
    check("50 H7/p6", FitKind::Interference, -42, -1);
    check("2 H7/p6", FitKind::Transition, -12, 4);
    check("25 H7/h6", FitKind::Clearance, 0, 34);
    check("Ø25 H7-g6", FitKind::Clearance, 7, 41);
}

#[test]
fn a_callout_that_is_no_fit_says_what_is_missing() {
    for (typed, hint) in [
        ("25 H7", Some("fit-shaft-missing")),
        ("25 g6", Some("fit-hole-missing")),
        ("25 ±0.1", Some("fit-classes-missing")),
        ("10m", Some("fit-classes-missing")),
        ("25 H7/g6", None),
        ("", None),
    ] {
        let session = fit(typed);
        assert_eq!(session.fit().hint.as_ref().map(|hint| hint.id), hint, "{typed}");
        assert_eq!(told(&session, FitField::Callout), "", "{typed}");
    }
    let session = fit("25 H7/");
    assert_ne!(told(&session, FitField::Callout), "");
    assert_eq!(session.fit().class(Feature::Hole), Some(class("H7")), "the half that is there is known");
    let session = fit("25 X7g/g6");
    assert!(session.culprit(FitField::Callout).is_some(), "{}", told(&session, FitField::Callout));
    assert!(session.culprit(CheckField::Callout).is_none());
}

#[test]
fn commands_keep_the_size_as_it_is_typed() {
    let mut session = fit("25,5 H7/g6");
    let text = |session: &Session| session.text(FitField::Callout).to_owned();
    apply(&mut session, Command::Fit(FitCommand::ChooseClass(class("k6"))));
    assert_eq!(text(&session), "25,5 H7/k6");
    apply(&mut session, Command::Fit(FitCommand::ChooseClass(class("F8"))));
    assert_eq!(text(&session), "25,5 F8/k6");
    apply(&mut session, Command::Fit(FitCommand::TakePair(class("H11"), class("c11"))));
    assert_eq!(text(&session), "25,5 H11/c11");
    let mut session = fit("");
    apply(&mut session, Command::Fit(FitCommand::TakePair(class("H7"), class("g6"))));
    assert_eq!(text(&session), "H7/g6");
    assert_ne!(told(&session, FitField::Callout), "", "the size is missing");
}

#[test]
fn parts_are_judged_with_both_borders() {
    #[track_caller]
    fn check(hole: &str, shaft: &str, clearance: &str, conforms: bool, verdicts: (Status, Status)) {
        let session = with(&[
            (FitField::Callout, "50 H7/p6"),
            (FitField::measured(Feature::Hole), hole),
            (FitField::measured(Feature::Shaft), shaft),
        ]);
        let Some(MeasuredParts::Both(actual)) = session.fit().parts() else { panic!("no parts") };
        assert_eq!((actual.clearance.to_string().as_str(), actual.conforms), (clearance, conforms));
        assert_eq!((actual.hole_verdict.status(), actual.shaft_verdict.status()), verdicts);
    }
    use Status::{Good, Rework, Scrap};
    check("50.010", "50,030", "-0.02", true, (Good, Good));
    check("50", "50.042", "-0.042", true, (Good, Good));
    check("49.999999", "50.042", "-0.042001", false, (Rework, Good));
    check("50.025", "50.026", "-0.001", true, (Good, Good));
    check("50.025", "50.025999", "-0.000999", false, (Good, Scrap));
    // Both are out, but their clearance is allowed.
    check("50.030", "50.050", "-0.02", true, (Scrap, Rework));
}

#[test]
fn the_temperature_changes_the_clearance() {
    let mut session = with(&[
        (FitField::Callout, "50 H7/p6"),
        (FitField::HoleMeasured, "50.010"),
        (FitField::ShaftMeasured, "50.030"),
        (FitField::expansion(Feature::Hole), "23,1"),
    ]);
    assert!(session.fit().warm().is_none(), "20 °C is the size itself");
    apply(&mut session, Field::from(FitField::Temperature).typed("80".into()));
    let warm = session.fit().warm().unwrap();
    // (23.1 − 11.5) · 60 · 50 mm
    assert_eq!(warm.change.nanometres(), 34_800);
    assert_eq!((warm.minimum.nanometres(), warm.maximum.nanometres()), (-7_200, 33_800));
    assert_eq!(warm.actual.map(Length::nanometres), Some(14_800));
    apply(&mut session, Command::Fit(FitCommand::ChooseExpansion(Feature::Hole, "11.5".parse().unwrap())));
    assert_eq!(session.fit().warm().unwrap().change, Length::ZERO);
    apply(&mut session, Field::from(FitField::Temperature).typed("hot".into()));
    assert!(session.fit().warm().is_none());
    assert_eq!(told(&session, FitField::Temperature), "hot is not a number");
}

#[test]
fn an_expansion_is_written_as_the_language_does() {
    let mut session = Session::new(Language::Nl);
    apply(&mut session, Command::Fit(FitCommand::ChooseExpansion(Feature::Shaft, "23.1".parse().unwrap())));
    assert_eq!(session.text(FitField::ShaftExpansion), "23,1");
}

#[test]
fn a_search_counts_all_and_lists_the_best() {
    let mut session =
        with(&[(FitField::Callout, "25"), (FitField::WantedMinimum, "0.007"), (FitField::WantedMaximum, "41 µm")]);
    let found = |session: &Session| session.fit().found().unwrap().unwrap().clone();
    let all = found(&session);
    assert!(all.candidates.len() <= all.total);
    assert!(all.candidates.iter().any(|pair| (pair.hole, pair.shaft) == (class("H7"), class("g6"))));
    apply(&mut session, Command::Fit(FitCommand::SearchAmong(Scope::Preferred)));
    assert!(found(&session).total < all.total);
    apply(&mut session, Field::from(FitField::WantedMinimum).typed("0.042".into()));
    let problem = session.fit().found().unwrap().unwrap_err().id;
    assert_eq!(problem, "fit-search-order");
    apply(&mut session, Field::from(FitField::WantedMinimum).typed(String::new()));
    assert!(session.fit().found().is_none());
    apply(&mut session, Field::from(FitField::WantedMinimum).typed("0.0409".into()));
    let none = found(&session);
    assert_eq!((none.total, none.candidates.len(), none.nearest.is_some()), (0, 0, true));
}

#[test]
fn the_map_holds_what_the_sources_define() {
    let session = fit("25 H7/g6");
    let map = session.fit().map(Feature::Hole).unwrap();
    let seven = map.grades().find(|grade| grade.to_string() == "7").unwrap();
    let cell = map.cell(Letter::H, seven).unwrap();
    assert_eq!((cell.lower_um, cell.upper_um), (0.0, 21.0));
    assert!(map.has(class("T7")) && !map.has(class("J9")));
    assert_eq!(map.next(class("H7"), Step::Right), Some(class("J7")));
    assert_eq!(map.next(class("J8"), Step::Down), None);
    assert_eq!(map.next(class("A7"), Step::Left), None);
    assert_eq!(map.next(class("H01"), Step::Up), None);
    assert_eq!(map.first(), Some(class("H7")));
    assert!(!fit("24 H7/g6").fit().map(Feature::Hole).unwrap().has(class("T7")));
    assert!(fit("3151 H7/g6").fit().map(Feature::Hole).unwrap().is_empty());
}

#[test]
fn the_map_and_the_limits_follow_the_sources() {
    let mut session = fit("25 H7/g6");
    let count = |session: &Session| {
        let map = session.fit().map(Feature::Hole).unwrap();
        map.grades().flat_map(|grade| Letter::ALL.map(|letter| map.cell(letter, grade))).flatten().count()
    };
    assert!(300 < count(&session));
    apply(&mut session, Command::UseSource(Base::ControlTables));
    assert!(0 < count(&session) && count(&session) <= 47);
    assert!(session.fit().fit.is_some());
    apply(&mut session, Field::from(FitField::Callout).typed("25 H7/zc9".into()));
    assert!(told(&session, FitField::Callout).contains("zc9 is not in table"));
}

#[test]
fn the_equivalent_fit_says_whether_it_is_the_same() {
    let session = fit("25 H7/p6");
    let equivalent = session.fit().equivalent.as_ref().unwrap();
    assert_eq!((equivalent.hole, equivalent.shaft), (class("P7"), class("h6")));
    assert!(equivalent.difference.as_ref().unwrap().is_none());
    let session = fit("25 H7/p7");
    let difference = session.fit().equivalent.as_ref().unwrap().difference.clone().unwrap();
    assert_eq!((difference.minimum, difference.maximum), (um(8), um(8)));
    assert!(fit("25 H7/h6").fit().equivalent.is_none());
}

#[test]
fn ends_are_named_by_what_they_are() {
    for ((minimum, maximum), expected) in [
        ((7, 41), [("fit-maximum-clearance", 41), ("fit-minimum-clearance", 7)]),
        ((0, 34), [("fit-maximum-clearance", 34), ("fit-minimum-clearance", 0)]),
        ((-12, 4), [("fit-maximum-clearance", 4), ("fit-maximum-interference", 12)]),
        ((-42, -1), [("fit-minimum-interference", 1), ("fit-maximum-interference", 42)]),
        ((-42, 0), [("fit-minimum-interference", 0), ("fit-maximum-interference", 42)]),
    ] {
        assert_eq!(extremes(um(minimum), um(maximum)), expected.map(|(id, amount)| (id, um(amount))));
    }
}

#[test]
fn the_picture_shows_zones_zero_line_and_near_parts() {
    let picture = |hole: &str, shaft: &str| {
        let fields =
            [(FitField::Callout, "25 H7/g6"), (FitField::HoleMeasured, hole), (FitField::ShaftMeasured, shaft)];
        with(&fields).fit().picture().unwrap()
    };
    let near = picture("25.012", "24.970");
    assert_eq!((near.hole.lower_um, near.hole.upper_um, near.hole.fundamental_um), (0.0, 21.0, Some(0.0)));
    assert_eq!((near.shaft.lower_um, near.shaft.upper_um, near.shaft.fundamental_um), (-20.0, -7.0, Some(-7.0)));
    assert_eq!(near.hole.mark, Some(Mark::InSight(12.0)));
    assert_eq!(near.shaft.mark, Some(Mark::InSight(-30.0)));
    assert!(near.axis_min_um < -30.0 && 21.0 < near.axis_max_um);
    let far = picture("26", "24");
    assert_eq!((far.hole.mark, far.shaft.mark), (Some(Mark::Above), Some(Mark::Below)));
    assert!(-60.0 < far.axis_min_um && far.axis_max_um < 60.0, "the zones are not squeezed: {far:?}");
    let even = fit("25 JS7/h6").fit().picture().unwrap();
    assert_eq!((even.hole.fundamental_um, even.shaft.fundamental_um), (None, Some(0.0)));
}

#[test]
fn a_side_goes_to_the_check_page_and_enter_measures_only_there() {
    let mut session = fit("25,5 H7/g6");
    apply(&mut session, Field::from(CheckField::Measured).typed("25.6".into()));
    assert_eq!(Action::on_enter(FitField::HoleMeasured.into(), session.page()), None);
    apply(&mut session, Command::Fit(FitCommand::Check(Feature::Shaft)));
    assert_eq!((session.page(), session.text(CheckField::Callout)), (Page::Check, "25,5 g6"));
    apply(&mut session, Command::Check(CheckCommand::Measure));
    assert_eq!(session.history().len(), 1);
}

#[test]
fn a_search_follows_the_sources() {
    let wanted = [(FitField::WantedMinimum, "0.001"), (FitField::WantedMaximum, "0.041")];
    let mut session = with(&[&[(FitField::Callout, "25 H7/g6")][..], &wanted].concat());
    let total = |session: &Session| session.fit().found().unwrap().unwrap().total;
    let all = total(&session);
    apply(&mut session, Command::UseSource(Base::ControlTables));
    assert!(total(&session) < all, "the control has 47 classes");
    let pairs = session.fit().found().unwrap().unwrap().candidates.clone();
    assert!(pairs.iter().all(|pair| session.fit().is_defined(pair.hole, pair.shaft)));
    // The first column of the built-in table of holes in a table of the user's own, 4 µm higher.
    let ends = vec!["400".parse().unwrap()];
    let deviations = Deviations::new("0.025".parse().unwrap(), "0.004".parse().unwrap()).unwrap();
    let column = Column { class: class("H7"), cells: vec![Some(deviations)] };
    let own = DeviationTable::new("own.tab", false, ends, vec![column]).unwrap();
    apply(&mut session, Command::TablesRead { folder: "own".into(), result: Ok((vec![own], Vec::new())) });
    let found = session.fit().found().unwrap().unwrap();
    let pair = found.candidates.iter().find(|pair| (pair.hole, pair.shaft) == (class("H7"), class("h5")));
    assert_eq!(
        pair.map(|pair| (pair.minimum.to_string(), pair.maximum.to_string())),
        Some(("0.004".into(), "0.034".into()))
    );
}

#[test]
fn a_joint_shows_the_press_fit_and_an_unknown_material_says_so() {
    let joint = |shaft: &'static str, expansion: &'static str| {
        with(&[
            (FitField::Callout, "40 H7/p6"),
            (FitField::PressLength, "30"),
            (FitField::HubOuter, "80"),
            (FitField::ShaftBore, shaft),
            (FitField::HoleExpansion, expansion),
        ])
    };
    let session = joint("", "11.5");
    let press = session.fit().press().unwrap().unwrap();
    assert!(press.torque.is_some() && press.is_elastic() == Some(true), "{press:?}");
    let session = joint("40", "11.5");
    assert!(session.fit().press().unwrap().is_err());
    let session = joint("0", "11.4");
    assert_eq!(session.fit().press().unwrap().unwrap_err().id, "fit-press-material");
    assert!(with(&[(FitField::Callout, "40 H7/p6")]).fit().press().is_none());
}
