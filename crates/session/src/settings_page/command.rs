//! What can be done on the settings page. What a setting changes is a command of whatever it belongs to.

use super::{Section, SettingsField};

/// What can be done on the settings page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SettingsCommand {
    /// Replaces the text of a field.
    Type(SettingsField, String),
    /// Shows a section, and no longer what was looked for.
    Show(Section),
}
