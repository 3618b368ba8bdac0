//! What is looked at before a file is used, and what a connection is set to.

use fitcheck_files as files;
use std::path::Path;
use std::time::Duration;

use rusqlite::config::DbConfig;
use rusqlite::{Connection, OpenFlags};

use super::schema::{APPLICATION, VERSION};
use crate::error::StoreError;

/// How long a reader waits where a journal is just being made, or its log is played in after a fall.
const PATIENCE: Duration = Duration::from_mins(1);

/// The smallest page of a file of SQLite, bytes.
const SMALLEST: u64 = 512;

/// What a file is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum State {
    /// Nothing is there, or nothing is in it.
    Empty,
    /// A journal of an older version.
    Older,
    /// A journal of this version.
    Current,
}

/// Looks at a file without changing it.
pub(super) fn look(path: &Path) -> Result<State, StoreError> {
    let beside = |ending: &str| path.with_file_name(format!("{}{ending}", name(path)));
    match std::fs::metadata(path) {
        Ok(found) if !found.is_file() => return Err(StoreError::NotAFile { path: path.to_owned() }),
        Ok(found) if found.len() == 0 => return Ok(State::Empty),
        // SQLite takes less than its smallest page for nothing, and would write over it.
        Ok(found) if found.len() < SMALLEST => return Err(StoreError::NotAJournal { path: path.to_owned() }),
        Ok(_file) => {}
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            // A log without its file would be played into a new one.
            let log = beside("-wal");
            return if log.exists() { Err(StoreError::Damaged { path: path.to_owned() }) } else { Ok(State::Empty) };
        }
        Err(error) => return Err(StoreError::system(path, &error)),
    }
    head(path)?;
    let connection = to_read(path)?;
    let failed = |error: rusqlite::Error| StoreError::of(path, &error);
    match version(&connection).map_err(failed)? {
        (APPLICATION, VERSION) => Ok(State::Current),
        (APPLICATION, version) if VERSION < version => {
            Err(StoreError::Newer { path: path.to_owned(), version, known: VERSION })
        }
        (APPLICATION, _older) => Ok(State::Older),
        (0, _) if is_bare(&connection).map_err(failed)? => Ok(State::Empty),
        _ => Err(StoreError::NotAJournal { path: path.to_owned() }),
    }
}

/// Looks at a journal that is only read: where there is none, that is an error.
pub(super) fn look_to_read(path: &Path) -> Result<State, StoreError> {
    match look(path)? {
        State::Empty if path.exists() => Err(StoreError::NotAJournal { path: path.to_owned() }),
        State::Empty => Err(StoreError::Missing { path: path.to_owned() }),
        state => Ok(state),
    }
}

/// Looks at what a file says it is as it lies, without its log, so that nothing is left beside a file that is not ours.
///
/// Through SQLite: a file that is opened and closed beside it in one program takes away the locks that the program holds on it
/// (<https://sqlite.org/howtocorrupt.html>, section 2.2), and others would take it for unused.
fn head(path: &Path) -> Result<(), StoreError> {
    match as_it_lies(path).and_then(|connection| version(&connection)) {
        Ok((APPLICATION, version)) if VERSION < version => {
            Err(StoreError::Newer { path: path.to_owned(), version, known: VERSION })
        }
        Ok((APPLICATION | 0, _)) => Ok(()),
        Ok(_) => Err(StoreError::NotAJournal { path: path.to_owned() }),
        Err(error) => match StoreError::of(path, &error) {
            error @ StoreError::NotAJournal { .. } => Err(error),
            // What is in its log may make it whole.
            _ => Ok(()),
        },
    }
}

/// A file without its log, and without a lock.
fn as_it_lies(path: &Path) -> rusqlite::Result<Connection> {
    let address = format!("file:{}?immutable=1", escaped(path));
    let flags = OpenFlags::SQLITE_OPEN_READ_ONLY | OpenFlags::SQLITE_OPEN_URI | OpenFlags::SQLITE_OPEN_NO_MUTEX;
    Connection::open_with_flags(address, flags)
}

fn name(path: &Path) -> String {
    files::name_of(path).to_string_lossy().into_owned()
}

/// What a file says it is, and its version.
pub(super) fn version(connection: &Connection) -> rusqlite::Result<(i64, i64)> {
    let number = |name| connection.pragma_query_value(None, name, |row| row.get(0));
    Ok((number("application_id")?, number("user_version")?))
}

fn is_bare(connection: &Connection) -> rusqlite::Result<bool> {
    let tables: i64 = connection.query_row("SELECT count(*) FROM sqlite_schema", [], |row| row.get(0))?;
    Ok(tables == 0)
}

/// Makes the folder of a journal where there is none.
pub(super) fn make_folder(path: &Path) -> Result<(), StoreError> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    if let Some(folder) = folder {
        std::fs::create_dir_all(folder).map_err(|error| StoreError::system(path, &error))?;
    }
    not_on_a_network(path, folder.unwrap_or_else(|| Path::new(".")))
}

/// A connection that adds entries, and makes the file where there is none.
pub(super) fn to_write(path: &Path, patience: Duration) -> Result<Connection, StoreError> {
    let flags = OpenFlags::SQLITE_OPEN_READ_WRITE | OpenFlags::SQLITE_OPEN_CREATE | OpenFlags::SQLITE_OPEN_NO_MUTEX;
    let failed = |error: rusqlite::Error| match StoreError::of(path, &error) {
        error @ StoreError::CannotOpen { .. } => told_by_the_system(path).unwrap_or(error),
        error => error,
    };
    let connection = Connection::open_with_flags(path, flags).map_err(failed)?;
    connection.busy_timeout(patience).map_err(failed)?;
    guard(&connection).map_err(failed)?;
    let mode: String =
        connection.pragma_update_and_check(None, "journal_mode", "WAL", |row| row.get(0)).map_err(failed)?;
    connection.pragma_update(None, "synchronous", "FULL").map_err(failed)?;
    connection.pragma_update(None, "fullfsync", "ON").map_err(failed)?;
    connection.pragma_update(None, "recursive_triggers", "ON").map_err(failed)?;
    // What was set is read back: without it nothing that is acknowledged would be on the disk.
    let number = |name| connection.pragma_query_value(None, name, |row| row.get::<_, i64>(0)).map_err(failed);
    if mode != "wal" || number("synchronous")? != 2 || number("recursive_triggers")? != 1 {
        return Err(StoreError::CannotOpen { path: path.to_owned() });
    }
    Ok(connection)
}

/// Why a file cannot be opened to write, which SQLite does not tell. The file is not opened for that: see [`head`].
#[cfg(target_os = "linux")]
fn told_by_the_system(path: &Path) -> Option<StoreError> {
    let asked = rustix::fs::access(path, rustix::fs::Access::WRITE_OK).err()?;
    let error = std::io::Error::from_raw_os_error(asked.raw_os_error());
    (error.kind() != std::io::ErrorKind::NotFound).then(|| StoreError::system(path, &error))
}

/// Other systems are not asked.
#[cfg(not(target_os = "linux"))]
const fn told_by_the_system(_path: &Path) -> Option<StoreError> {
    None
}

/// A connection that only reads. In a folder that may not be written to, a journal that nobody uses is read as it lies.
pub(super) fn to_read(path: &Path) -> Result<Connection, StoreError> {
    if !path.exists() {
        return Err(StoreError::Missing { path: path.to_owned() });
    }
    let failed = |error: rusqlite::Error| StoreError::of(path, &error);
    let open = |path: &Path, flags: OpenFlags| -> rusqlite::Result<Connection> {
        let connection = Connection::open_with_flags(path, flags | OpenFlags::SQLITE_OPEN_NO_MUTEX)?;
        connection.busy_timeout(PATIENCE)?;
        guard(&connection)?;
        // Only now is the file looked at.
        let _version = version(&connection)?;
        let _tables: i64 = connection.query_row("SELECT count(*) FROM sqlite_schema", [], |row| row.get(0))?;
        Ok(connection)
    };
    match open(path, OpenFlags::SQLITE_OPEN_READ_ONLY).map_err(failed) {
        Err(StoreError::CannotOpen { .. } | StoreError::ReadOnly { .. }) if !has_log(path) => {
            let address = format!("file:{}?immutable=1", escaped(path));
            let flags = OpenFlags::SQLITE_OPEN_READ_ONLY | OpenFlags::SQLITE_OPEN_URI;
            open(Path::new(&address), flags).map_err(failed)
        }
        opened => opened,
    }
}

/// Whether entries may still be in the log beside the file.
fn has_log(path: &Path) -> bool {
    let log = path.with_file_name(format!("{}-wal", name(path)));
    std::fs::metadata(log).is_ok_and(|found| 0 < found.len())
}

/// A path as part of an address.
fn escaped(path: &Path) -> String {
    path.to_string_lossy().replace('%', "%25").replace('?', "%3f").replace('#', "%23")
}

/// Nothing in a file that was tampered with is run, and nothing writes to its schema.
fn guard(connection: &Connection) -> rusqlite::Result<()> {
    connection.set_db_config(DbConfig::SQLITE_DBCONFIG_DEFENSIVE, true)?;
    connection.set_db_config(DbConfig::SQLITE_DBCONFIG_TRUSTED_SCHEMA, false)?;
    // Of a journal of a gigabyte nothing is mapped: a file that is cut short while it is mapped ends the program.
    connection.pragma_update(None, "mmap_size", 0)?;
    Ok(())
}

/// Refuses a folder on another machine: the locks of the log do not hold there, and two stations would write over each other.
#[cfg(target_os = "linux")]
fn not_on_a_network(path: &Path, folder: &Path) -> Result<(), StoreError> {
    /// NFS, SMB, CIFS, SMB2, AFS, Ceph, 9P (linux/magic.h, and the file systems' own headers).
    const NETWORK: [u64; 7] = [0x6969, 0x517B, 0xFF53_4D42, 0xFE53_4D42, 0x5346_414F, 0x00C3_6400, 0x0102_1997];
    let Ok(found) = rustix::fs::statfs(folder) else { return Ok(()) };
    if u64::try_from(found.f_type).is_ok_and(|kind| NETWORK.contains(&kind)) {
        return Err(StoreError::NetworkFolder { path: path.to_owned() });
    }
    Ok(())
}

/// The same: a share, or a drive that stands for one.
#[cfg(windows)]
fn not_on_a_network(path: &Path, folder: &Path) -> Result<(), StoreError> {
    use std::path::{Component, Prefix};
    let whole = std::fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned());
    match whole.components().next() {
        Some(Component::Prefix(prefix)) if matches!(prefix.kind(), Prefix::UNC(..) | Prefix::VerbatimUNC(..)) => {
            Err(StoreError::NetworkFolder { path: path.to_owned() })
        }
        _ => Ok(()),
    }
}

/// Other systems do not tell what a folder is.
#[cfg(not(any(target_os = "linux", windows)))]
fn not_on_a_network(_path: &Path, _folder: &Path) -> Result<(), StoreError> {
    Ok(())
}
