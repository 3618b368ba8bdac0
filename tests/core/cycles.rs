//! Cycles 421 and 422 on the simulated workpiece and on recorded contacts.

use fitcheck::length::Length;
use fitcheck::message::Say as _;
use fitcheck::probing::circle::evaluate;
use fitcheck::probing::cycle::{Angle, CircleFound, Cycle, CycleError, CycleResult, Inputs, Move, Phase, Value};
use fitcheck::probing::cycles::{CYCLES, cycle};
use fitcheck::probing::simulated::{Lobes, Machine, Probe, Workpiece};
use fitcheck::probing::{Contact, NoContact, Prober, Recorded, Touch};
use fitcheck::tolerance::Feature;
use fitcheck::verdict::Status;
use fitcheck::words::{Language, Words};
use proptest::prelude::*;

const STILL: Probe = scattering(0.0);

const fn scattering(trigger_scatter: f64) -> Probe {
    Probe { trigger_scatter, ..Probe::STILL }
}

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn hole() -> &'static Cycle {
    cycle(421).unwrap()
}

/// The text of an error, the same in `Display` and in English but for the true minus sign, and different in Dutch.
fn told(error: &CycleError) -> String {
    let english = error.to_string();
    assert_eq!(Words::new(Language::En).told(error).replace('\u{2212}', "-"), english);
    assert_ne!(Words::new(Language::Nl).told(error), error.message().id);
    english
}

/// Inputs of a 25 mm feature around (50, 20), changed by text: `Q247=60 Q423=3`.
fn inputs(cycle: &Cycle, changes: &str) -> Result<Inputs, String> {
    let all = format!("Q273=50 Q274=20 Q262=25 Q261=-5 Q260=20 {changes}");
    all.split_whitespace().try_fold(Inputs::new(), |inputs, change| {
        let (name, text) = change.split_once('=').unwrap();
        cycle.set(inputs, name, text).map_err(|error| told(&error))
    })
}

fn at(feature: Feature, diameter: f64) -> Workpiece {
    Workpiece::round(feature, [50.0, 20.0], diameter)
}

fn machine(workpiece: Workpiece) -> Machine {
    Machine::new(workpiece, STILL, 1).unwrap()
}

fn run(cycle: &Cycle, changes: &str, prober: &mut dyn Prober) -> Result<CycleResult, String> {
    cycle.measure(&inputs(cycle, changes)?, prober).map_err(|error| told(&error))
}

/// The circle that 421 and 422 find.
fn round(result: &CycleResult) -> &CircleFound {
    result.circle.as_ref().unwrap()
}

/// The results as people read them.
fn results(result: &CycleResult) -> String {
    result.results.iter().map(|found| format!("{}={}", found.called(), found.value)).collect::<Vec<_>>().join(" ")
}

#[track_caller]
fn check(number: u16, changes: &str, diameter: f64, expected: &str) {
    let feature = if number == 421 { Feature::Hole } else { Feature::Shaft };
    let mut prober = machine(at(feature, diameter));
    let said = run(cycle(number).unwrap(), changes, &mut prober).map_or_else(|error| error, |found| results(&found));
    assert_eq!(said, expected);
}

#[test]
fn a_hole_too_large_is_scrap_and_too_small_is_rework() {
    let place = "Q151=50 Q152=20";
    let limits = "Q275=25.021 Q276=25";
    let good = "Q180=1 Q181=0 Q182=0";
    check(421, limits, 25.012, &format!("{place} Q153=25.012 Q161=0 Q162=0 Q163=0.012 {good}"));
    check(421, limits, 25.0, &format!("{place} Q153=25 Q161=0 Q162=0 Q163=0 {good}"));
    check(421, limits, 25.021, &format!("{place} Q153=25.021 Q161=0 Q162=0 Q163=0.021 {good}"));
    let scrap = "Q180=0 Q181=0 Q182=1";
    check(421, limits, 25.021_001, &format!("{place} Q153=25.021001 Q161=0 Q162=0 Q163=0.021001 {scrap}"));
    let rework = "Q180=0 Q181=1 Q182=0";
    check(421, limits, 24.999_999, &format!("{place} Q153=24.999999 Q161=0 Q162=0 Q163=-0.000001 {rework}"));
    // Limits of 0: nothing is monitored, and the markers say good.
    check(421, "", 24.5, &format!("{place} Q153=24.5 Q161=0 Q162=0 Q163=-0.5 {good}"));
}

#[test]
fn a_shaft_too_large_is_rework_and_too_small_is_scrap() {
    let limits = "Q277=24.993 Q278=24.980";
    let tail = |diameter: &str, deviation: &str, markers: &str| {
        format!("Q151=50 Q152=20 Q153={diameter} Q161=0 Q162=0 Q163={deviation} {markers}")
    };
    check(422, limits, 24.985, &tail("24.985", "-0.015", "Q180=1 Q181=0 Q182=0"));
    check(422, limits, 24.993_001, &tail("24.993001", "-0.006999", "Q180=0 Q181=1 Q182=0"));
    check(422, limits, 24.979_999, &tail("24.979999", "-0.020001", "Q180=0 Q181=0 Q182=1"));
}

#[test]
fn a_centre_out_of_position_sets_the_scrap_marker_and_stays_a_cause_of_its_own() {
    let mut shifted = at(Feature::Hole, 24.99);
    shifted.centre = [50.1, 19.95];
    let mut prober = machine(shifted);
    let found = run(hole(), "Q275=25.021 Q276=25 Q279=0.1 Q280=0.049999", &mut prober).unwrap();
    assert_eq!(results(&found), "Q151=50.1 Q152=19.95 Q153=24.99 Q161=0.1 Q162=-0.05 Q163=-0.01 Q180=0 Q181=0 Q182=1");
    assert_eq!(round(&found).position.axes.map(|axis| axis.is_out()), [false, true]);
    assert_eq!(found.status, Some(Status::Scrap));
}

#[test]
fn inputs_out_of_range_are_refused_with_the_declared_range() {
    let refused = |changes: &str, expected: &str| check(421, changes, 25.0, expected);
    refused("Q247=3", "Q247 STEPPING ANGLE = 3°: at least 5° in size, at most 120°");
    refused("Q247=4.9999", "Q247 STEPPING ANGLE = 4.9999°: at least 5° in size, at most 120°");
    refused("Q247=-120.0001", "Q247 STEPPING ANGLE = -120.0001°: at least 5° in size, at most 120°");
    refused("Q247=0", "Q247 STEPPING ANGLE = 0°: at least 5° in size, at most 120°");
    refused("Q247=NaN", "Q247 STEPPING ANGLE: NaN is not a number");
    refused("Q325=360.0001", "Q325 STARTING ANGLE = 360.0001°: at most 360° either way");
    refused("Q320=-0.1", "Q320 SET-UP CLEARANCE = -0.1 mm: at least 0 mm, at most 99999.9999 mm");
    refused("Q262=100000", "Q262 NOMINAL DIAMETER = 100000 mm: at least 0 mm, at most 99999.9999 mm");
    refused("Q262=0", "Q262 NOMINAL DIAMETER = 0 mm: a circle needs a diameter above 0");
    refused("Q262=NaN", "Q262 NOMINAL DIAMETER: NaN is not a number");
    refused("Q273=-100000", "Q273 CENTER IN 1ST AXIS = -100000 mm: at least -99999.9999 mm, at most 99999.9999 mm");
    refused("Q301=2", "Q301 MOVE TO CLEARANCE = 2: expected one of 0, 1");
    refused("Q423=5", "Q423 NO. OF MEAS. POINTS = 5: expected one of 3, 4");
    refused("Q423=3.5", "Q423 NO. OF MEAS. POINTS = 3.5: expected one of 3, 4");
    refused("Q281=yes", "Q281 MEASURING LOG: yes is not a number");
    refused(
        "Q330=-1",
        "Q330 TOOL NUMBER = -1: a tool number from 0 to 99999.9, or a tool name of at most 255 characters",
    );
    refused(
        "Q275=25 Q276=25.021",
        "Q276 = 25.021 mm is above Q275 = 25 mm: the minimum dimension is above the maximum",
    );
}

#[test]
fn missing_and_unknown_inputs_are_named() {
    let mut prober = Recorded::new(Vec::new());
    let mut said = |inputs: &Inputs| told(&hole().measure(inputs, &mut prober).unwrap_err());
    assert_eq!(said(&Inputs::new()), "Q273 CENTER IN 1ST AXIS is missing");
    let unknown = inputs(hole(), "").unwrap().with(277, Value::Length(mm("25")));
    assert!(said(&unknown).starts_with("cycle 421 has no parameter Q277: its parameters are Q273, Q274, Q262, "));
    let wrong_kind = inputs(hole(), "").unwrap().with(247, Value::Length(mm("90")));
    assert_eq!(said(&wrong_kind), "Q247 STEPPING ANGLE = 90 mm: at least 5° in size, at most 120°");
}

#[test]
fn every_parameter_is_declared_once_with_a_default_in_its_range() {
    for cycle in CYCLES {
        for (index, parameter) in cycle.parameters.iter().enumerate() {
            assert!(
                cycle.parameters[index + 1..].iter().all(|other| other.key != parameter.key),
                "{} twice",
                parameter.key
            );
            assert!(parameter.default_value().is_none_or(|value| parameter.allows(&value)), "{}", parameter.key);
        }
    }
}

#[test]
fn three_contacts_without_a_step_lie_120_degrees_apart() {
    let angles = |changes: &str| {
        let mut prober = machine(at(Feature::Hole, 25.0));
        let found = run(hole(), changes, &mut prober).unwrap();
        let angle = |contact: &Contact| (contact.y - 20.0).atan2(contact.x - 50.0).to_degrees().rem_euclid(360.0);
        found.contacts.iter().map(|contact| format!("{:.0}", angle(contact))).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(angles(""), "0 90 180 270");
    assert_eq!(angles("Q325=30 Q247=-90"), "30 300 210 120");
    assert_eq!(angles("Q423=3"), "0 120 240");
    assert_eq!(angles("Q423=3 Q247=60"), "0 60 120");
    assert_eq!(angles("Q423=3 Q247=90"), "0 90 180");
}

#[test]
fn touches_start_on_the_free_side() {
    struct Seen(Vec<String>);
    impl Prober for Seen {
        fn touch(&mut self, touch: &Touch) -> Result<Contact, NoContact> {
            let ([x, y, z], [along_x, along_y, along_z]) = (touch.from, touch.direction);
            // Adding zero removes the sign of a zero.
            let way = [along_x, along_y, along_z].map(|part| part + 0.0);
            self.0.push(format!("from {x} {y} {z} along {way:?}"));
            Ok(Contact { x: x + along_x, y: y + along_y, z })
        }
    }
    let seen = |number, changes: &str| {
        let mut prober = Seen(Vec::new());
        let _fitted = run(cycle(number).unwrap(), changes, &mut prober);
        prober.0
    };
    // Hole: 12.5 - 3 - 2 from the centre, outwards, never from behind the centre.
    assert_eq!(seen(421, "Q320=3")[0], "from 57.5 20 -5 along [1.0, 0.0, 0.0]");
    assert_eq!(seen(421, "Q320=3")[1], "from 50 27.5 -5 along [0.0, 1.0, 0.0]");
    assert_eq!(seen(421, "Q320=30")[0], "from 50 20 -5 along [1.0, 0.0, 0.0]");
    // Stud: 12.5 + 3 + 2 from the centre, inwards.
    assert_eq!(seen(422, "Q320=3")[2], "from 32.5 20 -5 along [1.0, 0.0, 0.0]");
}

#[test]
fn a_touch_that_meets_nothing_stops_the_cycle() {
    let mut away = at(Feature::Shaft, 20.0);
    away.centre = [39.0, 20.0];
    let mut prober = machine(away);
    assert_eq!(
        run(cycle(422).unwrap(), "", &mut prober).unwrap_err(),
        "contact 2: the probe met nothing on the probing path"
    );
    check(421, "", 19.0, "contact 1: the probing path begins inside the material");
    let mut recorded = Recorded::new(vec![Contact { x: 62.5, y: 20.0, z: -5.0 }; 3]);
    assert_eq!(run(hole(), "", &mut recorded).unwrap_err(), "contact 4: the file has only 3 contacts");
    let mut same = Recorded::new(vec![Contact { x: 62.5, y: 20.0, z: -5.0 }; 4]);
    assert_eq!(
        run(hole(), "", &mut same).unwrap_err(),
        "contacts 1 and 2 coincide at x = 62.5, y = 20: a circle needs 3 different points"
    );
}

#[test]
fn recorded_contacts_go_through_a_cycle_as_simulated_ones_do() {
    let mut prober = Machine::new(at(Feature::Hole, 25.012), scattering(0.001), 5).unwrap();
    let found = run(hole(), "Q275=25.021 Q276=25", &mut prober).unwrap();
    let mut recorded = Recorded::new(found.contacts.clone());
    assert_eq!(run(hole(), "Q275=25.021 Q276=25", &mut recorded).unwrap(), found);
}

/// How a cycle is run: nominal diameter and centre, first angle, step, number of contacts.
#[derive(Debug, Clone, Copy)]
struct Setup {
    nominal: Length,
    centre: [Length; 2],
    first: Angle,
    step: Option<Angle>,
    contacts: i64,
}

impl Setup {
    fn new(nominal: &str) -> Self {
        let zero = Angle::from_degrees(0);
        Self { nominal: mm(nominal), centre: [Length::ZERO; 2], first: zero, step: None, contacts: 4 }
    }
}

/// Runs the cycle of a workpiece's feature.
fn measured(workpiece: &Workpiece, probe: Probe, seed: u64, setup: &Setup) -> CycleResult {
    let number = if workpiece.feature == Feature::Hole { 421 } else { 422 };
    let [x, y] = setup.centre.map(Value::Length);
    let inputs = Inputs::new()
        .with(273, x)
        .with(274, y)
        .with(262, Value::Length(setup.nominal))
        .with(325, Value::Angle(setup.first))
        .with(423, Value::Whole(setup.contacts));
    let inputs = setup.step.map_or_else(|| inputs.clone(), |step| inputs.clone().with(247, Value::Angle(step)));
    cycle(number).unwrap().measure(&inputs, &mut Machine::new(*workpiece, probe, seed).unwrap()).unwrap()
}

/// Degrees exactly, ten-thousandths at most.
fn degrees(ten_thousandths: i64) -> Angle {
    let sign = if ten_thousandths < 0 { "-" } else { "" };
    let size = ten_thousandths.abs();
    format!("{sign}{}.{:04}", size / 10_000, size % 10_000).parse().unwrap()
}

#[test]
fn an_oval_shows_as_the_difference_of_two_diameters() {
    for feature in [Feature::Hole, Feature::Shaft] {
        for (angle, factor) in [(0.0, 4.0), (22.5, 8.0_f64.sqrt()), (45.0, 0.0)] {
            let ovality = Lobes { count: 2, amplitude: 0.01, angle };
            let workpiece = Workpiece { ovality, ..Workpiece::round(feature, [0.0, 0.0], 25.0) };
            let result = measured(&workpiece, STILL, 0, &Setup::new("25"));
            let sizes = evaluate(&result.contacts).unwrap().two_point;
            let difference = sizes[0].size - sizes[1].size;
            assert!((difference - factor * 0.01).abs() < 1e-12, "{angle}: {difference}");
            assert_eq!(round(&result).diameter, mm("25"));
        }
    }
}

#[test]
fn three_lobes_are_invisible_to_three_contacts() {
    for (angle, diameter) in [(0.0, "25.02"), (60.0, "24.98"), (30.0, "25")] {
        let lobes = Lobes { count: 3, amplitude: 0.01, angle };
        let workpiece = Workpiece { lobes, ..Workpiece::round(Feature::Hole, [0.0, 0.0], 25.0) };
        let setup = Setup { contacts: 3, ..Setup::new("25") };
        let result = measured(&workpiece, STILL, 0, &setup);
        assert_eq!(round(&result).diameter, mm(diameter));
        assert!(evaluate(&result.contacts).unwrap().form() < 1e-12);
    }
}

#[test]
fn the_same_seed_gives_the_same_contacts_and_another_seed_others() {
    let workpiece = Workpiece { surface_scatter: 0.002, ..Workpiece::round(Feature::Hole, [0.0, 0.0], 25.0) };
    let probe = scattering(0.001);
    let contacts = |seed| measured(&workpiece, probe, seed, &Setup::new("25")).contacts;
    assert_eq!(contacts(7), contacts(7));
    assert_ne!(contacts(7), contacts(8));
    // Each contact has its own stream: three contacts begin as four do.
    let three = Setup { contacts: 3, step: Some(Angle::from_degrees(90)), ..Setup::new("25") };
    assert_eq!(measured(&workpiece, probe, 7, &three).contacts, contacts(7)[..3]);
}

#[test]
fn scatter_has_the_size_that_was_asked_for() {
    // Diameters of four even contacts scatter by 2 s / √4 = s; one standard deviation over many seeds.
    let workpiece = Workpiece { surface_scatter: 0.003, ..Workpiece::round(Feature::Shaft, [0.0, 0.0], 25.0) };
    let probe = scattering(0.004);
    let diameters: Vec<f64> =
        (0..2000).map(|seed| round(&measured(&workpiece, probe, seed, &Setup::new("25"))).circle.diameter).collect();
    let mean = diameters.iter().sum::<f64>() / 2000.0;
    let variance = diameters.iter().map(|diameter| (diameter - mean).powi(2)).sum::<f64>() / 1999.0;
    assert!((mean - 25.0).abs() < 4.0 * 0.005 / 2000.0_f64.sqrt(), "{mean}");
    assert!((variance.sqrt() / 0.005 - 1.0).abs() < 4.0 / 4000.0_f64.sqrt(), "{}", variance.sqrt());
}

/// The length that a float stands for, to the nanometre.
fn length(mm: f64) -> Length {
    Length::from_mm_f64(mm).unwrap()
}

proptest! {
    #[test]
    fn an_exact_workpiece_is_measured_exactly(
        is_hole in any::<bool>(),
        centre in [-500.0..500.0_f64, -500.0..500.0],
        offset in [-0.5..0.5_f64, -0.5..0.5],
        diameter in 3.0..300.0_f64,
        first in -3_600_000..3_600_000_i64,
        step in prop_oneof![300_000..1_200_000_i64, -1_200_000..-300_000_i64],
        contacts in 3_i64..=4,
    ) {
        let feature = if is_hole { Feature::Hole } else { Feature::Shaft };
        let workpiece = Workpiece { centre, ..Workpiece::round(feature, [0.0, 0.0], diameter) };
        let setup = Setup {
            centre: [length(centre[0] + offset[0]), length(centre[1] + offset[1])],
            first: degrees(first),
            step: Some(degrees(step)),
            contacts,
            nominal: length(diameter),
        };
        let result = measured(&workpiece, STILL, 0, &setup);
        let circle = round(&result).circle;
        prop_assert!((circle.diameter - diameter).abs() < 1e-9, "{circle:?}");
        prop_assert!((circle.x - centre[0]).abs() < 1e-9 && (circle.y - centre[1]).abs() < 1e-9, "{circle:?}");
    }

    #[test]
    fn first_angle_and_sense_of_the_step_change_nothing(first in -3_600_000..3_600_000_i64, offset in -0.1..0.1_f64) {
        let workpiece = Workpiece { centre: [offset, 0.05], ..Workpiece::round(Feature::Hole, [0.0, 0.0], 25.012) };
        for (first, step) in [(first, 90), (first, -90), (-first, 90)] {
            let setup = Setup {
                first: degrees(first),
                step: Some(Angle::from_degrees(step)),
                ..Setup::new("25")
            };
            let result = measured(&workpiece, STILL, 0, &setup);
            prop_assert_eq!(round(&result).diameter, mm("25.012"));
            prop_assert!((round(&result).circle.diameter - 25.012).abs() < 1e-12);
        }
    }

    #[test]
    fn a_contact_lies_on_the_contour(
        is_hole in any::<bool>(),
        amplitude in 0.0..0.3_f64,
        lobes in (2_u32..=100, 0.0..0.5_f64, 0.0..360.0_f64),
        offset in [-0.5..0.5_f64, -0.5..0.5],
        first in 0..3_600_000_i64,
    ) {
        let (count, lobe, angle) = lobes;
        let feature = if is_hole { Feature::Hole } else { Feature::Shaft };
        let workpiece = Workpiece {
            centre: offset,
            ovality: Lobes { count: 2, amplitude, angle: 10.0 },
            lobes: Lobes { count, amplitude: lobe, angle },
            ..Workpiece::round(feature, [0.0, 0.0], 20.0)
        };
        let setup = Setup {
            first: degrees(first),
            ..Setup::new("20")
        };
        for contact in measured(&workpiece, STILL, 0, &setup).contacts {
            let (x, y) = (contact.x - offset[0], contact.y - offset[1]);
            let towards = y.atan2(x);
            let radius = 10.0
                + amplitude * (2.0 * (towards - 10.0_f64.to_radians())).cos()
                + lobe * (f64::from(count) * (towards - angle.to_radians())).cos();
            prop_assert!((x.hypot(y) - radius).abs() < 1e-12);
        }
    }
}

#[test]
fn an_angle_is_read_in_degrees_and_never_in_a_unit_of_length() {
    let read = |text: &str| text.parse::<Angle>().map(Angle::ten_thousandths).map_err(|error| error.to_string());
    assert_eq!(read(" -22,5° "), Ok(-225_000));
    assert_eq!(read("0.0001 °"), Ok(1));
    for text in ["45 mm", "90 µm", "90um", "90°°"] {
        assert_eq!(read(text), Err(format!("{text} is not a number")));
    }
}

/// The moves of a run as people would list them: the phase's first letter, an arc marked.
fn moves(changes: &str) -> String {
    let mut prober = machine(at(Feature::Hole, 25.0));
    let found = run(hole(), changes, &mut prober).unwrap();
    let letter = |step: &Move| match (step.phase, step.about) {
        (Phase::PrePosition, Some(_)) => "arc",
        (phase, _) => phase.word(),
    };
    found.path.iter().map(|step| format!("{} {:.0}", letter(step), step.to[2])).collect::<Vec<_>>().join(", ")
}

#[test]
fn the_way_between_touches_is_that_of_q301_and_q365() {
    // Ends of the moves in the probe axis; measuring height -5, clearance height 20.
    let touch = "approach -5, contact -5, retract -5";
    let (down, up) = ("pre-position -5", "leave 20");
    assert_eq!(moves("Q423=3"), format!("{down}, {touch}, arc -5, {touch}, arc -5, {touch}, {up}"));
    assert_eq!(moves("Q423=3 Q365=0"), format!("{down}, {touch}, {down}, {touch}, {down}, {touch}, {up}"));
    let over = "pre-position 20, pre-position 20, pre-position -5";
    assert_eq!(moves("Q423=3 Q301=1"), format!("{down}, {touch}, {over}, {touch}, {over}, {touch}, {up}"));
}

#[test]
fn a_touch_starts_the_ball_s_radius_farther_away() {
    let start = |feature, ball_radius| {
        let number = if feature == Feature::Hole { 421 } else { 422 };
        let probe = Probe { ball_radius, ..Probe::STILL };
        let mut prober = Machine::new(at(feature, 25.0), probe, 1).unwrap();
        run(cycle(number).unwrap(), "Q320=1", &mut prober).unwrap().path[0].to[0]
    };
    assert!((start(Feature::Hole, 2.0) - (50.0 + 12.5 - 3.0 - 2.0)).abs() < 1e-12);
    assert!((start(Feature::Shaft, 2.0) - (50.0 + 12.5 + 3.0 + 2.0)).abs() < 1e-12);
    // A ball that does not fit is in the material before it moves.
    let mut prober = Machine::new(at(Feature::Hole, 25.0), Probe { ball_radius: 13.0, ..Probe::STILL }, 1).unwrap();
    assert_eq!(run(hole(), "", &mut prober).unwrap_err(), "contact 1: the probing path begins inside the material");
}
