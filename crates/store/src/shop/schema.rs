//! The schema of a shop's server: made, brought to a newer version, and looked at. `init` can be repeated.

use fitcheck_core::message::Say;
use tokio_postgres::Row;

use super::access::Access;
use super::error::ShopError;
use super::server::{Patience, Server, Stop};

/// What a schema is made of.
#[derive(Debug, Clone, Copy)]
pub struct Schema {
    /// What each version adds to the one before; the first makes the tables.
    pub steps: &'static [&'static str],
    /// What is made anew whatever the version: functions, views and their rights.
    pub again: &'static str,
}

/// The schema of this program.
pub const SCHEMA: Schema = Schema { steps: &[include_str!("tables.sql")], again: include_str!("view.sql") };

/// The oldest server that has all that is asked of it.
const OLDEST_SERVER: i32 = 13;

/// What `init` did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "shop-made")]
pub enum SchemaInit {
    /// There was none.
    New { version: i32 },
    /// There was an older one.
    Upgraded {
        /// Its version before.
        from: i32,
        /// Its version now.
        version: i32,
    },
    /// There was one of this version.
    Already { version: i32 },
}

impl Schema {
    pub fn version(&self) -> i32 {
        i32::try_from(self.steps.len()).unwrap_or(i32::MAX)
    }
}

/// Makes the schema of this program in a database, or brings an older one to its version, in one transaction.
///
/// # Errors
/// [`ShopError`] where the server cannot be asked, the user may not, or something else is there; then nothing was changed.
pub fn init(access: &Access, patience: Patience) -> Result<SchemaInit, ShopError> {
    init_as(access, patience, SCHEMA)
}

/// The same with a given schema, as a later program would have one.
///
/// # Errors
/// As for [`init`].
pub fn init_as(access: &Access, patience: Patience, schema: Schema) -> Result<SchemaInit, ShopError> {
    let server = Server::connect(access, patience, &Stop::default())?;
    let setting = |name: &'static str| {
        let row = server.ask(server.client.query_one("SELECT pg_catalog.current_setting($1)", &[&name]))?;
        row.try_get::<_, String>(0).map_err(|error| ShopError::asking(&error))
    };
    let encoding = setting("server_encoding")?;
    if encoding != "UTF8" {
        return Err(ShopError::Encoding { encoding });
    }
    // What says no number is none of the servers that are known.
    let version: i32 = setting("server_version_num")?.parse().unwrap_or(0);
    if version < OLDEST_SERVER * 10_000 {
        return Err(ShopError::OldServer { version: version / 10_000, oldest: OLDEST_SERVER });
    }
    server.run("BEGIN; SELECT pg_catalog.pg_advisory_xact_lock(7309453412)")?;
    let made = match there(&server)? {
        SchemaState::Foreign => return Err(ShopError::Foreign),
        SchemaState::Version(version) if schema.version() < version => {
            return Err(ShopError::Newer { version, known: schema.version() });
        }
        SchemaState::Version(version) if version == schema.version() => SchemaInit::Already { version },
        SchemaState::Version(from) => SchemaInit::Upgraded { from, version: schema.version() },
        SchemaState::Nothing => SchemaInit::New { version: schema.version() },
    };
    server.run(include_str!("roles.sql"))?;
    let done = match made {
        SchemaInit::New { .. } => {
            server.run("CREATE SCHEMA fitcheck AUTHORIZATION fitcheck_owner")?;
            0
        }
        SchemaInit::Upgraded { from, .. } => from,
        SchemaInit::Already { version } => version,
    };
    server.run("SET LOCAL ROLE fitcheck_owner")?;
    for step in schema.steps.iter().skip(usize::try_from(done).unwrap_or(0)) {
        server.run(step)?;
    }
    server.run(schema.again)?;
    server.ask(server.client.execute(
        "INSERT INTO fitcheck.meta (version) VALUES ($1) ON CONFLICT (one) DO UPDATE SET version = excluded.version",
        &[&schema.version()],
    ))?;
    server.run("COMMIT")?;
    Ok(made)
}

enum SchemaState {
    Nothing,
    Foreign,
    Version(i32),
}

/// What is in the database under our name.
fn there(server: &Server) -> Result<SchemaState, ShopError> {
    let sql = "SELECT pg_catalog.pg_get_userbyid(nspowner) = 'fitcheck_owner' AND EXISTS (SELECT FROM pg_catalog.pg_class \
               WHERE relnamespace = pg_namespace.oid AND relname = 'meta') \
               FROM pg_catalog.pg_namespace WHERE nspname = 'fitcheck'";
    let Some(row) = server.ask(server.client.query_opt(sql, &[]))? else { return Ok(SchemaState::Nothing) };
    if !value::<bool>(&row, 0)? {
        return Ok(SchemaState::Foreign);
    }
    version(server).map(SchemaState::Version)
}

/// The version of the schema that is there.
pub(super) fn version(server: &Server) -> Result<i32, ShopError> {
    let row = server.ask(server.client.query_opt("SELECT version FROM fitcheck.meta", &[]))?;
    row.map_or(Err(ShopError::Foreign), |row| value(&row, 0))
}

pub(super) fn value<'a, T: tokio_postgres::types::FromSql<'a>>(row: &'a Row, at: usize) -> Result<T, ShopError> {
    row.try_get(at).map_err(|error| ShopError::asking(&error))
}
