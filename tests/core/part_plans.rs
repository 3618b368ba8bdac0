//! A plan of holes, shafts, slots, ridges and faces: the programs of its set measure all of them on one simulated part,
//! and say of each what the library says.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::Arc;

use fitcheck::control::variables::{Parameter, Value};
use fitcheck::length::Length;
use fitcheck::nc::machine::{Contacts, Machine, NcPath, Remark, Settings, Step};
use fitcheck::nc::program::Program;
use fitcheck::nc::sets::{Control, NcPlan, NcSet, Target};
use fitcheck::probing::simulated::{Face, Part, Surface, Walls, Workpiece};
use fitcheck::tolerance::{Feature, Limits, Sources};
use fitcheck::verdict::{Status, judge};
use fitcheck::words::Dialogue;

/// Three holes, two shafts, two slots, two ridges, three faces.
const PLAN: &str = "\
name,kind,axis,callout,x,y,z
H1,,,25 H7,40,30,-8
H2,diameter,,12 P9,80,30,-8
H3,diameter,,60.5 ZA8,140,40,-12
S1,,,20 g6,40,90,-8
S2,diameter,,8 s7,80,90,-4
N1,width,,16 H8,200,30,-8
N2,width,y,10 D10,240,30,-8
R1,width,x,30 h9,200,120,-8
R2,Width,Y,6.5 k6,260,120,-8
P1,face,-Z,10 h9,300,30,10
P2,face,+X,400 js7,400,60,-10
P3,face,-Y,180 m6,320,180,-10
";

const NANOMETRE: i64 = 1;

fn plan() -> NcPlan {
    NcPlan::read(PLAN.as_bytes()).unwrap()
}

fn limits(plan: &NcPlan) -> Vec<Limits> {
    plan.features().iter().map(|feature| Sources::default().limits(&feature.callout, None).unwrap()).collect()
}

/// Runs a set on a part to its end.
fn run(plan: &NcPlan, control: Control, language: Dialogue, part: Part) -> Machine {
    let target = Target::new(control, language);
    let set = NcSet::make(plan, &target, &Sources::default()).unwrap();
    let path = |name: &str| format!("{}{name}", target.folder);
    let store: BTreeMap<NcPath, Vec<u8>> =
        set.files.iter().map(|file| (NcPath::of_file(&path(&file.name)), file.bytes.clone())).collect();
    let (program, warnings) = Program::read(&set.files[0].bytes).unwrap();
    assert_eq!(warnings, []);
    let settings = Settings::new(language, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    let name = path(&set.files[0].name);
    let mut machine = Machine::new(&name, Arc::new(program), store, Contacts::Workpiece(part), settings);
    while machine.run(u64::MAX).unwrap_or_else(|fault| panic!("{fault}")) != Step::Ended {}
    machine
}

/// The part of the plan with one size a feature.
fn part(plan: &NcPlan, sizes: &[Length]) -> Part {
    let mut part = plan.workpiece(&Sources::default()).unwrap();
    for (feature, size) in part.features.iter_mut().zip(sizes) {
        let size = size.to_mm_f64();
        feature.surface = match feature.surface {
            Surface::Round(workpiece, plane) => Surface::Round(Workpiece { diameter: size, ..workpiece }, plane),
            Surface::Walls(walls) => Surface::Walls(Walls { lengths: (size, None), ..walls }),
            Surface::Face(Face { point, normal, .. }) => {
                let mut moved = point;
                let axis = normal.iter().position(|part| 0.5 < part.abs()).unwrap();
                moved[axis] = size;
                Surface::Face(Face::plane(moved, normal))
            }
            surface @ Surface::Point(_) => surface,
        };
    }
    part
}

/// Sizes a nanometre below a limit, on it or above it, by turns of the features.
fn sizes(limits: &[Limits], turn: usize) -> Vec<Length> {
    let size = |(number, limits): (usize, &Limits)| {
        let (minimum, maximum) = (limits.minimum().nanometres(), limits.maximum().nanometres());
        let all = [minimum - NANOMETRE, minimum, limits.middle().nanometres(), maximum, maximum + NANOMETRE];
        Length::from_nanometres(all[(number + turn) % all.len()]).unwrap()
    };
    limits.iter().enumerate().map(size).collect()
}

#[test]
fn twelve_features_on_one_part_have_the_librarys_verdicts_each() {
    let plan = plan();
    let limits = limits(&plan);
    assert_eq!(limits.len(), 12);
    let mut counted = BTreeMap::new();
    for control in Control::ALL {
        for turn in 0..5 {
            let sizes = sizes(&limits, turn);
            let machine = run(&plan, control, Dialogue::En, part(&plan, &sizes));
            assert_eq!(machine.cycles().len(), 12);
            for (((run, limits), size), feature) in
                machine.cycles().iter().zip(&limits).zip(&sizes).zip(plan.features())
            {
                let check = &run.result.checks[0];
                let expected = judge(limits, *size, None).status();
                assert_eq!((check.minimum, check.maximum), (limits.minimum(), limits.maximum()), "{}", feature.name);
                assert_eq!(
                    (check.measured, run.result.status),
                    (*size, Some(expected)),
                    "{} {control:?}",
                    feature.name
                );
                *counted.entry(expected.word()).or_insert(0) += 1;
            }
            // Nothing stands in the way of any move, and every window has the word of its status.
            let collisions = machine
                .remarks()
                .iter()
                .filter(|(_, remark)| matches!(remark, Remark::Collision { .. } | Remark::Unchecked { .. }));
            assert_eq!(collisions.count(), 0, "{:?}", machine.remarks());
            let words: Vec<&str> = machine
                .windows()
                .iter()
                .map(|window| window.text.lines().next().unwrap().split(": ").nth(1).unwrap())
                .collect();
            let statuses = machine.cycles().iter().map(|run| match run.result.status {
                Some(Status::Good) => "GOOD",
                Some(Status::Rework) => "REWORK",
                _ => "SCRAP",
            });
            assert_eq!(words, statuses.collect::<Vec<_>>());
        }
    }
    assert_eq!(counted.into_iter().collect::<Vec<_>>(), [("GOOD", 108), ("REWORK", 36), ("SCRAP", 36)]);
}

#[test]
fn every_language_and_the_plans_own_part_are_good() {
    let plan = plan();
    for language in Dialogue::ALL {
        let part = plan.workpiece(&Sources::default()).unwrap();
        // What is written is what is run.
        let part = Part::read(&part.write().unwrap()).unwrap();
        let machine = run(&plan, Control::Tnc7, language, part);
        assert!(machine.cycles().iter().all(|run| run.result.status == Some(Status::Good)), "{language}");
    }
}

#[test]
fn a_set_has_only_the_programs_that_its_plan_needs() {
    let names = |text: &str, control| {
        let plan = NcPlan::read(text.as_bytes()).unwrap();
        let set = NcSet::make(&plan, &Target::new(control, Dialogue::En), &Sources::default()).unwrap();
        let page = String::from_utf8_lossy(&set.files.last().unwrap().bytes).into_owned();
        (set.files.iter().map(|file| file.name.clone()).collect::<Vec<_>>().join(" "), page)
    };
    let (files, page) = names("callout,x,y,z\n25 H7,0,0,0\n", Control::Tnc7);
    assert_eq!(files, "FIT_MAIN.H FIT_CHECK.H FIT_STATUS.A FIT_HOLE.TAB FIT_SHAFT.TAB README.TXT");
    assert!(!page.contains("WIDTH") && !page.contains("FACE"), "{page}");
    let (files, page) = names(PLAN, Control::Tnc7);
    assert_eq!(
        files,
        "FIT_MAIN.H FIT_CHECK.H FIT_STATUS.A FIT_WIDTH.H FIT_WIDTH.A FIT_FACE.H FIT_FACE.A FIT_HOLE.TAB FIT_SHAFT.TAB README.TXT"
    );
    assert!(page.contains("FIT_WIDTH.H, FIT_WIDTH.A: ") && page.contains("FIT_FACE.H also uses Q42"), "{page}");
    let (files, _) = names(PLAN, Control::Itnc530);
    assert_eq!(
        files,
        "8255_en.h 82551_en.h 82552_en.a 82551_width_en.h 82552_width_en.a 82551_face_en.h 82552_face_en.a \
         82553_hole.tab 82553_shaft.tab README.TXT"
    );
    // A width off its limits is moved between them on a TNC7, and the page names the parameter.
    let plan = plan();
    let set = NcSet::make(&plan, &Target::new(Control::Tnc7, Dialogue::En), &Sources::default()).unwrap();
    let said: Vec<String> = set.remarks.iter().map(ToString::to_string).collect();
    let moved = "N2: the nominal size of 10 D10 is outside the limits, which a TNC7 refuses: Q311 is 10.04 mm, and Q166 counts from there";
    assert!(said.iter().any(|said| said == moved), "{said:?}");
}

#[test]
fn what_a_kind_cannot_be_is_told_with_its_line() {
    let check = |row: &str, expected: &str| {
        let text = format!("kind,axis,angle,callout,x,y,z\n{row}\n");
        assert_eq!(NcPlan::read(text.as_bytes()).unwrap_err().to_string(), expected, "{row}");
    };
    check("pocket,,,25 H7,0,0,0", "line 2: kind pocket is not known: expected diameter, width, face");
    check("width,Z,,25 H7,0,0,0", "line 2: axis Z is not known: expected X, Y");
    check("face,,,25 h7,25,0,0", "line 2: axis is missing");
    check("face,X,,25 h7,25,0,0", "line 2: axis X is not known: expected +X, -X, +Y, -Y, +Z, -Z");
    check(",X,,25 H7,0,0,0", "line 2: a diameter has no axis");
    check("width,X,10,25 H7,0,0,0", "line 2: a width has no angle");
    check(
        "face,+X,,25 H7,25,0,0",
        "line 2: 25 H7: a face is judged as an outside dimension and needs a shaft class, such as h9",
    );
    check(
        "face,-Y,,25 h9,25,24,0",
        "line 2: 25 h9: the face is at 24 mm along the measured axis, which must be its nominal size",
    );
}

/// The written programs of widths and faces against the library: every class of the tables, at the limits and a
/// nanometre beyond.
#[test]
fn widths_and_faces_of_every_class_agree_with_the_library() {
    let classes: Vec<_> = fitcheck::control::shipped_tables()
        .iter()
        .flat_map(|table| table.columns().iter().map(|column| column.class).collect::<Vec<_>>())
        .collect();
    let mut rows = String::from("kind,axis,callout,x,y,z,clearance_height\n");
    for (number, class) in classes.iter().enumerate() {
        let place = 100 * number;
        writeln!(rows, "width,{},25 {class},{place},0,-8,50", ["X", "Y"][number % 2]).unwrap();
        if class.feature() == Feature::Shaft {
            let nominal = 25 + number;
            writeln!(rows, "face,-Z,{nominal} {class},{place},500,{nominal},200").unwrap();
        }
    }
    let plan = NcPlan::read(rows.as_bytes()).unwrap();
    let limits = limits(&plan);
    assert_eq!((classes.len(), limits.len()), (47, 70));
    for turn in 0..5 {
        let sizes = sizes(&limits, turn);
        let machine = run(&plan, Control::Tnc7, Dialogue::Nl, part(&plan, &sizes));
        for ((run, limits), size) in machine.cycles().iter().zip(&limits).zip(&sizes) {
            let check = &run.result.checks[0];
            assert_eq!((check.minimum, check.maximum, check.measured), (limits.minimum(), limits.maximum(), *size));
            assert_eq!(run.result.status, Some(judge(limits, *size, None).status()));
        }
    }
    // The last one's word is in the text parameter that the window prints.
    let machine = run(&plan, Control::Tnc7, Dialogue::En, part(&plan, &sizes(&limits, 0)));
    assert!(matches!(machine.variables().get(Parameter::qs(3)), Some(Value::Text(_))));
}

#[test]
fn a_feature_in_the_way_of_another_is_told() {
    // A shaft as high as the probe moves, between the holes.
    let plan = NcPlan::read(b"name,callout,x,y,z\nA,25 H7,0,0,-8\nB,25 H7,200,0,-8\n").unwrap();
    let mut part = plan.workpiece(&Sources::default()).unwrap();
    part.probe.ball_radius = 3.0;
    let post = "[[feature]]\nname = \"post\"\nkind = \"stud\"\ncentre = [100, 0]\ndiameter = 10\ntop = 60\n";
    part.features.extend(Part::read(post).unwrap().features);
    let machine = run(&plan, Control::Tnc7, Dialogue::En, part);
    assert!(machine.cycles().iter().all(|run| run.result.status == Some(Status::Good)));
    let told: Vec<String> =
        machine.remarks().iter().map(|(_, remark)| remark.to_string()).filter(|said| said.contains("would")).collect();
    // From where the first hole left the ball, a radius and a radius away from the axis of the post.
    assert_eq!(told, ["the ball would touch post, with the centre of the ball at X 92.565538 Y -2.954448 Z 50 mm"]);
}
