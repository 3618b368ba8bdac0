//! `fitcheck cycle 427 --list`: the declaration of a cycle.

use super::super::rows::{Columns, csv};
use super::{Format, Io};
use crate::probing::cycle::{Cycle, Inputs, Parameter, Unset, Value};
use crate::report::csv::CsvLine;
use crate::words::{Dialogue, Words};

object! {
    /// A cycle with its parameters.
    struct Listed of(cycle: &Cycle, language: Dialogue) {
        cycle: &'static str = cycle.code,
        name: &'static str = cycle.name(language),
        notes: Vec<String> = cycle.notes.iter().map(ToString::to_string).collect(),
        parameters: Vec<ParameterRow> = rows(cycle, language),
    }
}

/// A text that may begin with a sign and is no formula.
#[derive(Debug, serde::Serialize)]
struct Plain(String);

impl Columns for Plain {
    fn put(of: Option<&Self>, line: &mut CsvLine) {
        line.cell(of.map_or("", |text| &text.0));
    }
}

row! {
    /// One parameter.
    struct ParameterRow of(parameter: &Parameter, language: Dialogue) {
        key: String = parameter.key.to_string(),
        name: &'static str = parameter.name_in(language),
        question: &'static str = parameter.question(language),
        unit: Option<&'static str> = parameter.range.unit(),
        range: Plain = Plain(parameter.range.short().to_string()),
        default: Option<Plain> = Some(Plain(parameter.default_value()?.to_string())),
        required: bool = parameter.unset == Unset::Refused,
        predef: bool = parameter.may_be_predef,
        effect: bool = parameter.has_effect,
    }
}

impl ParameterRow {
    /// The value that is used when it is not given.
    fn unset(&self) -> &str {
        match &self.default {
            Some(Plain(default)) => default,
            None if self.required => "required",
            None => "may be left out",
        }
    }
}

fn rows(cycle: &Cycle, language: Dialogue) -> Vec<ParameterRow> {
    cycle.parameters.iter().map(|parameter| ParameterRow::of(parameter, language)).collect()
}

/// Another default where another parameter has a certain value.
fn otherwise(parameter: &Parameter) -> Option<String> {
    let other = parameter.unset_where?;
    let inputs = Inputs::new().with(other.key, Value::Whole(other.is));
    Some(format!(", {} with {} = {}", parameter.default_with(&inputs)?, other.key, other.is))
}

pub(super) fn print(cycle: &Cycle, language: Dialogue, format: Format, io: &mut Io<'_>) {
    let rows = rows(cycle, language);
    match format {
        Format::Json => io.json(&Listed::of(cycle, language)),
        Format::Csv => csv(rows, io),
        Format::Text => {
            writeln!(io.people(), "{} {}", cycle.code, cycle.name(language));
            let width = rows.iter().map(|row| row.question.chars().count()).fold(0, usize::max);
            for (row, parameter) in rows.iter().zip(cycle.parameters) {
                let unit = row.unit.unwrap_or("");
                let predef = if row.predef { ", or PREDEF" } else { "" };
                let effect = if row.effect { "" } else { "   no effect" };
                let key = &row.key;
                let question = row.question;
                let range = &row.range.0;
                let unset = row.unset();
                let line = format!("  {key:<6} {question:<width$}  {unset:<16} {range} {unit}");
                let otherwise = otherwise(parameter);
                let otherwise = otherwise.as_deref().unwrap_or("");
                writeln!(io.people(), "{}{predef}{otherwise}{effect}", line.trim_end());
            }
            let words = Words::new(language.language());
            for note in cycle.notes {
                writeln!(io.people(), "note: {}", words.told(note));
            }
        }
    }
}
