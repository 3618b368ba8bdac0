//! The twin test: program 8255 with 82551, as shipped, says what Fitcheck says, byte for byte.
//!
//! For all 47 classes, in every size range of the shipped tables at its end, in its middle and 0.1 µm above the end
//! before, on workpieces a nanometre below the limits, on them, in the middle and a nanometre above. The limits are held
//! against published figures (`tests/data/iso286`) as well. Where the program is weak, what the control says and what
//! Fitcheck says stand side by side.

use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

use fitcheck::control::machine::{Contacts, Fault, Machine, Settings, Shipped, Step};
use fitcheck::control::program::Program;
use fitcheck::control::shipped_tables;
use fitcheck::control::status::{status_window, status_word};
use fitcheck::control::variables::{Parameter, Value};
use fitcheck::journal::Record;
use fitcheck::length::{Length, Unit};
use fitcheck::probing::measure::{ProbePosition, cycle_number, measure};
use fitcheck::probing::simulated::{Bench, Surface, Workpiece};
use fitcheck::probing::Origin;
use fitcheck::probing::cycle::Plane;
use fitcheck::tolerance::{Callout, DeviationTable, Feature, Limits, Sources, ToleranceClass};
use fitcheck::verdict::{Status, doubt, judge};
use fitcheck::words::Language;

/// The centre that the shipped main programs name.
const CENTRE: [i32; 2] = [40, 30];

const NANOMETRE: i64 = 1;
/// What controls show: 0.1 µm.
const LAST_DIGIT: i64 = 100;

fn nm(nanometres: i64) -> Length {
    Length::from_nanometres(nanometres).unwrap()
}

fn time() -> jiff::civil::DateTime {
    jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0)
}

fn main_program(language: Language) -> Arc<Program> {
    let bytes = Shipped::file(&format!("8255_{language}.h")).unwrap();
    let (program, warnings) = Program::read(bytes).unwrap();
    assert_eq!(warnings, []);
    Arc::new(program)
}

fn bench(feature: Feature, diameter: Length) -> Bench {
    let workpiece = Workpiece::round(feature, CENTRE.map(f64::from), diameter.to_mm_f64());
    Bench::perfect(Surface::Round(workpiece, Plane::Xy))
}

/// What a run of 8255 leaves behind.
#[derive(Debug, Clone, PartialEq)]
struct Answer {
    window: String,
    status: Option<Status>,
    word: Option<Value>,
}

/// Runs 8255 with Q1 and QS1 as the operator would set them: Q1 is a floating-point number.
fn run(program: &Arc<Program>, nominal: &str, class: &str, bench: Bench, language: Language) -> Result<Machine, Fault> {
    let settings = Settings::new(language, time());
    let path = format!(r"TNC:\8255\8255_{language}.h");
    let mut machine = Machine::new(&path, Arc::clone(program), Shipped, Contacts::Workpiece(bench), settings);
    machine.set(Parameter::q(1), Value::Number(nominal.parse().unwrap()));
    machine.set(Parameter::qs(1), Value::Text(class.to_owned()));
    while machine.run(u64::MAX)? != Step::Ended {}
    Ok(machine)
}

fn answer_of(machine: &Machine) -> Answer {
    let [window] = machine.windows() else { panic!("{} windows", machine.windows().len()) };
    let word = machine.variables().get(Parameter::qs(3)).cloned();
    Answer { window: window.text.clone(), status: machine.status(), word }
}

/// What `fitcheck check` answers on the same workpiece.
fn native(limits: &Limits, callout: Callout, bench: Bench, language: Language) -> Answer {
    let position = ProbePosition {
        centre: CENTRE.map(|mm| Length::from_micrometres(mm * 1000)),
        height: Length::from_micrometres(-8_000),
        clearance: Length::from_micrometres(2_000),
        ..ProbePosition::default()
    };
    let origin = Origin::Simulated { cycle: cycle_number(limits.feature), seed: 1 };
    let mut machine = bench.machine().unwrap();
    let (measurement, _) = measure(limits, &position, &mut machine, origin).unwrap();
    let verdict = judge(limits, measurement.diameter, None);
    let record = Record {
        time: time(),
        id: String::new(),
        callout: Some(callout),
        verdict,
        doubt: doubt(limits.nominal, measurement.diameter),
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
    let (below, above) = match limits.feature {
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

/// Runs both on a callout and its five workpieces; gives how many were compared.
fn compare(program: &Arc<Program>, callout: Callout, limits: &Limits, language: Language) -> usize {
    let class = callout.class().unwrap();
    for (diameter, expected) in workpieces(limits) {
        let bench = bench(limits.feature, diameter);
        let native = native(limits, callout, bench, language);
        let machine = run(program, &callout.nominal().to_string(), class.as_str(), bench, language)
            .unwrap_or_else(|fault| panic!("{callout}, {diameter} mm: {fault}"));
        assert_eq!(answer_of(&machine), native, "{callout}, {diameter} mm");
        assert_eq!(native.status, Some(expected), "{callout}, {diameter} mm");
    }
    workpieces(limits).len()
}

/// Just above the end before, the middle, the end.
fn sizes(table: &DeviationTable) -> Vec<Length> {
    let mut sizes = Vec::new();
    let mut over = 0;
    for end in table.ends().iter().map(|end| end.nanometres()) {
        sizes.extend([over + LAST_DIGIT, i64::midpoint(over, end) / LAST_DIGIT * LAST_DIGIT, end].map(nm));
        over = end;
    }
    sizes
}

#[test]
fn timing() {
    let program = main_program(Language::Nl);
    let sources = Sources::of_tables(shipped_tables());
    for text in ["25 H7", "25 h7", "400 h7", "400 H7"] {
        let callout: Callout = text.parse().unwrap();
        let limits = sources.limits(&callout, None).unwrap();
        let from = std::time::Instant::now();
        for _ in 0..10 {
            compare(&program, callout, &limits, Language::Nl);
        }
        println!("{text}: {:?}", from.elapsed() / 50);
    }
}
