//! The settings page: everything that can be set, in sections, and a search over all of it.
//!
//! | file | what |
//! |---|---|
//! | here | the state: the shown section, what is looked for |
//! | `section`, `table` | the sections; every setting as a row |
//! | `defaults` | what a first start has |
//! | `searching` | which settings words find |
//! | `settings_file`, `importing` | a file of settings for a whole shop, and what it changes |
//! | `company` | who stands at the top of reports whose template names nobody |
//! | `pin` | the PIN that locks the operator's window |
//! | `keys_list` | every key, by the place where it is heard |
//! | `field`, `command`, `actions` | what can be done, and what can be set and is no action of another page |
//!
//! To add a setting, add its row to `table`. An action that chooses, and that no page has, stands in `actions`.

mod actions;
mod command;
mod company;
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
use jiff::civil::DateTime;

pub use actions::SettingsAction;
pub use command::SettingsCommand;
pub use company::CompanySettings;
pub use field::SettingsField;
pub use keys_list::{KeyRow, KeysOfPlace};
pub use section::Section;
pub(super) use table::setting_of;
pub use table::{Control, SETTINGS, Setting, Told};

use super::command::Command;
use super::effect::Effect;
use super::gauges::{GaugeCommand, Gauges};
use super::page::Page;
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
    /// The gauges on serial and USB ports.
    pub gauges: Gauges,
    /// Who stands at the top of reports whose template names nobody.
    pub company: CompanySettings,
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
        let words = shared.words();
        self.found = (!self.query.trim().is_empty()).then(|| searching::found(&self.query, &words));
        let shows_keys = self.found.is_none() && self.section == Section::Keys;
        self.keys = if shows_keys { keys_list::keys_by_place(&words) } else { Vec::new() };
    }
}

impl PageState for SettingsPage {
    type Command = SettingsCommand;
    type Field = SettingsField;

    fn restored(saved: &Saved, _shared: &Shared) -> Self {
        let company = CompanySettings::restored(&saved.company);
        Self { gauges: Gauges::restored(&saved.gauges), company, ..Self::default() }
    }

    fn save(&self, saved: &mut Saved) {
        saved.gauges = self.gauges.saved();
        saved.company = self.company.saved();
    }

    fn apply(&mut self, command: SettingsCommand, shared: &mut Shared, _now: DateTime) -> Vec<Effect> {
        match command {
            SettingsCommand::Type(SettingsField::Find, query) => self.query = query,
            SettingsCommand::Type(
                field @ (SettingsField::GaugeName
                | SettingsField::GaugePort
                | SettingsField::GaugeSpeed
                | SettingsField::GaugeGave),
                text,
            ) => self.gauges.type_text(field, text),
            SettingsCommand::Type(
                field @ (SettingsField::Company | SettingsField::CompanyAddress | SettingsField::CompanyLogo),
                text,
            ) => self.company.type_text(field, text),
            SettingsCommand::LogoRead { path, result } => self.company.take_logo(&path, result),
            SettingsCommand::Gauge(command) => self.gauges.apply(command, shared),
            SettingsCommand::Show(section) => {
                self.section = section;
                self.query.clear();
                if section == Section::Gauges {
                    self.gauges.apply(GaugeCommand::FindPorts, shared);
                }
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
        if *news == News::Opened(Page::Reports) {
            self.company.read_again();
        }
    }

    fn take_errands(&mut self) -> Vec<Effect> {
        self.gauges.take_errands().into_iter().chain(self.company.take_errand()).collect()
    }

    fn text(&self, field: SettingsField) -> &str {
        match field {
            SettingsField::Find => &self.query,
            SettingsField::NewPin => &self.new_pin,
            SettingsField::Pin => self.pin.as_deref().unwrap_or(""),
            field => self.company.text(field).unwrap_or_else(|| self.gauges.text(field)),
        }
    }

    fn error(&self, field: SettingsField) -> Option<&Message> {
        let of_pin = self.pin_error.as_ref().filter(|(of, _)| *of == field).map(|(_, error)| error);
        of_pin.or_else(|| self.company.error(field)).or_else(|| self.gauges.error(field))
    }

    fn closes(&self) -> Option<Command> {
        let clear = || SettingsCommand::Type(SettingsField::Find, String::new()).into();
        self.found.is_some().then(clear)
    }

    fn is_free_text(&self, field: SettingsField) -> bool {
        !matches!(field, SettingsField::GaugeSpeed | SettingsField::GaugeGave)
    }
}
