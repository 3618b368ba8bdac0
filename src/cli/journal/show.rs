//! `fitcheck journal show`: one entry with its whole reasoning.

use super::entry_name::{EntryName, entry_name};
use super::{CliError, Format, IntoCliError as _, Io, JournalArgs, Outcome, text};
use crate::cli::args::one_of;
use crate::journal::chain::{ChainId, Head};
use crate::store::local::{ListedEntry, Reader};

/// Show one entry with everything that it holds
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// Number of the entry, or at least 8 digits that its hash begins with, as a report shows them
    #[arg(value_name = "NUMBER|HASH", value_parser = entry_name)]
    entry: EntryName,
    /// Format: text for people, or json with chain, hashes and the body as it is stored
    #[arg(long, value_name = "FORMAT", default_value = "text", value_parser = one_of([Format::Text, Format::Json], |format| format.word()))]
    format: Format,
    #[command(flatten)]
    journal: JournalArgs,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let file = self.journal.file()?;
        let reader = Reader::open(&file).said()?;
        let last = reader.head().said()?.number;
        let number = self.entry.number(&reader, &file)?;
        let row = row(&reader, number, last, &file)?;
        let before = match number.checked_sub(1) {
            // Where the entry before was removed, its hash is not known.
            Some(number) if 0 < number => reader.entry(number).said()?.map(|kept| kept.head),
            _ => Some(Head::default()),
        };
        if self.format == Format::Json {
            io.data().write_all(&line_in(&row, reader.chain(), before, &reports(&reader, number)?));
        } else {
            text::print(&row, reader.chain(), last, io);
            for (number, name) in reports(&reader, number)? {
                text::line("in report", format_args!("{number} {name}"), io);
            }
        }
        match &row.entry {
            Ok(_) => Ok(Outcome::Done),
            Err(error) => {
                io.fail(error);
                Ok(Outcome::BadData)
            }
        }
    }
}

/// An entry by its number.
pub(super) fn row(reader: &Reader, number: u64, last: u64, file: &std::path::Path) -> Result<ListedEntry, CliError> {
    let row = reader.rows(&[number]).said()?.into_iter().next();
    row.ok_or_else(|| CliError::NoEntry { number, last, path: file.to_owned() })
}

/// The reports that show a check: the numbers of their entries, and the names of their files.
fn reports(reader: &Reader, number: u64) -> Result<Vec<(u64, String)>, CliError> {
    let rows = reader.rows(&reader.reports_of(number).said()?).said()?;
    let named = |row: &ListedEntry| Some((row.kept.head.number, row.entry.as_ref().ok()?.report()?.name.clone()));
    Ok(rows.iter().filter_map(named).collect())
}

/// An entry as one line of JSON: its body is as it is kept, byte for byte, so that its hash can be computed from it.
pub(super) fn line(row: &ListedEntry, chain: ChainId, before: Option<Head>) -> Vec<u8> {
    line_in(row, chain, before, &[])
}

/// The same with the reports that show it, where there are any.
fn line_in(row: &ListedEntry, chain: ChainId, before: Option<Head>, reports: &[(u64, String)]) -> Vec<u8> {
    let Head { number, hash } = row.kept.head;
    let before = before.map_or_else(String::new, |before| format!("\"before\":\"{}\",", before.hash));
    let corrected_by = row.corrected_by.map_or("null".to_owned(), |number| number.to_string());
    let reports: Vec<String> = reports.iter().map(|(number, _)| number.to_string()).collect();
    let reports = if reports.is_empty() { String::new() } else { format!("\"in_reports\":[{}],", reports.join(",")) };
    let head = format!(
        "{{\"chain\":\"{chain}\",\"number\":{number},{before}\"hash\":\"{hash}\",\"corrected_by\":{corrected_by},{reports}"
    );
    let mut line = head.into_bytes();
    let is_json = serde_json::from_slice::<serde::de::IgnoredAny>(&row.kept.body).is_ok();
    if is_json && !row.kept.body.contains(&b'\n') {
        line.extend_from_slice(b"\"body\":");
        line.extend_from_slice(&row.kept.body);
    } else {
        // Whatever it is, a reader of JSON gets JSON.
        let text = serde_json::Value::from(String::from_utf8_lossy(&row.kept.body)).to_string();
        line.extend_from_slice(b"\"body\":null,\"damaged\":");
        line.extend_from_slice(text.as_bytes());
    }
    line.extend_from_slice(b"}\n");
    line
}
