//! Whether a server has what `init` makes, and nothing else that acts: functions, triggers, policies, grants, views, indexes, tables.
//!
//! How a server writes down a view or a policy differs from version to version. So the same statements make a copy among this session's
//! temporary things, the server tells both in the same words, and the copy is rolled back: whoever may read can do that. The texts of
//! functions are kept as they were given, and are compared with ours to the byte.

use std::collections::{BTreeMap, BTreeSet};

use super::access::Access;
use super::error::ShopError;
use super::finding::{ShopFinding, Thing};
use super::schema::{SCHEMA, value, version};
use super::server::{Patience, Server, Stop};

/// What a thing is called, and what it says; several may have one name.
type Things = BTreeMap<(String, String), BTreeSet<String>>;

impl Thing {
    /// By its word in `structure.sql`.
    fn of(word: &str) -> Self {
        match word {
            "function" => Self::Function,
            "grant" => Self::Grant,
            "index" => Self::Index,
            "owner" => Self::Owner,
            "policy" => Self::Policy,
            "rule" => Self::Rule,
            "trigger" => Self::Trigger,
            "view" => Self::View,
            _ => Self::Table,
        }
    }
}

/// What is to be said of it.
pub(super) struct Compared {
    /// What is missing, changed or strange.
    pub findings: Vec<ShopFinding>,
    /// Why nothing was compared.
    pub not_compared: Option<ShopError>,
}

/// Compares what is there with what this program makes.
pub(super) fn compare(access: &Access, patience: Patience) -> Compared {
    match findings(access, patience) {
        Ok(findings) => Compared { findings, not_compared: None },
        Err(error) => Compared { findings: Vec::new(), not_compared: Some(error) },
    }
}

fn findings(access: &Access, patience: Patience) -> Result<Vec<ShopFinding>, ShopError> {
    // A connection of its own: what goes wrong here does not end the walk.
    let server = Server::connect(access, patience, &Stop::default())?;
    let there = version(&server)?;
    if SCHEMA.version() < there {
        return Err(ShopError::Newer { version: there, known: SCHEMA.version() });
    }
    server.run("BEGIN ISOLATION LEVEL REPEATABLE READ; SET LOCAL search_path = pg_catalog, pg_temp")?;
    let found = things(&server, "'fitcheck'::regnamespace::oid", "'fitcheck_owner'", "'p'")?;
    let mut findings = around(&server)?;
    findings.extend(bodies(&server)?);
    for step in statements() {
        server.run(&copied(step))?;
    }
    let made = things(&server, "pg_my_temp_schema()", "current_user", "'t'")?;
    server.run("ROLLBACK")?;
    for (kind, name) in found.keys().chain(made.keys()).collect::<BTreeSet<_>>() {
        let thing = (kind.clone(), name.clone());
        let kind = Thing::of(kind);
        let name = name.clone();
        let finding = match (found.get(&thing), made.get(&thing)) {
            (found, made) if found == made => continue,
            // As it was said before there was more to compare.
            (_, Some(_)) if kind == Thing::Trigger && name.contains('_') => ShopFinding::Altered { name },
            (Some(_), Some(_)) => ShopFinding::Changed { kind, name },
            (Some(_), None) if kind == Thing::Owner => ShopFinding::Changed { kind, name },
            (None, _) => ShopFinding::Gone { kind, name },
            (_, None) => ShopFinding::Strange { kind, name },
        };
        if !findings.contains(&finding) {
            findings.push(finding);
        }
    }
    Ok(findings)
}

/// What this program makes a schema by.
fn statements() -> impl Iterator<Item = &'static str> {
    SCHEMA.steps.iter().copied().chain([SCHEMA.again])
}

/// A statement of ours for temporary things.
fn copied(sql: &str) -> String {
    sql.replace("GRANT USAGE ON SCHEMA fitcheck TO fitcheck_station, fitcheck_reader;", "")
        .replace("fitcheck.", "pg_temp.")
}

/// `schema` and `owner` are ours, never anybody's text.
fn things(server: &Server, schema: &str, owner: &str, persistence: &str) -> Result<Things, ShopError> {
    let sql = include_str!("structure.sql")
        .replace("{schema}", schema)
        .replace("{owner}", owner)
        .replace("{persistence}", persistence);
    let mut things = Things::new();
    for row in &server.ask(server.client.query(&sql, &[]))? {
        let says: Option<String> = value(row, 2)?;
        // NULL says nothing.
        things.entry((value(row, 0)?, value(row, 1)?)).or_default().insert(says.unwrap_or_default());
    }
    Ok(things)
}

/// The texts of functions that are not ours to the byte.
fn bodies(server: &Server) -> Result<Vec<ShopFinding>, ShopError> {
    let ours: BTreeMap<&str, &str> = statements().flat_map(functions).collect();
    let sql = "SELECT proname::text, prosrc FROM pg_proc WHERE pronamespace = 'fitcheck'::regnamespace ORDER BY 1";
    let mut findings = Vec::new();
    for row in &server.ask(server.client.query(sql, &[]))? {
        let name: &str = value(row, 0)?;
        let body: &str = value(row, 1)?;
        if ours.get(name).is_some_and(|ours| *ours != body) {
            findings.push(ShopFinding::Changed { kind: Thing::Function, name: name.to_owned() });
        }
    }
    Ok(findings)
}

/// The functions that a statement makes: their names and their texts.
fn functions(sql: &str) -> impl Iterator<Item = (&str, &str)> {
    sql.split("FUNCTION fitcheck.").filter_map(|rest| {
        let (name, rest) = rest.split_once('(')?;
        let (head, rest) = rest.split_once("AS $$")?;
        // A trigger only names one.
        (!head.contains(';')).then_some(())?;
        Some((name, rest.split_once("$$")?.0))
    })
}

/// What is no thing of the schema: its own owner and grants, and what the roles may.
fn around(server: &Server) -> Result<Vec<ShopFinding>, ShopError> {
    let sql = "SELECT pg_get_userbyid(nspowner)::text, (SELECT string_agg(concat_ws(' ', \
                 CASE grantee WHEN 0 THEN 'public' ELSE pg_get_userbyid(grantee)::text END, privilege_type, is_grantable), ', ' \
                 ORDER BY pg_get_userbyid(grantee)) FROM aclexplode(nspacl) WHERE grantee <> nspowner) \
               FROM pg_namespace WHERE nspname = 'fitcheck'";
    let row = server.ask(server.client.query_one(sql, &[]))?;
    let owner: String = value(&row, 0)?;
    let grants: Option<String> = value(&row, 1)?;
    let mut findings = Vec::new();
    let mut changed = |kind: Thing, name: &str| findings.push(ShopFinding::Changed { kind, name: name.to_owned() });
    if owner != "fitcheck_owner" {
        changed(Thing::Owner, "fitcheck");
    }
    if grants.as_deref() != Some("fitcheck_reader USAGE f, fitcheck_station USAGE f") {
        changed(Thing::Grant, "fitcheck");
    }
    let sql = "SELECT rolname::text FROM pg_roles WHERE rolname IN ('fitcheck_owner', 'fitcheck_station', 'fitcheck_reader') \
               AND (rolsuper OR rolbypassrls OR rolcreaterole OR rolcreatedb OR rolreplication OR rolcanlogin \
                    OR rolname <> 'fitcheck_owner' AND (pg_has_role(oid, 'fitcheck_owner', 'MEMBER') \
                       OR EXISTS (SELECT FROM pg_auth_members WHERE member = pg_roles.oid))) ORDER BY 1";
    for row in &server.ask(server.client.query(sql, &[]))? {
        changed(Thing::Role, value(row, 0)?);
    }
    Ok(findings)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_functions_of_the_schema_are_found_with_their_texts() {
        let names = |sql: &'static str| functions(sql).map(|(name, _)| name).collect::<Vec<_>>();
        assert_eq!(names(SCHEMA.steps[0]), ["refuse", "follow"]);
        assert_eq!(names(SCHEMA.again), ["figures", "corrects", "corrected_by"]);
        assert!(functions(SCHEMA.again).all(|(_, text)| text.starts_with('\n') && text.ends_with('\n')));
    }
}
