//! The pairing page: which measured holes go with which measured shafts.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `field` | the text fields |
//! | `command`, `apply` | what can be done, and doing it |

mod apply;
mod command;
mod field;

use std::collections::BTreeMap;

pub use command::PairingCommand;
pub use field::PairingField;

use super::field::Texts;
use super::saved::SavedInputs;
use crate::message::Message;

/// The state of the pairing page.
#[derive(Debug, Default)]
pub struct PairingPage {
    texts: Texts<PairingField>,
    errors: BTreeMap<PairingField, Message>,
}

impl PairingPage {
    /// The page with what was saved, or with empty fields.
    pub(super) fn new(saved: &SavedInputs) -> Self {
        Self { texts: Texts::restored(&saved.texts), ..Self::default() }
    }

    pub(super) fn texts(&self) -> impl Iterator<Item = (String, String)> {
        self.texts.saved()
    }

    /// The text of a field.
    pub fn text(&self, field: PairingField) -> &str {
        self.texts.text(field)
    }

    /// What is wrong with a field.
    pub fn error(&self, field: PairingField) -> Option<&Message> {
        self.errors.get(&field)
    }
}
