//! A probing and its contact, and the trait of everything that makes contacts.

use crate::length::Length;
use crate::message::Say;

/// A point in millimetres, in the workpiece's coordinates: on the workpiece's surface, or the centre of the ball where
/// a [`Prober`] has a ball that touches.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Contact {
    /// Reference axis.
    pub x: f64,
    /// Minor axis.
    pub y: f64,
    /// Probe axis.
    pub z: f64,
}

/// A probing that a cycle asks for: where the probe starts and in which direction it moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// Where the probing movement begins, millimetres.
    pub from: [f64; 3],
    /// Unit vector of the movement.
    pub direction: [f64; 3],
    /// The longest probing path from there, millimetres (DIST of the touch-probe table, K of G785).
    pub longest: f64,
}

impl Contact {
    /// The contact at X, Y, Z.
    pub const fn at([x, y, z]: [f64; 3]) -> Self {
        Self { x, y, z }
    }

    /// X, Y, Z.
    pub const fn place(&self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }
}

/// The probe met nothing on its path.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "contact", error)]
pub enum NoContact {
    /// Nothing lies on the line of the movement.
    Missed {
        /// Which contact of the cycle, from 1.
        number: usize,
    },
    /// Something is there, but farther away than the probing path is long.
    OutOfReach {
        /// Which contact of the cycle, from 1.
        number: usize,
        /// The longest probing path.
        longest: Length,
    },
    /// The movement begins inside the material: a real probe would have collided on its way there.
    InMaterial {
        /// Which contact of the cycle, from 1.
        number: usize,
    },
    /// The movement begins inside the material of a feature of a part.
    InFeature {
        /// Which contact of the cycle, from 1.
        number: usize,
        /// The feature's name.
        feature: String,
    },
    /// The ball comes to the wall of a hole, slot or pocket from behind, where nothing says how thick the material is.
    Behind {
        /// Which contact of the cycle, from 1.
        number: usize,
        /// The feature's name.
        feature: String,
    },
    /// The ball meets two features of a part at once, or a wall that is missing within another feature.
    Ambiguous {
        /// Which contact of the cycle, from 1.
        number: usize,
        /// The feature's name.
        feature: String,
        /// The other feature's name.
        other: String,
    },
    /// A recorded contact is where the ball could not come to from where its probing begins.
    BeyondTravel {
        /// Which contact of the cycle, from 1.
        number: usize,
        /// How far it is from there, to a hundredth of a millimetre.
        distance: Length,
        /// The longest probing path and the set-up clearance of the touch-probe table.
        allowed: Length,
    },
    /// A recorded contact has no height, and the height is measured.
    NoHeight {
        /// Which contact of the cycle, from 1.
        number: usize,
    },
    /// The recorded contacts are used up.
    UsedUp {
        /// Which contact of the cycle, from 1.
        number: usize,
        /// How many contacts there are.
        available: usize,
    },
}

/// Where a cycle's contacts come from: the simulated workpiece, or contacts recorded in a file.
pub trait Prober {
    /// Makes one probing.
    ///
    /// # Errors
    /// [`NoContact`] when nothing is met.
    fn touch(&mut self, touch: &Touch) -> Result<Contact, NoContact>;

    /// The ball's radius as calibrated, millimetres. Above zero, contacts are places of the ball's centre; at zero,
    /// they are points of the surface.
    fn ball_radius(&self) -> f64 {
        0.0
    }

    /// Whether its contacts were recorded: then nothing but their places says of which feature they are.
    fn is_recorded(&self) -> bool {
        false
    }

    /// Whether the height of its contacts is known. Where it is not, they have the height 0 and nothing may depend on it.
    fn has_heights(&self) -> bool {
        true
    }
}

/// Contacts recorded in a file, returned in their order, whichever probings the cycle asks for.
#[derive(Debug, Clone)]
pub struct Recorded {
    contacts: Vec<Contact>,
    next: usize,
    has_heights: bool,
}

impl Recorded {
    /// Contacts in probing order.
    pub const fn new(contacts: Vec<Contact>) -> Self {
        Self { contacts, next: 0, has_heights: true }
    }

    /// The same, and whether their heights were recorded, too.
    #[must_use]
    pub const fn with_heights(mut self, has_heights: bool) -> Self {
        self.has_heights = has_heights;
        self
    }

    /// How many contacts there are, and how many of them have been returned.
    pub fn handed_out(&self) -> (usize, usize) {
        (self.contacts.len(), self.next.min(self.contacts.len()))
    }
}

impl Prober for Recorded {
    /// The next contact of the record.
    ///
    /// # Errors
    /// [`NoContact::UsedUp`] when there is none left.
    fn touch(&mut self, _touch: &Touch) -> Result<Contact, NoContact> {
        let contact = self.contacts.get(self.next).copied();
        self.next += 1;
        contact.ok_or(NoContact::UsedUp { number: self.next, available: self.contacts.len() })
    }

    fn is_recorded(&self) -> bool {
        true
    }

    fn has_heights(&self) -> bool {
        self.has_heights
    }
}
