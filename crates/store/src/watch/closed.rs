//! Which files nobody writes any more, as far as the system says it.
//!
//! Linux tells when a file that was written is closed, or gets its name (inotify(7)); Windows refuses a reader that allows no writer while there
//! is one. Neither is known of another machine's files on a share, where a file has to be unchanged for a while instead.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// What is known of who writes a file.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Writer {
    /// Nothing: another machine may write it, or somebody has since before it was listened to.
    #[default]
    Unknown,
    /// It was written and not closed since.
    Writes,
    /// It was closed, and not written since.
    Closed,
    /// It got its name when it was written.
    Moved,
}

/// Hears who writes the files of a folder.
#[derive(Debug)]
pub(super) struct Ear {
    #[cfg(target_os = "linux")]
    events: Option<std::os::fd::OwnedFd>,
    /// What was heard last of each file.
    pub(super) writers: BTreeMap<PathBuf, Writer>,
}

#[cfg(target_os = "linux")]
impl Ear {
    pub(super) fn new(folder: &Path) -> Self {
        use rustix::fs::inotify::{CreateFlags, WatchFlags, add_watch, init};
        let begin = || {
            let events = init(CreateFlags::NONBLOCK | CreateFlags::CLOEXEC)?;
            let moves = WatchFlags::MOVED_FROM | WatchFlags::MOVED_TO;
            add_watch(&events, folder, WatchFlags::CLOSE_WRITE | WatchFlags::MODIFY | moves)?;
            rustix::io::Result::Ok(events)
        };
        // Where there are too many of them already, files have to be unchanged for a while.
        Self { events: begin().ok(), writers: BTreeMap::new() }
    }

    /// Hears which files were written since the last time. `renamed` is told which got another name: the one before, and the new one.
    pub(super) fn hear(&mut self, folder: &Path, renamed: &mut dyn FnMut(&Path, &Path)) -> BTreeSet<PathBuf> {
        use std::os::unix::ffi::OsStrExt as _;

        use rustix::fs::inotify::{ReadFlags, Reader};
        let mut written = BTreeSet::new();
        let Some(events) = &self.events else { return written };
        let mut buffer = [std::mem::MaybeUninit::uninit(); 8 << 10];
        let mut reader = Reader::new(events, &mut buffer);
        // What had its name before: whoever writes it may go on under the new one.
        let mut moved = None;
        while let Ok(event) = reader.next() {
            let what = event.events();
            if what.contains(ReadFlags::QUEUE_OVERFLOW) {
                self.writers.clear();
            }
            let Some(name) = event.file_name() else { continue };
            let path = folder.join(std::ffi::OsStr::from_bytes(name.to_bytes()));
            let writer = if what.contains(ReadFlags::MOVED_FROM) {
                let before = self.writers.remove(&path);
                moved = Some((event.cookie(), path, before));
                continue;
            } else if what.contains(ReadFlags::MOVED_TO) {
                match moved.take().filter(|(cookie, ..)| *cookie == event.cookie()) {
                    Some((_, before, writer)) => {
                        renamed(&before, &path);
                        writer.filter(|writer| *writer == Writer::Writes).unwrap_or(Writer::Moved)
                    }
                    None => Writer::Moved,
                }
            } else if what.contains(ReadFlags::CLOSE_WRITE) {
                self.writers.insert(path, Writer::Closed);
                continue;
            } else {
                Writer::Writes
            };
            self.writers.insert(path.clone(), writer);
            written.insert(path);
        }
        written
    }
}

#[cfg(not(target_os = "linux"))]
impl Ear {
    pub(super) fn new(_folder: &Path) -> Self {
        Self { writers: BTreeMap::new() }
    }

    /// Nothing is told by itself.
    pub(super) fn hear(&mut self, _folder: &Path, _renamed: &mut dyn FnMut(&Path, &Path)) -> BTreeSet<PathBuf> {
        BTreeSet::new()
    }
}

impl Ear {
    /// Who writes a file, by what was heard.
    #[cfg(not(windows))]
    pub(super) fn writer(&self, path: &Path, _known: Writer, _rests: bool) -> Writer {
        self.writers.get(path).copied().unwrap_or(Writer::Unknown)
    }

    /// Whether somebody has a file open to write. The system is asked by opening it, and whoever begins to write at that moment is refused: so
    /// it is asked of files that rest, and only until one is closed. One that is written again is a new one.
    #[cfg(windows)]
    pub(super) fn writer(&self, path: &Path, known: Writer, rests: bool) -> Writer {
        use std::os::windows::fs::OpenOptionsExt as _;
        /// FILE_SHARE_READ: other readers are allowed, and no writer.
        const READERS: u32 = 1;
        if known == Writer::Closed {
            return Writer::Closed;
        }
        if !rests {
            return Writer::Writes;
        }
        let opened = std::fs::OpenOptions::new().read(true).share_mode(READERS).open(path);
        if opened.is_ok() { Writer::Closed } else { Writer::Writes }
    }
}
