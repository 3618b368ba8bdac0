//! Numbers of entries as SQLite keeps them.

/// A number of an entry as SQLite keeps it.
pub(super) fn integer(number: u64) -> i64 {
    i64::try_from(number).unwrap_or(i64::MAX)
}

/// The number of an entry that SQLite has kept; one below 0 is nobody's, as 0 is.
pub(super) fn natural(number: i64) -> u64 {
    number.max(0).unsigned_abs()
}
