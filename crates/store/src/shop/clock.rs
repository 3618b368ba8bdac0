//! How far the clocks of stations are from the server's. Nothing is sorted or corrected by it: it is shown.

use fitcheck_exchange::journal::chain::ChainId;

use super::access::Access;
use super::error::{ShopError, chain_of};
use super::schema::value;
use super::server::{Patience, Server, Stop};

/// How many of a chain's newest entries are looked at.
const NEWEST: i64 = 500;

/// What the newest entries of a chain tell of its station's clock. A time is how much later the server got an entry than the station
/// says that it wrote it: the way there, the time offline, and the difference of the clocks together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Clock {
    pub chain: ChainId,
    /// The station that wrote its newest entry.
    pub station: String,
    /// The newest entry's, milliseconds.
    pub newest_ms: i64,
    /// The least of them, milliseconds: below zero the station's clock is ahead of the server's by that at least.
    pub least_ms: i64,
}

/// The clocks of all chains that have an entry with a time.
///
/// # Errors
/// [`ShopError`] where the server cannot be asked.
pub fn clocks(access: &Access, patience: Patience) -> Result<Vec<Clock>, ShopError> {
    all(&Server::connect(access, patience, &Stop::default())?)
}

/// The same on a connection.
pub(super) fn all(server: &Server) -> Result<Vec<Clock>, ShopError> {
    let sql = "SELECT chain.chain, (array_agg(station ORDER BY number DESC))[1], \
               (array_agg(late ORDER BY number DESC))[1], min(late) \
               FROM fitcheck.chain AS chain CROSS JOIN LATERAL (\
                 SELECT newest.station, newest.number, \
                   (extract(epoch FROM newest.received - (fitcheck.figures(newest.body)).at) * 1000)::bigint AS late \
                 FROM (SELECT * FROM fitcheck.entry WHERE entry.chain = chain.chain ORDER BY number DESC LIMIT $1) AS newest\
               ) AS entries WHERE late IS NOT NULL GROUP BY chain.chain ORDER BY 2, 1";
    let rows = server.ask(server.client.query(sql, &[&NEWEST]))?;
    rows.iter()
        .map(|row| {
            Ok(Clock {
                chain: chain_of(value(row, 0)?)?,
                station: value(row, 1)?,
                newest_ms: value(row, 2)?,
                least_ms: value(row, 3)?,
            })
        })
        .collect()
}
