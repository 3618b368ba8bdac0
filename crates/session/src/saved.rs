//! What survives a restart: last inputs, language, theme, the folder of tables, last folders, recent files.
//!
//! A TOML text with a version number. Reading and writing files is done elsewhere.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use fitcheck_core::message::Say;
use fitcheck_core::tolerance::{Base, iso286};
use fitcheck_core::words::Language;
use fitcheck_exchange::exchange::Remembered;
use fitcheck_exchange::exchange::gauge::{LineUnit, Taught};
use fitcheck_exchange::report::paper::Paper;
use fitcheck_exchange::report::template::Section;
use fitcheck_gauges::PortSettings;
use serde::{Deserialize, Serialize};

use super::check::{MeasureBy, RuleChoice};
use super::ruler::Ruler;
use super::settings::{DecimalSign, Density, Mode, RowHeight, Theme};
use super::zoom::Zoom;

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
    /// Whom the window is for; `None` until somebody has said it.
    pub mode: Option<Mode>,
    /// How large a millimetre is on this screen; `None` until somebody has held a card to it.
    pub ruler: Option<Ruler>,
    /// The salted hash of the PIN that locks the operator's window.
    pub pin: Option<String>,
    /// Whether the keypad is shown.
    pub keypad: bool,
    /// Whether a verdict is heard.
    pub sounds: bool,
    /// How high everything is that is pressed.
    pub density: Density,
    /// How high the rows of lists are.
    pub rows: RowHeight,
    /// What stands before the decimals of a number.
    pub decimal: DecimalSign,
    /// Whether the first steps are done.
    pub welcomed: bool,
    /// The scale of the window in per cent.
    pub zoom: Zoom,
    /// The folder of the user's own tables.
    pub tables_folder: Option<PathBuf>,
    /// The user's own mask, where one is chosen.
    pub mask: Option<PathBuf>,
    /// The file of the user's own texts, where one is chosen.
    pub own_texts: Option<PathBuf>,
    /// The file of the budget that checks use.
    pub budget: Option<PathBuf>,
    /// What limits are looked up in after the user's own tables.
    pub source: Base,
    /// Where editions of ISO 286 differ.
    pub standard: iso286::Options,
    /// The text fields.
    pub inputs: SavedInputs,
    /// The cycles page.
    pub cycles: SavedCycles,
    /// Folders and recent files.
    pub files: SavedFiles,
    /// The columns of files as they were corrected.
    pub columns: Remembered,
    /// Where checks are recorded, and who measures.
    pub records: SavedRecords,
    /// How reports look.
    pub reports: SavedReports,
    /// Who stands at the top of reports whose template names nobody.
    pub company: SavedCompany,
    /// The part that is being measured.
    pub walk: SavedWalk,
    /// The gauges on ports of this computer.
    pub gauges: Vec<SavedGauge>,
}

/// What is kept of a gauge.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedGauge {
    pub name: String,
    /// Whether its port is open while the window is.
    pub on: bool,
    /// What its numbers without a unit are in.
    pub unit: LineUnit,
    pub port: PortSettings,
    /// The form of its lines, where it is not a known one.
    pub taught: Option<Taught>,
}

/// Who stands at the top of reports whose template names nobody.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedCompany {
    pub name: String,
    /// Its lines, with a semicolon between them.
    pub address: String,
    /// The whole path of its logo; empty where it has none.
    pub logo: String,
}

/// What is kept of the reports page.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedReports {
    /// The name of the template; empty for the usual one.
    pub template: String,
    /// Another language than the template's.
    pub language: Option<Language>,
    /// Another paper than the template's.
    pub paper: Option<Paper>,
    /// The sections that are left out.
    pub hidden: BTreeSet<Section>,
}

/// What is kept of recording.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedRecords {
    /// Whether no check is recorded.
    pub off: bool,
    /// The journal, where it is not the usual one.
    pub file: Option<PathBuf>,
    /// Who measures.
    pub who: String,
    /// The names that were used last, the latest first.
    pub names: Vec<String>,
    /// The server of the shop, without a password.
    pub server: Option<String>,
}

/// What is kept of a part that is being measured; its values are in the journal.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedWalk {
    /// The file of its plan; `None` where no part is being measured.
    pub plan: Option<PathBuf>,
    pub serial: String,
    /// The newest record of the journal when it was begun.
    pub since: u64,
    /// What its plan asked for, as a hash.
    pub sizes: String,
    /// The newest record of the journal when the plan came to ask for that.
    pub planned: u64,
    /// The sizes that were left out, with the reasons.
    pub skipped: BTreeMap<String, String>,
    /// The folder that is watched.
    pub watched: Option<SavedWatch>,
}

/// What is kept of a watched folder; what was taken from it is in the journal.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SavedWatch {
    pub folder: PathBuf,
    /// The file of the plan that its values are judged by.
    pub plan: PathBuf,
}

/// What is kept of files.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedFiles {
    /// The folder that was used last.
    pub last_folder: Option<PathBuf>,
    /// The last folder of each kind of thing.
    pub folders: BTreeMap<String, PathBuf>,
    /// The files that were read last, the latest first.
    pub recent: Vec<SavedFile>,
}

/// A file that was read.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedFile {
    /// The kind of thing that it was read as; an unknown one is left out.
    pub kind: String,
    pub path: PathBuf,
}

/// What is kept of the text fields.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedInputs {
    /// The texts of the check, fit and table page by the keys of their fields; a missing one has its default.
    pub texts: BTreeMap<String, String>,
    /// Where the next measurement of the check page comes from.
    pub by: MeasureBy,
    /// How the check page judges.
    pub judging: RuleChoice,
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
            mode: None,
            ruler: None,
            pin: None,
            keypad: false,
            sounds: false,
            density: Density::default(),
            rows: RowHeight::default(),
            decimal: DecimalSign::default(),
            welcomed: false,
            zoom: Zoom::default(),
            tables_folder: None,
            mask: None,
            own_texts: None,
            budget: None,
            source: Base::default(),
            standard: iso286::Options::default(),
            inputs: SavedInputs::default(),
            cycles: SavedCycles::default(),
            files: SavedFiles::default(),
            columns: Remembered::default(),
            records: SavedRecords::default(),
            reports: SavedReports::default(),
            company: SavedCompany::default(),
            walk: SavedWalk::default(),
            gauges: Vec::new(),
        }
    }
}

/// Why a saved state cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "saved", error)]
pub enum SavedError {
    /// Not a state that this program wrote.
    Broken {
        /// The reader's message.
        reason: String,
    },
    /// Written by a later version.
    #[say(args(known = VERSION))]
    Newer { version: u32 },
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

    /// The bytes to write where another window has written meanwhile: what this window has changed since `before` in what is
    /// there now, key by key. Keys that this version does not know stay.
    ///
    /// # Errors
    /// [`SavedError`] where what is there now is no state that this version knows.
    pub fn write_over(&self, before: &Self, there: &[u8]) -> Result<Vec<u8>, SavedError> {
        Self::read(there)?;
        let broken = |reason: String| SavedError::Broken { reason };
        let table = |saved: &Self| toml::Table::try_from(saved).map_err(|error| broken(error.to_string()));
        let text = std::str::from_utf8(there).map_err(|error| broken(error.to_string()))?;
        let mut all: toml::Table = toml::from_str(text).map_err(|error| broken(error.message().to_owned()))?;
        change(&mut all, &table(before)?, &table(self)?);
        Ok(toml::to_string(&all).map_err(|error| broken(error.to_string()))?.into_bytes())
    }

    /// The bytes to write.
    ///
    /// # Errors
    /// [`SavedError`] where the state has something that its format cannot say.
    pub fn write(&self) -> Result<Vec<u8>, SavedError> {
        let text = toml::to_string(self).map_err(|error| SavedError::Broken { reason: error.to_string() })?;
        Ok(text.into_bytes())
    }
}

/// Makes the changes from one table to another in a third.
fn change(all: &mut toml::Table, before: &toml::Table, after: &toml::Table) {
    for (key, value) in after {
        match (value, before.get(key), all.get_mut(key)) {
            (value, Some(before), _) if value == before => {}
            (toml::Value::Table(after), Some(toml::Value::Table(before)), Some(toml::Value::Table(all))) => {
                change(all, before, after);
            }
            _ => {
                all.insert(key.clone(), value.clone());
            }
        }
    }
    for key in before.keys().filter(|key| !after.contains_key(*key)) {
        all.remove(key);
    }
}
