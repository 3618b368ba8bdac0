//! The company that stands at the top of reports whose template names none: its name, its address and its logo.
//!
//! The file of the logo is read as soon as its path is known, and again whenever the reports page is opened. A logo that cannot be read is told
//! beside its field and on the report, which is written all the same.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_exchange::report::image::Image;
use fitcheck_exchange::report::template::{Company, LONGEST, Template};

use super::SettingsField;
use crate::effect::Effect;
use crate::saved::SavedCompany;

/// The company of the settings.
#[derive(Debug, Default)]
pub struct CompanySettings {
    saved: SavedCompany,
    /// The logo that was read, or why there is none; `None` while it is awaited.
    logo: Option<Result<Image, Message>>,
    /// Whether the logo is to be read.
    reads: bool,
}

impl CompanySettings {
    pub(super) fn restored(saved: &SavedCompany) -> Self {
        let mut company = Self { saved: saved.clone(), ..Self::default() };
        company.read_again();
        company
    }

    pub(super) fn saved(&self) -> SavedCompany {
        self.saved.clone()
    }

    /// The logo may be another one now.
    pub(super) fn read_again(&mut self) {
        self.reads = self.path().is_some();
    }

    pub(super) fn type_text(&mut self, field: SettingsField, text: String) {
        match field {
            SettingsField::Company => self.saved.name = text,
            SettingsField::CompanyAddress => self.saved.address = text,
            SettingsField::CompanyLogo => {
                self.saved.logo = text;
                self.logo = None;
                self.read_again();
            }
            _ => {}
        }
    }

    pub(super) fn text(&self, field: SettingsField) -> Option<&str> {
        match field {
            SettingsField::Company => Some(&self.saved.name),
            SettingsField::CompanyAddress => Some(&self.saved.address),
            SettingsField::CompanyLogo => Some(&self.saved.logo),
            _ => None,
        }
    }

    /// Why the logo is not shown.
    pub(super) fn error(&self, field: SettingsField) -> Option<&Message> {
        let of_logo = self.logo.as_ref().filter(|_| field == SettingsField::CompanyLogo);
        of_logo.and_then(|logo| logo.as_ref().err())
    }

    /// The file of the logo: its path, which may be in quotes as systems copy it.
    fn path(&self) -> Option<PathBuf> {
        let path = self.saved.logo.trim().trim_matches('"');
        (!path.is_empty()).then(|| PathBuf::from(path))
    }

    pub(super) fn take_errand(&mut self) -> Option<Effect> {
        let path = self.path().filter(|_| std::mem::take(&mut self.reads))?;
        // A root or a drive: whose folder it is would depend on where the program was started.
        if path.has_root() || path.to_string_lossy().as_bytes().get(1) == Some(&b':') {
            return Some(Effect::ReadLogo(path));
        }
        self.logo = Some(Err(message!("settings-page-company-logo-place").text("given", path.display())));
        None
    }

    /// Takes the logo of a path, unless another path was typed meanwhile.
    pub(super) fn take_logo(&mut self, path: &Path, result: Result<Image, Message>) {
        if self.path().as_deref() == Some(path) {
            self.logo = Some(result);
        }
    }

    /// A template, with the company where it names none.
    pub(crate) fn in_template(&self, template: &Arc<Template>) -> Arc<Template> {
        let text = |text: &str| text.trim().chars().filter(|c| !c.is_control()).take(LONGEST).collect::<String>();
        let address = self.saved.address.split(';').map(text).filter(|line| !line.is_empty()).collect();
        let path = self.path();
        let name = path.as_deref().map(|path| path.file_name().unwrap_or(path.as_os_str()).to_string_lossy());
        let company =
            Company { name: text(&self.saved.name), address, logo: name.map_or_else(String::new, Into::into) };
        if template.company != Company::default() || company == Company::default() {
            return Arc::clone(template);
        }
        let awaited = || Err(message!("parts-page-picture-awaited"));
        let logo = path.map(|_| self.logo.clone().unwrap_or_else(awaited));
        Arc::new(template.of_company(company, logo))
    }
}
