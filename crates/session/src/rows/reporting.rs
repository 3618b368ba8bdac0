//! The listed rows of a large file as a report, or as the rows of a file with their verdicts.

use std::io::{self, Write};
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::text::long;
use fitcheck_core::tolerance::Sources;
use fitcheck_exchange::batch::{FORMS, Form, refusal, write_listed};
use fitcheck_exchange::exchange::batch::{Filter, ListedRows, RowFate};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::report::{Checks, Report};
use jiff::civil::DateTime;

use super::Rows;

/// The forms of text in which rows are written, by their numbers among all forms.
pub fn row_forms() -> impl Iterator<Item = usize> {
    FORMS.iter().enumerate().filter(|(_, (form, ..))| *form != Form::Parquet).map(|(number, _)| number)
}

/// Listed rows that are written as the rows of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct RowsText {
    rows: ListedRows,
    form: Form,
}

impl RowsText {
    /// Writes them.
    ///
    /// # Errors
    /// Those of the file that is read and of the one that is written.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        write_listed(&self.rows, self.form, out).map_err(changed)
    }
}

/// A file that is another one now says so.
fn changed(error: io::Error) -> io::Error {
    match error.kind() {
        io::ErrorKind::InvalidData | io::ErrorKind::UnexpectedEof => {
            io::Error::other(message!("rows-changed").to_string())
        }
        _ => error,
    }
}

/// The checks of listed rows, as an import makes them; a row without a verdict has none.
#[derive(Debug)]
struct RowChecks {
    rows: ListedRows,
    file: String,
    now: DateTime,
}

impl Checks for RowChecks {
    fn each(&self, see: &mut dyn FnMut(&Record) -> io::Result<()>) -> io::Result<()> {
        let each = self.rows.each(&mut |row| {
            let imported = row.imported(&self.rows.layout, &self.file, &self.rows.sources, self.now);
            imported.records.iter().filter(|_| row.judged.is_some()).try_for_each(&mut *see)
        });
        each.map_err(changed)
    }
}

impl Rows {
    /// The listed rows as a report: counts first, then the checks in the order of the list.
    pub(crate) fn report(&self, sources: &Arc<Sources>, now: DateTime) -> Option<Report> {
        let rows = self.listed_rows(sources)?;
        let mut notes = vec![self.counted()];
        notes.extend(self.order_told());
        if !self.is_whole() {
            notes.push(message!("rows-not-whole"));
        }
        let unjudged = self.listed_unjudged();
        if 0 < unjudged {
            notes.push(message!("rows-report-without").count("count", unjudged));
        }
        let is_partial = 0 < unjudged || !self.is_whole() || self.is_cut();
        let checks = RowChecks { rows, file: self.name.clone(), now };
        Some(Report { notes, is_partial, ..Report::new(now, checks) })
    }

    /// The listed rows in a form of text.
    pub(crate) fn text(&self, form: usize, sources: &Arc<Sources>) -> Result<RowsText, Message> {
        let rows = self.listed_rows(sources).ok_or_else(|| message!("rows-export-not-yet"))?;
        let (form, ..) = *FORMS.get(form).ok_or_else(|| message!("dialog-no-path"))?;
        refusal(form, &rows.layout).map_or(Ok(RowsText { rows, form }), Err)
    }

    /// How many rows of the whole file have which verdict, and how many are listed.
    fn counted(&self) -> Message {
        let [good, rework, re_measure, out, scrap, unjudged] = self.fates().map(|(_, count)| count);
        let said = message!("rows-report-counts").text("name", &self.name).text("count", self.count());
        let said = said.text("good", good).text("rework", rework).text("remeasure", re_measure);
        said.text("out", out).text("scrap", scrap).text("unjudged", unjudged).text("listed", self.listed())
    }

    /// In which order they are listed, where it is not that of the file.
    pub fn order_told(&self) -> Option<Message> {
        let most = long(Self::MOST);
        match (self.is_worst_first(), self.is_cut()) {
            (true, true) => Some(message!("rows-worst-of-many").text("most", most)),
            (true, false) => Some(message!("rows-in-order")),
            (false, true) => Some(message!("rows-first-of-many").text("most", most)),
            (false, false) => None,
        }
    }

    /// How many listed rows have no verdict.
    fn listed_unjudged(&self) -> usize {
        if let Some(sifted) = &self.sifted {
            return sifted.unjudged;
        }
        if !self.filter.fates.is_empty() && !self.filter.fates.contains(&RowFate::NotJudged) {
            return 0;
        }
        let unjudged = Filter { fates: [RowFate::NotJudged].into(), ..self.filter.clone() }.sieve(self.classes.len());
        self.parts.iter().map(|part| part.count(&unjudged)).sum()
    }
}
