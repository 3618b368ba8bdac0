//! The pairing page: which measured holes go with which measured shafts.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `field` | the text fields |
//! | `reading` | what the fields mean |
//! | `command`, `apply` | what can be done, and doing it |
//! | `paired` | the answer as the page shows it |
//! | `picture` | all parts as places on one scale, and which of them are in sight |
//!
//! Pairing takes longer than a frame may, so it is an errand: [`Effect::Pair`] asks for it with a number, and an answer with
//! another number than the last one is dropped.

mod actions;
mod apply;
mod command;
mod field;
mod paired;
mod picture;
mod reading;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::{Message, Say};
use fitcheck_core::tolerance::Feature;
use fitcheck_exchange::report::pairing::PairingParts;

pub use actions::{PAIRS, PairingAction};
pub use apply::usable;
pub use command::PairingCommand;
pub use field::PairingField;
pub use paired::{FromMiddle, PairRow, Paired};
pub use picture::{Bin, Marks, PairingView, PairsPicture};

use self::reading::WantedOf;
use super::effect::Effect;
use super::texts::Texts;

/// The state of the pairing page.
#[derive(Debug, Default)]
pub struct PairingPage {
    texts: Texts<PairingField>,
    errors: BTreeMap<PairingField, Message>,
    wanted: Option<WantedOf>,
    group_count: Option<usize>,
    holes: Side,
    shafts: Side,
    /// The number of the last question.
    run: u64,
    /// Whether it asks for anything.
    is_asked: bool,
    /// The number of the question that is being answered.
    at_work: Option<u64>,
    /// The answer to what the page asks now.
    pub paired: Option<Arc<Paired>>,
    /// The place of the selected pair.
    pub selected: Option<usize>,
    /// Goes up whenever the selected pair has to come into sight.
    look: u64,
    errands: Vec<Effect>,
}

/// Holes or shafts.
#[derive(Debug, Default)]
struct Side {
    parts: Option<Arc<PairingParts>>,
    /// The file that is being read, as often as it was asked for.
    awaited: Vec<PathBuf>,
}

impl PairingPage {
    /// Why the parts are not sorted into the groups that were asked for.
    pub fn group_error(&self) -> Option<Message> {
        let sorted = self.paired.as_ref()?.answer.sorted.as_ref()?;
        sorted.as_ref().err().map(Say::message)
    }

    const fn side(&self, feature: Feature) -> &Side {
        match feature {
            Feature::Hole => &self.holes,
            Feature::Shaft => &self.shafts,
        }
    }

    const fn side_mut(&mut self, feature: Feature) -> &mut Side {
        match feature {
            Feature::Hole => &mut self.holes,
            Feature::Shaft => &mut self.shafts,
        }
    }

    /// The measured holes or shafts.
    pub const fn parts(&self, feature: Feature) -> Option<&Arc<PairingParts>> {
        self.side(feature).parts.as_ref()
    }

    /// Whether a file of holes or shafts is being read.
    pub const fn is_reading(&self, feature: Feature) -> bool {
        !self.side(feature).awaited.is_empty()
    }

    /// The side that a dropped file is for, by its number among the files that are dropped at once: sides without parts take
    /// them, holes first. `None` where none is free: nothing is replaced that nobody named.
    pub fn side_of_dropped(&self, number: usize) -> Option<Feature> {
        let is_free = |feature: &Feature| self.parts(*feature).is_none() && !self.is_reading(*feature);
        [Feature::Hole, Feature::Shaft].into_iter().filter(is_free).nth(number)
    }

    /// Whether pairs are being looked for.
    pub const fn is_pairing(&self) -> bool {
        self.is_asked && self.paired.is_none()
    }

    /// Where to look: a number that goes up whenever a pair has to come into sight, and its place.
    pub const fn look(&self) -> (u64, Option<usize>) {
        (self.look, self.selected)
    }
}
