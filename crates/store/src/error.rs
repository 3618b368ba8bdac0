//! Why a journal could not be used, and what is told beside an answer.

use std::path::{Path, PathBuf};

use fitcheck_core::message::{Say, printed};
use fitcheck_exchange::journal::body::BodyError;
use fitcheck_files::FileError;
use rusqlite::ErrorCode;

/// Why a journal could not be used. Nothing was written where one of these is the answer.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "store", error)]
pub enum StoreError {
    /// There is no file.
    Missing {
        /// The journal.
        path: PathBuf,
    },
    /// A folder, a pipe or a device.
    NotAFile { path: PathBuf },
    /// A file that is something else: no database, or the database of another program.
    NotAJournal {
        /// The file.
        path: PathBuf,
    },
    /// Made by a newer Fitcheck, which keeps more than this one knows.
    Newer {
        /// The journal.
        path: PathBuf,
        #[say(with = printed)]
        version: i64,
        /// The newest that this program knows.
        #[say(with = printed)]
        known: i64,
    },
    /// Made by an older Fitcheck: it is only read by this one after it was opened for writing.
    Older {
        /// The journal.
        path: PathBuf,
    },
    /// The database's own pages do not agree: cut short or overwritten.
    Damaged {
        /// The journal.
        path: PathBuf,
    },
    /// No space left.
    Full {
        /// The journal.
        path: PathBuf,
    },
    /// The file or its folder may not be written to.
    ReadOnly {
        /// The journal.
        path: PathBuf,
    },
    /// Another program has held it for longer than this one waits.
    Locked {
        /// The journal.
        path: PathBuf,
    },
    /// The disk fails.
    Disk {
        /// The journal.
        path: PathBuf,
        /// What the system says.
        reason: String,
    },
    CannotOpen {
        /// The journal.
        path: PathBuf,
    },
    /// Its folder is on another machine, where its locks do not hold.
    NetworkFolder {
        /// The journal.
        path: PathBuf,
    },
    /// Its triggers or tables are not those that Fitcheck makes.
    Altered {
        /// The journal.
        path: PathBuf,
        /// What is missing or other.
        name: String,
    },
    /// Its first entry does not tell which chain it is.
    NoBeginning {
        /// The journal.
        path: PathBuf,
    },
    /// Another file lies where it was opened: it was moved or set aside meanwhile.
    Moved {
        /// The journal.
        path: PathBuf,
    },
    /// The entry that is corrected is not the one that was meant.
    OtherTarget {
        #[say(with = printed)]
        number: u64,
    },
    /// The entry was corrected or taken back already.
    Corrected {
        #[say(with = printed)]
        number: u64,
        /// The entry that did.
        #[say(with = printed)]
        by: u64,
    },
    /// The entry that is corrected is a report: it says which file was written, and that stands.
    IsReport {
        #[say(with = printed)]
        number: u64,
    },
    /// The entry that is corrected is an alarm of a control chart: it says which rule fired, and that stands.
    IsAlarm {
        #[say(with = printed)]
        number: u64,
    },
    /// The entry that is answered is no alarm of a control chart.
    NoAlarm {
        #[say(with = printed)]
        number: u64,
    },
    /// A report tells of checks of another journal.
    OtherJournal {
        /// The last entry that it knows.
        #[say(with = printed)]
        number: u64,
    },
    NoEntry {
        /// The journal.
        path: PathBuf,
        /// The number that was asked for.
        #[say(with = printed)]
        number: u64,
        #[say(with = printed)]
        last: u64,
    },
    /// An entry that must be there is not found by its number.
    Hidden {
        /// The journal.
        path: PathBuf,
        /// The entry's number.
        #[say(with = printed)]
        number: u64,
    },
    /// The entry cannot be written as bytes.
    #[say(transparent)]
    Body(BodyError),
    /// A file beside the journal: its folder, a backup.
    #[say(transparent)]
    File(FileError),
    /// A backup did not come out as the journal.
    Backup {
        /// The backup.
        path: PathBuf,
    },
    /// Somebody stopped it.
    Interrupted,
    /// The database says something that it should not.
    Database {
        /// The journal.
        path: PathBuf,
        /// What it says.
        reason: String,
    },
}

impl StoreError {
    /// What the database says of a journal.
    pub(super) fn of(path: &Path, error: &rusqlite::Error) -> Self {
        let path = path.to_owned();
        let Some(code) = error.sqlite_error_code() else {
            return Self::Database { path, reason: error.to_string() };
        };
        match code {
            ErrorCode::NotADatabase => Self::NotAJournal { path },
            ErrorCode::DatabaseCorrupt => Self::Damaged { path },
            ErrorCode::DiskFull => Self::Full { path },
            ErrorCode::DatabaseBusy | ErrorCode::DatabaseLocked | ErrorCode::FileLockingProtocolFailed => {
                Self::Locked { path }
            }
            ErrorCode::ReadOnly | ErrorCode::PermissionDenied => Self::ReadOnly { path },
            ErrorCode::CannotOpen => Self::CannotOpen { path },
            ErrorCode::SystemIoFailure => Self::Disk { path, reason: error.to_string() },
            ErrorCode::OperationInterrupted => Self::Interrupted,
            _ => Self::Database { path, reason: error.to_string() },
        }
    }

    /// What the system says of a folder or a file of a journal.
    pub(super) fn system(path: &Path, error: &std::io::Error) -> Self {
        use std::io::ErrorKind as Kind;
        let journal = path.to_owned();
        match error.kind() {
            Kind::StorageFull | Kind::QuotaExceeded => Self::Full { path: journal },
            Kind::PermissionDenied | Kind::ReadOnlyFilesystem => Self::ReadOnly { path: journal },
            Kind::NotFound => Self::Missing { path: journal },
            _ => Self::Disk { path: journal, reason: error.to_string() },
        }
    }
}

/// What is told of a journal that can be used.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "store-remark")]
pub enum StoreRemark {
    /// There was none: it was begun.
    Begun {
        /// The journal.
        path: PathBuf,
    },
    /// It was damaged, lies elsewhere now, and another one was begun in its place.
    SetAside {
        /// The journal.
        path: PathBuf,
        /// Where the damaged one is.
        folder: PathBuf,
    },
    /// An older journal was brought to this version, after a copy of it was made.
    Migrated {
        /// The journal.
        path: PathBuf,
        copy: PathBuf,
    },
    /// It ends before an entry that it once had.
    Behind {
        /// The journal.
        path: PathBuf,
        /// Its last entry.
        #[say(with = printed)]
        last: u64,
        /// The entry that it once had.
        #[say(with = printed)]
        known: u64,
    },
    /// It has another entry in the place of one that it once had.
    Other {
        /// The journal.
        path: PathBuf,
        /// The entry's number.
        #[say(with = printed)]
        number: u64,
    },
    /// Another journal, or none, is where one was.
    Replaced {
        /// The journal.
        path: PathBuf,
        /// The last entry of the one that was there.
        #[say(with = printed)]
        known: u64,
    },
    /// Another program writes to it, and this one waits for its turn.
    Waits {
        /// The journal.
        path: PathBuf,
    },
    /// What is known of it elsewhere could not be read or kept.
    NoAnchor {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
}
