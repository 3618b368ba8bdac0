//! Text for people, CSV and JSON for machines.

use std::collections::BTreeMap;
use std::fmt;

use serde_json::{Number, Value as Json};

use super::row::{COLUMNS, Row, Value};
use crate::cli::aligned::{Aligned, Side};
use crate::cli::{CliError, Format, Io, Refused as _};
use crate::length::{Length, Unit};
use crate::report::columns::names;
use crate::report::csv::{CsvLine, More, cell};
use crate::report::json;
use crate::verdict::Status;

/// How many rows decide how wide the columns of the text are; those after them are printed at once.
const MEASURED: usize = 10_000;

/// Prints the rows of one file after another.
pub(in crate::cli) struct Printer {
    format: Format,
    /// The columns besides those of every import.
    more: More,
    is_first: bool,
    line: CsvLine,
    table: Table,
    summary: Summary,
}

impl Printer {
    pub(in crate::cli) fn new(format: Format, more: More, io: &mut Io<'_>) -> Self {
        // Before the first row nobody knows whether a file says that its values were corrected.
        let more = more.with(More::CORRECTED, true);
        match format {
            Format::Text => {}
            Format::Csv => {
                let names: Vec<&str> = names(&COLUMNS).into_iter().chain(more.names()).collect();
                writeln!(io.data(), "{}", names.join(","));
            }
            Format::Json => write!(io.data(), "["),
        }
        let (line, table, summary) = (CsvLine::default(), Table::default(), Summary::default());
        Self { format, more, is_first: true, line, table, summary }
    }

    pub(in crate::cli) fn row(&mut self, row: &Row, io: &mut Io<'_>) -> Result<(), CliError> {
        match self.format {
            Format::Text => {
                self.text(row, io);
                Ok(())
            }
            Format::Csv => {
                for (_, value) in &COLUMNS {
                    value(row).put(&mut self.line);
                }
                match &row.judged {
                    Some(record) => self.more.cells(record).iter().for_each(|text| self.line.cell(&cell(text))),
                    None => self.more.names().for_each(|_name| self.line.cell("")),
                }
                io.data().write_all(self.line.end());
                Ok(())
            }
            Format::Json => self.json(row, io),
        }
    }

    /// What stands against all values of a file is a row for machines, too: people are told it already.
    pub(in crate::cli) fn against(&mut self, row: &Row, io: &mut Io<'_>) -> Result<(), CliError> {
        if self.format == Format::Text { Ok(()) } else { self.row(row, io) }
    }

    pub(in crate::cli) fn end(&mut self, io: &mut Io<'_>) {
        match self.format {
            Format::Text => {
                self.table.print(io);
                writeln!(io.people(), "{}", self.summary);
            }
            Format::Csv => {}
            Format::Json => writeln!(io.data(), "{}]", if self.is_first { "" } else { "\n" }),
        }
    }

    /// Prints what waits for the widths of the columns: nobody waits for it longer.
    pub(in crate::cli) fn flush(&mut self, io: &mut Io<'_>) {
        if self.format == Format::Text {
            self.table.print(io);
        }
        io.data().flush();
    }

    /// Puts the verdict into the table; prints errors to standard error with their places.
    fn text(&mut self, row: &Row, io: &mut Io<'_>) {
        self.summary.count(row);
        // What is missing is named in one sentence.
        let Some(line) = row.line.filter(|_| !row.is_missing) else { return };
        for warning in &row.warnings {
            io.tell(format_args!("{}:{line}: warning: {warning}", row.file));
        }
        if let Some(error) = &row.error {
            let column = row.column.map_or(String::new(), |column| format!(":{column}"));
            io.tell(format_args!("{}:{line}{column}: {error}", row.file));
        }
        if row.measured.is_some() {
            self.table.add(cells(row), io);
        }
    }

    fn json(&mut self, row: &Row, io: &mut Io<'_>) -> Result<(), CliError> {
        // Written by hand, so that the names are in the order of the columns.
        let more = match &row.judged {
            Some(record) => json::more(record, self.more).said()?,
            None => self.more.names().map(|name| (name, Json::Null)).collect(),
        };
        let own = COLUMNS.iter().map(|(name, value)| (*name, value(row).json()));
        let members: Vec<String> = own.chain(more).map(|(name, value)| format!("\"{name}\":{value}")).collect();
        let comma = if self.is_first { "" } else { "," };
        self.is_first = false;
        write!(io.data(), "{comma}\n  {{{}}}", members.join(","));
        Ok(())
    }
}

/// The table of the text: its columns are as wide as their widest cell in the first rows.
#[derive(Default)]
struct Table {
    /// Rows that are not printed yet.
    waiting: Vec<[String; 9]>,
    /// The widths, once a row is printed.
    widths: Option<[usize; 9]>,
}

impl Table {
    fn add(&mut self, cells: [String; 9], io: &mut Io<'_>) {
        if let Some(widths) = &self.widths {
            writeln!(io.people(), "{}", TABLE.line(&cells, widths));
            return;
        }
        self.waiting.push(cells);
        if MEASURED <= self.waiting.len() {
            self.print(io);
        }
    }

    /// Prints the rows that wait.
    fn print(&mut self, io: &mut Io<'_>) {
        if self.waiting.is_empty() {
            return;
        }
        let widths = TABLE.widths(&self.waiting);
        for cells in std::iter::once(TABLE.headings()).chain(self.waiting.drain(..)) {
            writeln!(io.people(), "{}", TABLE.line(&cells, &widths));
        }
        self.widths = Some(widths);
    }
}

impl Value<'_> {
    fn json(&self) -> Json {
        match self {
            Self::Nothing => Json::Null,
            Self::Text(text) => Json::from(*text),
            Self::Count(count) => Json::from(*count),
            Self::Millimetres(length, decimals) => number(&length.exact(Unit::Millimetre, usize::from(*decimals))),
            Self::Micrometres(length) => number(&length.exact(Unit::Micrometre, 0)),
            Self::Texts(texts) => Json::from(*texts),
        }
    }

    /// Puts it into a line of CSV.
    fn put(&self, line: &mut CsvLine) {
        match self {
            Self::Nothing => line.cell(""),
            Self::Text(text) => line.cell(&cell(text)),
            Self::Count(count) => line.cell(&count.to_string()),
            Self::Millimetres(length, decimals) => line.mm(*length, *decimals),
            Self::Micrometres(length) => line.um(*length),
            Self::Texts(texts) => line.cell(&cell(&texts.join("; "))),
        }
    }
}

/// A decimal number: a length has at most 16 figures, so the nearest float is written as the same one.
fn number(text: &str) -> Json {
    let whole = text.parse::<u64>().map(Number::from).ok();
    whole.or_else(|| text.parse().ok().and_then(Number::from_f64)).map_or(Json::Null, Json::Number)
}

const TABLE: Aligned<9> = Aligned {
    columns: [
        ("file:line", Side::Left),
        ("id", Side::Left),
        ("callout", Side::Left),
        ("measured mm", Side::Right),
        ("limits mm", Side::Left),
        ("deviation µm", Side::Right),
        ("verdict", Side::Left),
        ("position", Side::Left),
        ("source", Side::Left),
    ],
    widest: 200,
};

fn cells(row: &Row) -> [String; 9] {
    let mm = |length: Option<Length>| length.map_or(String::new(), |length| length.exact(Unit::Millimetre, 3));
    let limits = match (row.minimum, row.maximum) {
        (Some(minimum), Some(maximum)) => format!("{} to {}", mm(Some(minimum)), mm(Some(maximum))),
        _ => String::new(),
    };
    let um = |length: Length| length.exact(Unit::Micrometre, 0);
    let deviation = row.deviation.map(Length::signed_um).unwrap_or_default();
    let remove = row.remove.map_or(String::new(), |remove| format!(", remove {} µm", um(remove)));
    [
        format!("{}:{}", row.file, row.line.unwrap_or_default()),
        row.id.replace(char::is_control, "\u{fffd}"),
        row.callout.clone().unwrap_or_default(),
        mm(row.measured),
        limits,
        deviation,
        row.status.map_or_else(|| "not judged".to_owned(), |status| format!("{status}{remove}")),
        row.position_word().unwrap_or_default().to_owned(),
        row.source.as_deref().unwrap_or_default().to_owned(),
    ]
}

/// How many rows had which result.
#[derive(Debug, Default)]
struct Summary {
    rows: usize,
    status: BTreeMap<Status, usize>,
    out_of_position: usize,
    not_judged: usize,
    not_usable: usize,
    missing: usize,
}

impl Summary {
    fn count(&mut self, row: &Row) {
        if row.is_missing {
            self.missing += 1;
            return;
        }
        self.rows += 1;
        if let Some(status) = row.status {
            *self.status.entry(status).or_default() += 1;
        }
        self.out_of_position += usize::from(row.position_word() == Some("OUT"));
        self.not_judged += usize::from(row.error.is_some() && row.measured.is_some());
        self.not_usable += usize::from(row.error.is_some() && row.measured.is_none());
    }
}

/// `3 rows: 1 GOOD, 1 REWORK, 1 position OUT, 1 not usable`.
impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let status = self.status.iter().map(|(status, &count)| (status.word(), count));
        let others = [
            ("position OUT", self.out_of_position),
            ("not judged", self.not_judged),
            ("not usable", self.not_usable),
            ("missing", self.missing),
        ];
        let parts = status.chain(others).filter(|(_, count)| 0 < *count);
        let parts: Vec<String> = parts.map(|(name, count)| format!("{count} {name}")).collect();
        write!(f, "{} {}: {}", self.rows, if self.rows == 1 { "row" } else { "rows" }, parts.join(", "))
    }
}
