//! What the settings of a file change: a command for each that is another one now.

use std::path::Path;

use fitcheck_core::message::{Message, message};
use jiff::civil::DateTime;

use super::settings_file::{self, SettingsFile};
use crate::Session;
use crate::check::CheckCommand;
use crate::command::Command;
use crate::effect::Effect;
use crate::files::FilesCommand;
use crate::notice::Notice;
use crate::page::Page;
use crate::purpose::Purpose;
use crate::saved::{Saved, SavedError};

impl Session {
    /// The bytes of a file with the settings, for a whole shop.
    ///
    /// # Errors
    /// [`SavedError`] where a setting cannot be said in the format.
    pub(crate) fn settings_bytes(&self) -> Result<Vec<u8>, SavedError> {
        settings_file::write(&self.saved(), &self.settings_page.unknown)
    }

    /// Takes the settings of a file that was read, each by its own command, and says which are others now.
    pub(crate) fn settings_read(&mut self, path: &Path, result: Result<String, Message>, now: DateTime) -> Vec<Effect> {
        let saved = self.saved();
        let read = result.and_then(|text| SettingsFile::read(&text, &saved));
        let Some(file) = self.shared.file_answered(read) else { return Vec::new() };
        let changes = changes(&saved, &file.wanted);
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
        let told = message!("settings-page-imported").text("name", name).count("count", changes.len());
        let names = changes.iter().map(|(name, _)| Message::new(name));
        self.shared.note(told, names.chain(file.told()).collect());
        self.settings_page.unknown = file.unknown;
        changes.into_iter().flat_map(|(_, command)| self.apply(command, now)).collect()
    }
}

impl Session {
    /// Whether a command changes a setting on the settings page: what has changed is told, and can be taken back. A text that is being typed
    /// is not.
    pub(crate) const fn is_setting(&self, command: &Command) -> bool {
        let is_here = matches!(self.page(), Page::Settings) || self.by_palette;
        is_here
            && matches!(
                command,
                Command::SetLanguage(_)
                    | Command::SetTheme(_)
                    | Command::SetDensity(_)
                    | Command::SetRows(_)
                    | Command::SetDecimal(_)
                    | Command::SetZoom(_)
                    | Command::ShowKeypad(_)
                    | Command::UseSounds(_)
                    | Command::UseSource(_)
                    | Command::SetStandard(_)
                    | Command::BackToDefaults(_)
                    | Command::Check(
                        CheckCommand::UseRule(_) | CheckCommand::LetProve(_) | CheckCommand::TellUncertainty(_)
                    )
            )
    }

    /// Tells which setting is another one than before, and offers to take that back.
    pub(crate) fn note_setting(&mut self, before: Saved) {
        let changes = changes(&self.saved(), &before);
        let told = match changes.as_slice() {
            [] => return,
            [(name, _)] => message!("settings-page-changed").message("name", Message::new(name)),
            several => message!("settings-page-several-changed").count("count", several.len()),
        };
        self.shared.notices.push(Notice { before: Some(Box::new(before)), ..Notice::of(told, false) });
    }

    /// Sets what a notice tells of back to what it was before.
    pub(crate) fn setting_back(&mut self, now: DateTime) -> Vec<Effect> {
        let Some(before) = self.shared.notices.open().iter().find_map(|notice| notice.before.clone()) else {
            return Vec::new();
        };
        let changes = changes(&self.saved(), &before);
        let effects = changes.into_iter().flat_map(|(_, command)| self.apply(command, now)).collect();
        self.shared.notices.retain(|notice| notice.before.is_none());
        effects
    }
}

/// A command with the name of the setting that it changes.
type Change = (&'static str, Command);

/// What leads from one state to the settings of another one.
fn changes(now: &Saved, wanted: &Saved) -> Vec<Change> {
    let mut changes = Vec::new();
    let mut change = |is_other: bool, name: &'static str, command: Command| {
        if is_other {
            changes.push((name, command));
        }
    };
    change(wanted.language != now.language, "language", Command::SetLanguage(wanted.language));
    change(wanted.theme != now.theme, "settings-page-colours", Command::SetTheme(wanted.theme));
    change(wanted.keypad != now.keypad, "keypad", Command::ShowKeypad(wanted.keypad));
    change(wanted.sounds != now.sounds, "sounds", Command::UseSounds(wanted.sounds));
    change(wanted.density != now.density, "density", Command::SetDensity(wanted.density));
    change(wanted.rows != now.rows, "settings-page-rows", Command::SetRows(wanted.rows));
    change(wanted.decimal != now.decimal, "settings-page-decimal", Command::SetDecimal(wanted.decimal));
    change(wanted.zoom != now.zoom, "settings-page-zoom", Command::SetZoom(wanted.zoom));
    change(wanted.source != now.source, "limits-from", Command::UseSource(wanted.source));
    change(wanted.standard != now.standard, "settings-page-edition", Command::SetStandard(wanted.standard));
    let (judging, before) = (wanted.inputs.judging, now.inputs.judging);
    let rule = CheckCommand::UseRule(judging.rule).into();
    change(judging.rule != before.rule, "settings-page-decision-rule", rule);
    let prover = CheckCommand::LetProve(judging.prover).into();
    change(judging.prover != before.prover, "settings-page-prover", prover);
    let from = CheckCommand::TellUncertainty(judging.from).into();
    change(judging.from != before.from, "settings-page-uncertainty-from", from);
    for text in settings_file::texts() {
        let given = text.of(wanted);
        change(given != text.of(now), text.name, text.field.typed(given));
    }
    for (wanted, now, purpose, name) in [
        (&wanted.tables_folder, &now.tables_folder, Purpose::LoadTables, "settings-page-own-tables"),
        (&wanted.mask, &now.mask, Purpose::LoadMask, "settings-page-own-mask"),
        (&wanted.own_texts, &now.own_texts, Purpose::LoadTexts, "settings-page-own-texts"),
    ] {
        if let Some(path) = wanted.clone().filter(|_| wanted != now) {
            changes.push((name, FilesCommand::Open(purpose, path).into()));
        }
    }
    changes
}
