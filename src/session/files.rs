//! Dialogs, and what comes back from files: every answer is reported, in the dialog or as a notice.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use jiff::civil::DateTime;

use super::Session;
use super::command::{Effect, Purpose};
use super::shared::{MaskChoice, News};
use crate::control::mask::Mask;
use crate::files::FileError;
use crate::journal::Record;
use crate::message::{Message, Say as _};
use crate::report::{RENDERINGS, Report};
use crate::tolerance::DeviationTable;
use crate::words::Words;

impl Session {
    pub(super) fn open_dialog(&mut self, purpose: Purpose) {
        let path = match purpose {
            Purpose::Export(format) => {
                let ending = RENDERINGS.get(format).and_then(|rendering| rendering.endings.first());
                ending.map(|ending| format!("fitcheck.{ending}")).unwrap_or_default()
            }
            Purpose::ExportStatus => "fitcheck-status.txt".to_owned(),
            Purpose::SaveTable(format) => self.tables.file_name(format),
            Purpose::SaveWorkpiece => "workpiece.toml".to_owned(),
            Purpose::SaveCycleLog => self.cycles.log().map_or_else(String::new, |log| log.name.clone()),
            _ => String::new(),
        };
        self.shared.open_dialog(purpose, path);
    }

    pub(super) fn picked(&mut self, path: Option<PathBuf>, now: DateTime) -> Vec<Effect> {
        let (Some(dialog), Some(path)) = (&mut self.shared.dialog, path) else { return Vec::new() };
        dialog.path = path.display().to_string();
        self.confirm(now)
    }

    pub(super) fn confirm(&mut self, now: DateTime) -> Vec<Effect> {
        let Some(dialog) = self.shared.dialog.as_ref().filter(|dialog| !dialog.busy) else { return Vec::new() };
        let (purpose, path) = (dialog.purpose, PathBuf::from(dialog.path.trim()));
        match self.errand(purpose, path, now) {
            Ok(effect) => {
                if let Some(dialog) = &mut self.shared.dialog {
                    (dialog.busy, dialog.problem) = (true, None);
                }
                vec![effect]
            }
            Err(problem) => {
                self.shared.refuse_dialog(problem);
                Vec::new()
            }
        }
    }

    /// The effect that a dialog asks for, or why there is none.
    fn errand(&mut self, purpose: Purpose, path: PathBuf, now: DateTime) -> Result<Effect, Message> {
        if path.as_os_str().is_empty() {
            return Err(Message::new("dialog-no-path"));
        }
        let bytes = match purpose {
            Purpose::OpenTable if !self.tables.settle_cell(&mut self.shared) => {
                return Err(Message::new("tables-cell-unreadable"));
            }
            Purpose::SaveTable(format) => self.tables.bytes(format, &path, &mut self.shared)?,
            Purpose::Export(format) => self.export(format, now)?,
            Purpose::SaveWorkpiece => self.shared.workpiece.bytes()?,
            Purpose::SaveCycleLog => {
                let log = self.cycles.log().ok_or_else(|| Message::new("cycles-no-log"))?;
                log.bytes.clone()
            }
            Purpose::ExportStatus => {
                let text = self.check.status_text().ok_or_else(|| Message::new("dialog-no-status"))?;
                text.as_bytes().to_vec()
            }
            _ => return Ok(Effect::Read(purpose, path)),
        };
        Ok(Effect::Save(path, bytes))
    }

    /// The chosen records, or all of them when none is chosen, as a file's bytes.
    fn export(&self, format: usize, now: DateTime) -> Result<Vec<u8>, Message> {
        let Some(rendering) = RENDERINGS.get(format) else { return Err(Message::new("dialog-no-path")) };
        let records: Vec<Record> = self.shared.history.for_report().map(|record| record.as_ref().clone()).collect();
        let words = Words::new(self.shared.language);
        (rendering.render)(&Report::new(now, records), &words).map_err(|error| error.message())
    }

    pub(super) fn close(&mut self) {
        if self.shared.dialog.take().is_none() && !self.shared.notices.is_empty() {
            self.shared.notices.remove(0);
        }
    }

    pub(super) fn mask_read(&mut self, name: String, result: Result<(Box<Mask>, Vec<Message>), Message>) {
        if let Some((mask, details)) = self.shared.file_answered(result) {
            self.shared.note_details(Message::new("mask-loaded-with-warnings").text("name", &name), details);
            self.shared.set_mask(MaskChoice::Own { name, mask: Arc::new(*mask) });
        }
    }

    pub(super) fn tables_read(
        &mut self,
        folder: PathBuf,
        result: Result<(Vec<DeviationTable>, Vec<Message>), Message>,
    ) {
        if let Some((tables, details)) = self.shared.file_answered(result) {
            let message = Message::new("tables-loaded").count("count", tables.len()).text("folder", folder.display());
            self.shared.note(message, details);
            self.use_tables(tables, Some(folder));
        }
    }

    pub(super) fn use_tables(&mut self, own: Vec<DeviationTable>, folder: Option<PathBuf>) {
        self.shared.tables_folder = folder;
        let sources = self.shared.sources.as_ref().clone().with_own(own);
        self.shared.use_sources(sources);
        self.shared.spread(News::OwnTables);
    }

    pub(super) fn saved_file(&mut self, path: &Path, result: Result<(), FileError>) {
        if self.shared.file_answered(result.map_err(|error| error.message())).is_some() {
            self.tables.saved(path);
            self.shared.note(Message::new("file-written").text("path", path.display()), Vec::new());
        }
    }
}
