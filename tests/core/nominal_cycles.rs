//! Cycles 14xx: nominal values with their tolerances as texts, what is judged, what corrects the preset. The figures of the sample were worked
//! out apart from the program; those of the classes are cells of ISO 286.

use fitcheck::control::variables::{Parameter, Value};
use fitcheck::length::Length;
use fitcheck::nc::machine::{Contacts, Machine};
use fitcheck::probing::cycle::{self, Cycle, CycleError, CycleResult, Inputs, Phase, Plane, ResultName};
use fitcheck::probing::cycles::cycle_named;
use fitcheck::probing::simulated::{Face, FreePoint, Part, Probe, Simulation, Surface, Workpiece};
use fitcheck::tolerance::{Feature, Nominal};
use fitcheck::verdict::Status;

use crate::datum::{check, machine, over, ran, remarks, run, sample, verdicts, zero};

const CIRCLE: &str = "QS1100=25 QS1101=50 QS1102=-5 QS1116=25H7";

fn inputs(cycle: &Cycle, settings: &str) -> Result<Inputs, CycleError> {
    settings
        .split_whitespace()
        .filter_map(|pair| pair.split_once('='))
        .try_fold(Inputs::new(), |inputs, (key, text)| cycle.set(inputs, key, text))
}

/// What a cycle finds on a round feature at X25 Y50.
fn on_round(settings: &str, feature: Feature, diameter: f64) -> Result<CycleResult, CycleError> {
    let cycle = cycle_named("1401").unwrap();
    let part = Surface::Round(Workpiece::round(feature, [25.0, 50.0], diameter), Plane::Xy);
    cycle.measure(&inputs(cycle, settings)?, &mut Simulation::perfect(part).machine().unwrap())
}

#[track_caller]
fn refused(settings: &str, why: &str) {
    let error = on_round(settings, Feature::Hole, 25.0).unwrap_err();
    assert!(error.to_string().contains(why), "{settings}: {error}");
}

#[test]
fn a_text_is_probed_for_in_the_middle_of_its_zone() {
    for (text, target, limits) in [
        ("10H7", "10.0075", Some(("10", "10.015"))),
        ("10 h7", "9.9925", Some(("9.985", "10"))),
        ("10m", "10", Some(("9.8", "10.2"))),
        ("10+0.01-0.015", "9.9975", Some(("9.985", "10.01"))),
        ("8-2-1", "6.5", Some(("6", "7"))),
        ("10±0.1", "10", Some(("9.9", "10.1"))),
        ("+25", "25", None),
        ("-5+0.1-0.2", "-5.05", Some(("-5.2", "-4.9"))),
        ("0±0,1", "0", Some(("-0.1", "0.1"))),
        ("0.05+0.1-0.1", "0.05", Some(("-0.05", "0.15"))),
        ("+0.2+0.1-0.1", "0.2", Some(("0.1", "0.3"))),
    ] {
        let nominal: Nominal = text.parse().unwrap();
        let found = nominal.limits().map(|(minimum, maximum)| (minimum.to_string(), maximum.to_string()));
        let wanted = limits.map(|(minimum, maximum)| (minimum.to_owned(), maximum.to_owned()));
        assert_eq!((nominal.target().to_string().as_str(), found), (target, wanted), "{text}");
        assert_eq!(nominal.to_string().parse::<Nominal>(), Ok(nominal), "{text}");
    }
    for (text, why) in [
        ("?10H7", "? means that the operator positions the probe"),
        ("?", "? means that the operator positions the probe"),
        ("10H7@10.004", "@ means that the control does not probe"),
        ("±0.1", "does not begin with a nominal size"),
        ("+0.2-0.05", "does not begin with a nominal size"),
        ("-5H7", "nominal size -5 mm is not above 0"),
        ("10H", "is not a tolerance class"),
        ("0.4m", "0.5"),
        ("10H7/g6", "cannot stand in a text of cycles 14xx"),
    ] {
        let error = text.parse::<Nominal>().unwrap_err().to_string();
        assert!(error.contains(why), "{text}: {error}");
    }
}

#[test]
fn holes_are_judged_by_the_class_in_the_text() {
    let machine = ran("s10_1401_h7", &sample("s10_1401_h7.h"));
    check(&machine, &[(1, 25.013), (2, 0.0), (3, 25.03), (4, 2.0), (5, 24.99), (6, 1.0), (966, 24.99), (183, 1.0)]);
    assert_eq!(verdicts(&machine), [Some(Status::Good), Some(Status::Scrap), Some(Status::Rework)]);
    let first = &machine.cycles()[0].result;
    let value = |number: u16| first.value(number).map(ToString::to_string);
    let wanted = [(950, "25.01"), (951, "49.99"), (980, "0.01"), (981, "-0.01"), (996, "0.0025")];
    for (number, wanted) in wanted {
        assert_eq!(value(number).as_deref(), Some(wanted), "Q{number}");
    }
    // The height is where the ball touches: nobody has measured it.
    assert_eq!((value(952), value(982)), (None, None));
    // The text can be read by the program, and a number in its place has no tolerance.
    let plain = sample("s10_1401_h7.h").replace("QS1116=\"25H7\"", "Q1116=+25");
    let machine = ran("s10_1401_h7", &plain);
    check(&machine, &[(1, 25.013), (2, -1.0), (4, -1.0), (6, -1.0)]);
    assert_eq!(verdicts(&machine), [None; 3]);
    assert!(
        remarks(&machine).iter().any(|remark| remark.contains("nothing was compared with limits")),
        "{:?}",
        remarks(&machine)
    );
}

#[test]
fn an_iso_program_measures_the_same() {
    let text = sample("s10_1401_h7.h");
    let lines = text.lines().skip(3).take(14).map(|line| line.split(';').next().unwrap().trim());
    let block = lines.collect::<Vec<_>>().join(" ").replace("3  TCH PROBE 1401 CIRCLE PROBING ~", "");
    let iso = format!("%A G71 *\nN10 T100 G17 *\nN20 G1401 {block} *\nN30 M30 *\nN99999999 %A G71 *\n");
    let machine = ran("s10_1401_h7", &iso);
    check(&machine, &[(950, 25.01), (966, 25.013), (183, 0.0)]);
}

#[test]
fn a_stud_is_judged_the_other_way_round() {
    let stud = CIRCLE.replace("25H7", "25h7") + " Q1115=1";
    for (diameter, status) in
        [(25.001, Status::Rework), (25.0, Status::Good), (24.979, Status::Good), (24.978, Status::Scrap)]
    {
        let result = on_round(&stud, Feature::Shaft, diameter).unwrap();
        assert_eq!(result.verdict(), Some(status), "{diameter}");
    }
}

#[test]
fn what_is_not_defined_is_refused() {
    let other = "capitals is for a hole, one in small letters for a stud";
    refused(&CIRCLE.replace("25H7", "25h7"), other);
    refused(&format!("{CIRCLE} Q1115=1"), other);
    refused(&CIRCLE.replace("QS1102=-5", "QS1102=-5±0.1"), "does not measure this value");
    refused(&CIRCLE.replace("25H7", "0"), "a circle needs a diameter above 0");
    refused(&CIRCLE.replace("25H7", "25+0-30"), "at least 0 mm");
    refused(&format!("{CIRCLE} Q1119=0"), "at least 1°");
    refused(&format!("{CIRCLE} Q423=2"), "expected one of 3, 4, 5, 6, 7, 8, 9");
    refused(&format!("{CIRCLE} Q423=10"), "expected one of 3, 4, 5, 6, 7, 8, 9");
    refused(&CIRCLE.replace("QS1100=25", "QS1100=125"), "contact 1");
}

#[test]
fn a_centre_out_of_its_tolerance_is_scrap_and_stops_as_asked() {
    let centre = |tolerance: &str, setting: &str| {
        let settings = CIRCLE.replace("QS1100=25", &format!("QS1100=24.99{tolerance}"));
        on_round(&format!("{settings} Q309={setting}"), Feature::Hole, 25.01).unwrap()
    };
    let result = centre("+0.01-0", "2");
    assert_eq!((result.verdict(), result.stop.is_some()), (Some(Status::Good), false));
    // Counted from the middle of the zone.
    assert_eq!(result.length(ResultName::CENTRE_DEVIATION_1).unwrap().to_string(), "0.005");
    let result = centre("+0.009-0.1", "2");
    assert_eq!((result.verdict(), result.stop.is_some()), (Some(Status::Scrap), true));
    // Rework stops with 1 alone.
    for (setting, stops) in [("0", false), ("1", true), ("2", false)] {
        let result = on_round(&format!("{CIRCLE} Q309={setting}"), Feature::Hole, 24.99).unwrap();
        assert_eq!((result.verdict(), result.stop.is_some()), (Some(Status::Rework), stops), "Q309={setting}");
    }
}

#[test]
fn contacts_lie_over_the_arc_and_the_way_is_as_asked() {
    let angles = |settings: &str| -> Vec<String> {
        let result = on_round(&format!("{CIRCLE} {settings}"), Feature::Hole, 25.01).unwrap();
        let angle = |x: f64, y: f64| format!("{:.0}", (y - 50.0).atan2(x - 25.0).to_degrees());
        result.contacts.iter().map(|contact| angle(contact.x, contact.y)).collect()
    };
    assert_eq!(angles("Q423=5"), ["0", "72", "144", "-144", "-72"]);
    assert_eq!(angles("Q423=3 Q325=30 Q1119=-360"), ["30", "-90", "150"]);
    assert_eq!(angles("Q423=4 Q325=-45 Q1119=90"), ["-45", "-15", "15", "45"]);
    let highest = |mode: &str| {
        let result = on_round(&format!("{CIRCLE} Q1125={mode}"), Feature::Hole, 25.01).unwrap();
        let is_high = |z: f64| 49.0 < z;
        let over = result.path.iter().filter(|step| step.phase == Phase::PrePosition && is_high(step.from[2])).count();
        (over, result.path.iter().any(|step| step.phase == Phase::Leave))
    };
    assert_eq!([highest("-1"), highest("0"), highest("1")], [(0, false), (1, true), (1, true)]);
    assert_eq!(highest("2"), (7, true));
}

/// A program of this head, one hole and what stands behind it, on the part of the sample.
fn corrected(head: &str) -> (Machine, Option<String>) {
    let block = "TCH PROBE 1401 CIRCLE PROBING ~\nQS1100=\"+25\" ~\nQS1101=\"+50\" ~\nQS1102=\"-5\" ~\nQS1116=\"25H7\" ~\n\
                 Q1115=+0 ~\nQ423=+4 ~\nQ325=+0 ~\nQ1119=+360 ~\nQ320=+2 ~\nQ260=+40 ~\nQ1125=+1 ~\nQ309=+0 ~\n";
    let text = format!(
        "BEGIN PGM A MM\nTOOL CALL 100 Z S50\n{head}{block}Q1120=+1\nQ1 = Q950\n{block}Q1120=+0\nM30\nEND PGM A MM\n"
    );
    let part = Contacts::Workpiece(Part::read(&sample("s10_1401_h7.toml")).unwrap());
    over(machine(&text, part))
}

#[test]
fn the_active_preset_is_corrected_so_that_the_point_reads_its_nominal_value() {
    for (head, set) in [("", "datum set"), ("CYCL DEF 247 DATUM SETTING ~\nQ339=+3\n", "datum set")] {
        let (machine, fault) = corrected(head);
        assert_eq!(fault, None);
        check(&machine, &[(1, 25.01), (950, 25.0), (951, 50.0), (966, 25.013)]);
        assert_eq!(zero(&machine).as_deref(), Some("0.01 -0.01 0"));
        assert!(remarks(&machine).iter().any(|remark| remark.contains(set)), "{:?}", remarks(&machine));
    }
    // With a named row it is not known what becomes of a shift.
    let shift = "CYCL DEF 247 DATUM SETTING ~\nQ339=+3\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 Z+0.5\n";
    let (_, fault) = corrected(shift);
    assert!(fault.unwrap().contains("what a control makes of the shift is not known"));
}

#[test]
fn inches_have_no_tolerance_here() {
    let inch = |text: &str| {
        let text = sample("s10_1401_h7.h")
            .replace(" MM ", " INCH ")
            .replace("\"+25\"", "\"+0.984252\"")
            .replace("\"+50\"", "\"+1.968504\"")
            .replace("\"-5\"", "\"-0.2\"")
            .replace("Q320=+2 ", "Q320=+0.08 ")
            .replace("Q260=+40", "Q260=+2")
            .replace("25H7", text);
        let (head, _) = text.split_once("6  TCH PROBE").unwrap();
        let part = Contacts::Workpiece(Part::read(&sample("s10_1401_h7.toml")).unwrap());
        over(machine(&format!("{head}M30\nEND PGM S10_1401_H7 INCH\n"), part))
    };
    let (machine, fault) = inch("0.984252");
    assert_eq!(fault, None);
    check(&machine, &[(966, 25.013 / 25.4), (950, 25.01 / 25.4), (183, -1.0)]);
    assert_eq!(machine.variables().get(Parameter::qs(1116)), None::<&Value>);
    let (_, fault) = inch("25H7");
    let fault = fault.unwrap();
    assert!(fault.contains("in a program in inches the unit of a tolerance is not known"), "{fault}");
}

/// What cycle 1400 finds on a face at this place of its axis, facing the probe.
fn on_face(settings: &str, normal: [f64; 3], at: f64) -> Result<CycleResult, CycleError> {
    let cycle = cycle_named("1400").unwrap();
    let part = Surface::Face(Face::plane(normal.map(|part| part.abs() * at), normal));
    let simulation = Simulation { probe: Probe { ball_radius: 3.0, ..Probe::STILL }, ..Simulation::perfect(part) };
    cycle.measure(&inputs(cycle, settings)?, &mut simulation.machine().unwrap())
}

#[test]
fn a_face_is_judged_by_the_material_that_is_left() {
    let x = |direction: i64, at: f64| {
        let text = format!("QS1100=40+0.02-0.01 QS1101=10 QS1102=-5 Q372={direction}");
        on_face(&text, [if direction < 0 { 1.0 } else { -1.0 }, 0.0, 0.0], at).unwrap()
    };
    for (direction, at, status) in [
        (-1, 40.021, Status::Rework),
        (-1, 40.02, Status::Good),
        (-1, 39.99, Status::Good),
        (-1, 39.989, Status::Scrap),
        (1, 40.021, Status::Scrap),
        (1, 39.989, Status::Rework),
    ] {
        assert_eq!(x(direction, at).verdict(), Some(status), "{direction} {at}");
    }
    let result = x(-1, 40.021);
    let value = |number: u16| result.value(number).map(ToString::to_string);
    let found = [950, 951, 952, 980, 981, 982].map(value);
    let wanted = [Some("40.021"), Some("10"), Some("-5"), Some("0.016"), None, None];
    assert_eq!(found, wanted.map(|text| text.map(str::to_owned)));
    // The probe axis, and a tolerance of an axis that is not measured.
    let top = on_face("QS1100=40 QS1101=10 QS1102=0±0.05 Q372=-3", [0.0, 0.0, 1.0], 0.04).unwrap();
    assert_eq!(
        (top.verdict(), top.length(ResultName::POSITION_3).unwrap().to_string().as_str()),
        (Some(Status::Good), "0.04")
    );
    let error = on_face("QS1100=40 QS1101=10±0.1 QS1102=0 Q372=-3", [0.0, 0.0, 1.0], 0.0).unwrap_err().to_string();
    assert!(error.contains("QS1101") && error.contains("does not measure this value"), "{error}");
    let error = on_face("QS1100=40 QS1101=10 QS1102=0 Q372=0", [0.0, 0.0, 1.0], 0.0).unwrap_err().to_string();
    assert!(error.contains("expected one of -3, -2, -1, 1, 2, 3"), "{error}");
}

/// The edge of the fact sheet: turned by 0.4 degrees about X50 Y0.
const EDGE: &str = "QS1100=10 QS1101=0 QS1102=-5 QS1103=90 QS1104=0 QS1105=-5 Q372=2";

fn on_edge(settings: &str) -> Result<CycleResult, CycleError> {
    let cycle = cycle_named("1410").unwrap();
    let part = Surface::Face(Face::plane([50.0, 0.0, -5.0], [0.006_981_260_3, -0.999_975_630_7, 0.0]));
    let simulation = Simulation { probe: Probe { ball_radius: 3.0, ..Probe::STILL }, ..Simulation::perfect(part) };
    cycle.measure(&inputs(cycle, settings)?, &mut simulation.machine().unwrap())
}

#[test]
fn an_edge_gives_its_points_and_its_rotation() {
    let result = on_edge(EDGE).unwrap();
    let value = |number: u16| match result.value(number) {
        Some(cycle::Value::Length(length)) => length.to_mm_f64(),
        Some(cycle::Value::Angle(angle)) => angle.to_degrees_f64(),
        found => panic!("Q{number} is {found:?}"),
    };
    for (number, wanted) in [(950, 10.0), (951, -0.2793), (953, 90.0), (954, 0.2792), (964, 0.4), (981, -0.2793)] {
        assert!((value(number) - wanted).abs() < 0.000_06, "Q{number} = {}", value(number));
    }
    assert_eq!(result.verdict(), None);
    // Each point has a tolerance of its own. The face lies ahead of the second point: material is gone there.
    let judged = on_edge(&EDGE.replace("QS1101=0", "QS1101=0±0.3").replace("QS1104=0", "QS1104=0+0.2-0.3")).unwrap();
    assert_eq!(judged.checks.iter().map(|check| check.status).collect::<Vec<_>>(), [Status::Good, Status::Scrap]);
    // The middle of both points corrects the preset.
    let datum = on_edge(&format!("{EDGE} Q1120=3")).unwrap().datum.unwrap();
    assert_eq!(datum.axes.len(), 1);
    assert!(datum.axes[0].measured.to_mm_f64().abs() < 0.000_2 && datum.axes[0].wanted == Length::ZERO);
    for (settings, why) in [
        (format!("{EDGE} Q1121=2"), "Q1121 CONFIRM ROTATION: Fitcheck follows a basic rotation (Q1121 = 1) alone"),
        (format!("{EDGE} Q1126=1"), "Q1126 ALIGN ROTARY AXIS: Fitcheck follows a basic rotation"),
        (EDGE.replace("QS1103=90", "QS1103=10"), "an edge needs two points along it"),
        (EDGE.replace("Q372=2", "Q372=3"), "expected one of -2, -1, 1, 2"),
    ] {
        let error = on_edge(&settings).unwrap_err().to_string();
        assert!(error.contains(why), "{settings}: {error}");
    }
}

/// What cycle 1402 finds on a sphere about this place.
fn on_sphere(settings: &str, [x, y, z]: [f64; 3], radius: f64) -> Result<CycleResult, CycleError> {
    let cycle = cycle_named("1402").unwrap();
    let top = FreePoint { radius: Some(radius), ..FreePoint::flat([x, y, z + radius], [0.0, 0.0, 1.0]) };
    let perfect = Simulation::perfect(Surface::Point(top));
    let simulation = Simulation { probe: Probe { ball_radius: 3.0, ..Probe::STILL }, ..perfect };
    cycle.measure(&inputs(cycle, settings)?, &mut simulation.machine().unwrap())
}

#[test]
fn a_sphere_gives_its_centre_and_diameter_and_is_judged_like_a_stud() {
    let sphere = "QS1100=20±0.2 QS1101=30 QS1102=-15 QS1116=30h6 Q423=5";
    for (more, diameter, status) in [
        ("", 29.99, Status::Good),
        (" Q423=3 Q325=20", 30.001, Status::Rework),
        (" Q423=9 Q1119=200", 29.986, Status::Scrap),
        (" Q1125=2", 29.987, Status::Good),
    ] {
        let settings = if more.contains("Q423") { sphere.replace(" Q423=5", more) } else { format!("{sphere}{more}") };
        let result = on_sphere(&settings, [20.1, 29.95, -15.2], diameter / 2.0).unwrap();
        assert_eq!(result.verdict(), Some(status), "{more}");
        let value = |number: u16| result.value(number).unwrap().to_string();
        assert_eq!([950, 951, 952, 966].map(value), ["20.1", "29.95", "-15.2", &format!("{diameter}")], "{more}");
        assert_eq!([980, 981, 982].map(value), ["0.1", "-0.05", "-0.2"]);
        assert_eq!(result.contacts.len(), result.path.iter().filter(|step| step.phase == Phase::Contact).count());
    }
    let error = on_sphere(&sphere.replace("30h6", "30H6"), [20.0, 30.0, -15.0], 15.0).unwrap_err().to_string();
    assert!(error.contains("small letters for a stud"), "{error}");
    // A tolerance of the height counts: it is measured.
    let high = on_sphere(&sphere.replace("QS1102=-15", "QS1102=-15±0.1"), [20.0, 30.0, -14.8], 14.995).unwrap();
    assert_eq!(high.verdict(), Some(Status::Scrap));
}

/// Two holes 80 mm apart, turned by 0.4 degrees about the first.
#[test]
fn two_circles_give_their_sizes_and_the_line_through_them() {
    let (sin, cos) = 0.4_f64.to_radians().sin_cos();
    let text = format!(
        "[[feature]]\nname = \"A\"\nkind = \"bore\"\ncentre = [10, 20]\ndiameter = 20.012\nbottom = -20\n\
         [[feature]]\nname = \"B\"\nkind = \"stud\"\ncentre = [{}, {}]\ndiameter = 25.03\ntop = 0\nbottom = -20\n[probe]\nball_radius = 3\n",
        10.0 + 80.0 * cos,
        20.0 + 80.0 * sin
    );
    let block = "TCH PROBE 1411 PROBING TWO CIRCLES ~\nQS1100=\"10\" ~\nQS1101=\"20\" ~\nQS1102=\"-5\" ~\nQS1116=\"20H7\" ~\nQS1103=\"90\" ~\n\
                 QS1104=\"20\" ~\nQS1105=\"-5\" ~\nQS1117=\"25h7\" ~\nQ1115=+2 ~\nQ423=+4 ~\nQ325=+0 ~\nQ1119=+360 ~\nQ320=+2 ~\nQ260=+40 ~\n\
                 Q1125=+1 ~\nQ309=+0 ~\nQ1126=+0 ~\nQ1120=+0 ~\nQ1121=+1";
    let part = || Contacts::Workpiece(Part::read(&text).unwrap());
    let (machine, fault) = run(&format!("{block}\nFN 18: SYSREAD Q1 = ID210 NR1"), part());
    assert_eq!(fault, None);
    check(&machine, &[(950, 10.0), (951, 20.0), (966, 20.012), (953, 10.0 + 80.0 * cos), (954, 20.0 + 80.0 * sin)]);
    check(&machine, &[(967, 25.03), (964, 0.4), (1, 0.4), (183, 1.0)]);
    let result = &machine.cycles()[0].result;
    // The hole is good, the stud above its maximum of 25.
    assert_eq!(result.checks.iter().map(|check| check.status).collect::<Vec<_>>(), [Status::Good, Status::Rework]);
    // A perfect workpiece has both in the middle of their zones.
    let (machine, fault) = run(block, Contacts::Perfect);
    assert_eq!(fault, None);
    check(&machine, &[(966, 20.0105), (967, 24.9895), (964, 0.0), (183, 0.0)]);
    for (from, to, why) in [
        ("QS1103=\"90\"", "QS1103=\"10\"", "an edge needs two points along it"),
        ("QS1117=\"25h7\"", "QS1117=\"25H7\"", "Q1115"),
        ("Q1120=+0", "Q1120=+3", "Q1121 CONFIRM ROTATION"),
    ] {
        let fault = run(&block.replace(from, to), part()).1.unwrap();
        assert!(fault.contains(why), "{fault}");
    }
    // The middle of both centres corrects the preset.
    let middle = block.replace("Q1120=+0", "Q1120=+3").replace("Q1121=+1", "Q1121=+0");
    let (machine, fault) = run(&middle, part());
    assert_eq!(fault, None);
    let datum = machine.cycles()[0].result.datum.clone().unwrap();
    assert_eq!(datum.axes.iter().map(|axis| axis.wanted.to_string()).collect::<Vec<_>>(), ["50", "20"]);
}
