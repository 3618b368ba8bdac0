//! What a fault says, in every language.

use super::FaultKind;
use crate::control::variables::Parameter;
use crate::message::{Message, Say};

impl Say for FaultKind {
    fn message(&self) -> Message {
        let of = |id, parameter: &Parameter| Message::new(id).text("parameter", parameter);
        match self {
            Self::UsedUp(used) => used.message(),
            Self::TextTooLong { length, most } => {
                Message::new("machine-text-too-long").text("length", length).text("most", most)
            }
            Self::UnknownBlock => Message::new("machine-unknown-block"),
            Self::UnknownCycle { cycle, known } => {
                Message::new("machine-unknown-cycle").text("cycle", cycle).text("known", known)
            }
            Self::Broken { what } => Message::new("machine-broken").text("what", what),
            Self::NoProgram { path, error } => {
                Message::new("machine-at-file").text("path", path).message("error", error.message())
            }
            Self::Label(fault) => fault.message(),
            Self::NoLabel { parameter, value } => of("machine-no-label", parameter).text("value", value),
            Self::Undefined(parameter) => of("machine-undefined", parameter),
            Self::NoParameter(parameter) => of("machine-no-parameter", parameter),
            Self::NotNumber(parameter) => of("machine-not-number", parameter),
            Self::NotText(parameter) => of("machine-not-text", parameter),
            Self::Path(error) => error.message(),
            Self::Store(error) => error.message(),
            Self::Programmed(number) => Message::new("machine-programmed").text("number", number),
            Self::NoCycleParameter { cycle, parameter } => {
                of("machine-no-cycle-parameter", parameter).text("cycle", cycle)
            }
            Self::CycleParameterTwice { cycle, parameter } => {
                of("machine-cycle-parameter-twice", parameter).text("cycle", cycle)
            }
            Self::Cycle { cycle, error } => {
                Message::new("machine-in-cycle").text("cycle", cycle).message("error", error.message())
            }
            Self::Workpiece(error) => Message::new("machine-workpiece").message("error", error.message()),
            Self::Inch => Message::new("machine-inch"),
            Self::Mask { mask, error } => {
                Message::new("machine-mask").text("mask", mask).message("error", error.message())
            }
            Self::Render { mask, error } => {
                Message::new("machine-mask").text("mask", mask).message("error", error.message())
            }
            _ => self.number_message().or_else(|| self.table_message()).unwrap_or(Message::new("machine-no-table")),
        }
    }
}

impl FaultKind {
    fn number_message(&self) -> Option<Message> {
        Some(match self {
            Self::DivisionByZero => Message::new("machine-division-by-zero"),
            Self::NegativeRoot(value) => Message::new("machine-negative-root").text("value", value),
            Self::NoResult { function, value } => {
                Message::new("machine-no-result").text("function", function).text("value", value)
            }
            Self::BeyondRange(value) => Message::new("machine-beyond-range").text("value", value),
            Self::NotWhole { what, value } => Message::new("machine-not-whole").text("what", what).text("value", value),
            Self::BehindText { length, from } => {
                Message::new("machine-behind-text").text("length", length).text("from", from)
            }
            Self::NoNumberInText { parameter, text } => {
                Message::new("machine-no-number-in-text").text("parameter", parameter).text("text", text)
            }
            Self::UnknownSystemText { id, number } => {
                Message::new("machine-unknown-system-text").text("id", id).text("number", number)
            }
            _ => return None,
        })
    }

    fn table_message(&self) -> Option<Message> {
        let cell = |id, table: &str, row: &usize, column: &str| {
            Message::new(id).text("table", table).text("row", row).text("column", column)
        };
        Some(match self {
            Self::NoTable => Message::new("machine-no-table"),
            Self::Table(error) => error.message(),
            Self::NoColumn { table, column, columns } => {
                Message::new("machine-no-column").text("table", table).text("column", column).text("columns", columns)
            }
            Self::NoRow { table, row, last } => {
                Message::new("machine-no-row").text("table", table).text("row", row).text("last", last)
            }
            Self::NoRows(table) => Message::new("machine-no-rows").text("table", table),
            Self::EmptyCell { table, row, column } => cell("machine-empty-cell", table, row, column),
            Self::NoNumberInCell { table, row, column, cell: text } => {
                cell("machine-no-number-in-cell", table, row, column).text("cell", text)
            }
            Self::Touches { table, row, column } => cell("machine-touches", table, row, column),
            Self::TableWrite { table, error } => {
                Message::new("machine-table-write").text("table", table).message("error", error.message())
            }
            _ => return None,
        })
    }
}
