//! The status window of a record: the parameters that program 82551 passes to its mask.
//!
//! The parameters are those of NC-Solution 8255 (description of 7/2020): QS2 is the nominal size with only the decimals it
//! has, a blank and the class; QS3 the status word; Q33 and Q23 the limits; Q153 the measured diameter.

use fitcheck_core::tolerance::Feature;
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Dialogue;
use fitcheck_nc::control::mask::{Context, Mask, RenderError};
use fitcheck_nc::control::status::{micrometres, shipped_mask, status_word};
use fitcheck_nc::control::variables::{Parameter, Value, Variables};

use super::Record;

/// The parameters after program 82551 has run on a record.
pub fn status_variables(record: &Record, dialogue: Dialogue) -> Variables {
    let mut variables = Variables::new();
    let limits = &record.limits;
    let number = Value::Number;
    let length = Value::Length;
    let um = micrometres;
    let mut set = |parameter, value| variables.set(parameter, value);
    let class = record.callout.and_then(|callout| callout.class()).map_or_else(String::new, |class| class.to_string());
    let fit = record.callout.map_or_else(|| limits.nominal.to_string(), |callout| callout.to_string());
    set(Parameter::q(1), length(limits.nominal));
    set(Parameter::qs(1), Value::Text(class));
    if let Some(feature) = limits.feature {
        set(Parameter::q(2), number(if feature == Feature::Hole { -1.0 } else { 1.0 }));
    }
    set(Parameter::qs(2), Value::Text(fit));
    set(Parameter::q(4), um(limits.deviations.upper()));
    set(Parameter::q(5), um(limits.deviations.lower()));
    set(Parameter::q(23), length(limits.maximum()));
    set(Parameter::q(33), length(limits.minimum()));
    let status = record.verdict.status();
    set(Parameter::qs(3), Value::Text(status_word(status, dialogue).to_owned()));
    if let Some([x, y]) = record.measurement.centre {
        set(Parameter::q(151), length(x));
        set(Parameter::q(152), length(y));
    }
    set(Parameter::q(153), length(record.measurement.diameter));
    if let Some(position) = record.verdict.position {
        let [x, y] = position.axes;
        set(Parameter::q(161), length(x.deviation));
        set(Parameter::q(162), length(y.deviation));
    }
    set(Parameter::q(163), length(record.verdict.size.deviation));
    for (marker, marked) in [(180, Status::Good), (181, Status::Rework), (182, Status::Scrap)] {
        set(Parameter::q(marker), number(if status == marked { 1.0 } else { 0.0 }));
    }
    variables
}

/// The text of the status window for a record, made with the given mask or with the dialogue's own.
///
/// # Errors
/// [`RenderError`] where a user's mask asks for a parameter that the check does not set.
pub fn status_window(record: &Record, dialogue: Dialogue, mask: Option<&Mask>) -> Result<String, RenderError> {
    let variables = status_variables(record, dialogue);
    let context = Context { language: dialogue, time: record.time, call_path: r"TNC:\82551.h" };
    mask.unwrap_or_else(|| shipped_mask(dialogue)).render(&variables, &context).map(|output| output.text)
}
