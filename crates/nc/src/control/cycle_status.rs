//! The status window of a measuring cycle: what a program would pass to its mask after the cycle has run.
//!
//! A diameter is drawn with the mask of program 82551 (NC-Solution 8255): QS2 is the nominal diameter and the cycle,
//! QS3 the status word, Q33 and Q23 the limits, Q153 the measured diameter. Other cycles declare masks of their own,
//! drawn from the parameters and results of the cycle.

use fitcheck_core::probing::cycle::{self, Check, Cycle, CycleResult, Key, Meaning, ResultName, Window};
use fitcheck_core::words::Dialogue;
use jiff::civil::DateTime;

use super::mask::{Context, Mask, RenderError};
use super::status::{mask_named, micrometres, shipped_mask, status_word};
use super::variables::{Parameter, Value, Variables};

/// The built-in mask of a cycle; `None` for a cycle without a status window.
pub fn cycle_mask(cycle: &Cycle, language: Dialogue) -> Option<&'static Mask> {
    match cycle.window {
        Window::None => None,
        Window::Diameter => Some(shipped_mask(language)),
        Window::Own(mask) => mask_named(mask, language),
    }
}

/// The parameters after a cycle has run: all that it was given, all that it found, and whatever else the masks need.
pub fn cycle_variables(cycle: &Cycle, result: &CycleResult, language: Dialogue) -> Variables {
    let mut variables = Variables::new();
    let given =
        cycle.parameters.iter().filter_map(|parameter| Some((parameter.key, result.inputs.value(parameter.key)?)));
    let found = result.results.iter().filter_map(|found| Some((found.key?, &found.value)));
    for (key, value) in given.chain(found) {
        if let Some((parameter, value)) = variable(key, value) {
            variables.set(parameter, value);
        }
    }
    if let Some(status) = result.status {
        variables.set(Parameter::qs(3), Value::Text(status_word(status, language).to_owned()));
    }
    variables.set(Parameter::qs(2), Value::Text(checked(cycle, result)));
    if let Some(check) = result.checks.iter().find(|check| check.what == ResultName::DIAMETER) {
        set_diameter(cycle, result, check, &mut variables);
    }
    variables
}

/// The parameters of program 82551 for a diameter: nominal size, hole or shaft, deviations in µm, limits. No class.
fn set_diameter(cycle: &Cycle, result: &CycleResult, check: &Check, variables: &mut Variables) {
    let is_outside = (cycle.surface)(&result.inputs).shape().is_outside();
    variables.set(Parameter::qs(1), Value::Text(String::new()));
    variables.set(Parameter::q(33), Value::Length(check.minimum));
    variables.set(Parameter::q(23), Value::Length(check.maximum));
    variables.set(Parameter::q(2), Value::Number(if is_outside { 1.0 } else { -1.0 }));
    if let Some(nominal) = cycle.length_of(&result.inputs, Meaning::Diameter) {
        variables.set(Parameter::q(1), Value::Length(nominal));
        variables.set(Parameter::q(4), micrometres(check.maximum.saturating_sub(nominal)));
        variables.set(Parameter::q(5), micrometres(check.minimum.saturating_sub(nominal)));
    }
}

/// The text of the status window, drawn with a mask or with the cycle's own; `None` if nothing was compared with
/// limits, or if the cycle has no mask.
///
/// # Errors
/// [`RenderError`] if a user's mask contains a parameter that the cycle does not set.
pub fn cycle_window(
    cycle: &Cycle,
    result: &CycleResult,
    language: Dialogue,
    mask: Option<&Mask>,
    time: DateTime,
) -> Option<Result<String, RenderError>> {
    // A centre alone has no limits of size to show.
    let has_limits = result.checks.iter().any(|check| !check.what.is_centre());
    // The user's mask is for diameters.
    let mask = mask.filter(|_| matches!(cycle.window, Window::Diameter)).or_else(|| cycle_mask(cycle, language));
    let mask = mask.filter(|_| has_limits)?;
    let context = Context { language, time, call_path: r"TNC:\82551.h" };
    Some(mask.render(&cycle_variables(cycle, result, language), &context).map(|output| output.text))
}

/// What was checked, as in QS2: the nominal size or the axis, and the cycle.
fn checked(cycle: &Cycle, result: &CycleResult) -> String {
    match (cycle.subject)(&result.inputs) {
        Some(subject) => format!("{subject} ({})", cycle.code),
        None => cycle.code.to_owned(),
    }
}

/// A parameter of the control with its value; `None` for the letters of a lathe control.
pub(crate) fn variable(key: Key, value: &cycle::Value) -> Option<(Parameter, Value)> {
    let parameter = match (key, value) {
        // A tool name is a text under the same number.
        (Key::Q(number), cycle::Value::Text(_)) | (Key::Qs(number), _) => Parameter::qs(number),
        (Key::Q(number), _) => Parameter::q(number),
        (Key::Word(word), _) => word.parse().ok()?,
    };
    let value = match value {
        cycle::Value::Length(length) => Value::Length(*length),
        cycle::Value::Angle(angle) => Value::Number(angle.to_degrees_f64()),
        // Markers and choices are small numbers.
        cycle::Value::Whole(whole) => Value::Number(f64::from(i32::try_from(*whole).ok()?)),
        cycle::Value::Number(number) => Value::Number(*number),
        cycle::Value::Text(_) | cycle::Value::Band(_) | cycle::Value::Nominal(_) | cycle::Value::Predef => {
            Value::Text(value.to_string())
        }
    };
    Some((parameter, value))
}
