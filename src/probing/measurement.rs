//! What came out of measuring: a diameter, perhaps a centre and contacts, and how it was got.

use std::fmt;
use std::sync::Arc;

use super::circle::Circle;
use super::contact::Contact;
use crate::length::Length;
use crate::words::{Message, Say};

/// A measured diameter and all that is known about it.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    /// The diameter, at the nearest nanometre.
    pub diameter: Length,
    /// The centre in reference and minor axis, where it was measured.
    pub centre: Option<[Length; 2]>,
    /// The contacts in probing order; none for a typed or imported diameter.
    pub contacts: Vec<Contact>,
    /// The least-squares circle through the contacts, unrounded.
    pub circle: Option<Circle>,
    /// Where it comes from.
    pub origin: Origin,
}

/// Where a measurement comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Origin {
    /// A cycle on the simulated workpiece.
    Simulated {
        /// The cycle's number, 421 or 422.
        cycle: u16,
        /// The seed of the scatter: the same seed gives the same contacts.
        seed: u64,
    },
    /// Contacts from a file.
    Contacts {
        /// The file's name without its folder.
        file: Arc<str>,
    },
    /// A diameter from a file.
    Imported {
        /// The file's name without its folder.
        file: Arc<str>,
    },
    /// A diameter that somebody typed.
    Typed,
}

impl Say for Origin {
    fn message(&self) -> Message {
        match self {
            Self::Simulated { cycle, seed } => Message::new("origin-simulated").text("cycle", cycle).text("seed", seed),
            Self::Contacts { file } => Message::new("origin-contacts").text("file", file),
            Self::Imported { file } => Message::new("origin-imported").text("file", file),
            Self::Typed => Message::new("origin-typed"),
        }
    }
}

impl fmt::Display for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Simulated { cycle, seed } => write!(f, "simulated, cycle {cycle}, seed {seed}"),
            Self::Contacts { file } => write!(f, "contacts from {file}"),
            Self::Imported { file } => write!(f, "imported from {file}"),
            Self::Typed => f.pad("typed"),
        }
    }
}

/// What a measurement cannot tell. Said in the window and on every report.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Caveat {
    /// Only one number is known.
    OnlyADiameter,
    /// A circle goes through any three contacts: the residual is always zero.
    ThreeContacts,
    /// Four contacts: two diameters and a mean; four lobes are invisible.
    FourContacts,
    /// More contacts, but still single ones.
    FewContacts {
        /// How many.
        contacts: usize,
    },
    /// The contacts cover less than 180 degrees.
    ShortArc {
        /// The covered arc in whole degrees.
        arc_deg: u16,
    },
}

impl Say for Caveat {
    fn message(&self) -> Message {
        match self {
            Self::OnlyADiameter => Message::new("caveat-only-a-diameter"),
            Self::ThreeContacts => Message::new("caveat-three-contacts"),
            Self::FourContacts => Message::new("caveat-four-contacts"),
            Self::FewContacts { contacts } => Message::new("caveat-few-contacts").count("contacts", *contacts),
            Self::ShortArc { arc_deg } => Message::new("caveat-short-arc").text("arc", arc_deg),
        }
    }
}

impl fmt::Display for Caveat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OnlyADiameter => f.write_str("one diameter only: nothing is known of form and position"),
            Self::ThreeContacts => f.write_str("3 contacts: form cannot be measured"),
            Self::FourContacts => f.write_str("4 contacts: no form seen beyond ovality"),
            Self::FewContacts { contacts } => write!(f, "{contacts} contacts: form between them is not seen"),
            Self::ShortArc { arc_deg } => {
                write!(f, "contacts cover only {arc_deg}°: scatter is magnified in diameter and centre")
            }
        }
    }
}

impl Measurement {
    /// A bare diameter that was typed or imported.
    pub const fn of_diameter(diameter: Length, origin: Origin) -> Self {
        Self { diameter, centre: None, contacts: Vec::new(), circle: None, origin }
    }

    /// What this measurement cannot tell.
    pub fn caveats(&self) -> Vec<Caveat> {
        let mut caveats = vec![match self.contacts.len() {
            0 => Caveat::OnlyADiameter,
            1..=3 => Caveat::ThreeContacts,
            4 => Caveat::FourContacts,
            contacts => Caveat::FewContacts { contacts },
        }];
        if let Some(circle) = &self.circle {
            let arc_deg = super::circle::arc_deg(&self.contacts, circle).round();
            if arc_deg < 180.0 {
                #[expect(
                    clippy::as_conversions,
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "an arc is 0 to 360"
                )]
                caveats.push(Caveat::ShortArc { arc_deg: arc_deg as u16 });
            }
        }
        caveats
    }
}
