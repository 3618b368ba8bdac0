//! What the cycles page and the program page both measure: the simulated workpiece and recorded contacts.

mod apply;

use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::probing::Contact;
use fitcheck_core::probing::cycle::Plane;
use fitcheck_core::probing::simulated::{Part, Shape, Simulation};
use fitcheck_exchange::exchange::contacts::Contacts;
use fitcheck_exchange::journal::chain::Hash;

use super::cycles::{WorkpieceField, WorkpieceForm};

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
    /// The contacts that were read last, on whichever page.
    pub recorded: Option<Arc<RecordedContacts>>,
    /// A part of several features.
    pub part: Option<Arc<OpenPart>>,
}

impl SimulatedWorkpiece {
    /// The simulated machine, or what is wrong with its first field.
    pub fn machine(&self) -> Result<&Simulation, Message> {
        let wrong = || self.form.problem().unwrap_or_else(|| message!("cycles-no-workpiece"));
        self.form.simulation.as_ref().ok_or_else(wrong)
    }

    /// The simulated machine as a file's bytes.
    pub fn bytes(&self) -> Result<Vec<u8>, Message> {
        let refused = |error: toml::ser::Error| message!("cycles-not-written").text("reason", error);
        self.machine()?.write().map(String::into_bytes).map_err(refused)
    }
}
