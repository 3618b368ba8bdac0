//! The journal of a station: one SQLite file, to which entries are only added.
//!
//! When [`Journal::append`] returns, its entries are on the disk: write-ahead log, `synchronous=FULL`, read back at every open. Any
//! number of programs may add to one file at once, one after the other; readers never wait. `journal.sqlite` has `-wal` and `-shm` beside it
//! while it is in use, and these belong to it: a copy is made by [`backup`]. `-lock` is empty and stays.
//!
//! | file | what |
//! |---|---|
//! | here | adding entries |
//! | `opening` | what is looked at before a file is used; what a connection is set to |
//! | `admission` | what an entry that is added may refer to |
//! | `turn` | whose turn it is to write, where several programs add to one file |
//! | `schema` | the tables, and what keeps entries as they are |
//! | `finding` | what an entry is found by, and questions as conditions on it |
//! | `index` | what entries are found by, some hundreds of entries later |
//! | `number` | numbers of entries as SQLite keeps them |
//! | `words` | questions for words |
//! | `reader` | reading, beside the writer |
//! | `reported` | what a report is found by |
//! | `reports` | which reports there are: by their bytes, their names, the checks that they show |
//! | `verify` | whether every entry is the one that was written |
//! | `backup` | a copy at one moment |
//! | `anchor` | the last entry of each journal, kept elsewhere |
//! | `aside` | a damaged journal makes room |

mod admission;
mod anchor;
mod aside;
mod backup;
mod finding;
mod index;
mod number;
mod opening;
mod reader;
mod reported;
mod reports;
mod schema;
mod turn;
mod verify;
mod words;

use std::path::{Path, PathBuf};
use std::time::Duration;

use fitcheck_exchange::journal::body;
use fitcheck_exchange::journal::chain::{ChainId, Hash, Head, entry_hash};
use fitcheck_exchange::journal::entry::{About, Begin, Content, Entry, Kept, Moment};
use rusqlite::{Connection, OptionalExtension as _, params};

pub use self::anchor::{Anchor, Anchors};
pub use self::backup::backup;
pub use self::reader::{Interrupt, ListedEntry, Reader};
use self::turn::Turn;
pub use self::verify::{Finding, Verified, verify};
use super::error::{StoreError, StoreRemark};

/// The name of the file in the folder for the journal.
pub const FILE: &str = "journal.sqlite";

/// What a journal is opened with.
#[derive(Debug, Clone)]
pub struct Opening {
    /// The station, for the first entry of a new journal.
    pub station: String,
    /// The time now, for the same, and for the name of what is set aside.
    pub time: Moment,
    /// Where the last entries of journals are kept besides; `None` keeps and compares none.
    pub anchors: Option<PathBuf>,
    /// How long another program is waited for that holds the journal and writes nothing.
    pub patience: Duration,
    /// Tells what is waited for, after some seconds.
    pub waits: fn(&StoreRemark),
}

impl Opening {
    /// With the user's own file of last entries, and a minute of patience; nobody is told of waiting.
    pub fn new(station: impl Into<String>, time: Moment) -> Self {
        let anchors = Anchors::of_user();
        let patience = Duration::from_mins(1);
        Self { station: station.into(), time, anchors, patience, waits: |_remark| {} }
    }
}

/// A journal that is added to.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    /// Which file it is, wherever it is moved.
    file: Option<FileId>,
    connection: Connection,
    chain: ChainId,
    opening: Opening,
    /// The head at the last look, for the anchor.
    head: Head,
    /// The number of the last head that was kept elsewhere.
    anchored: u64,
    remarks: Vec<StoreRemark>,
}

/// After how many entries the last one is kept elsewhere, besides at the beginning and the end.
const ANCHOR_EVERY: u64 = 100;

impl Journal {
    /// Opens a journal, or begins one where there is no file. An older one is brought to this version, after a copy of it was made. One
    /// whose pages are damaged is set aside, with its folder in the remarks, and another one is begun that names it.
    ///
    /// # Errors
    /// [`StoreError`] where nothing can be written there, or another file is there.
    pub fn open(path: &Path, opening: &Opening) -> Result<Self, StoreError> {
        let known = opening.anchors.as_deref().map(Anchors::read).transpose();
        let mut remarks = Vec::new();
        let known = known
            .unwrap_or_else(|error| {
                remarks.extend(opening.anchors.clone().map(|path| StoreRemark::NoAnchor { path, reason: error }));
                None
            })
            .and_then(|anchors| anchors.at(path));
        match Self::open_whole(path, opening, known.as_ref()) {
            Err(error) if aside::is_damage(&error, known.as_ref()) => {
                let folder = aside::set_aside(path, &opening.time)?;
                remarks.push(StoreRemark::SetAside { path: path.to_owned(), folder });
                Self::open_whole(path, opening, known.as_ref())
            }
            opened => opened,
        }
        .map(|mut journal| {
            journal.remarks.splice(0..0, remarks);
            journal
        })
    }

    fn open_whole(path: &Path, opening: &Opening, known: Option<&Anchor>) -> Result<Self, StoreError> {
        let mut remarks = Vec::new();
        match opening::look(path) {
            // Somebody is just making it.
            Ok(_) | Err(StoreError::Locked { .. }) => {}
            Err(error) => return Err(error),
        }
        opening::make_folder(path)?;
        let turn = Turn::of(path, opening)?;
        let state = opening::look(path)?;
        let mut connection = opening::to_write(path, opening.patience)?;
        let failed = |error: rusqlite::Error| StoreError::of(path, &error);
        match state {
            opening::State::Empty => {
                let transaction = turn.begin(&connection, path, opening)?;
                // Another program may have been first.
                if opening::version(&transaction).map_err(failed)? == (0, 0) {
                    schema::make(&transaction).map_err(failed)?;
                    begin(&transaction, path, opening, known)?;
                    remarks.push(StoreRemark::Begun { path: path.to_owned() });
                }
                transaction.commit().map_err(failed)?;
            }
            opening::State::Older => {
                let copy = backup::before_migration(path, &connection)?;
                schema::rebuild(&mut connection).map_err(failed)?;
                remarks.push(StoreRemark::Migrated { path: path.to_owned(), copy });
            }
            opening::State::Current => {}
        }
        if let Some(name) = schema::altered(&connection).map_err(failed)? {
            return Err(StoreError::Altered { path: path.to_owned(), name });
        }
        let chain = reader::chain_of(&connection, path)?;
        let head = head_of(&connection).map_err(failed)?;
        if number::integer(head.number) < index::indexed(&connection).map_err(failed)? {
            // Entries were cut off: what is added now has numbers that were indexed already.
            schema::rebuild(&mut connection).map_err(failed)?;
        }
        if let Some(known) = known {
            remarks.extend(anchor::compare(&connection, path, (chain, head), known).map_err(failed)?);
        }
        if head.number == 0 {
            return Err(StoreError::NoBeginning { path: path.to_owned() });
        }
        let file = file_id(path);
        let path = path.to_owned();
        let opening = opening.clone();
        let mut journal = Self { path, file, connection, chain, opening, head, anchored: 0, remarks };
        journal.keep_head();
        Ok(journal)
    }

    /// Adds entries, all of them or none. When this returns they are on the disk.
    ///
    /// A full disk, a failing disk or a damaged file leaves the journal as it was before: it can be asked again.
    ///
    /// # Errors
    /// [`StoreError`] where nothing was added.
    pub fn append(&mut self, entries: &[Entry]) -> Result<Vec<Kept>, StoreError> {
        if file_id(&self.path) != self.file {
            return Err(StoreError::Moved { path: self.path.clone() });
        }
        let Self { path, connection, chain, opening, .. } = self;
        // Written as bytes before the file is locked.
        let bodies: Vec<Vec<u8>> =
            entries.iter().map(body::write).collect::<Result<_, _>>().map_err(StoreError::Body)?;
        let failed = |error: rusqlite::Error| StoreError::of(path, &error);
        let turn = Turn::of(path, opening)?;
        let transaction = turn.begin(connection, path, opening)?;
        let mut head = head_of(&transaction).map_err(failed)?;
        for entry in entries {
            admission::may_add(&transaction, path, entry)?;
        }
        let mut kept = Vec::with_capacity(bodies.len());
        for body in bodies {
            head = add(&transaction, path, (*chain, head), &body)?;
            kept.push(Kept { head, body: body.into() });
        }
        if let Err(error) = transaction.commit() {
            let error = StoreError::of(path, &error);
            // What a failing disk has done is only known by looking: what is there must not be added a second time.
            let there = Reader::open(path).and_then(|reader| reader.entry(head.number));
            let is_there = there.is_ok_and(|there| there.is_some_and(|there| there.head == head));
            let lasts = || connection.query_row("PRAGMA wal_checkpoint(FULL)", [], |row| row.get::<_, i64>(0)) == Ok(0);
            if !is_there || !lasts() {
                return Err(error);
            }
        }
        if file_id(&self.path) != self.file {
            // It is in a file that nobody looks for: it counts as not recorded.
            return Err(StoreError::Moved { path: self.path.clone() });
        }
        // A file of its own for each entry would cost more than the entry.
        let is_due = self.anchored + ANCHOR_EVERY <= head.number;
        self.head = head;
        // What was added stays added where this fails; the next entry tries it again.
        let _later = index::bring_up(&self.connection, number::integer(head.number));
        if is_due {
            self.keep_head();
        }
        Ok(kept)
    }

    /// Indexes what waits to be indexed: in a quiet moment, so that questions are answered faster.
    ///
    /// # Errors
    /// [`StoreError`] where the file cannot be written to; nothing is lost.
    pub fn tidy(&self) -> Result<(), StoreError> {
        let _turn = Turn::of(&self.path, &self.opening)?;
        let all = || index::bring_all_up(&self.connection, number::integer(head_of(&self.connection)?.number));
        all().map_err(|error: rusqlite::Error| StoreError::of(&self.path, &error))
    }

    /// The name of the chain.
    pub const fn chain(&self) -> ChainId {
        self.chain
    }

    /// The last entry.
    ///
    /// # Errors
    /// [`StoreError`] where the file cannot be read.
    pub fn head(&self) -> Result<Head, StoreError> {
        head_of(&self.connection).map_err(|error| StoreError::of(&self.path, &error))
    }

    /// What is to be told of it since it was opened.
    pub fn remarks(&self) -> &[StoreRemark] {
        &self.remarks
    }

    /// Keeps the last entry elsewhere, so that it is known when this file ends before it. It may be behind, never ahead: what it says
    /// is on the disk.
    pub fn keep_head(&mut self) {
        self.anchored = self.head.number;
        let Some(path) = &self.opening.anchors else { return };
        // What is not this journal's stays: it is the proof that something is wrong.
        let is_alarmed =
            |remark: &StoreRemark| matches!(remark, StoreRemark::Behind { .. } | StoreRemark::Other { .. });
        if self.remarks.iter().any(is_alarmed) {
            return;
        }
        let anchor = Anchor { file: self.path.clone(), chain: self.chain, head: self.head };
        if let Err(reason) = Anchors::keep(path, &anchor) {
            let told = StoreRemark::NoAnchor { path: path.clone(), reason };
            if !self.remarks.contains(&told) {
                self.remarks.push(told);
            }
        }
    }
}

impl Drop for Journal {
    fn drop(&mut self) {
        if file_id(&self.path) != self.file {
            // What is known of the file at this path is another journal's.
            return;
        }
        self.keep_head();
        // Costs nothing where nothing has changed; what it says is of no use to anybody any more, and nobody is waited for.
        let _optimized = self
            .connection
            .busy_timeout(Duration::ZERO)
            .and_then(|()| self.connection.execute_batch("PRAGMA optimize"));
    }
}

/// The last entry of a file.
fn head_of(connection: &Connection) -> rusqlite::Result<Head> {
    let mut newest = connection.prepare_cached("SELECT number, hash FROM entry ORDER BY number DESC LIMIT 1")?;
    let head = newest
        .query_row([], |row| {
            let hash: [u8; 32] = row.get(1)?;
            Ok(Head { number: number::natural(row.get(0)?), hash: Hash(hash) })
        })
        .optional()?;
    // Before the first entry.
    Ok(head.unwrap_or_default())
}

/// A device and a number on it.
type FileId = (u64, u64);

/// Which file lies at a path; `None` where systems do not tell. There a file that is in use cannot be moved.
#[cfg(unix)]
fn file_id(path: &Path) -> Option<FileId> {
    use std::os::unix::fs::MetadataExt as _;
    std::fs::metadata(path).ok().map(|found| (found.dev(), found.ino()))
}

/// Which file lies at a path; `None` where systems do not tell. There a file that is in use cannot be moved.
#[cfg(not(unix))]
fn file_id(_path: &Path) -> Option<FileId> {
    None
}

/// Adds an entry behind another one.
fn add(
    connection: &Connection,
    path: &Path,
    (chain, before): (ChainId, Head),
    body: &[u8],
) -> Result<Head, StoreError> {
    let failed = |error: rusqlite::Error| StoreError::of(path, &error);
    let too_long = || StoreError::Database { path: path.to_owned(), reason: "an entry of four gigabytes".to_owned() };
    let hash = entry_hash(chain, before, body).ok_or_else(too_long)?;
    let number = before.number.saturating_add(1);
    let row = i64::try_from(number).map_err(|_above| too_long())?;
    let added = connection
        .prepare_cached("INSERT INTO entry(number, body, hash) VALUES (?1, ?2, ?3)")
        .and_then(|mut insert| insert.execute(params![row, body, hash.0]))
        .map_err(failed)?;
    // Somebody's trigger may have swallowed it.
    if added != 1 || head_of(connection).map_err(failed)? != (Head { number, hash }) {
        return Err(StoreError::Altered { path: path.to_owned(), name: "entry".to_owned() });
    }
    Ok(Head { number, hash })
}

/// Writes the first entry: it makes the chain's name.
fn begin(connection: &Connection, path: &Path, opening: &Opening, known: Option<&Anchor>) -> Result<(), StoreError> {
    let mut name = [0; 16];
    getrandom::fill(&mut name)
        .map_err(|error| StoreError::Database { path: path.to_owned(), reason: error.to_string() })?;
    let chain = ChainId(name);
    let nobody = String::new;
    let entry = Entry {
        about: About {
            station: opening.station.clone(),
            time: opening.time.clone(),
            who: nobody(),
            part: nobody(),
            serial: nobody(),
            feature: nobody(),
            remark: nobody(),
        },
        content: Content::Begin(Begin {
            chain,
            program: concat!("fitcheck ", env!("CARGO_PKG_VERSION")).to_owned(),
            after: known.map(|known| (known.chain, known.head)),
        }),
    };
    let body = body::write(&entry).map_err(StoreError::Body)?;
    connection
        .execute("INSERT INTO chain(name) VALUES (?1)", params![name])
        .map_err(|error| StoreError::of(path, &error))?;
    add(connection, path, (chain, Head::default()), &body).map(drop)
}
