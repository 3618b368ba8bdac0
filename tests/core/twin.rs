//! The twin test: the built-in program 8255 with 82551 says the same as Fitcheck, byte for byte.
//!
//! For all 47 classes, in every size range of the built-in tables at its end, in its middle and 0.1 µm above the end
//! before, on workpieces a nanometre below the limits, on them, in the middle and a nanometre above. The limits are
//! also compared with published figures (`tests/data/iso286`). Where the program is weak, the control's answer and
//! Fitcheck's are side by side.

use std::collections::BTreeMap;
use std::sync::Arc;

use fitcheck::control::deviations::{read_table, to_control_table};
use fitcheck::control::shipped_tables;
use fitcheck::control::status::status_word;
use fitcheck::control::table::Generation;
use fitcheck::control::variables::{Parameter, Value};
use fitcheck::journal::{Record, status_window};
use fitcheck::length::{Length, Unit};
use fitcheck::nc::machine::{Contacts, Fault, InMemory, Machine, Settings, Shipped, Step};
use fitcheck::nc::program::{Body, Program};
use fitcheck::probing::cycle::Plane;
use fitcheck::probing::measure::{ProbePosition, cycle_number, measure};
use fitcheck::probing::simulated::{Simulation, Surface, Workpiece};
use fitcheck::probing::{Origin, Recorded};
use fitcheck::tolerance::table::Column;
use fitcheck::tolerance::{
    Callout, DeviationTable, Deviations, Feature, Limits, LimitsError, Sources, ToleranceClass, ZoneDoubt,
};
use fitcheck::verdict::{Status, doubt, judge};
use fitcheck::words::Dialogue;

/// The centre that the built-in main programs name.
const CENTRE: [i32; 2] = [40, 30];

/// The smallest workpiece that can be simulated, 1 µm.
const SMALLEST: Length = Length::from_micrometres(1);

const NANOMETRE: i64 = 1;
/// What controls show: 0.1 µm.
const LAST_DIGIT: i64 = 100;

fn nm(nanometres: i64) -> Length {
    Length::from_nanometres(nanometres).unwrap()
}

fn time() -> jiff::civil::DateTime {
    jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0)
}

fn main_program(language: Dialogue) -> Arc<Program> {
    let bytes = Shipped::file(&format!("8255_{language}.h")).unwrap();
    let (program, warnings) = Program::read(bytes).unwrap();
    assert_eq!(warnings, []);
    Arc::new(program)
}

fn simulation(feature: Feature, diameter: Length) -> Simulation {
    let workpiece = Workpiece::round(feature, CENTRE.map(f64::from), diameter.to_mm_f64());
    Simulation::perfect(Surface::Round(workpiece, Plane::Xy))
}

/// What is left after a run of 8255.
#[derive(Debug, Clone, PartialEq)]
struct Answer {
    window: String,
    status: Option<Status>,
    word: Option<Value>,
}

/// A machine with the main program of a language; it is started again for every workpiece.
fn machine(language: Dialogue) -> Machine {
    let settings = Settings::new(language, time());
    let path = format!(r"TNC:\8255\8255_{language}.h");
    Machine::new(&path, main_program(language), Shipped, Contacts::Perfect, settings)
}

/// Runs 8255 with Q1 and QS1 as an operator sets them: Q1 is a floating-point number.
fn run(machine: &mut Machine, nominal: &str, class: &str, contacts: Contacts) -> Result<(), Fault> {
    machine.restart(contacts);
    machine.set(Parameter::q(1), Value::Number(nominal.parse().unwrap())).unwrap();
    machine.set(Parameter::qs(1), Value::Text(class.to_owned())).unwrap();
    while machine.run(u64::MAX)? != Step::Ended {}
    Ok(())
}

fn answer_of(machine: &Machine) -> Answer {
    let [window] = machine.windows() else { panic!("{} windows", machine.windows().len()) };
    let word = machine.variables().get(Parameter::qs(3)).cloned();
    Answer { window: window.text.clone(), status: machine.status(), word }
}

/// The answer of `fitcheck check` on the same workpiece.
fn native(limits: &Limits, callout: Callout, simulation: Simulation, language: Dialogue) -> Answer {
    let position = ProbePosition {
        centre: CENTRE.map(|mm| Length::from_micrometres(mm * 1000)),
        height: Length::from_micrometres(-8_000),
        clearance: Length::from_micrometres(2_000),
        ..ProbePosition::default()
    };
    let origin = Origin::Simulated { cycle: cycle_number(limits.feature.unwrap()), seed: 1 };
    let mut machine = simulation.machine().unwrap();
    let (measurement, _) = measure(limits.feature.unwrap(), limits, &position, &mut machine, origin).unwrap();
    let verdict = judge(limits, measurement.diameter, None);
    let record = Record {
        time: time(),
        id: String::new(),
        callout: Some(callout),
        verdict,
        doubt: doubt(limits, measurement.diameter),
        correction: None,
        budget: None,
        limits: limits.clone(),
        measurement,
    };
    let status = verdict.status();
    let word = Value::Text(status_word(status, language).to_owned());
    let window = status_window(&record, language, None).unwrap();
    Answer { window, status: Some(status), word: Some(word) }
}

/// A nanometre below the limits, on the lower one, in the middle, on the upper one, a nanometre above.
fn workpieces(limits: &Limits) -> [(Length, Status); 5] {
    let (minimum, maximum) = (limits.minimum(), limits.maximum());
    let (below, above) = match limits.feature.unwrap() {
        Feature::Hole => (Status::Rework, Status::Scrap),
        Feature::Shaft => (Status::Scrap, Status::Rework),
    };
    [
        (nm(minimum.nanometres() - NANOMETRE), below),
        (minimum, Status::Good),
        (limits.middle(), Status::Good),
        (maximum, Status::Good),
        (nm(maximum.nanometres() + NANOMETRE), above),
    ]
}

/// Runs both on one workpiece.
fn compare(machine: &mut Machine, callout: Callout, limits: &Limits, (diameter, expected): (Length, Status)) {
    let simulation = simulation(limits.feature.unwrap(), diameter);
    let native = native(limits, callout, simulation, machine.settings().language);
    let class = callout.class().unwrap();
    run(machine, &callout.nominal().to_string(), class.as_str(), Contacts::Workpiece(simulation.into()))
        .unwrap_or_else(|fault| panic!("{callout}, {diameter} mm: {fault}"));
    assert_eq!(answer_of(machine), native, "{callout}, {diameter} mm");
    assert_eq!(native.status, Some(expected), "{callout}, {diameter} mm");
}

/// Where no diameter can be measured, because the cell is empty or a limit is below 0, neither gives a verdict.
fn compare_refusals(machine: &mut Machine, callout: Callout, limits: Option<&Limits>) {
    let class = callout.class().unwrap();
    let refused = run(machine, &callout.nominal().to_string(), class.as_str(), Contacts::Recorded(Vec::new()));
    let fault = refused.expect_err("a verdict without limits").to_string();
    assert!(machine.windows().is_empty(), "{callout}");
    match limits {
        None => assert!(fault.ends_with(&format!("column {class}: the cell is empty")), "{callout}: {fault}"),
        Some(limits) => {
            assert!(fault.contains("at least 0 mm"), "{callout}: {fault}");
            let origin = Origin::Simulated { cycle: cycle_number(limits.feature.unwrap()), seed: 1 };
            let native = measure(
                limits.feature.unwrap(),
                limits,
                &ProbePosition::default(),
                &mut Recorded::new(Vec::new()),
                origin,
            );
            assert!(native.unwrap_err().to_string().contains("at least 0 mm"), "{callout}");
        }
    }
}

/// Published deviations by class: over, up to, upper and lower, µm.
fn published() -> BTreeMap<ToleranceClass, Vec<[Length; 4]>> {
    let path = format!("{}/tests/data/iso286/limits_47_classes.csv", env!("CARGO_MANIFEST_DIR"));
    let mut found: BTreeMap<ToleranceClass, Vec<[Length; 4]>> = BTreeMap::new();
    for line in std::fs::read_to_string(path).unwrap().lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let mm = |text: &str| text.parse().unwrap();
        let um = |text: &str| Length::parse_in(text, Unit::Micrometre).unwrap();
        let row = [mm(cells[1]), mm(cells[2]), um(cells[3]), um(cells[4])];
        found.entry(cells[0].parse().unwrap()).or_default().push(row);
    }
    found
}

/// What was compared.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
struct Count {
    classes: usize,
    verdicts: usize,
    refusals: usize,
}

/// Every second class of a table, or every other.
fn sweep(feature: Feature, odd: bool) -> Count {
    let (tables, published) = (shipped_tables(), published());
    let table = tables.iter().find(|table| table.columns()[0].class.feature() == feature).unwrap();
    let sources = Sources::of_tables(tables.clone());
    let mut machine = machine(Dialogue::Nl);
    let mut count = Count::default();
    for column in table.columns().iter().skip(usize::from(odd)).step_by(2) {
        count.classes += 1;
        for (nominal, is_border) in sizes(table) {
            let callout = Callout::new(nominal, column.class).unwrap();
            let Ok(limits) = sources.limits(&callout, None) else {
                compare_refusals(&mut machine, callout, None);
                count.refusals += 1;
                continue;
            };
            let row = published[&column.class].iter().find(|[over, to, ..]| *over < nominal && nominal <= *to);
            let [_, _, upper, lower] = row.unwrap_or_else(|| panic!("{callout} is not published"));
            assert_eq!((limits.deviations.upper(), limits.deviations.lower()), (*upper, *lower), "{callout}");
            if limits.minimum() < Length::ZERO {
                compare_refusals(&mut machine, callout, Some(&limits));
                count.refusals += 1;
                continue;
            }
            let all = workpieces(&limits);
            let wanted = if is_border { &all[..] } else { &all[2..3] };
            for &workpiece in wanted.iter().filter(|(diameter, _)| SMALLEST <= *diameter) {
                compare(&mut machine, callout, &limits, workpiece);
                count.verdicts += 1;
            }
        }
    }
    count
}

/// Of every size range: a nanometre above the end before, 0.1 µm above it, the middle, the end. At all but the second
/// all workpieces are measured.
fn sizes(table: &DeviationTable) -> Vec<(Length, bool)> {
    let mut sizes = Vec::new();
    let mut over = 0;
    for end in table.ends().iter().map(|end| end.nanometres()) {
        let middle = i64::midpoint(over, end) / LAST_DIGIT * LAST_DIGIT;
        let all = [(over + NANOMETRE, true), (over + LAST_DIGIT, false), (middle, true), (end, true)];
        sizes.extend(all.map(|(size, is_border)| (nm(size), is_border)));
        over = end;
    }
    sizes
}

#[test]
fn hole_classes_agree_byte_for_byte() {
    assert_eq!(sweep(Feature::Hole, false), Count { classes: 12, verdicts: 3_984, refusals: 12 });
}

#[test]
fn the_other_hole_classes_agree_as_well() {
    assert_eq!(sweep(Feature::Hole, true), Count { classes: 12, verdicts: 3_990, refusals: 12 });
}

#[test]
fn shaft_classes_agree_byte_for_byte() {
    assert_eq!(sweep(Feature::Shaft, false), Count { classes: 12, verdicts: 3_988, refusals: 14 });
}

#[test]
fn the_other_shaft_classes_agree_as_well() {
    assert_eq!(sweep(Feature::Shaft, true), Count { classes: 11, verdicts: 3_642, refusals: 16 });
}

#[test]
fn every_language_says_the_same() {
    let tables = shipped_tables();
    let sources = Sources::of_tables(tables.clone());
    for language in Dialogue::ALL {
        let mut machine = machine(language);
        for class in tables.iter().flat_map(|table| table.columns().iter().map(|column| column.class)) {
            let callout = Callout::new("25.5".parse().unwrap(), class).unwrap();
            let limits = sources.limits(&callout, None).unwrap();
            for workpiece in workpieces(&limits) {
                compare(&mut machine, callout, &limits, workpiece);
            }
        }
    }
}

/// The built-in table with one own column more, whose deviations differ in every size range, as a file.
fn with_own_column(feature: Feature) -> Vec<u8> {
    let tables = shipped_tables();
    let table = tables.iter().find(|table| table.columns()[0].class.feature() == feature).unwrap();
    let (name, side) = match feature {
        Feature::Hole => ("PF", 1),
        Feature::Shaft => ("pf", -1),
    };
    let cell = |number: i32| {
        let ends = [35 + 3 * number, 5 + number].map(|um| Length::from_micrometres(um * side));
        Deviations::new(ends[0].max(ends[1]), ends[0].min(ends[1])).unwrap()
    };
    let cells = (0..).zip(table.ends()).map(|(number, _)| Some(cell(number))).collect();
    let mut columns = table.columns()[..20].to_vec();
    columns.push(Column { class: name.parse().unwrap(), cells });
    let own = DeviationTable::new(table.name(), false, table.ends().to_vec(), columns).unwrap();
    to_control_table(&own, Generation::Structure).write().unwrap()
}

/// QS1 = PF is what `25 PF` is to `fitcheck check --tables`: in every size range, and in every language.
#[test]
fn an_own_column_agrees_byte_for_byte() {
    let both = [Feature::Hole, Feature::Shaft].map(with_own_column);
    let tables = both.each_ref().map(|bytes| read_table(bytes, "own", "own", false).unwrap().0.unwrap());
    let [holes, shafts] = &both;
    let sources = Sources::default().with_own(tables.clone());
    for language in Dialogue::ALL {
        let store = InMemory::new().with("82553_hole.tab", holes.clone()).with("82553_shaft.tab", shafts.clone());
        let path = format!(r"TNC:\8255\8255_{language}.h");
        let settings = Settings::new(language, time());
        let mut machine = Machine::new(&path, main_program(language), store, Contacts::Perfect, settings);
        let (mut count, mut below_zero) = (0, 0);
        for (table, class) in tables.iter().zip(["PF", "pf"]) {
            for (nominal, is_border) in sizes(table) {
                let callout = Callout::new(nominal, class.parse().unwrap()).unwrap();
                let limits = match sources.limits(&callout, None) {
                    Ok(limits) => limits,
                    Err(refused) => {
                        let LimitsError::Zone(doubt) = refused else { panic!("{callout}: {refused}") };
                        assert!(matches!(*doubt, ZoneDoubt::ToZero { .. }), "{callout}: {doubt:?}");
                        below_zero += 1;
                        continue;
                    }
                };
                let all = workpieces(&limits);
                let wanted = if is_border && language == Dialogue::Nl { &all[..] } else { &all[2..3] };
                for &workpiece in wanted.iter().filter(|(diameter, _)| SMALLEST <= *diameter) {
                    compare(&mut machine, callout, &limits, workpiece);
                    count += 1;
                }
            }
        }
        assert_eq!(count, if language == Dialogue::Nl { 666 } else { 166 }, "{language}");
        assert_eq!(below_zero, 2, "{language}");
    }
}

/// Where the program has no answer of its own: the control's answer beside Fitcheck's.
#[track_caller]
fn side_by_side(nominal: &str, class: &str, control: &str, fitcheck: &str) {
    let mut machine = machine(Dialogue::Nl);
    let fault = run(&mut machine, nominal, class, Contacts::Perfect).expect_err("a fault");
    let sources = Sources::of_tables(shipped_tables());
    let refused = match format!("{nominal} {class}").parse::<Callout>() {
        Ok(callout) => sources.limits(&callout, None).expect_err("no limits").to_string(),
        Err(error) => error.to_string(),
    };
    let fault = format!("block {}: {}", fault.number.unwrap(), fault.kind);
    assert_eq!((fault.as_str(), refused.as_str()), (control, fitcheck));
    assert!(machine.windows().is_empty() && machine.status().is_none(), "no verdict");
}

#[test]
fn beyond_the_last_range_the_table_has_no_row() {
    side_by_side(
        "400.0001",
        "H7",
        "block 20: table 82553_hole.tab has no row 42: its rows are 0 to 41",
        "nominal size 400.0001 mm is beyond table 82553_hole.tab, whose last range is over 355 up to and including 400 mm",
    );
    side_by_side(
        "401",
        "g6",
        "block 20: table 82553_shaft.tab has no row 42: its rows are 0 to 41",
        "nominal size 401 mm is beyond table 82553_shaft.tab, whose last range is over 355 up to and including 400 mm",
    );
}

#[test]
fn an_unknown_class_has_no_column() {
    let holes = "D10 E9 F7 F8 G7 G9 H6 H7 H8 H9 H11 H12 H13 JS7 JS9 K6 K7 M6 M7 N7 N9 P7 P9 R7";
    let columns = format!("its columns are NR, BEREICH, {}", holes.replace(' ', ", "));
    let control = |class: &str| format!("block 14: table 82553_hole.tab has no column {class}; {columns}");
    let unknown = |class: &str| format!("{class} is not in table 82553_hole.tab; it has {holes}");
    side_by_side("25", "H10", &control("H10"), &unknown("H10"));
    side_by_side("25", "Z9", &control("Z9"), &unknown("Z9"));
    // The program only looks at the first character: capitals, digits and nothing at all are holes to it.
    let mixed = "Js9 mixes upper and lower case: write JS9 for a hole or js9 for a shaft (character 4)";
    side_by_side("25", "Js9", &control("Js9"), mixed);
    let digit = "7 has no sign: write +7 or -7 for a deviation, without a space in the number (character 4)";
    side_by_side("25", "7H", &control("7H"), digit);
    let missing = "a tolerance is missing, such as H7, h7, H7/g6, m, +0.1 -0.2 or ±0.1";
    side_by_side("25", "", &control(""), missing);
    // A class of the other case: Fitcheck offers it.
    let shafts = "d9 e8 f7 g6 h5 h6 h7 h8 h9 h11 js5 js6 js13 js14 k5 k6 m5 m6 n6 p6 r6 s6 s7";
    side_by_side(
        "25",
        "g9",
        &format!(
            "block 14: table 82553_shaft.tab has no column g9; its columns are NR, BEREICH, {}",
            shafts.replace(' ', ", ")
        ),
        "g9 is a shaft class and table 82553_shaft.tab does not have it; the hole class is G9",
    );
}

#[test]
fn an_empty_cell_is_no_value() {
    side_by_side(
        "0.8",
        "N9",
        "block 14: table 82553_hole.tab, row 0, column N9: the cell is empty",
        "N9 is not defined over 0 up to 1 mm in table 82553_hole.tab; it is defined over 1 up to 400 mm",
    );
}

/// The program itself takes row 0 for them; only the cycle's ranges keep it from a verdict.
#[test]
fn a_nominal_size_of_zero_or_less_is_stopped_by_the_cycle() {
    side_by_side(
        "0",
        "H7",
        "block 33: cycle 421: Q262 NOMINAL DIAMETER = 0 mm: a circle needs a diameter above 0",
        "nominal size 0 mm is not above 0",
    );
    side_by_side(
        "0",
        "h7",
        "block 37: cycle 422: Q278 MINIMUM DIMENSION = -0.01 mm: at least 0 mm, at most 99999.9999 mm",
        "nominal size 0 mm is not above 0",
    );
    side_by_side(
        "-5",
        "H7",
        "block 33: cycle 421: Q262 NOMINAL DIAMETER = -5 mm: at least 0 mm, at most 99999.9999 mm",
        "nominal size -5 mm is not above 0",
    );
}

/// The program of NC-Solution 8255 would run on into GOOD where the cycle has set no marker; ours stops.
#[test]
fn without_a_marker_the_program_never_says_good() {
    let text = String::from_utf8(Shipped::file("82551_nl.h").unwrap().to_vec()).unwrap();
    let (before, rest) = text.split_once("33 TCH PROBE 421").unwrap();
    let (_cycle, after) = rest.split_once("34 L  Z+Q61").unwrap();
    let without = format!("{before}33 Q180 = 0\r\nQ181 = 0\r\nQ182 = 0\r\n34 L  Z+Q61{after}");
    let settings = Settings::new(Dialogue::Nl, time());
    let store = InMemory::new().with("82551_nl.h", without);
    let mut machine = Machine::new("8255_nl.h", main_program(Dialogue::Nl), store, Contacts::Perfect, settings);
    let fault = machine.run(u64::MAX).expect_err("an error of the program");
    assert_eq!(fault.kind.to_string(), "the program stopped itself with error 1004");
    assert!(machine.windows().is_empty());
}

/// All languages have the same blocks except for comments, names and words.
#[test]
fn the_programs_differ_in_words_only() {
    let bare = |name: &str, language: Dialogue| {
        let bytes = Shipped::file(&format!("{name}_{language}.h")).unwrap();
        assert!(bytes.is_ascii(), "{name}_{language}.h");
        let (program, warnings) = Program::read(bytes).unwrap();
        assert_eq!((warnings, program.name()), (vec![], Some(format!("{name}_{language}").as_str())));
        let blocks = program.blocks().iter().map(|block| match &block.body {
            Body::Heading { depth, .. } => format!("heading {depth}"),
            Body::Probe(cycle) => {
                let lines = cycle.lines.iter().map(|line| format!("{}={:?}", line.parameter, line.value));
                format!("{} {}", cycle.number, lines.collect::<Vec<_>>().join(" "))
            }
            body => format!("{body:?}").replace(&format!("_{language}."), ".").replace(&format!("_{language}\""), "\""),
        });
        let mut blocks: Vec<String> = blocks.collect();
        for status in [Status::Good, Status::Rework, Status::Scrap] {
            let word = format!("{:?}", status_word(status, language));
            for block in &mut blocks {
                *block = block.replace(&word, status.word());
            }
        }
        blocks
    };
    for name in ["8255", "82551"] {
        for language in Dialogue::ALL {
            assert_eq!(bare(name, language), bare(name, Dialogue::Nl), "{name}_{language}.h");
        }
    }
}
