//! Text for people, CSV and JSON for machines.

use std::path::Path;

use serde_json::{Number, Value as Json};

use super::row::{COLUMNS, Row, Value};
use crate::cli::{CliError, Format, Io};
use crate::length::{Length, Unit};
use crate::verdict::Status;

/// Prints the rows of one file after the other.
pub(super) struct Printer {
    format: Format,
    is_first: bool,
}

impl Printer {
    pub(super) fn new(format: Format, io: &mut Io<'_>) -> Result<Self, CliError> {
        match format {
            Format::Text => {}
            Format::Csv => writeln!(io.out, "{}", COLUMNS.join(","))?,
            Format::Json => write!(io.out, "[")?,
        }
        Ok(Self { format, is_first: true })
    }

    pub(super) fn file(&mut self, path: &Path, rows: &[Row], io: &mut Io<'_>) -> Result<(), CliError> {
        match self.format {
            Format::Text => text(path, rows, io),
            Format::Csv => csv(rows, io),
            Format::Json => self.json(rows, io),
        }
    }

    pub(super) fn end(&self, io: &mut Io<'_>) -> Result<(), CliError> {
        if self.format == Format::Json {
            writeln!(io.out, "{}]", if self.is_first { "" } else { "\n" })?;
        }
        Ok(())
    }

    fn json(&mut self, rows: &[Row], io: &mut Io<'_>) -> Result<(), CliError> {
        for row in rows {
            // Written by hand, so that the names stand in the order of the columns.
            let members = COLUMNS.iter().zip(row.values());
            let members: Vec<String> = members.map(|(name, value)| format!("\"{name}\": {}", value.json())).collect();
            let comma = if self.is_first { "" } else { "," };
            self.is_first = false;
            write!(io.out, "{comma}\n{{{}}}", members.join(", "))?;
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

fn csv(rows: &[Row], io: &mut Io<'_>) -> Result<(), CliError> {
    let mut writer = csv::Writer::from_writer(&mut *io.out);
    for row in rows {
        writer.write_record(row.values().map(|value| value.csv())).map_err(stream)?;
    }
    writer.flush()?;
    Ok(())
}

/// A closed pipe stays one.
fn stream(error: csv::Error) -> CliError {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => CliError::Stream(error),
        other => CliError::Data(format!("{other:?}")),
    }
}

const HEADINGS: [&str; 9] =
    ["line", "id", "callout", "measured mm", "limits mm", "deviation µm", "verdict", "position", "source"];

/// Which columns hold figures and stand to the right.
const RIGHT: [bool; 9] = [true, false, false, true, false, true, false, false, false];

/// A table of the verdicts, and the problems on standard error with their places.
fn text(path: &Path, rows: &[Row], io: &mut Io<'_>) -> Result<(), CliError> {
    for row in rows {
        let Some(line) = row.line else { continue };
        for warning in &row.warnings {
            writeln!(io.err, "{}:{line}: warning: {warning}", path.display())?;
        }
        if let Some(error) = &row.error {
            let column = row.column.map_or(String::new(), |column| format!(":{column}"));
            writeln!(io.err, "{}:{line}{column}: {error}", path.display())?;
        }
    }
    let table: Vec<[String; 9]> = rows.iter().filter(|row| row.measured.is_some()).map(cells).collect();
    if table.is_empty() {
        return Ok(());
    }
    writeln!(io.out, "{}", path.display())?;
    let mut widths = HEADINGS.map(|heading| heading.chars().count());
    for cells in &table {
        for (width, cell) in widths.iter_mut().zip(cells) {
            *width = (*width).max(cell.chars().count());
        }
    }
    line(&HEADINGS.map(str::to_owned), &widths, io)?;
    for cells in &table {
        line(cells, &widths, io)?;
    }
    writeln!(io.out, "{}\n", summary(rows))?;
    Ok(())
}

fn cells(row: &Row) -> [String; 9] {
    let mm = |length: Option<Length>| length.map_or(String::new(), |length| length.exact(Unit::Millimetre, 3));
    let limits = match (row.minimum, row.maximum) {
        (Some(minimum), Some(maximum)) => format!("{} to {}", mm(Some(minimum)), mm(Some(maximum))),
        _ => String::new(),
    };
    let um = |length: Length| length.exact(Unit::Micrometre, 0);
    let deviation = row.deviation.map_or(String::new(), |deviation| {
        let plus = if Length::ZERO < deviation { "+" } else { "" };
        format!("{plus}{}", um(deviation))
    });
    let remove = row.remove.map_or(String::new(), |remove| format!(", remove {} µm", um(remove)));
    [
        row.line.map_or(String::new(), |line| line.to_string()),
        row.id.split_whitespace().collect::<Vec<_>>().join(" "),
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
            if right { format!("  {cell:>width$}") } else { format!("  {cell:<width$}") }
        });
    writeln!(io.out, "{}", padded.collect::<String>().trim_end())
}

/// `3 rows: 1 GOOD, 1 REWORK, 1 position OUT, 1 not usable`.
fn summary(rows: &[Row]) -> String {
    let count = |name: &str, is: &dyn Fn(&Row) -> bool| {
        let count = rows.iter().filter(|row| is(row)).count();
        (0 < count).then(|| format!("{count} {name}"))
    };
    let status = |status: Status| count(status.word(), &move |row: &Row| row.status == Some(status));
    let parts = [
        status(Status::Good),
        status(Status::Rework),
        status(Status::ReMeasure),
        status(Status::Scrap),
        count("position OUT", &|row| row.position_word() == Some("OUT")),
        count("not judged", &|row| row.error.is_some() && row.measured.is_some()),
        count("not usable", &|row| row.error.is_some() && row.measured.is_none()),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    format!("  {} {}: {}", rows.len(), if rows.len() == 1 { "row" } else { "rows" }, parts.join(", "))
}
