//! A long file that goes to the disk while it is being written, so that little is left to wait for at its end.
//!
//! Where the system can, its bytes go there straight and not into the memory in which the system keeps files: to put five
//! million judged rows there, and to give that memory back when the file is replaced, took as long as judging them.

use std::fs::File;
use std::io::{self, Write};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread::{Builder, Scope, ScopedJoinHandle};

/// How much goes to the disk in one step.
const PART: usize = 1 << 20;
/// What addresses and lengths are multiples of where bytes go straight; no disk in use asks for more.
const ALIGNED: usize = 4 << 10;
/// How many parts there are: one is filled, one is written and one waits.
const PARTS: usize = 3;
/// How much the system may keep in its memory before it goes to the disk, where bytes cannot go there straight.
const MOST_KEPT: usize = 16 << 20;

/// Bytes on their way to the disk.
struct Part {
    bytes: Vec<u8>,
    /// Where the first aligned one is.
    start: usize,
    length: usize,
}

impl Part {
    fn new() -> Self {
        let bytes = vec![0; PART + ALIGNED];
        let start = bytes.as_ptr().align_offset(ALIGNED).min(ALIGNED);
        Self { bytes, start, length: 0 }
    }

    /// Takes as many bytes as it has room for.
    fn take(&mut self, bytes: &[u8]) -> usize {
        let count = bytes.len().min(PART - self.length);
        let begin = self.start + self.length;
        if let (Some(room), Some(bytes)) = (self.bytes.get_mut(begin..begin + count), bytes.get(..count)) {
            room.copy_from_slice(bytes);
        }
        self.length += count;
        count
    }

    fn taken(&self) -> &[u8] {
        let (_, from) = self.bytes.split_at(self.start);
        let (taken, _) = from.split_at(self.length);
        taken
    }
}

/// Writes a file on a thread of its own. A file shorter than a part has none.
pub(super) struct Straight<'scope, 'env, 'file> {
    file: &'file File,
    scope: &'scope Scope<'scope, 'env>,
    part: Part,
    disk: Option<Disk<'scope>>,
}

/// The thread that writes, what it writes next and what it has written.
struct Disk<'scope> {
    full: SyncSender<Part>,
    empty: Receiver<Part>,
    thread: ScopedJoinHandle<'scope, io::Result<()>>,
}

impl<'scope> Disk<'scope> {
    /// Starts it; without a thread nothing is written meanwhile.
    fn of<'file: 'scope>(file: &'file File, scope: &'scope Scope<'scope, '_>) -> io::Result<Self> {
        let (full, parts) = sync_channel::<Part>(PARTS);
        let (written, empty) = sync_channel(PARTS);
        (1..PARTS).for_each(|_| drop(written.try_send(Part::new())));
        let work = move || {
            let mut way = Way { file, is_straight: go_straight(file, true), kept: 0 };
            for mut part in parts {
                way.write(part.taken())?;
                part.length = 0;
                drop(written.try_send(part));
            }
            Ok(())
        };
        let thread = Builder::new().name("disk".to_owned()).spawn_scoped(scope, work)?;
        Ok(Self { full, empty, thread })
    }

    /// Hands a full part over and puts an empty one in its place; `false` where the disk has refused one.
    fn swap(&self, part: &mut Part) -> bool {
        self.empty.recv().is_ok_and(|empty| self.full.send(std::mem::replace(part, empty)).is_ok())
    }

    /// Waits until everything is written.
    fn end(self) -> io::Result<()> {
        drop(self.full);
        self.thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    }
}

/// How bytes go to the disk.
struct Way<'file> {
    file: &'file File,
    is_straight: bool,
    /// How much the system has kept since all of it went to the disk.
    kept: usize,
}

impl Way<'_> {
    fn write(&mut self, mut bytes: &[u8]) -> io::Result<()> {
        if MOST_KEPT <= self.kept {
            self.kept = 0;
            self.file.sync_data()?;
        }
        if !self.is_straight {
            self.kept += bytes.len();
        }
        while !bytes.is_empty() {
            match (&mut &*self.file).write(bytes) {
                Ok(0) => return Err(io::ErrorKind::WriteZero.into()),
                Ok(count) => bytes = bytes.split_at(count.min(bytes.len())).1,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                // A folder that says it can and cannot, or the rest of a part where a disk has become full.
                Err(error) if self.is_straight && error.kind() == io::ErrorKind::InvalidInput => {
                    self.is_straight = go_straight(self.file, false);
                }
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }
}

/// Whether bytes of a file go straight to the disk from now on, as asked where the system can.
#[cfg(target_os = "linux")]
fn go_straight(file: &File, is_asked: bool) -> bool {
    use rustix::fs::{OFlags, fcntl_getfl, fcntl_setfl};
    let set = |flags: OFlags| fcntl_setfl(file, if is_asked { flags | OFlags::DIRECT } else { flags - OFlags::DIRECT });
    fcntl_getfl(file).and_then(set).is_ok() && is_asked
}

#[cfg(not(target_os = "linux"))]
const fn go_straight(_file: &File, _is_asked: bool) -> bool {
    false
}

impl<'scope, 'env, 'file: 'scope> Straight<'scope, 'env, 'file> {
    pub(super) fn new(file: &'file File, scope: &'scope Scope<'scope, 'env>) -> Self {
        Self { file, scope, part: Part::new(), disk: None }
    }

    /// Hands the full part over. Without a thread it is written here.
    fn send(&mut self) -> io::Result<()> {
        let Some(disk) = self.disk.take().or_else(|| Disk::of(self.file, self.scope).ok()) else {
            (&mut &*self.file).write_all(self.part.taken())?;
            self.part.length = 0;
            return Ok(());
        };
        if disk.swap(&mut self.part) {
            self.disk = Some(disk);
            return Ok(());
        }
        disk.end().and(Err(io::ErrorKind::BrokenPipe.into()))
    }

    /// Writes what is left and waits until everything is on the disk.
    ///
    /// # Errors
    /// What the disk reports, also of an earlier part: it does so only once.
    pub(super) fn end(mut self) -> io::Result<()> {
        if let Some(disk) = self.disk.take() {
            disk.end()?;
            // The rest is not as long as the disk wants it.
            go_straight(self.file, false);
        }
        (&mut &*self.file).write_all(self.part.taken())?;
        self.file.sync_all()
    }
}

impl<'scope, 'file: 'scope> Write for Straight<'scope, '_, 'file> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.part.length == PART {
            self.send()?;
        }
        Ok(self.part.take(bytes))
    }

    /// Nobody sees the file before its end.
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bytes(count: usize) -> Vec<u8> {
        (0..count).map(|at| u8::try_from(at % 251).unwrap()).collect()
    }

    #[test]
    fn every_length_about_a_part_is_written_whole_in_pieces_of_any_length() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("rows.csv");
        for count in [0, 1, PART - 1, PART, PART + 1, 3 * PART, 5 * PART + ALIGNED, 17 * PART + 17] {
            let bytes = bytes(count);
            for piece in [4_099, 100_000, 3 * PART] {
                let file = File::create(&path).unwrap();
                std::thread::scope(|scope| {
                    let mut out = Straight::new(&file, scope);
                    bytes.chunks(piece).for_each(|piece| out.write_all(piece).unwrap());
                    out.end().unwrap();
                });
                assert!(std::fs::read(&path).unwrap() == bytes, "{count} bytes in pieces of {piece}");
            }
        }
    }

    #[test]
    fn what_cannot_go_straight_goes_as_ever() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("rows.csv");
        let file = File::create(&path).unwrap();
        let mut way = Way { file: &file, is_straight: go_straight(&file, true), kept: 0 };
        let part = bytes(MOST_KEPT);
        // Neither an address nor a length that a disk takes.
        way.write(&part[1..1_000]).unwrap();
        assert!(!way.is_straight);
        way.write(&part).unwrap();
        way.write(&part).unwrap();
        assert!(way.kept < 2 * MOST_KEPT, "nothing went to the disk meanwhile");
        assert!(std::fs::read(&path).unwrap() == [&part[1..1_000], &part, &part].concat());
    }

    #[test]
    fn what_the_disk_refuses_is_told_at_the_latest_at_the_end() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("rows.csv");
        File::create(&path).unwrap();
        // Nothing can be written to a file that was opened to be read.
        let file = File::open(&path).unwrap();
        for count in [1, PART, 8 * PART] {
            let told = std::thread::scope(|scope| {
                let mut out = Straight::new(&file, scope);
                out.write_all(&bytes(count)).and_then(|()| out.end())
            });
            assert!(told.is_err(), "{count} bytes");
        }
    }
}
