//! Whether every entry of a journal is the one that was written.

use std::ops::ControlFlow;
use std::path::Path;

use rusqlite::Connection;

use super::{opening, reader, schema};
use crate::journal::chain::{Hash, Head};
use crate::journal::inspection::{Inspected, Inspection};
use crate::message::Say;
use crate::store::error::StoreError;

/// After how many entries the progress is told.
const STEP: u64 = 10_000;

/// What was found in a journal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verified {
    /// The chain.
    pub inspected: Inspected,
    /// What is wrong with the file around it.
    pub findings: Vec<Finding>,
}

impl Verified {
    /// Whether nothing is wrong.
    pub const fn is_whole(&self) -> bool {
        self.inspected.breaks.is_empty() && self.findings.is_empty()
    }
}

/// What is wrong with a journal's file, besides its chain.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "store-finding")]
pub enum Finding {
    /// What keeps entries from being changed is missing or was changed.
    Altered {
        /// The trigger or table.
        name: String,
    },
    /// Questions do not find every entry, or find one that is not there.
    NotFound {
        /// How many entries.
        entries: u64,
    },
}

/// Looks at every entry of a journal, and compares it with heads of its chain that were kept elsewhere. `progress` gets how many were looked
/// at and how many there are, and may stop it.
///
/// # Errors
/// [`StoreError::Interrupted`] where it was stopped; [`StoreError`] where the file cannot be read to its end.
pub fn verify(
    path: &Path,
    known: &[Head],
    progress: &mut dyn FnMut(u64, u64) -> ControlFlow<()>,
) -> Result<Verified, StoreError> {
    if opening::look(path)? == opening::State::Empty {
        let path = path.to_owned();
        return Err(if path.exists() { StoreError::NotAJournal { path } } else { StoreError::Missing { path } });
    }
    let connection = opening::to_read(path)?;
    let failed = |error: rusqlite::Error| StoreError::of(path, &error);
    let chain = reader::chain_of(&connection, path)?;
    let mut inspection = Inspection::new(chain, known);
    // One moment of a journal that is in use.
    let transaction = connection.unchecked_transaction().map_err(failed)?;
    let (all, not_found) = counts(&transaction).map_err(failed)?;
    let walk = || -> rusqlite::Result<Option<Inspected>> {
        let mut entries = transaction.prepare("SELECT number, body, hash FROM entry ORDER BY number")?;
        let mut rows = entries.query([])?;
        let mut done = 0_u64;
        while let Some(row) = rows.next()? {
            let hash = Hash(row.get(2)?);
            inspection.see(reader::natural(row.get(0)?), row.get_ref(1)?.as_blob()?, hash);
            done = done.saturating_add(1);
            if done.is_multiple_of(STEP) && progress(done, all).is_break() {
                return Ok(None);
            }
        }
        Ok(Some(inspection.finish()))
    };
    let inspected = walk().map_err(failed)?.ok_or(StoreError::Interrupted)?;
    let altered = schema::altered(&transaction).map_err(failed)?.map(|name| Finding::Altered { name });
    let not_found = (0 < not_found).then_some(Finding::NotFound { entries: not_found });
    Ok(Verified { inspected, findings: altered.into_iter().chain(not_found).collect() })
}

/// How many entries there are, and how many of them but the first are not in `find` or the other way round.
fn counts(connection: &Connection) -> rusqlite::Result<(u64, u64)> {
    let count = |sql: &str| connection.query_row(sql, [], |row| row.get(0).map(reader::natural));
    let all = count("SELECT count(*) FROM entry")?;
    let missing = count("SELECT count(*) FROM entry WHERE number > 1 AND number NOT IN (SELECT number FROM find)")?;
    let more = count("SELECT count(*) FROM find WHERE number NOT IN (SELECT number FROM entry)")?;
    Ok((all, missing.saturating_add(more)))
}
