//! What is left of a window that panicked: a report in a file beside the state, which the next window tells of.

use std::backtrace::Backtrace;
use std::fmt::Write as _;
use std::panic::PanicHookInfo;
use std::path::{Path, PathBuf};

use crate::files::{self, FileError};
use crate::message::{Message, message};

/// The first words of the names of reports.
const NAME: &str = "crash-";

/// The ending of a report that no window has told of yet.
const UNTOLD: &str = "new.txt";

/// From now on a panic of the window leaves a report in a folder, and says on standard error where it is.
pub(super) fn watch(folder: PathBuf) {
    let before = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        before(info);
        let text = report(info);
        match write(&folder, &text) {
            Ok(path) => log::error!("a report of this fault is in {}", path.display()),
            Err(error) => log::error!("no report of this fault could be written: {error}"),
        }
    }));
}

/// What a maintainer needs, and nothing of what was measured.
fn report(info: &PanicHookInfo<'_>) -> String {
    let mut text =
        format!("Fitcheck {}, {} {}\n", env!("CARGO_PKG_VERSION"), std::env::consts::OS, std::env::consts::ARCH);
    let thread = std::thread::current();
    // Writing into a text cannot fail.
    _ = writeln!(text, "{}, thread {}", files::now(), thread.name().unwrap_or("without a name"));
    _ = writeln!(text, "{info}\n\n{}", Backtrace::force_capture());
    text
}

/// Writes a report under a name of its own.
fn write(folder: &Path, text: &str) -> Result<PathBuf, FileError> {
    std::fs::create_dir_all(folder).map_err(|error| files::system(folder, &error))?;
    let time = files::now().strftime("%Y%m%d-%H%M%S").to_string();
    let path = folder.join(format!("{NAME}{time}-{}.{UNTOLD}", std::process::id()));
    files::write(&path, text.as_bytes())?;
    Ok(path)
}

/// Tells of the reports that are new, and marks them as told.
pub(super) fn tell(folder: &Path) -> Vec<Message> {
    // Without a folder there is no report in it.
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let is_new = |path: &PathBuf| {
        let name = files::name_of(path).to_string_lossy();
        name.starts_with(NAME) && name.ends_with(UNTOLD)
    };
    let told = |path: PathBuf| {
        let name = files::name_of(&path).to_string_lossy().replace(UNTOLD, "txt");
        let kept = path.with_file_name(name);
        // A report that cannot be renamed is told of again.
        let path = if std::fs::rename(&path, &kept).is_ok() { kept } else { path };
        message!("crash-report").text("path", path.display())
    };
    let mut found: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).filter(is_new).collect();
    found.sort();
    found.into_iter().map(told).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report_is_told_of_once_and_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = write(folder.path(), "what happened").unwrap();
        let told = tell(folder.path());
        assert_eq!(told.len(), 1);
        assert!(!path.exists());
        let kept = path.with_file_name(files::name_of(&path).to_string_lossy().replace("new.txt", "txt"));
        assert_eq!(std::fs::read_to_string(kept).unwrap(), "what happened");
        assert!(tell(folder.path()).is_empty(), "once");
        assert!(tell(&folder.path().join("nothing")).is_empty());
    }
}
