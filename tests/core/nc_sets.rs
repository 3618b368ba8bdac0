//! Sets for a control: what is written can be read back and runs to the same verdict as Fitcheck's.

use std::collections::BTreeMap;
use std::sync::Arc;

use fitcheck::control::deviations::read_table;
use fitcheck::control::mask::FileUse;
use fitcheck::control::shipped_tables;
use fitcheck::control::variables::{Parameter, Value};
use fitcheck::journal::{Record, status_window};
use fitcheck::length::Length;
use fitcheck::nc::machine::{Contacts, Machine, NcPath, Settings, Step, Store, StoreError};
use fitcheck::nc::program::{Body, Program, TextExpression, TextOperand};
use fitcheck::nc::sets::{Control, NcSet, SetError, SetRemark, Target};
use fitcheck::part::{Column, Draft, DraftFeature, MOST_FEATURES, Plan, PlanFeature};
use fitcheck::probing::cycle::{Plane, Remark};
use fitcheck::probing::measure::{ProbePosition, cycle_number, measure};
use fitcheck::probing::simulated::{Simulation, Surface, Workpiece};
use fitcheck::probing::{Measurement, Origin};
use fitcheck::shipped;
use fitcheck::tolerance::table_edit::standard_table;
use fitcheck::tolerance::{Callout, Limits, Sources, ToleranceClass, iso286};
use fitcheck::verdict::{Status, judge};
use fitcheck::words::Dialogue;
use proptest::prelude::*;

use crate::plans::{of_rows, read};

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn feature(callout: &str, [x, y, z]: [&str; 3]) -> DraftFeature {
    DraftFeature::of(
        [(Column::Callout, callout), (Column::X, x), (Column::Y, y), (Column::Z, z)]
            .map(|(c, text)| (c, text.to_owned())),
    )
}

fn limits(row: &DraftFeature, sources: &Sources) -> Limits {
    sources.limits(&row.text(Column::Callout).unwrap().parse().unwrap(), None).unwrap()
}

fn time() -> jiff::civil::DateTime {
    jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0)
}

fn make(features: &[DraftFeature], control: Control, language: Dialogue) -> NcSet {
    let plan = of_rows(features, &Sources::default());
    NcSet::make(&plan, &Target::new(control, language), &Sources::default()).unwrap()
}

/// The files of a set at their paths on the control and nothing else: no built-in file replaces a missing one.
#[derive(Default)]
struct OnControl(BTreeMap<String, Vec<u8>>);

impl OnControl {
    fn with(set: &NcSet, control: Control) -> Self {
        let path = |name: &str| format!("{}{name}", control.usual_folder());
        Self(set.files.iter().map(|file| (path(&file.name), file.bytes.clone())).collect())
    }
}

impl Store for OnControl {
    fn read(&self, path: &NcPath) -> Result<Vec<u8>, StoreError> {
        self.0.get(&path.to_string()).cloned().ok_or_else(|| StoreError::Missing { path: path.clone() })
    }

    fn write(&mut self, path: &NcPath, bytes: &[u8], _how: FileUse) -> Result<usize, StoreError> {
        self.0.insert(path.to_string(), bytes.to_vec());
        Ok(bytes.len())
    }
}

/// The set's main program on these contacts, run to its end.
#[track_caller]
pub(crate) fn run(set: &NcSet, control: Control, language: Dialogue, contacts: Contacts) -> Machine {
    let main = &set.files[0];
    let (program, warnings) = Program::read(&main.bytes).unwrap();
    assert_eq!(warnings, []);
    let path = format!("{}{}", control.usual_folder(), main.name);
    let store = OnControl::with(set, control);
    let mut machine = Machine::new(&path, Arc::new(program), store, contacts, Settings::new(language, time()));
    while machine.run(u64::MAX).unwrap_or_else(|fault| panic!("{fault}")) != Step::Ended {}
    machine
}

/// The native measurement of a feature on a workpiece of this diameter.
pub(crate) fn measured(feature: &PlanFeature, limits: &Limits, diameter: Length) -> Measurement {
    let [x, y, z] = feature.place.unwrap();
    let centre = [x, y].map(Length::to_mm_f64);
    let workpiece = Workpiece::round(limits.feature.unwrap(), centre, diameter.to_mm_f64());
    let position = ProbePosition {
        centre: [x, y],
        height: z,
        first_angle: feature.angle,
        clearance: feature.clearance,
        ..ProbePosition::default()
    };
    let mut machine = Simulation::perfect(Surface::Round(workpiece, Plane::Xy)).machine().unwrap();
    let origin = Origin::Simulated { cycle: cycle_number(limits.feature.unwrap()), seed: 1 };
    measure(limits.feature.unwrap(), limits, &position, &mut machine, origin).unwrap().0
}

/// The native answer: window and status.
fn native(callout: Callout, limits: &Limits, measurement: Measurement, language: Dialogue) -> (String, Status) {
    let verdict = judge(limits, measurement.diameter, None);
    let record = Record {
        time: time(),
        id: String::new(),
        callout: Some(callout),
        verdict,
        doubt: None,
        correction: None,
        budget: None,
        limits: limits.clone(),
        measurement,
    };
    (status_window(&record, language, None).unwrap(), verdict.status())
}

/// Runs a set on one workpiece per feature, compares all results, and returns the statuses.
#[track_caller]
fn check(
    features: &[DraftFeature],
    diameters: &[Length],
    control: Control,
    language: Dialogue,
    sources: &Sources,
) -> Vec<Status> {
    check_for(&Target::new(control, language), features, diameters, sources)
}

/// The same for a target.
#[track_caller]
fn check_for(target: &Target, features: &[DraftFeature], diameters: &[Length], sources: &Sources) -> Vec<Status> {
    let (control, language) = (target.control, target.language);
    let plan = of_rows(features, sources);
    let set = NcSet::make(&plan, target, sources).unwrap();
    let mut contacts = Vec::new();
    let mut expected = Vec::new();
    for (feature, &diameter) in plan.features().iter().zip(diameters) {
        let limits = sources.limits(&feature.kind.callouts()[0], None).unwrap();
        let measurement = measured(feature, &limits, diameter);
        contacts.extend(measurement.contacts.iter().copied());
        expected.push(native(feature.kind.callouts()[0], &limits, measurement, language));
    }
    let machine = run(&set, control, language, Contacts::Recorded(contacts));
    let statuses: Vec<Status> = machine.cycles().iter().map(|run| run.result.status.unwrap()).collect();
    let windows = machine.windows().iter().map(|window| window.text.clone());
    assert_eq!(windows.zip(statuses.iter().copied()).collect::<Vec<_>>(), expected, "{control:?} {language}");
    // One file per feature, with the window's text.
    let files: Vec<String> = machine.outputs().iter().map(|written| written.path.file_name().to_owned()).collect();
    let before = if control == Control::Itnc530 { "8255_" } else { "FIT_" };
    let ending = if control == Control::Itnc530 { "txt" } else { "TXT" };
    let names: Vec<String> = plan.features().iter().map(|f| format!("{before}{}.{ending}", f.name)).collect();
    assert_eq!(files, names);
    let outputs: Vec<&String> = machine.outputs().iter().map(|written| &written.text).collect();
    assert_eq!(outputs, expected.iter().map(|(window, _)| window).collect::<Vec<_>>());
    statuses
}

/// Classes inside, on and outside their zone, one beyond the 47, one beyond 400 mm, half micrometres.
fn plan() -> Vec<DraftFeature> {
    let mut features = vec![
        feature("25 H7", ["40", "30", "-8"]),
        feature("25 D10", ["-12.5", "0.0004", "0"]),
        feature("8 JS7", ["0", "0", "-1"]),
        feature("20 g6", ["100", "-100", "-3.25"]),
        feature("55 r6", ["1", "2", "3"]),
        feature("24 ZA8", ["-1", "-2", "-3"]),
        feature("500 H7", ["0", "0", "0"]),
    ];
    features[1].set(Column::Name, "Bore_2".to_owned());
    features[1].set(Column::Angle, "-45".to_owned());
    features[3].set(Column::ClearanceHeight, "120.5".to_owned());
    features[3].set(Column::Clearance, "0.75".to_owned());
    features
}

#[test]
fn every_control_and_language_gives_the_native_verdicts() {
    let sources = Sources::default();
    let features = plan();
    let limits: Vec<Limits> = features.iter().map(|row| limits(row, &sources)).collect();
    let off = |length: Length, nm: i64| Length::from_nanometres(length.nanometres() + nm).unwrap();
    for control in Control::ALL {
        for language in Dialogue::ALL {
            // Below, on, within, on and above the limits: each feature in turn.
            let mut statuses = Vec::new();
            for turn in 0..3 {
                let diameters: Vec<Length> = limits
                    .iter()
                    .enumerate()
                    .map(|(number, limits)| match (number + turn) % 3 {
                        0 => off(limits.minimum(), -1),
                        1 => {
                            if turn == 2 {
                                limits.maximum()
                            } else {
                                limits.minimum()
                            }
                        }
                        _ => off(limits.maximum(), 1),
                    })
                    .collect();
                statuses.extend(check(&features, &diameters, control, language, &sources));
            }
            let count = |status| statuses.iter().filter(|given| **given == status).count();
            // Each of the seven features is too small once, good once, and too large once.
            assert_eq!([Status::Good, Status::Rework, Status::Scrap].map(count), [7, 7, 7]);
        }
    }
}

/// A set for TNC7 whose cycle takes the tolerance as a text.
fn by_text(language: Dialogue) -> Target {
    Target { by_text: true, ..Target::new(Control::Tnc7, language) }
}

#[test]
fn the_cycle_with_the_tolerance_as_a_text_gives_the_native_verdicts() {
    let sources = Sources::default();
    let features = plan();
    let all: Vec<Limits> = features.iter().map(|row| limits(row, &sources)).collect();
    for language in Dialogue::ALL {
        for (off, statuses) in [(-1, [0, 5, 2]), (0, [7, 0, 0])] {
            let size = |limits: &Limits| Length::from_nanometres(limits.minimum().nanometres() + off).unwrap();
            let diameters: Vec<Length> = all.iter().map(size).collect();
            let found = check_for(&by_text(language), &features, &diameters, &sources);
            let count = |status| found.iter().filter(|given| **given == status).count();
            assert_eq!([Status::Good, Status::Rework, Status::Scrap].map(count), statuses, "{language} {off}");
        }
    }
    let set = NcSet::make(&of_rows(&features, &sources), &by_text(Dialogue::En), &sources).unwrap();
    let program = text_of(&set, 1);
    assert!(program.contains("TCH PROBE 1401 CIRCLE PROBING ~\r\n    Q1100=+Q11"), "{program}");
    assert_eq!([program.matches("QS1116=QS9 ").count(), program.matches("Q1115=+1 ").count()], [2, 1]);
    assert!(!program.contains("TCH PROBE 421") && !program.contains("Q180"), "{program}");
    let page = text_of(&set, 5);
    assert!(page.contains("cycle 1401 with size and tolerance as a text") && !page.contains("recommends cycle 1401"));
}

#[test]
fn deviations_are_a_text_of_the_cycle_and_other_controls_have_none() {
    let sources = Sources::default();
    let rows = |feature| {
        let text = format!("callout;feature;x;y;z\n35 +0.2/0;{feature};40;30;-8\n12 ±0.02;{feature};90;30;-8\n");
        crate::plans::plan(&text)
    };
    for (feature, above) in [("hole", Status::Scrap), ("shaft", Status::Rework)] {
        let plan = rows(feature);
        let set = NcSet::make(&plan, &by_text(Dialogue::En), &sources).unwrap();
        assert!(text_of(&set, 0).contains("QS1 = \"+0.2-0\"") && text_of(&set, 0).contains("QS1 = \"+0.02-0.02\""));
        for (size, status) in [("35.2", Status::Good), ("35.200001", above)] {
            let round = |x: f64, size: &str| {
                let feature = if feature == "hole" { "bore" } else { "stud" };
                format!("[[feature]]\nname = \"A{x}\"\nkind = \"{feature}\"\ncentre = [{x}, 30]\ndiameter = {size}\n")
            };
            let part = round(40.0, size) + &round(90.0, "12");
            let part = fitcheck::probing::simulated::Part::read(&part).unwrap();
            let machine = run(&set, Control::Tnc7, Dialogue::En, Contacts::Workpiece(part));
            assert_eq!(machine.cycles()[0].result.status, Some(status), "{feature} {size}");
            assert_eq!(machine.cycles()[1].result.status, Some(Status::Good));
        }
    }
    let other = Target { by_text: true, ..Target::new(Control::Tnc640, Dialogue::En) };
    let error = NcSet::make(&rows("hole"), &other, &sources).unwrap_err().to_string();
    assert_eq!(error, "a set with tolerance texts is possible for TNC7 only, not for TNC 620 / TNC 640");
}

#[test]
fn a_single_hole_and_a_single_shaft_on_a_simulated_workpiece() {
    for control in Control::ALL {
        for (callout, below, above) in
            [("25 H7", Status::Rework, Status::Scrap), ("25 h7", Status::Scrap, Status::Rework)]
        {
            let one = feature(callout, ["40", "30", "-8"]);
            let limits = limits(&one, &Sources::default());
            let set = make(&[one], control, Dialogue::En);
            for (diameter, status) in [
                (limits.minimum().saturating_sub(mm("0.000001")), below),
                (limits.minimum(), Status::Good),
                (limits.middle(), Status::Good),
                (limits.maximum(), Status::Good),
                (limits.maximum().checked_add(mm("0.000001")).unwrap(), above),
            ] {
                let workpiece = Workpiece::round(limits.feature.unwrap(), [40.0, 30.0], diameter.to_mm_f64());
                let simulation = Simulation::perfect(Surface::Round(workpiece, Plane::Xy));
                let machine = run(&set, control, Dialogue::En, Contacts::Workpiece(simulation.into()));
                assert_eq!(machine.status(), Some(status), "{callout} {diameter} {control:?}");
            }
        }
    }
}

/// The movement of a probe: at clearance height before and after, never lower on the way to the centre.
#[test]
fn the_probe_moves_between_features_at_clearance_height() {
    let features = vec![feature("25 H7", ["40", "30", "-8"]), feature("20 g6", ["90", "30", "-8"])];
    for control in Control::ALL {
        let set = make(&features, control, Dialogue::En);
        let machine = run(&set, control, Dialogue::En, Contacts::Perfect);
        let between = machine.path().iter().filter(|step| 25.0 < (step.to[0] - step.from[0]).abs());
        let heights: Vec<f64> = between.flat_map(|step| [step.from[2], step.to[2]]).collect();
        assert_eq!(heights, [50.0, 50.0], "{control:?}");
    }
}

#[test]
fn names_follow_the_control() {
    let names = |control, language| {
        let set = make(&[feature("25 H7", ["0", "0", "0"])], control, language);
        set.files.iter().map(|file| file.name.clone()).collect::<Vec<_>>()
    };
    assert_eq!(
        names(Control::Itnc530, Dialogue::De),
        ["8255_de.h", "82551_de.h", "82552_de.a", "82553_hole.tab", "82553_shaft.tab", "LIESMICH.TXT"]
    );
    for control in [Control::Tnc640, Control::Tnc7] {
        assert_eq!(
            names(control, Dialogue::Nl),
            ["FIT_MAIN.H", "FIT_CHECK.H", "FIT_STATUS.A", "FIT_HOLE.TAB", "FIT_SHAFT.TAB", "LEESMIJ.TXT"]
        );
    }
}

fn text_of(set: &NcSet, number: usize) -> String {
    String::from_utf8(set.files[number].bytes.clone()).unwrap()
}

#[test]
fn what_differs_between_the_controls() {
    let of = |control| make(&plan(), control, Dialogue::En);
    let [itnc, tnc640, tnc7] = Control::ALL.map(of);
    // The set-up clearance is added to a machine parameter or to the table's SET_UP.
    assert!(text_of(&itnc, 0).contains("Q51 = 2 ;LATERAL SET-UP CLEARANCE, ADDED TO MP6140\r\n"));
    for later in [&tnc640, &tnc7] {
        assert!(text_of(later, 0).contains("Q51 = 2 ;LATERAL SET-UP CLEARANCE, ADDED TO SET_UP\r\n"));
        assert!(!later.files.iter().any(|file| String::from_utf8_lossy(&file.bytes).contains("MP6140")));
    }
    // Numbers of masks.
    assert_eq!([&itnc, &tnc640, &tnc7].map(|set| text_of(set, 2).contains("%9.4LF")), [true, false, false]);
    assert_eq!([&itnc, &tnc640, &tnc7].map(|set| text_of(set, 2).contains("%9.4F")), [false, true, true]);
    // Headers of tables.
    assert_eq!([&itnc, &tnc640, &tnc7].map(|set| text_of(set, 3).contains("#STRUCTBEGIN")), [true, false, false]);
    assert_eq!([&itnc, &tnc640, &tnc7].map(|set| text_of(set, 3).contains("TableDescription")), [false, true, true]);
    // Q262 is moved between the limits only on a TNC7.
    assert_eq!([&itnc, &tnc640, &tnc7].map(|set| text_of(set, 1).matches("Q262=+Q1 ").count()), [2, 2, 0]);
    assert_eq!([&itnc, &tnc640, &tnc7].map(|set| text_of(set, 1).matches("Q262=+Q62 ").count()), [0, 0, 2]);
    // Folders.
    assert!(text_of(&itnc, 0).contains("CALL PGM TNC:\\8255\\82551_en.h\r\n"));
    assert!(text_of(&tnc7, 1).contains("FN 26: TABOPEN TNC:\\nc_prog\\fitcheck\\FIT_SHAFT.TAB\r\n"));
}

/// The mask of NC-Solution 8255, byte for byte but for the ends of its lines.
#[test]
fn an_itnc_530_gets_the_mask_as_printed_and_later_controls_say_what_differs() {
    let printed = shipped::text(shipped::MASKS, "82552_nl.a");
    assert!(printed.starts_with("\"STATUS VAN DE PASSING: %S\", QS3\n\"GEPRUEFTE PASSUNG: %S\", QS2;\n"), "{printed}");
    for language in Dialogue::ALL {
        let [itnc, tnc640, tnc7] = Control::ALL.map(|control| make(&plan(), control, language));
        let original = shipped::text(shipped::MASKS, &format!("82552_{language}.a"));
        assert_eq!(text_of(&itnc, 2), original.replace('\n', "\r\n"));
        // The page names what differs, and the software that the solution needs.
        let page = |set: &NcSet| encoding_rs::WINDOWS_1252.decode(&set.files[5].bytes).0.into_owned();
        for later in [&tnc640, &tnc7] {
            assert!(page(later).contains("%9.4F") && page(later).contains("%9.4LF"), "{}", page(later));
            assert!(!page(later).contains("606 42x-02"), "{}", page(later));
        }
        assert!(page(&itnc).contains("340 49x-07") && page(&itnc).contains("606 42x-02"), "{}", page(&itnc));
        assert!(!page(&itnc).contains("%9.4F"), "{}", page(&itnc));
    }
}

/// For every class of the tables: the nominal diameter of the cycle is between its limits on a TNC7, and is the nominal
/// size elsewhere.
#[test]
fn a_tnc7_gets_a_nominal_diameter_between_the_limits() {
    let classes: Vec<ToleranceClass> =
        shipped_tables().iter().flat_map(|table| table.columns().iter().map(|column| column.class)).collect();
    let features: Vec<DraftFeature> = classes
        .iter()
        .map(|class| feature(&Callout::new(mm("25"), *class).unwrap().to_string(), ["40", "30", "-8"]))
        .collect();
    let outside = |machine: &Machine| {
        let is_outside = |remark: &Remark| matches!(remark, Remark::NominalOutsideLimits { .. });
        machine.cycles().iter().filter(|run| run.result.remarks.iter().any(is_outside)).count()
    };
    for control in Control::ALL {
        let set = make(&features, control, Dialogue::En);
        let machine = run(&set, control, Dialogue::En, Contacts::Perfect);
        let moved = set.remarks.iter().filter(|remark| matches!(remark, SetRemark::MovedNominal { .. })).count();
        // 24 of the 47 classes are off the nominal size at 25 mm (`docs/SOURCES.md`, sets for a control).
        let expected = if control == Control::Tnc7 { (0, 24) } else { (24, 0) };
        assert_eq!((outside(&machine), moved), expected, "{control:?}");
    }
    // The note names the exact value that the cycle gets.
    for class in ["D10", "g6", "s7", "P9", "k6"] {
        let one = feature(&format!("25 {class}"), ["0", "0", "0"]);
        let set = make(&[one], Control::Tnc7, Dialogue::En);
        let machine = run(&set, Control::Tnc7, Dialogue::En, Contacts::Perfect);
        let Some(SetRemark::MovedNominal { value, .. }) = set.remarks.first() else { panic!("{class}") };
        let Some(Value::Number(given)) = machine.variables().get(Parameter::q(62)) else { panic!("{class}") };
        assert_eq!(Length::from_mm_f64(*given).unwrap(), *value, "{class}");
    }
}

/// What all controls accept: no system data, no joins of literals, ASCII, CRLF, numbers from 0.
#[test]
fn programs_keep_to_the_common_ground() {
    for control in Control::ALL {
        for language in Dialogue::ALL {
            let set = make(&plan(), control, language);
            for file in &set.files[..2] {
                assert!(file.bytes.is_ascii(), "{}", file.name);
                let text = String::from_utf8(file.bytes.clone()).unwrap();
                assert!(text.lines().count() == text.matches("\r\n").count() && text.ends_with("\r\n"));
                let (program, warnings) = Program::read(&file.bytes).unwrap();
                assert_eq!(warnings, []);
                assert_eq!(program.name(), Some(file.name.rsplit_once('.').unwrap().0));
                for (number, block) in program.blocks().iter().enumerate() {
                    assert_eq!(block.number, Some(u32::try_from(number).unwrap()));
                    assert!(!matches!(block.body, Body::Other), "{:?}", program.text_of(number).next());
                    if let Body::AssignText { value: TextExpression::Join(items), .. } = &block.body {
                        let is_parameter =
                            |item: &TextExpression| matches!(item, TextExpression::Value(TextOperand::Parameter(_)));
                        assert!(items.iter().all(is_parameter));
                    }
                }
            }
            let page = encoding_rs::WINDOWS_1252.decode(&set.files[5].bytes).0.into_owned();
            assert!(!page.contains(['{', '}', '[', '\u{fffd}']), "{page}");
            assert!(page.lines().all(|line| line.chars().count() <= 132), "{page}");
            assert!(plan().len() <= page.matches("-> ").count());
            assert!(page.contains(control.name()) && page.contains(&control.usual_folder().to_string()));
        }
    }
}

#[test]
fn tables_hold_the_47_classes_and_what_the_plan_needs_beside_them() {
    let set = make(&plan(), Control::Tnc640, Dialogue::En);
    let table = |number: usize| {
        let file = &set.files[number];
        let (table, warnings) = read_table(&file.bytes, &file.name, &file.name, false).unwrap();
        assert_eq!(warnings, []);
        table.unwrap()
    };
    let (hole, shaft) = (table(3), table(4));
    assert_eq!((hole.columns().len(), shaft.columns().len()), (25, 23));
    let own = "ZA8".parse().unwrap();
    assert_eq!(set.remarks, [SetRemark::OwnColumn { class: own, table: "FIT_HOLE.TAB" }]);
    // ZA changes at 24 mm, so the range to 30 mm is split there; 500 H7 needs one more range.
    let ends: Vec<String> = hole.ends().iter().map(ToString::to_string).collect();
    assert_eq!(ends.join(" "), "1 3 6 10 18 24 30 50 65 80 100 120 140 160 180 200 225 250 280 315 355 400 500");
    // Every filled cell is the standard's, everywhere in its range.
    let alone = Sources::of_tables([hole.clone(), shaft]);
    for (class, size) in [("ZA8", "24"), ("ZA8", "24.0001"), ("H7", "450"), ("R7", "51"), ("g6", "400"), ("JS9", "20")]
    {
        let callout: Callout = format!("{size} {class}").parse().unwrap();
        let [ours, theirs] = [&alone, &Sources::default()].map(|sources| sources.limits(&callout, None).unwrap());
        assert_eq!(ours.deviations, theirs.deviations, "{callout}");
    }
    // R has two values over 400 up to 500 mm: the cell is empty rather than wrong.
    assert!(alone.limits(&"450 R7".parse().unwrap(), None).is_err());
}

/// The built-in tables are compared with published ones cell by cell: what a plan of usual classes needs is the same.
#[test]
fn a_set_of_usual_classes_has_the_built_in_tables() {
    let set = make(&[feature("25 H7", ["0", "0", "0"])], Control::Tnc640, Dialogue::En);
    for (number, built_in) in [3, 4].into_iter().zip(shipped_tables()) {
        let file = &set.files[number];
        let table = read_table(&file.bytes, &file.name, &file.name, false).unwrap().0.unwrap();
        assert_eq!(table.ends(), built_in.ends(), "{}", file.name);
        assert_eq!(table.columns(), built_in.columns(), "{}", file.name);
    }
}

#[test]
fn an_itnc_530_takes_thirty_columns_and_then_only_those_of_the_plan() {
    let few = ["25 ZA8", "25 U7"].map(|callout| feature(callout, ["0", "0", "0"])).to_vec();
    let set = make(&few, Control::Itnc530, Dialogue::En);
    assert!(!set.remarks.iter().any(|remark| matches!(remark, SetRemark::FewerColumns { .. })));
    let many: Vec<DraftFeature> =
        ["ZA8", "U7", "S7", "T7", "H7"].map(|class| feature(&format!("25 {class}"), ["0", "0", "0"])).to_vec();
    let set = make(&many, Control::Itnc530, Dialogue::En);
    let fewer = SetRemark::FewerColumns { table: "82553_hole.tab", classes: "ZA8 U7 S7 T7 H7".to_owned() };
    assert_eq!(set.remarks.last(), Some(&fewer));
    let sources = Sources::default();
    let diameters: Vec<Length> = many.iter().map(|row| limits(row, &sources).minimum()).collect();
    assert_eq!(check(&many, &diameters, Control::Itnc530, Dialogue::It, &sources), [Status::Good; 5]);
    // Even more than those: refused with the control's limit, nothing is left out.
    let letters = "CD D E EF F FG G H J JS K M N P R S T U V X Y Z ZA ZB ZC".split(' ');
    let all: Vec<DraftFeature> = letters
        .flat_map(|letter| [6, 7].map(|grade| format!("8 {letter}{grade}")))
        .filter(|callout| sources.limits(&callout.parse().unwrap(), None).is_ok())
        .map(|callout| feature(&callout, ["0", "0", "0"]))
        .collect();
    let plan = of_rows(&all, &sources);
    let refused = NcSet::make(&plan, &Target::new(Control::Itnc530, Dialogue::En), &sources).unwrap_err();
    assert!(matches!(refused, SetError::Table { table: "82553_hole.tab", .. }), "{refused}");
    assert!(NcSet::make(&plan, &Target::new(Control::Tnc7, Dialogue::En), &sources).is_ok());
}

/// A user's own table comes first, with ranges and values of its own.
#[test]
fn own_tables_are_what_the_control_gets() {
    let class: ToleranceClass = "H8".parse().unwrap();
    let own = standard_table("shop.tab", &[class], mm("40"), iso286::Options::default()).unwrap();
    let mut edit = fitcheck::tolerance::table_edit::TableEdit::new(own);
    let wide = fitcheck::tolerance::Deviations::new(mm("0.1"), mm("0.0005")).unwrap();
    for range in 0..edit.table().ends().len() {
        edit.set(class, range, Some(wide));
    }
    let sources = Sources::default().with_own([edit.table().clone()]);
    let features = ["20 H8", "35 H8", "60 H8"].map(|callout| feature(callout, ["0", "0", "0"])).to_vec();
    let diameters = [mm("20.1"), mm("35.0004"), mm("60.046")];
    for control in Control::ALL {
        let statuses = check(&features, &diameters, control, Dialogue::En, &sources);
        assert_eq!(statuses, [Status::Good, Status::Rework, Status::Good]);
    }
    // Only the control's own tables: classes beyond the 47 are refused, with the line's place.
    let sources = Sources::of_tables(shipped_tables());
    let refused = &read("callout,x,y,z\n25 H7,0,0,0\n25 U7,0,0,0\n", &sources).unwrap_err()[0];
    assert!(refused.starts_with("line 3: 25 U7: U7 is not in table 82553_hole.tab"), "{refused}");
}

#[test]
fn the_same_plan_gives_the_same_bytes_and_the_zip_holds_them() {
    use std::io::Read as _;
    let set = make(&plan(), Control::Tnc7, Dialogue::Nl);
    assert_eq!(set, make(&plan(), Control::Tnc7, Dialogue::Nl));
    let bytes = set.zip().unwrap();
    assert_eq!(bytes, set.zip().unwrap());
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(bytes)).unwrap();
    assert_eq!(archive.len(), set.files.len());
    for file in &set.files {
        let mut found = Vec::new();
        archive.by_name(&file.name).unwrap().read_to_end(&mut found).unwrap();
        assert_eq!(found, file.bytes, "{}", file.name);
    }
}

#[test]
fn plans_are_bounded() {
    let sources = Sources::default();
    let one = feature("25 H7", ["0", "0", "0"]);
    let most = of_rows(&vec![one.clone(); MOST_FEATURES], &sources);
    assert_eq!(most.features().last().unwrap().name, "F1000");
    let of = |count| Plan::of(&Draft::of(vec![one.clone(); count]), &sources).unwrap_err()[0].what.to_string();
    assert_eq!(of(MOST_FEATURES + 1), "the plan has more than 1000 features");
    assert_eq!(of(0), "the plan has no features");
    let far = format!("callout,x,y,z\n{}", "25 H7,0,0,0\n".repeat(MOST_FEATURES + 5));
    assert_eq!(read(&far, &sources).unwrap_err(), ["line 1002: the plan has more than 1000 features"]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Any class that has limits, at any size: the set agrees to the nanometre, whatever the control.
    #[test]
    fn any_class_and_size_agrees(
        letter in 0..28_usize, hole in any::<bool>(), grade in 4..14_u8, hundredths in 100..315_000_i64,
        off in -2..3_i64, at_maximum in any::<bool>(), control in 0..3_usize,
    ) {
        let letters = ["a", "b", "c", "cd", "d", "e", "ef", "f", "fg", "g", "h", "j", "js", "k", "m", "n", "p", "r", "s",
            "t", "u", "v", "x", "y", "z", "za", "zb", "zc"];
        let letter = if hole { letters[letter].to_uppercase() } else { letters[letter].to_owned() };
        let nominal = Length::from_nanometres(hundredths * 10_000).unwrap();
        let callout: Callout = format!("{nominal} {letter}{grade}").parse().unwrap();
        let sources = Sources::default();
        if let Ok(limits) = sources.limits(&callout, None) {
            prop_assume!(mm("0.01") < limits.minimum());
            let border = if at_maximum { limits.maximum() } else { limits.minimum() };
            let diameter = Length::from_nanometres(border.nanometres() + off).unwrap();
            let one = feature(&callout.to_string(), ["0", "0", "0"]);
            check(&[one], &[diameter], Control::ALL[control], Dialogue::Nl, &sources);
        }
    }

    /// No bytes make the reader of plans panic, and what it reads stays within its bounds.
    #[test]
    fn any_bytes_are_a_plan_or_an_error(text in "(callout,x,y,z\n)?[-0-9Hhg,;\\. \"\n\tnamecxyz±]{0,60}") {
        if let Ok(plan) = read(&text, &Sources::default()) {
            prop_assert!(plan.features().len() <= MOST_FEATURES);
        }
    }
}
