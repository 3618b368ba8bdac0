//! `fitcheck cycle 427 --list`: the declaration of a cycle.

use serde::Serialize;

use super::{CliError, Format, Io};
use crate::probing::cycle::{Cycle, Inputs, Parameter, Unset, Value};
use crate::words::{Dialogue, Words};

/// A cycle with its parameters; its names must not change.
#[derive(Debug, Serialize)]
struct Listed<'a> {
    cycle: &'static str,
    name: &'static str,
    notes: Vec<String>,
    parameters: &'a [Row],
}

/// One parameter; its names must not change.
#[derive(Debug, Serialize)]
struct Row {
    key: String,
    name: &'static str,
    question: &'static str,
    unit: Option<&'static str>,
    range: String,
    default: Option<String>,
    required: bool,
    predef: bool,
    effect: bool,
    /// Another default where another parameter has a certain value, for people.
    #[serde(skip)]
    otherwise: Option<String>,
}

impl Row {
    fn of(parameter: &Parameter, language: Dialogue) -> Self {
        Self {
            key: parameter.key.to_string(),
            name: parameter.name_in(language),
            question: parameter.question(language),
            unit: parameter.range.unit(),
            range: parameter.range.short().to_string(),
            default: parameter.default_value().map(|value| value.to_string()),
            required: parameter.unset == Unset::Refused,
            predef: parameter.may_be_predef,
            effect: parameter.has_effect,
            otherwise: parameter.unset_where.and_then(|other| {
                let inputs = Inputs::new().with(other.key, Value::Whole(other.is));
                Some(format!("{} with {} = {}", parameter.default_with(&inputs)?, other.key, other.is))
            }),
        }
    }

    /// The value that is used when it is not given.
    fn unset(&self) -> &str {
        match &self.default {
            Some(default) => default,
            None if self.required => "required",
            None => "may be left out",
        }
    }
}

pub(super) fn print(cycle: &Cycle, language: Dialogue, format: Format, io: &mut Io<'_>) -> Result<(), CliError> {
    let rows: Vec<_> = cycle.parameters.iter().map(|parameter| Row::of(parameter, language)).collect();
    match format {
        Format::Json => {
            let notes = cycle.notes.iter().map(ToString::to_string).collect();
            io.json(&Listed { cycle: cycle.code, name: cycle.name(language), notes, parameters: &rows })?;
        }
        Format::Csv => {
            let mut writer = csv::Writer::from_writer(io.data());
            for row in &rows {
                writer.serialize(row)?;
            }
            writer.flush()?;
        }
        Format::Text => {
            writeln!(io.people(), "{} {}", cycle.code, cycle.name(language));
            let width = rows.iter().map(|row| row.question.chars().count()).max().unwrap_or_default();
            for row in &rows {
                let unit = row.unit.unwrap_or_default();
                let predef = if row.predef { ", or PREDEF" } else { "" };
                let effect = if row.effect { "" } else { "   no effect" };
                let (key, question, range, unset) = (&row.key, row.question, &row.range, row.unset());
                let line = format!("  {key:<6} {question:<width$}  {unset:<16} {range} {unit}");
                let otherwise = row.otherwise.as_ref().map(|other| format!(", {other}")).unwrap_or_default();
                writeln!(io.people(), "{}{predef}{otherwise}{effect}", line.trim_end());
            }
            let words = Words::new(language.language());
            for note in cycle.notes {
                writeln!(io.people(), "note: {}", words.told(note));
            }
        }
    }
    Ok(())
}
