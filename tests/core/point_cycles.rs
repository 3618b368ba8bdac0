//! Cycles 427 and 444 and G785: the manuals' blocks, exact workpieces, every result and every stop.

use std::collections::BTreeMap;

use fitcheck::length::Length;
use fitcheck::message::Say as _;
use fitcheck::probing::cycle::{
    Cycle, CycleError, CycleResult, Inputs, Key, LogTarget, Phase, Plane, Remark, ResultName, ResultParameter, Value,
};
use fitcheck::probing::cycles::cycle_named;
use fitcheck::probing::simulated::{Face, FreePoint, Lobes, Machine, Probe, Simulation, Surface, Workpiece};
use fitcheck::probing::{Contact, NoContact, Prober, Recorded, Touch, TouchProbe};
use fitcheck::tolerance::Feature;
use fitcheck::verdict::Status;
use fitcheck::words::{Language, Words};
use proptest::prelude::*;

/// Manual TNC7 (Italian), the example block of cycle 427.
const EXAMPLE_427: &str = "Q263=+35 Q264=+45 Q261=+5 Q320=+0 Q272=+3 Q267=-1 Q260=+20 Q281=+1 Q288=+5.1 Q289=+4.95 \
                        Q309=+0 Q330=+0 Q498=+0 Q531=+0";

/// Manual CNC PILOT 640, the example block of G785.
const EXAMPLE_785: &str = "R=0 BR=0 K=2 C=0 RC=60 I=0 J=0 Q=0 P=0 H=0";

fn inputs(cycle: &Cycle, settings: &str) -> Result<Inputs, CycleError> {
    settings.split_whitespace().try_fold(Inputs::new(), |inputs, setting| {
        let (name, text) = setting.split_once('=').unwrap();
        cycle.set(inputs, name, text)
    })
}

fn run(code: &str, settings: &str, prober: &mut dyn Prober) -> Result<CycleResult, String> {
    let cycle = cycle_named(code).unwrap();
    inputs(cycle, settings).and_then(|inputs| cycle.measure(&inputs, prober)).map_err(|error| {
        let english = error.to_string();
        assert_eq!(Words::new(Language::En).told(&error), english);
        assert_ne!(Words::new(Language::Nl).told(&error), error.message().id);
        english
    })
}

fn results(result: &CycleResult) -> String {
    result
        .results
        .iter()
        .filter(|found| found.key.is_some())
        .map(|found| format!("{}={}", found.called(), found.value))
        .collect::<Vec<_>>()
        .join(" ")
}

fn said(what: &(impl std::fmt::Display + fitcheck::message::Say)) -> String {
    let english = what.to_string();
    assert_eq!(Words::new(Language::En).told(what), english);
    assert_ne!(Words::new(Language::Nl).told(what), english);
    english
}

fn face(point: [f64; 3], normal: [f64; 3]) -> Surface {
    Surface::Face(Face { point, normal, wave: None, surface_scatter: 0.0 })
}

fn ball(ball_radius: f64) -> Probe {
    Probe { ball_radius, ..Probe::STILL }
}

fn machine(surface: Surface, ball_radius: f64) -> Machine {
    Machine::with(surface, ball(ball_radius), 1).unwrap()
}

/// Whether every move begins where the one before ended.
fn is_unbroken(result: &CycleResult) -> bool {
    let apart = |from: [f64; 3], to: [f64; 3]| from.iter().zip(to).any(|(from, to)| 0.0 < (from - to).abs());
    result.path.windows(2).all(|pair| !apart(pair[0].to, pair[1].from))
}

fn length(mm: f64) -> Value {
    Value::Length(Length::from_mm_f64(mm).unwrap())
}

/// A top face at a height.
fn top(height: f64) -> Surface {
    face([0.0, 0.0, height], [0.0, 0.0, 1.0])
}

#[track_caller]
fn check_427(height: f64, changes: &str, expected: &str) -> CycleResult {
    let result = run("427", &format!("{EXAMPLE_427} {changes}"), &mut machine(top(height), 2.0)).unwrap();
    assert_eq!(results(&result), expected);
    result
}

#[test]
fn the_block_of_cycle_427_measures_a_height_between_its_limits() {
    let good = check_427(5.0, "", "Q160=5 Q180=1 Q181=0 Q182=0");
    assert_eq!(good.log, LogTarget::File("TCHPR427.TXT"));
    assert_eq!((good.status, good.stop.as_ref()), (Some(Status::Good), None));
    let remarks: Vec<_> = good.remarks.iter().map(said).collect();
    assert_eq!(
        remarks,
        [
            "Q498 is accepted but has no effect",
            "Q531 is accepted but has no effect",
            "an outside dimension is assumed: above the maximum is rework, below the minimum is scrap",
            "the deviation has no parameter here: the manual says that a control stores it, but not in which one",
        ]
    );
    // On the limits and one nanometre beyond.
    check_427(5.1, "", "Q160=5.1 Q180=1 Q181=0 Q182=0");
    check_427(4.95, "", "Q160=4.95 Q180=1 Q181=0 Q182=0");
    check_427(5.100_001, "", "Q160=5.100001 Q180=0 Q181=1 Q182=0");
    check_427(4.949_999, "", "Q160=4.949999 Q180=0 Q181=0 Q182=1");
    // Both limits 0: nothing is monitored, and the marker says good.
    let unmonitored = check_427(7.0, "Q288=0 Q289=0 Q309=1", "Q160=7 Q180=1 Q181=0 Q182=0");
    assert!(unmonitored.checks.is_empty() && unmonitored.stop.is_none());
}

/// Actual value less nominal value of the measured axis; the manual names no parameter for it.
#[test]
fn cycle_427_gives_the_deviation_without_a_parameter() {
    let deviation = |result: &CycleResult| {
        let of = |found: &&ResultParameter| found.name == ResultName::COORDINATE_DEVIATION;
        let found = result.results.iter().find(of).unwrap();
        assert_eq!((found.key, said(&found.name)), (None, "deviation of the coordinate".to_owned()));
        found.value.to_string()
    };
    assert_eq!(deviation(&check_427(5.0231, "", "Q160=5.0231 Q180=1 Q181=0 Q182=0")), "0.0231");
    assert_eq!(deviation(&check_427(4.9, "", "Q160=4.9 Q180=0 Q181=0 Q182=1")), "-0.1");
    assert_eq!(deviation(&check_427(7.0, "Q288=0 Q289=0", "Q160=7 Q180=1 Q181=0 Q182=0")), "2");
    for (axis, nominal) in [(1, 35.0), (2, 45.0)] {
        let (mut place, mut normal) = ([35.0, 45.0, 5.0], [0.0; 3]);
        place[axis - 1] = nominal + 0.25;
        normal[axis - 1] = 1.0;
        let settings = format!("{EXAMPLE_427} Q272={axis} Q288=99 Q289=0");
        let result = run("427", &settings, &mut machine(face(place, normal), 2.0)).unwrap();
        assert_eq!(deviation(&result), "0.25");
    }
}

/// As 421 has it for Q262: the manual asks for a measuring height between limits that 427 does not have.
#[test]
fn a_nominal_coordinate_outside_the_limits_is_remarked() {
    let check = |height: &str, limits: &str, expected: bool| {
        let result = run("427", &format!("{EXAMPLE_427} Q261={height} {limits}"), &mut machine(top(5.0), 2.0)).unwrap();
        let text =
            format!("nominal coordinate {height} mm is not between the limits: by its manual a TNC7 may refuse that");
        assert_eq!(result.remarks.iter().map(said).any(|remark| remark == text), expected, "{height}");
    };
    for (height, expected) in [("4.95", false), ("5.1", false), ("4.949999", true), ("5.100001", true)] {
        check(height, "", expected);
    }
    check("7", "Q288=0 Q289=0", false);
}

#[test]
fn q309_stops_and_names_what_is_out() {
    let stop = check_427(5.2, "Q309=1", "Q160=5.2 Q180=0 Q181=1 Q182=0").stop.unwrap();
    assert_eq!(said(&stop), "program stop by Q309 = 1: measured coordinate 5.2 mm is above its maximum 5.1 mm: REWORK");
    assert_eq!(check_427(5.2, "", "Q160=5.2 Q180=0 Q181=1 Q182=0").stop, None);
    let hole = Workpiece::round(Feature::Hole, [50.1, 20.0], 24.99);
    let settings = "Q273=50 Q274=20 Q262=25 Q275=25.021 Q276=25 Q279=0.05 Q280=0.05 Q309=1 Q281=2 Q330=5.1";
    let both = run("421", settings, &mut Machine::new(hole, ball(3.0), 1).unwrap()).unwrap();
    assert_eq!(
        said(both.stop.as_ref().unwrap()),
        "program stop by Q309 = 1: measured diameter 24.99 mm is below its minimum 25 mm: REWORK; \
         measured centre, 1st axis 50.1 mm is above its maximum 50.05 mm: SCRAP"
    );
    let all: Vec<_> = both.checks.iter().map(said).collect();
    assert_eq!(all[2], "measured centre, 2nd axis 20 mm is within 19.95 to 20.05 mm");
    assert_eq!(both.log, LogTarget::Screen);
    assert_eq!(said(&both.remarks[0]), "Q330 = 5.1: the tool is not monitored: no tool table");
}

#[test]
fn limits_that_are_swapped_are_refused() {
    let refused = run("427", &format!("{EXAMPLE_427} Q288=4"), &mut machine(top(5.0), 0.0)).unwrap_err();
    assert_eq!(refused, "Q289 = 4.95 mm is above Q288 = 4 mm: the minimum dimension is above the maximum");
}

#[test]
fn no_contact_within_dist_is_an_error_and_the_way_is_kept() {
    let cycle = cycle_named("427").unwrap();
    let probe =
        TouchProbe { longest_path: "6".parse().unwrap(), set_up: "1.5".parse().unwrap(), ..TouchProbe::default() };
    let given = inputs(cycle, EXAMPLE_427).unwrap().with_probe(probe);
    // The ball starts 1.5 mm above where it would touch at 5, so 4.5 mm deeper is still reached.
    assert!(cycle.measure(&given, &mut machine(top(0.5), 2.0)).is_ok());
    let (path, refused) = cycle.measure_along(&given, &mut machine(top(0.499_999), 2.0));
    let refused = refused.unwrap_err();
    assert_eq!(said(&refused), "contact 1: the probe met nothing within the probing path of 6 mm");
    assert!(matches!(refused, CycleError::NoContact(NoContact::OutOfReach { number: 1, .. })));
    assert_eq!(path.last().map(|step| (step.phase, step.to[2])), Some((Phase::Approach, 2.5)));
    let (path, refused) = cycle.measure_along(&given, &mut machine(top(7.0), 2.0));
    assert_eq!(refused.unwrap_err().to_string(), "contact 1: the probing path begins inside the material");
    assert_eq!(path.last().map(|step| step.phase), Some(Phase::PrePosition));
}

/// DIST sets the probing path of cycle 444, whatever the normal.
#[test]
fn cycle_444_meets_nothing_beyond_dist() {
    let cycle = cycle_named("444").unwrap();
    let probe =
        TouchProbe { longest_path: "6".parse().unwrap(), set_up: "1.5".parse().unwrap(), ..TouchProbe::default() };
    let given = inputs(cycle, "Q263=10 Q264=20 Q294=5 Q581=0 Q582=0 Q583=3 Q260=50").unwrap().with_probe(probe);
    // The ball starts 1.5 mm before its contact with the nominal point, so 4.5 mm deeper is still reached.
    assert!(cycle.measure(&given, &mut machine(top(0.5), 2.0)).is_ok());
    let (path, refused) = cycle.measure_along(&given, &mut machine(top(0.499_999), 2.0));
    let refused = refused.unwrap_err();
    assert_eq!(said(&refused), "contact 1: the probe met nothing within the probing path of 6 mm");
    // The ball stops where DIST ends: 8.5 - 6 mm.
    assert_eq!(path.last().map(|step| (step.phase, step.to[2])), Some((Phase::Approach, 2.5)));
}

#[test]
fn the_way_of_cycle_427_is_listed_move_by_move() {
    let result = check_427(5.0, "Q320=1", "Q160=5 Q180=1 Q181=0 Q182=0");
    let moves: Vec<_> = result.path.iter().map(|step| (step.phase, step.to[2])).collect();
    // Ball radius 2, SET_UP 2, Q320 1: five above the point.
    let expected = [
        (Phase::PrePosition, 10.0),
        (Phase::Approach, 7.0),
        (Phase::Contact, 7.0),
        (Phase::Retract, 10.0),
        (Phase::Leave, 20.0),
    ];
    assert_eq!(moves, expected);
    assert!(is_unbroken(&result));
}

/// A level surface at zero, moved up.
fn raised(deviation: f64) -> Surface {
    let normal = [0.0, 0.0, 1.0];
    Surface::Point(FreePoint { point: [0.0; 3], normal, deviation, radius: None, surface_scatter: 0.0 })
}

/// Cycle 444 on a point (10, 20, 30) with the normal (0, 3, 4), moved out along it.
#[track_caller]
fn check_444(deviation: f64, changes: &str, expected: &str) -> CycleResult {
    let point =
        FreePoint { point: [10.0, 20.0, 30.0], normal: [0.0, 3.0, 4.0], deviation, radius: None, surface_scatter: 0.0 };
    let settings = format!("Q263=10 Q264=20 Q294=30 Q581=0 Q582=3 Q583=4 Q320=1 Q260=80 {changes}");
    let result = run("444", &settings, &mut machine(Surface::Point(point), 2.5)).unwrap();
    assert_eq!(results(&result), expected);
    result
}

#[test]
fn cycle_444_gives_position_deviations_and_a_status() {
    let on_it = check_444(0.0, "", "Q151=10 Q152=20 Q153=30 Q161=0 Q162=0 Q163=0 Q164=0 Q183=-1");
    assert_eq!((on_it.status, on_it.log), (None, LogTarget::File("TCHPR444.html")));
    let good = "Q151=10 Q152=20.06 Q153=30.08 Q161=0 Q162=0.06 Q163=0.08 Q164=0.1 Q183=0";
    check_444(0.1, "QS400=0.4-0.1", good);
    // On the limits and one nanometre beyond.
    let status = |deviation: f64, band: &str| {
        let settings = format!("Q263=0 Q264=0 Q294=0 Q581=0 Q582=0 Q583=0.001 QS400={band}");
        run("444", &settings, &mut machine(raised(deviation), 2.5)).unwrap().value(183).cloned()
    };
    for (deviation, band, expected) in [
        (0.4, "0.4-0.1", 0),
        (0.400_001, "0.4-0.1", 1),
        (-0.1, "0.4-0.1", 0),
        (-0.100_001, "0.4-0.1", 2),
        (0.4, "0.4", 0),
        (-0.000_001, "0.4", 2),
        (0.000_001, "-0.1", 1),
        (-0.1, "-0.1", 0),
        (1.5, "", -1),
        (1.5, "0", -1),
        (1.5, "0.1+0.1", -1),
    ] {
        assert_eq!(status(deviation, band), Some(Value::Whole(expected)), "{deviation} in {band:?}");
    }
}

#[test]
fn a_tolerance_text_that_is_none_is_remarked() {
    for (given, is_remarked) in
        [("", false), ("QS400=0.4-0.1", false), ("QS400=0.1+0.2", true), ("QS400=-0.1-0.2", true)]
    {
        let settings = format!("Q263=0 Q264=0 Q294=0 Q581=0 Q582=0 Q583=1 {given}");
        let found = run("444", &settings, &mut machine(raised(0.3), 1.0)).unwrap();
        let remark = Remark::NoTolerance { key: Key::Qs(400) };
        assert_eq!(found.remarks.contains(&remark), is_remarked, "{given:?}");
    }
}

#[test]
fn q309_of_cycle_444_stops_on_both_sides_or_on_undersize_only() {
    let stops = |deviation: f64, q309: u8| {
        let settings = format!("Q263=0 Q264=0 Q294=0 Q581=0 Q582=0 Q583=1 QS400=0.4-0.1 Q309={q309}");
        run("444", &settings, &mut machine(raised(deviation), 1.0)).unwrap().stop.is_some()
    };
    for (deviation, stop) in [
        (0.5, [false, true, false]),
        (-0.2, [false, true, true]),
        // Within tolerance nothing stops, whether below or above nominal.
        (-0.05, [false, false, false]),
        (0.05, [false, false, false]),
    ] {
        assert_eq!([0, 1, 2].map(|q309| stops(deviation, q309)), stop, "{deviation}");
    }
}

#[test]
fn cycle_444_starts_on_the_normal_and_retracts_by_mb() {
    let far = check_444(0.0, "MB=10", "Q151=10 Q152=20 Q153=30 Q161=0 Q162=0 Q163=0 Q164=0 Q183=-1");
    let near =
        |place: [f64; 3], wanted: [f64; 3]| place.iter().zip(wanted).all(|(is, should)| (is - should).abs() < 1e-9);
    let of = |result: &CycleResult, phase| result.path.iter().rfind(|step| step.phase == phase).unwrap().to;
    // 2.5 + 2 + 1 along (0, 0.6, 0.8); after the contact 2.5 from the point, and 10 more.
    assert!(near(of(&far, Phase::PrePosition), [10.0, 23.3, 34.4]));
    assert!(near(of(&far, Phase::Contact), [10.0, 21.5, 32.0]));
    assert!(near(of(&far, Phase::Retract), [10.0, 27.5, 40.0]));
    assert!(near(far.path[0].from, [10.0, 23.3, 80.0]));
    let back = check_444(0.0, "", "Q151=10 Q152=20 Q153=30 Q161=0 Q162=0 Q163=0 Q164=0 Q183=-1");
    assert!(near(of(&back, Phase::Retract), [10.0, 23.3, 34.4]));
}

#[test]
fn a_normal_without_direction_is_refused() {
    let settings = "Q263=0 Q264=0 Q294=0 Q581=0 Q582=0 Q583=0";
    let refused = run("444", settings, &mut Recorded::new(Vec::new())).unwrap_err();
    assert_eq!(refused, "Q581, Q582 and Q583 are all 0: a normal needs a direction");
    let refused = run("444", "QS400=H7", &mut Recorded::new(Vec::new())).unwrap_err();
    assert!(refused.starts_with("QS400 TOLERANCE: H7 is not a deviation"), "{refused}");
}

#[test]
fn a_wrong_normal_gives_a_wrong_deviation_as_on_the_control() {
    // The surface is level, the normal leans: the ball touches beside the point, and radius times 1 − cos is missing.
    let settings = "Q263=0 Q264=0 Q294=0 Q581=0.1 Q582=0 Q583=1";
    let result = run("444", settings, &mut machine(top(0.0), 2.0)).unwrap();
    let Some(Value::Length(deviation)) = result.value(164) else { panic!() };
    let cos = 1.0 / 1.01_f64.sqrt();
    assert!((deviation.to_mm_f64() - (2.0 / cos - 2.0)).abs() < 1e-6, "{deviation}");
}

fn bore(centre: [f64; 2], diameter: f64, plane: Plane) -> Surface {
    Surface::Round(Workpiece::round(Feature::Hole, centre, diameter), plane)
}

#[test]
fn the_block_of_g785_measures_a_small_bore() {
    let result = run("G785", EXAMPLE_785, &mut machine(bore([0.02, -0.01], 3.0, Plane::Xy), 0.5)).unwrap();
    assert_eq!(results(&result), "#i99=3 X=0.02 Y=-0.01");
    assert_eq!((result.status, result.log), (None, LogTarget::Shown));
    let remarks: Vec<_> = result.remarks.iter().map(said).collect();
    assert_eq!(remarks.len(), 4);
    assert_eq!(remarks[3], "#i99 is read as the diameter: the manual does not say which value it holds");
    // A bore that is not reached with K.
    let refused = run("G785", EXAMPLE_785, &mut machine(bore([0.0, 0.0], 6.0, Plane::Xy), 0.5)).unwrap_err();
    assert_eq!(refused, "contact 1: the probe met nothing within the probing path of 2 mm");
    let refused = run("G785", "K=0 RC=60", &mut Recorded::new(Vec::new())).unwrap_err();
    assert_eq!(refused, "K MEASURING PATH = 0 mm: a probing path needs a length; its sign gives the direction");
}

#[test]
fn g785_pre_positions_on_the_start_diameter_at_its_height() {
    let stud = Surface::Round(Workpiece::round(Feature::Shaft, [1.0, 2.0], 20.0), Plane::Xy);
    let settings = "BR=1 K=-8 C=30 RC=120 D=30 WB=-7 I=1 J=2";
    let result = run("G785", settings, &mut machine(stud, 1.5)).unwrap();
    assert_eq!(results(&result), "#i99=20 X=1 Y=2");
    let arcs: Vec<_> = result.path.iter().filter(|step| step.about == Some([1.0, 2.0, -7.0])).collect();
    assert_eq!(arcs.len(), 2);
    for step in &result.path {
        assert!((step.to[2] + 7.0).abs() < 1e-12);
    }
    // With the other sign the probe runs away from the stud.
    let refused = run("G785", "BR=1 K=8 RC=120 D=30 I=1 J=2", &mut machine(stud, 1.5)).unwrap_err();
    assert_eq!(refused, "contact 1: the probe met nothing on the probing path");
    // And a negative path meets the other wall of a hole.
    let other = run("G785", "K=-20 RC=120", &mut machine(bore([0.0, 0.0], 25.0, Plane::Xy), 1.5)).unwrap();
    assert_eq!(results(&other), "#i99=25 X=0 Y=0");
    assert!((other.contacts[0].x + 12.5).abs() < 1e-9);
}

#[test]
fn we_touches_twice_keeps_the_mean_and_stops_where_both_differ_too_much() {
    let twice = |x: [f64; 6]| {
        let directions = [0.0_f64, 120.0, 240.0];
        let contact = |number: usize| {
            let (sin, cos) = directions[number / 2].to_radians().sin_cos();
            Contact { x: x[number] * cos, y: x[number] * sin, z: 0.0 }
        };
        Recorded::new((0..6).map(contact).collect())
    };
    let settings = "K=20 RC=120 WE=0.01";
    let mean = run("G785", settings, &mut twice([10.0, 10.01, 10.002, 10.008, 10.005, 10.005])).unwrap();
    assert_eq!(mean.value(Key::Word("#i99")), Some(&length(20.01)));
    assert_eq!(mean.contacts.len(), 3);
    assert_eq!(mean.path.iter().filter(|step| step.phase == Phase::Contact).count(), 6);
    let refused = run("G785", settings, &mut twice([10.0, 10.01, 10.0, 10.010_001, 10.0, 10.0])).unwrap_err();
    assert_eq!(refused, "contact 2: its two probings lie 0.010001 mm apart, WE permits 0.01 mm");
}

proptest! {
    #[test]
    fn cycle_427_gives_the_exact_coordinate(
        point in [-400.0..400.0_f64, -400.0..400.0, -100.0..100.0],
        off in -1.5..1.5_f64,
        axis in 0_usize..3,
        down in any::<bool>(),
        ball_radius in 0.0..5.0_f64,
    ) {
        let sign = if down { -1.0 } else { 1.0 };
        let mut normal = [0.0; 3];
        normal[axis] = -sign * 2.5;
        let mut place = point;
        place[axis] += off;
        let settings = format!("Q272={} Q267={sign}", axis + 1);
        let cycle = cycle_named("427").unwrap();
        let keys = [263, 264, 261];
        let given = keys.into_iter().zip(point).fold(inputs(cycle, &settings).unwrap(), |inputs, (key, part)| {
            inputs.with(key, length(part))
        });
        let result = cycle.measure(&given, &mut machine(face(place, normal), ball_radius)).unwrap();
        let contact = result.contacts[0].place();
        prop_assert!((contact[axis] - place[axis]).abs() < 1e-9, "{contact:?}");
        prop_assert_eq!(result.value(160), Some(&length(place[axis])));
        prop_assert!(is_unbroken(&result));
    }

    #[test]
    fn the_other_direction_gives_the_same_coordinate(height in -50.0..50.0_f64, ball_radius in 0.0..5.0_f64) {
        // One face seen from both sides.
        let measured = |direction: f64| {
            let cycle = cycle_named("427").unwrap();
            let given = inputs(cycle, &format!("Q264=0 Q261=0 Q272=1 Q267={direction}")).unwrap();
            let given = given.with(263, length(height + 0.3));
            let surface = face([height, 0.0, 0.0], [-direction, 0.0, 0.0]);
            cycle.measure(&given, &mut machine(surface, ball_radius)).unwrap().value(160).cloned()
        };
        prop_assert_eq!(measured(1.0), measured(-1.0));
    }

    #[test]
    fn cycle_444_gives_the_exact_deviation_along_any_normal(
        point in [-300.0..300.0_f64, -300.0..300.0, -300.0..300.0],
        normal in [-10.0..10.0_f64, -10.0..10.0, -10.0..10.0],
        shrunk in prop_oneof![Just(1.0), Just(1e-3), Just(1e-200)],
        deviation in -1.5..1.5_f64,
        radius in prop_oneof![Just(None), (10.0..500.0_f64).prop_map(Some), (10.0..500.0_f64).prop_map(|r| Some(-r))],
        ball_radius in 0.0..5.0_f64,
    ) {
        prop_assume!(0.01 < normal.iter().map(|part| part * part).sum::<f64>());
        let point = point.map(|part| Length::from_mm_f64(part).unwrap().to_mm_f64());
        let surface = Surface::Point(FreePoint { point, normal, deviation, radius, surface_scatter: 0.0 });
        let cycle = cycle_named("444").unwrap();
        let keys = [(263, 581), (264, 582), (294, 583)];
        let given = keys.into_iter().zip(point.into_iter().zip(normal)).fold(
            Inputs::new(),
            |inputs, ((place, component), (mm, part))| {
                inputs.with(place, length(mm)).with(component, Value::Number(part * shrunk))
            },
        );
        let result = cycle.measure(&given, &mut machine(surface, ball_radius)).unwrap();
        let size = normal.iter().map(|part| part * part).sum::<f64>().sqrt();
        for (axis, part) in result.contacts[0].place().into_iter().enumerate() {
            let expected = point[axis] + deviation * normal[axis] / size;
            prop_assert!((part - expected).abs() < 1e-9, "{part} {expected}");
        }
        let Some(Value::Length(along)) = result.value(164) else { panic!() };
        prop_assert!((along.to_mm_f64() - deviation).abs() < 0.6e-6);
    }

    #[test]
    fn circles_are_exact_for_any_ball_plane_side_angle_and_sense(
        is_hole in any::<bool>(),
        plane in prop_oneof![Just(Plane::Xy), Just(Plane::Zx), Just(Plane::Yz)],
        centre in [-200.0..200.0_f64, -200.0..200.0],
        off in [-0.4..0.4_f64, -0.4..0.4],
        diameter in 15.0..200.0_f64,
        angle in -360..360_i32,
        step in prop_oneof![40..=120_i32, -120..=-40_i32],
        ball_radius in 0.0..4.0_f64,
    ) {
        let feature = if is_hole { Feature::Hole } else { Feature::Shaft };
        let surface = Surface::Round(Workpiece::round(feature, centre, diameter), plane);
        let r = match plane { Plane::Xy => 0, Plane::Zx => 1, Plane::Yz => 2 };
        let (start, sign) = if is_hole { (diameter - 12.0, 1) } else { (diameter + 12.0, -1) };
        let cycle = cycle_named("G785").unwrap();
        let settings = format!("R={r} BR={} K={} C={angle} RC={step} WB=3", i32::from(!is_hole), sign * 9);
        let given = inputs(cycle, &settings).unwrap()
            .with(Key::Word("D"), length(start))
            .with(Key::Word("I"), length(centre[0] + off[0]))
            .with(Key::Word("J"), length(centre[1] + off[1]));
        let result = cycle.measure(&given, &mut machine(surface, ball_radius)).unwrap();
        let circle = result.circle.clone().unwrap().circle;
        prop_assert!((circle.diameter - diameter).abs() < 1e-9, "{circle:?}");
        prop_assert!((circle.x - centre[0]).abs() < 1e-9 && (circle.y - centre[1]).abs() < 1e-9, "{circle:?}");
        for contact in result.plane_contacts() {
            prop_assert!(((contact.x - centre[0]).hypot(contact.y - centre[1]) - diameter / 2.0).abs() < 1e-9);
            prop_assert!((contact.z - 3.0).abs() < 1e-12);
        }
        // The same feature in X/Y by 421 or 422.
        if plane == Plane::Xy {
            let cycle = cycle_named(if is_hole { "421" } else { "422" }).unwrap();
            let given = inputs(cycle, &format!("Q325={angle} Q247={step}")).unwrap()
                .with(273, length(centre[0] + off[0]))
                .with(274, length(centre[1] + off[1]))
                .with(262, length(diameter));
            let circle = cycle.measure(&given, &mut machine(surface, ball_radius)).unwrap().circle.unwrap().circle;
            prop_assert!((circle.diameter - diameter).abs() < 1e-9, "{circle:?}");
        }
    }

    #[test]
    fn a_ball_touches_a_lobed_contour_and_never_cuts_it(
        is_hole in any::<bool>(),
        count in 2_u32..=12,
        amplitude in 0.001..0.2_f64,
        angle in 0.0..360.0_f64,
        ball_radius in 0.1..3.0_f64,
    ) {
        let feature = if is_hole { Feature::Hole } else { Feature::Shaft };
        let lobes = Lobes { count, amplitude, angle: 17.0 };
        let workpiece = Workpiece { lobes, ..Workpiece::round(feature, [0.0, 0.0], 20.0) };
        let (sin, cos) = angle.to_radians().sin_cos();
        let (from, sign) = if is_hole { (0.0, 1.0) } else { (20.0, -1.0) };
        let touch = Touch { from: [from * cos, from * sin, 0.0], direction: [sign * cos, sign * sin, 0.0], longest: 50.0 };
        let met = Machine::new(workpiece, ball(ball_radius), 1).unwrap().touch(&touch).unwrap();
        let nearest = (0..36_000).map(|step| {
            let towards = (f64::from(step) / 100.0).to_radians();
            let radius = 10.0 + amplitude * (f64::from(count) * (towards - 17.0_f64.to_radians())).cos();
            (met.x - radius * towards.cos()).hypot(met.y - radius * towards.sin())
        }).fold(f64::INFINITY, f64::min);
        prop_assert!(ball_radius - 1e-9 <= nearest && nearest < ball_radius + 1e-5, "{nearest} for {ball_radius}");
    }
}

#[track_caller]
fn simulation(text: &str) -> Simulation {
    Simulation::read(text).unwrap_or_else(|error| panic!("{error}"))
}

const BORE: &str = "[bore]\ncentre = [50, 20]\ndiameter = 25\n";

/// The diameter that cycle 421 finds.
fn found(text: &str, probe: TouchProbe) -> (f64, f64, f64) {
    let cycle = cycle_named("421").unwrap();
    let given = inputs(cycle, "Q273=50 Q274=20 Q262=25").unwrap().with_probe(probe);
    let mut machine = simulation(text).machine().unwrap().calibrated(&probe);
    let circle = cycle.measure(&given, &mut machine).unwrap().circle.unwrap().circle;
    (circle.x, circle.y, circle.diameter)
}

#[test]
fn every_fault_of_the_machine_shows_by_its_amount() {
    let near = |is: f64, should: f64| assert!((is - should).abs() < 1e-9, "{is} not {should}");
    let usual = TouchProbe::default();
    // 10 K of steel on 25 mm: 2.875 µm; facts: 100 mm by 10 K is 11.5 µm.
    let (x, _, diameter) = found(&format!("temperature = 30\n{BORE}"), usual);
    near(diameter, 25.002_875);
    near(x, 50.005_75);
    let (_, _, diameter) = found(&format!("temperature = 30\nexpansion = 23.1\n{BORE}"), usual);
    near(diameter, 25.005_775);
    // A ball assumed 0.5 µm too large makes a bore 1 µm too large.
    let (_, _, diameter) = found(&format!("{BORE}[probe]\nball_radius = 3\ncalibration_error = 0.0005\n"), usual);
    near(diameter, 25.001);
    // An offset that is calibrated changes nothing; the rest moves the centre.
    let offset = format!("{BORE}[probe]\nball_radius = 3\noffset = [0.01, -0.02]\n");
    let row = TouchProbe { offset: ["0.01", "-0.02"].map(|text| text.parse().unwrap()), ..usual };
    let (x, y, diameter) = found(&offset, row);
    near(x, 50.0);
    near(y, 20.0);
    near(diameter, 25.0);
    let (x, y, diameter) = found(&offset, usual);
    near(x, 49.99);
    near(y, 20.02);
    near(diameter, 25.0);
    // The same pre-travel in all four directions widens by twice its amount.
    let lobing = "[probe]\nball_radius = 3\nlobing = { count = 4, amplitude = 0.0007 }\n";
    let (_, _, diameter) = found(&format!("{BORE}{lobing}"), usual);
    near(diameter, 25.001_4);
}

#[test]
fn a_wave_lifts_the_ball_to_the_crest_and_lets_it_into_the_trough() {
    let height = |x: &str, ball: &str| {
        let text = format!(
            "[face]\npoint = [0, 0, 5]\nnormal = [0, 0, 1]\nwave = {{ amplitude = 0.01, length = 20, direction = [1, 0, 0] }}\n\
             [probe]\nball_radius = {ball}\n"
        );
        let cycle = cycle_named("427").unwrap();
        let given = inputs(cycle, &format!("Q263={x} Q264=0 Q261=5 Q272=3 Q267=-1")).unwrap();
        let result = cycle.measure(&given, &mut simulation(&text).machine().unwrap()).unwrap();
        result.contacts[0].z
    };
    for ball in ["0", "2"] {
        assert!((height("0", ball) - 5.01).abs() < 1e-9);
        assert!((height("10", ball) - 4.99).abs() < 1e-9);
        assert!((height("20", ball) - 5.01).abs() < 1e-9);
    }
    assert!((height("5", "0") - 5.0).abs() < 1e-9);
    // On the flank the ball is a little higher than the surface below it.
    let flank = height("5", "2");
    assert!(5.0 < flank && flank < 5.000_1, "{flank}");
}

#[test]
fn a_machine_file_that_cannot_be_is_refused_with_its_line() {
    let refused = |text: &str, expected: &str| {
        let error = Simulation::read(text).unwrap_err();
        assert_eq!(said_in_both(&error), expected);
    };
    refused(
        "seed = 1\n",
        "the file has 0 of [bore], [stud], [face], [point], [slot], [ridge], [pocket], [boss]: it needs exactly one",
    );
    refused(
        &format!("{BORE}[face]\npoint=[0,0,0]\nnormal=[0,0,1]\n"),
        "the file has 2 of [bore], [stud], [face], [point], [slot], [ridge], [pocket], [boss]: it needs exactly one",
    );
    refused("[bore]\ncentre = [0, 0]\ndiameter = -1\n", "line 3: diameter = -1: at least 0.001, at most 100000");
    refused(
        "[bore]\ncentre = [0, 0]\ndiameter = 25\nlobes = { count = 1, amplitude = 0.1 }\n",
        "line 4: lobes = 1: at least 2, at most 100",
    );
    refused(
        "[bore]\ncentre = [0, 0]\ndiameter = 25\n[probe]\nball_radius = -2\n",
        "line 5: ball radius = -2: at least 0, at most 100",
    );
    refused(&format!("temperature = 500\n{BORE}"), "line 1: temperature = 500: at least -100, at most 200");
    refused(
        "[face]\npoint = [0, 0, 0]\nnormal = [0, 0, 0]\n",
        "line 3: length of the normal = 0: at least 0.000001, at most 200000",
    );
    refused("[bore]\ncentre = [0, nan]\ndiameter = 25\n", "line 2: centre y = NaN: at least -100000, at most 100000");
    let odd = Simulation::read("[bore]\ncentre = [0, 0]\ndiameter = 25\ncolour = 'red'\n").unwrap_err().to_string();
    assert!(odd.starts_with("line 4: unknown field `colour`"), "{odd}");
    let long = Simulation::read(&format!("[bore]\n{}=1\n", "a".repeat(300_000))).unwrap_err().to_string();
    assert!(long.starts_with("line 2: unknown field `aaa") && long.ends_with('…'), "{}", long.len());
    assert!(long.chars().count() < 400, "{}", long.len());
    let broken = Simulation::read("[bore\n").unwrap_err().to_string();
    assert!(broken.starts_with("line 1: "), "{broken}");
}

fn said_in_both(error: &fitcheck::probing::simulated::SimulationError) -> String {
    let english = error.to_string();
    // People read a true minus sign.
    assert_eq!(Words::new(Language::En).told(error).replace('\u{2212}', "-"), english);
    assert_ne!(Words::new(Language::Nl).told(error), error.message().id);
    english
}

#[test]
fn the_same_file_gives_the_same_contacts_and_scatter_has_its_size() {
    let text =
        format!("seed = 9\n{BORE}surface_scatter = 0.0003\n[probe]\nball_radius = 3\ntrigger_scatter = 0.0004\n");
    let usual = TouchProbe::default();
    assert_eq!(found(&text, usual), found(&text, usual));
    assert_ne!(found(&text, usual), found(&text.replace("seed = 9", "seed = 10"), usual));
    let diameters: Vec<f64> =
        (0..1000).map(|seed| found(&text.replace("seed = 9", &format!("seed = {seed}")), usual).2).collect();
    let mean = diameters.iter().sum::<f64>() / 1000.0;
    let sigma = (diameters.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / 999.0).sqrt();
    // Four contacts: u(D) = s, and s is 0.5 µm.
    assert!((sigma / 0.000_5 - 1.0).abs() < 4.0 / 2000.0_f64.sqrt(), "{sigma}");
}

#[test]
fn three_by_sixty_degrees_is_three_times_as_uncertain_as_three_by_120() {
    // Tests the table of factors through the lathe's cycle, not only through the formula.
    let sigma = |step: u32| {
        let surface = bore([0.0, 0.0], 25.0, Plane::Xy);
        let probe = Probe { trigger_scatter: 0.000_5, ..Probe::STILL };
        let diameters: Vec<f64> = (0..3000)
            .map(|seed| {
                let mut machine = Machine::with(surface, probe, seed).unwrap();
                let result = run("G785", &format!("K=20 C=10 RC={step}"), &mut machine).unwrap();
                result.circle.unwrap().circle.diameter
            })
            .collect();
        let mean = diameters.iter().sum::<f64>() / 3000.0;
        (diameters.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / 2999.0).sqrt()
    };
    let factor = sigma(60) / sigma(120);
    assert!((factor / 3.0 - 1.0).abs() < 0.08, "{factor}");
}

#[test]
fn every_result_has_a_name_in_both_languages() {
    let mut names = BTreeMap::new();
    let runs = [
        run("421", "Q273=50 Q274=20 Q262=25", &mut machine(bore([50.0, 20.0], 25.0, Plane::Xy), 2.0)).unwrap(),
        check_427(5.0, "", "Q160=5 Q180=1 Q181=0 Q182=0"),
        check_444(0.0, "", "Q151=10 Q152=20 Q153=30 Q161=0 Q162=0 Q163=0 Q164=0 Q183=-1"),
    ];
    for found in runs.iter().flat_map(|result| &result.results) {
        assert_eq!(Words::new(Language::En).told(&found.name), found.name.to_string());
        let dutch = Words::new(Language::Nl).told(&found.name);
        assert_ne!(dutch, found.name.message().id);
        names.insert(found.name.to_string(), dutch);
    }
    assert_eq!(names.len(), 19);
}
