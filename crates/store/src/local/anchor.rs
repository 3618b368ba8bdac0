//! The last entry of each journal, kept in another folder: a chain alone cannot show that its newest entries were cut off, or that an
//! older copy was put back.
//!
//! A small text file, one journal a line: chain, number, hash and file. A later line for a file counts; the line of a chain goes when the
//! chain goes on. It may be behind the journal; ahead of it is the alarm. Another such file has the last entry of each journal that a server
//! is known to have, with the server in place of the file.

use std::path::{Path, PathBuf};

use fitcheck_exchange::journal::chain::{ChainId, Hash, Head};
use fitcheck_files::{self as files, FileError};
use rusqlite::{Connection, OptionalExtension as _};

use super::number::integer;
use crate::error::StoreRemark;

/// The first line of the file.
const HEADER: &str = "# The last entry of each journal of Fitcheck: chain, number, hash, file\n";

/// The last entry of a journal that was seen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Anchor {
    /// Where the journal was.
    pub file: PathBuf,
    pub chain: ChainId,
    /// Its last entry.
    pub head: Head,
}

/// The last entries of all journals.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Anchors(Vec<Anchor>);

impl Anchors {
    /// Where the user's are: beside the settings, not beside the journals.
    pub fn of_user() -> Option<PathBuf> {
        Some(files::settings_folder()?.join("journal-heads.txt"))
    }

    /// Where the last entries are that servers have, of journals that this user has sent.
    pub fn of_servers() -> Option<PathBuf> {
        Some(files::settings_folder()?.join("server-heads.txt"))
    }

    /// Reads a file of them; none where there is no file.
    ///
    /// # Errors
    /// What is wrong with the file.
    pub fn read(path: &Path) -> Result<Self, String> {
        match files::read_file(path) {
            Ok(bytes) => {
                String::from_utf8_lossy(&bytes).lines().filter(|line| !line.starts_with('#')).map(line).collect()
            }
            Err(FileError::Missing { .. }) => Ok(Self::default()),
            Err(error) => Err(error.to_string()),
        }
    }

    /// The journal that was in a file the last time.
    pub fn at(&self, file: &Path) -> Option<Anchor> {
        let file = whole(file);
        self.0.iter().rev().find(|anchor| anchor.file == file).cloned()
    }

    /// What is known of a chain, wherever its file is.
    pub fn of_chain(&self, chain: ChainId) -> Vec<Head> {
        self.0.iter().filter(|anchor| anchor.chain == chain).map(|anchor| anchor.head).collect()
    }

    /// The last entries of chains that a server had.
    pub fn of_server(&self, server: &str) -> Vec<(ChainId, Head)> {
        let of_it = self.0.iter().filter(|anchor| anchor.file == Path::new(server));
        of_it.map(|anchor| (anchor.chain, anchor.head)).collect()
    }

    /// Keeps the last entry of a chain that a server has, unless a later one is kept already.
    ///
    /// # Errors
    /// What the system says.
    pub fn keep_of_server(path: &Path, server: &str, chain: ChainId, head: Head) -> Result<(), String> {
        Self::keep_one(path, Anchor { file: PathBuf::from(server), chain, head }, |other| {
            other.chain == chain && other.file == Path::new(server)
        })
    }

    /// Keeps the last entry of a journal, unless a later one of the same chain is kept already.
    pub(super) fn keep(path: &Path, anchor: &Anchor) -> Result<(), String> {
        let chain = anchor.chain;
        Self::keep_one(path, Anchor { file: whole(&anchor.file), ..anchor.clone() }, |other| other.chain == chain)
    }

    /// Keeps one in place of those that it follows.
    fn keep_one(path: &Path, anchor: Anchor, follows: impl Fn(&Anchor) -> bool) -> Result<(), String> {
        let folder = path.parent().unwrap_or(path);
        std::fs::create_dir_all(folder).map_err(|error| error.to_string())?;
        // Two programs with two journals must not take each other's line away.
        let mut options = std::fs::File::options();
        let lock = options.create(true).truncate(false).write(true).open(path.with_extension("lock"));
        let lock = lock.map_err(|error| error.to_string())?;
        lock.lock().map_err(|error| error.to_string())?;
        let mut anchors = Self::read(path)?;
        let is_later = |other: &Anchor| follows(other) && anchor.head.number < other.head.number;
        if anchors.0.iter().any(is_later) || anchors.0.last() == Some(&anchor) {
            return Ok(());
        }
        anchors.0.retain(|other| !follows(other));
        anchors.0.push(anchor);
        let lines = anchors
            .0
            .iter()
            .map(|Anchor { file, chain, head }| format!("{chain} {} {} {}\n", head.number, head.hash, file.display()));
        let text: String = std::iter::once(HEADER.to_owned()).chain(lines).collect();
        files::write(path, text.as_bytes()).map_err(|error| error.to_string())
    }
}

impl FromIterator<Anchor> for Anchors {
    fn from_iter<T: IntoIterator<Item = Anchor>>(anchors: T) -> Self {
        Self(anchors.into_iter().collect())
    }
}

fn line(text: &str) -> Result<Anchor, String> {
    let wrong = || fitcheck_core::message::shortened(text, 80);
    let mut words = text.splitn(4, ' ');
    let mut word = || words.next().ok_or_else(wrong);
    let chain = word()?.parse().map_err(|_hex| wrong())?;
    let number = word()?.parse().map_err(|_number| wrong())?;
    let hash: Hash = word()?.parse().map_err(|_hex| wrong())?;
    Ok(Anchor { file: PathBuf::from(word()?), chain, head: Head { number, hash } })
}

/// A path that means the same from every folder.
fn whole(file: &Path) -> PathBuf {
    std::path::absolute(file).unwrap_or_else(|_unknown| file.to_owned())
}

/// What is to be told of a journal beside what was known of its file.
pub(super) fn compare(
    connection: &Connection,
    path: &Path,
    (chain, head): (ChainId, Head),
    known: &Anchor,
) -> rusqlite::Result<Option<StoreRemark>> {
    let path = path.to_owned();
    let number = known.head.number;
    if known.chain != chain {
        return Ok(Some(StoreRemark::Replaced { path, known: number }));
    }
    if head.number < number {
        return Ok(Some(StoreRemark::Behind { path, last: head.number, known: number }));
    }
    let mut there = connection.prepare_cached("SELECT hash FROM entry WHERE number = ?1")?;
    let hash: Option<[u8; 32]> = there.query_row([integer(number)], |row| row.get(0)).optional()?;
    Ok((hash != Some(known.head.hash.0)).then_some(StoreRemark::Other { path, number }))
}
