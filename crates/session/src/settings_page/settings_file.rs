//! A file of settings for a whole shop: the keys of the state file that are settings, and nothing of one person, part or computer.
//!
//! The address of the shop's server is not among them: it has the login of one station. Keys that this version does not know are kept, and
//! written again.

use fitcheck_core::message::{Message, Say as _, message};
use toml::{Table, Value};

use super::{Control, SETTINGS};
use crate::field::Field;
use crate::saved::{Saved, SavedError};
use crate::texts::KeptField as _;

/// The keys of the state file that the file has besides texts.
const SHARED: [&str; 13] = [
    "language",
    "theme",
    "keypad",
    "sounds",
    "density",
    "rows",
    "decimal",
    "zoom",
    "source",
    "standard",
    "tables_folder",
    "mask",
    "own_texts",
];

/// What was read from such a file.
#[derive(Debug)]
pub(super) struct SettingsFile {
    /// The state with the settings of the file in it.
    pub wanted: Saved,
    /// The keys that this version does not know.
    pub unknown: Table,
}

/// A setting that is a text.
pub(super) struct TextSetting {
    pub field: Field,
    /// The id of the name of the setting.
    pub name: &'static str,
    /// Its key in the state file.
    pub key: &'static str,
    /// The text of a first start.
    pub first: &'static str,
}

impl TextSetting {
    /// The text that a state has.
    pub fn of(&self, saved: &Saved) -> String {
        saved.inputs.texts.get(self.key).map_or_else(|| self.first.to_owned(), Clone::clone)
    }
}

/// The settings that are texts.
pub(super) fn texts() -> impl Iterator<Item = TextSetting> {
    SETTINGS.iter().filter_map(|setting| match setting.control {
        Control::Field(Field::Check(field), ..) => {
            let (key, first) = field.declared();
            Some(TextSetting { field: Field::Check(field), name: setting.name, key, first })
        }
        _ => None,
    })
}

fn broken(reason: &impl ToString) -> SavedError {
    SavedError::Broken { reason: reason.to_string() }
}

fn table_of(saved: &Saved) -> Result<Table, SavedError> {
    Table::try_from(saved).map_err(|error| broken(&error))
}

/// The bytes of such a file.
///
/// # Errors
/// [`SavedError`] where a setting cannot be said in the format.
pub(super) fn write(saved: &Saved, unknown: &Table) -> Result<Vec<u8>, SavedError> {
    let mut all = table_of(saved)?;
    let mut file = unknown.clone();
    for key in ["version"].into_iter().chain(SHARED) {
        file.extend(all.remove_entry(key));
    }
    let mut inputs = if let Some(Value::Table(unknown)) = file.remove("inputs") { unknown } else { Table::new() };
    if let Some(Value::Table(mut kept)) = all.remove("inputs") {
        inputs.extend(kept.remove_entry("judging"));
    }
    let texts = texts().map(|text| (text.key.to_owned(), Value::String(text.of(saved))));
    inputs.insert("texts".to_owned(), Value::Table(texts.collect()));
    file.insert("inputs".to_owned(), Value::Table(inputs));
    Ok(toml::to_string(&file).map_err(|error| broken(&error))?.into_bytes())
}

impl SettingsFile {
    /// Reads such a file into a state. What the file does not have stays as it is; of a state file only settings are taken.
    ///
    /// # Errors
    /// Why it is no such file, or one of a later version.
    pub fn read(text: &str, now: &Saved) -> Result<Self, Message> {
        let said = |error: SavedError| error.message();
        // Its version, and whether every value is one.
        Saved::read(text.as_bytes()).map_err(said)?;
        let mut unknown: Table = toml::from_str(text).map_err(|error| said(broken(&error.message())))?;
        if unknown.remove("version").is_none() {
            return Err(message!("settings-page-no-version"));
        }
        let mut all = table_of(now).map_err(said)?;
        for key in SHARED {
            all.extend(unknown.remove_entry(key));
        }
        if let Some(Value::Table(mut given)) = unknown.remove("inputs") {
            take_inputs(&mut given, &mut all);
            if !given.is_empty() {
                unknown.insert("inputs".to_owned(), Value::Table(given));
            }
        }
        // What else a state file has is known, and no setting.
        let known = table_of(&Saved::default()).map_err(said)?;
        unknown.retain(|key, _| {
            key == "inputs" || (!known.contains_key(key) && !["budget", "mode", "pin", "ruler"].contains(&key))
        });
        let wanted = all.try_into().map_err(|error: toml::de::Error| said(broken(&error.message())))?;
        Ok(Self { wanted, unknown })
    }

    /// What is to be said of the keys that this version does not know.
    pub fn told(&self) -> Vec<Message> {
        self.unknown.keys().map(|key| message!("settings-page-unknown-key").text("key", key)).collect()
    }
}

/// Takes the rule and the texts of settings from a file into a state; what this version does not know stays.
fn take_inputs(given: &mut Table, all: &mut Table) {
    let Some(Value::Table(inputs)) = all.get_mut("inputs") else { return };
    inputs.extend(given.remove_entry("judging"));
    given.remove("by");
    let texts_given = given.remove("texts");
    if let (Some(Value::Table(kept)), Some(Value::Table(mut texts_given))) = (inputs.get_mut("texts"), texts_given) {
        for text in texts() {
            kept.extend(texts_given.remove_entry(text.key));
        }
    }
}
