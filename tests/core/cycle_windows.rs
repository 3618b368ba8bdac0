//! The status window of a measuring cycle, drawn with the mask that the cycle declares or with the user's own.

use fitcheck::control::cycle_status::{cycle_mask, cycle_window};
use fitcheck::control::mask::Mask;
use fitcheck::control::status::status_word;
use fitcheck::probing::cycle::{Cycle, CycleResult, Inputs, Window};
use fitcheck::probing::cycles::{CYCLES, cycle_named};
use fitcheck::probing::{Contact, Recorded};
use fitcheck::verdict::Status;
use fitcheck::words::Dialogue;

fn measured(code: &str, settings: &[&str], contacts: &[[f64; 3]]) -> (&'static Cycle, CycleResult) {
    let cycle = cycle_named(code).unwrap();
    let inputs = settings.iter().fold(Inputs::new(), |inputs, setting| {
        let (name, text) = setting.split_once('=').unwrap();
        cycle.set(inputs, name, text).unwrap()
    });
    let contacts = contacts.iter().map(|place| Contact::at(*place)).collect();
    (cycle, cycle.measure(&inputs, &mut Recorded::new(contacts)).unwrap())
}

#[track_caller]
fn check((cycle, result): &(&'static Cycle, CycleResult), language: Dialogue, expected: Option<&str>) {
    let time = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
    let window = cycle_window(cycle, result, language, None, time).map(Result::unwrap);
    assert_eq!(window.as_deref(), expected);
}

const SQUARE: [[f64; 3]; 4] = [[37.5, 0.0, -5.0], [0.0, 37.5, -5.0], [-37.5, 0.0, -5.0], [0.0, -37.5, -5.0]];

#[test]
fn a_circle_is_drawn_with_the_mask_of_nc_solution_8255() {
    let nominal = ["Q273=0", "Q274=0", "Q262=75"];
    let stud = measured("422", &[&nominal[..], &["Q277=74.9", "Q278=74.8"]].concat(), &SQUARE);
    check(
        &stud,
        Dialogue::Nl,
        Some(
            "STATUS VAN DE PASSING: Nabewerking\nGEPRUEFTE PASSUNG: 75 (422)\nMINIMALE MAAT:  74.8000\n\
             MAXIMALE MAAT:  74.9000\nGEMETEN DIAMETER:  75.0000\n",
        ),
    );
    check(&measured("421", &nominal, &SQUARE), Dialogue::En, None);
    // A centre alone has no limits of size to print.
    check(&measured("421", &[&nominal[..], &["Q279=1"]].concat(), &SQUARE), Dialogue::En, None);
    check(&measured("G785", &["K=2", "RC=120"], &SQUARE), Dialogue::En, None);
}

#[test]
fn a_mask_of_the_user_s_own_has_what_program_82551_has() {
    let stud = measured("422", &["Q273=0", "Q274=0", "Q262=75", "Q277=75.0125", "Q278=74.8"], &SQUARE);
    let mask = b"\"%S %6.3F %2.0F %5.1F %6.1F %6.3F\", QS2, Q1, Q2, Q4, Q5, Q163;\nM_CLOSE;\n";
    let (mask, _) = Mask::read(mask).unwrap();
    let time = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
    let text = cycle_window(stud.0, &stud.1, Dialogue::En, Some(&mask), time).unwrap().unwrap();
    assert_eq!(text, "75 (422) 75.000  1  12.5 -200.0  0.000\n");
}

#[test]
fn a_coordinate_and_a_point_have_masks_of_their_own() {
    let face = ["Q263=0", "Q264=0", "Q261=0", "Q272=3", "Q267=-1", "Q288=5.1", "Q289=-4.95"];
    check(
        &measured("427", &face, &[[0.0, 0.0, 5.0]]),
        Dialogue::En,
        Some(
            "COORDINATE STATUS: GOOD\nCHECKED: Z (427)\nMINIMUM LIMIT:  -4.9500\nMAXIMUM LIMIT:   5.1000\n\
             MEASURED COORDINATE:   5.0000\n",
        ),
    );
    let point = ["Q263=0", "Q264=0", "Q294=0", "Q581=0", "Q582=0", "Q583=1"];
    check(
        &measured("444", &[&point[..], &["QS400=0.4-0.1"]].concat(), &[[0.0, 0.0, -0.2]]),
        Dialogue::En,
        Some(
            "POINT STATUS: SCRAP\nTOLERANCE: 0.4-0.1\nMEASURED 1ST AXIS:   0.0000\nMEASURED 2ND AXIS:   0.0000\n\
             MEASURED 3RD AXIS:  -0.2000\nDEVIATION:  -0.2000\n",
        ),
    );
    check(&measured("444", &point, &[[0.0, 0.0, -0.2]]), Dialogue::En, None);
}

#[test]
fn every_mask_that_a_cycle_declares_is_there_in_every_language() {
    let mut missing = Vec::new();
    for (cycle, language) in CYCLES.iter().flat_map(|cycle| Dialogue::ALL.map(|language| (cycle, language))) {
        let name = match cycle.window {
            Window::None => continue,
            Window::Diameter => "82552",
            Window::Own(name) => name,
        };
        if cycle_mask(cycle, language).is_none() {
            missing.push(format!("cycle {} declares assets/masks/{name}_{language}.a, which is missing", cycle.code));
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

#[test]
fn every_mask_of_every_language_can_be_drawn_for_every_status() {
    for (height, status) in [(5.0, 0), (5.2, 1), (4.9, 2)] {
        let face = ["Q263=0", "Q264=0", "Q261=0", "Q272=3", "Q267=-1", "Q288=5.1", "Q289=4.95"];
        let coordinate = measured("427", &face, &[[0.0, 0.0, height]]);
        let point = ["Q263=0", "Q264=0", "Q294=5", "Q581=0", "Q582=0", "Q583=1", "QS400=0.1-0.05"];
        let point = measured("444", &point, &[[0.0, 0.0, height]]);
        for ((cycle, result), language) in
            [&coordinate, &point].into_iter().flat_map(|run| Dialogue::ALL.map(|l| (run, l)))
        {
            let time = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
            let text = cycle_window(cycle, result, language, None, time).unwrap().unwrap();
            let status = [Status::Good, Status::Rework, Status::Scrap][status];
            let end = format!(": {}", status_word(status, language));
            assert!(text.lines().next().unwrap().ends_with(&end), "{text}");
            assert!(text.lines().count() <= 6 && text.lines().all(|line| line.chars().count() <= 40), "{text}");
        }
    }
}
