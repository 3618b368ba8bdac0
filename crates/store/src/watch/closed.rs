//! Which files nobody writes any more, as far as the system says it.
//!
//! Linux tells when a file that was written is closed, or gets its name (inotify(7)); Windows refuses a reader that allows no writer while there
//! is one. Neither is known of another machine's files on a share, where a file has to be unchanged for a while instead.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// What is known of who writes a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Writer {
    /// It was written and not closed since.
    Writes,
    /// It was closed, and not written since.
    Closed,
    /// It got its name when it was written.
    Moved,
    /// Nothing: another machine may write it, or somebody has since before it was listened to.
    Unknown,
}

/// Hears who writes the files of a folder.
#[derive(Debug)]
pub(super) struct Closed {
    #[cfg(target_os = "linux")]
    events: Option<std::os::fd::OwnedFd>,
    #[cfg(target_os = "linux")]
    folder: PathBuf,
    writers: BTreeMap<PathBuf, Writer>,
    /// The files that were written since the last look.
    heard: BTreeSet<PathBuf>,
    /// The files that got another name since: the one before, and the new one.
    moves: Vec<(PathBuf, PathBuf)>,
}

#[cfg(target_os = "linux")]
impl Closed {
    pub(super) fn new(folder: &Path) -> Self {
        use rustix::fs::inotify::{CreateFlags, WatchFlags, add_watch, init};
        let begin = || {
            let events = init(CreateFlags::NONBLOCK | CreateFlags::CLOEXEC)?;
            let moves = WatchFlags::MOVED_FROM | WatchFlags::MOVED_TO;
            add_watch(&events, folder, WatchFlags::CLOSE_WRITE | WatchFlags::MODIFY | moves)?;
            rustix::io::Result::Ok(events)
        };
        // Where there are too many of them already, files have to be unchanged for a while.
        let events = begin().ok();
        Self { events, folder: folder.to_owned(), writers: BTreeMap::new(), heard: BTreeSet::new(), moves: Vec::new() }
    }

    /// Hears what has happened since the last time.
    pub(super) fn hear(&mut self) {
        use std::os::unix::ffi::OsStrExt as _;

        use rustix::fs::inotify::{ReadFlags, Reader};
        self.heard.clear();
        let Some(events) = &self.events else { return };
        let mut buffer = [std::mem::MaybeUninit::uninit(); 8 << 10];
        let mut reader = Reader::new(events, &mut buffer);
        // What had its name before: whoever writes it may go on under the new one.
        let mut moved = None;
        while let Ok(event) = reader.next() {
            if event.events().contains(ReadFlags::QUEUE_OVERFLOW) {
                self.writers.clear();
            }
            let Some(name) = event.file_name() else { continue };
            let path = self.folder.join(std::ffi::OsStr::from_bytes(name.to_bytes()));
            if event.events().contains(ReadFlags::MOVED_FROM) {
                let writer = self.writers.remove(&path);
                moved = Some((event.cookie(), path, writer));
                continue;
            }
            let writer = if event.events().contains(ReadFlags::MOVED_TO) {
                let before = moved.take().filter(|(cookie, ..)| *cookie == event.cookie());
                let is_written = before.as_ref().is_some_and(|(.., writer)| *writer == Some(Writer::Writes));
                self.moves.extend(before.map(|(_, before, _)| (before, path.clone())));
                if is_written { Writer::Writes } else { Writer::Moved }
            } else if event.events().contains(ReadFlags::CLOSE_WRITE) {
                self.writers.insert(path, Writer::Closed);
                continue;
            } else {
                Writer::Writes
            };
            self.heard.insert(path.clone());
            self.writers.insert(path, writer);
        }
    }

    /// Who writes a file.
    pub(super) fn writer(&self, path: &Path) -> Writer {
        self.writers.get(path).copied().unwrap_or(Writer::Unknown)
    }
}

#[cfg(not(target_os = "linux"))]
impl Closed {
    pub(super) fn new(_folder: &Path) -> Self {
        Self { writers: BTreeMap::new(), heard: BTreeSet::new(), moves: Vec::new() }
    }

    /// Nothing is told by itself.
    pub(super) fn hear(&mut self) {}

    /// Whether somebody has a file open to write.
    #[cfg(windows)]
    pub(super) fn writer(&self, path: &Path) -> Writer {
        use std::os::windows::fs::OpenOptionsExt as _;
        /// FILE_SHARE_READ: other readers are allowed, and no writer.
        const READERS: u32 = 1;
        let opened = std::fs::OpenOptions::new().read(true).share_mode(READERS).open(path);
        if opened.is_ok() { Writer::Closed } else { Writer::Writes }
    }

    /// Not known here.
    #[cfg(not(windows))]
    pub(super) fn writer(&self, _path: &Path) -> Writer {
        Writer::Unknown
    }
}

impl Closed {
    /// Whether it was heard that a file was written since the last look.
    pub(super) fn is_heard(&self, path: &Path) -> bool {
        self.heard.contains(path)
    }

    /// The files that got another name since this was asked: the one before, and the new one.
    pub(super) fn moves(&mut self) -> Vec<(PathBuf, PathBuf)> {
        std::mem::take(&mut self.moves)
    }

    /// What was heard of a file is no longer so.
    pub(super) fn forget(&mut self, path: &Path) {
        self.writers.remove(path);
    }

    /// Forgets the files that are gone.
    pub(super) fn forget_all_but(&mut self, there: &BTreeSet<PathBuf>) {
        self.writers.retain(|path, _| there.contains(path));
    }
}
