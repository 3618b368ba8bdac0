//! How commands and news change the table page.

use std::path::Path;

use fitcheck_core::message::Message;
use jiff::civil::DateTime;

use super::{Document, Origin, TableChoice, TablesCommand, TablesField, TablesPage};
use crate::effect::Effect;
use crate::page::Page;
use crate::saved::Saved;
use crate::shared::{News, Shared};
use crate::state::PageState;
use crate::texts::Texts;

impl PageState for TablesPage {
    type Command = TablesCommand;
    type Field = TablesField;

    fn restored(saved: &Saved, _shared: &Shared) -> Self {
        Self { texts: Texts::restored(&saved.inputs.texts), ..Self::default() }
    }

    fn save(&self, saved: &mut Saved) {
        saved.inputs.texts.extend(self.texts.saved());
    }

    fn apply(&mut self, command: TablesCommand, shared: &mut Shared, _now: DateTime) -> Vec<Effect> {
        let used = self.is_used(&shared.sources);
        self.obey(command, shared);
        if used {
            self.use_edited(shared);
        }
        Vec::new()
    }

    fn follow(&mut self, news: &News, shared: &mut Shared) {
        match news {
            News::Opened(Page::Tables) => self.opened(shared),
            News::Sources => self.sources_changed(shared),
            News::OwnTables => self.own_tables_changed(shared),
            _ => {}
        }
    }

    fn text(&self, field: TablesField) -> &str {
        self.texts.text(field)
    }

    fn error(&self, field: TablesField) -> Option<&Message> {
        self.errors.get(&field)
    }

    fn unsaved(&self) -> Vec<String> {
        let unsaved = self.documents.iter().filter(|document| document.is_unsaved());
        unsaved.map(|document| document.title.clone()).collect()
    }

    fn file_written(&mut self, path: &Path, is_whole: bool, _shared: &mut Shared) -> Option<Message> {
        self.table_written(path, is_whole);
        None
    }

    fn is_free_text(&self, field: TablesField) -> bool {
        field == TablesField::Filter
    }
}

impl TablesPage {
    fn type_text(&mut self, field: TablesField, text: String, shared: &mut Shared) {
        self.texts.set(field, text);
        match field {
            TablesField::Filter => self.filter_changed(shared),
            TablesField::CellUpper | TablesField::CellLower => self.check_cell_fields(),
            TablesField::Classes | TablesField::To => _ = self.errors.remove(&field),
        }
    }

    /// Filter, selection and fields follow when the shown table is exchanged or changed.
    pub(super) fn shown_changed(&mut self, shared: &Shared) {
        let Some(filter) = self.filtered(self.texts.text(TablesField::Filter)) else { return };
        self.filter = filter;
        if let Some(document) = self.shown_mut() {
            document.keep_selection();
        }
        self.fill_cell_fields(shared);
    }
}

impl TablesPage {
    /// Does what a command says with the open tables.
    fn obey(&mut self, command: TablesCommand, shared: &mut Shared) {
        // What was typed into the cell is applied before another cell or table is shown. If it cannot be read, the cell
        // stays selected and its field shows why. Other commands are about the cell itself, or come from a file.
        let is_pending = self.cell_is_pending(shared);
        match command {
            TablesCommand::Type(..)
            | TablesCommand::RevertCell
            | TablesCommand::SetCell
            | TablesCommand::EmptyCell
            | TablesCommand::TakeStandard
            | TablesCommand::Read { .. } => {}
            // Undo discards what was typed last.
            TablesCommand::Undo | TablesCommand::Redo if is_pending => {
                self.fill_cell_fields(shared);
                return;
            }
            _ if !self.settle_cell(shared) => return,
            _ => {}
        }
        match command {
            TablesCommand::Type(field, text) => self.type_text(field, text, shared),
            TablesCommand::Open(TableChoice::Document(number)) => self.show_document(number, shared),
            TablesCommand::Open(TableChoice::Own(number)) => {
                if let Some(table) = shared.sources.own().get(number).cloned() {
                    self.open_table(table.as_ref().clone(), Origin::Own, shared);
                }
            }
            TablesCommand::Read { name, result } => self.table_read(&name, result, shared),
            TablesCommand::Select(class, range) => self.select(class, range, shared),
            TablesCommand::Move(step) => self.move_by(step, shared),
            TablesCommand::NextDifference => self.select_difference(true, shared),
            TablesCommand::PreviousDifference => self.select_difference(false, shared),
            TablesCommand::OnlyDifferences(only) => {
                self.only_differences = only;
                self.filter_changed(shared);
            }
            TablesCommand::SetCell => _ = self.settle_cell(shared),
            TablesCommand::RevertCell => self.fill_cell_fields(shared),
            TablesCommand::EmptyCell => self.put_into_cell(None, shared),
            TablesCommand::TakeStandard => self.take_standard(shared),
            TablesCommand::Undo => self.step_back(Document::undo, shared),
            TablesCommand::Redo => self.step_back(Document::redo, shared),
            TablesCommand::AddColumns => self.add_columns(shared),
            TablesCommand::RemoveColumn => self.remove_column(shared),
            TablesCommand::Make => self.make_table(shared),
            TablesCommand::Use => self.use_shown(shared),
        }
    }
}
