//! The columns that the first rows of a file have.

use csv::StringRecord;

use super::Columns;
use crate::exchange::beside::BesideColumn;
use crate::exchange::cell::Cells as _;
use crate::exchange::cells::is_callout;
use crate::exchange::column::{NAMED, listed, name_of};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::head::Head;
use crate::exchange::sample::Sample;
use crate::exchange::{cells, stated};

impl Sample {
    /// What the columns are.
    ///
    /// # Errors
    /// A reason that concerns the whole file.
    pub(in crate::exchange) fn columns(&self) -> Result<Columns, ImportErrorKind> {
        if self.rows.is_empty() {
            return Err(ImportErrorKind::NoRows);
        }
        let mut columns = if let Some((line, cells)) = self.header.and_then(|at| self.rows.get(at)) {
            self.by_header(*line, cells)?
        } else {
            let mut columns = self.by_content()?;
            if let Some((line, names)) = self.above.checked_sub(1).and_then(|at| self.rows.get(at)) {
                columns.header = Some(*line);
                columns.with_units(names)?;
            }
            columns
        };
        columns.top = self.top;
        let names = self.above.checked_sub(1).map(|last| self.header.unwrap_or(last)).and_then(|at| self.rows.get(at));
        let none = StringRecord::new();
        let names = names.map_or(&none, |(_, names)| names);
        let samples = self.side_by_side(names);
        let samples =
            if self.measured.is_none() && samples.first() == Some(&columns.measured.at) { samples } else { Vec::new() };
        if !samples.is_empty() {
            columns.split_into(&samples, names)?;
        }
        self.look_at_values(&mut columns, names);
        if let Some((line, _)) =
            self.rows.iter().take(self.above).find(|(_, row)| columns.hides_rows(row, self.separator))
        {
            return Err(ImportErrorKind::HeaderHidesRows { line: *line });
        }
        stated::decide(self, &mut columns)?;
        columns.split_into(&columns.sample_places(), names)?;
        Ok(columns)
    }

    /// The column that looks as if it had the callouts of rows that nothing else gives limits. It is not taken for them: it may be the
    /// other part's.
    fn callouts_unnamed(&self, columns: &Columns, names: &StringRecord, used: &[usize]) -> Option<String> {
        let mut free = (0..columns.count).filter(|at| !columns.have_limits() && !used.contains(at));
        free.find(|at| self.mostly(*at, is_callout)).map(|at| listed(&[name_of(at, names.cell(at))]))
    }

    /// What the first measured values look like.
    pub(in crate::exchange) fn look_at_values(&self, columns: &mut Columns, names: &StringRecord) {
        let used = columns.used();
        let above = self.rows.iter().filter(|(line, _)| columns.header.is_some_and(|header| *line < header));
        columns.head = Head::of(above.filter(|(line, _)| Some(*line) != columns.top));
        columns.ignored.retain(|ignored| {
            !columns
                .samples
                .iter()
                .any(|sample| *ignored == name_of(sample.measured.at, names.cell(sample.measured.at)))
        });
        columns.evidence.word = self.says_simulated(columns, &used);
        columns.beside = self.beside(names, columns, &used);
        columns.evidence.warm = self.said_of_all(columns, names);
        columns.other_values = self.other_values(names, columns, &used);
        columns.callouts_unnamed = self.callouts_unnamed(columns, names, &used);
        columns.remarks = columns.remarks_beside(names, &used);
        // What is compared is not skipped.
        let compared = columns.beside.iter().map(BesideColumn::at).chain(columns.evidence.word);
        let compared: Vec<String> = compared.map(|at| name_of(at, names.cell(at))).collect();
        columns.ignored.retain(|name| !compared.contains(name));
        columns.ignored.truncate(NAMED + 1);
        let at = columns.measured.at;
        columns.decimal_sign = cells::decimal_sign(self.cells(at));
        columns.behind = self.behind(at);
        columns.decimals = self.decimals(at);
    }
}
