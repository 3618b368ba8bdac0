//! How commands change the simulated workpiece and what is measured beside it.

use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::probing::simulated::Simulation;
use fitcheck_exchange::exchange::contacts::Contacts;

use super::{OpenPart, RecordedContacts, WorkpieceCommand};
use crate::cycles::WorkpieceForm;
use crate::page::Page;
use crate::purpose::{CycleFile, Purpose};
use crate::shared::{News, Shared};

impl Shared {
    /// Asks for a file of the cycles page.
    pub fn open_cycle_file(&mut self, file: CycleFile) {
        self.open_dialog(Purpose::OpenCycleFile(file), String::new());
    }

    /// Does a command. `suited` is a workpiece that suits the open page, or why there is none.
    pub fn apply_workpiece(
        &mut self,
        command: WorkpieceCommand,
        suited: impl FnOnce(&Self) -> Option<Result<Simulation, Message>>,
    ) {
        match command {
            WorkpieceCommand::Show(is_open) => self.workpiece.is_open = is_open,
            WorkpieceCommand::Type(field, text) => self.change_workpiece(|form| form.set(field, text)),
            WorkpieceCommand::ChooseShape(kind) => self.change_workpiece(|form| form.set_shape(kind)),
            WorkpieceCommand::ChoosePlane(plane) => self.change_workpiece(|form| form.set_plane(plane)),
            WorkpieceCommand::Suit => match suited(self) {
                Some(Ok(bench)) => self.change_workpiece(|form| *form = WorkpieceForm::of(&bench)),
                Some(Err(problem)) => self.tell(message!("cycles-cannot-suit").message("problem", problem)),
                None => {}
            },
            WorkpieceCommand::Read(result) => {
                if let Some(bench) = self.file_answered(result) {
                    self.workpiece.form = WorkpieceForm::of(&bench);
                    self.spread(News::WorkpieceTaken);
                }
            }
            WorkpieceCommand::PartRead { name, result } => {
                // A cycle on its own has no place on a part: its page measures one surface.
                let refuses = self.page == Page::Cycles;
                let result = if refuses { result.and(Err(message!("cycles-part-refused"))) } else { result };
                if let Some(part) = self.file_answered(result) {
                    let sha256 = self.recording.of_file(&name);
                    self.workpiece.part = Some(Arc::new(OpenPart { name, part: *part, sha256 }));
                    self.spread(News::PartTaken);
                }
            }
            WorkpieceCommand::ContactsRead { name, result } => {
                if let Some((Contacts { contacts, has_heights, .. }, details)) = self.file_answered(result) {
                    self.note_details(message!("cycles-contacts-loaded").text("name", &name), details);
                    let sha256 = self.recording.of_file(&name);
                    let recorded = RecordedContacts { name, contacts, has_heights, sha256 };
                    self.workpiece.recorded = Some(Arc::new(recorded));
                    self.spread(News::ContactsTaken);
                }
            }
        }
    }

    fn change_workpiece(&mut self, change: impl FnOnce(&mut WorkpieceForm)) {
        change(&mut self.workpiece.form);
        self.spread(News::Workpiece);
    }
}
