//! `--columns` and `--show-columns`: what the columns of a CSV are taken for.

use std::path::{Path, PathBuf};

use serde_json::{Value as Json, json};

use crate::cli::rows::csv_line;
use crate::cli::{CliError, CliRemark, Format, IntoCliError as _, Io, Outcome};
use crate::exchange::{Detected, FirstRows, Mapping};
use crate::files;

/// How much of a file is looked at.
const HEAD: usize = 64 << 10;

/// How wide a column of the text becomes at most.
const WIDEST: usize = 40;

/// Reads a mapping: a list, or a file of TOML.
pub(in crate::cli) fn mapping(given: &str) -> Result<Mapping, CliError> {
    let path = Path::new(given);
    if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")) {
        let bytes = files::read(path)?;
        return Mapping::from_toml(&String::from_utf8_lossy(&bytes)).about(given);
    }
    given.parse::<Mapping>().said()
}

/// Prints what the columns of each file are taken for. Where they are not all known, it prints what is, and why nothing can be read yet.
pub(super) fn show(paths: &[PathBuf], mapping: Option<&Mapping>, format: Format, io: &mut Io<'_>) -> Outcome {
    let open = Mapping::default();
    let mapping = mapping.unwrap_or(&open);
    let mut bad = false;
    let mut is_first = true;
    let mut shown = Vec::new();
    for path in paths {
        let found = first_rows(path).and_then(|first| {
            let (detected, why) = match first.detect(mapping) {
                Ok(detected) => (detected, None),
                Err(error) => (first.guessed(mapping), Some(error.to_string())),
            };
            let toml = detected.mapping.to_toml().map_err(|error| error.to_string())?;
            Ok((detected, toml, why))
        });
        if let Ok((.., Some(why))) = &found {
            bad = true;
            io.fail(format_args!("{}: {why}", path.display()));
        }
        match found {
            Ok((detected, toml, _)) => match format {
                Format::Json => shown.push(as_json(path, &detected, &toml)),
                Format::Csv => csv(path, &detected, std::mem::take(&mut is_first), io),
                Format::Text => text(path, &detected, &toml, io),
            },
            Err(error) => {
                bad = true;
                io.fail(format_args!("{}: {error}", path.display()));
            }
        }
    }
    if format == Format::Json {
        io.json(&shown);
    }
    if bad { Outcome::BadData } else { Outcome::Done }
}

/// The first rows of a file: of a text its beginning, of a workbook those of its sheets.
fn first_rows(path: &Path) -> Result<FirstRows, String> {
    let head = files::read_head(path, HEAD).map_err(|error| error.to_string())?;
    let name = files::name_of(path).to_string_lossy();
    let is_workbook = head.starts_with(b"PK");
    let bytes = if is_workbook { files::read(path).map_err(|error| error.to_string())? } else { head };
    FirstRows::of_columns(&name, &bytes).ok_or_else(|| CliRemark::NoColumns.to_string())
}

/// What is shown of one column.
struct ColumnSummary<'a> {
    number: usize,
    name: &'a str,
    holds: &'static str,
    first: &'a str,
}

/// The columns of a file: as many as have a name, hold something or have a cell in the first row.
fn columns(detected: &Detected) -> impl Iterator<Item = ColumnSummary<'_>> {
    let cells = detected.rows.first().map_or(&[][..], |(_, cells)| cells);
    let count = detected.roles.len().max(detected.names.len()).max(cells.len());
    (0..count).map(move |at| ColumnSummary {
        number: at + 1,
        name: detected.names.get(at).map_or("", String::as_str),
        holds: detected.word(at).unwrap_or("-"),
        first: cells.get(at).map_or("", |cell| cell.trim()),
    })
}

fn text(path: &Path, detected: &Detected, toml: &str, io: &mut Io<'_>) {
    let shown: Vec<ColumnSummary<'_>> = columns(detected).collect();
    let wide = |length: fn(&ColumnSummary<'_>) -> usize| shown.iter().map(length).fold(0, usize::max).min(WIDEST);
    let names = wide(|column| column.name.chars().count());
    let holds = wide(|column| column.holds.len());
    let out = io.people();
    writeln!(out, "{}", path.display());
    for ColumnSummary { number, name, holds: held, first } in &shown {
        let line = format!("{number:>4}  {name:<names$}  {held:<holds$}  {first}");
        writeln!(out, "{}", line.trim_end());
    }
    writeln!(out);
    if let Some(from) = &detected.unit_from {
        writeln!(out, "# unit: {from}");
    }
    out.write_all(format!("{toml}\n").as_bytes());
}

fn csv(path: &Path, detected: &Detected, is_first: bool, io: &mut Io<'_>) {
    if is_first {
        csv_line(["file", "column", "name", "holds", "first"], io);
    }
    let file = path.display().to_string();
    for ColumnSummary { number, name, holds, first } in columns(detected) {
        csv_line([file.as_str(), &number.to_string(), name, holds, first], io);
    }
}

fn as_json(path: &Path, detected: &Detected, toml: &str) -> Json {
    let columns = columns(detected).map(|ColumnSummary { number, name, holds, first }| {
        json!({ "column": number, "name": name, "holds": (holds != "-").then_some(holds), "first": first })
    });
    json!({
        "file": path.display().to_string(),
        "columns": columns.collect::<Vec<_>>(),
        "mapping": toml,
        "unit_from": detected.unit_from,
    })
}
