//! Part plans as files: TOML and CSV, every fault at once with its place, and what is written reads back.

use std::collections::BTreeSet;

use fitcheck::length::Length;
use fitcheck::part::{Column, Document, Draft, DraftFeature, HeadField, Plan, PlanFault};
use fitcheck::tolerance::{Feature, Sources};
use proptest::prelude::*;

use crate::plans::{plan, read};

const FLANGE: &str = r#"
fitcheck_plan = 1
part = "Flange 4711"
drawing = "4711-B"
picture = "flange.png"
material = "Steel"
rule = "iso14253-2017"
u_um = 1.2
travel_x = [-250, 250]

[[feature]]
number = 1
name = "BORE_A"
callout = "25 H7"
x = 40
y = 30.5
z = -8
balloon_x = 0.25
balloon_y = 0.5

[[feature]]
number = 2
name = "PIN"
callout = "20 ±0.01"
feature = "shaft"
rule = "fixed=2"
remark = "after grinding"

[[feature]]
number = "3a"
name = "K1"
kind = "pocket"
callout = "40 H7"
callout2 = "25 H8"
x = 0
y = 0
z = -8
cycle = 423
parameters = "Q301=1 Q281=0"
"#;

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

#[test]
fn a_plan_has_what_its_file_says() {
    let plan = plan(FLANGE);
    assert_eq!((plan.head.part.as_str(), plan.head.picture.as_str()), ("Flange 4711", "flange.png"));
    let [bore, pin, pocket] = plan.features() else { panic!("{plan:?}") };
    assert_eq!(
        (bore.number.as_str(), bore.name.as_str(), bore.place),
        ("1", "BORE_A", Some(["40", "30.5", "-8"].map(mm)))
    );
    assert_eq!((bore.limits[0].minimum(), bore.limits[0].maximum()), (mm("25"), mm("25.021")));
    assert_eq!(bore.balloon, Some([0.25, 0.5]));
    assert_eq!(bore.rule.unwrap().name().word(), "iso14253-2017");
    assert_eq!(bore.material.as_ref().unwrap().name, "Steel");
    assert_eq!((pin.feature(), pin.place, pin.rule.unwrap().name().word()), (Some(Feature::Shaft), None, "fixed"));
    assert_eq!((pin.limits[0].minimum(), pin.limits[0].maximum()), (mm("19.99"), mm("20.01")));
    assert_eq!((pocket.number.as_str(), pocket.cycle.unwrap().code), ("3a", "423"));
    let sizes: Vec<String> = plan.sizes().map(|size| format!("{} {}", size.name(), size.callout.unwrap())).collect();
    assert_eq!(sizes, ["BORE_A 25 H7", "PIN 20 ±0.01", "K1 X 40 H7", "K1 Y 25 H8"]);
}

#[test]
fn every_mistake_is_told_at_once_with_line_and_character() {
    let text = "\
fitcheck_plan = 1
drwaing = 3
travel_x = [250, -250]
travel_z = [-100, 0]

[[feature]]
name = \"A\"
callout = \"25 H99\"
x = \"4O\"
z = -8

[[feature]]
name = \"a\"
kind = \"groove\"
callout = \"25 H7\"
z = -100.001

[[feature]]
callout = true
rule = \"isso\"
material = \"cheese\"
balloon_x = 2
colour = \"red\"

[[feature]]
name = \"B\"
callout = \"25 H7\"
parameters = \"Q423=3 Q999=1\"
";
    let errors = read(text, &Sources::default()).unwrap_err();
    let begins = [
        "line 2, column 1: unknown key drwaing: expected ",
        "line 3, column 12: 250 -250 is not a travel",
        "line 8, column 11: 25 H99: ",
        "line 9, column 5: x: 4O is not a number",
        "line 13, column 8: name a occurs twice",
        "line 14, column 8: kind groove is not known",
        "line 16, column 5: Z-100.001 is outside the machine's travel, -100 to 0 mm",
        "line 18, column 1: callout is missing",
        "line 19, column 11: callout: expected a text or a number, found boolean",
        "line 20, column 8: rule isso is not known: expected simple, iso14253-2017",
        "line 21, column 12: unknown material cheese",
        "line 22, column 13: 2 is not a place on the picture",
        "line 23, column 1: unknown key colour",
        "line 28, column 14: cycle 421 does not take Q999=1 from a plan",
    ];
    for begin in begins {
        assert!(errors.iter().any(|error| error.starts_with(begin)), "{begin}: {errors:#?}");
    }
    assert_eq!(errors.len(), begins.len(), "{errors:#?}");
    let lines: Vec<usize> =
        errors.iter().filter_map(|error| error.strip_prefix("line ")?.split([',', ':']).next()?.parse().ok()).collect();
    assert!(lines.is_sorted(), "{errors:#?}");
}

/// Every cell of the first feature is wrong, and each has its own fault.
const WRONG: &str = r#"fitcheck_plan = 1
drwaing = 3
travel_x = [250, -250]
travel_z = [-100, 60]

[[feature]]
number = "1"
name = "A"
kind = "groove"
axis = "W"
callout = "twenty five"
callout2 = "wide"
x = "4O"
angle = 400
rule = "isso"
u_um = "x"
cycle = "9999"
parameters = "Q999=1 Q998"
material = "cheese"
balloon_x = 2
balloon_y = 0.5

[[feature]]
number = "01"
name = "a"
callout = "25 H7/g6"
z = -100.001

[[feature]]
kind = "face"
axis = "-Z"
callout = "10 H7"

[[feature]]
kind = "face"
axis = "-Z"
z = 5
callout = "10 h7"

[[feature]]
kind = "point"
axis = "0 0 0"
callout = "25 H7"

[[feature]]
kind = "point"
axis = "-Z"
callout = "+0.1 +0.05"

[[feature]]
name = "K1"
kind = "pocket"
axis = "X"
callout = "40 h7"
callout2 = "25 g6"

[[feature]]
name = "K1 X"
callout = true
colour = "red"

[[feature]]
number = "A"
name = "1"
callout = "25 H7"
rule = "iso14253-2017"
material = "999"
parameters = "Q261=5 Q423=99"
remark = "a\nb"
z = -5
clearance_height = -8

[[feature]]
callout = "4000 H7"

[[feature]]
callout = "25 H7"
x = 1
y = 2
z = -8
clearance_height = 61

[[feature]]
kind = "point"
axis = "-Z"
callout = "±20"

[[feature]]
kind = "bore"
callout = "20 g6"

[[feature]]
kind = "flatness"
callout = "25 H7"

[[feature]]
callout = "12 ±0.02"

[[feature]]
callout = "25 H7"
plausible = [25.5, 24.5]

[[feature]]
callout = "25 H7"
plausible = ["24.5", "25.01"]
"#;

/// The name of a fault that a cell can have; `None` of those of a file as a whole, which leave no plan to look at or come one at a time.
/// Whoever adds a fault decides here whether it is in the plan above.
fn of_cell(fault: &PlanFault) -> Option<&'static str> {
    match fault {
        PlanFault::NoFeatures
        | PlanFault::TooMany { .. }
        | PlanFault::TooLarge { .. }
        | PlanFault::NotAPlan
        | PlanFault::OtherVersion { .. }
        | PlanFault::Toml { .. }
        | PlanFault::File { .. }
        | PlanFault::NoColumn { .. }
        | PlanFault::UnknownColumn { .. }
        | PlanFault::ColumnTwice { .. }
        | PlanFault::Cells { .. } => None,
        PlanFault::UnknownKey { .. } => Some("UnknownKey"),
        PlanFault::OtherValue { .. } => Some("OtherValue"),
        PlanFault::NoCell { .. } => Some("NoCell"),
        PlanFault::Number { .. } => Some("Number"),
        PlanFault::Callout { .. } => Some("Callout"),
        PlanFault::Fit { .. } => Some("Fit"),
        PlanFault::Unknown { .. } => Some("Unknown"),
        PlanFault::OtherSide { .. } => Some("OtherSide"),
        PlanFault::NotOf { .. } => Some("NotOf"),
        PlanFault::Direction { .. } => Some("Direction"),
        PlanFault::NoBand { .. } => Some("NoBand"),
        PlanFault::NoFeature { .. } => Some("NoFeature"),
        PlanFault::NoFormLimit { .. } => Some("NoFormLimit"),
        PlanFault::BandSide { .. } => Some("BandSide"),
        PlanFault::Band(_) => Some("Band"),
        PlanFault::SideClass { .. } => Some("SideClass"),
        PlanFault::FaceClass { .. } => Some("FaceClass"),
        PlanFault::FacePlace { .. } => Some("FacePlace"),
        PlanFault::Limits { .. } => Some("Limits"),
        PlanFault::Range(_) => Some("Range"),
        PlanFault::Parameter { .. } => Some("Parameter"),
        PlanFault::NoParameter { .. } => Some("NoParameter"),
        PlanFault::ClearanceHeight { .. } => Some("ClearanceHeight"),
        PlanFault::Travel { .. } => Some("Travel"),
        PlanFault::ClearanceTravel { .. } => Some("ClearanceTravel"),
        PlanFault::NoTravel { .. } => Some("NoTravel"),
        PlanFault::NoPlausible { .. } => Some("NoPlausible"),
        PlanFault::PlausibleLimits { .. } => Some("PlausibleLimits"),
        PlanFault::Text { .. } => Some("Text"),
        PlanFault::SameName { .. } => Some("SameName"),
        PlanFault::SameNumber { .. } => Some("SameNumber"),
        PlanFault::SameSize { .. } => Some("SameSize"),
        PlanFault::NumberIsName { .. } => Some("NumberIsName"),
        PlanFault::NameIsNumber { .. } => Some("NameIsNumber"),
        PlanFault::Material(_) => Some("Material"),
        PlanFault::Thermal(_) => Some("Thermal"),
        PlanFault::Rule { .. } => Some("Rule"),
        PlanFault::Uncertainty { .. } => Some("Uncertainty"),
        PlanFault::Balloon { .. } => Some("Balloon"),
    }
}

#[test]
fn a_plan_with_every_kind_of_mistake_shows_all_of_them_at_once() {
    let errors = Document::read(WRONG.as_bytes()).unwrap().plan(&Sources::default()).unwrap_err();
    let found: BTreeSet<&str> = errors.iter().filter_map(|error| of_cell(&error.what)).collect();
    let own = include_str!("plan_files.rs");
    let all: BTreeSet<&str> =
        own.split("=> Some(\"").skip(1).filter_map(|rest| rest.split_once("\")")).map(|(name, _)| name).collect();
    assert!(30 < all.len());
    assert_eq!(found, all, "{errors:#?}");
    // Of the first feature every cell but name, number and balloon_y, and of the parameters each word.
    let lines = [9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 18, 19, 20];
    let of_first: Vec<usize> =
        errors.iter().filter_map(|error| error.place.line).filter(|line| (7..22).contains(line)).collect();
    assert_eq!(of_first, lines, "{errors:#?}");
    // Both sides of a pocket.
    let of_pocket = errors.iter().filter(|error| matches!(error.what, PlanFault::SideClass { .. })).count();
    assert_eq!(of_pocket, 2, "{errors:#?}");
}

#[test]
fn the_probe_moves_freely_within_the_machines_travel() {
    let plan = |height: &str, place: &str| {
        format!(
            "fitcheck_plan = 1\ntravel_z = [-100, 40]\n[[feature]]\ncallout = \"25 H7\"\nx = 1\ny = 2\n{place}{height}"
        )
    };
    let z = "z = -8\n";
    let errors = read(&plan("clearance_height = 41\n", z), &Sources::default()).unwrap_err();
    assert_eq!(
        errors,
        [
            "line 8, column 20: the probe moves at Z41, which is outside the machine's travel, -100 to 40 mm: give another clearance_height"
        ]
    );
    // So it does where the plan leaves the height to 50 mm.
    let errors = read(&plan("", z), &Sources::default()).unwrap_err();
    assert_eq!(errors.len(), 1, "{errors:?}");
    assert!(errors[0].contains("the probe moves at Z50"), "{errors:?}");
    assert!(read(&plan("clearance_height = 40\n", z), &Sources::default()).is_ok());
    // What is not measured by a program needs no height.
    assert!(read(&plan("", ""), &Sources::default()).is_ok());
}

#[test]
fn what_is_no_toml_is_told_and_what_is_right_of_it_is_read() {
    let document =
        Document::read(b"fitcheck_plan = 1\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\nx = 40\n").unwrap();
    assert!(!document.problems.is_empty());
    assert!(document.problems.iter().all(|problem| problem.place.line.is_some()), "{:?}", document.problems);
    assert_eq!(document.draft.rows[0].text(Column::Name), Some("A"));
    for text in ["fitcheck_plan = 2\n", "fitcheck_plan = \"one\"\n", "fitcheck_plan = -1\n"] {
        let errors = read(text, &Sources::default()).unwrap_err();
        assert!(errors.iter().any(|error| error.contains("versions 1 to 1 are supported")), "{errors:?}");
    }
    // The version is not only decoration.
    let errors = read("[[feature]]\ncallout = \"25 H7\"\n", &Sources::default()).unwrap_err();
    assert_eq!(errors, ["line 1, column 1: column fitcheck_plan is missing"]);
}

#[test]
fn a_csv_without_a_known_column_is_no_plan_of_many_faults() {
    let errors = read("a;b;c\n1;2;3\n1;2;3\n", &Sources::default()).unwrap_err();
    assert_eq!(errors.len(), 1, "{errors:?}");
    assert!(errors[0].starts_with("line 1: unknown column a"), "{errors:?}");
}

#[test]
fn what_is_written_reads_back_and_means_the_same() {
    let document = Document::read(FLANGE.as_bytes()).unwrap();
    let toml = document.draft.to_toml();
    assert!(toml.contains("\nx = 40\ny = 30.5\nz = -8\n") && toml.contains("travel_x = [-250, 250]"), "{toml}");
    let again = Document::read(toml.as_bytes()).unwrap();
    let same = |a: &Plan, b: &Plan| {
        assert_eq!(a.head, b.head);
        for (a, b) in a.features().iter().zip(b.features()) {
            let line = a.line;
            assert_eq!(*a, fitcheck::part::PlanFeature { line, ..b.clone() });
        }
    };
    let first = document.plan(&Sources::default()).unwrap();
    same(&first, &again.plan(&Sources::default()).unwrap());
    // CSV has the features alone, so what is said for all of them goes.
    let csv = document.draft.to_csv();
    assert!(csv.starts_with("number;name;kind;callout;callout2;feature;x;y;z;"), "{csv}");
    assert_eq!(read(&csv, &Sources::default()).unwrap().features().len(), 3);
}

#[test]
fn numbers_are_given_in_order() {
    let mut draft = Draft::of(vec![DraftFeature::default(), DraftFeature::of([(Column::Number, "7".to_owned())])]);
    draft.renumber();
    let numbers: Vec<_> = draft.rows.iter().map(|row| row.text(Column::Number)).collect();
    assert_eq!(numbers, [Some("1"), Some("2")]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Any texts, right or wrong, are there again.
    #[test]
    fn any_draft_reads_back_from_toml(
        head in prop::collection::vec("[ -~äøµ\\n\"\\\\]{0,12}", HeadField::ALL.len()),
        rows in prop::collection::vec(prop::collection::vec("[-0-9.eA-Zµ\"' #=]{0,8}", Column::ALL.len()), 1..4),
    ) {
        let rows = rows.into_iter().map(|texts| DraftFeature::of(Column::ALL.into_iter().zip(texts)));
        let mut draft = Draft::of(rows.collect());
        for (field, text) in HeadField::ALL.into_iter().zip(head) {
            draft.set(field, text);
        }
        let again = Document::read(draft.to_toml().as_bytes()).unwrap();
        prop_assert_eq!(&again.problems, &[]);
        for field in HeadField::ALL {
            prop_assert_eq!(again.draft.text(field), draft.text(field));
        }
        for (again, row) in again.draft.rows.iter().zip(&draft.rows) {
            for column in Column::ALL {
                prop_assert_eq!(again.text(column), row.text(column));
            }
        }
    }
}
