//! Which tables are open: the built-in ones, the user's own, files, and what is made here.

use std::sync::Arc;

use super::MOST_DOCUMENTS;
use super::document::{Document, Origin};
use crate::control::shipped_tables;
use crate::message::Message;
use crate::session::{Field, Notice, Session};
use crate::tolerance::DeviationTable;

impl Session {
    /// Opens the built-in tables when the page is opened for the first time.
    pub(in crate::session) fn open_tables_page(&mut self) {
        if self.tables.documents.is_empty() {
            let options = self.sources.options();
            let shipped = shipped_tables().into_iter();
            let document =
                |table: Arc<DeviationTable>| Document::kept(table.as_ref().clone(), Origin::Shipped, options);
            self.tables.documents = shipped.map(document).collect();
            self.show_document(0);
        }
    }

    /// Shows an open table; its selection is as it was left.
    pub(super) fn show_document(&mut self, number: usize) {
        if number < self.tables.documents.len() {
            self.tables.shown = number;
            self.inputs.set(Field::TableFilter, String::new());
            self.shown_changed();
        }
    }

    /// Opens a table that was read; one of the same name without unsaved edits makes room for it.
    pub(super) fn open_table(&mut self, table: DeviationTable, origin: Origin) {
        let options = self.sources.options();
        let same = self.tables.by_title(table.name());
        let same = same.filter(|&number| self.tables.documents.get(number).is_some_and(Document::is_replaceable));
        if let Some((number, place)) = same.and_then(|same| Some((same, self.tables.documents.get_mut(same)?))) {
            *place = Document::kept(table, origin, options);
            return self.show_document(number);
        }
        let title = self.tables.free_title(table.name());
        self.add_and_show(Document::kept(table, origin, options).with_title(title));
    }

    pub(super) fn add_and_show(&mut self, document: Document) {
        match self.tables.add(document) {
            Some(number) => self.show_document(number),
            None => self.tell(Message::new("tables-too-many").count("count", MOST_DOCUMENTS)),
        }
    }

    pub(super) fn table_read(&mut self, name: &str, result: Result<(Box<DeviationTable>, Vec<Message>), Message>) {
        match result {
            Ok((table, details)) => {
                self.file_done();
                if !details.is_empty() {
                    let message = Message::new("tables-read-with-warnings").text("name", name);
                    self.notices.push(Notice { message, details, is_problem: false });
                }
                self.open_table(*table, Origin::File);
            }
            Err(problem) => self.file_failed(problem),
        }
    }

    /// Other options of ISO 286 count at once. What was typed into the cell counts before.
    pub(in crate::session) fn sources_of_tables_changed(&mut self) {
        self.settle_cell();
        let options = self.sources.options();
        for document in &mut self.tables.documents {
            document.compare(options);
        }
        self.shown_changed();
    }

    /// The tables of a folder were read: what is open follows, unless it has edits.
    pub(in crate::session) fn folder_of_tables_changed(&mut self) {
        let options = self.sources.options();
        for document in &mut self.tables.documents {
            let own = self.sources.own().iter().find(|own| own.name().eq_ignore_ascii_case(document.title()));
            if let Some(own) = own.filter(|own| document.is_replaceable() && !document.holds_what(own)) {
                *document = Document::kept(own.as_ref().clone(), Origin::Own, options);
            }
        }
        self.shown_changed();
    }
}
