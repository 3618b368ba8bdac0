//! Rotations and tilted planes, and what is measured in them. The programs in `tests/data/samples/datum` and the values that they are to give
//! were worked out apart from the program, from geometry alone; so are those of the other tests, with sines and cosines written out.

use fitcheck::nc::machine::Contacts;
use fitcheck::probing::cycle::{Inputs, Value};
use fitcheck::probing::cycles::cycle;
use fitcheck::probing::simulated::{Part, Simulation};
use fitcheck::verdict::Status;
use proptest::prelude::*;

use crate::datum::{GOOD, MEASURE, SET, check, hole, ran, refused, remarks, run, sample, verdicts, with_table, zero};

/// A point turned about the zero by an angle in degrees, plus from X to Y.
fn turned([x, y]: [f64; 2], degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

/// An edge along X through a point, with its material above, turned by an angle; and a hole of 25.01 mm.
fn part(degrees: f64, [edge_x, edge_y]: [f64; 2], [x, y]: [f64; 2]) -> Contacts {
    let [normal_x, normal_y] = turned([0.0, -1.0], degrees);
    let text = format!(
        "[[feature]]\nname = \"E\"\nkind = \"face\"\npoint = [{edge_x}, {edge_y}, -5]\nnormal = [{normal_x}, {normal_y}, 0]\nreach = 300\n\
         [[feature]]\nname = \"H\"\nkind = \"bore\"\ncentre = [{x}, {y}]\ndiameter = 25.01\nbottom = -20\n[probe]\nball_radius = 3\n"
    );
    Contacts::Workpiece(Part::read(&text).unwrap())
}

/// A cycle on the edge at Y -60 from X -40 to X 40, with further lines.
fn on_edge(number: u32, lines: &str) -> String {
    format!(
        "TCH PROBE {number} LINE ~\nQ263=-40 ~\nQ264=-60 ~\nQ265=+40 ~\nQ266=-60 ~\nQ272=+2 ~\nQ267=+1 ~\nQ261=-5 ~\nQ320=+2 ~\n\
         Q260=+15 ~\nQ301=+0{lines}"
    )
}

#[test]
fn an_edge_becomes_the_basic_rotation_and_a_hole_is_measured_without_it() {
    let machine = ran("s7_420_400_421", &sample("s7_420_400_421.h"));
    check(&machine, &[(1, 0.4), (2, 0.4), (3, 49.9988), (4, 0.3491), (5, 0.0)]);
    check(&machine, &[(151, 50.2), (152, 40.3), (153, 20.01)]);
    assert_eq!(verdicts(&machine), [None, None, GOOD]);
    let said = remarks(&machine);
    assert!(said.iter().any(|said| said.contains("new basic rotation of 0.4°: active at once")), "{said:?}");
    assert!(said.iter().any(|said| said.contains("the basic rotation of 0.4° has ended")), "{said:?}");
    assert!(said.iter().any(|said| said.contains("FN 18 asks for a place from the zero of the machine")), "{said:?}");
    assert!(!machine.remarks_stand_against(), "{said:?}");
}

#[test]
fn a_tilted_plane_is_measured_along_its_own_axes() {
    let machine = ran("s9_427_tilted", &sample("s9_427_tilted.h"));
    check(&machine, &[(1, 10.03)]);
    assert_eq!(verdicts(&machine), [GOOD]);
    let datum = machine.cycles()[0].datum.as_ref().unwrap();
    assert_eq!(datum.tilt.as_ref().map(|tilt| (tilt.degrees, tilt.set_by.line)), Some(([0.0, 90.0, 30.0], 3)));
    let said = remarks(&machine);
    assert!(said.iter().any(|said| said.contains("the stylus is not checked for collisions")), "{said:?}");
    assert!(!said.iter().any(|said| said.contains("moved before this cycle")), "{said:?}");
}

#[test]
fn an_edge_along_the_minor_axis_is_turned_against_that_axis() {
    let text = "[[feature]]\nname = \"E\"\nkind = \"face\"\npoint = [50.05, 0, -5]\nnormal = [-0.9999875, 0.005, 0]\nreach = 60\n[probe]\nball_radius = 3\n";
    let part = || Contacts::Workpiece(Part::read(text).unwrap());
    let line = |number, more: &str| {
        format!(
            "TCH PROBE {number} LINE ~\nQ263=+50 ~\nQ264=+10 ~\nQ265=+50 ~\nQ266=-10 ~\nQ272=+1 ~\nQ267=+1 ~\nQ261=-5 ~\nQ320=+2 ~\nQ260=+15 ~\n\
             Q301=+1{more}"
        )
    };
    // 0.005 to one in plus X where Y grows: the contacts are 50.1 and 50.0, the line reads 89.7135 and leans to the right by 0.2865.
    let (machine, fault) = run(&line(420, ""), part());
    assert_eq!(fault, None);
    check(&machine, &[(150, 89.7135), (198, 420.0)]);
    let (machine, _) = run(&format!("{}\nFN 18: SYSREAD Q1 = ID210 NR1", line(400, "")), part());
    check(&machine, &[(1, -0.2865), (150, -0.2865)]);
    // Less the preset angle.
    let (machine, _) = run(&format!("{}\nFN 18: SYSREAD Q1 = ID210 NR1", line(400, " ~\nQ307=-0.5")), part());
    check(&machine, &[(1, 0.2135), (150, -0.2865)]);
    refused(
        &line(420, "").replace("Q266=-10", "Q266=+10"),
        part(),
        "Q264 and Q266 are the same: an edge needs two points along it",
    );
    refused(&line(400, "").replace("Q272=+1", "Q272=+3"), part(), "Q272");
}

#[test]
fn a_datum_in_a_rotated_system_lies_where_its_axes_say() {
    // The part is turned by 1 degree: its hole is at 30/20 of its own axes, its edge at -60.
    let part = || part(1.0, turned([0.0, -60.0], 1.0), turned([30.0, 20.0], 1.0));
    let set = SET.replace("Q321=+0", "Q321=+30").replace("Q322=+0", "Q322=+20");
    let (machine, fault) = run(&format!("{}\n{set}", on_edge(400, "")), part());
    assert_eq!(fault, None);
    // In its own axes it is where the drawing has it.
    check(&machine, &[(151, 30.0), (152, 20.0), (153, 25.01)]);
    let datum = format!("{}\n{set}\nL X+10 Y+0 R0 FMAX", on_edge(400, ""));
    let (machine, _) = run(&datum, part());
    let [x, y] = turned([40.0, 20.0], 1.0);
    let [at_x, at_y, _] = machine.position();
    assert!((at_x.unwrap() - x).abs() < 1e-5 && (at_y.unwrap() - y).abs() < 1e-5, "{:?}", machine.position());
    // A shift counts along the turned axes.
    let shifted = format!("{}\nCYCL DEF 7.1 X+30 Y+20\nL X+0 Y+0 R0 FMAX", on_edge(400, ""));
    let (machine, _) = run(&shifted, part());
    let [at_x, at_y, _] = machine.position();
    let [x, y] = turned([30.0, 20.0], 1.0);
    assert!((at_x.unwrap() - x).abs() < 1e-9 && (at_y.unwrap() - y).abs() < 1e-9, "{:?}", machine.position());
    // An increment, too: first along X, then along Y.
    let (machine, _) = run(&format!("{}\nL X+0 Y+0\nL IX+30\nL IY+20", on_edge(400, "")), part());
    let [at_x, at_y, _] = machine.position();
    assert!((at_x.unwrap() - x).abs() < 1e-9 && (at_y.unwrap() - y).abs() < 1e-9, "{:?}", machine.position());
}

#[test]
fn a_rotation_in_a_row_acts_with_cycle_247() {
    let part = || part(1.0, turned([0.0, -60.0], 1.0), [0.0, 0.0]);
    let read = "FN 18: SYSREAD Q1 = ID210 NR1";
    let preset = |number: u32| format!("CYCL DEF 247 DATUM SETTING ~\nQ339=+{number}");
    let row = on_edge(400, " ~\nQ305=+5");
    let (machine, fault) = run(&format!("{row}\n{read}\n{}\nFN 18: SYSREAD Q2 = ID210 NR1", preset(5)), part());
    assert_eq!(fault, None);
    check(&machine, &[(1, 0.0), (2, 1.0)]);
    // The active row acts at once; another row ends it.
    let (machine, _) =
        run(&format!("{}\n{row}\n{read}\n{}\nFN 18: SYSREAD Q2 = ID210 NR1", preset(5), preset(6)), part());
    check(&machine, &[(1, 1.0), (2, 0.0)]);
}

#[test]
fn the_rotation_of_the_preset_table_turns_the_axes_and_is_written() {
    let preset = |number: u32| format!("CYCL DEF 247 DATUM SETTING ~\nQ339=+{number}");
    // The workpiece lies as the row says that is active first. 421 measures without that rotation: along the axes of the machine, in
    // which the part is turned by 1.5 degrees.
    let (machine, fault) = with_table(&format!("{}\nFN 18: SYSREAD Q1 = ID210 NR1\n{MEASURE}", preset(4)));
    assert_eq!(fault, None);
    let [x, y] = turned([0.4, -0.3], 1.5);
    check(&machine, &[(1, 1.5), (151, x), (152, y), (153, 25.01)]);
    assert!(remarks(&machine).iter().any(|said| said.contains("the basic rotation of 1.5° has ended")));
    // Row 1 is not turned: seen from there the part of row 4 is. A datum in the turned axes is written in those of the machine.
    let set = SET.replace("Q305=+0", "Q305=+2");
    let (machine, fault) = with_table(&format!("{}\n{set}", preset(4)));
    assert_eq!(fault, None);
    let said = remarks(&machine);
    assert!(said.iter().any(|said| said.contains("row 2 of the preset table set to X 0.4, Y -0.3 mm")), "{said:?}");
}

#[test]
fn a_rotary_axis_turns_the_part_and_nothing_is_judged_until_it_has_a_datum() {
    let part = || part(1.0, turned([0.0, -60.0], 1.0), turned([0.3, 0.2], 1.0));
    let turn = on_edge(403, " ~\nQ312=+6 ~\nQ337=+1");
    refused(
        &format!("{turn}\n{MEASURE}"),
        part(),
        "a turn of the part by a rotary axis, without a new datum in both axes",
    );
    let (machine, fault) = run(&format!("{turn}\n{SET}\n{MEASURE}"), part());
    assert_eq!(fault, None);
    check(&machine, &[(151, 0.0), (152, 0.0), (153, 25.01)]);
    assert_eq!(verdicts(&machine), [None, None, GOOD]);
    assert!(!machine.remarks_stand_against(), "{:?}", remarks(&machine));
    let said = remarks(&machine);
    assert!(said.iter().any(|said| said.contains("axis C turns the part by 1°")), "{said:?}");
    // One axis is not enough; the preset of before is somewhere else on the part.
    let width = "TCH PROBE 419 DATUM IN ONE AXIS ~\nQ263=+0 ~\nQ264=-60 ~\nQ261=-5 ~\nQ320=+2 ~\nQ260=+15 ~\nQ272=+2 ~\nQ267=+1 ~\nQ305=+0";
    refused(&format!("{turn}\n{width}\n{MEASURE}"), part(), "a turn of the part by a rotary axis");
    let preset = "CYCL DEF 247 DATUM SETTING ~\nQ339=+1";
    refused(&format!("{turn}\n{SET}\n{preset}\n{MEASURE}"), part(), "a turn of the part by a rotary axis");
    // An axis that does not count as zero is said; another axis is not followed.
    let (machine, _) = run(&format!("{}\n{SET}\n{MEASURE}", on_edge(403, " ~\nQ312=+0")), part());
    assert!(remarks(&machine).iter().any(|said| said.contains("C moved before this cycle")), "{:?}", remarks(&machine));
    refused(&format!("{}\n{SET}\n{MEASURE}", on_edge(403, " ~\nQ312=+4")), part(), "an unknown datum");
}

#[test]
fn cycle_19_tilts_as_plane_spatial_does() {
    let text = sample("s9_427_tilted.h");
    let plane = "PLANE SPATIAL SPA+0 SPB+90 SPC+30 TURN MB MAX FMAX SEQ-";
    let swivel = text.replace(plane, "CYCL DEF 19.1 A+0 B+90 C+30");
    let machine = ran("s9_427_tilted", &swivel);
    check(&machine, &[(1, 10.03)]);
    assert!(remarks(&machine).iter().any(|said| said.contains("the rotary axes are taken to stand as it needs them")));
    // A shift within the plane goes along its axes, one before it along those of the workpiece.
    let within = text.replace(plane, &format!("{plane}\nCYCL DEF 7.1 Z+3"));
    check(&ran("s9_427_tilted", &within.replace("Q261=+10", "Q261=+7")), &[(1, 7.03)]);
    // The plane is at a right angle to X and Y, so a shift along Z changes nothing that is measured along its Z.
    let before = text.replace(plane, &format!("CYCL DEF 7.1 Z+3\n{plane}"));
    check(&ran("s9_427_tilted", &before), &[(1, 10.03)]);
    let before = text.replace(plane, &format!("CYCL DEF 7.1 X+2\n{plane}"));
    check(&ran("s9_427_tilted", &before), &[(1, 10.03 - 2.0 * 0.866_025_4)]);
}

#[test]
fn what_a_tilt_leaves_open_is_refused() {
    let plane = "PLANE SPATIAL SPA+0 SPB+0 SPC+30 TURN FMAX";
    refused(&format!("{plane}\n{SET}"), hole(), "the plane has been tilted since line 4");
    let shifted = format!("{plane}\nCYCL DEF 7.1 X+3\nPLANE RESET TURN FMAX\n{MEASURE}");
    refused(&shifted, hole(), "a shift from a plane that is no longer tilted has been active since line 6");
    let ended = format!("{plane}\nCYCL DEF 7.1 X+3\nCYCL DEF 7.1 X+0\nPLANE RESET TURN FMAX\n{MEASURE}");
    assert_eq!(run(&ended, hole()).1, None);
    let written = format!("{plane}\nCYCL DEF 7.1 X+3\nPLANE RESET TURN FMAX\nTRANS DATUM RESET\n{MEASURE}");
    assert_eq!(run(&written, hole()).1, None);
    // Where the axes stay after a tilt they are turned still.
    let (machine, _) = run(&format!("{plane}\nPLANE RESET STAY\n{MEASURE}"), hole());
    assert!(
        remarks(&machine).iter().any(|said| said.contains("A, B, C moved before this cycle")),
        "{:?}",
        remarks(&machine)
    );
    assert_eq!(zero(&machine), None);
}

/// What the cycle finds on a part whose axes are those of the program.
fn native(diameter: f64, at: [f64; 2]) -> (Option<Status>, Vec<Option<Value>>) {
    let [x, y] = at;
    let text = format!("[bore]\ncentre = [{x}, {y}]\ndiameter = {diameter}\n[probe]\nball_radius = 3\n");
    let mut machine = Part::from(Simulation::read(&text).unwrap()).machine().unwrap();
    let cycle = cycle(421).unwrap();
    let mut inputs = Inputs::new();
    for (name, value) in [
        ("Q273", "80"),
        ("Q274", "40"),
        ("Q262", "12"),
        ("Q325", "0"),
        ("Q247", "90"),
        ("Q261", "-5"),
        ("Q320", "2"),
        ("Q260", "15"),
        ("Q301", "0"),
        ("Q275", "12.018"),
        ("Q276", "12"),
        ("Q279", "0.05"),
        ("Q280", "0.05"),
    ] {
        inputs = cycle.set(inputs, name, value).unwrap();
    }
    let found = cycle.measure(&inputs, &mut machine).unwrap();
    (found.verdict(), [151_u16, 152, 153].map(|key| found.value(key).cloned()).to_vec())
}

proptest! {
    /// A part that lies anywhere and is turned is aligned by its edge and a hole; another hole has the verdict then that it has on a part
    /// whose axes are those of the program.
    #[test]
    fn a_part_that_was_aligned_is_judged_as_one_that_lies_straight(
        degrees in -3.0..3.0_f64,
        lies in prop::array::uniform2(-0.8..0.8_f64),
        half_diameter in 59_950..60_150_i32,
        half_off in prop::array::uniform2(-350..350_i32),
    ) {
        // No value is at a limit: the datum is a whole number of nanometres, and so the place of the hole is one more or less.
        let ten_thousandths = |half: i32| f64::from(2 * half + 1) / 10_000.0;
        let [lies_x, lies_y] = lies;
        let on_part = |at: [f64; 2]| {
            let [x, y] = turned(at, degrees);
            [x + lies_x, y + lies_y]
        };
        let [normal_x, normal_y] = turned([0.0, -1.0], degrees);
        let ([edge_x, edge_y], [hole_x, hole_y]) = (on_part([0.0, -60.0]), on_part([0.0, 0.0]));
        let [off_x, off_y] = half_off.map(ten_thousandths);
        let [x, y] = on_part([80.0 + off_x, 40.0 + off_y]);
        let diameter = ten_thousandths(half_diameter);
        let text = format!(
            "[[feature]]\nname = \"E\"\nkind = \"face\"\npoint = [{edge_x}, {edge_y}, -5]\nnormal = [{normal_x}, {normal_y}, 0]\nreach = 300\n\
             [[feature]]\nname = \"H\"\nkind = \"bore\"\ncentre = [{hole_x}, {hole_y}]\ndiameter = 25.01\nbottom = -20\n\
             [[feature]]\nname = \"M\"\nkind = \"bore\"\ncentre = [{x}, {y}]\ndiameter = {diameter}\nbottom = -20\n[probe]\nball_radius = 3\n"
        );
        let part = Contacts::Workpiece(Part::read(&text).unwrap());
        let measure = "TCH PROBE 421 MEASURE HOLE ~\nQ273=+80 ~\nQ274=+40 ~\nQ262=+12 ~\nQ325=+0 ~\nQ247=+90 ~\nQ261=-5 ~\nQ320=+2 ~\n\
                       Q260=+15 ~\nQ301=+0 ~\nQ275=+12.018 ~\nQ276=+12 ~\nQ279=+0.05 ~\nQ280=+0.05";
        let turn = on_edge(403, " ~\nQ312=+6 ~\nQ337=+1");
        let (machine, fault) = run(&format!("{turn}\n{SET}\n{measure}"), part);
        prop_assert_eq!(fault, None);
        let run = machine.cycles().last().unwrap();
        let (verdict, values) = native(diameter, [80.0 + off_x, 40.0 + off_y]);
        prop_assert_eq!(run.result.verdict(), verdict);
        for (key, right) in [151_u16, 152, 153].into_iter().zip(values) {
            let (Some(Value::Length(found)), Some(Value::Length(right))) = (run.result.value(key), right) else { panic!("Q{key}") };
            // The datum is a whole number of nanometres, and so is a centre.
            prop_assert!(found.saturating_sub(right).abs().nanometres() <= 2, "Q{}: {} for {}", key, found, right);
        }
    }
}

#[test]
fn the_edge_of_1410_turns_the_system_on() {
    let part = || part(1.0, turned([0.0, -60.0], 1.0), turned([0.3, 0.2], 1.0));
    let edge = "TCH PROBE 1410 PROBING ON EDGE ~\nQS1100=\"-40\" ~\nQS1101=\"-60\" ~\nQS1102=\"-5\" ~\nQS1103=\"+40\" ~\nQS1104=\"-60\" ~\nQS1105=\"-5\" ~\n\
                Q372=+2 ~\nQ320=+2 ~\nQ260=+15 ~\nQ1125=+1 ~\nQ309=+0 ~\nQ1126=+0 ~\nQ1120=+0 ~\nQ1121=+1";
    let read = "FN 18: SYSREAD Q1 = ID210 NR1";
    let (machine, fault) = run(&format!("{edge}\n{read}"), part());
    assert_eq!(fault, None);
    check(&machine, &[(964, 1.0), (1, 1.0)]);
    // It measures in the rotation that is there, and adds to it; 421 ends it.
    let (machine, fault) =
        run(&format!("{edge}\nQ2 = Q964\n{edge}\n{read}\n{MEASURE}\nFN 18: SYSREAD Q3 = ID210 NR1"), part());
    assert_eq!(fault, None);
    check(&machine, &[(2, 1.0), (964, 0.0), (1, 1.0), (3, 0.0)]);
}
