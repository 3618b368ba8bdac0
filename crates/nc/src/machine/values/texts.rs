//! Formulas that give a text.

use super::super::fault::{Counted, FaultKind};
use super::{Values, whole};
use crate::control::variables::Parameter;
use crate::program::{Operand, TextExpression, TextOperand};

/// Paths of programs: 1 is that of the main program (from memory).
const PROGRAM: usize = 10_010;

/// Date and time.
const DATE_AND_TIME: usize = 10_321;

/// The formats of date and time by their number, as far as known: from memory, a control may differ.
const FORMATS: [&str; 17] = [
    "%d.%m.%Y %H:%M:%S",
    "%-d.%m.%Y %-H:%M:%S",
    "%-d.%m.%Y %-H:%M",
    "%-d.%m.%y %-H:%M",
    "%Y-%m-%d %H:%M:%S",
    "%Y-%m-%d %H:%M",
    "%Y-%m-%d %-H:%M",
    "%y-%m-%d %-H:%M",
    "%d.%m.%Y",
    "%-d.%m.%Y",
    "%-d.%m.%y",
    "%Y-%m-%d",
    "%y-%m-%d",
    "%H:%M:%S",
    "%-H:%M:%S",
    "%-H:%M",
    "%d.%m.%Y %H:%M",
];

/// The most digits after the point that a number may have in a text.
const MOST_DECIMALS: usize = 9;

impl Values {
    pub(in crate::machine) fn evaluate_text(&self, formula: &TextExpression) -> Result<String, FaultKind> {
        match formula {
            TextExpression::Value(operand) => Ok(self.text_operand(operand)?.to_owned()),
            TextExpression::Join(items) => {
                let mut text = String::new();
                for item in items {
                    text.push_str(&self.evaluate_text(item)?);
                    self.check_length(&text)?;
                }
                Ok(text)
            }
            TextExpression::FromNumber { number, decimals } => self.text_of_number(*number, *decimals),
            TextExpression::Part { source, from, length } => self.part(*source, *from, *length),
            TextExpression::System { id, number } => self.system_text(*id, *number),
        }
    }

    /// TOCHAR: with this many decimals, rounded half away from zero; if not given, as many as the value has.
    fn text_of_number(&self, number: Operand, decimals: Option<Operand>) -> Result<String, FaultKind> {
        let decimals = decimals.map(|decimals| self.whole(Counted::Word("DECIMALS"), decimals)).transpose()?;
        if let Some(value) = decimals.filter(|decimals| MOST_DECIMALS < *decimals) {
            let value = f64::from(u32::try_from(value).unwrap_or(u32::MAX));
            return Err(FaultKind::NoResult { function: "DECIMALS", value });
        }
        self.decimal(number, decimals)
    }

    /// SUBSTR: it may begin at the end of the text and end after it, but not begin after it.
    fn part(&self, source: Parameter, from: Operand, length: Option<Operand>) -> Result<String, FaultKind> {
        let text = self.text(source)?;
        let from = self.whole(Counted::Word("BEG"), from)?;
        let length = length.map_or(Ok(usize::MAX), |length| self.whole(Counted::Word("LEN"), length))?;
        let characters = text.chars().count();
        if characters < from {
            return Err(FaultKind::BehindText { length: characters, from });
        }
        Ok(text.chars().skip(from).take(length).collect())
    }

    /// SYSSTR.
    fn system_text(&self, id: Operand, number: Operand) -> Result<String, FaultKind> {
        let id = self.operand(id)?;
        let number = self.operand(number)?;
        if whole(id) == Some(PROGRAM) && whole(number) == Some(1) {
            return Ok(self.main.to_string());
        }
        let format = whole(id)
            .filter(|id| *id == DATE_AND_TIME)
            .and_then(|_| FORMATS.get(whole(number)?))
            .ok_or(FaultKind::UnknownSystemText { id, number })?;
        Ok(self.time.strftime(format).to_string())
    }
}

/// Whether a text formula contains a parameter.
pub(super) fn text_reads(formula: &TextExpression, wanted: Parameter) -> bool {
    match formula {
        TextExpression::Value(TextOperand::Parameter(parameter)) => *parameter == wanted,
        TextExpression::Join(items) => items.iter().any(|item| text_reads(item, wanted)),
        TextExpression::Part { source, .. } => *source == wanted,
        TextExpression::Value(TextOperand::Text(_))
        | TextExpression::FromNumber { .. }
        | TextExpression::System { .. } => false,
    }
}
