//! What can be done on the cycles page, and its text fields.

use super::{Step, WorkpieceField};
use crate::control::probe_table::ProbeTable;
use crate::message::Message;
use crate::probing::Contact;
use crate::probing::cycle::{Key, Plane};
use crate::probing::simulated::{Shape, Simulation};

/// What can be done on the cycles page.
#[derive(Debug, Clone)]
pub enum CyclesCommand {
    /// Chooses a cycle by its number; what was typed for the others is kept.
    Choose(u16),
    /// Replaces the text of a field.
    Type(CycleField, String),
    /// Chooses where contacts come from.
    From(ContactsFrom),
    /// Opens or closes the dialog of the simulated workpiece.
    ShowWorkpiece(bool),
    /// Chooses what shape the simulated workpiece has.
    ChooseShape(Shape),
    /// Chooses the plane of a round surface.
    ChoosePlane(Plane),
    /// Makes a simulated workpiece that suits the cycle's inputs.
    SuitWorkpiece,
    /// Takes a row of the touch-probe table by its number.
    ChooseProbe(u32),
    /// Takes the shipped touch-probe table.
    ShippedProbes,
    /// Runs the cycle.
    Run,
    /// Clears the result.
    Clear,
    /// Steps along the path.
    Step(Step),
    /// Opens or closes the field for an NC block.
    ShowBlock(bool),
    /// Replaces the NC block.
    TypeBlock(String),
    /// Fills the form from the NC block.
    TakeBlock,
    /// Puts the form as an NC block on the clipboard.
    CopyBlock,
    /// Puts the results on the clipboard, one a line.
    CopyResults,
    /// Puts the status window's text on the clipboard.
    CopyStatus,
    /// A file of contacts was read, or not.
    ContactsRead {
        /// Its name without the folder.
        name: String,
        /// The contacts, and warnings.
        result: Result<(Vec<Contact>, Vec<Message>), Message>,
    },
    /// A file of a simulated workpiece was read, or not.
    WorkpieceRead(Result<Box<Simulation>, Message>),
    /// A touch-probe table was read, or not.
    ProbesRead {
        /// Its name without the folder.
        name: String,
        /// The table.
        result: Result<ProbeTable, Message>,
    },
}

/// A text field of the cycles page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CycleField {
    /// A parameter of the chosen cycle.
    Parameter(Key),
    /// What PREDEF stands for in a parameter of the chosen cycle.
    Global(Key),
    /// Where the ball stands before the cycle, by axis.
    Position(Axis),
    /// A figure of the simulated workpiece.
    Workpiece(WorkpieceField),
}

/// An axis of the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

impl Axis {
    /// All axes.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// Its letter.
    pub const fn letter(self) -> &'static str {
        match self {
            Self::X => "X",
            Self::Y => "Y",
            Self::Z => "Z",
        }
    }
}

/// Where contacts come from.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum ContactsFrom {
    /// A perfect workpiece at nominal.
    #[default]
    Perfect,
    /// The simulated workpiece.
    Simulated,
    /// Contacts recorded in a file.
    Recorded,
}

impl ContactsFrom {
    /// Every source.
    pub const ALL: [Self; 3] = [Self::Perfect, Self::Simulated, Self::Recorded];
}
