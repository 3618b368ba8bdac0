//! Saving the shown table, and using it for limits.

use std::path::Path;
use std::sync::Arc;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::tolerance::DeviationTable;
use fitcheck_exchange::exchange::tables::TABLE_FORMATS;

use super::document::Document;
use super::{Origin, TablesPage};
use crate::shared::Shared;

/// The table under another name.
fn renamed(table: &DeviationTable, name: &str) -> DeviationTable {
    // The parts come from a table, so they fit together.
    DeviationTable::new(name, false, table.ends().to_vec(), table.columns().to_vec()).unwrap_or_else(|_| table.clone())
}

impl TablesPage {
    /// The proposed name of a file in a format of the list. An ending that the table's file has is written as there: `.tab` beside `.TAB`
    /// would be a second file on some systems.
    pub(crate) fn file_name(&self, format: usize) -> String {
        let title = self.shown().map_or("", |document| document.title.as_str());
        let (stem, own) = title.rsplit_once('.').unwrap_or((title, ""));
        let endings = TABLE_FORMATS.get(format).map_or(&["tab"][..], |format| format.endings);
        let is_of_format = endings.iter().any(|ending| ending.eq_ignore_ascii_case(own));
        let ending = if is_of_format { own } else { endings.first().copied().unwrap_or("tab") };
        format!("{stem}.{ending}")
    }

    /// The shown table's bytes in a format of the list, for a file.
    pub(crate) fn bytes(&mut self, format: usize, path: &Path, shared: &mut Shared) -> Result<Vec<u8>, Message> {
        if !self.settle_cell(shared) {
            return Err(message!("tables-cell-unreadable"));
        }
        let (Some(document), Some(format)) = (self.shown(), TABLE_FORMATS.get(format)) else {
            return Err(message!("tables-nothing-to-save"));
        };
        // The table has the name of its file; a blank would end the name.
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().replace(char::is_whitespace, "_");
        let bytes = (format.write)(&renamed(document.table(), &name)).map_err(|error| error.message())?;
        // A built-in table never changes; a file in another format cannot be opened again. Neither counts as saving.
        let saves = format.endings.contains(&"tab") && document.origin != Origin::Shipped;
        if let Some(document) = self.shown_mut().filter(|_| saves) {
            document.save(path);
        }
        Ok(bytes)
    }

    /// A file was written, or not. If it was a table's, no other open table has that file and its name any longer.
    pub(super) fn table_written(&mut self, path: &Path, is_whole: bool) {
        let mut saved = None;
        for (number, document) in self.documents.iter_mut().enumerate() {
            if document.written(path, is_whole) {
                saved = Some((number, document.title.clone()));
            }
        }
        let Some((number, title)) = saved else { return };
        let free = self.free_title(&title);
        for (other, document) in self.documents.iter_mut().enumerate() {
            if other != number && document.is_titled(&title) {
                document.lose_file(free.clone());
            }
        }
    }

    /// The table that limits come from was edited: they come from what it holds now, never from what it held under the same name.
    pub(super) fn use_edited(&self, shared: &mut Shared) {
        let Some(own) = shared.sources.own().first().cloned() else { return };
        let edited = self.documents.iter().find(|document| document.is_titled(own.name()));
        if let Some(document) = edited.filter(|document| !document.holds_what(&own)) {
            Self::use_for_limits(document, "tables-used-edited", shared);
        }
    }

    /// The shown table becomes the first of the user's own.
    pub(super) fn use_shown(&self, shared: &mut Shared) {
        if let Some(document) = self.shown() {
            Self::use_for_limits(document, "tables-used", shared);
        }
    }

    fn use_for_limits(document: &Document, told: &'static str, shared: &mut Shared) {
        let title = document.title.clone();
        let table = Arc::new(renamed(document.table(), &title));
        let others = shared.sources.own().iter().filter(|own| !own.name().eq_ignore_ascii_case(&title)).cloned();
        let own = std::iter::once(table).chain(others).collect::<Vec<_>>();
        let sources = shared.sources.as_ref().clone().with_own(own);
        shared.use_sources(sources);
        shared.note(Message::new(told).text("name", title), Vec::new());
    }
}
