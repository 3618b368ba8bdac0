//! Which tables are open: the built-in ones, the user's own, files, and those made here.

use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::tolerance::DeviationTable;
use fitcheck_nc::control::shipped_tables;

use super::{Document, MOST_DOCUMENTS, Origin, TablesField, TablesPage};
use crate::shared::Shared;

impl TablesPage {
    /// Opens the built-in tables when the page is opened for the first time.
    pub(super) fn opened(&mut self, shared: &Shared) {
        if self.documents.is_empty() {
            let options = shared.sources.options();
            let shipped = shipped_tables().into_iter();
            let document =
                |table: Arc<DeviationTable>| Document::kept(table.as_ref().clone(), Origin::Shipped, options);
            self.documents = shipped.map(document).collect();
            self.show_document(0, shared);
        }
    }

    /// Shows an open table; its selection is as it was left.
    pub(super) fn show_document(&mut self, number: usize, shared: &Shared) {
        if number < self.documents.len() {
            self.shown = number;
            self.texts.set(TablesField::Filter, "");
            self.shown_changed(shared);
        }
    }

    /// Opens a table that was read. It replaces one of the same name that has no unsaved edits.
    pub(super) fn open_table(&mut self, table: DeviationTable, origin: Origin, shared: &mut Shared) {
        let options = shared.sources.options();
        let same = self.by_title(table.name());
        let same = same.filter(|&number| self.documents.get(number).is_some_and(Document::is_replaceable));
        if let Some((number, place)) = same.and_then(|same| Some((same, self.documents.get_mut(same)?))) {
            *place = Document::kept(table, origin, options);
            return self.show_document(number, shared);
        }
        let title = self.free_title(table.name());
        self.add_and_show(Document::kept(table, origin, options).with_title(title), shared);
    }

    pub(super) fn add_and_show(&mut self, document: Document, shared: &mut Shared) {
        match self.add(document) {
            Some(number) => self.show_document(number, shared),
            None => shared.tell(message!("tables-too-many").count("count", MOST_DOCUMENTS)),
        }
    }

    pub(super) fn table_read(
        &mut self,
        name: &str,
        result: Result<(Box<DeviationTable>, Vec<Message>), Message>,
        shared: &mut Shared,
    ) {
        if let Some((table, details)) = shared.file_answered(result) {
            shared.note_details(message!("tables-read-with-warnings").text("name", name), details);
            self.open_table(*table, Origin::File, shared);
        }
    }

    /// Applies other options of ISO 286 at once, after what was typed into the cell.
    pub(super) fn sources_changed(&mut self, shared: &mut Shared) {
        self.settle_cell(shared);
        let options = shared.sources.options();
        for document in &mut self.documents {
            document.compare(options);
        }
        self.shown_changed(shared);
    }

    /// Open tables follow the tables of a folder that was read, unless they have edits.
    pub(super) fn own_tables_changed(&mut self, shared: &Shared) {
        let options = shared.sources.options();
        for document in &mut self.documents {
            let own = shared.sources.own().iter().find(|own| own.name().eq_ignore_ascii_case(&document.title));
            if let Some(own) = own.filter(|own| document.is_replaceable() && !document.holds_what(own)) {
                *document = Document::kept(own.as_ref().clone(), Origin::Own, options);
            }
        }
        self.shown_changed(shared);
    }
}
