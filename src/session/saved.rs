//! What survives a restart: last inputs, language, theme, the folder of tables.
//!
//! A TOML text with a version number. Reading and writing files is done elsewhere.

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::command::{SourceChoice, Theme};
use super::inputs::Inputs;
use crate::tolerance::iso286;
use crate::words::Language;

/// The version that is written.
const VERSION: u32 = 1;

/// The state that is kept.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Saved {
    pub(super) version: u32,
    /// The language of the window.
    pub language: Language,
    /// Light or dark.
    pub theme: Theme,
    /// Whether the keypad is shown.
    pub keypad: bool,
    /// The folder of the user's own tables.
    pub tables_folder: Option<PathBuf>,
    /// What limits are looked up in after the user's own tables.
    pub source: SourceChoice,
    /// Where editions of ISO 286 differ.
    pub standard: iso286::Options,
    /// The text fields.
    pub inputs: Inputs,
    /// The cycles page.
    pub cycles: SavedCycles,
}

/// What is kept of the cycles page.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedCycles {
    /// The chosen cycle's number.
    pub cycle: Option<u16>,
    /// What was typed, by cycle and parameter: `427 Q263`.
    pub texts: BTreeMap<String, String>,
}

impl Default for Saved {
    fn default() -> Self {
        Self {
            version: VERSION,
            language: Language::default(),
            theme: Theme::default(),
            keypad: false,
            tables_folder: None,
            source: SourceChoice::default(),
            standard: iso286::Options::default(),
            inputs: Inputs::default(),
            cycles: SavedCycles::default(),
        }
    }
}

/// Why a saved state cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SavedError {
    /// Not a state that this program wrote.
    #[error("the saved state cannot be read: {reason}")]
    Broken {
        /// What the reader says.
        reason: String,
    },
    /// Written by a later version.
    #[error("the saved state has version {version}, this program knows versions up to {VERSION}")]
    Newer {
        /// Its version.
        version: u32,
    },
}

impl Saved {
    /// Reads a state; what is missing takes its default.
    pub fn read(bytes: &[u8]) -> Result<Self, SavedError> {
        let broken = |reason: String| SavedError::Broken { reason };
        let text = std::str::from_utf8(bytes).map_err(|error| broken(error.to_string()))?;
        let saved: Self = toml::from_str(text).map_err(|error| broken(error.message().to_owned()))?;
        if VERSION < saved.version {
            return Err(SavedError::Newer { version: saved.version });
        }
        Ok(saved)
    }

    /// The bytes to write.
    pub fn write(&self) -> Vec<u8> {
        // Nothing in the state can fail to serialise: texts, enums and a path.
        toml::to_string(self).unwrap_or_default().into_bytes()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Command, Field, MeasureBy, Session};
    use super::*;

    #[test]
    fn inputs_survive_a_restart() {
        let mut session = Session::new(Language::Nl);
        let now = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
        session.apply(Command::Type(Field::Callout, "25 H7".into()), now);
        session.apply(Command::Type(Field::Measured, "25,012".into()), now);
        session.apply(Command::SetTheme(Theme::Dark), now);
        let saved = Saved::read(&session.saved().write()).unwrap();
        let (again, effects) = Session::restore(saved);
        assert_eq!(again.inputs().text(Field::Callout), "25 H7");
        assert_eq!(again.inputs().text(Field::Measured), "25,012");
        assert_eq!(
            (again.language(), again.theme(), again.inputs().by),
            (Language::Nl, Theme::Dark, MeasureBy::Typing)
        );
        assert_eq!(effects, []);
    }

    #[test]
    fn a_broken_or_newer_state_is_refused() {
        assert!(matches!(Saved::read(b"language = 7"), Err(SavedError::Broken { .. })));
        assert!(matches!(Saved::read(b"\xff\xff"), Err(SavedError::Broken { .. })));
        assert_eq!(Saved::read(b"version = 2"), Err(SavedError::Newer { version: 2 }));
        assert_eq!(Saved::read(b"").unwrap(), Saved::default());
    }
}
