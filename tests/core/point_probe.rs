//! Cycles 0 and 1: one contact, which gives a coordinate or only where the probe stood.

use fitcheck::nc::machine::Contacts;
use fitcheck::probing::Contact;
use fitcheck::probing::simulated::Part;

use crate::datum::{check, refused, remarks, run};

/// A top at Z 0.25 and a face at X 40.1 with its material in plus direction.
fn part() -> Contacts {
    let text = "[[feature]]\nname = \"T\"\nkind = \"face\"\npoint = [0, 0, 0.25]\nnormal = [0, 0, 1]\nreach = 100\n\
                [[feature]]\nname = \"F\"\nkind = \"face\"\npoint = [40.1, 0, -5]\nnormal = [-1, 0, 0]\nreach = 100\n[probe]\nball_radius = 3\n";
    Contacts::Workpiece(Part::read(text).unwrap())
}

const TOP: &str = "TCH PROBE 0.0 REF. PLANE Q5 Z-\nTCH PROBE 0.1 X+5 Y+0 Z+10";

#[test]
fn a_coordinate_is_that_of_the_surface() {
    // The ball's centre stands a radius above the top, and the control's own parameters have it so.
    let (machine, fault) = run(&format!("{TOP}\nQ1 = Q5 + 1"), part());
    assert_eq!(fault, None);
    check(&machine, &[(5, 0.25), (1, 1.25), (115, 5.0), (116, 0.0), (117, 3.25)]);
    let position = machine.position();
    assert_eq!(position, [Some(5.0), Some(0.0), Some(10.0)]);
    let (machine, fault) = run("TCH PROBE 0.0 REF. PLANE Q5 X+\nTCH PROBE 0.1 X+20 Y+0 Z-5", part());
    assert_eq!(fault, None);
    check(&machine, &[(5, 40.1), (115, 37.1)]);
    // In the system in force, and in the program's unit.
    let (machine, _) =
        run("CYCL DEF 7.1 X+40 Z+0.2\nTCH PROBE 0.0 REF. PLANE Q5 X +\nTCH PROBE 0.1 X-20 Y+0 Z-5", part());
    check(&machine, &[(5, 0.1)]);
    let (machine, _) = run(
        "PLANE SPATIAL SPA+0 SPB+90 SPC+0 TURN FMAX\nTCH PROBE 0.0 REF. PLANE Q5 Z+\nTCH PROBE 0.1 X+5 Y+0 Z+20",
        part(),
    );
    check(&machine, &[(5, 40.1)]);
    // A parameter gets the coordinate of recorded contacts as they are: points of the surface.
    let recorded = Contacts::Recorded(vec![Contact::at([5.0, 0.0, 0.3])]);
    check(&run(TOP, recorded).0, &[(5, 0.3)]);
}

#[test]
fn a_polar_probing_says_only_where_the_probe_stood() {
    // 30 degrees from X: the ball meets the face at X 37.1 after 17.1 / cos 30.
    let polar = "TCH PROBE 1.0 POLAR PRESET\nTCH PROBE 1.1 X ANGLE: +30\nTCH PROBE 1.2 X+20 Y+0 Z-5";
    let (machine, fault) = run(polar, part());
    assert_eq!(fault, None);
    check(&machine, &[(115, 37.1), (116, 17.1 * 30_f64.to_radians().tan()), (117, -5.0)]);
    let dutch = polar.replace("POLAR PRESET", "POLAIR REF.PT").replace("ANGLE:", "HOEK:");
    check(&run(&dutch, part()).0, &[(115, 37.1)]);
}

#[test]
fn what_a_probing_needs_is_asked_for() {
    refused(TOP, Contacts::Perfect, "cycles 0 and 1 probe a single point, and a perfect workpiece has none");
    refused(&TOP.replace("Z+10", ""), part(), "where the probing begins is not known in all axes");
    refused(&TOP.replace("Z+10", "Z+100"), part(), "cycle 0: contact 1");
    refused("TCH PROBE 0.1 X+5 Y+0 Z+10", part(), "does not follow cycle 0.1");
    refused(&TOP.replace("Q5 Z-", "Q5"), part(), "does not follow cycle 0.0");
    refused(&TOP.replace("X+5", "A+5"), part(), "does not follow cycle 0.1");
    refused(&format!("CYCL DEF 8.1 X\n{TOP}"), part(), "mirroring has been active");
    let flat = Contacts::WithoutHeights(vec![Contact::at([5.0, 0.0, 0.0])]);
    refused(TOP, flat, "cycle 0: contact 1");
    let (machine, _) = run(&format!("M3\n{TOP}"), part());
    assert!(remarks(&machine).iter().any(|said| said.contains("M3")), "{:?}", remarks(&machine));
}
