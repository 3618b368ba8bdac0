//! One touch of the probe, and whoever makes it.

use crate::words::{Message, Say};

/// A point on the workpiece's surface in millimetres, in the workpiece's coordinates (ball radius already taken into
/// account).
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Contact {
    /// Reference axis.
    pub x: f64,
    /// Minor axis.
    pub y: f64,
    /// Probe axis.
    pub z: f64,
}

/// A touch that a cycle asks for: where the probe starts and in which direction it moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// Where the probing movement begins, millimetres.
    pub from: [f64; 3],
    /// Unit vector of the movement.
    pub direction: [f64; 3],
}

/// The probe met nothing on its way.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NoContact {
    /// Nothing within reach of the movement.
    #[error("touch {number}: no contact on the probing path")]
    Missed {
        /// Which touch of the cycle, from 1.
        number: usize,
    },
    /// The recorded contacts are used up.
    #[error("touch {number}: the file has only {available} contacts")]
    UsedUp {
        /// Which touch of the cycle, from 1.
        number: usize,
        /// How many contacts there are.
        available: usize,
    },
}

impl Say for NoContact {
    fn message(&self) -> Message {
        match self {
            Self::Missed { number } => Message::new("contact-missed").text("number", number),
            Self::UsedUp { number, available } => {
                Message::new("contact-used-up").text("number", number).text("available", available)
            }
        }
    }
}

/// Where a cycle's contacts come from: the simulated workpiece, or contacts recorded in a file.
pub trait Prober {
    /// Makes one touch.
    ///
    /// # Errors
    /// [`NoContact`] when nothing is met.
    fn touch(&mut self, touch: &Touch) -> Result<Contact, NoContact>;
}
