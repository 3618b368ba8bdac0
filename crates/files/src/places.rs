//! Where what belongs to a user is kept: in the user's own folders, or beside a program that is carried about.

use std::path::PathBuf;

use etcetera::BaseStrategy as _;

/// The name of the folder beside the program that holds everything, where there is such a folder.
const CARRIED: &str = "state";

/// The folder of the program within the user's folders.
const OWN: &str = "fitcheck";

/// The folder for settings, and for what is known of journals elsewhere; `None` where there is none.
pub fn settings_folder() -> Option<PathBuf> {
    carried_folder().or_else(|| Some(etcetera::choose_base_strategy().ok()?.config_dir().join(OWN)))
}

/// The folder for the journal; `None` where there is none. On Windows it stays on this machine: the folder that follows its user lies on a
/// server, where a journal is not safe.
pub fn journal_folder() -> Option<PathBuf> {
    let of_user = || {
        let folders = etcetera::choose_base_strategy().ok()?;
        let data = if cfg!(windows) { folders.cache_dir() } else { folders.data_dir() };
        Some(data.join(OWN))
    };
    carried_folder().or_else(of_user)
}

/// The folder beside the program, where somebody made one.
pub fn carried_folder() -> Option<PathBuf> {
    let program = std::env::current_exe().ok()?;
    Some(program.parent()?.join(CARRIED)).filter(|folder| folder.is_dir())
}
