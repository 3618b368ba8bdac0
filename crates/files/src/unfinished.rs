//! What must go if the program ends before it is finished: names of files and folders that nobody else knows yet.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

#[cfg(unix)]
use super::hearing;

/// Everything unfinished at this moment.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn with_all<T>(change: impl FnOnce(&mut BTreeSet<PathBuf>) -> T) -> T {
    change(&mut UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner))
}

/// The name of an unfinished file or folder. It is removed when this is dropped, and when a signal ends the program.
#[derive(Debug)]
pub(super) struct Unfinished(PathBuf);

impl Unfinished {
    /// A file or folder that was just made.
    pub fn at(path: PathBuf) -> Self {
        remove_at_signals();
        // A signal may come in a folder that was changed meanwhile.
        let absolute = std::path::absolute(&path).unwrap_or_else(|_| path.clone());
        with_all(|all| all.insert(absolute));
        Self(path)
    }

    pub fn path(&self) -> &Path {
        &self.0
    }

    /// It has another name now, or is none of ours any more.
    pub fn finished(self) {
        self.forget();
        std::mem::forget(self);
    }

    fn forget(&self) {
        let absolute = std::path::absolute(&self.0).unwrap_or_else(|_| self.0.clone());
        with_all(|all| all.remove(&absolute));
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        remove(&self.0);
        self.forget();
    }
}

/// Removes a file, or a folder with what is in it; links are not followed. Nobody is left to hear of a failure.
pub(super) fn remove(path: &Path) {
    let is_folder = path.symlink_metadata().is_ok_and(|metadata| metadata.is_dir());
    drop(if is_folder { std::fs::remove_dir_all(path) } else { std::fs::remove_file(path) });
}

/// How long whatever goes on has to end after Ctrl+C; it may wait for a pipe that gives nothing.
#[cfg(unix)]
const PATIENCE: std::time::Duration = std::time::Duration::from_secs(2);
/// As long as the program works it gets so often as long: a busy machine may take that until what is done is whole.
#[cfg(unix)]
const TIMES: u32 = 30;

/// From the first unfinished name on, SIGINT, SIGTERM and SIGHUP first remove what is unfinished and then end the
/// program as ever. Without a thread for it they end it at once. A SIGINT that is heard as a wish to stop ends nothing by itself.
#[cfg(unix)]
pub(super) fn remove_at_signals() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    static STARTED: std::sync::Once = std::sync::Once::new();
    STARTED.call_once(|| {
        // Whoever started the program with a signal ignored, as `nohup` does, still wants it ignored.
        let wanted = [SIGINT, SIGTERM, SIGHUP].into_iter().filter(|signal| !is_ignored(*signal));
        let Ok(mut signals) = Signals::new(wanted) else { return };
        let handle = move || {
            for signal in signals.forever() {
                if signal == SIGINT && hearing::ask() {
                    end_later(signal);
                } else {
                    end_by(signal);
                }
            }
        };
        drop(std::thread::Builder::new().name("signals".to_owned()).spawn(handle));
    });
}

#[cfg(not(unix))]
pub(super) const fn remove_at_signals() {}

/// Ends the program by a signal, once what is unfinished is removed.
#[cfg(unix)]
fn end_by(signal: i32) {
    with_all(|all| all.iter().for_each(|path| remove_all(path)));
    drop(signal_hook::low_level::emulate_default_handler(signal));
}

/// The same in a while, unless what goes on has ended by then. Without a thread for it the next Ctrl+C does it.
#[cfg(unix)]
fn end_later(signal: i32) {
    let wait = move || {
        for _ in 0..TIMES {
            let before = worked();
            std::thread::sleep(PATIENCE);
            if !hearing::is_awaited() {
                return;
            }
            if worked() == before {
                break;
            }
        }
        end_by(signal);
    };
    drop(std::thread::Builder::new().name("stopping".to_owned()).spawn(wait));
}

/// For how long the program has been on a processor, in hundredths of a second; `None` where the system does not tell it.
#[cfg(unix)]
fn worked() -> Option<u64> {
    let told = std::fs::read_to_string("/proc/self/stat").ok()?;
    // Behind the name of the program, which may have anything in it.
    let mut numbers = told.rsplit_once(')')?.1.split_whitespace().skip(11).map_while(|text| text.parse::<u64>().ok());
    numbers.next()?.checked_add(numbers.next()?)
}

/// Removes what is still being written: until a folder is gone, more files may come into it.
#[cfg(unix)]
fn remove_all(path: &Path) {
    const TRIES: usize = 1_000;
    for _ in 0..TRIES {
        remove(path);
        if path.symlink_metadata().is_err() {
            return;
        }
    }
}

/// Whether the system says that a signal is ignored; where it does not say, it is not.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let Ok(status) = std::fs::read_to_string("/proc/self/status") else { return false };
    let mask = status.lines().find_map(|line| u64::from_str_radix(line.strip_prefix("SigIgn:")?.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}
