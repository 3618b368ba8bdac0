//! Text for people, CSV and JSON for machines.

use std::collections::BTreeMap;
use std::fmt;

use serde_json::{Number, Value as Json};

use super::row::{COLUMNS, Row, Value};
use crate::cli::{CliError, Format, Io};
use crate::length::{Length, Unit};
use crate::report::columns::names;
use crate::report::csv::cell;
use crate::verdict::Status;

/// Prints the rows of one file after another.
pub(super) struct Printer {
    format: Format,
    is_first: bool,
    /// The table of the text: its columns are as wide as their widest cell, so it is printed at the end.
    table: Vec<[String; 9]>,
    summary: Summary,
}

impl Printer {
    pub(super) fn new(format: Format, io: &mut Io<'_>) -> Result<Self, CliError> {
        match format {
            Format::Text => {}
            Format::Csv => writeln!(io.data(), "{}", names(&COLUMNS).join(","))?,
            Format::Json => write!(io.data(), "[")?,
        }
        Ok(Self { format, is_first: true, table: Vec::new(), summary: Summary::default() })
    }

    pub(super) fn file(&mut self, rows: impl Iterator<Item = Row>, io: &mut Io<'_>) -> Result<(), CliError> {
        match self.format {
            Format::Text => {
                self.text(rows, io);
                Ok(())
            }
            Format::Csv => csv(rows, io),
            Format::Json => self.json(rows, io),
        }
    }

    pub(super) fn end(&self, io: &mut Io<'_>) -> Result<(), CliError> {
        match self.format {
            Format::Text => self.table(io),
            Format::Csv => Ok(()),
            Format::Json => Ok(writeln!(io.data(), "{}]", if self.is_first { "" } else { "\n" })?),
        }
    }

    /// Keeps the verdicts for the table; prints errors to standard error with their places.
    fn text(&mut self, rows: impl Iterator<Item = Row>, io: &mut Io<'_>) {
        for row in rows {
            self.summary.count(&row);
            let Some(line) = row.line else { continue };
            for warning in &row.warnings {
                io.tell(format_args!("{}:{line}: warning: {warning}", row.file));
            }
            if let Some(error) = &row.error {
                let column = row.column.map_or(String::new(), |column| format!(":{column}"));
                io.tell(format_args!("{}:{line}{column}: {error}", row.file));
            }
            if row.measured.is_some() {
                self.table.push(cells(&row));
            }
        }
    }

    fn table(&self, io: &mut Io<'_>) -> Result<(), CliError> {
        if !self.table.is_empty() {
            let mut widths = HEADINGS.map(|heading| heading.chars().count());
            for (width, cell) in self.table.iter().flat_map(|cells| (0..).zip(cells)) {
                if let Some(width) = widths.get_mut(width) {
                    *width = (*width).max(cell.chars().count());
                }
            }
            line(&HEADINGS.map(str::to_owned), &widths, io)?;
            for cells in &self.table {
                line(cells, &widths, io)?;
            }
        }
        writeln!(io.people(), "{}", self.summary)?;
        Ok(())
    }

    fn json(&mut self, rows: impl Iterator<Item = Row>, io: &mut Io<'_>) -> Result<(), CliError> {
        for row in rows {
            // Written by hand, so that the names are in the order of the columns.
            let members: Vec<String> =
                COLUMNS.iter().map(|(name, value)| format!("\"{name}\":{}", value(&row).json())).collect();
            let comma = if self.is_first { "" } else { "," };
            self.is_first = false;
            write!(io.data(), "{comma}\n  {{{}}}", members.join(","))?;
        }
        Ok(())
    }
}

impl Value<'_> {
    fn json(&self) -> Json {
        match self {
            Self::Nothing => Json::Null,
            Self::Text(text) => Json::from(*text),
            // A length has at most 16 figures, so the nearest float is written as the same decimal number.
            Self::Number(number) => number
                .parse::<u64>()
                .map(Number::from)
                .ok()
                .or_else(|| number.parse().ok().and_then(Number::from_f64))
                .map_or(Json::Null, Json::Number),
            Self::Texts(texts) => Json::from(*texts),
        }
    }

    fn csv(&self) -> String {
        match self {
            Self::Nothing => String::new(),
            Self::Text(text) => (*text).to_owned(),
            Self::Number(number) => number.clone(),
            Self::Texts(texts) => texts.join("; "),
        }
    }
}

fn csv(rows: impl Iterator<Item = Row>, io: &mut Io<'_>) -> Result<(), CliError> {
    let mut writer = csv::Writer::from_writer(io.data());
    for row in rows {
        writer.write_record(COLUMNS.map(|(_, value)| cell(&value(&row).csv())))?;
    }
    writer.flush()?;
    Ok(())
}

const HEADINGS: [&str; 9] =
    ["file:line", "id", "callout", "measured mm", "limits mm", "deviation µm", "verdict", "position", "source"];

/// Which columns hold figures and are right-aligned.
const RIGHT: [bool; 9] = [false, false, false, true, false, true, false, false, false];

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
        row.source.clone().unwrap_or_default(),
    ]
}

fn line(cells: &[String; 9], widths: &[usize; 9], io: &mut Io<'_>) -> std::io::Result<()> {
    let padded =
        cells.iter().zip(widths).zip(RIGHT).map(|((cell, &width), right)| {
            if right { format!("{cell:>width$}  ") } else { format!("{cell:<width$}  ") }
        });
    writeln!(io.people(), "{}", padded.collect::<String>().trim_end())
}

/// How many rows had which result.
#[derive(Debug, Default)]
struct Summary {
    rows: usize,
    status: BTreeMap<Status, usize>,
    out_of_position: usize,
    not_judged: usize,
    not_usable: usize,
}

impl Summary {
    fn count(&mut self, row: &Row) {
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
        let others =
            [("position OUT", self.out_of_position), ("not judged", self.not_judged), ("not usable", self.not_usable)];
        let parts = status.chain(others).filter(|(_, count)| 0 < *count);
        let parts: Vec<String> = parts.map(|(name, count)| format!("{count} {name}")).collect();
        write!(f, "{} {}: {}", self.rows, if self.rows == 1 { "row" } else { "rows" }, parts.join(", "))
    }
}
