//! What a person reads is in the reader's language throughout: no English word and no decimal point within a Dutch
//! sentence.

use std::sync::Arc;

use fitcheck::control::variables::{Parameter, Value};
use fitcheck::message::Say;
use fitcheck::nc::machine::{Contacts, InMemory, Machine, Settings, Step};
use fitcheck::nc::program::Program;
use fitcheck::probing::circle::evaluate;
use fitcheck::probing::cycles::cycle;
use fitcheck::probing::simulated::Simulation;
use fitcheck::probing::{Contact, Measurement, Origin};
use fitcheck::session::{CycleFile, Purpose};
use fitcheck::tolerance::Callout;
use fitcheck::words::{Dialogue, Language, Words};

fn dutch() -> Words {
    Words::new(Language::Nl)
}

#[track_caller]
fn check(what: &impl Say, expected: &str) {
    assert_eq!(dutch().told(what), expected);
}

#[track_caller]
fn check_callout(text: &str, expected: &str) {
    check(&text.parse::<Callout>().unwrap_err(), expected);
}

#[test]
fn a_callout_that_an_error_suggests_has_a_decimal_comma_and_reads_back() {
    check_callout(
        "12,5 -0,2 +0,1",
        "de onderafwijking staat voor de bovenafwijking: schrijf 12,5 +0,1 \u{2212}0,2 (teken 6)",
    );
    check_callout("11.985/12.01", "de kleinste grensmaat staat voor de grootste: schrijf 12,01/11,985 (teken 1)");
    check_callout("12,5 g6/H7", "de as staat voor de boring: schrijf 12,5 H7/g6 (teken 6)");
    check_callout(
        "12,5M",
        "M heeft geen graad: schrijf 12,5m voor de algemene tolerantie van ISO 2768-1, of voeg een graad toe, zoals M7 \
         (teken 5)",
    );
    check_callout(
        "12,01-11,985",
        "dit is dubbelzinnig: schrijf 12,01/11,985 voor grensmaten of 12,01 0 \u{2212}11,985 voor een onderafwijking \
         (teken 1)",
    );
    let suggested: Callout = "12,5 +0,1 \u{2212}0,2".parse().unwrap();
    assert_eq!(suggested, "12.5 +0.1 -0.2".parse().unwrap());
}

/// Runs blocks with a value that is given before the run.
fn machine(blocks: &str, given: Option<(Parameter, Value)>) -> Machine {
    let text = format!("BEGIN PGM main MM\n{blocks}\nEND PGM main MM\n");
    let program = Arc::new(Program::read(text.as_bytes()).unwrap().0);
    let settings = Settings::new(Dialogue::Nl, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    let mut machine = Machine::new(r"TNC:\main.h", program, InMemory::new(), Contacts::Perfect, settings);
    if let Some((parameter, value)) = given {
        machine.set(parameter, value).unwrap();
    }
    machine
}

#[track_caller]
fn check_fault(blocks: &str, expected: &str) {
    let mut machine = machine(blocks, None);
    loop {
        match machine.run(u64::MAX) {
            Ok(Step::Ended) => panic!("it ran to its end"),
            Ok(_) => {}
            Err(fault) => return check(&fault.kind, expected),
        }
    }
}

#[test]
fn faults_and_remarks_of_a_run_have_a_decimal_comma_and_dutch_words() {
    check_fault("Q1 = 1.5\nCALL LBL Q1", "Q1 = 1,5 is geen label");
    check_fault("FN 14: ERROR = 1.5", "FN 14: ERROR = 1,5: een geheel getal vanaf 0 verwacht");
    let mut machine = machine("Q1 = 3\nQ2 = Q1", Some((Parameter::q(1), Value::Number(2.5))));
    machine.run(u64::MAX).unwrap();
    let said: Vec<_> = machine.remarks().iter().map(|(_, remark)| dutch().told(remark)).collect();
    assert_eq!(said, ["Q1 = 2,5 is vooraf opgegeven en vervangt de waarde in deze NC-regel"]);
}

#[test]
fn a_row_that_is_not_a_whole_number_is_a_rij() {
    use fitcheck::nc::machine::{Counted, FaultKind};
    check(&FaultKind::NotWhole { what: Counted::Row, value: 1.5 }, "rij = 1,5: een geheel getal vanaf 0 verwacht");
}

#[test]
fn a_figure_that_a_workpiece_cannot_have_is_named_in_dutch() {
    let wrong = |text: &str| Simulation::read(text).unwrap_err();
    check(
        &wrong("[bore]\ncentre = [1e6, 0]\ndiameter = 25.5\n"),
        "regel 2: midden x = 1000000: minstens \u{2212}100000, hoogstens 100000",
    );
    check(
        &wrong("[bore]\ncentre = [0, 0]\ndiameter = 25.5\nsurface_scatter = 2.5\n"),
        "regel 4: spreiding van het oppervlak = 2,5: minstens 0, hoogstens 1,275",
    );
    check(&wrong("temperature = -100.5\n[bore]\ncentre = [0, 0]\ndiameter = 25\n"), {
        "regel 1: temperatuur = \u{2212}100,5: minstens \u{2212}100, hoogstens 200"
    });
}

#[test]
fn what_is_too_large_for_a_length_is_named_in_dutch() {
    let contact = |x, y| Contact { x, y, z: 0.0 };
    check(
        &evaluate(&[contact(0.0, 0.0), contact(1.0, 1.0), contact(0.0, 2_000_000_000.5)]).unwrap_err(),
        "meetpunt 3: y = 2000000000,5 mm is te groot: hoogstens 1000000000 mm in beide richtingen",
    );
    let circle = fitcheck::probing::circle::Circle { x: 2e9, y: 0.0, diameter: 1.0 };
    check(
        &Measurement::of_circle(circle, Vec::new(), Origin::Typed).unwrap_err(),
        "midden x = 2000000000 mm is te groot: hoogstens 1000000000 mm in beide richtingen",
    );
}

#[test]
fn warnings_about_a_circle_have_a_decimal_comma() {
    let at = |degrees: f64| Contact { x: degrees.to_radians().cos(), y: degrees.to_radians().sin(), z: 0.0 };
    let evaluation = evaluate(&[at(0.0), at(30.5), at(60.5)]).unwrap();
    let said: Vec<_> = evaluation.warnings.iter().map(|warning| dutch().told(warning)).collect();
    assert!(said.iter().any(|warning| warning.contains("60,5°")), "{said:?}");
    assert!(said.iter().all(|warning| !warning.contains("60.5")), "{said:?}");
}

#[test]
fn ranges_and_values_of_parameters_have_dutch_words() {
    let parameter = |number: u16, key: &str| cycle(number).unwrap().parameter_named(key).unwrap();
    let range = |number, key| dutch().say(&parameter(number, key).range.short());
    assert_eq!(range(427, "Q263"), "\u{2212}99999,9999 … 99999,9999");
    assert_eq!(range(427, "Q267"), "\u{2212}1, 1");
    assert_eq!(range(427, "Q330"), "0 … 99999,9, of hoogstens 255 tekens");
    let none = parameter(444, "QS400").accept("0").unwrap();
    assert_eq!(dutch().say(&none.with_unit()), "geen tolerantie");
    let tool = parameter(427, "Q330").accept("PROBE-1.5").unwrap();
    assert_eq!(dutch().say(&tool.with_unit()), "PROBE-1.5", "a name stays as it is");
}

#[test]
fn the_system_dialog_names_kinds_of_files_in_dutch_and_english() {
    let english = Words::new(Language::En);
    let name = |purpose: Purpose| [purpose.filter_name(&english), purpose.filter_name(&dutch())];
    assert_eq!(name(Purpose::OpenProgram), ["NC programs (*.h, *.i)", "NC-programma's (*.h, *.i)"]);
    assert_eq!(name(Purpose::OpenTable), ["Tables (*.tab)", "Tabellen (*.tab)"]);
    assert_eq!(
        name(Purpose::OpenCycleFile(CycleFile::Contacts)),
        ["Contacts (*.csv, *.txt)", "Meetpunten (*.csv, *.txt)"]
    );
    for purpose in
        [Purpose::Import, Purpose::LoadMask, Purpose::SaveCycleLog, Purpose::ExportStatus, Purpose::Export(0)]
    {
        let [english, dutch] = name(purpose);
        assert_ne!(english, dutch);
        assert!(!english.starts_with("file-kind"), "{english}");
    }
}
