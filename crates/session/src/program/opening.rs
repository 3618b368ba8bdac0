//! Programs from files, and what is typed into the page's fields.

use std::path::PathBuf;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_exchange::journal::chain::Hash;
use fitcheck_nc::machine::Shipped;
use fitcheck_nc::program::ProgramWarning;

use super::{Document, Input, Origin, ProgramField, ProgramPage, WorkpieceFrom};
use crate::shared::Shared;

impl ProgramPage {
    /// Opens the page; the first time with the built-in program of the window's language.
    pub(super) fn opened(&mut self, shared: &mut Shared) {
        if self.origin.is_some() {
            return;
        }
        let dialogue = shared.language.dialogue();
        if let Some((_, name)) = Shipped::main_programs().find(|(known, _)| *known == dialogue) {
            self.open_shipped(name, shared);
        }
    }

    pub(super) fn open_shipped(&mut self, name: &'static str, shared: &mut Shared) {
        let Some(bytes) = Shipped::file(name) else {
            return shared.tell(message!("program-page-not-shipped").text("name", name));
        };
        match Document::read(name, bytes) {
            Ok((document, warnings)) => {
                self.open_program(Origin::Shipped(name), document, warnings, shared);
                self.sha256 = Some(Hash::of_file(bytes));
            }
            Err(error) => shared.tell(error.message()),
        }
    }

    pub(super) fn program_read(
        &mut self,
        path: PathBuf,
        result: Result<(Box<Document>, Vec<ProgramWarning>), Message>,
        shared: &mut Shared,
    ) {
        if let Some((document, warnings)) = shared.file_answered(result) {
            let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
            self.opened = self.opened.wrapping_add(1);
            self.open_program(Origin::File(path), *document, warnings, shared);
            self.sha256 = shared.recording.of_file(&name);
        }
    }

    fn open_program(&mut self, origin: Origin, document: Document, warnings: Vec<ProgramWarning>, shared: &mut Shared) {
        let path = document.path.clone();
        if self.origin.as_ref() != Some(&origin) {
            self.leave_contacts(shared);
        }
        // A filter of the program before would hide parameters of this one.
        self.texts.retain(|field, _| !matches!(field, ProgramField::Input(_) | ProgramField::Filter));
        for (parameter, text) in document.assigned() {
            let Some(input) = Input::of(*parameter) else { continue };
            let text = if input.unit().is_empty() { text.clone() } else { shared.as_typed(text) };
            self.texts.insert(ProgramField::Input(input), text);
        }
        self.breakpoints.clear();
        self.typed.clear();
        self.documents.clear();
        self.documents.insert(path.clone(), document);
        self.main = Some(path.clone());
        self.shown = Some(path);
        self.origin = Some(origin);
        self.warnings = warnings;
        self.looks = self.looks.wrapping_add(1);
        self.look = 0;
        self.check_inputs();
        self.reset();
    }

    /// Contacts were recorded for one program: another one would judge what it has not probed.
    fn leave_contacts(&mut self, shared: &mut Shared) {
        let Some(recorded) = self.recorded.take() else { return };
        if self.workpiece == WorkpieceFrom::Recorded {
            self.workpiece = WorkpieceFrom::Perfect;
            shared.note(message!("program-page-contacts-left").text("name", &recorded.name), Vec::new());
        }
    }

    pub(super) fn type_text(&mut self, field: ProgramField, text: String) {
        if let ProgramField::Input(input) = field {
            self.type_input(input, text);
            return self.reset();
        }
        if let ProgramField::Tool(parameter) = field {
            self.type_tool(parameter, text);
            return self.reset();
        }
        self.texts.insert(field, text);
        match field {
            ProgramField::Input(_) | ProgramField::Tool(_) | ProgramField::Filter => {}
            ProgramField::Diameter | ProgramField::WorkpieceX | ProgramField::WorkpieceY => {
                self.workpiece = WorkpieceFrom::Given;
                self.check_workpiece();
                self.reset();
            }
            ProgramField::Name | ProgramField::Value => _ = self.errors.remove(&field),
        }
    }
}
