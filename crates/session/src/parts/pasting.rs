//! Cells on their way between the table of a plan and a spreadsheet.

use fitcheck_core::message::{Message, message, shortened};
use fitcheck_core::part::{Column, DraftFeature, MOST_FEATURES};
use fitcheck_core::tolerance::Sources;

use super::draft_cells::{clamped, selected, write};
use super::{PartsPage, paste};
use crate::shared::Shared;

/// The longest list of names that is told.
const MOST_NAMES: usize = 80;

impl PartsPage {
    /// The selected cells as a spreadsheet takes them.
    pub(super) fn copied(&self) -> String {
        let rows = self.sheet.selected_rows();
        let columns = self.sheet.selected_columns();
        let rows = self.document.draft().rows.get(clamped(&rows, self.document.draft().rows.len()));
        let lines = rows
            .into_iter()
            .flatten()
            .map(|row| paste::line(columns.iter().map(|column| (*column, row.cell(*column).text.clone()))));
        let lines: Vec<String> = lines.collect();
        lines.join("\n")
    }

    /// Puts cells at the cell; one cell alone goes into every selected one. What finds no place is told, and an empty clipboard changes
    /// nothing.
    pub(super) fn paste(&mut self, text: &str, shared: &mut Shared, sources: &Sources) {
        if text.trim_matches([' ', '\r', '\n']).is_empty() {
            return;
        }
        let mut rows = paste::cells(text);
        let named = paste::header(&rows);
        let names = if named.is_some() { rows.remove(0) } else { Vec::new() };
        let row = *self.sheet.selected_rows().start();
        let is_named = named.is_some();
        let paste::Header { columns, twice, unknown } =
            named.unwrap_or_else(|| paste::Header { columns: self.columns_from_corner(), ..paste::Header::default() });
        if let ([cells], false) = (rows.as_slice(), is_named)
            && let [text] = cells.as_slice()
            && self.sheet.is_block()
        {
            return self.fill(text, sources);
        }
        // Empty rows below the last feature would be features without anything.
        let count = self.document.draft().rows.len();
        while count < row + rows.len() && rows.last().is_some_and(|row| row.iter().all(|cell| cell.trim().is_empty())) {
            rows.pop();
        }
        let lost_rows = (row + rows.len()).saturating_sub(MOST_FEATURES);
        let wide = rows.iter().map(Vec::len).fold(0, usize::max);
        let nowhere = |at: &usize| columns.get(*at).is_none_or(Option::is_none);
        let has_text = |at: &usize| rows.iter().any(|row| row.get(*at).is_some_and(|cell| !cell.trim().is_empty()));
        // A column without a name is one that is meant to be left out, unless it holds something; those with a name are told by it.
        let is_nameless = |at: &usize| names.get(*at).is_none_or(|name| name.trim().is_empty());
        let is_lost = |at: &usize| nowhere(at) && (!is_named || is_nameless(at) && has_text(at));
        let lost_columns = (0..wide).filter(is_lost).count();
        rows.truncate(rows.len().saturating_sub(lost_rows));
        let block = (rows.len(), wide.min(columns.len()));
        self.document.change(sources, |draft| {
            while draft.rows.len() < row + rows.len() {
                draft.rows.push(DraftFeature::default());
            }
            for (row, cells) in draft.rows.iter_mut().skip(row).zip(rows) {
                for (column, text) in columns.iter().zip(cells) {
                    if let Some(column) = column {
                        write(row, *column, paste::bare(*column, text.trim()));
                    }
                }
            }
        });
        self.sheet.follow(&self.document);
        if !is_named {
            let column = columns.first().copied().flatten().unwrap_or(Column::Name);
            self.sheet.select((row, column), block.0, block.1);
        }
        if 0 < lost_rows {
            let message = message!("parts-page-pasted-rows").count("count", lost_rows);
            shared.tell(message.count("most", MOST_FEATURES));
        }
        if !twice.is_empty() {
            let keys: Vec<&str> = twice.into_iter().map(Column::key).collect();
            shared.tell(message!("parts-page-pasted-twice").text("keys", keys.join(", ")));
        }
        if !unknown.is_empty() {
            shared
                .tell(message!("parts-page-pasted-unknown").text("names", shortened(&unknown.join(", "), MOST_NAMES)));
        }
        if 0 < lost_columns {
            let id = if is_named { "parts-page-pasted-nameless" } else { "parts-page-pasted-columns" };
            shared.tell(Message::new(id).count("count", lost_columns));
        }
    }

    /// The shown columns from the upper left corner of what is selected.
    fn columns_from_corner(&self) -> Vec<Option<Column>> {
        let corner = self.sheet.selected_columns().first().copied().unwrap_or(Column::Name);
        let shown = self.sheet.columns.iter().skip_while(|column| **column != corner);
        shown.copied().map(Some).collect()
    }

    /// Writes one text into every selected cell.
    fn fill(&mut self, text: &str, sources: &Sources) {
        let rows = self.sheet.selected_rows();
        let columns = self.sheet.selected_columns();
        self.document.change(sources, |draft| {
            for row in selected(draft, &rows) {
                for column in &columns {
                    write(row, *column, paste::bare(*column, text.trim()));
                }
            }
        });
    }
}
