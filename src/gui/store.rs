//! The state file: what survives a restart. Written whole; a broken one is set aside, and the program starts.

use std::path::{Path, PathBuf};

use etcetera::BaseStrategy as _;

use crate::files::{self, FileError};
use crate::message::{Message, Say as _};
use crate::session::Saved;
use crate::tolerance::fit::materials::Materials;

/// Where the state is kept; `None` keeps nothing.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Store {
    path: Option<PathBuf>,
}

impl Store {
    /// In the user's own settings folder, where there is one.
    pub fn of_user() -> Self {
        let folder = etcetera::choose_base_strategy().ok().map(|folders| folders.config_dir().join("fitcheck"));
        Self { path: folder.map(|folder| folder.join("state.toml")) }
    }

    /// At a path.
    pub fn at(path: &Path) -> Self {
        Self { path: Some(path.to_owned()) }
    }

    /// Nowhere.
    pub const fn nowhere() -> Self {
        Self { path: None }
    }

    /// The saved state, if there is one, and a notice if it was broken.
    pub fn load(&self) -> (Option<Saved>, Option<Message>) {
        let Some(path) = &self.path else { return (None, None) };
        let bytes = match files::read(path) {
            Ok(bytes) => bytes,
            Err(FileError::Missing { .. }) => return (None, None),
            Err(error) => return (None, Some(error.message())),
        };
        match Saved::read(&bytes) {
            Ok(saved) => (Some(saved), None),
            Err(error) => {
                let told = match files::set_aside(path) {
                    Ok(aside) => Message::new("state-set-aside").text("path", aside.display()),
                    Err(error) => error.message(),
                };
                log::error!("{error}");
                (None, Some(told))
            }
        }
    }

    /// The user's own materials, `materials.toml` beside the state file; `None` where there are none.
    ///
    /// # Errors
    /// What is wrong with the file. It is the user's, so it is not set aside.
    pub fn materials(&self) -> Option<Result<Materials, Message>> {
        let path = self.path.as_ref()?.with_file_name("materials.toml");
        let read = || {
            let bytes = files::read(&path).map_err(|error| error.message())?;
            let text = String::from_utf8_lossy(&bytes);
            Materials::read(&text).map_err(|error| {
                Message::new("materials-refused").text("path", path.display()).message("reason", error.message())
            })
        };
        path.exists().then(read)
    }

    /// Keeps a state; a failure is logged, because losing the last inputs must not stop the work.
    pub fn save(&self, saved: &Saved) {
        let Some(path) = &self.path else { return };
        if let Some(folder) = path.parent()
            && let Err(error) = std::fs::create_dir_all(folder)
        {
            return log::error!("{error}: {}", folder.display());
        }
        if let Err(error) = files::write(path, &saved.write()) {
            log::error!("{error}");
        }
    }
}
