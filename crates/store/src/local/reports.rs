//! Which reports there are: by the bytes of their files, by their names, and by the checks that they show; and entries by the beginning of
//! their hash.
//!
//! As questions do, these look at the entries that wait to be indexed by themselves.

use fitcheck_exchange::journal::body;
use fitcheck_exchange::journal::chain::{Hash, HashPrefix, Head};
use fitcheck_exchange::journal::found::{FoundReport, folded};

use super::index::Waiting;
use super::number::{integer, natural};
use super::reader::Reader;
use crate::error::StoreError;

impl Reader {
    /// The entries of reports that show the check of a number, the oldest first. Those that show what it corrects are not among them.
    ///
    /// # Errors
    /// As for [`Self::head`].
    pub fn reports_of(&self, number: u64) -> Result<Vec<u64>, StoreError> {
        // A report comes behind its checks.
        let sql = "SELECT report FROM reported WHERE ?1 <= last AND first <= ?1 AND ?1 < report ORDER BY report";
        self.reports(sql, integer(number), |report| report.checks.contains(number))
    }

    /// The entries of reports of a file with this SHA-256, the oldest first.
    ///
    /// # Errors
    /// As for [`Self::head`].
    pub fn reports_with(&self, sha256: Hash) -> Result<Vec<u64>, StoreError> {
        let sql = "SELECT number FROM report WHERE sha256 = ?1 ORDER BY number";
        self.reports(sql, sha256.0, |report| report.sha256 == sha256)
    }

    /// The entries of reports of a file of this name, the oldest first; capital or small letters.
    ///
    /// # Errors
    /// As for [`Self::head`].
    pub fn reports_named(&self, name: &str) -> Result<Vec<u64>, StoreError> {
        let name = folded(name);
        let sql = "SELECT number FROM report WHERE name = ?1 ORDER BY number";
        self.reports(sql, name.as_ref(), |report| folded(&report.name) == name)
    }

    /// Entries whose hash begins so, at most so many, ascending. No index has hashes, which would cost every recording a page: all entries
    /// are looked at.
    ///
    /// # Errors
    /// [`StoreError::Interrupted`] where somebody stopped it, and as for [`Self::head`].
    pub fn with_hash(&self, prefix: &HashPrefix, most: usize) -> Result<Vec<Head>, StoreError> {
        let read = || -> rusqlite::Result<Vec<Head>> {
            let mut entries = self.connection.prepare("SELECT number, hash FROM entry ORDER BY number")?;
            let heads = entries
                .query_map([], |row| Ok(Head { number: natural(row.get(0)?), hash: Hash(row.get(1)?) }))?
                .filter(|head| head.as_ref().map_or(true, |head| prefix.begins(head.hash)));
            heads.take(most).collect()
        };
        read().map_err(|error| self.failed(&error))
    }

    /// The reports for which something holds: indexed ones by their rows, and then those that wait.
    fn reports(
        &self,
        sql: &str,
        value: impl rusqlite::ToSql,
        holds: impl Fn(&FoundReport<'_>) -> bool,
    ) -> Result<Vec<u64>, StoreError> {
        let read = || -> rusqlite::Result<Vec<u64>> {
            let transaction = self.connection.unchecked_transaction()?;
            let mut numbers = transaction.prepare_cached(sql)?;
            let mut numbers: Vec<u64> =
                numbers.query_map([&value], |row| row.get(0).map(natural))?.collect::<Result<_, _>>()?;
            let waiting = Waiting::of(&transaction)?;
            numbers.extend(waiting.reports(&holds));
            Ok(numbers)
        };
        read().map_err(|error| self.failed(&error))
    }
}

impl Waiting {
    /// The numbers of the reports for which something holds, ascending.
    fn reports(&self, holds: impl Fn(&FoundReport<'_>) -> bool) -> Vec<u64> {
        let of_report = |(number, bytes): &(u64, Vec<u8>)| {
            let report = body::found(bytes).ok()??.report?;
            holds(&report).then_some(*number)
        };
        self.entries().iter().rev().filter_map(of_report).collect()
    }
}
