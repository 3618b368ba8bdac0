//! The file dialog: a typed path, a list of the folder, and the question whether a file may be replaced.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use fitcheck_core::message::{Message, Say as _};

use super::command::FilesCommand;
use super::folder_list::FolderList;
use crate::purpose::Purpose;

/// The number of a dialog among all that were opened.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct DialogId(pub(crate) u64);

/// An open file dialog. A path can be typed, or chosen in the list.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Dialog {
    /// Its number: what it asked for comes back with it.
    pub number: DialogId,
    pub purpose: Purpose,
    /// The typed path: from the listed folder on, where it does not begin at the root.
    pub path: String,
    /// What went wrong the last time.
    pub problem: Option<Message>,
    /// Whether a file is being read or written.
    pub busy: bool,
    /// The folder's list.
    pub list: FolderList,
    /// The file that the user is asked about: it exists, and would be replaced.
    pub exists: Option<PathBuf>,
    /// Whether the system's dialog gave no path.
    pub nothing_picked: bool,
    /// The name that was proposed.
    proposed: String,
    /// The path behind the text, where it was chosen and not typed: not every name can be written as text.
    chosen: Option<PathBuf>,
}

impl Dialog {
    /// A dialog with a proposed name that begins with a folder.
    pub(crate) fn new(number: DialogId, purpose: Purpose, path: String, folder: Option<&Path>) -> Self {
        let list = FolderList::new(purpose.endings(), purpose.is_folder());
        let mut dialog = Self {
            number,
            purpose,
            proposed: path.clone(),
            path,
            problem: None,
            busy: false,
            list,
            exists: None,
            nothing_picked: false,
            chosen: None,
        };
        if let Some(folder) = folder {
            dialog.show(folder.to_owned());
        }
        dialog
    }

    /// Whether it waits for a file or for an answer.
    pub const fn is_waiting(&self) -> bool {
        self.busy || self.exists.is_some()
    }

    pub(crate) fn type_path(&mut self, path: String) {
        if self.purpose.is_reading() {
            self.list.filter(&path);
        }
        self.path = path;
        self.problem = None;
        self.chosen = None;
        self.list.unselect();
    }

    pub(super) fn begin(&mut self) {
        self.busy = true;
        self.problem = None;
        self.nothing_picked = false;
    }

    /// The system's dialog answered.
    pub(super) fn picked(&mut self, path: Option<&Path>) {
        self.nothing_picked = path.is_none();
        if let Some(path) = path {
            self.list.unselect();
            self.choose(path.to_owned(), path.display().to_string());
        }
    }

    pub(super) fn ask(&mut self, path: PathBuf) {
        self.busy = false;
        self.exists = Some(path);
    }

    /// What was typed is a folder: it is shown.
    pub(super) fn go_to(&mut self, folder: PathBuf) {
        self.busy = false;
        self.path = self.proposed.clone();
        self.show(folder);
    }

    pub(super) fn apply(&mut self, command: FilesCommand, home: Option<PathBuf>) {
        match command {
            FilesCommand::Listed { folder, result } => {
                self.list.read(&folder, result.map_err(|error| error.message()));
            }
            FilesCommand::IsFolder(folder) => self.go_to(folder),
            FilesCommand::Replace(_) => self.exists = None,
            _ if self.is_waiting() => {}
            FilesCommand::Show(folder) => self.show(folder),
            FilesCommand::Up => {
                if let Some(folder) = self.list.parent().map(Path::to_owned) {
                    self.show(folder);
                }
            }
            FilesCommand::Home => {
                if let Some(home) = home {
                    self.show(home);
                }
            }
            FilesCommand::ShowAll(all) => self.list.show_all(all),
            FilesCommand::Move(step) => {
                self.list.step(step);
                self.take_name();
            }
            FilesCommand::Select(number) => {
                self.list.select(number);
                match self.list.selected_entry().filter(|entry| entry.is_folder).map(|entry| entry.path.clone()) {
                    Some(folder) => self.show(folder),
                    None => self.take_name(),
                }
            }
            _ => {}
        }
    }

    /// The path that is asked for; `None` where a selected folder is shown instead.
    pub(super) fn asked_for(&mut self, home: Option<&Path>) -> Option<PathBuf> {
        if let Some(entry) = self.list.selected_entry() {
            let path = entry.path.clone();
            if entry.is_folder {
                self.show(path);
                return None;
            }
            return Some(path);
        }
        if let Some(chosen) = &self.chosen {
            return Some(chosen.clone());
        }
        let typed = Path::new(self.path.trim());
        if typed.as_os_str().is_empty() {
            return Some(PathBuf::new());
        }
        let names_folder = self.names_folder();
        let mut path = match (typed.strip_prefix("~"), home, self.list.folder()) {
            (Ok(rest), Some(home), _) => home.join(rest),
            (_, _, Some(folder)) => folder.join(typed),
            _ => typed.to_owned(),
        };
        if names_folder || self.list.has_folder(&path) {
            self.go_to(path);
            return None;
        }
        // What follows the point of `bore 12.5H7` is no ending.
        let has_ending = self.purpose.is_reading() || self.wants_folder() || Purpose::knows_ending(&path);
        if let Some(mut name) = path.file_name().filter(|_| !has_ending).map(OsStr::to_owned) {
            name.push(format!(".{}", self.purpose.ending()));
            path.set_file_name(name);
        }
        Some(path)
    }

    /// Whether what is typed for a file that is written can only be a folder: its last part is no name, or is ended. A folder is asked
    /// for by whatever name.
    fn names_folder(&self) -> bool {
        let typed = self.path.trim();
        let last = typed.rsplit(std::path::is_separator).next();
        !self.purpose.is_reading()
            && !self.wants_folder()
            && (matches!(last, None | Some("" | "." | "..")) || typed == "~")
    }

    fn wants_folder(&self) -> bool {
        self.purpose.is_folder()
    }

    fn show(&mut self, folder: PathBuf) {
        self.problem = None;
        if self.wants_folder() {
            self.choose(folder.clone(), folder.display().to_string());
        } else {
            // A name that is written goes along to the other folder.
            self.chosen = None;
            if self.purpose.is_reading() {
                self.path.clear();
            }
        }
        self.list.ask(folder);
    }

    fn choose(&mut self, path: PathBuf, shown: String) {
        self.path = shown;
        self.chosen = Some(path);
        self.problem = None;
    }

    /// The name of a selected file stands in the field.
    fn take_name(&mut self) {
        let entry = self.list.selected_entry().filter(|entry| !entry.is_folder);
        if let Some((path, name)) = entry.map(|entry| (entry.path.clone(), entry.name.clone())) {
            self.choose(path, name);
        }
    }
}
