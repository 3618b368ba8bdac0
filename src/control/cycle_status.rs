//! The status window of a measuring cycle: what a program would hand to its mask after the cycle has run.
//!
//! A diameter is drawn with the mask of program 82551 (NC-Solution 8255): QS2 is the nominal diameter and the cycle,
//! QS3 the status word, Q33 and Q23 the limits, Q153 the measured diameter. Other cycles declare masks of their own, drawn
//! from the parameters that the cycle itself was given and found.

use jiff::civil::DateTime;

use super::mask::{Context, Mask, RenderError};
use super::status::{mask_named, micrometres, shipped_mask, status_word};
use super::variables::{Parameter, Value, Variables};
use crate::probing::cycle::{self, Check, Cycle, CycleResult, FoundName, Key, Meaning, Window};
use crate::words::Dialogue;

/// The shipped mask of a cycle; `None` for a cycle without a status window.
pub fn cycle_mask(cycle: &Cycle, language: Dialogue) -> Option<&'static Mask> {
    match cycle.window {
        Window::None => None,
        Window::Diameter => Some(shipped_mask(language)),
        Window::Own(mask) => mask_named(mask, language),
    }
}

/// The parameters after a cycle has run: all that it was given and all that it found, and what the masks ask for besides.
pub fn cycle_variables(cycle: &Cycle, result: &CycleResult, language: Dialogue) -> Variables {
    let mut variables = Variables::new();
    let given =
        cycle.parameters.iter().filter_map(|parameter| Some((parameter.key, result.inputs.value(parameter.key)?)));
    let found = result.results.iter().map(|found| (found.key, &found.value));
    for (key, value) in given.chain(found) {
        if let Some((parameter, value)) = variable(key, value) {
            variables.set(parameter, value);
        }
    }
    if let Some(status) = result.status {
        variables.set(Parameter::qs(3), Value::Text(status_word(status, language).to_owned()));
    }
    variables.set(Parameter::qs(2), Value::Text(checked(cycle, result)));
    if let Some(check) = diameter(result) {
        set_diameter(cycle, result, check, &mut variables);
    }
    variables
}

/// What program 82551 has of a diameter: nominal size, hole or shaft, deviations in µm, limits. There is no class.
fn set_diameter(cycle: &Cycle, result: &CycleResult, check: &Check, variables: &mut Variables) {
    variables.set(Parameter::qs(1), Value::Text(String::new()));
    variables.set(Parameter::q(33), Value::Length(check.minimum));
    variables.set(Parameter::q(23), Value::Length(check.maximum));
    variables.set(Parameter::q(2), Value::Number(if cycle.shape().is_outside() { 1.0 } else { -1.0 }));
    if let Some(nominal) = cycle.length_of(&result.inputs, Meaning::Diameter) {
        variables.set(Parameter::q(1), Value::Length(nominal));
        variables.set(Parameter::q(4), micrometres(check.maximum.saturating_sub(nominal)));
        variables.set(Parameter::q(5), micrometres(check.minimum.saturating_sub(nominal)));
    }
}

/// The text of the status window, drawn with a mask or with the cycle's own; `None` where nothing was compared with
/// limits, or the cycle has no mask.
///
/// # Errors
/// [`RenderError`] where a user's mask asks for a parameter that the cycle does not set.
pub fn cycle_window(
    cycle: &Cycle,
    result: &CycleResult,
    language: Dialogue,
    mask: Option<&Mask>,
    time: DateTime,
) -> Option<Result<String, RenderError>> {
    // A centre alone has no limits of size to show.
    let has_limits = result.checks.iter().any(|check| !check.what.is_centre());
    // The user's mask is one for diameters.
    let mask = mask.filter(|_| matches!(cycle.window, Window::Diameter)).or_else(|| cycle_mask(cycle, language));
    let mask = mask.filter(|_| has_limits)?;
    let context = Context { language, time, call_path: r"TNC:\82551.h" };
    Some(mask.render(&cycle_variables(cycle, result, language), &context).map(|output| output.text))
}

/// The diameter against its limits.
fn diameter(result: &CycleResult) -> Option<&Check> {
    result.checks.iter().find(|check| check.what == FoundName::DIAMETER)
}

/// What was checked, as QS2 says it: the nominal size or the axis, and the cycle.
fn checked(cycle: &Cycle, result: &CycleResult) -> String {
    match (cycle.subject)(&result.inputs) {
        Some(subject) => format!("{subject} ({})", cycle.code),
        None => cycle.code.to_owned(),
    }
}

/// A parameter of the control; names of a lathe control are none.
fn variable(key: Key, value: &cycle::Value) -> Option<(Parameter, Value)> {
    let parameter = match (key, value) {
        // A tool by its name is a text under the same number.
        (Key::Q(number), cycle::Value::Text(_)) | (Key::Qs(number), _) => Parameter::qs(number),
        (Key::Q(number), _) => Parameter::q(number),
        (Key::Word(_), _) => return None,
    };
    let value = match value {
        cycle::Value::Length(length) => Value::Length(*length),
        cycle::Value::Angle(angle) => Value::Number(angle.to_degrees_f64()),
        // Markers and choices are a few.
        cycle::Value::Whole(whole) => Value::Number(f64::from(i32::try_from(*whole).ok()?)),
        cycle::Value::Number(number) => Value::Number(*number),
        cycle::Value::Text(_) | cycle::Value::Band(_) | cycle::Value::Predef => Value::Text(value.to_string()),
    };
    Some((parameter, value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::probing::cycle::Inputs;
    use crate::probing::cycles::cycle_named;
    use crate::probing::{Contact, Recorded};

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
                let status =
                    [crate::verdict::Status::Good, crate::verdict::Status::Rework, crate::verdict::Status::Scrap]
                        [status];
                let end = format!(": {}", status_word(status, language));
                assert!(text.lines().next().unwrap().ends_with(&end), "{text}");
                assert!(text.lines().count() <= 6 && text.lines().all(|line| line.chars().count() <= 40), "{text}");
            }
        }
    }
}
