//! Whether every chain on the server is the one that its station wrote. Entries are fetched and hashed here: what the server
//! computes is not trusted.

use std::ops::ControlFlow;

use super::clock::{self, Clock};
use super::error::{ShopError, hash_of};
use super::password::Access;
use super::schema::{self, value};
use super::send::{count, natural};
use super::server::{Patience, Server, Stop};
use crate::journal::chain::{ChainId, Hash, Head};
use crate::journal::inspection::{Inspected, Inspection};
use crate::message::Say;

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
}

/// What was found on a server.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ShopVerified {
    /// Every chain.
    pub chains: Vec<ShopChain>,
    /// Chains that are known elsewhere and not there at all, with their heads.
    pub missing: Vec<(ChainId, Head)>,
    /// What is wrong around them.
    pub findings: Vec<ShopFinding>,
}

impl ShopVerified {
    /// Whether nothing is wrong.
    pub fn is_whole(&self) -> bool {
        self.missing.is_empty()
            && self.findings.is_empty()
            && self.chains.iter().all(|chain| chain.inspected.breaks.is_empty())
    }
}

/// What is wrong on a server, besides its chains.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "shop-finding")]
pub enum ShopFinding {
    /// What keeps entries from being changed is missing or switched off.
    Altered {
        /// The trigger.
        name: String,
    },
    /// Stations are no longer kept to their own chains.
    RowSecurity {
        /// The table.
        name: String,
    },
    /// A chain has a name of another length.
    ChainName {
        /// The name in hexadecimal digits.
        name: String,
    },
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
    let server = Server::connect(access, patience, &Stop::default())?;
    let _version = schema::version(&server)?;
    server.run("BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY")?;
    let mut findings = around(&server)?;
    let (mut chains, mut done) = (Vec::new(), 0);
    let all = entries(&server)?;
    for name in names(&server)? {
        let Ok(chain) = name.parse::<ChainId>() else {
            findings.push(ShopFinding::ChainName { name });
            continue;
        };
        let heads: Vec<Head> = known.iter().filter(|(other, _)| *other == chain).map(|(_, head)| *head).collect();
        let mut inspection = Inspection::new(chain, &heads);
        walk(&server, chain, |number, body, hash| {
            inspection.see(number, body, hash);
            done += 1;
            if done % count(PAGE) == 0 { progress(done, all.max(done)) } else { ControlFlow::Continue(()) }
        })?;
        let (login, station) = owner(&server, chain)?;
        chains.push(ShopChain { chain, station, login, inspected: inspection.finish(), clock: None });
    }
    for clock in clock::all(&server)? {
        if let Some(chain) = chains.iter_mut().find(|chain: &&mut ShopChain| chain.chain == clock.chain) {
            chain.clock = Some(clock);
        }
    }
    let is_there = |chain: &ChainId| chains.iter().any(|one| one.chain == *chain);
    let missing = known.iter().filter(|(chain, head)| 0 < head.number && !is_there(chain)).copied().collect();
    server.run("COMMIT")?;
    Ok(ShopVerified { chains, missing, findings })
}

/// Gives every entry of a chain in the order of their numbers. A cursor gives each one that is there, also a number that is there twice.
fn walk(
    server: &Server,
    chain: ChainId,
    mut see: impl FnMut(u64, &[u8], Hash) -> ControlFlow<()>,
) -> Result<(), ShopError> {
    // The name has hexadecimal digits alone.
    server.run(&format!(
        "DECLARE walk NO SCROLL CURSOR FOR SELECT number, body, hash FROM fitcheck.entry \
         WHERE chain = '\\x{chain}'::bytea ORDER BY number"
    ))?;
    loop {
        let fetch = format!("FETCH {PAGE} FROM walk");
        let rows = server.ask(server.client.query(&fetch, &[]))?;
        for row in &rows {
            let body: &str = value(row, 1)?;
            if see(natural(value(row, 0)?), body.as_bytes(), hash_of(value(row, 2)?).unwrap_or_default()).is_break() {
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
    Ok((value(&row, 0)?, value::<Option<String>>(&row, 1)?.unwrap_or_default()))
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
