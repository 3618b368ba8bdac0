//! The state file: what survives a restart. It is kept soon after every change, so that a killed window loses next to
//! nothing. Several windows keep one file: each writes what it has changed, one after the other. What cannot be read is
//! set aside, and the program starts.

use std::fs::{File, TryLockError};
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::files::{self, FileError};
use crate::message::{Message, Say as _, message};
use crate::session::{Saved, SavedError};
use crate::tolerance::fit::materials::Materials;

/// Where the state is kept; `None` keeps nothing.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Store {
    pub(super) path: Option<PathBuf>,
}

impl Store {
    /// In the user's own settings folder, where there is one.
    pub fn of_user() -> Self {
        Self { path: files::settings_folder().map(|folder| folder.join("state.toml")) }
    }

    pub fn at(path: &Path) -> Self {
        Self { path: Some(path.to_owned()) }
    }

    pub const fn nowhere() -> Self {
        Self { path: None }
    }

    /// The folder of the state file.
    pub fn folder(&self) -> Option<&Path> {
        self.path.as_deref().and_then(Path::parent)
    }

    /// The saved state, if there is one, and a notice if it cannot be read. If it cannot be set aside either, nothing is
    /// kept from here on, because that would replace it.
    pub fn load(&mut self) -> (Option<Saved>, Option<Message>) {
        let Some(path) = &self.path else { return (None, None) };
        let error = match read(path) {
            Ok(saved) => return (saved, None),
            Err(error) => error,
        };
        log::error!("{error}");
        match files::set_aside(path) {
            Ok(aside) => (None, Some(message!("state-set-aside").text("path", aside.display()))),
            Err(stays) => {
                let told = message!("state-not-kept").message("reason", stays.message());
                self.path = None;
                (None, Some(told))
            }
        }
    }

    /// What is kept, to look at it; what nothing is kept of is as at the first start.
    ///
    /// # Errors
    /// What is wrong with the file. It stays where it is.
    pub fn kept(&self) -> Result<Saved, Message> {
        let read = self.path.as_deref().map_or(Ok(None), read);
        read.map(Option::unwrap_or_default)
    }

    /// The user's own materials, `materials.toml` beside the state file; `None` where there are none.
    ///
    /// # Errors
    /// What is wrong with the file. It is the user's, so it is not set aside.
    pub fn materials(&self) -> Option<Result<Materials, Message>> {
        let path = self.path.as_ref()?.with_file_name("materials.toml");
        let read = || {
            let bytes = files::read_file(&path).map_err(|error| error.message())?;
            let text = String::from_utf8_lossy(&bytes);
            Materials::read(&text).map_err(|error| {
                message!("materials-refused").text("path", path.display()).message("reason", error.message())
            })
        };
        path.exists().then(read)
    }

    /// Keeps what has changed since `before`, and leaves what another window has changed meanwhile.
    ///
    /// # Errors
    /// What the user should know: the state is not kept, or another one was set aside.
    pub fn save(&self, before: &Saved, after: &Saved) -> Result<(), Message> {
        let Some(path) = &self.path else { return Ok(()) };
        let kept = || -> Result<Option<PathBuf>, Message> {
            let failed = |error: FileError| error.message();
            let written = || after.write().map_err(|error| error.message());
            let folder = path.parent().unwrap_or(path);
            std::fs::create_dir_all(folder).map_err(|error| failed(files::system(folder, &error)))?;
            let _lock = lock(&path.with_extension("lock")).map_err(failed)?;
            let (bytes, aside) = match files::read_file(path) {
                Err(FileError::Missing { .. }) => (written()?, None),
                there => match there.map(|there| after.write_over(before, &there)) {
                    Ok(Ok(bytes)) => (bytes, None),
                    // Another window of a later version keeps more than this one knows.
                    Ok(Err(error @ SavedError::Newer { .. })) => return Err(error.message()),
                    _ => (written()?, Some(files::set_aside(path).map_err(failed)?)),
                },
            };
            files::write(path, &bytes).map_err(failed)?;
            Ok(aside)
        };
        match kept() {
            Ok(None) => Ok(()),
            Ok(Some(aside)) => Err(message!("state-set-aside-now").text("path", aside.display())),
            Err(reason) => Err(message!("state-not-kept").message("reason", reason)),
        }
    }
}

/// The state in a file, where there is one.
fn read(path: &Path) -> Result<Option<Saved>, Message> {
    match files::read_file(path).map(|bytes| Saved::read(&bytes)) {
        Ok(Ok(saved)) => Ok(Some(saved)),
        Err(FileError::Missing { .. }) => Ok(None),
        Ok(Err(error)) => Err(error.message()),
        Err(error) => Err(error.message()),
    }
}

/// Waits a moment for other windows to finish. Where the system knows no locks, windows are on their own.
fn lock(path: &Path) -> Result<Option<File>, FileError> {
    /// A window holds the lock for one small file only.
    const TRIES: usize = 100;
    let open = File::options().create(true).truncate(false).write(true).open(path);
    let file = open.map_err(|error| files::system(path, &error))?;
    for _ in 0..TRIES {
        match file.try_lock() {
            Ok(()) => return Ok(Some(file)),
            Err(TryLockError::WouldBlock) => std::thread::sleep(Duration::from_millis(10)),
            Err(TryLockError::Error(_)) => return Ok(None),
        }
    }
    Err(files::system(path, &std::io::ErrorKind::ResourceBusy.into()))
}
