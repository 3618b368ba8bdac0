//! The columns that the first rows of a file have.

use csv::StringRecord;

use super::Columns;
use crate::exchange::beside::BesideColumn;
use crate::exchange::cell::Cells as _;
use crate::exchange::cells;
use crate::exchange::column::{NAMED, name_of};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::sample::Sample;
use crate::exchange::stated;

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
        let names = self.above.checked_sub(1).map(|last| self.header.unwrap_or(last)).and_then(|at| self.rows.get(at));
        self.look_at_values(&mut columns, names.map_or(&StringRecord::new(), |(_, names)| names));
        if let Some((line, _)) =
            self.rows.iter().take(self.above).find(|(_, row)| columns.hides_rows(row, self.separator))
        {
            return Err(ImportErrorKind::HeaderHidesRows { line: *line });
        }
        stated::decide(self, &mut columns)?;
        Ok(columns)
    }

    /// What the first measured values look like.
    pub(in crate::exchange) fn look_at_values(&self, columns: &mut Columns, names: &StringRecord) {
        let used = columns.used();
        columns.evidence.word = self.says_simulated(columns, &used);
        columns.beside = self.beside(names, columns, &used);
        columns.evidence.warm = self.said_of_all(columns, names);
        columns.other_values = self.other_values(names, columns, &used);
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
