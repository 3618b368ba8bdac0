//! What a user should know of a cycle before it is used on a control, and what no simulation shows.

use crate::message::Say;

/// Something to know of a cycle, as the manuals say it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "cycle-note")]
pub enum Note {
    /// The machine builder must enable and adapt the cycle.
    MachineBuilder,
    /// The manuals of the iTNC 530 do not have it: it is for TNC 320, 620, 640 and later controls.
    NotOnItnc530,
    /// The normal is best taken from a CAD or CAM system.
    NormalFromCad,
    /// The control needs a software option.
    SoftwareOption {
        /// Its numbers, before and since they were ordered anew: `#17 / #1-05-1`.
        option: &'static str,
    },
    /// A basic rotation in force ends before the contacts.
    EndsRotation,
    /// The maker recommends another cycle where the control has it.
    Recommended {
        /// The number of the other cycle.
        cycle: &'static str,
    },
}
