//! Which files nobody writes any more, as far as the system says it.
//!
//! Linux tells when a file that was written is closed, or gets its name (inotify(7)); Windows refuses a reader that allows no writer while there
//! is one. Neither is known of another machine's files on a share, where a file has to be unchanged for a while instead.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Hears which files of a folder are closed.
#[derive(Debug)]
pub(super) struct Closed {
    #[cfg(target_os = "linux")]
    events: Option<std::os::fd::OwnedFd>,
    #[cfg(target_os = "linux")]
    folder: PathBuf,
    paths: BTreeSet<PathBuf>,
}

#[cfg(target_os = "linux")]
impl Closed {
    pub(super) fn new(folder: &Path) -> Self {
        use rustix::fs::inotify::{CreateFlags, WatchFlags, add_watch, init};
        let begin = || {
            let events = init(CreateFlags::NONBLOCK | CreateFlags::CLOEXEC)?;
            add_watch(&events, folder, WatchFlags::CLOSE_WRITE | WatchFlags::MOVED_TO | WatchFlags::MODIFY)?;
            rustix::io::Result::Ok(events)
        };
        // Where there are too many of them already, files have to be unchanged for a while.
        Self { events: begin().ok(), folder: folder.to_owned(), paths: BTreeSet::new() }
    }

    /// Hears what has happened since the last time.
    pub(super) fn hear(&mut self) {
        use std::os::unix::ffi::OsStrExt as _;

        use rustix::fs::inotify::{ReadFlags, Reader};
        let Some(events) = &self.events else { return };
        let mut buffer = [std::mem::MaybeUninit::uninit(); 8 << 10];
        let mut reader = Reader::new(events, &mut buffer);
        while let Ok(event) = reader.next() {
            if event.events().contains(ReadFlags::QUEUE_OVERFLOW) {
                self.paths.clear();
            }
            let Some(name) = event.file_name() else { continue };
            let path = self.folder.join(std::ffi::OsStr::from_bytes(name.to_bytes()));
            if event.events().intersects(ReadFlags::CLOSE_WRITE | ReadFlags::MOVED_TO) {
                self.paths.insert(path);
            } else {
                self.paths.remove(&path);
            }
        }
    }

    /// Whether a file was closed, and not written since.
    pub(super) fn is_closed(&self, path: &Path) -> bool {
        self.paths.contains(path)
    }
}

#[cfg(not(target_os = "linux"))]
impl Closed {
    pub(super) fn new(_folder: &Path) -> Self {
        Self { paths: BTreeSet::new() }
    }

    /// Nothing is told by itself.
    pub(super) fn hear(&mut self) {}

    /// Whether nobody has a file open to write.
    #[cfg(windows)]
    pub(super) fn is_closed(&self, path: &Path) -> bool {
        use std::os::windows::fs::OpenOptionsExt as _;
        /// FILE_SHARE_READ: other readers are allowed, and no writer.
        const READERS: u32 = 1;
        std::fs::OpenOptions::new().read(true).share_mode(READERS).open(path).is_ok()
    }

    /// Not known here.
    #[cfg(not(windows))]
    pub(super) fn is_closed(&self, _path: &Path) -> bool {
        false
    }
}

impl Closed {
    /// Forgets the files that are gone.
    pub(super) fn forget_all_but(&mut self, there: &BTreeSet<PathBuf>) {
        self.paths.retain(|path| there.contains(path));
    }
}
