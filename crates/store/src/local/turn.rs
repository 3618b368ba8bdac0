//! Whose turn it is to write: programs that add to one journal queue for it.
//!
//! SQLite lets a program that finds a file held try again after a while, and whoever tries at the right moment comes first: on a busy machine
//! one of ten is unlucky until it gives up, and its record is not kept. So each waits for a lock on a file beside the journal, which the
//! system hands on in the order in which they came, and which is free when its holder ends, however it ends. The lock of the database
//! itself stays what keeps the entries apart: other programs, and versions without this queue, know that one only.

use fitcheck_files as files;
use std::fs::{File, TryLockError, metadata};
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::thread;
use std::time::{Duration, Instant, SystemTime};

use rusqlite::{Connection, Transaction, TransactionBehavior};

use super::Opening;
use crate::error::{StoreError, StoreRemark};

/// The ending of the file that is locked. It is empty and stays.
const ENDING: &str = "-lock";
/// After this long the user is told for whom the program waits.
const TOLD: Duration = Duration::from_secs(3);
/// How often is looked whether the one who holds the journal still writes.
const LOOKS: Duration = Duration::from_millis(200);

/// The turn of this program, until it is dropped.
pub(super) struct Turn {
    /// Locked until it is closed; `None` where the system has no such locks.
    _held: Option<File>,
}

impl Turn {
    /// Waits for the turn. Where the system has no such locks, the database's own has to do.
    pub(super) fn of(path: &Path, opening: &Opening) -> Result<Self, StoreError> {
        let Some(file) = lock_file(path) else { return Ok(Self { _held: None }) };
        match file.try_lock() {
            Ok(()) => return Ok(Self { _held: Some(file) }),
            Err(TryLockError::Error(_none)) => return Ok(Self { _held: None }),
            Err(TryLockError::WouldBlock) => {}
        }
        let (sender, receiver) = sync_channel(0);
        // Whoever has given up no longer listens: then the turn is over as soon as it comes.
        let queue = move || drop(sender.send(file.lock().ok().map(|()| file)));
        let thread = thread::Builder::new().name("turn".to_owned()).spawn(queue);
        drop(thread.map_err(|error| StoreError::system(path, &error))?);
        let mut waiting = Waiting::new(path, opening);
        loop {
            match receiver.recv_timeout(LOOKS.min(opening.patience)) {
                Ok(file) => return Ok(Self { _held: file }),
                Err(RecvTimeoutError::Disconnected) => return Ok(Self { _held: None }),
                Err(RecvTimeoutError::Timeout) => waiting.goes_on()?,
            }
        }
    }

    /// Begins to write. Only programs that do not queue are waited for.
    #[expect(clippy::unused_self, reason = "nobody begins before it is their turn")]
    pub(super) fn begin<'a>(
        &self,
        connection: &'a Connection,
        path: &Path,
        opening: &Opening,
    ) -> Result<Transaction<'a>, StoreError> {
        let failed = |error: rusqlite::Error| StoreError::of(path, &error);
        connection.busy_timeout(LOOKS.min(opening.patience)).map_err(failed)?;
        let mut waiting = Waiting::new(path, opening);
        loop {
            match Transaction::new_unchecked(connection, TransactionBehavior::Immediate).map_err(failed) {
                Ok(transaction) => return Ok(transaction),
                Err(StoreError::Locked { .. }) => waiting.goes_on()?,
                Err(error) => return Err(error),
            }
        }
    }
}

/// The file of the queue; one that belongs to another user is locked without writing to it. Windows locks no file that is open for
/// appending alone.
fn lock_file(path: &Path) -> Option<File> {
    let mut name = path.file_name()?.to_owned();
    name.push(ENDING);
    let file = path.with_file_name(name);
    File::options().create(true).truncate(false).write(true).open(&file).or_else(|_denied| File::open(&file)).ok()
}

/// Somebody else writes. As long as the file changes, the queue moves, and however slow the machine is, the turn comes.
struct Waiting<'a> {
    path: &'a Path,
    opening: &'a Opening,
    begun: Instant,
    is_told: bool,
    /// What the journal and its log looked like, and since when.
    seen: [Option<(u64, SystemTime)>; 2],
    since: Instant,
}

impl<'a> Waiting<'a> {
    fn new(path: &'a Path, opening: &'a Opening) -> Self {
        let now = Instant::now();
        Self { path, opening, begun: now, is_told: false, seen: looks(path), since: now }
    }

    fn goes_on(&mut self) -> Result<(), StoreError> {
        let seen = looks(self.path);
        if seen != self.seen {
            self.seen = seen;
            self.since = Instant::now();
        }
        if self.opening.patience <= self.since.elapsed() {
            return Err(StoreError::Locked { path: self.path.to_owned() });
        }
        if !self.is_told && TOLD <= self.begun.elapsed() {
            self.is_told = true;
            (self.opening.waits)(&StoreRemark::Waits { path: self.path.to_owned() });
        }
        Ok(())
    }
}

fn looks(path: &Path) -> [Option<(u64, SystemTime)>; 2] {
    let look = |path: &Path| metadata(path).ok().and_then(|found| Some((found.len(), found.modified().ok()?)));
    [look(path), look(&files::with_ending(path, "-wal"))]
}
