//! Programs from files, and what is typed into the page's fields.

use std::path::PathBuf;

use super::{Document, Origin, ProgramField, WorkpieceFrom};
use crate::message::{Message, Say as _};
use crate::nc::machine::Shipped;
use crate::nc::program::ProgramWarning;
use crate::session::Session;

/// How many files are remembered.
const MOST_RECENT: usize = 8;

impl Session {
    /// The page is opened: the first time with the shipped program of the window's language.
    pub(in crate::session) fn open_program_page(&mut self) {
        if self.program.origin.is_some() {
            return;
        }
        let dialogue = self.language.dialogue();
        if let Some((_, name)) = Shipped::main_programs().find(|(known, _)| *known == dialogue) {
            self.open_shipped(name);
        }
    }

    pub(super) fn open_shipped(&mut self, name: &'static str) {
        let Some(bytes) = Shipped::file(name) else {
            return self.tell(Message::new("program-page-not-shipped").text("name", name));
        };
        match Document::read(name, bytes) {
            Ok((document, warnings)) => self.open_program(Origin::Shipped(name), document, warnings),
            Err(error) => self.tell(error.message()),
        }
    }

    pub(super) fn program_read(
        &mut self,
        path: PathBuf,
        result: Result<(Box<Document>, Vec<ProgramWarning>), Message>,
    ) {
        match result {
            Ok((document, warnings)) => {
                self.file_done();
                let recent = &mut self.program.recent;
                recent.retain(|known| *known != path);
                recent.insert(0, path.clone());
                recent.truncate(MOST_RECENT);
                self.open_program(Origin::File(path), *document, warnings);
            }
            Err(problem) => self.file_failed(problem),
        }
    }

    fn open_program(&mut self, origin: Origin, document: Document, warnings: Vec<ProgramWarning>) {
        let path = document.path().clone();
        let page = &mut self.program;
        let sign = self.language.decimal_sign().to_string();
        page.texts.retain(|field, _| !matches!(field, ProgramField::Input(_)));
        for (input, text) in document.assigned() {
            let text = if input.unit().is_empty() { text.clone() } else { text.replace('.', &sign) };
            page.texts.insert(ProgramField::Input(*input), text);
        }
        page.breakpoints.clear();
        page.given.clear();
        page.documents.clear();
        page.documents.insert(path.clone(), document);
        (page.main, page.shown, page.origin) = (Some(path.clone()), Some(path), Some(origin));
        page.warnings = warnings;
        (page.looks, page.look) = (page.looks.wrapping_add(1), 0);
        page.check_inputs();
        self.reset_program();
    }

    pub(super) fn type_program_field(&mut self, field: ProgramField, text: String) {
        let page = &mut self.program;
        page.texts.insert(field, text);
        match field {
            ProgramField::Input(_) => {
                page.check_inputs();
                self.reset_program();
            }
            ProgramField::Diameter | ProgramField::WorkpieceX | ProgramField::WorkpieceY => {
                page.workpiece = WorkpieceFrom::Given;
                page.check_workpiece();
                self.reset_program();
            }
            ProgramField::Filter => {}
            ProgramField::Name | ProgramField::Value => _ = page.errors.remove(&field),
        }
    }
}
