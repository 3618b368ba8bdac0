//! Text for people, CSV and JSON for machines.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Serialize, Serializer};
use serde_json::{Map, Number, Value as Json};

use super::row::{ImportRow, RowKind};
use crate::cli::people::{Aligned, Side, mm, um};
use crate::cli::rows::{Columns, csv_line, names};
use crate::cli::{CliError, Format, IntoCliError as _, Io};
use crate::length::{Length, Unit};
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
                let more = more.names().map(str::to_owned);
                csv_line(names::<Printed<'_>>().into_iter().chain(more), io);
            }
            Format::Json => write!(io.data(), "["),
        }
        let line = CsvLine::default();
        let table = Table::default();
        let summary = Summary::default();
        Self { format, more, is_first: true, line, table, summary }
    }

    pub(in crate::cli) fn row(&mut self, row: &ImportRow, io: &mut Io<'_>) -> Result<(), CliError> {
        match self.format {
            Format::Text => {
                self.text(row, io);
                Ok(())
            }
            Format::Csv => {
                Printed::put(Some(&Printed::of(row, Map::new())), &mut self.line);
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
    pub(in crate::cli) fn against(&mut self, row: &ImportRow, io: &mut Io<'_>) -> Result<(), CliError> {
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
    fn text(&mut self, row: &ImportRow, io: &mut Io<'_>) {
        self.summary.count(row);
        // What is missing is named in one sentence.
        let Some(line) = row.line.filter(|_| row.kind != RowKind::Missing) else { return };
        for warning in &row.warnings {
            io.tell(format_args!("{}:{line}: warning: {warning}", row.file));
        }
        if let Some(error) = &row.error {
            let column = row.column.map_or(String::new(), |column| format!(":{column}"));
            io.tell(format_args!("{}:{line}{column}: {error}", row.file));
        }
        if row.kind == RowKind::Measured {
            self.table.add(cells(row), io);
        }
    }

    fn json(&mut self, row: &ImportRow, io: &mut Io<'_>) -> Result<(), CliError> {
        let more = match &row.judged {
            Some(record) => json::more(record, self.more).said()?,
            None => self.more.names().map(|name| (name, Json::Null)).collect(),
        };
        let more = more.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
        write!(io.data(), "{}\n  ", if self.is_first { "" } else { "," });
        self.is_first = false;
        io.data().write_json(&Printed::of(row, more));
        Ok(())
    }
}

row! {
    /// A row for programs.
    pub(super) struct Printed<'a> of(row: &'a ImportRow, more: Map<String, Json>) {
        file: &'a str = &row.file,
        line: Option<usize> = row.line,
        id: &'a str = &row.id,
        callout: Option<&'a str> = row.callout.as_deref(),
        nominal_mm: Option<Mm<0>> = row.nominal.map(Mm),
        min_mm: Option<Mm<3>> = row.minimum.map(Mm),
        max_mm: Option<Mm<3>> = row.maximum.map(Mm),
        measured_mm: Option<Mm<3>> = row.measured.map(Mm),
        deviation_um: Option<Um> = row.deviation.map(Um),
        status: Option<Status> = row.status,
        remove_um: Option<Um> = row.remove.map(Um),
        position: Option<&'static str> = row.position_word(),
        source: Option<&'a str> = row.source.as_deref(),
        warnings: Texts<'a> = Texts(&row.warnings),
        error: Option<&'a str> = row.error.as_deref(),
        simulated: Option<&'static str> = Some(if row.is_simulated? { "true" } else { "false" });
        json:
        #[serde(flatten)]
        more: Map<String, Json> = more,
    }
}

/// Millimetres exactly, with at least so many decimals.
#[derive(Debug)]
struct Mm<const DECIMALS: u8>(Length);

impl<const DECIMALS: u8> Columns for Mm<DECIMALS> {
    fn put(of: Option<&Self>, line: &mut CsvLine) {
        match of {
            Some(length) => line.mm(length.0, DECIMALS),
            None => line.cell(""),
        }
    }
}

impl<const DECIMALS: u8> Serialize for Mm<DECIMALS> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        number(&self.0.exact(Unit::Millimetre, usize::from(DECIMALS))).serialize(serializer)
    }
}

/// Micrometres exactly.
#[derive(Debug)]
struct Um(Length);

impl Columns for Um {
    fn put(of: Option<&Self>, line: &mut CsvLine) {
        match of {
            Some(length) => line.um(length.0),
            None => line.cell(""),
        }
    }
}

impl Serialize for Um {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        number(&um(self.0)).serialize(serializer)
    }
}

/// Several texts in one column.
#[derive(Debug, Serialize)]
struct Texts<'a>(&'a [String]);

impl Columns for Texts<'_> {
    fn put(of: Option<&Self>, line: &mut CsvLine) {
        line.cell(&cell(&of.map_or_else(String::new, |texts| texts.0.join("; "))));
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

fn cells(row: &ImportRow) -> [String; 9] {
    let limits = match (row.minimum, row.maximum) {
        (Some(minimum), Some(maximum)) => format!("{} to {}", mm(minimum), mm(maximum)),
        _ => String::new(),
    };
    let deviation = row.deviation.map_or_else(String::new, Length::signed_um);
    let remove = row.remove.map_or(String::new(), |remove| format!(", remove {} µm", um(remove)));
    [
        row.line.map_or_else(|| row.file.to_string(), |line| format!("{}:{line}", row.file)),
        row.id.replace(char::is_control, "\u{fffd}"),
        row.callout.as_ref().map_or_else(String::new, Clone::clone),
        row.measured.map_or_else(String::new, mm),
        limits,
        deviation,
        row.status.map_or_else(|| "not judged".to_owned(), |status| format!("{status}{remove}")),
        row.position_word().map_or_else(String::new, str::to_owned),
        row.source.as_deref().map_or_else(String::new, str::to_owned),
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
    fn count(&mut self, row: &ImportRow) {
        if row.kind == RowKind::Missing {
            self.missing += 1;
            return;
        }
        self.rows += 1;
        if let Some(status) = row.status {
            *self.status.entry(status).or_default() += 1;
        }
        self.out_of_position += usize::from(row.position_word() == Some("OUT"));
        self.not_judged += usize::from(row.error.is_some() && row.kind == RowKind::Measured);
        self.not_usable += usize::from(row.error.is_some() && row.kind == RowKind::Refused);
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
