//! Sets of features without a class: the limits stand in the main program, and the control says what Fitcheck says.

use fitcheck::control::variables::{Parameter, Value};
use fitcheck::length::Length;
use fitcheck::nc::machine::{Contacts, Machine};
use fitcheck::nc::sets::{Control, NcSet, Target};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::{Status, judge};
use fitcheck::words::Dialogue;

use crate::nc_sets::run;
use crate::plans::plan;

/// A feature of a plan: kind, axis, and hole or shaft.
type Kind = (&'static str, &'static str, &'static str);

const HOLE: Kind = ("", "", "hole");
const SHAFT: Kind = ("", "", "shaft");

fn text((kind, axis, feature): Kind, [first, second]: [&str; 2], z: &str) -> String {
    format!(
        "kind;axis;feature;callout;callout2;x;y;z;clearance_height\n{kind};{axis};{feature};{first};{second};40;30;{z};90\n"
    )
}

fn made(text: &str, control: Control, language: Dialogue) -> NcSet {
    NcSet::make(&plan(text), &Target::new(control, language), &Sources::default()).unwrap()
}

/// Q180, Q181 and Q182: good, rework, scrap.
fn markers(machine: &Machine) -> [bool; 3] {
    [180, 181, 182].map(|number| matches!(machine.variables().get(Parameter::q(number)), Some(Value::Number(1.0))))
}

/// Runs the set on a part whose first and second side have these sizes.
fn on_part(kind: Kind, callouts: [&str; 2], sizes: [Length; 2], control: Control) -> Machine {
    let is_face = kind.0 == "face";
    let z = if is_face { "10" } else { "-8" };
    let set = made(&text(kind, callouts, z), control, Dialogue::En);
    // A perfect part is in the middle of its zone.
    let [first, second] = sizes.map(|size| format!("{size} ±0.001"));
    let second = if callouts[1].is_empty() { "" } else { &second };
    let height = if is_face { sizes[0].to_string() } else { z.to_owned() };
    let part = plan(&text(kind, [&first, second], &height)).workpiece();
    run(&set, control, Dialogue::En, Contacts::Workpiece(part))
}

/// In the middle of the zone, on each limit and a nanometre beyond it, each side in turn.
#[track_caller]
fn check(kind: Kind, callouts: [&str; 2], [below, above]: [Status; 2]) {
    let asked = plan(&text(kind, callouts, if kind.0 == "face" { "10" } else { "-8" }));
    let limits = &asked.features()[0].limits;
    let nm = Length::from_nanometres(1).unwrap();
    for control in Control::ALL {
        for side in 0..limits.len() {
            let one = &limits[side];
            let beyond = [one.minimum().saturating_sub(nm), one.maximum().checked_add(nm).unwrap()];
            for (size, expected) in [
                (beyond[0], below),
                (one.minimum(), Status::Good),
                (one.middle(), Status::Good),
                (one.maximum(), Status::Good),
                (beyond[1], above),
            ] {
                let mut sizes = [limits[0].middle(), limits.last().unwrap().middle()];
                sizes[side] = size;
                let own = judge(one, size, None).status();
                let machine = on_part(kind, callouts, sizes, control);
                let marked = [Status::Good, Status::Rework, Status::Scrap].map(|status| status == own);
                let said = format!("{kind:?} {callouts:?} {size} {control:?}");
                assert_eq!((own, machine.status(), markers(&machine)), (expected, Some(own), marked), "{said}");
            }
        }
    }
}

const AS_HOLE: [Status; 2] = [Status::Rework, Status::Scrap];
const AS_SHAFT: [Status; 2] = [Status::Scrap, Status::Rework];

#[test]
fn a_diameter_without_a_class_is_judged_on_the_control_as_here() {
    check(HOLE, ["35 +0.2/0", ""], AS_HOLE);
    check(SHAFT, ["35 +0.2/0", ""], AS_SHAFT);
    check(SHAFT, ["12 ±0.02", ""], AS_SHAFT);
    check(HOLE, ["12.01/11.985", ""], AS_HOLE);
    check(HOLE, ["10m", ""], AS_HOLE);
    // The nominal size is outside, which a TNC7 does not take.
    check(HOLE, ["25 +0.149 +0.065", ""], AS_HOLE);
    check(SHAFT, ["20 -0.007/-0.02", ""], AS_SHAFT);
}

#[test]
fn so_is_every_other_kind() {
    check(("width", "Y", "hole"), ["16 +0.027/0", ""], AS_HOLE);
    check(("width", "X", "shaft"), ["30 0/-0.052", ""], AS_SHAFT);
    check(("face", "-Z", ""), ["10 ±0.02", ""], AS_SHAFT);
    check(("pocket", "", ""), ["40 +0.1/0", "25 ±0.03"], AS_HOLE);
    check(("boss", "", ""), ["40 0/-0.1", "25 -0.02/-0.04"], AS_SHAFT);
    // One side of each.
    check(("pocket", "", ""), ["40 H7", "25 ±0.03"], AS_HOLE);
    check(("boss", "", ""), ["40 ±0.1", "25 g6"], AS_SHAFT);
}

const MIXED: &str = "feature;callout;kind;axis;x;y;z\nhole;35 +0.2/0;;;0;0;-8\n;25 H7;;;100;0;-8\nshaft;12 ±0.02;;;200;0;-8\n;20 g6;;;300;0;-8\nhole;16 +0.027/0;width;X;400;0;-8\n";

fn file(set: &NcSet, number: usize) -> String {
    encoding_rs::WINDOWS_1252.decode(&set.files[number].bytes).0.into_owned()
}

/// A class behind deviations is looked up again, in every language and on every control.
#[test]
fn features_with_and_without_a_class_stand_in_one_set() {
    for control in Control::ALL {
        for language in Dialogue::ALL {
            let set = made(MIXED, control, language);
            let part = plan(MIXED).workpiece();
            let machine = run(&set, control, language, Contacts::Workpiece(part));
            let statuses: Vec<_> = machine.cycles().iter().map(|run| run.result.status).collect();
            assert_eq!(statuses, [Some(Status::Good); 5], "{control:?} {language}");
            let [main, called] = [file(&set, 0), file(&set, 1)];
            assert!(main.is_ascii() && called.is_ascii());
            assert!(called.contains("LBL 92") && !main.contains("QS1 = \"\""), "{called}");
            let page = file(&set, set.files.len() - 1);
            assert!(page.contains("35 +0.2/0") && page.contains("Q74") && !page.contains(['{', '}']), "{page}");
            assert!(page.lines().all(|line| line.chars().count() <= 132), "{page}");
        }
    }
}

#[test]
fn the_main_program_gives_the_limits_and_the_window_shows_the_deviations() {
    let set = made(&text(HOLE, ["35 +0.2/0", ""], "-8"), Control::Tnc640, Dialogue::En);
    let main = file(&set, 0);
    let lines: Vec<&str> = main.lines().filter_map(|line| Some(line.split_once(' ')?.1.trim_start())).collect();
    let at = lines.iter().position(|line| line.starts_with("Q1 =")).unwrap();
    assert_eq!(
        &lines[at - 1..at + 5],
        [
            "* -   F1: 35 +0.2/0",
            "Q1 = 35 ;NOMINAL SIZE",
            "DECLARE STRING QS1 = \"+0.2/0\" ;TOLERANCE CLASS",
            "Q2 = - 1 ;-1 HOLE, 0 OR +1 SHAFT",
            "Q23 = 35.2 ;MAXIMUM SIZE",
            "Q33 = 35 ;MINIMUM SIZE",
        ],
        "{main}"
    );
    let machine = run(&set, Control::Tnc640, Dialogue::En, Contacts::Perfect);
    let window = &machine.windows()[0].text;
    assert!(window.contains("CHECKED FIT: 35 +0.2/0") && window.contains("35.2000"), "{window}");
}

/// What needs no limits of its own has none of their blocks: neither a set of classes, nor the program of another kind.
#[test]
fn a_program_of_classes_alone_is_as_it_was() {
    let classes = "callout;x;y;z\n25 H7;0;0;-8\n20 g6;100;0;-8\n";
    let width = "callout;kind;axis;feature;x;y;z\n25 H7;;;;0;0;-8\n16 +0.027/0;width;X;hole;100;0;-8\n";
    for control in Control::ALL {
        let [plain, beside] = [classes, width].map(|text| made(text, control, Dialogue::En));
        for number in 0..plain.files.len() {
            assert!(!file(&plain, number).contains("Q24 =") && !file(&plain, number).contains("LBL 92"), "{control:?}");
        }
        assert_eq!(file(&plain, 1), file(&beside, 1), "{control:?}");
        assert!(file(&beside, 3).contains("LBL 92"), "{control:?}");
        let tables = |set: &NcSet| [set.files.len() - 3, set.files.len() - 2].map(|number| file(set, number));
        assert_eq!(tables(&plain), tables(&beside), "{control:?}");
    }
}
