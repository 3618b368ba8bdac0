//! Cycles 423 to 426 on walls: exact on an exact workpiece, status and results by the stated rules, courses, logs.

use fitcheck::control::cycle_log::{CycleLog, Heading};
use fitcheck::control::cycle_status::cycle_window;
use fitcheck::control::log;
use fitcheck::exchange::{WhyUnjudged, import};
use fitcheck::length::{Length, Unit};
use fitcheck::probing::cycle::{Cycle, CycleResult, Inputs, Phase, Remark, Value};
use fitcheck::probing::cycles::cycle_named;
use fitcheck::probing::simulated::{Machine, Probe, Simulation, Surface, Walls};
use fitcheck::probing::{Contact, NoContact, Recorded};
use fitcheck::tolerance::{Feature, Sources};
use fitcheck::verdict::Status;
use fitcheck::words::Dialogue;
use proptest::prelude::*;

fn length(mm: f64) -> Value {
    Value::Length(Length::from_mm_f64(mm).unwrap())
}

fn given(code: &str, settings: &str) -> (&'static Cycle, Inputs) {
    let cycle = cycle_named(code).unwrap();
    let set = |inputs, setting: &str| {
        let (name, text) = setting.split_once('=').unwrap();
        cycle.set(inputs, name, text).unwrap()
    };
    (cycle, settings.split_whitespace().fold(Inputs::new(), set))
}

fn on(walls: Walls, ball_radius: f64) -> Machine {
    Machine::with(Surface::Walls(walls), Probe { ball_radius, ..Probe::STILL }, 1).unwrap()
}

fn of(result: &CycleResult, key: u16) -> String {
    result.value(key).unwrap_or_else(|| panic!("no Q{key}")).to_string()
}

/// The markers Q180, Q181 and Q182.
fn markers(result: &CycleResult) -> String {
    [180, 181, 182].map(|key| of(result, key)).concat()
}

const SLOT: &str = "Q328=50 Q329=20 Q272=1 Q261=-5 Q260=30 Q311=20";
const RIDGE: &str = "Q263=60 Q264=20 Q265=40 Q266=20 Q272=1 Q261=-5 Q260=30 Q311=20";
const RECTANGLE: &str = "Q273=50 Q274=20 Q282=60 Q283=40 Q261=-5 Q260=30";

fn slot(settings: &str, width: f64) -> CycleResult {
    let (cycle, inputs) = given("425", &format!("{SLOT} {settings}"));
    cycle.measure(&inputs, &mut on(Walls::new(Feature::Hole, [50.5, 0.0], (width, None)), 3.0)).unwrap()
}

fn ridge(settings: &str, width: f64) -> CycleResult {
    let (cycle, inputs) = given("426", &format!("{RIDGE} {settings}"));
    cycle.measure(&inputs, &mut on(Walls::new(Feature::Shaft, [50.0, 0.0], (width, None)), 1.0)).unwrap()
}

fn rectangle(code: &str, settings: &str, centre: [f64; 2], (first, second): (f64, f64)) -> CycleResult {
    let (cycle, inputs) = given(code, &format!("{RECTANGLE} {settings}"));
    let feature = if code == "423" { Feature::Hole } else { Feature::Shaft };
    cycle.measure(&inputs, &mut on(Walls::new(feature, centre, (first, Some(second))), 1.5)).unwrap()
}

#[test]
fn a_slot_has_its_width_its_centre_line_and_their_deviation() {
    let found = slot("", 20.01);
    assert_eq!(["156", "157", "166"].map(|key| of(&found, key.parse().unwrap())), ["20.01", "50.5", "0.01"]);
    assert_eq!((found.status, markers(&found)), (Some(Status::Good), "100".to_owned()), "nothing is monitored");
    assert!(found.checks.is_empty() && found.remarks.is_empty());
    // First in plus direction, then in minus direction.
    let xs: Vec<_> = found.contacts.iter().map(|contact| contact.x).collect();
    assert!((xs[0] - 60.505).abs() < 1e-9 && (xs[1] - 40.495).abs() < 1e-9, "{xs:?}");
}

#[test]
fn too_large_is_scrap_inside_and_rework_outside_and_a_limit_belongs_to_its_zone() {
    let cases = [(20.0, "100"), (20.1, "100"), (20.100_001, "001"), (19.999_999, "010")];
    for (width, inside) in cases {
        let outside = ["100", "010", "001"][["100", "001", "010"].iter().position(|known| *known == inside).unwrap()];
        assert_eq!(markers(&slot("Q288=20.1 Q289=20", width)), inside, "slot {width}");
        assert_eq!(markers(&ridge("Q288=20.1 Q289=20", width)), outside, "ridge {width}");
        let side = |code: &str, first: bool| {
            let (limits, sides) = if first {
                ("Q284=20.1 Q285=20 Q282=20", (width, 40.0))
            } else {
                ("Q286=20.1 Q287=20 Q283=20", (60.0, width))
            };
            let settings = RECTANGLE
                .split_whitespace()
                .filter(|set| !limits.contains(set.split_once('=').unwrap().0))
                .collect::<Vec<_>>();
            let (cycle, inputs) = given(code, &format!("{} {limits}", settings.join(" ")));
            let feature = if code == "423" { Feature::Hole } else { Feature::Shaft };
            let walls = Walls::new(feature, [50.0, 20.0], (sides.0, Some(sides.1)));
            markers(&cycle.measure(&inputs, &mut on(walls, 1.0)).unwrap())
        };
        for first in [true, false] {
            assert_eq!(side("423", first), inside, "pocket {width} {first}");
            assert_eq!(side("424", first), outside, "boss {width} {first}");
        }
    }
}

#[test]
fn scrap_comes_before_rework_and_a_centre_out_of_position_is_scrap() {
    // The first side can be machined; on the second, material cannot be put back.
    let both = rectangle("423", "Q284=60.1 Q285=60 Q286=40.1 Q287=40", [50.0, 20.0], (59.9, 40.2));
    assert_eq!((markers(&both).as_str(), both.checks.len()), ("001", 2));
    assert_eq!(both.checks.iter().map(|check| check.status).collect::<Vec<_>>(), [Status::Rework, Status::Scrap]);
    let centre = rectangle("424", "Q284=60.1 Q285=60 Q279=0.05 Q280=0.05 Q309=1", [50.06, 20.05], (60.0, 40.0));
    assert_eq!((markers(&centre).as_str(), centre.checks.len()), ("001", 3));
    assert!(
        centre.stop.unwrap().to_string().contains("measured centre, 1st axis 50.06 mm is above its maximum 50.05 mm")
    );
    let keys = [151, 152, 154, 155, 161, 162, 164, 165];
    let found = rectangle("423", "", [50.1, 19.9], (60.02, 39.97));
    assert_eq!(keys.map(|key| of(&found, key)), ["50.1", "19.9", "60.02", "39.97", "0.1", "-0.1", "0.02", "-0.03"]);
}

#[test]
fn the_nominal_width_between_the_limits_is_what_a_tnc7_asks_for() {
    let remarked = |found: &CycleResult| {
        found.remarks.contains(&Remark::NominalWidthOutsideLimits { nominal: "20".parse().unwrap() })
    };
    assert!(remarked(&slot("Q288=20.2 Q289=20.1", 20.15)) && !remarked(&slot("Q288=20.1 Q289=20", 20.15)));
    assert!(remarked(&ridge("Q288=19.9 Q289=19.8", 19.85)));
}

#[test]
fn the_second_contact_is_shifted_and_reached_as_q301_says() {
    let ys = |settings: &str| slot(settings, 20.0).contacts.iter().map(|contact| contact.y).collect::<Vec<_>>();
    assert_eq!(ys(""), [20.0, 20.0]);
    assert_eq!(ys("Q310=-7.5"), [20.0, 12.5]);
    let highest = |settings: &str| {
        let found = slot(settings, 20.0);
        let contact = found.path.iter().position(|step| step.phase == Phase::Contact).unwrap();
        let between =
            found.path[contact..].iter().take_while(|step| step.touch != Some(2) || step.phase == Phase::PrePosition);
        between.map(|step| step.to[2]).fold(f64::NEG_INFINITY, f64::max)
    };
    assert!((highest("Q310=-7.5") + 5.0).abs() < 1e-12, "at measuring height");
    assert!((highest("Q310=-7.5 Q301=1") - 30.0).abs() < 1e-12, "over the clearance height");
    // In a wide slot the second probing begins where the nominal width predicts the wall.
    let (cycle, inputs) = given("425", "Q328=50 Q329=0 Q272=1 Q261=-5 Q260=30 Q311=80 Q320=1");
    let wide = cycle.measure(&inputs, &mut on(Walls::new(Feature::Hole, [30.0, 0.0], (80.0, None)), 2.0)).unwrap();
    let second = wide.path.iter().find(|step| step.touch == Some(2) && step.phase == Phase::Approach).unwrap();
    assert!((second.from[0] - (-10.0 + 2.0 + 3.0)).abs() < 1e-9, "{second:?}");
    assert_eq!((of(&wide, 156), of(&wide, 157)), ("80".to_owned(), "30".to_owned()));
}

#[test]
fn the_probe_keeps_clear_of_a_boss_and_a_small_pocket_is_probed_from_its_centre() {
    let boss = rectangle("424", "Q320=1", [50.0, 20.0], (60.0, 40.0));
    for step in boss.path.iter().filter(|step| step.to[2] < 0.0 && matches!(step.phase, Phase::PrePosition)) {
        let beside = [(step.to[0] - 50.0).abs() - 30.0, (step.to[1] - 20.0).abs() - 20.0];
        assert!(1.5 < beside[0].max(beside[1]), "{step:?}");
        assert!(
            step.from[2] > 0.0 || (0..2).any(|axis| (step.from[axis] - step.to[axis]).abs() < 1e-12),
            "one axis at a time"
        );
    }
    let (cycle, inputs) = given("423", "Q273=50 Q274=20 Q282=6 Q283=5 Q261=-5");
    let small =
        cycle.measure(&inputs, &mut on(Walls::new(Feature::Hole, [50.0, 20.0], (6.0, Some(5.0))), 1.0)).unwrap();
    let begins = small.path.iter().filter(|step| step.phase == Phase::Approach).map(|step| step.from);
    assert!(begins.eq([[50.0, 20.0, -5.0]; 4]));
    assert_eq!((of(&small, 154), of(&small, 155)), ("6".to_owned(), "5".to_owned()));
}

#[test]
fn what_cannot_be_probed_says_so() {
    // A ball that does not go into the slot, a wall farther away than DIST, and the points of a ridge swapped.
    let (cycle, inputs) = given("425", SLOT);
    let error = |width, ball| {
        cycle.measure(&inputs, &mut on(Walls::new(Feature::Hole, [50.0, 0.0], (width, None)), ball)).unwrap_err()
    };
    assert_eq!(error(5.0, 3.0), NoContact::InMaterial { number: 1 }.into());
    assert_eq!(error(400.0, 3.0), NoContact::OutOfReach { number: 1, longest: "50".parse().unwrap() }.into());
    let (cycle, inputs) = given("426", &RIDGE.replace("Q263=60", "Q263=40").replace("Q265=40", "Q265=60"));
    let swapped = cycle.measure(&inputs, &mut on(Walls::new(Feature::Shaft, [50.0, 0.0], (20.0, None)), 1.0));
    assert_eq!(swapped.unwrap_err(), NoContact::InMaterial { number: 1 }.into());
    let (cycle, inputs) = given("423", &format!("{RECTANGLE} Q284=1 Q285=2"));
    let said = cycle.measure(&inputs, &mut Recorded::new(Vec::new())).unwrap_err().to_string();
    assert_eq!(said, "Q285 = 2 mm is above Q284 = 1 mm: the minimum dimension is above the maximum");
}

#[test]
fn recorded_contacts_are_judged_alike() {
    let (cycle, inputs) = given("423", &format!("{RECTANGLE} Q284=60.1 Q285=60"));
    let contacts = [[80.02, 20.0, -5.0], [50.0, 40.0, -5.0], [20.0, 20.0, -5.0], [50.0, 0.0, -5.0]].map(Contact::at);
    let found = cycle.measure(&inputs, &mut Recorded::new(contacts.to_vec())).unwrap();
    assert_eq!((of(&found, 154), of(&found, 151), of(&found, 155)), ("60.02".into(), "50.01".into(), "40".into()));
}

#[test]
fn the_status_window_shows_what_was_measured() {
    let time = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
    let window = |code: &str, result: &CycleResult| {
        cycle_window(cycle_named(code).unwrap(), result, Dialogue::En, None, time).map(Result::unwrap)
    };
    assert_eq!(
        window("425", &slot("Q288=20.1 Q289=20", 20.15)).unwrap(),
        "WIDTH STATUS: SCRAP\nCHECKED: 20 (425)\nMINIMUM WIDTH:  20.0000\nMAXIMUM WIDTH:  20.1000\n\
         MEASURED WIDTH:  20.1500\nCENTRE LINE:  50.5000\n"
    );
    let limits = "Q284=60.1 Q285=60 Q286=40.1 Q287=40";
    assert_eq!(
        window("424", &rectangle("424", limits, [50.0, 20.0], (60.2, 40.0))).unwrap(),
        "RECTANGLE STATUS: REWORK\nCHECKED: 60 x 40 (424)\nLIMITS 1ST SIDE:  60.0000/  60.1000\n\
         MEASURED 1ST SIDE:  60.2000\nLIMITS 2ND SIDE:  40.0000/  40.1000\nMEASURED 2ND SIDE:  40.0000\n"
    );
    assert_eq!(window("425", &slot("", 20.0)), None);
    assert_eq!(window("423", &rectangle("423", "Q279=1", [50.0, 20.0], (60.0, 40.0))), None);
    for dialogue in Dialogue::ALL {
        for (code, result) in
            [("426", ridge("Q288=20.1 Q289=20", 20.0)), ("423", rectangle("423", limits, [50.0, 20.0], (60.0, 40.0)))]
        {
            let text = cycle_window(cycle_named(code).unwrap(), &result, dialogue, None, time).unwrap().unwrap();
            assert!(text.lines().count() <= 6 && text.lines().all(|line| line.chars().count() <= 40), "{text}");
        }
    }
}

fn heading(unit: Unit) -> Heading {
    Heading {
        date_time: Some(jiff::civil::date(2026, 3, 14).at(6, 55, 4, 0)),
        program: Some(r"TNC:\CHECK1.H".to_owned()),
        unit,
        is_simulated: false,
    }
}

#[test]
fn a_log_has_the_sections_of_its_cycle_and_reads_back_in_every_language() {
    let found = slot("Q288=20.1 Q289=20 Q281=1", 20.15);
    let cycle = cycle_named("425").unwrap();
    let log = CycleLog::of(cycle, &found, &heading(Unit::Millimetre), Dialogue::En).unwrap();
    let text = String::from_utf8(log.write(Dialogue::En).unwrap()).unwrap();
    let body: Vec<_> = text.lines().skip(7).filter(|line| !line.is_empty()).collect();
    assert_eq!(text.lines().next(), Some("Measuring log for touch probe cycle 425 Inside width measuring"));
    assert_eq!(
        body,
        [
            "Nominal values:",
            "Width:                                             20.0000",
            "Given limit values:",
            "Maximum width:                                     20.1000",
            "Minimum width:                                     20.0000",
            "Actual values:",
            "Width:                                             20.1500",
            "Position of center line:                           50.5000",
            "Deviations:",
            "Width:                                              0.1500",
            "Further measuring results:",
            "Measuring height:                                  -5.0000",
            "Measuring log end",
        ]
    );
    let limits = "Q284=60.1 Q285=60 Q286=40.1 Q287=40 Q279=0.1";
    let results = [
        ("425", found),
        ("426", ridge("Q288=20.1 Q289=20", 20.2)),
        ("423", rectangle("423", limits, [50.01, 20.0], (59.9, 40.05))),
        ("424", rectangle("424", limits, [50.01, 20.2], (60.05, 39.0))),
    ];
    for (code, result) in &results {
        let cycle = cycle_named(code).unwrap();
        for (unit, dialogue) in
            Dialogue::ALL.into_iter().flat_map(|dialogue| [(Unit::Millimetre, dialogue), (Unit::Inch, dialogue)])
        {
            let made = CycleLog::of(cycle, result, &heading(unit), dialogue).unwrap();
            let bytes = made.write(dialogue).unwrap();
            let CycleLog::Text(text) = &made else { panic!("{code}") };
            assert_eq!(log::read(&bytes), [Ok(text.printed(dialogue))], "{code} {dialogue}");
            assert_eq!(made.status(dialogue), result.status, "{code} {dialogue}");
            let found = import("x.txt", &bytes, &Sources::default(), jiff::civil::date(2000, 1, 1).at(0, 0, 0, 0));
            assert_eq!((found.errors.len(), found.records.len()), (0, 0), "{code}");
            let says = found.unjudged.iter().map(|unjudged| match &unjudged.why {
                WhyUnjudged::Size { judged, .. } => judged.status,
                other => panic!("{other:?}"),
            });
            assert_eq!(says.clone().count(), if matches!(*code, "423" | "424") { 2 } else { 1 });
            assert_eq!(says.max(), result.status, "{code} {dialogue}");
        }
    }
    // Limits of 0 mean that nothing is monitored, in the log as in the cycle.
    let free = CycleLog::of(cycle, &slot("", 21.0), &heading(Unit::Millimetre), Dialogue::De).unwrap();
    assert_eq!(free.status(Dialogue::De), None);
    let bytes = free.write(Dialogue::De).unwrap();
    let found = import("x.txt", &bytes, &Sources::default(), jiff::civil::date(2000, 1, 1).at(0, 0, 0, 0));
    assert_eq!(
        found.unjudged[0].why.to_string(),
        "not judged: the log's limits are 0, so the measured width was not monitored"
    );
}

#[test]
fn a_log_that_is_cut_off_is_never_read_as_another() {
    let log = CycleLog::of(
        cycle_named("425").unwrap(),
        &slot("Q288=20.1 Q289=20", 20.15),
        &heading(Unit::Millimetre),
        Dialogue::En,
    );
    let bytes = log.unwrap().write(Dialogue::En).unwrap();
    for end in 0..=bytes.len() {
        for read in log::read(&bytes[..end]).into_iter().flatten() {
            let [width, line] = read.figures[..] else { panic!("{end}") };
            assert_eq!((width.actual.to_string(), line.actual.to_string()), ("20.15".into(), "50.5".into()), "{end}");
        }
    }
}

#[test]
fn a_workpiece_file_has_slots_and_rectangles() {
    let file = |text: &str| Simulation::read(text).map_err(|error| error.to_string());
    let slot = file("[slot]\ncentre = [50, 0]\nwidth = 20\nangle = 90\n").unwrap();
    assert_eq!(
        slot.surface,
        Surface::Walls(Walls { angle: 90.0, ..Walls::new(Feature::Hole, [50.0, 0.0], (20.0, None)) })
    );
    assert_eq!(file(&slot.write().unwrap()).unwrap(), slot);
    let boss = file("[boss]\ncentre = [1, 2]\nlengths = [60, 40]\nsurface_scatter = 0.001\n").unwrap();
    assert_eq!(file(&boss.write().unwrap()).unwrap(), boss);
    for (text, expected) in [
        ("[slot]\ncentre = [0, 0]\nwidth = 0\n", "line 3: width = 0: at least 0.001, at most 100000"),
        ("[pocket]\ncentre = [0, 0]\nlengths = [1, -2]\n", "line 3: 2nd length = -2: at least 0.001, at most 100000"),
        ("[boss]\ncentre = [nan, 0]\nlengths = [1, 2]\n", "line 2: centre x = NaN: at least -100000, at most 100000"),
        ("[ridge]\nangle = 361\ncentre = [0, 0]\nwidth = 1\n", "line 2: angle = 361: at least -360, at most 360"),
    ] {
        assert_eq!(file(text).unwrap_err(), expected);
    }
    // Steel that is ten kelvins too warm.
    let warm = "temperature = 30\nexpansion = 10\n[slot]\ncentre = [0, 0]\nwidth = 20\n";
    let (cycle, inputs) = given("425", "Q328=0 Q329=0 Q272=1 Q261=0 Q311=20");
    let found = cycle.measure(&inputs, &mut Simulation::read(warm).unwrap().machine().unwrap()).unwrap();
    assert_eq!(of(&found, 156), "20.002");
}

/// A length on the nanometre grid, so that a result is on the grid and not between two points.
fn nanometre(mm: f64) -> f64 {
    (mm * 1e6).round() / 1e6
}

/// Places within the control's range, small offsets, lengths, and a ball.
fn places() -> impl Strategy<Value = ([f64; 2], [f64; 2], [f64; 2], f64)> {
    let place = || -99_000.0..99_000.0_f64;
    ([place(), place()], [-0.4..0.4_f64, -0.4..0.4], [20.0..80.0_f64, 20.0..80.0], 0.0..4.0_f64).prop_map(
        |(centre, off, lengths, ball)| (centre.map(nanometre), off.map(nanometre), lengths.map(nanometre), ball),
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn widths_are_exact_whatever_ball_axis_and_shift(
        (centre, off, [width, _], ball_radius) in places(),
        (is_slot, is_second, shift) in (any::<bool>(), any::<bool>(), -50.0..50.0_f64),
    ) {
        let axis = usize::from(is_second);
        let feature = if is_slot { Feature::Hole } else { Feature::Shaft };
        let angle = if is_second { 90.0 } else { 0.0 };
        let walls = Walls { angle, ..Walls::new(feature, centre, (width, None)) };
        let at = [centre[0] + off[0], centre[1] + off[1]];
        let cycle = cycle_named(if is_slot { "425" } else { "426" }).unwrap();
        let mut inputs = Inputs::new()
            .with(272, Value::Whole(if is_second { 2 } else { 1 }))
            .with(261, length(0.0))
            .with(311, length(width));
        if is_slot {
            inputs = inputs.with(328, length(at[0])).with(329, length(at[1])).with(310, length(shift));
        } else {
            let point = |sign: f64| { let mut point = at; point[axis] += sign * width / 2.0; point };
            let (first, second) = (point(1.0), point(-1.0));
            inputs = inputs.with(263, length(first[0])).with(264, length(first[1]))
                .with(265, length(second[0])).with(266, length(second[1]));
        }
        let found = cycle.measure(&inputs, &mut on(walls, ball_radius)).unwrap();
        let place = |contact: &Contact| contact.place()[axis];
        for (contact, sign) in found.contacts.iter().zip([1.0, -1.0]) {
            let error = place(contact) - (centre[axis] + sign * width / 2.0);
            prop_assert!(error.abs() < 1e-9, "{error:e}");
        }
        prop_assert_eq!(found.value(156), Some(&length(width)));
        prop_assert_eq!(found.value(157), Some(&length(centre[axis])));
    }

    #[test]
    fn rectangles_are_exact_whatever_ball_and_place(
        (centre, off, lengths, ball_radius) in places(),
        is_pocket in any::<bool>(),
    ) {
        let feature = if is_pocket { Feature::Hole } else { Feature::Shaft };
        let cycle = cycle_named(if is_pocket { "423" } else { "424" }).unwrap();
        let inputs = Inputs::new()
            .with(273, length(centre[0] + off[0]))
            .with(274, length(centre[1] + off[1]))
            .with(282, length(lengths[0]))
            .with(283, length(lengths[1]))
            .with(261, length(0.0));
        let walls = Walls::new(feature, centre, (lengths[0], Some(lengths[1])));
        let found = cycle.measure(&inputs, &mut on(walls, ball_radius)).unwrap();
        for (number, axis, sign) in [(0, 0, 1.0), (1, 1, 1.0), (2, 0, -1.0), (3, 1, -1.0)] {
            let error = found.contacts[number].place()[axis] - (centre[axis] + sign * lengths[axis] / 2.0);
            prop_assert!(error.abs() < 1e-9, "{error:e}");
        }
        for (key, expected) in [(151, centre[0]), (152, centre[1]), (154, lengths[0]), (155, lengths[1])] {
            prop_assert_eq!(found.value(key), Some(&length(expected)), "Q{}", key);
        }
    }

    /// A turned slot is measured along the axis: longer by the angle, and the ball touches beside the axis.
    #[test]
    fn a_turned_slot_is_not_corrected(angle in -20.0..20.0_f64, width in 20.0..40.0_f64, ball_radius in 0.0..3.0_f64) {
        let (cycle, inputs) = given("425", "Q328=0 Q329=0 Q272=1 Q261=0 Q311=20");
        let walls = Walls { angle, ..Walls::new(Feature::Hole, [0.0, 0.0], (width, None)) };
        let found = cycle.measure(&inputs, &mut on(walls, ball_radius)).unwrap();
        let cos = angle.to_radians().cos();
        let expected = (width - 2.0 * ball_radius) / cos + 2.0 * ball_radius;
        let Some(Value::Length(measured)) = found.value(156) else { panic!() };
        prop_assert!((measured.to_mm_f64() - expected).abs() < 1e-6, "{measured} {expected}");
    }
}
