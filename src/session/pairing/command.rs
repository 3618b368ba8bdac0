//! What can be done on the pairing page.

use super::PairingField;

/// What can be done on the pairing page.
#[derive(Debug, Clone)]
pub enum PairingCommand {
    /// Replaces the text of a field.
    Type(PairingField, String),
}
