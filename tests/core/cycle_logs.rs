//! From a cycle to its log and back: the same figures, the same verdict, in every language.

use fitcheck::control::cycle_log::{CycleLog, Heading, OtherVerdict};
use fitcheck::control::log;
use fitcheck::control::point_log;
use fitcheck::exchange::{Imported, WhyUnjudged, import};
use fitcheck::length::{Length, Unit};
use fitcheck::probing::cycle::{Cycle, CycleResult, Inputs, Key, Value};
use fitcheck::probing::cycles::{CYCLES, cycle_named};
use fitcheck::probing::simulated::{Face, FreePoint, Machine, Probe, Surface, Workpiece};
use fitcheck::probing::{Recorded, cycle::Plane};
use fitcheck::tolerance::{Deviations, Feature, Sources};
use fitcheck::verdict::{PositionVerdict, Status};
use fitcheck::words::Dialogue;
use jiff::civil::{DateTime, date};
use proptest::prelude::*;

fn when() -> DateTime {
    date(2026, 3, 14).at(6, 55, 4, 0)
}

fn heading(unit: Unit) -> Heading {
    Heading { date_time: Some(when()), program: Some(r"TNC:\GEH35712\CHECK1.H".to_owned()), unit, is_simulated: false }
}

fn nm(length: i64) -> Value {
    Value::Length(Length::from_nanometres(length).unwrap())
}

/// Nanometres as millimetres.
fn mm(nm: i64) -> f64 {
    Length::from_nanometres(nm).unwrap().to_mm_f64()
}

fn still(surface: Surface) -> Machine {
    Machine::with(surface, Probe::STILL, 1).unwrap()
}

/// What the program's own import reads from a log.
fn imported(file: &str, bytes: &[u8]) -> Imported {
    import(file, bytes, &Sources::default(), date(2000, 1, 1).at(0, 0, 0, 0))
}

/// The verdict of the import, with a centre out of position; `None` where nothing is judged.
fn import_says(file: &str, bytes: &[u8]) -> Option<Status> {
    let found = imported(file, bytes);
    assert_eq!(found.errors, []);
    if let [record] = found.records.as_slice() {
        return Some(record.verdict.status());
    }
    let [unjudged] = found.unjudged.as_slice() else { panic!("{found:?}") };
    match &unjudged.why {
        WhyUnjudged::Coordinate(found) | WhyUnjudged::Point(found) => Some(found.status),
        WhyUnjudged::NoLimits { .. } => {
            let position = unjudged.position.filter(PositionVerdict::is_monitored)?;
            Some(if position.is_out() { Status::Scrap } else { Status::Good })
        }
        _ => None,
    }
}

/// Writes the log, reads it back in two ways, and returns what it says.
fn there_and_back(cycle: &Cycle, result: &CycleResult, unit: Unit, language: Dialogue) -> (CycleLog, Option<Status>) {
    let log = CycleLog::of(cycle, result, &heading(unit), language).unwrap();
    let bytes = log.write(language).unwrap();
    let (file, read) = match &log {
        CycleLog::Text(text) => {
            let read = log::read(&bytes);
            let printed = text.printed(language);
            assert_eq!(read, [Ok(printed.clone())]);
            assert_eq!(printed.date_time(), Some(when()));
            ("x.txt", CycleLog::Text(printed))
        }
        CycleLog::Page(page) => {
            let read: Vec<_> = point_log::read(&bytes).into_iter().map(|answer| answer.unwrap().1).collect();
            assert_eq!(read, std::slice::from_ref(page));
            ("x.html", log.clone())
        }
    };
    let says = import_says(file, &bytes);
    assert_eq!(says, log.status(language), "{log:?}");
    (read, says)
}

/// A result of 421 or 422 on an exact workpiece; all in nanometres.
fn circle(
    is_hole: bool,
    nominal: [i64; 3],
    actual: [i64; 3],
    limits: Option<[i64; 2]>,
    tolerances: [i64; 2],
) -> (&'static Cycle, CycleResult) {
    let (code, feature) = if is_hole { ("421", Feature::Hole) } else { ("422", Feature::Shaft) };
    let cycle = cycle_named(code).unwrap();
    let (maximum, minimum) = if is_hole { (275, 276) } else { (277, 278) };
    let [max, min] = limits.unwrap_or_default();
    let inputs = [(273, nominal[0]), (274, nominal[1]), (262, nominal[2]), (261, -3_000_000), (maximum, max)]
        .into_iter()
        .chain([(minimum, min), (279, tolerances[0]), (280, tolerances[1])])
        .fold(Inputs::new(), |inputs, (key, value)| inputs.with(key, nm(value)));
    // Four contacts on the circle, so that the rounding of a simulated path does not interfere.
    let [x, y, diameter] = actual.map(mm);
    let part = Workpiece::round(feature, [x, y], diameter);
    let result = cycle.measure(&inputs, &mut still(Surface::Round(part, Plane::Xy))).unwrap();
    let found = result.circle.as_ref().unwrap();
    let measured = [found.centre[0], found.centre[1], found.diameter].map(Length::nanometres);
    assert_eq!(measured, actual);
    (cycle, result)
}

fn coordinate(actual: i64, limits: [i64; 2]) -> (&'static Cycle, CycleResult) {
    let cycle = cycle_named("427").unwrap();
    let inputs = [(263, 35_000_000), (264, 45_000_000), (261, actual), (288, limits[0]), (289, limits[1])]
        .into_iter()
        .fold(Inputs::new(), |inputs, (key, value)| inputs.with(key, nm(value)));
    let inputs = inputs.with(272, Value::Whole(3)).with(267, Value::Whole(-1));
    let face = Face { point: [0.0, 0.0, mm(actual)], normal: [0.0, 0.0, 1.0], wave: None, surface_scatter: 0.0 };
    let result = cycle.measure(&inputs, &mut still(Surface::Face(face))).unwrap();
    assert_eq!(result.value(160), Some(&nm(actual)));
    (cycle, result)
}

fn point(normal: [f64; 3], deviation: f64, band: Option<[i64; 2]>) -> (&'static Cycle, CycleResult) {
    let cycle = cycle_named("444").unwrap();
    let at = [(263, 10_000_000), (264, -20_000_000), (294, 5_000_000)];
    let inputs = at.into_iter().fold(Inputs::new(), |inputs, (key, value)| inputs.with(key, nm(value)));
    let inputs = [581, 582, 583]
        .into_iter()
        .zip(normal)
        .fold(inputs, |inputs, (key, part): (u16, f64)| inputs.with(key, Value::Number(part)));
    let length = |nm| Length::from_nanometres(nm).unwrap();
    let band = band.map(|[upper, lower]| Deviations::new(length(upper), length(lower)).unwrap());
    let inputs = inputs.with(Key::Qs(400), Value::Band(band));
    let surface = FreePoint { point: [10.0, -20.0, 5.0], normal, deviation, radius: None, surface_scatter: 0.0 };
    (cycle, cycle.measure(&inputs, &mut still(Surface::Point(surface))).unwrap())
}

#[test]
fn the_published_measurement_of_cycle_421_is_written_as_published() {
    let (cycle, result) = circle(
        true,
        [50_000_000, 65_000_000, 12_000_000],
        [50_081_000, 64_953_000, 12_025_900],
        Some([12_045_000, 12_000_000]),
        [100_000, 100_000],
    );
    let log = CycleLog::of(cycle, &result, &heading(Unit::Millimetre), Dialogue::En).unwrap();
    let text = String::from_utf8(log.write(Dialogue::En).unwrap()).unwrap();
    let expected = [
        "Measuring log for touch probe cycle 421 Hole measuring",
        "",
        "Date: 14-03-2026",
        "Time: 6:55:04",
        r"Measuring program: TNC:\GEH35712\CHECK1.H",
        "Type of dimension (0 = MM / 1 = INCH): 0",
        "",
        "Nominal values:",
        "Center in reference axis:                          50.0000",
        "Center in minor axis:                              65.0000",
        "Diameter:                                          12.0000",
        "",
        "Given limit values:",
        "Maximum limit for center in reference axis:        50.1000",
        "Minimum limit for center in reference axis:        49.9000",
        "Maximum limit for center in minor axis:            65.1000",
        "Minimum limit for center in minor axis:            64.9000",
        "Maximum dimension for hole:                        12.0450",
        "Minimum dimension for hole:                        12.0000",
        "",
        "Actual values:",
        "Center in reference axis:                          50.0810",
        "Center in minor axis:                              64.9530",
        "Diameter:                                          12.0259",
        "",
        "Deviations:",
        "Center in reference axis:                           0.0810",
        "Center in minor axis:                              -0.0470",
        "Diameter:                                           0.0259",
        "",
        "Further measuring results:",
        "Measuring height:                                  -3.0000",
        "",
        "Measuring log end",
        "",
    ];
    assert_eq!(text.split("\r\n").collect::<Vec<_>>(), expected);
    assert_eq!((result.status, log.status(Dialogue::En)), (Some(Status::Good), Some(Status::Good)));
}

#[test]
fn what_was_not_monitored_is_not_judged_when_it_is_read_back() {
    for language in Dialogue::ALL {
        let (cycle, result) = circle(true, [0, 0, 25_000_000], [0, 0, 24_500_000], None, [0, 0]);
        assert_eq!(
            (result.status, there_and_back(cycle, &result, Unit::Millimetre, language).1),
            (Some(Status::Good), None)
        );
        // A monitored centre is judged although the diameter is not.
        let (cycle, result) = circle(false, [0, 0, 25_000_000], [100_001, 0, 24_500_000], None, [100_000, 0]);
        assert_eq!(result.status, Some(Status::Scrap));
        // The page of figures has four decimals: it cannot show a nanometre, so the log reads as good.
        let (log, says) = there_and_back(cycle, &result, Unit::Millimetre, language);
        assert_eq!((log.status(language), says), (Some(Status::Good), Some(Status::Good)));
        let (cycle, result) = coordinate(7_000_000, [0, 0]);
        assert_eq!(
            (result.status, there_and_back(cycle, &result, Unit::Millimetre, language).1),
            (Some(Status::Good), None)
        );
        let (cycle, result) = point([0.0, 0.0, 1.0], 1.5, None);
        assert_eq!((result.status, there_and_back(cycle, &result, Unit::Millimetre, language).1), (None, None));
    }
}

#[test]
fn a_value_beyond_a_limit_by_less_than_the_log_prints_is_named() {
    let other = |actual: i64, unit| {
        let (cycle, result) = circle(true, [0, 0, 25_000_000], [0, 0, actual], Some([25_021_000, 25_000_000]), [0, 0]);
        let log = CycleLog::of(cycle, &result, &heading(unit), Dialogue::En).unwrap();
        log.other_verdict(&result, Dialogue::En).map(|other| other.to_string())
    };
    let says = |unit| Some(format!("the log's values, rounded to 0.0001 {unit}, give GOOD where the cycle gave SCRAP"));
    assert_eq!(other(25_021_000, Unit::Millimetre), None);
    assert_eq!(other(25_021_001, Unit::Millimetre), says("mm"));
    assert_eq!(other(25_021_049, Unit::Millimetre), says("mm"));
    assert_eq!(other(25_021_050, Unit::Millimetre), None);
    assert_eq!(other(25_021_500, Unit::Inch), says("inch"));
    // On the other side the same holds for rework.
    assert_eq!(
        other(24_999_999, Unit::Millimetre).unwrap(),
        "the log's values, rounded to 0.0001 mm, give GOOD where the cycle gave REWORK"
    );
    // The page of cycle 444 keeps every nanometre.
    let (cycle, result) = point([0.0, 0.0, 1.0], 0.400_001, Some([400_000, -100_000]));
    for (unit, language) in [(Unit::Millimetre, Dialogue::En), (Unit::Inch, Dialogue::It)] {
        let (log, says) = there_and_back(cycle, &result, unit, language);
        assert_eq!((says, log.other_verdict(&result, language)), (Some(Status::Rework), None));
    }
}

#[test]
fn the_page_of_cycle_444_has_the_status_of_its_own_band() {
    for (deviation, band, word) in [
        (0.4, Some([400_000, -100_000]), "GOOD"),
        (-0.1, Some([400_000, -100_000]), "GOOD"),
        (0.400_001, Some([400_000, -100_000]), "REWORK"),
        (-0.100_001, Some([400_000, -100_000]), "SCRAP"),
        (-0.000_001, Some([400_000, 0]), "SCRAP"),
        (1.5, None, "NOT JUDGED"),
    ] {
        let (cycle, result) = point([0.0, 3.0, 4.0], deviation, band);
        let log = CycleLog::of(cycle, &result, &heading(Unit::Millimetre), Dialogue::En).unwrap();
        let page = String::from_utf8(log.write(Dialogue::En).unwrap()).unwrap();
        assert!(page.contains(&format!("rowspan=\"3\">{word}</td>")), "{deviation}: {page}");
        assert!(band.is_some() || page.contains("no tolerance"), "{page}");
    }
}

#[test]
fn a_cycle_without_a_log_and_a_result_of_another_cycle_make_none() {
    let (_, hole) = circle(true, [0, 0, 25_000_000], [0, 0, 25_000_000], None, [0, 0]);
    let head = heading(Unit::Millimetre);
    for cycle in CYCLES {
        let made = CycleLog::of(cycle, &hole, &head, Dialogue::En).is_some();
        // 421 and 422 have the same results except for the limits.
        assert_eq!(made, [421, 422].contains(&cycle.number), "{}", cycle.code);
    }
    let cycle = cycle_named("G785").unwrap();
    let inputs = cycle.set(cycle.set(Inputs::new(), "K", "2").unwrap(), "RC", "120").unwrap();
    let round = hole.contacts.clone();
    let lathe = cycle.measure(&inputs, &mut Recorded::new(round)).unwrap();
    assert_eq!(CycleLog::of(cycle, &lathe, &head, Dialogue::En), None);
}

#[test]
fn a_second_log_stands_behind_the_first() {
    let (cycle, result) = coordinate(5_000_000, [5_100_000, 4_950_000]);
    let log = CycleLog::of(cycle, &result, &heading(Unit::Millimetre), Dialogue::It).unwrap();
    let two = log.append(&log.write(Dialogue::De).unwrap(), Dialogue::It).unwrap();
    assert_eq!(log::read(&two).iter().filter(|log| log.is_ok()).count(), 2);
    let refused = log.append(b"cut off", Dialogue::It).unwrap_err().to_string();
    assert_eq!(refused, "the file ends within a line: it may be cut off, so nothing is added to it");
    let (cycle, result) = point([0.0, 0.0, 1.0], 0.1, Some([400_000, -100_000]));
    let page = CycleLog::of(cycle, &result, &heading(Unit::Inch), Dialogue::Nl).unwrap();
    let two = page.append(&page.write(Dialogue::Nl).unwrap(), Dialogue::En).unwrap();
    assert_eq!(point_log::read(&two).len(), 2);
    assert!(page.append(b"<html></html>", Dialogue::En).unwrap_err().to_string().starts_with("line 1: not a log"));
}

/// The unit of a program and the dialogue language of its control.
fn units() -> impl Strategy<Value = (Unit, Dialogue)> {
    (prop_oneof![Just(Unit::Millimetre), Just(Unit::Inch)], proptest::sample::select(Dialogue::ALL.to_vec()))
}

/// Limits as a pair of nanometres that is not swapped.
fn pair(one: i64, other: i64) -> [i64; 2] {
    [one.max(other), one.min(other)]
}

/// Values of the log in nanometres.
fn figures(log: &CycleLog) -> Vec<i64> {
    let CycleLog::Text(log) = log else { panic!() };
    let lengths = log.figures.iter().flat_map(|figure| {
        let limits = figure.limits.map(|pair| [pair.maximum, pair.minimum]);
        [figure.nominal, Some(figure.actual)].into_iter().flatten().chain(limits.into_iter().flatten())
    });
    lengths.map(Length::nanometres).collect()
}

/// The log never has the worse of two verdicts: rounding takes no value over its limit.
fn is_no_worse(cycle: Option<Status>, log: Option<Status>) -> bool {
    log.is_none() || log <= cycle
}

proptest! {
    #[test]
    fn a_circle_s_log_reads_back_with_the_same_figures_and_the_same_verdict(
        is_hole in any::<bool>(),
        centre in [-300_000..300_000_i64, -300_000..300_000],
        off in [-200..200_i64, -200..200],
        nominal in 30_000..900_000_i64,
        deviation in -300..300_i64,
        limits in proptest::option::of([-300..300_i64, -300..300]),
        tolerances in [0..200_i64, 0..200],
        nanometres in prop_oneof![Just([0; 4]), [-99..99_i64, -99..99, -99..99, 0..99]],
        (unit, language) in units(),
    ) {
        // Tenths of a micrometre, the last figure of a log in millimetres, and possibly nanometres beyond it.
        let [fine_1, fine_2, fine_d, fine_t] = nanometres;
        let nominal_place = [centre[0] * 1000, centre[1] * 1000, nominal * 100];
        let actual = [
            nominal_place[0] + off[0] * 100 + fine_1,
            nominal_place[1] + off[1] * 100 + fine_2,
            nominal_place[2] + deviation * 100 + fine_d,
        ];
        let limits = limits.map(|[one, other]| pair((nominal + one) * 100 + fine_t, (nominal + other) * 100));
        let tolerances = [tolerances[0] * 100, tolerances[1] * 100 + fine_t];
        let (cycle, result) = circle(is_hole, nominal_place, actual, limits, tolerances);
        let (read, says) = there_and_back(cycle, &result, unit, language);
        prop_assert!(is_no_worse(result.status, says), "{:?} but {:?}", result.status, says);
        if unit == Unit::Millimetre && nanometres == [0; 4] {
            let unrounded = CycleLog::of(cycle, &result, &heading(unit), language).unwrap();
            prop_assert_eq!(figures(&read), figures(&unrounded));
            prop_assert_eq!(says.unwrap_or(Status::Good), result.status.unwrap());
        }
    }

    #[test]
    fn a_coordinate_s_log_reads_back_with_the_same_figures_and_the_same_verdict(
        actual in -400_000..400_000_i64,
        limits in [-300..300_i64, -300..300],
        nanometres in prop_oneof![Just(0_i64), -99..99_i64],
        (unit, language) in units(),
    ) {
        let limits = pair((actual + limits[0]) * 100, (actual + limits[1]) * 100);
        let (cycle, result) = coordinate(actual * 100 + nanometres, limits);
        let (read, says) = there_and_back(cycle, &result, unit, language);
        prop_assert!(is_no_worse(result.status, says), "{:?} but {:?}", result.status, says);
        if unit == Unit::Millimetre && nanometres == 0 {
            let unrounded = CycleLog::of(cycle, &result, &heading(unit), language).unwrap();
            prop_assert_eq!(figures(&read), figures(&unrounded));
            prop_assert_eq!(says.or(result.status), result.status);
        }
    }

    #[test]
    fn a_point_s_page_reads_back_exactly_with_the_cycle_s_own_verdict(
        normal in [-10.0..10.0_f64, -10.0..10.0, -10.0..10.0],
        deviation in -500_000..500_000_i64,
        band in proptest::option::of([1..500_000_i64, 1..500_000]),
        on_limit in any::<bool>(),
        (unit, language) in units(),
    ) {
        prop_assume!(0.01 < normal.iter().map(|part| part * part).sum::<f64>());
        let band = band.map(|[upper, lower]| [upper, -lower]);
        let deviation = band.filter(|_| on_limit).map_or(deviation, |[upper, _]| upper);
        let (cycle, result) = point(normal, mm(deviation), band);
        let (log, says) = there_and_back(cycle, &result, unit, language);
        prop_assert_eq!(says, result.status);
        let CycleLog::Page(page) = log else { panic!() };
        prop_assert_eq!(Some(&Value::Length(page.deviation)), result.value(164));
    }
}

#[test]
fn another_verdict_names_the_unit_of_the_log() {
    let other = OtherVerdict { cycle: Status::Scrap, log: Status::Good, unit: Unit::Inch };
    let said = "the log's values, rounded to 0.0001 inch, give GOOD where the cycle gave SCRAP";
    assert_eq!(other.to_string(), said);
}
