//! The table page: which tables are open, the shown one's selected cell, its filter, edits and comparison.
//!
//! | file | what |
//! |---|---|
//! | `document` | an open table: its edits, and its comparison with ISO 286 |
//! | `filter` | which columns and rows a filter's text means |
//! | `editing` | from the fields to cells and columns |
//! | `walking` | moving from cell to cell |
//! | `opening` | which tables are open, and the shown one
//! | `keeping` | saving, and using a table for limits |
//!
//! A table stays open, with its edits, until the window is closed: looking at another one loses nothing.

mod document;
mod editing;
mod filter;
mod keeping;
mod opening;
mod walking;

use std::collections::BTreeMap;
use std::sync::Arc;

pub use document::{Document, Origin};
pub use filter::Filter;

use self::keeping::Saving;
use super::Session;
use super::inputs::Field;
use crate::message::Message;
use crate::tolerance::{DeviationTable, ToleranceClass};

/// What can be done on the table page.
#[derive(Debug, Clone)]
pub enum TablesCommand {
    /// Shows a table of the list.
    Open(TableChoice),
    /// A table's file was read, or not.
    Read {
        /// Its name without the folder.
        name: String,
        /// The table and its warnings.
        result: Result<(Box<DeviationTable>, Vec<Message>), Message>,
    },
    /// Selects a cell: class, and number of the size range.
    Select(ToleranceClass, usize),
    /// Selects a cell near the selected one.
    Move(Step),
    /// Selects the next cell that differs from ISO 286, in reading order and round again.
    NextDifference,
    /// Selects the one before.
    PreviousDifference,
    /// Puts the two fields into the selected cell; both empty is an empty cell.
    SetCell,
    /// Puts the selected cell back into the fields.
    RevertCell,
    /// Empties the selected cell.
    EmptyCell,
    /// Puts what ISO 286 says into the selected cell.
    TakeStandard,
    /// Takes the shown table's last edit back.
    Undo,
    /// Does it again.
    Redo,
    /// Adds the classes of their field to the shown table, with the deviations of ISO 286.
    AddColumns,
    /// Removes the selected cell's class.
    RemoveColumn,
    /// Makes a table of the classes and up to the size in their fields.
    Make,
    /// Looks limits up in the shown table first.
    Use,
}

/// A table of the page's list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableChoice {
    /// One that is open, by its number.
    Document(usize),
    /// One of the user's own that was not opened yet, by its number there.
    Own(usize),
}

/// A step from cell to cell; it ends at the table's edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// To the class on the left.
    Left,
    /// To the class on the right.
    Right,
    /// To the smaller size range.
    Up,
    /// To the larger size range.
    Down,
    /// Ten size ranges up.
    PageUp,
    /// Ten size ranges down.
    PageDown,
    /// To the first class.
    First,
    /// To the last class.
    Last,
    /// To the first size range.
    Top,
    /// To the last size range.
    Bottom,
}

/// The state of the table page.
#[derive(Debug, Default)]
pub struct TablesPage {
    documents: Vec<Document>,
    shown: usize,
    filter: Filter,
    errors: BTreeMap<Field, Message>,
    saving: Option<Saving>,
}

/// How many tables are open at most; beyond that the oldest without unsaved edits is closed.
const MOST_DOCUMENTS: usize = 32;

impl TablesPage {
    /// The open tables, the two built-in ones first.
    pub fn documents(&self) -> &[Document] {
        &self.documents
    }

    /// The shown table; `None` before the page was opened for the first time.
    pub fn shown(&self) -> Option<&Document> {
        self.documents.get(self.shown)
    }

    /// The shown table's number.
    pub const fn number(&self) -> usize {
        self.shown
    }

    /// What the filter makes of the shown table.
    pub const fn filter(&self) -> &Filter {
        &self.filter
    }

    /// What is wrong with a field of the page.
    pub fn error(&self, field: Field) -> Option<&Message> {
        self.errors.get(&field)
    }

    fn shown_mut(&mut self) -> Option<&mut Document> {
        self.documents.get_mut(self.shown)
    }

    /// The open table of a title. The built-in ones do not count: a user's own may be called the same.
    fn by_title(&self, title: &str) -> Option<usize> {
        let is_it =
            |document: &Document| document.origin() != Origin::Shipped && document.title().eq_ignore_ascii_case(title);
        self.documents.iter().position(is_it)
    }

    /// A title that no open table has: `own.tab`, `own_2.tab`.
    fn free_title(&self, wanted: &str) -> String {
        let (stem, ending) = wanted.rsplit_once('.').unwrap_or((wanted, "tab"));
        let numbered = (2..).map(|number| format!("{stem}_{number}.{ending}"));
        let mut titles = std::iter::once(format!("{stem}.{ending}")).chain(numbered);
        titles.find(|title| self.by_title(title).is_none()).unwrap_or_default()
    }

    /// Adds a table and says its number, or closes an old one without unsaved edits to make room.
    fn add(&mut self, document: Document) -> Option<usize> {
        if MOST_DOCUMENTS <= self.documents.len() {
            let old = self.documents.iter().position(|old| old.origin() != Origin::Shipped && !old.is_unsaved())?;
            self.documents.remove(old);
        }
        self.documents.push(document);
        Some(self.documents.len() - 1)
    }
}

impl Session {
    /// The table page.
    pub const fn tables(&self) -> &TablesPage {
        &self.tables
    }

    /// The user's own tables that are not open yet: their number among [`crate::tolerance::Sources::own`], and table.
    pub fn unopened_tables(&self) -> impl Iterator<Item = (usize, &Arc<DeviationTable>)> {
        let own = self.sources.own().iter().enumerate();
        own.filter(|(_, table)| self.tables.by_title(table.name()).is_none())
    }

    /// Whether limits are looked up in the shown table first, as it stands.
    pub fn uses_shown_table(&self) -> bool {
        let (Some(document), Some(own)) = (self.tables.shown(), self.sources.own().first()) else { return false };
        own.name() == document.title() && document.holds_what(own)
    }

    pub(super) fn apply_tables(&mut self, command: TablesCommand) {
        // What was typed into the cell counts before another cell or table is shown; what cannot be read keeps the
        // cell, and says why. Other commands are about the cell itself, or come from a file.
        let is_pending = self.cell_is_pending();
        match command {
            TablesCommand::RevertCell
            | TablesCommand::SetCell
            | TablesCommand::EmptyCell
            | TablesCommand::TakeStandard
            | TablesCommand::Read { .. } => {}
            // Undo takes back what was typed last.
            TablesCommand::Undo | TablesCommand::Redo if is_pending => return self.fill_cell_fields(),
            _ if !self.settle_cell() => return,
            _ => {}
        }
        match command {
            TablesCommand::Open(TableChoice::Document(number)) => self.show_document(number),
            TablesCommand::Open(TableChoice::Own(number)) => {
                if let Some(table) = self.sources.own().get(number).cloned() {
                    self.open_table(table.as_ref().clone(), Origin::Own);
                }
            }
            TablesCommand::Read { name, result } => self.table_read(&name, result),
            TablesCommand::Select(class, range) => self.select(class, range),
            TablesCommand::Move(step) => self.move_by(step),
            TablesCommand::NextDifference => self.select_difference(true),
            TablesCommand::PreviousDifference => self.select_difference(false),
            TablesCommand::SetCell => _ = self.settle_cell(),
            TablesCommand::RevertCell => self.fill_cell_fields(),
            TablesCommand::EmptyCell => self.put_into_cell(None),
            TablesCommand::TakeStandard => self.take_standard(),
            TablesCommand::Undo => self.step_back(Document::undo),
            TablesCommand::Redo => self.step_back(Document::redo),
            TablesCommand::AddColumns => self.add_columns(),
            TablesCommand::RemoveColumn => self.remove_column(),
            TablesCommand::Make => self.make_table(),
            TablesCommand::Use => self.use_shown_table(),
        }
    }

    /// The shown table is another one, or was changed: filter, selection and fields follow.
    fn shown_changed(&mut self) {
        let Some(document) = self.tables.documents.get_mut(self.tables.shown) else { return };
        self.tables.filter = Filter::of(self.inputs.text(Field::TableFilter), document.table());
        document.keep_selection();
        self.fill_cell_fields();
    }

    /// A text of the page's fields changed.
    pub(super) fn table_field_changed(&mut self, field: Field) {
        match field {
            Field::TableFilter => self.filter_changed(),
            Field::CellUpper | Field::CellLower => self.check_cell_fields(),
            _ => _ = self.tables.errors.remove(&field),
        }
    }
}
