//! The settings page: everything that can be set, in sections, and a search over all of it.
//!
//! | file | what |
//! |---|---|
//! | here | the state: the shown section, what is looked for |
//! | `section`, `table` | the sections; every setting as a row |
//! | `defaults` | what a first start has |
//! | `searching` | which settings words find |
//! | `settings_file`, `importing` | a file of settings for a whole shop, and what it changes |
//! | `pin` | the PIN that locks the operator's window |
//! | `keys_list` | every key, by the place where it is heard |
//! | `field`, `command`, `actions` | what can be done, and what can be set and is no action of another page |
//!
//! To add a setting, add its row to `table`. An action that chooses, and that no page has, stands in `actions`.

mod actions;
mod command;
mod defaults;
mod field;
mod importing;
mod keys_list;
mod pin;
mod searching;
mod section;
mod settings_file;
mod table;

use std::path::PathBuf;

use fitcheck_core::message::Message;
use fitcheck_core::words::Words;
use jiff::civil::DateTime;

pub use actions::SettingsAction;
pub use command::SettingsCommand;
pub use field::SettingsField;
pub use keys_list::{KeyRow, KeysOfPlace};
pub use section::Section;
pub(super) use table::setting_of;
pub use table::{Control, SETTINGS, Setting, Told};

use super::command::Command;
use super::effect::Effect;
use super::saved::Saved;
use super::shared::{News, Shared};
use super::state::PageState;

/// The state of the settings page.
#[derive(Debug, Default)]
pub struct SettingsPage {
    /// The section that is shown while nothing is looked for.
    pub section: Section,
    /// What is looked for.
    query: String,
    /// A PIN that is to lock the operator's window, as far as it is typed.
    new_pin: String,
    /// The PIN that is tried, as far as it is typed; `None` while none is asked for.
    pin: Option<String>,
    /// What is wrong with one of the two.
    pin_error: Option<(SettingsField, Message)>,
    /// What it finds, as places in [`SETTINGS`]; `None` while nothing is looked for.
    pub found: Option<Vec<usize>>,
    /// The keys of the window; empty while they are not shown.
    pub keys: Vec<KeysOfPlace>,
    /// What the last file of settings had that this version does not know: it is written again.
    unknown: toml::Table,
    /// The file that keeps the settings; `None` where nothing is kept.
    pub state_file: Option<PathBuf>,
}

impl SettingsPage {
    /// The settings that are in sight.
    pub fn shown(&self) -> Vec<&'static Setting> {
        match &self.found {
            Some(found) => found.iter().filter_map(|place| SETTINGS.get(*place)).collect(),
            None => SETTINGS.iter().filter(|setting| setting.section == self.section).collect(),
        }
    }

    fn search(&mut self, shared: &Shared) {
        let words = Words::new(shared.language);
        self.found = (!self.query.trim().is_empty()).then(|| searching::found(&self.query, &words));
        let shows_keys = self.found.is_none() && self.section == Section::Keys;
        self.keys = if shows_keys { keys_list::keys_by_place(&words) } else { Vec::new() };
    }
}

impl PageState for SettingsPage {
    type Command = SettingsCommand;
    type Field = SettingsField;

    fn restored(_saved: &Saved, _shared: &Shared) -> Self {
        Self::default()
    }

    fn apply(&mut self, command: SettingsCommand, shared: &mut Shared, _now: DateTime) -> Vec<Effect> {
        match command {
            SettingsCommand::Type(SettingsField::Find, query) => self.query = query,
            SettingsCommand::Show(section) => {
                self.section = section;
                self.query.clear();
            }
            command => return self.apply_pin(command, shared),
        }
        self.search(shared);
        Vec::new()
    }

    fn follow(&mut self, news: &News, shared: &mut Shared) {
        // The window speaks another language.
        if *news == News::StatusWindow {
            self.search(shared);
        }
    }

    fn typed(field: SettingsField, text: String) -> SettingsCommand {
        SettingsCommand::Type(field, text)
    }

    fn text(&self, field: SettingsField) -> &str {
        match field {
            SettingsField::Find => &self.query,
            SettingsField::NewPin => &self.new_pin,
            SettingsField::Pin => self.pin.as_deref().unwrap_or(""),
        }
    }

    fn error(&self, field: SettingsField) -> Option<&Message> {
        self.pin_error.as_ref().filter(|(of, _)| *of == field).map(|(_, error)| error)
    }

    fn closes(&self) -> Option<Command> {
        let clear = || SettingsCommand::Type(SettingsField::Find, String::new()).into();
        self.found.is_some().then(clear)
    }

    fn is_free_text(&self, _field: SettingsField) -> bool {
        true
    }
}
