//! What a journal has and the server lacks is sent, in order. Nothing is kept of what was sent: the server is asked for the
//! last entry of the chain that it has, and gets what comes after it. So it may be interrupted anywhere and done again.

use std::ops::ControlFlow;
use std::str;

use fitcheck_exchange::journal::body;
use fitcheck_exchange::journal::chain::{ChainId, Hash, Head};
use fitcheck_exchange::journal::entry::Kept;

use super::access::Access;
use super::error::{ShopError, hash_of};
use super::schema::{self, value};
use super::server::{Patience, Server, Stop};
use super::source::Source;
use fitcheck_core::text::Within as _;

/// The most entries of a transaction.
const MOST_ENTRIES: usize = 500;
/// The bytes after which a transaction ends.
const MOST_BYTES: usize = 1 << 20;
/// The longest body that the server takes, bytes.
pub const LONGEST_BODY: usize = 16 << 20;
/// The longest name of a station that the server takes, bytes.
const LONGEST_STATION: usize = 1_024;

/// How far it has come.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Sent {
    /// How many entries were sent.
    pub entries: u64,
    /// The last entry that the server has.
    pub head: Head,
    /// How many it lacks.
    pub unsent: u64,
}

/// Sends what the server lacks. `progress` is told after each batch, and may stop it.
///
/// # Errors
/// [`ShopError`]; what was sent before stays there.
pub fn send_once(
    source: &dyn Source,
    station: &str,
    access: &Access,
    patience: Patience,
    progress: &mut dyn FnMut(Sent) -> ControlFlow<()>,
) -> Result<Sent, ShopError> {
    send(source, station, access, (patience, &Stop::default()), progress)
}

/// The same, stopped by somebody else.
pub(super) fn send(
    source: &dyn Source,
    station: &str,
    access: &Access,
    (patience, stop): (Patience, &Stop),
    progress: &mut dyn FnMut(Sent) -> ControlFlow<()>,
) -> Result<Sent, ShopError> {
    let server = Server::connect(access, patience, stop)?;
    // A newer schema takes what an older one took.
    let _version = schema::version(&server)?;
    let sending = Sending { server, chain: source.chain(), station: shorter(station) };
    sending.own()?;
    let mut sent = sending.begin(source)?;
    let mut goes_on = progress(sent);
    while 0 < sent.unsent {
        if goes_on.is_break() || sending.server.is_stopped() {
            return Err(ShopError::Stopped);
        }
        let entries = source.entries(sent.head.number.saturating_add(1), MOST_ENTRIES).map_err(ShopError::journal)?;
        let batch = batch(&entries)?;
        let Some(last) = batch.last() else { break };
        sending.batch(sent.head, batch)?;
        let ours = source.head().map_err(ShopError::journal)?;
        sent.entries = sent.entries.saturating_add(count(batch.len()));
        sent.head = last.head;
        sent.unsent = ours.number.saturating_sub(sent.head.number);
        goes_on = progress(sent);
    }
    Ok(sent)
}

struct Sending {
    server: Server,
    chain: ChainId,
    station: String,
}

impl Sending {
    /// The chain is ours: its first login is the only one that adds to it.
    fn own(&self) -> Result<(), ShopError> {
        let Self { server, chain, .. } = self;
        let chain = chain.0.as_slice();
        let client = &server.client;
        let begin = "INSERT INTO fitcheck.chain (chain) SELECT $1 WHERE NOT EXISTS \
                     (SELECT FROM fitcheck.chain WHERE chain = $1) ON CONFLICT DO NOTHING";
        let _begun = server.ask(client.execute(begin, &[&chain]))?;
        let asked = "SELECT login::text, session_user::text FROM fitcheck.chain WHERE chain = $1";
        let row = server.ask(client.query_one(asked, &[&chain]))?;
        let login: String = value(&row, 0)?;
        let ours: String = value(&row, 1)?;
        if login == ours { Ok(()) } else { Err(ShopError::OtherLogin { login, ours }) }
    }

    /// What the server has of the chain, which must be what the journal has.
    fn begin(&self, source: &dyn Source) -> Result<Sent, ShopError> {
        let theirs = head(&self.server, self.chain)?;
        let ours = source.head().map_err(ShopError::journal)?;
        if ours.number < theirs.number {
            return Err(ShopError::Ahead { ours: ours.number, theirs: theirs.number });
        }
        if 0 < theirs.number {
            let same = source.entries(theirs.number, 1).map_err(ShopError::journal)?;
            let same = same.first().map(|kept| kept.head).filter(|head| head.number == theirs.number);
            let hash = same.map_or_else(Hash::default, |head| head.hash);
            if hash != theirs.hash {
                return Err(ShopError::Fork { number: theirs.number, ours: hash, theirs: theirs.hash });
            }
        }
        Ok(Sent { entries: 0, head: theirs, unsent: ours.number.saturating_sub(theirs.number) })
    }

    /// Sends entries that follow `before`, in one transaction. Entries that are already there have to be the same.
    fn batch(&self, before: Head, entries: &[Kept]) -> Result<(), ShopError> {
        let Self { server, chain, station } = self;
        let client = &server.client;
        let chain = chain.0.as_slice();
        server.run("BEGIN")?;
        let lock =
            "SELECT pg_catalog.pg_advisory_xact_lock(pg_catalog.hashtextextended(pg_catalog.encode($1, 'hex'), 0))";
        let _locked = server.ask(client.execute(lock, &[&chain]))?;
        let numbers: Vec<i64> = entries.iter().map(|kept| integer(kept.head.number)).collect();
        let hashes: Vec<&[u8]> = entries.iter().map(|kept| kept.head.hash.0.as_slice()).collect();
        let first = integer(before.number);
        let last = numbers.last().map_or(first, |last| *last);
        let asked =
            "SELECT number, hash FROM fitcheck.entry WHERE chain = $1 AND number BETWEEN $2 AND $3 ORDER BY number";
        let there = server.ask(client.query(asked, &[&chain, &first, &last]))?;
        let mut is_before_there = before.number == 0;
        for row in &there {
            let number = natural(value(row, 0)?);
            let theirs = hash_of(value(row, 1)?)?;
            is_before_there |= number == before.number;
            let ours =
                [before].into_iter().chain(entries.iter().map(|kept| kept.head)).find(|head| head.number == number);
            let ours = ours.map_or_else(Hash::default, |head| head.hash);
            if ours != theirs {
                return Err(ShopError::Fork { number, ours, theirs });
            }
        }
        if !is_before_there {
            // An older copy of the database was put back just now: begin again from what it has.
            return Err(ShopError::Lost { reason: format!("entry {} is no longer there", before.number) });
        }
        // The name that was recorded, whoever sends it: a journal may be sent from another computer.
        let stations: Vec<String> = entries
            .iter()
            .map(|kept| body::station(&kept.body).map_or_else(|| station.clone(), |own| shorter(&own)))
            .collect();
        let bodies = entries.iter().map(body).collect::<Result<Vec<&str>, ShopError>>()?;
        let insert = "INSERT INTO fitcheck.entry (chain, number, station, hash, body) SELECT $1, added.* FROM \
                      (SELECT number, station, hash, body FROM unnest($2::text[], $3::bigint[], $4::bytea[], $5::text[]) \
                      AS given(station, number, hash, body) ORDER BY number) AS added ON CONFLICT DO NOTHING";
        let added = server.ask(client.execute(insert, &[&chain, &stations, &numbers, &hashes, &bodies]))?;
        let known = there.iter().filter(|row| value::<i64>(row, 0).is_ok_and(|number| number != first)).count();
        if added.saturating_add(count(known)) != count(entries.len()) {
            return Err(ShopError::Busy { reason: "another program sends the same entries".to_owned() });
        }
        server.run("COMMIT")
    }
}

/// The last entry of a chain that the server has.
pub(super) fn head(server: &Server, chain: ChainId) -> Result<Head, ShopError> {
    let sql = "SELECT number, hash FROM fitcheck.entry WHERE chain = $1 ORDER BY number DESC LIMIT 1";
    let row = server.ask(server.client.query_opt(sql, &[&chain.0.as_slice()]))?;
    let Some(row) = row else { return Ok(Head::default()) };
    Ok(Head { number: natural(value(&row, 0)?), hash: hash_of(value(&row, 1)?)? })
}

/// The first of these entries that go into one transaction. One that cannot be sent is told when those before it were sent.
fn batch(entries: &[Kept]) -> Result<&[Kept], ShopError> {
    let mut bytes = 0_usize;
    let mut end = 0;
    for kept in entries {
        bytes = bytes.saturating_add(kept.body.len());
        match sendable(kept) {
            Err(error) if end == 0 => return Err(error),
            Ok(()) if end == 0 || bytes <= MOST_BYTES => end += 1,
            Ok(()) | Err(_) => break,
        }
    }
    Ok(entries.within(..end))
}

/// The body of an entry as the text that the server takes.
fn body(kept: &Kept) -> Result<&str, ShopError> {
    str::from_utf8(&kept.body).map_err(|_no_text| ShopError::NotText { number: kept.head.number })
}

fn sendable(kept: &Kept) -> Result<(), ShopError> {
    let number = kept.head.number;
    let bytes = kept.body.len();
    if LONGEST_BODY < bytes {
        return Err(ShopError::TooLong { number, bytes });
    }
    if kept.body.contains(&0) {
        return Err(ShopError::NotText { number });
    }
    body(kept)?;
    Ok(())
}

/// A station's name as the server takes it.
fn shorter(station: &str) -> String {
    let end = station.floor_char_boundary(LONGEST_STATION);
    station.within(..end).replace('\0', "")
}

pub(super) fn integer(number: u64) -> i64 {
    i64::try_from(number).unwrap_or(i64::MAX)
}

pub(super) fn natural(number: i64) -> u64 {
    number.max(0).unsigned_abs()
}

pub(super) fn count(entries: usize) -> u64 {
    u64::try_from(entries).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fitcheck_exchange::journal::chain::Hash;

    fn kept(number: u64, body: &[u8]) -> Kept {
        Kept { head: Head { number, hash: Hash::default() }, body: body.into() }
    }

    #[test]
    fn a_batch_ends_after_a_megabyte_and_has_one_entry_at_least() {
        let large = vec![b'a'; MOST_BYTES];
        let entries = [kept(1, b"{}"), kept(2, &large), kept(3, b"{}")];
        assert_eq!(batch(&entries).unwrap().len(), 1);
        assert_eq!(batch(&entries[1..]).unwrap().len(), 1);
        assert_eq!(batch(&entries[2..]).unwrap().len(), 1);
        assert_eq!(batch(&[]).unwrap().len(), 0);
    }

    #[test]
    fn an_entry_that_cannot_be_sent_is_told_after_those_before_it() {
        let entries = [kept(1, b"{}"), kept(2, b"\0"), kept(3, b"{}"), kept(4, b"\xff")];
        assert_eq!(batch(&entries).unwrap().len(), 1);
        assert_eq!(batch(&entries[1..]), Err(ShopError::NotText { number: 2 }));
        assert_eq!(batch(&entries[3..]), Err(ShopError::NotText { number: 4 }));
        let long = vec![b'a'; LONGEST_BODY + 1];
        assert_eq!(batch(&[kept(5, &long)]), Err(ShopError::TooLong { number: 5, bytes: LONGEST_BODY + 1 }));
        assert_eq!(batch(&[kept(5, &long[1..])]).unwrap().len(), 1);
    }
}
