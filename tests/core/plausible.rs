//! What a value of a plan's size can be at all: a value beyond that is asked about and not judged.

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::journal::body;
use fitcheck::journal::entry::Checked;
use fitcheck::length::Length;
use fitcheck::part::{Column, Document};
use fitcheck::session::{Action, Effect, PartsAction, WalkField};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::Doubt;
use serde_json::Value as Json;

use crate::at_home::AtHome as _;
use crate::plans::{plan, read};
use crate::session_walk::{act, act_after, asked, import, kept, said, size, take, walking_by};

const PLAN: &str = r#"fitcheck_plan = 1
part = "Flange"

[[feature]]
name = "BORE"
callout = "25 H7"
plausible = [24.5, 25.5]

[[feature]]
name = "K1"
kind = "pocket"
callout = "40 H7"
callout2 = "25 H8"
plausible = ["39", "41"]
plausible2 = "24 26"
"#;

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn ranges(text: &str) -> Vec<Option<[String; 2]>> {
    let plan = plan(text);
    let of = |size: fitcheck::part::Size<'_>| {
        size.plausible.map(|range| [range.lower(), range.upper()].map(|end| end.to_string()))
    };
    plan.sizes().map(of).collect()
}

#[test]
fn each_size_of_a_plan_has_its_range_and_writes_it_back() {
    let pairs = [["24.5", "25.5"], ["39", "41"], ["24", "26"]].map(|pair| Some(pair.map(str::to_owned)));
    assert_eq!(ranges(PLAN), pairs);
    let document = Document::read(PLAN.as_bytes()).unwrap();
    let toml = document.draft.to_toml();
    assert!(toml.contains("plausible = [24.5, 25.5]\n") && toml.contains("plausible2 = [24, 26]\n"), "{toml}");
    assert_eq!(ranges(&toml), pairs);
    let csv = document.draft.to_csv();
    assert!(csv.contains(";plausible;plausible2\n") && csv.contains(";24.5 25.5;"), "{csv}");
    assert_eq!(ranges(&csv), pairs);
    // Without a range of its own the side along Y has that along X, as it has its callout.
    let square = "kind;callout;plausible\npocket;40 H7;39 41\n";
    assert_eq!(ranges(square), [Some(["39", "41"].map(str::to_owned)), Some(["39", "41"].map(str::to_owned))]);
    assert_eq!(ranges("callout\n25 H7\n"), [None]);
}

#[test]
fn its_ends_and_the_limits_of_the_size_are_within_it() {
    let plan = plan("callout;plausible\n25 H7;25 25,021\n");
    let bore = plan.sizes().next().unwrap();
    for (measured, can_be) in [("24.999999", false), ("25", true), ("25.021", true), ("25.021001", false)] {
        assert_eq!(bore.excludes(mm(measured)).is_none(), can_be, "{measured}");
    }
}

#[test]
fn a_range_that_is_none_is_refused_with_its_reason() {
    let refused =
        |row: &str| read(&format!("kind;callout;callout2;plausible;plausible2\n{row}\n"), &Sources::default());
    for (row, why) in [
        (
            ";25 H7;;24.5;",
            "line 2: plausible: 24.5 is not a range: write two lengths in mm, the smaller one first, such as 24.5 25.5",
        ),
        (";25 H7;;25.5 24.5;", "line 2: plausible: 25.5 24.5 is not a range"),
        (";25 H7;;25 25;", "line 2: plausible: 25 25 is not a range"),
        (";25 H7;;a b;", "line 2: plausible: a b is not a range"),
        (
            ";25 H7;;24.5 25.02;",
            "line 2: plausible: 24.5 to 25.02 mm does not contain the limits of size, 25 to 25.021 mm: give a wider range",
        ),
        (";25 H7;;;24 26", "line 2: a diameter has no plausible2"),
        (
            "pocket;40 H7;25 H8;39 41;",
            "line 2: plausible: 39 to 41 mm does not contain the limits of size, 25 to 25.033 mm",
        ),
        ("pocket;40 H7;25 H8;39 41;25 26", ""),
        ("pocket;40 H7;25 H8;39 41;25.01 26", "line 2: plausible2: 25.01 to 26 mm does not contain"),
    ] {
        match refused(row) {
            Ok(_) => assert_eq!(why, "", "{row}"),
            Err(errors) => {
                assert!(errors.len() == 1 && !why.is_empty() && errors[0].starts_with(why), "{row}: {errors:?}");
            }
        }
    }
    let toml = |value: &str| {
        read(
            &format!("fitcheck_plan = 1\n[[feature]]\ncallout = \"25 H7\"\nplausible = {value}\n"),
            &Sources::default(),
        )
    };
    assert!(toml("[24.5, 25.5]").is_ok());
    for value in ["true", "[true, 25.5]", "[24.5, [25.5]]"] {
        let errors = toml(value).unwrap_err();
        assert!(errors.iter().any(|error| error.contains("two numbers in brackets")), "{value}: {errors:?}");
    }
}

/// Runs the program in a folder of its own with the plan and two values.
fn run(args: &[&str]) -> (i32, String, String) {
    let place = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fitcheck::files::write(&place.path().join(name), text.as_bytes()).unwrap();
    write("plan.toml", PLAN);
    write("v.csv", "name;measured\nBORE;25,912\nK1 X;40,01\nK1 Y;25,01\n");
    let mut command = cargo_bin_cmd!("fitcheck");
    command.env_remove("FITCHECK_JOURNAL");
    let output = command.at_home(place.path()).current_dir(place.path()).args(args).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

const REASON: &str =
    "not judged: 25.912 mm cannot be: the plan says 24.5 to 25.5 mm; check unit and decimal sign, or measure again";

#[test]
fn a_value_of_a_file_that_cannot_be_is_not_judged_anywhere() {
    let (code, out, err) = run(&["import", "--plan", "plan.toml", "v.csv", "--format", "json"]);
    assert_eq!(code, 1, "{out}{err}");
    let rows: Vec<Json> = serde_json::from_str(&out).unwrap();
    let bore = rows.iter().find(|row| row["id"] == "BORE").unwrap();
    assert_eq!((bore["status"].as_str(), bore["error"].as_str()), (None, Some(REASON)), "{out}");
    assert!(rows.iter().any(|row| row["id"] == "K1 X" && row["status"] == "GOOD"), "{out}");
    let (_, out, _) = run(&["report", "--plan", "plan.toml", "v.csv", "--format", "json", "-o", "-"]);
    assert!(!out.contains("SCRAP"), "{out}");
    assert!(out.contains("25.912 mm cannot be"), "{out}");
    let (_, out, err) = run(&["stats", "--plan", "plan.toml", "v.csv", "--all"]);
    assert!(!out.contains("25.912"), "{out}{err}");
    let (code, out, err) = run(&["plan", "check", "plan.toml", "--format", "json"]);
    assert_eq!(code, 0, "{err}");
    let plan: Json = serde_json::from_str(&out).unwrap();
    let plan = if plan.is_array() { plan[0].clone() } else { plan };
    assert_eq!(plan["features"][0]["sizes"][0]["plausible_mm"].to_string(), "[24.5,25.5]", "{out}");
}

#[test]
fn a_set_for_a_control_says_that_it_does_not_know_the_range() {
    let (code, _, err) = run(&["nc", "plan.toml", "--control", "tnc7", "-o", "set"]);
    // The features of this plan have no place: what is asked for is told before anything is written.
    assert_ne!(code, 0, "{err}");
    let placed = "name;callout;x;y;z;plausible\nBORE;25 H7;40;30;-8;24.5 25.5\n";
    let place = tempfile::tempdir().unwrap();
    fitcheck::files::write(&place.path().join("p.csv"), placed.as_bytes()).unwrap();
    let mut command = cargo_bin_cmd!("fitcheck");
    let output = command
        .at_home(place.path())
        .current_dir(place.path())
        .args(["nc", "p.csv", "--control", "tnc7", "-o", "set"])
        .output()
        .unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert!(err.contains("BORE: the plan says plausible 24.5 25.5, but the set does not use it"), "{err}");
}

#[test]
fn in_the_walk_it_is_asked_about_and_taken_once_somebody_says_that_it_is_so() {
    let mut session = walking_by(PLAN);
    assert_eq!(take(&mut session, "25,912"), []);
    let walking = &session.parts().walking;
    let doubt = walking.question.unwrap().doubt;
    assert_eq!(doubt, Doubt::Implausible { lower: mm("24.5"), upper: mm("25.5"), meant: None });
    assert_eq!(
        said(&fitcheck::message::Say::message(&doubt)),
        "measured value is outside what the plan says can be, 24.5 to 25.5 mm: are unit and decimal sign right?"
    );
    let answers: [Action; 2] = [PartsAction::MeasureAnew.into(), PartsAction::TakeValue.into()];
    assert_eq!(session.answers(), answers);
    // Nothing is judged, and it is measured again.
    assert_eq!(act(&mut session, PartsAction::MeasureAnew.into()), [Effect::Focus(WalkField::Value.into())]);
    assert_eq!(session.text(WalkField::Value), "");
    assert!(session.parts().walking.question.is_none());
    assert_eq!(asked(&session).as_deref(), Some("BORE"));
    // It is so: the record says what the plan said, and that it was confirmed.
    take(&mut session, "25,912");
    let (_, entries) = kept(&act_after(&mut session, PartsAction::TakeValue.into(), 600));
    let [entry] = &entries[..] else { panic!("{entries:?}") };
    assert_eq!(size(entry).doubt, Some(doubt));
    assert_eq!(entry.about.remark, "confirmed when it was measured: it is so");
    assert_eq!(asked(&session).as_deref(), Some("K1 X"));
    // Older versions of Fitcheck refuse this entry, and it reads back as it was.
    let bytes = body::write(entry).unwrap();
    let text = String::from_utf8(bytes.clone()).unwrap();
    assert!(text.starts_with("{\"v\":6,"), "{text}");
    let doubt = "\"doubt\":{\"kind\":\"implausible\",\"lower_nm\":24500000,\"upper_nm\":25500000,\"meant_nm\":null}";
    assert!(text.contains(doubt), "{text}");
    assert_eq!(body::read(&bytes).unwrap(), *entry);
    let Checked::Size(record) = &entry.check().unwrap().what else { panic!() };
    assert!(record.doubt.is_some());
    let swapped = text.replace("24500000,\"upper_nm\":25500000", "25500000,\"upper_nm\":24500000");
    assert!(body::read(swapped.as_bytes()).is_err());
}

#[test]
fn what_it_was_meant_to_be_is_offered_where_that_can_be() {
    let mut session = walking_by(PLAN);
    take(&mut session, "250,12");
    let answers: [Action; 3] =
        [PartsAction::TakeMeantValue.into(), PartsAction::MeasureAnew.into(), PartsAction::TakeValue.into()];
    assert_eq!(session.answers(), answers);
    kept(&act(&mut session, PartsAction::TakeMeantValue.into()));
    assert_eq!(session.parts().walking.shown().unwrap().1.record.measurement.diameter, mm("25.012"));
    assert_eq!(session.parts().walking.shown().unwrap().1.record.doubt, None);
}

#[test]
fn a_value_that_arrives_and_cannot_be_is_listed_and_not_judged() {
    let mut session = walking_by(PLAN);
    import(&mut session, "name;measured\nBORE;25,912\nK1 X;40,01\n");
    let walking = &session.parts().walking;
    assert_eq!(walking.values(0).len(), 0);
    assert_eq!(walking.values(1).len(), 1);
    let notices: Vec<String> =
        session.notices().iter().flat_map(|notice| notice.details.iter().map(said)).collect::<Vec<_>>();
    assert!(notices.iter().any(|line| line.contains(REASON)), "{notices:?}");
    assert_eq!(asked(&session).as_deref(), Some("BORE"));
}

#[test]
fn the_table_of_the_plan_shows_the_range_where_it_is_used() {
    let session = walking_by(PLAN);
    let columns = &session.parts().sheet.columns;
    assert!(columns.contains(&Column::Plausible) && columns.contains(&Column::SecondPlausible), "{columns:?}");
}
