//! Dialogs, and what comes back from files: every answer is reported, in the dialog or as a notice.
//!
//! | file | what |
//! |---|---|
//! | `command` | what can be done |
//! | `content` | what a file gets |
//! | `dialog` | the open dialog: its path, its list, its question |
//! | `folder_list` | the list of a folder |
//! | `kinds` | what a file given from outside is opened for |
//! | `names` | proposed names |
//! | `places` | last folders and recent files |
//! | `reports` | reports as files get them, with what the journal is told of them |
//! | `working` | the file that is being read or written |

mod actions;
mod command;
mod content;
mod dialog;
mod folder_list;
mod kinds;
mod names;
mod places;
pub(crate) mod reports;
mod working;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::tolerance::{Absent, DeviationTable};
use fitcheck_exchange::report::ChartFile;
use fitcheck_files::FileError;
use fitcheck_nc::control::mask::Mask;
use jiff::civil::DateTime;

pub use actions::FilesAction;
pub use command::{FilesCommand, Launch, ReadOutcome};
pub use content::Content;
pub use dialog::{Dialog, DialogId};
pub use folder_list::FolderList;
pub use kinds::{HEAD, OpenError};
pub(super) use names::of_record;
pub(super) use places::Places;
pub use places::RecentFile;
pub use working::Working;

use super::effect::Effect;
use super::help::Sample;
use super::notice::Notice;
use super::page::Page;
use super::purpose::Purpose;
use super::shared::{MaskChoice, News, OwnMask};
use super::{Session, program};

impl Session {
    /// Does something about files.
    pub(super) fn apply_files(&mut self, command: FilesCommand, now: DateTime) -> Vec<Effect> {
        let places = &self.shared.places;
        match command {
            FilesCommand::Open(purpose, path) => return self.open_file(purpose, path, now),
            FilesCommand::OpenRecent(number) => {
                let Some(file) = places.recent.get(number).cloned() else { return Vec::new() };
                return self.open_file(file.purpose, file.path, now);
            }
            FilesCommand::JudgeUnplanned => {
                let Some(path) = self.unplanned_file().map(Path::to_owned) else { return Vec::new() };
                // What it offered is done: the answer is on the page of checks.
                self.shared.notices.close();
                self.shared.open(Page::Check);
                return self.open_file(Purpose::Import, path, now);
            }
            FilesCommand::ForgetRecent => self.shared.places.forget(),
            FilesCommand::Seen { purpose, path, fate } => self.shared.places.seen(purpose, path, fate),
            FilesCommand::Launch(how) => {
                let Some(notice) = self.shared.notices.shown() else { return Vec::new() };
                let Some(path) = notice.file.clone() else { return Vec::new() };
                let Some(purpose) = notice.opens.filter(|_| how == Launch::Open) else {
                    return vec![Effect::Launch(path, how)];
                };
                // What it offered is done, and in sight.
                self.shared.notices.close();
                return self.open_file(purpose, path, now);
            }
            FilesCommand::Working(working) => self.shared.working = working,
            FilesCommand::StopWorking => return vec![Effect::StopWorking],
            FilesCommand::Launched(Ok(())) => {}
            FilesCommand::Launched(Err(problem)) => self.shared.notices.push_first(Notice::of(problem, true)),
            FilesCommand::IsFolder(path) => {
                self.pairing.is_no_file(&path);
                if !self.shared.dialog_waits() {
                    self.shared.tell(FileError::IsFolder { path }.message());
                } else if let Some(dialog) = &mut self.shared.dialog {
                    dialog.apply(FilesCommand::IsFolder(path), None);
                }
            }
            FilesCommand::SetWritten { folder, result } => self.set_written(&folder, result),
            FilesCommand::Take(number) => {
                if let Some(dialog) = &mut self.shared.dialog {
                    dialog.list.select(number);
                }
                return self.confirm(now);
            }
            FilesCommand::Replace(true) => return self.replace(now),
            command => {
                let home = places.home.clone();
                if let Some(dialog) = &mut self.shared.dialog {
                    dialog.apply(command, home);
                }
            }
        }
        Vec::new()
    }

    /// Asks which file is meant; an operator is asked for no name and no folder.
    pub(super) fn ask_for_file(&mut self, purpose: Purpose, now: DateTime) -> Vec<Effect> {
        self.open_dialog(purpose, now);
        if self.is_for_operators() { self.confirm(now) } else { Vec::new() }
    }

    pub(super) fn open_dialog(&mut self, purpose: Purpose, now: DateTime) {
        let path = match purpose {
            Purpose::Export(_) | Purpose::ExportRows(_) if self.lists_rows() => {
                let name = self.check.rows.as_ref().map_or("", |rows| rows.name.as_str());
                let stem = name.split_once('.').map_or(name, |(stem, _)| stem);
                let judged = self.shared.words().say(&message!("rows-file-name").text("name", stem));
                names::dated(&names::allowed(&judged), now, purpose.ending())
            }
            Purpose::Report(_) => self.report_name(now, purpose.ending()),
            Purpose::Export(_) => {
                let several = self.shared.words().get("file-name-checks");
                let records = self.shared.history.for_report().map(Arc::as_ref);
                names::of_records(records, &several, now, purpose.ending())
            }
            Purpose::ReportRecords(_) => {
                let several = self.shared.words().get("file-name-checks");
                let records = self.records.for_report();
                names::of_records(records.iter().map(Arc::as_ref), &several, now, purpose.ending())
            }
            Purpose::ReportPart(_) => self.part_name(now, purpose.ending()),
            Purpose::ExportStatus => {
                let name = self.status_to_export().map_or_else(String::new, |status| status.name);
                names::dated(&names::allowed(&name), now, purpose.ending())
            }
            // A control knows a table and a log by these names.
            Purpose::SaveTable(format) => self.tables.file_name(format),
            Purpose::SaveCycleLog => self.cycles.log().map_or_else(String::new, |log| log.name.clone()),
            Purpose::SaveWorkpiece => "workpiece.toml".to_owned(),
            Purpose::ExportSettings => "fitcheck-settings.toml".to_owned(),
            Purpose::SaveTools => self.tools().map_or_else(String::new, |tools| tools.name.clone()),
            Purpose::SaveBudget => self.budget.document.name(),
            Purpose::SaveStudyBudget => {
                let file = self.statistics.study.file().map_or("", |file| file.name.as_str());
                names::with_ending(file, purpose.ending())
            }
            Purpose::SaveChart => {
                let title = self.statistics.open().map_or_else(String::new, |(feature, _)| feature.key.title(true));
                names::dated(&names::allowed(&title), now, purpose.ending())
            }
            Purpose::SavePlan(_) => names::with_ending(&self.parts.document.name(), purpose.ending()),
            Purpose::SavePairs(_) => {
                let name = self.shared.words().get("pairing-page-file-name");
                names::dated(&names::allowed(&name), now, purpose.ending())
            }
            _ => String::new(),
        };
        self.shared.open_dialog(purpose, path);
    }

    pub(super) fn browse(&self) -> Vec<Effect> {
        let Some(dialog) = &self.shared.dialog else { return Vec::new() };
        let folder = dialog.list.folder().map(Path::to_owned);
        let name = if dialog.purpose.is_reading() { String::new() } else { dialog.path.clone() };
        let browse = Effect::Browse { purpose: dialog.purpose, folder, name };
        vec![Effect::ForDialog(dialog.number, Box::new(browse))]
    }

    pub(super) fn picked(&mut self, path: Option<&Path>, now: DateTime) -> Vec<Effect> {
        let Some(dialog) = self.shared.answered_dialog() else { return Vec::new() };
        dialog.picked(path);
        if path.is_some() { self.confirm(now) } else { Vec::new() }
    }

    pub(super) fn confirm(&mut self, now: DateTime) -> Vec<Effect> {
        let home = self.shared.places.home.as_deref();
        let Some(dialog) = self.shared.dialog.as_mut().filter(|dialog| !dialog.is_waiting()) else { return Vec::new() };
        // A selected folder is gone into.
        let Some(path) = dialog.asked_for(home) else { return Vec::new() };
        self.send(path, false, now)
    }

    /// The user was asked and writes over the file.
    fn replace(&mut self, now: DateTime) -> Vec<Effect> {
        let dialog = self.shared.dialog.as_mut();
        let path = dialog.and_then(|dialog| Some((dialog.purpose, dialog.exists.take()?)));
        // Of a set, the question names one of its files.
        let path = path.map(|(purpose, path)| match path.parent() {
            Some(folder) if purpose.is_folder() => folder.to_owned(),
            _ => path,
        });
        path.map_or_else(Vec::new, |path| self.send(path, true, now))
    }

    /// Sends the dialog's file to work, or says in the dialog why not.
    fn send(&mut self, path: PathBuf, replaces: bool, now: DateTime) -> Vec<Effect> {
        let asking = self.shared.dialog.as_ref().map(|dialog| (dialog.number, dialog.purpose));
        let Some((number, purpose)) = asking else { return Vec::new() };
        match self.errand(purpose, path, now) {
            Ok(effect) => {
                if let Some(dialog) = &mut self.shared.dialog {
                    dialog.begin();
                }
                let effect = match effect {
                    Effect::Save(path, bytes) if replaces => Effect::Replace(path, bytes),
                    Effect::SaveSet { folder, set, .. } => Effect::SaveSet { folder, set, replaces },
                    effect => effect,
                };
                vec![Effect::ForDialog(number, Box::new(effect))]
            }
            Err(problem) => {
                self.shared.refuse_dialog(problem);
                Vec::new()
            }
        }
    }

    /// The file of no part of a plan that the notice tells of.
    pub(crate) fn unplanned_file(&self) -> Option<&Path> {
        let name = self.shared.notices.shown()?.unplanned.as_deref()?;
        let kind = Purpose::Import.kind();
        let recent = self.recent_files().iter().filter(|file| file.purpose.kind() == kind);
        let mut paths = recent.map(|file| file.path.as_path());
        paths.find(|path| path.file_name().is_some_and(|own| own == name))
    }

    /// Reads a file without a dialog, on the page that shows it.
    fn open_file(&mut self, purpose: Purpose, path: PathBuf, now: DateTime) -> Vec<Effect> {
        // Measurements that are dropped on a part that is being measured are its own; a sample is no part's.
        let is_of_walk = purpose == Purpose::Import
            && self.shared.page == Page::Parts
            && self.parts.walking.is_begun()
            && Sample::bytes_at(&path).is_none();
        let purpose = if is_of_walk { Purpose::ImportValues(self.parts.walking.run) } else { purpose };
        if let Some(page) = purpose.page(self.shared.page) {
            self.shared.open(page);
        }
        match self.errand(purpose, path, now) {
            Ok(effect) => vec![effect],
            Err(problem) => {
                self.shared.tell(problem);
                Vec::new()
            }
        }
    }

    /// The effect that a dialog asks for, or why there is none.
    fn errand(&mut self, purpose: Purpose, path: PathBuf, now: DateTime) -> Result<Effect, Message> {
        if path.as_os_str().is_empty() {
            return Err(message!("dialog-no-path"));
        }
        let content: Content = match purpose {
            Purpose::OpenTable if !self.tables.settle_cell(&mut self.shared) => {
                return Err(message!("tables-cell-unreadable"));
            }
            Purpose::SaveTable(format) => self.tables.bytes(format, &path, &mut self.shared)?.into(),
            Purpose::Export(format) => self.export(format, now)?,
            Purpose::Report(format) => self.report_to_write(format, now)?,
            Purpose::ExportRows(form) => {
                let rows = self.check.rows.as_ref().ok_or_else(|| message!("rows-export-not-yet"))?;
                Content::Rows(Box::new(rows.text(form, &self.shared.sources)?))
            }
            Purpose::ReportRecords(format) => self.report_records(format, now)?,
            Purpose::ReportPart(format) => self.report_part(format, now)?,
            Purpose::SaveWorkpiece => self.shared.workpiece.bytes()?.into(),
            Purpose::SaveTools => self.tools_bytes()?.into(),
            Purpose::ExportSettings => self.settings_bytes().map_err(|error| error.message())?.into(),
            Purpose::SaveBudget => self.budget.document.save(&path).into(),
            Purpose::SavePlan(_) => self.parts.document.save(&path).into(),
            Purpose::SaveStudyBudget => {
                let budget = self.statistics.study.budget(now.date());
                budget.ok_or_else(|| message!("statistics-study-no-budget"))?.into_bytes().into()
            }
            Purpose::SaveChart => {
                let format = ChartFile::of(&path).ok_or_else(|| message!("statistics-page-chart-ending"))?;
                Content::Chart { drawing: self.statistics.drawing(&self.shared.report_words())?, format }
            }
            Purpose::SaveCycleLog => {
                let log = self.cycles.log().ok_or_else(|| message!("cycles-no-log"))?;
                log.bytes.clone().into()
            }
            Purpose::ExportStatus => {
                let status = self.status_to_export().ok_or_else(|| message!("dialog-no-status"))?;
                status.text.into_bytes().into()
            }
            Purpose::CreateSet => {
                let set = self.program.creating.set().cloned();
                let set = set.ok_or_else(|| message!("program-page-create-nothing"))?;
                return Ok(Effect::SaveSet { folder: path, set, replaces: false });
            }
            Purpose::SavePairs(format) => self.pairing.content(format)?,
            Purpose::OpenParts(feature) => {
                self.pairing.awaits(feature, path.clone());
                return Ok(Effect::Read(purpose, path));
            }
            _ => return Ok(Effect::Read(purpose, path)),
        };
        Ok(Effect::Save(path, content))
    }

    pub(super) fn close(&mut self) {
        if self.shared.dialog.as_ref().is_some_and(|dialog| dialog.exists.is_some()) {
            // The question is answered with "keep"; the dialog asks for another name.
            _ = self.shared.dialog.as_mut().and_then(|dialog| dialog.exists.take());
        } else if self.shared.dialog.take().is_none() {
            self.shared.notices.close();
        }
    }

    pub(super) fn mask_read(&mut self, path: PathBuf, result: Result<(Box<Mask>, Vec<Message>), Message>) {
        if self.shared.answered.is_none() && self.shared.given_up_mask.take_if(|given_up| *given_up == path).is_some() {
            return;
        }
        let awaited = OwnMask::Awaited(path.clone());
        if let Some((mask, details)) = self.shared.file_answered(result) {
            let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
            self.shared.note_details(message!("mask-loaded-with-warnings").text("name", &name), details);
            self.shared.set_mask(MaskChoice::Own { name, path, mask: Arc::new(*mask) });
        } else if self.shared.own_mask == awaited {
            self.shared.own_mask = OwnMask::Unread(path);
            self.shared.spread(News::OwnMask);
        }
    }

    pub(super) fn tables_read(
        &mut self,
        folder: PathBuf,
        result: Result<(Vec<DeviationTable>, Vec<Message>), Message>,
    ) {
        if self.shared.answered.is_none() && self.shared.given_up.take_if(|given_up| *given_up == folder).is_some() {
            return;
        }
        if let Some((tables, details)) = self.shared.file_answered(result) {
            let message = message!("tables-loaded").count("count", tables.len()).text("folder", folder.display());
            self.shared.note(message, details);
            self.use_tables(tables, Some(folder));
        } else if self.shared.awaits_tables() && self.shared.tables_folder == Some(folder) {
            self.do_without_tables();
        }
    }

    /// The tables that were used the last time cannot be read: limits come from the next source, and say so.
    fn do_without_tables(&mut self) {
        let sources = self.shared.sources.as_ref().clone();
        let absent = match sources.absent() {
            Some(Absent::Awaited(folder)) => Some(Absent::Unread(Arc::clone(folder))),
            other => other.cloned(),
        };
        self.shared.use_sources(sources.with_absent(absent));
    }

    pub(super) fn use_tables(&mut self, own: Vec<DeviationTable>, folder: Option<PathBuf>) {
        if self.shared.awaits_tables() && self.shared.tables_folder != folder {
            self.shared.given_up = self.shared.tables_folder.take();
        }
        self.shared.tables_folder = folder;
        let sources = self.shared.sources.as_ref().clone().with_own(own).with_absent(None);
        self.shared.use_sources(sources);
        self.shared.spread(News::OwnTables);
    }

    /// The files of a set were written, or none of them.
    fn set_written(&mut self, folder: &Path, result: Result<Vec<PathBuf>, FileError>) {
        let dialog = self.shared.answered_dialog().filter(|dialog| dialog.busy);
        let result = match (result, dialog) {
            (Err(FileError::Exists { path }), Some(dialog)) if path != folder => return dialog.ask(path),
            (result, _) => {
                result.map_err(|error| program::no_folder(&error, folder).unwrap_or_else(|| error.message()))
            }
        };
        if let Some(files) = self.shared.file_answered(result) {
            self.shared.places.used(Purpose::CreateSet, &folder.join("set"));
            self.shared.notices.push(program::written(&files, folder));
        }
    }

    pub(super) fn saved_file(&mut self, path: &Path, result: Result<(), FileError>) {
        let details = self.file_written(path, result.is_ok());
        let dialog = self.shared.answered_dialog().filter(|dialog| dialog.busy);
        let purpose = dialog.as_ref().map(|dialog| dialog.purpose);
        let result = match (result, dialog) {
            // The user is asked, or taken to the folder whose name was typed.
            (Err(FileError::Exists { path }), Some(dialog)) => return dialog.ask(path),
            (Err(FileError::IsFolder { path }), Some(dialog)) => return dialog.go_to(path),
            (result, _) => result.map_err(|error| error.message()),
        };
        if self.shared.file_answered(result).is_none() {
            return;
        }
        if let Some(purpose) = purpose {
            self.shared.places.used(purpose, path);
        }
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
        let message = match path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            Some(folder) => message!("file-written").text("name", name).text("folder", folder.display()),
            None => message!("file-written-here").text("name", name),
        };
        let file = Some(path.to_owned());
        // The budget of a study is opened where budgets are.
        let opens = (purpose == Some(Purpose::SaveStudyBudget)).then_some(Purpose::OpenBudget);
        self.shared.notices.push(Notice { details, file, opens, ..Notice::of(message, false) });
    }
}
