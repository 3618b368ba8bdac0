//! Whether every chain on the server is the one that its station wrote. Entries are fetched and hashed here: what the server
//! computes is not trusted.

use std::ops::ControlFlow;

use fitcheck_exchange::journal::body;
use fitcheck_exchange::journal::chain::{ChainId, Hash, Head};
use fitcheck_exchange::journal::inspection::{Inspected, Inspection};

use super::access::Access;
use super::clock::{self, Clock};
use super::error::{ShopError, hash_of};
use super::finding::ShopFinding;
use super::schema::{self, value};
use super::send::{count, head, natural};
use super::server::{Patience, Server, Stop};
use super::structure::{self, Compared};

/// How many entries are fetched at once.
const PAGE: usize = 2_000;

/// A chain on the server.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ShopChain {
    /// Its name.
    pub chain: ChainId,
    /// The station that wrote its newest entry.
    pub station: String,
    /// The login that it belongs to; `None` where the server does not know it.
    pub login: Option<String>,
    /// What was found.
    pub inspected: Inspected,
    /// How far the station's clock is from the server's, by its newest entries; `None` where none of them has a time.
    pub clock: Option<Clock>,
    /// The last of the entries that are known elsewhere and were compared; `None` where none is.
    pub compared: Option<u64>,
    /// How many entries are listed under another station than the one that was recorded.
    pub renamed: u64,
}

/// What is known elsewhere of chains.
#[derive(Debug, Clone, Copy, Default)]
pub struct Elsewhere<'a> {
    /// Entries that were there: sent by this station, or known from a backup or a recording.
    pub sent: &'a [(ChainId, Head)],
    /// Entries of this station that may not be sent yet.
    pub own: &'a [(ChainId, Head)],
}

/// What was found on a server.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ShopVerified {
    pub chains: Vec<ShopChain>,
    /// Chains that are known elsewhere and not there at all, with their heads.
    pub missing: Vec<(ChainId, Head)>,
    /// Chains of this station whose last entries are not there, with their last entry here and there: not sent yet, or cut off.
    pub behind: Vec<(ChainId, Head, u64)>,
    /// Why functions, policies, grants, views and indexes were not looked at; `None` where they were.
    pub not_compared: Option<ShopError>,
    /// What is wrong around them.
    pub findings: Vec<ShopFinding>,
}

impl ShopVerified {
    /// Whether there was something to look at, and everything was looked at.
    pub const fn is_complete(&self) -> bool {
        !self.chains.is_empty() && self.not_compared.is_none() && self.behind.is_empty()
    }

    /// How many entries were looked at.
    pub fn entries(&self) -> u64 {
        self.chains.iter().map(|chain| chain.inspected.entries).sum()
    }

    /// Whether nothing is wrong in what was looked at.
    pub fn is_whole(&self) -> bool {
        self.missing.is_empty()
            && self.findings.is_empty()
            && self.chains.iter().all(|chain| chain.inspected.breaks.is_empty())
    }
}

/// Looks at every entry of every chain as they are at one moment, and compares them with heads that are known elsewhere. `progress` gets
/// how many were looked at and about how many there are, and may stop it.
///
/// # Errors
/// [`ShopError::Stopped`] where it was stopped; [`ShopError`] where the server cannot be asked.
pub fn verify(
    access: &Access,
    known: &[(ChainId, Head)],
    patience: Patience,
    progress: &mut dyn FnMut(u64, u64) -> ControlFlow<()>,
) -> Result<ShopVerified, ShopError> {
    verify_beside(access, Elsewhere { sent: known, own: &[] }, patience, progress)
}

/// The same beside what is known elsewhere.
///
/// # Errors
/// As for [`verify`].
pub fn verify_beside(
    access: &Access,
    known: Elsewhere<'_>,
    patience: Patience,
    progress: &mut dyn FnMut(u64, u64) -> ControlFlow<()>,
) -> Result<ShopVerified, ShopError> {
    let server = Server::connect(access, patience, &Stop::default())?;
    let _version = schema::version(&server)?;
    server.run("BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY")?;
    let mut findings = around(&server)?;
    let Compared { findings: of_structure, not_compared } = structure::compare(access, patience);
    findings.extend(of_structure.into_iter().filter(|one| !findings.contains(one)).collect::<Vec<_>>());
    let mut behind = Vec::new();
    let mut chains = Vec::new();
    let mut done = 0;
    let all = entries(&server)?;
    for name in names(&server)? {
        let Ok(chain) = name.parse::<ChainId>() else {
            findings.push(ShopFinding::ChainName { name });
            continue;
        };
        let of_chain = |all: &[(ChainId, Head)]| -> Vec<Head> {
            all.iter().filter(|(other, head)| *other == chain && 0 < head.number).map(|(_, head)| *head).collect()
        };
        let mut heads = of_chain(known.sent);
        let last = head(&server, chain)?.number;
        for own in of_chain(known.own) {
            if own.number <= last {
                heads.push(own);
            } else {
                behind.push((chain, own, last));
            }
        }
        let mut inspection = Inspection::new(chain, &heads);
        let mut renamed = 0_u64;
        walk(&server, chain, |number, body, hash, station| {
            inspection.see(number, body, hash);
            renamed = renamed.saturating_add(u64::from(body::station(body).is_some_and(|own| own != station)));
            done += 1;
            if done % count(PAGE) == 0 { progress(done, all.max(done)) } else { ControlFlow::Continue(()) }
        })?;
        let (login, station) = owner(&server, chain)?;
        let compared = heads.iter().map(|head| head.number).max();
        chains.push(ShopChain {
            chain,
            station,
            login,
            inspected: inspection.finish(),
            clock: None,
            compared,
            renamed,
        });
    }
    for clock in clock::all(&server)? {
        if let Some(chain) = chains.iter_mut().find(|chain: &&mut ShopChain| chain.chain == clock.chain) {
            chain.clock = Some(clock);
        }
    }
    let is_there = |chain: &ChainId| chains.iter().any(|one| one.chain == *chain);
    let is_missing = |(chain, head): &&(ChainId, Head)| 0 < head.number && !is_there(chain);
    let missing: Vec<_> = known.sent.iter().filter(is_missing).copied().collect();
    // What was sent once and is gone is told above.
    let unsent = known.own.iter().filter(is_missing).filter(|(own, _)| missing.iter().all(|(chain, _)| chain != own));
    behind.extend(unsent.map(|(chain, head)| (*chain, *head, 0)));
    server.run("COMMIT")?;
    Ok(ShopVerified { chains, missing, behind, not_compared, findings })
}

/// Gives every entry of a chain in the order of their numbers. A cursor gives each one that is there, also a number that is there twice.
fn walk(
    server: &Server,
    chain: ChainId,
    mut see: impl FnMut(u64, &[u8], Hash, &str) -> ControlFlow<()>,
) -> Result<(), ShopError> {
    // The name has hexadecimal digits alone.
    server.run(&format!(
        "DECLARE walk NO SCROLL CURSOR FOR SELECT number, body, hash, station FROM fitcheck.entry \
         WHERE chain = '\\x{chain}'::bytea ORDER BY number"
    ))?;
    loop {
        let fetch = format!("FETCH {PAGE} FROM walk");
        let rows = server.ask(server.client.query(&fetch, &[]))?;
        for row in &rows {
            let body: &str = value(row, 1)?;
            // A hash of another length is that of no entry: the entry is told as changed.
            let hash = hash_of(value(row, 2)?).unwrap_or_else(|_damaged| Hash::default());
            if see(natural(value(row, 0)?), body.as_bytes(), hash, value(row, 3)?).is_break() {
                return Err(ShopError::Stopped);
            }
        }
        if rows.is_empty() {
            return server.run("CLOSE walk");
        }
    }
}

/// The names of all chains, from the entries themselves: the table of chains may lack one.
fn names(server: &Server) -> Result<Vec<String>, ShopError> {
    let sql = "WITH RECURSIVE name AS (\
               (SELECT chain FROM fitcheck.entry ORDER BY chain LIMIT 1) UNION ALL \
               SELECT (SELECT chain FROM fitcheck.entry WHERE name.chain < chain ORDER BY chain LIMIT 1) \
               FROM name WHERE name.chain IS NOT NULL) SELECT pg_catalog.encode(chain, 'hex') FROM name WHERE chain IS NOT NULL";
    let rows = server.ask(server.client.query(sql, &[]))?;
    rows.iter().map(|row| value(row, 0)).collect()
}

/// About how many entries there are: for the progress.
fn entries(server: &Server) -> Result<u64, ShopError> {
    let sql = "SELECT greatest(reltuples, 0)::bigint FROM pg_catalog.pg_class WHERE oid = 'fitcheck.entry'::regclass";
    let row = server.ask(server.client.query_one(sql, &[]))?;
    value(&row, 0).map(natural)
}

fn owner(server: &Server, chain: ChainId) -> Result<(Option<String>, String), ShopError> {
    let sql = "SELECT (SELECT login::text FROM fitcheck.chain WHERE chain = $1), \
               (SELECT station FROM fitcheck.entry WHERE chain = $1 ORDER BY number DESC LIMIT 1)";
    let row = server.ask(server.client.query_one(sql, &[&chain.0.as_slice()]))?;
    let station: Option<String> = value(&row, 1)?;
    // A chain without entries has no station.
    Ok((value(&row, 0)?, station.unwrap_or_default()))
}

/// Whether what keeps the entries is there and switched on.
fn around(server: &Server) -> Result<Vec<ShopFinding>, ShopError> {
    let sql = "SELECT wanted.name FROM (VALUES ('entry', 'entry_keeps', 'A'), ('entry', 'entry_stays', 'A'), \
               ('entry', 'entry_follows', 'O'), ('chain', 'chain_stays', 'A')) AS wanted(tab, name, enabled) \
               WHERE NOT EXISTS (SELECT FROM pg_catalog.pg_trigger WHERE tgname = wanted.name \
               AND tgrelid = ('fitcheck.' || wanted.tab)::regclass AND tgenabled::text IN (wanted.enabled, 'A'))";
    let rows = server.ask(server.client.query(sql, &[]))?;
    let mut findings: Vec<ShopFinding> =
        rows.iter().map(|row| value(row, 0).map(|name| ShopFinding::Altered { name })).collect::<Result<_, _>>()?;
    let sql = "SELECT relname::text FROM pg_catalog.pg_class WHERE NOT relrowsecurity \
               AND oid IN ('fitcheck.entry'::regclass, 'fitcheck.chain'::regclass) ORDER BY relname";
    for row in &server.ask(server.client.query(sql, &[]))? {
        findings.push(ShopFinding::RowSecurity { name: value(row, 0)? });
    }
    Ok(findings)
}
