//! Dialogs, and what comes back from files: every answer is told, in the dialog or as a notice.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use jiff::civil::DateTime;

use super::command::{Effect, Purpose};
use super::{Dialog, MaskChoice, Notice, Session, measuring};
use crate::control::mask::Mask;
use crate::exchange::Imported;
use crate::files::FileError;
use crate::message::{Message, Say as _};
use crate::report;
use crate::tolerance::{DeviationTable, Sources};
use crate::words::Words;

impl Session {
    pub(super) fn open_dialog(&mut self, purpose: Purpose) {
        let path = match purpose {
            Purpose::Export(format) => {
                let ending = report::RENDERINGS.get(format).and_then(|rendering| rendering.endings.first());
                ending.map(|ending| format!("fitcheck.{ending}")).unwrap_or_default()
            }
            Purpose::ExportStatus => "fitcheck-status.txt".to_owned(),
            Purpose::SaveTable(format) => self.table_file_name(format),
            Purpose::SaveWorkpiece => "workpiece.toml".to_owned(),
            Purpose::SaveCycleLog => self.cycles.log().map_or_else(String::new, |log| log.name.clone()),
            Purpose::Import
            | Purpose::LoadMask
            | Purpose::LoadTables
            | Purpose::OpenTable
            | Purpose::OpenCycleFile(_)
            | Purpose::OpenProgram => String::new(),
        };
        self.dialog = Some(Dialog { purpose, path, problem: None, busy: false });
    }

    pub(super) fn picked(&mut self, path: Option<PathBuf>, now: DateTime) -> Vec<Effect> {
        let (Some(dialog), Some(path)) = (&mut self.dialog, path) else { return Vec::new() };
        dialog.path = path.display().to_string();
        self.confirm(now)
    }

    pub(super) fn confirm(&mut self, now: DateTime) -> Vec<Effect> {
        let Some(dialog) = self.dialog.as_ref().filter(|dialog| !dialog.busy) else { return Vec::new() };
        let text = dialog.path.trim();
        if text.is_empty() {
            self.refuse_dialog(Message::new("dialog-no-path"));
            return Vec::new();
        }
        let path = PathBuf::from(text);
        let purpose = dialog.purpose;
        let effect = match purpose {
            Purpose::Import => Effect::Import(path),
            Purpose::LoadMask => Effect::ReadMask(path),
            Purpose::LoadTables => Effect::ReadTables(path),
            Purpose::OpenTable if !self.settle_cell() => {
                self.refuse_dialog(Message::new("tables-cell-unreadable"));
                return Vec::new();
            }
            Purpose::OpenTable => Effect::ReadTable(path),
            Purpose::SaveTable(format) => match self.table_bytes(format, &path) {
                Ok(bytes) => Effect::Save(path, bytes),
                Err(problem) => {
                    self.refuse_dialog(problem);
                    return Vec::new();
                }
            },
            Purpose::Export(format) => match self.export(format, now) {
                Ok(bytes) => Effect::Save(path, bytes),
                Err(problem) => {
                    self.refuse_dialog(problem);
                    return Vec::new();
                }
            },
            Purpose::OpenCycleFile(file) => Effect::ReadCycleFile(file, path),
            Purpose::OpenProgram => Effect::ReadProgram(path),
            Purpose::SaveWorkpiece => match self.workpiece_bytes() {
                Ok(bytes) => Effect::Save(path, bytes),
                Err(problem) => {
                    self.refuse_dialog(problem);
                    return Vec::new();
                }
            },
            Purpose::SaveCycleLog => {
                let Some(log) = self.cycles.log() else {
                    self.refuse_dialog(Message::new("cycles-no-log"));
                    return Vec::new();
                };
                Effect::Save(path, log.bytes.clone())
            }
            Purpose::ExportStatus => {
                let Some(text) = self.status_text() else {
                    self.refuse_dialog(Message::new("dialog-no-status"));
                    return Vec::new();
                };
                Effect::Save(path, text.into_bytes())
            }
        };
        if let Some(dialog) = &mut self.dialog {
            (dialog.busy, dialog.problem) = (true, None);
        }
        vec![effect]
    }

    fn refuse_dialog(&mut self, problem: Message) {
        if let Some(dialog) = &mut self.dialog {
            (dialog.busy, dialog.problem) = (false, Some(problem));
        }
    }

    /// Whether the dialog that sent a file to work is still open; it may have been closed, and another one opened.
    fn dialog_waits(&self) -> bool {
        self.dialog.as_ref().is_some_and(|dialog| dialog.busy)
    }

    /// The file that a dialog asked for is done.
    pub(super) fn file_done(&mut self) {
        if self.dialog_waits() {
            self.dialog = None;
        }
    }

    /// The file that a dialog asked for could not be read or written: told in any case.
    pub(super) fn file_failed(&mut self, problem: Message) {
        if self.dialog_waits() { self.refuse_dialog(problem) } else { self.tell(problem) }
    }

    /// The chosen records, or all of them when none is chosen, as a file's bytes.
    fn export(&self, format: usize, now: DateTime) -> Result<Vec<u8>, Message> {
        let all = self.history.iter().enumerate();
        let wanted = all.filter(|(number, _)| self.chosen.is_empty() || self.chosen.contains(number));
        let words = Words::new(self.language);
        measuring::export(format, wanted.map(|(_, record)| record.as_ref().clone()).collect(), &words, now)
    }

    pub(super) fn status_text(&self) -> Option<String> {
        self.shown.as_ref().and_then(|shown| shown.window.clone().ok())
    }

    pub(super) fn close(&mut self) {
        if self.dialog.take().is_none() && !self.notices.is_empty() {
            self.notices.remove(0);
        }
    }

    pub(super) fn imported(&mut self, name: &str, result: Result<Box<Imported>, Message>, now: DateTime) {
        let imported = match result {
            Ok(imported) => *imported,
            Err(problem) => {
                self.file_failed(problem);
                return;
            }
        };
        self.file_done();
        self.notices.push(measuring::import_notice(name, &imported));
        let mut records: Vec<_> = imported.records.into_iter().map(Arc::new).collect();
        if let Some(contacts) = imported.contacts {
            match measuring::judge_contacts(name, &contacts, &self.asked, now) {
                Ok(record) => records.push(Arc::new(record)),
                Err(problem) => self.tell(problem),
            }
        }
        self.add(records);
    }

    pub(super) fn mask_read(&mut self, name: String, result: Result<(Box<Mask>, Vec<Message>), Message>) {
        match result {
            Ok((mask, details)) => {
                self.file_done();
                if !details.is_empty() {
                    let message = Message::new("mask-loaded-with-warnings").text("name", &name);
                    self.notices.push(Notice { message, details, is_problem: false });
                }
                self.set_mask(MaskChoice::Own { name, mask: Arc::new(*mask) });
            }
            Err(problem) => self.file_failed(problem),
        }
    }

    pub(super) fn tables_read(
        &mut self,
        folder: PathBuf,
        result: Result<(Vec<DeviationTable>, Vec<Message>), Message>,
    ) {
        match result {
            Ok((tables, details)) => {
                self.file_done();
                let count = tables.len();
                let message = Message::new("tables-loaded").count("count", count).text("folder", folder.display());
                self.notices.push(Notice { message, details, is_problem: false });
                self.use_tables(tables, Some(folder));
            }
            Err(problem) => self.file_failed(problem),
        }
    }

    pub(super) fn use_tables(&mut self, own: Vec<DeviationTable>, folder: Option<PathBuf>) {
        self.tables_folder = folder;
        let sources = self.sources.as_ref().clone().with_own(own);
        self.use_sources(sources);
        self.folder_of_tables_changed();
    }

    /// Limits from elsewhere: no verdict stays beside limits that it was not made with.
    pub(super) fn use_sources(&mut self, sources: Sources) {
        self.sources = Arc::new(sources);
        self.callout_changed(true);
        self.sources_of_tables_changed();
    }

    pub(super) fn saved_file(&mut self, path: &Path, result: Result<(), FileError>) {
        match result {
            Ok(()) => {
                self.file_done();
                self.table_saved(path);
                let message = Message::new("file-written").text("path", path.display());
                self.notices.push(Notice { message, details: Vec::new(), is_problem: false });
            }
            Err(error) => self.file_failed(error.message()),
        }
    }
}
