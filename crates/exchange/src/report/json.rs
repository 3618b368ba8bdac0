//! Checks and reports as JSON, the same in every language.
//!
//! An object with the file's `version`, now 1, and `checks`: one object per check with the names of the CSV's columns.
//! Figures are numbers, contacts are arrays of x, y, z in millimetres, warnings are an array of sentences; missing
//! values are null. A report also has its head: `title`, `created`, `program`, `part`, `order`, `inspector`, `notes`; and one of whole
//! parts has `parts`: `part`, `serial`, `status` (null where it has no verdict), `measured`, `missing`, `left_out`, `simulated`, `picture`.

use std::io::{self, Write};

use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;
use serde::Serialize;

use super::csv::More;
use super::part::PartSheet;
use super::{Checks, Holds, RenderError, Rendering, Report};
use crate::journal::Record;
use crate::row::{self, ReportRow};

pub const RENDERING: Rendering = Rendering {
    name: "json",
    title: "JSON",
    is_for_people: false,
    holds: Holds::Report,
    endings: &["json"],
    render: render_report,
};

/// The version of the file's structure. What a reader knows of an older version stays where it is.
pub const VERSION: u32 = 1;

/// Everything before the checks.
#[derive(Serialize)]
struct File<'a> {
    version: u32,
    #[serde(flatten)]
    head: Option<Head<'a>>,
}

#[derive(Serialize)]
struct Head<'a> {
    title: &'a str,
    created: String,
    program: &'a str,
    part: Option<&'a str>,
    order: Option<&'a str>,
    inspector: Option<&'a str>,
    notes: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    parts: Vec<Part<'a>>,
}

/// A whole part.
#[derive(Serialize)]
struct Part<'a> {
    #[serde(rename = "part")]
    name: &'a str,
    serial: &'a str,
    status: Option<&'static str>,
    measured: usize,
    missing: Vec<String>,
    left_out: Vec<LeftOut>,
    simulated: usize,
    picture: Option<&'a str>,
}

/// A size without a value, and why.
#[derive(Serialize)]
struct LeftOut {
    name: String,
    reason: String,
}

impl<'a> Part<'a> {
    fn of(sheet: &'a PartSheet) -> Self {
        let standing = sheet.standing();
        let left_out = sheet.left_out().into_iter().map(|(name, reason)| LeftOut { name, reason });
        Self {
            name: &sheet.plan.head.part,
            serial: sheet.serial(),
            status: sheet.status().map(Status::word),
            measured: standing.measured,
            missing: sheet.missing(),
            left_out: left_out.collect(),
            simulated: standing.simulated,
            picture: sheet.picture_name(),
        }
    }
}

fn render_report(report: &Report, _words: &Words, out: &mut dyn Write) -> io::Result<()> {
    let head = Head {
        title: &report.title,
        created: report.created.to_string(),
        program: &report.program,
        part: report.part.as_deref(),
        order: report.order.as_deref(),
        inspector: report.inspector.as_deref(),
        notes: report.notes.iter().map(ToString::to_string).collect(),
        parts: report.parts.iter().map(Part::of).collect(),
    };
    write(Some(head), &*report.checks, out)
}

/// The records as JSON, in their order.
pub fn render(records: &[Record]) -> Result<Vec<u8>, RenderError> {
    let mut bytes = Vec::new();
    let written = write(None, &records, &mut bytes);
    written.map(|()| bytes).map_err(|error| RenderError::writer("json", &error))
}

/// One record as an object with the CSV's names; missing values are left out.
pub fn object(record: &Record) -> Result<serde_json::Map<String, serde_json::Value>, RenderError> {
    row::object(record).map_err(|error| RenderError::writer("json", &error))
}

/// What a record has under the names of some columns; null where it has nothing.
pub fn more(record: &Record, more: More) -> Result<Vec<(&'static str, serde_json::Value)>, RenderError> {
    let row = serde_json::to_value(ReportRow::of(record)).map_err(|error| RenderError::writer("json", &error))?;
    Ok(more.names().map(|name| (name, row.get(name).map_or(serde_json::Value::Null, Clone::clone))).collect())
}

/// Writes the file check by check, indented as `serde_json` does it.
fn write(head: Option<Head<'_>>, checks: &dyn Checks, out: &mut dyn Write) -> io::Result<()> {
    let head = serde_json::to_string_pretty(&File { version: VERSION, head })?;
    write!(out, "{},\n  \"checks\": [", head.strip_suffix("\n}").unwrap_or(&head))?;
    let mut is_first = true;
    checks.each(&mut |record| {
        let comma = if std::mem::take(&mut is_first) { "" } else { "," };
        // A text has its own line ends escaped.
        let check = serde_json::to_string_pretty(&ReportRow::of(record))?.replace('\n', "\n    ");
        write!(out, "{comma}\n    {check}")
    })?;
    out.write_all(if is_first { b"]\n}\n" } else { b"\n  ]\n}\n" })
}
