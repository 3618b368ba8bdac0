//! From the fields to a measurement and a record.

use jiff::civil::DateTime;

use super::asked::Asked;
use super::inputs::{Field, Inputs, MeasureBy};
use super::Notice;
use crate::exchange::Imported;
use crate::journal::Record;
use crate::length::LengthError;
use crate::probing::{Contact, Measurement, Origin};
use crate::report::{RENDERINGS, Report};
use crate::verdict;
use crate::words::{Language, Message, Say as _, Words};

/// Measures as the fields say. What is refused names the field.
pub(super) fn measure(inputs: &Inputs, asked: &Asked, now: DateTime) -> Result<Record, (Field, Message)> {
    let Some(limits) = asked.limits() else {
        // An error beside the callout says more than "no limits".
        let problem = asked.error(Field::Callout).cloned();
        return Err((Field::Callout, problem.unwrap_or_else(|| Message::new("measured-needs-limits"))));
    };
    let measurement = match inputs.by {
        _ => typed(asked)?,
    };
    let measured = measurement.diameter;
    Ok(Record {
        time: now,
        id: inputs.text(Field::Part).trim().to_owned(),
        callout: asked.callout(),
        limits: limits.clone(),
        verdict: verdict::judge(limits, measured, None),
        doubt: verdict::doubt(limits.nominal, measured),
        measurement,
    })
}

fn typed(asked: &Asked) -> Result<Measurement, (Field, Message)> {
    if let Some(diameter) = asked.length(Field::Measured) {
        return Ok(Measurement::of_diameter(diameter, Origin::Typed));
    }
    let problem = asked.error(Field::Measured).cloned();
    Err((Field::Measured, problem.unwrap_or_else(|| LengthError::Empty.message())))
}

pub(super) fn export(_format: usize, _records: Vec<Record>, _language: Language, _now: DateTime) -> Vec<u8> { Vec::new() }
pub(super) fn import_notice(_name: &str, _imported: &Imported) -> Notice { todo!() }
pub(super) fn judge_contacts(_name: &str, _contacts: Vec<Contact>, _asked: &Asked, _now: DateTime) -> Result<Record, Message> { todo!() }
