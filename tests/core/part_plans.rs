//! A plan of holes, shafts, slots, ridges, faces, pockets, bosses and points: the programs of its set measure all of them
//! on one simulated part, and say of each what the library says.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::Arc;

use fitcheck::control::variables::{Parameter, Value};
use fitcheck::length::Length;
use fitcheck::nc::machine::{Contacts, Machine, NcPath, Remark, Settings, Step};
use fitcheck::nc::program::Program;
use fitcheck::nc::sets::{Control, NcSet, Target};
use fitcheck::part::{FeatureKind, Plan};
use fitcheck::probing::simulated::{Face, FreePoint, Part, Surface, Walls, Workpiece};
use fitcheck::tolerance::{Feature, Limits, Source, Sources};
use fitcheck::verdict::{Status, judge};
use fitcheck::words::Dialogue;

use crate::plans;

/// Three holes, two shafts, two slots, two ridges, three faces, a pocket, a boss.
const PLAN: &str = "\
name,kind,axis,callout,x,y,z,callout2
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
K1,pocket,,40 H7,40,200,-8,25 D10
B1,Boss,,18 s7,140,200,-8,30 h9
";

/// Points along two axes, and two oblique ones: a normal of CAD and an upward one. For controls that have the cycle.
const POINTS: &str = "\
T1,point,-Z,±0.05,480,30,12
T2,point,+X,+0.1/-0.05,480,90,-6
T3,point,0.5 -0.25 -1,-0.02,480,150,5.5
T4,point,-0.577350269 0.577350269 -0.577350269,+12 µm -7 µm,480,210,3
";

const NANOMETRE: i64 = 1;

/// The plan of a control: with points where it has the cycle.
fn plan(control: Control) -> Plan {
    let points = if control == Control::Itnc530 { "" } else { POINTS };
    plans::plan(&format!("{PLAN}{points}"))
}

/// The limits of every feature, from the library: one of every size. Those of a point count from its nominal place.
pub fn limits(plan: &Plan) -> Vec<Vec<Limits>> {
    let of = |kind: &FeatureKind| match kind {
        FeatureKind::Point(band, _) => {
            vec![Limits::new(Feature::Shaft, Length::ZERO, *band, Source::Callout).unwrap()]
        }
        kind => {
            let limits = kind.callouts().into_iter().map(|callout| Sources::default().limits(&callout, None).unwrap());
            limits.collect()
        }
    };
    plan.features().iter().map(|feature| of(&feature.kind)).collect()
}

/// Runs a set on a part to its end.
fn run(plan: &Plan, control: Control, language: Dialogue, part: Part) -> Machine {
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

/// The part of the plan with these sizes of every feature.
pub fn part(plan: &Plan, sizes: &[Vec<Length>]) -> Part {
    let mut part = plan.workpiece();
    for (feature, sizes) in part.features.iter_mut().zip(sizes) {
        let size = sizes[0].to_mm_f64();
        feature.surface = match feature.surface {
            Surface::Round(workpiece, plane) => Surface::Round(Workpiece { diameter: size, ..workpiece }, plane),
            Surface::Walls(walls) => {
                Surface::Walls(Walls { lengths: (size, sizes.get(1).map(|size| size.to_mm_f64())), ..walls })
            }
            Surface::Face(Face { point, normal, .. }) => {
                let mut moved = point;
                let axis = normal.iter().position(|part| 0.5 < part.abs()).unwrap();
                moved[axis] = size;
                Surface::Face(Face::plane(moved, normal))
            }
            Surface::Point(point) => Surface::Point(FreePoint { deviation: size, ..point }),
        };
    }
    part
}

/// Sizes a nanometre below a limit, on it or above it, by turns of the sizes.
pub fn sizes(limits: &[Vec<Limits>], turn: usize) -> Vec<Vec<Length>> {
    let size = |number: usize, limits: &Limits| {
        let (minimum, maximum) = (limits.minimum().nanometres(), limits.maximum().nanometres());
        let all = [minimum - NANOMETRE, minimum, limits.middle().nanometres(), maximum, maximum + NANOMETRE];
        Length::from_nanometres(all[number % all.len()]).unwrap()
    };
    // In one of five turns one side of a rectangle is too small and the other too large.
    let all = limits.iter().enumerate();
    let of = |(number, limits): (usize, &Vec<Limits>)| {
        limits.iter().enumerate().map(|(side, limits)| size(number + turn + 4 * side, limits)).collect()
    };
    all.map(of).collect()
}

/// Whether every size was measured within the library's limits, and has its verdict; the worst is that of the feature.
#[track_caller]
fn check(machine: &Machine, plan: &Plan, sizes: &[Vec<Length>]) -> Vec<Status> {
    let limits = limits(plan);
    assert_eq!(machine.cycles().len(), limits.len());
    let all = machine.cycles().iter().zip(plan.features()).zip(limits.iter().zip(sizes));
    let statuses = all.map(|((run, feature), (limits, sizes))| {
        let result = &run.result;
        let found: Vec<_> =
            result.checks.iter().map(|check| (check.minimum, check.maximum, check.measured, check.status)).collect();
        let expected = limits
            .iter()
            .zip(sizes)
            .map(|(limits, size)| (limits.minimum(), limits.maximum(), *size, judge(limits, *size, None).status()));
        let expected: Vec<_> = expected.collect();
        assert_eq!(found, expected, "{}", feature.name);
        let worst = expected.iter().map(|(.., status)| *status).max();
        assert_eq!(result.status, worst, "{}", feature.name);
        worst.unwrap()
    });
    statuses.collect()
}

#[test]
fn features_of_every_kind_on_one_part_have_the_librarys_verdicts_each() {
    let mut counted = BTreeMap::new();
    for control in Control::ALL {
        let plan = plan(control);
        assert_eq!(plan.features().len(), if control == Control::Itnc530 { 14 } else { 18 });
        for turn in 0..5 {
            let sizes = sizes(&limits(&plan), turn);
            let machine = run(&plan, control, Dialogue::En, part(&plan, &sizes));
            let statuses = check(&machine, &plan, &sizes);
            for status in &statuses {
                *counted.entry(status.word()).or_insert(0) += 1;
            }
            // Nothing stands in the way of any move; only surfaces at an angle to the axes are not looked at.
            let ways = machine.remarks().iter().map(|(_, remark)| remark);
            let ways: Vec<String> = ways
                .filter(|remark| matches!(remark, Remark::Collision { .. } | Remark::Unchecked { .. }))
                .map(ToString::to_string)
                .collect();
            let oblique = "moves are not checked in full against T3, T4".to_owned();
            assert_eq!(ways, if control == Control::Itnc530 { vec![] } else { vec![oblique] });
            // Every window has the word of its status, and every result of its feature is in its own file.
            let words: Vec<&str> = machine
                .windows()
                .iter()
                .map(|window| window.text.lines().next().unwrap().split(": ").nth(1).unwrap())
                .collect();
            assert_eq!(words, statuses.iter().map(|status| status.word()).collect::<Vec<_>>());
        }
    }
    assert_eq!(counted.into_iter().collect::<Vec<_>>(), [("GOOD", 144), ("REWORK", 50), ("SCRAP", 56)]);
}

#[test]
fn the_windows_of_pockets_and_points_have_the_limits_and_what_was_measured() {
    let plan = plan(Control::Tnc7);
    let machine = run(&plan, Control::Tnc7, Dialogue::Nl, plan.workpiece());
    let window = |number: usize| machine.windows()[number].text.replace("\r\n", "\n");
    assert_eq!(
        window(12),
        "STATUS RECHTHOEK: GOED\nGECONTROLEERD: 40 H7 x 25 D10\nGRENZEN ZIJDE 1:  40.0000/  40.0250\nGEMETEN ZIJDE 1:  40.0125\n\
         GRENZEN ZIJDE 2:  25.0650/  25.1490\nGEMETEN ZIJDE 2:  25.1070\n"
    );
    assert!(window(14).starts_with("STATUS VAN HET PUNT: GOED\nTOLERANTIE: 0.05-0.05\n"), "{}", window(14));
}

/// A control that does not set the status of its cycle must not say good with the one of an earlier feature.
#[test]
fn without_a_status_of_the_cycle_no_point_is_good() {
    let target = Target::new(Control::Tnc7, Dialogue::En);
    let rows = "name,kind,axis,callout,x,y,z\nA,point,-Z,±0.05,0,0,0\nB,point,-Z,±0.05,50,0,0\n";
    let set = NcSet::make(&plans::plan(rows), &target, &Sources::default()).unwrap();
    let path = |name: &str| format!("{}{name}", target.folder);
    let mut store: BTreeMap<NcPath, Vec<u8>> =
        set.files.iter().map(|file| (NcPath::of_file(&path(&file.name)), file.bytes.clone())).collect();
    let point = store.get_mut(&NcPath::of_file(&path("FIT_POINT.H"))).unwrap();
    let text = String::from_utf8(point.clone()).unwrap();
    let (before, rest) = text.split_once("7  TCH PROBE").unwrap();
    let (_cycle, after) = rest.split_once("8  L  Z+Q61").unwrap();
    *point = format!("{before}8  L  Z+Q61{after}").into_bytes();
    let (program, _) = Program::read(&set.files[0].bytes).unwrap();
    let settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    let main = path(&set.files[0].name);
    let mut machine = Machine::new(&main, Arc::new(program), store, Contacts::Perfect, settings);
    machine.set(Parameter::q(183), Value::Number(0.0)).unwrap();
    let fault = machine.run(u64::MAX).expect_err("an error of the program");
    assert_eq!(fault.kind.to_string(), "the program stopped itself with error 1004");
    assert!(machine.windows().is_empty());
}

#[test]
fn every_language_and_the_plans_own_part_are_good() {
    let plan = plan(Control::Tnc7);
    for language in Dialogue::ALL {
        let part = plan.workpiece();
        // What is written is what is run.
        let part = Part::read(&part.write().unwrap()).unwrap();
        let machine = run(&plan, Control::Tnc7, language, part);
        assert!(machine.cycles().iter().all(|run| run.result.status == Some(Status::Good)), "{language}");
    }
}

#[test]
fn a_set_has_only_the_programs_that_its_plan_needs() {
    let names = |text: &str, control| {
        let plan = plans::plan(text);
        let set = NcSet::make(&plan, &Target::new(control, Dialogue::En), &Sources::default()).unwrap();
        let page = String::from_utf8_lossy(&set.files.last().unwrap().bytes).into_owned();
        (set.files.iter().map(|file| file.name.clone()).collect::<Vec<_>>().join(" "), page)
    };
    let (files, page) = names("callout,x,y,z\n25 H7,0,0,0\n", Control::Tnc7);
    assert_eq!(files, "FIT_MAIN.H FIT_CHECK.H FIT_STATUS.A FIT_HOLE.TAB FIT_SHAFT.TAB README.TXT");
    assert!(!page.contains("WIDTH") && !page.contains("FACE"), "{page}");
    let (files, page) = names(&format!("{PLAN}{POINTS}"), Control::Tnc7);
    assert_eq!(
        files,
        "FIT_MAIN.H FIT_CHECK.H FIT_STATUS.A FIT_WIDTH.H FIT_WIDTH.A FIT_FACE.H FIT_FACE.A FIT_RECT.H FIT_RECT.A \
         FIT_POINT.H FIT_POINT.A FIT_HOLE.TAB FIT_SHAFT.TAB README.TXT"
    );
    for said in [
        "FIT_WIDTH.H, FIT_WIDTH.A: ",
        "FIT_FACE.H also uses Q42",
        "FIT_RECT.H also uses Q71",
        "FIT_POINT.H: the machine",
    ] {
        assert!(page.contains(said), "{page}");
    }
    let (files, _) = names(PLAN, Control::Itnc530);
    assert_eq!(
        files,
        "8255_en.h 82551_en.h 82552_en.a 82551_width_en.h 82552_width_en.a 82551_face_en.h 82552_face_en.a \
         82551_rect_en.h 82552_rect_en.a 82553_hole.tab 82553_shaft.tab README.TXT"
    );
    // A width off its limits is moved between them on a TNC7, and the page names the parameter.
    let plan = plan(Control::Tnc7);
    let set = NcSet::make(&plan, &Target::new(Control::Tnc7, Dialogue::En), &Sources::default()).unwrap();
    let said: Vec<String> = set.remarks.iter().map(ToString::to_string).collect();
    let moved = "N2: the nominal size of 10 D10 is outside the limits, which a TNC7 refuses: Q311 is 10.04 mm, and Q166 refers to that";
    assert!(said.iter().any(|said| said == moved), "{said:?}");
    for (side, nominal) in [("18 s7", "Q282 is 18.028 mm, and Q164"), ("25 D10", "Q283 is 25.065 mm, and Q165")] {
        assert!(said.iter().any(|said| said.contains(side) && said.contains(nominal)), "{said:?}");
    }
}

#[test]
fn what_a_kind_cannot_be_is_told_with_its_line() {
    let check = |row: &str, expected: &str| {
        let text = format!("kind,axis,angle,callout,x,y,z,callout2\n{row}\n");
        assert_eq!(plans::read(&text, &Sources::default()).unwrap_err().join("; "), expected, "{row}");
    };
    check(
        "groove,,,25 H7,0,0,0",
        "line 2: kind groove is not known: expected diameter, width, face, pocket, boss, point, length, form",
    );
    check("pocket,X,,25 H7,0,0,0", "line 2: a pocket has no axis");
    check("boss,,90,25 h7,0,0,0", "line 2: a boss has no angle");
    check("pocket,,,25 h7,0,0,0", "line 2: 25 h7: both sides of a pocket need classes such as H7");
    check("boss,,,25 h7,0,0,0,20 H7", "line 2: 20 H7: both sides of a boss need classes such as h7");
    check(
        "pocket,,,25 H7,0,0,0,±0.1",
        "line 2: ±0.1: ±0.1 does not begin with a nominal size: write one, such as 25 H7",
    );
    check("width,,,25 H7,0,0,0,20 H7", "line 2: a width has no callout2");
    check("point,,,±0.05,0,0,0", "line 2: axis is missing");
    let known = "+X, -X, +Y, -Y, +Z, -Z, or three numbers such as 0.5 0 -1, from -10 to 10 with at most 9 decimals and not all 0";
    for axis in ["Z", "0 0 0", "0 1", "0 0 0 1", "11 0 0", "0 0 1e-10", "0 0 inf", "a b c", "0.1.2 0 1"] {
        check(
            &format!("point,{axis},,±0.05,0,0,0"),
            &format!("line 2: axis {axis} is not a direction: expected {known}"),
        );
    }
    check("point,-Z,5,±0.05,0,0,0", "line 2: a point has no angle");
    check("point,-Z,,±0.05,0,0,0,±0.05", "line 2: a point has no callout2");
    let cycle = "the cycle needs an upper one of 0 or more and a lower one of 0 or less, not both 0";
    check("point,-Z,,+0.2 +0.1,0,0,0", &format!("line 2: a point cannot have deviations from 0.1 to 0.2 mm: {cycle}"));
    check("point,-Z,,±0,0,0,0", &format!("line 2: a point cannot have deviations from 0 to 0 mm: {cycle}"));
    let band = "is not a tolerance band for a point, such as ±0.05 or +0.1/-0.05";
    check(
        "point,-Z,,-0.1/+0.1,0,0,0",
        &format!(
            "line 2: -0.1/+0.1 {band}: the lower deviation comes before the upper one: write +0.1 -0.1 (character 1)"
        ),
    );
    check(
        "point,-Z,,10 ±0.1,0,0,0",
        &format!(
            "line 2: 10 ±0.1 {band}: 10 has no sign: write +10 or -10 for a deviation, without a space in the number (character 1)"
        ),
    );
    check(
        "point,-Z,,25 H7,0,0,0",
        &format!(
            "line 2: 25 H7 {band}: 25 has no sign: write +25 or -25 for a deviation, without a space in the number (character 1)"
        ),
    );
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

/// The written programs of widths, faces and rectangles against the library: every class of the tables, at the limits and
/// a nanometre beyond.
#[test]
fn widths_faces_and_rectangles_of_every_class_agree_with_the_library() {
    let classes: Vec<_> = fitcheck::control::shipped_tables()
        .iter()
        .flat_map(|table| table.columns().iter().map(|column| column.class).collect::<Vec<_>>())
        .collect();
    let mut rows = String::from("kind,axis,callout,x,y,z,clearance_height,callout2\n");
    for (number, class) in classes.iter().enumerate() {
        let place = 100 * number;
        writeln!(rows, "width,{},25 {class},{place},0,-8,50", ["X", "Y"][number % 2]).unwrap();
        // Every class on the first side, and on the second beside another.
        let other =
            classes.iter().skip(number + 1).chain(&classes).find(|other| other.feature() == class.feature()).unwrap();
        let kind = if class.feature() == Feature::Hole { "pocket" } else { "boss" };
        writeln!(rows, "{kind},,25 {class},{place},200,-8,50,40.5 {other}").unwrap();
        if class.feature() == Feature::Shaft {
            let nominal = 25 + number;
            writeln!(rows, "face,-Z,{nominal} {class},{place},500,{nominal},200").unwrap();
        }
    }
    let plan = plans::plan(&rows);
    let limits = limits(&plan);
    assert_eq!((classes.len(), limits.len()), (47, 117));
    for turn in 0..5 {
        let sizes = sizes(&limits, turn);
        check(&run(&plan, Control::Tnc7, Dialogue::Nl, part(&plan, &sizes)), &plan, &sizes);
    }
    // The last one's word is in the text parameter that the window prints.
    let machine = run(&plan, Control::Tnc7, Dialogue::En, part(&plan, &sizes(&limits, 0)));
    assert!(matches!(machine.variables().get(Parameter::qs(3)), Some(Value::Text(_))));
}

/// Points in any direction, with any band, anywhere: verdicts to the nanometre.
#[test]
fn points_in_any_direction_agree_with_the_library() {
    let parts = [-1.0_f64, -0.333, 0.0, 0.123_456_789, 2.0];
    let bands = ["±0.05", "+0.1/-0.05", "-0.1", "+3 µm", "±1"];
    let mut rows = String::from("kind\taxis\tcallout\tx\ty\tz\tclearance_height\n");
    // The probe comes from above: the normal points up.
    let directions = parts.iter().flat_map(|x| parts.iter().map(move |y| (x, y, -0.25 - x.abs())));
    for (count, (x, y, z)) in (0_u8..).zip(directions) {
        let (place, band) = (20.5 * f64::from(count), bands[usize::from(count) % bands.len()]);
        writeln!(rows, "point\t{x} {y} {z}\t{band}\t{place}\t-12345.678\t7.25\t50").unwrap();
    }
    let plan = plans::plan(&rows);
    assert_eq!(plan.features().len(), 25);
    for (turn, control) in [Control::Tnc640, Control::Tnc7].into_iter().cycle().take(5).enumerate() {
        let sizes = sizes(&limits(&plan), turn);
        check(&run(&plan, control, Dialogue::De, part(&plan, &sizes)), &plan, &sizes);
    }
}

#[test]
fn points_are_refused_for_a_control_without_their_cycle() {
    let plan = plans::plan(&format!("{PLAN}{POINTS}"));
    let made = |control| NcSet::make(&plan, &Target::new(control, Dialogue::En), &Sources::default());
    let refused = made(Control::Itnc530).unwrap_err().to_string();
    assert_eq!(refused, "line 16: a point is measured by cycle 444, which an iTNC 530 does not have (and 3 more)");
    assert!(made(Control::Tnc640).is_ok());
}

#[test]
fn a_feature_in_the_way_of_another_is_told() {
    // A shaft as high as the probe moves, between the holes.
    let plan = plans::plan("name,callout,x,y,z\nA,25 H7,0,0,-8\nB,25 H7,200,0,-8\n");
    let mut part = plan.workpiece();
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
