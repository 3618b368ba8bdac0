//! What survives a restart: last inputs, language, theme, the folder of tables.
//!
//! A TOML text with a version number. Reading and writing files is done elsewhere.

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::check::MeasureBy;
use super::command::Theme;
use crate::message::Say;
use crate::tolerance::{Base, Feature, iso286};
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
    pub source: Base,
    /// Where editions of ISO 286 differ.
    pub standard: iso286::Options,
    /// The text fields.
    pub inputs: SavedInputs,
    /// The cycles page.
    pub cycles: SavedCycles,
}

/// What is kept of the text fields.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedInputs {
    /// The texts of the check, fit and table page by the keys of their fields; a missing one counts as its default.
    pub texts: BTreeMap<String, String>,
    /// Where the next measurement of the check page comes from.
    pub by: MeasureBy,
    /// Hole or shaft, where the check page's callout does not say it.
    pub feature: Option<Feature>,
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
            source: Base::default(),
            standard: iso286::Options::default(),
            inputs: SavedInputs::default(),
            cycles: SavedCycles::default(),
        }
    }
}

/// Why a saved state cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "saved", error)]
pub enum SavedError {
    /// Not a state that this program wrote.
    Broken {
        /// What the reader says.
        reason: String,
    },
    /// Written by a later version.
    #[say(args(known = VERSION))]
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
    use super::super::{CheckCommand, CheckField, Command, Field, FitField, Session, TablesField};
    use super::*;

    fn now() -> jiff::civil::DateTime {
        jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0)
    }

    #[test]
    fn inputs_survive_a_restart() {
        let mut session = Session::new(Language::Nl);
        session.apply(CheckCommand::Type(CheckField::Callout, "25 H7".into()).into(), now());
        session.apply(CheckCommand::Type(CheckField::Measured, "25,012".into()).into(), now());
        session.apply(Command::SetTheme(Theme::Dark), now());
        let saved = Saved::read(&session.saved().write()).unwrap();
        let (again, effects) = Session::restore(saved);
        assert_eq!(again.text(CheckField::Callout), "25 H7");
        assert_eq!(again.text(CheckField::Measured), "25,012");
        assert_eq!(
            (again.language(), again.theme(), again.check().by()),
            (Language::Nl, Theme::Dark, MeasureBy::Typing)
        );
        assert_eq!(effects, []);
    }

    /// A state file as versions up to 1.0 wrote it, with every key.
    const OLD: &str = r#"version = 1
language = "nl"
theme = "dark"
keypad = true
source = "control-tables"

[standard]
edition = "1988"
js = "rounded"

[inputs]
by = "typing"
feature = "shaft"

[inputs.texts]
callout = "25 h7"
measured = "m"
part = "p"
nominal = "25"
centre-x = "1"
centre-y = "2"
height = "3"
first-angle = "4"
clearance = "5"
centre-tolerance = "6"
true-diameter = "7"
offset-x = "8"
offset-y = "9"
ovality = "10"
lobes = "11"
lobe-height = "12"
surface-scatter = "13"
probe-scatter = "14"
seed = "15"
fit-callout = "16"
hole-measured = "17"
shaft-measured = "18"
temperature = "19"
hole-expansion = "20"
shaft-expansion = "21"
wanted-minimum = "22"
wanted-maximum = "23"
table-filter = "24"
cell-upper = "25"
cell-lower = "26"
table-classes = "27"
table-to = "28"

[cycles]
cycle = 421

[cycles.texts]
"421 Q273" = "50"
"#;

    #[test]
    fn an_old_state_is_read_and_written_with_the_same_keys() {
        let saved = Saved::read(OLD.as_bytes()).unwrap();
        let (session, _) = Session::restore(saved.clone());
        let fields: [(Field, &str); 8] = [
            (CheckField::Callout.into(), "25 h7"),
            (CheckField::FirstAngle.into(), "4"),
            (CheckField::Seed.into(), "15"),
            (FitField::Callout.into(), "16"),
            (FitField::WantedMaximum.into(), "23"),
            (TablesField::Filter.into(), "24"),
            (TablesField::CellLower.into(), "26"),
            (TablesField::To.into(), "28"),
        ];
        for (field, text) in fields {
            assert_eq!(session.text(field), text, "{field:?}");
        }
        assert_eq!(session.saved(), saved);
        let written = String::from_utf8(session.saved().write()).unwrap();
        for line in OLD.lines() {
            assert!(written.lines().any(|other| other == line), "{line} in {written}");
        }
    }

    #[test]
    fn a_broken_or_newer_state_is_refused() {
        assert!(matches!(Saved::read(b"language = 7"), Err(SavedError::Broken { .. })));
        assert!(matches!(Saved::read(b"\xff\xff"), Err(SavedError::Broken { .. })));
        assert_eq!(Saved::read(b"version = 2"), Err(SavedError::Newer { version: 2 }));
        assert_eq!(Saved::read(b"").unwrap(), Saved::default());
    }
}
