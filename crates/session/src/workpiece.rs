//! What the cycles page and the program page both measure: the simulated workpiece and recorded contacts.

use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::probing::Contact;
use fitcheck_core::probing::cycle::Plane;
use fitcheck_core::probing::simulated::{Part, Shape, Simulation};
use fitcheck_exchange::exchange::contacts::Contacts;
use fitcheck_exchange::journal::chain::Hash;

use super::command::Page;
use super::command::{CycleFile, Purpose};
use super::cycles::{WorkpieceField, WorkpieceForm};
use super::shared::{News, Shared};

/// What can be done with the simulated workpiece and with recorded contacts.
#[derive(Debug, Clone)]
pub enum WorkpieceCommand {
    /// Replaces the text of a field.
    Type(WorkpieceField, String),
    /// Opens or closes the dialog of the simulated workpiece.
    Show(bool),
    /// Chooses what kind of surface the simulated workpiece has.
    ChooseShape(Shape),
    /// Chooses the plane of a round surface.
    ChoosePlane(Plane),
    /// Makes a simulated workpiece that suits the inputs of the open page.
    Suit,
    /// A file of a simulated machine was read, or not.
    Read(Result<Box<Simulation>, Message>),
    /// A file of a part with several features was read, or not.
    PartRead {
        /// Its name without the folder.
        name: String,
        result: Result<Box<Part>, Message>,
    },
    /// A file of contacts was read, or not.
    ContactsRead {
        /// Its name without the folder.
        name: String,
        /// The contacts, and warnings.
        result: Result<(Contacts, Vec<Message>), Message>,
    },
}

/// Contacts of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedContacts {
    /// The file's name.
    pub name: String,
    /// The contacts in probing order.
    pub contacts: Vec<Contact>,
    /// Whether the file has their heights.
    pub has_heights: bool,
    /// SHA-256 of the file.
    pub sha256: Option<Hash>,
}

/// A simulated part of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenPart {
    /// The file's name.
    pub name: String,
    pub part: Part,
    /// SHA-256 of the file.
    pub sha256: Option<Hash>,
}

/// The simulated workpiece as it is typed, and the contacts that were read.
#[derive(Debug, Default)]
pub(super) struct SimulatedWorkpiece {
    pub form: WorkpieceForm,
    /// Whether its dialog is open.
    pub is_open: bool,
    pub recorded: Option<Arc<RecordedContacts>>,
    /// A part of several features.
    pub part: Option<Arc<OpenPart>>,
}

impl SimulatedWorkpiece {
    /// The simulated machine, or what is wrong with its first field.
    pub fn machine(&self) -> Result<&Simulation, Message> {
        let wrong = || self.form.problem().unwrap_or_else(|| message!("cycles-no-workpiece"));
        self.form.simulation().ok_or_else(wrong)
    }

    /// The simulated machine as a file's bytes.
    pub fn bytes(&self) -> Result<Vec<u8>, Message> {
        let refused = |error: toml::ser::Error| message!("cycles-not-written").text("reason", error);
        self.machine()?.write().map(String::into_bytes).map_err(refused)
    }
}

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
