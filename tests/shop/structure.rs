//! What `init` makes is what is there: whatever was changed, taken away or added is named, by whoever may read.

use std::ops::ControlFlow;

use fitcheck::store::shop::{Elsewhere, ShopError, ShopFinding, ShopVerified, Thing, verify_beside};

use crate::chains::verified;
use crate::harness::{Book, SHORT, Shop, access};

fn changed(kind: Thing, name: &str) -> ShopFinding {
    ShopFinding::Changed { kind, name: name.to_owned() }
}

fn gone(kind: Thing, name: &str) -> ShopFinding {
    ShopFinding::Gone { kind, name: name.to_owned() }
}

fn strange(kind: Thing, name: &str) -> ShopFinding {
    ShopFinding::Strange { kind, name: name.to_owned() }
}

/// What somebody with all rights may do around the entries, and what is told of it.
fn changes() -> Vec<(&'static str, ShopFinding)> {
    vec![
        (
            "CREATE OR REPLACE FUNCTION fitcheck.follow() RETURNS trigger LANGUAGE plpgsql SET search_path = fitcheck, pg_temp \
             AS 'BEGIN RETURN NULL; END'",
            changed(Thing::Function, "follow"),
        ),
        (
            "CREATE OR REPLACE FUNCTION fitcheck.corrected_by(of bytea, wanted bigint) RETURNS bigint LANGUAGE sql STABLE \
             SET search_path = pg_catalog, pg_temp AS 'SELECT NULL::bigint'",
            changed(Thing::Function, "corrected_by"),
        ),
        ("ALTER FUNCTION fitcheck.refuse() SECURITY DEFINER", changed(Thing::Function, "refuse")),
        (
            "DROP POLICY entry_is_own ON fitcheck.entry; \
             CREATE POLICY entry_is_own ON fitcheck.entry FOR INSERT WITH CHECK (true)",
            changed(Thing::Policy, "entry_is_own"),
        ),
        ("DROP POLICY chain_is_own ON fitcheck.chain", gone(Thing::Policy, "chain_is_own")),
        ("CREATE POLICY all_may ON fitcheck.entry USING (true)", strange(Thing::Policy, "all_may")),
        ("ALTER POLICY entry_is_read ON fitcheck.entry TO fitcheck_reader", changed(Thing::Policy, "entry_is_read")),
        (
            "DO $$ BEGIN EXECUTE 'CREATE OR REPLACE VIEW fitcheck.checks AS SELECT * FROM (' \
             || rtrim(pg_get_viewdef('fitcheck.checks'::regclass), ';') || ') AS all_checks WHERE status <> $x$SCRAP$x$'; END $$",
            changed(Thing::View, "checks"),
        ),
        ("GRANT UPDATE ON fitcheck.entry TO PUBLIC", changed(Thing::Grant, "entry")),
        ("REVOKE SELECT ON fitcheck.checks FROM fitcheck_reader", changed(Thing::Grant, "checks")),
        ("GRANT INSERT (received) ON fitcheck.entry TO fitcheck_station", strange(Thing::Grant, "entry.received")),
        ("GRANT CREATE ON SCHEMA fitcheck TO fitcheck_station", changed(Thing::Grant, "fitcheck")),
        ("DROP INDEX fitcheck.entry_received", gone(Thing::Index, "entry_received")),
        (
            "DROP INDEX fitcheck.entry_corrects; \
             CREATE INDEX entry_corrects ON fitcheck.entry (chain, fitcheck.corrects(body)) \
             WHERE fitcheck.corrects(body) IS NOT NULL AND number < 5",
            changed(Thing::Index, "entry_corrects"),
        ),
        (
            "UPDATE pg_index SET indisvalid = false WHERE indexrelid = 'fitcheck.entry_received'::regclass",
            changed(Thing::Index, "entry_received"),
        ),
        ("ALTER TABLE fitcheck.entry ALTER received DROP DEFAULT", changed(Thing::Table, "entry.received")),
        ("ALTER TABLE fitcheck.entry ADD COLUMN more text", strange(Thing::Table, "entry.more")),
        ("ALTER TABLE fitcheck.entry DROP CONSTRAINT entry_number_check", gone(Thing::Table, "entry_number_check")),
        ("CREATE RULE swallow AS ON INSERT TO fitcheck.entry DO INSTEAD NOTHING", strange(Thing::Rule, "swallow")),
        (
            "CREATE TRIGGER forge BEFORE INSERT ON fitcheck.chain FOR EACH STATEMENT EXECUTE FUNCTION fitcheck.refuse()",
            strange(Thing::Trigger, "forge"),
        ),
        ("ALTER TABLE fitcheck.chain DISABLE TRIGGER ALL", ShopFinding::Altered { name: "chain_stays".to_owned() }),
        ("ALTER TABLE fitcheck.meta OWNER TO fitadmin", changed(Thing::Owner, "meta")),
        ("ALTER SCHEMA fitcheck OWNER TO fitadmin", changed(Thing::Owner, "fitcheck")),
    ]
}

#[test]
fn whatever_was_changed_around_the_entries_is_named() {
    for (sql, expected) in changes() {
        let Some(shop) = Shop::new() else { return };
        let book = Book::new("Mill 3");
        book.checks(3);
        book.send(&shop.station("a")).unwrap();
        let reader = access(&shop.login("reader", "fitcheck_reader"));
        let found = verified(&reader, &[&book]);
        assert!(found.is_whole() && found.is_complete(), "{found:?}");
        shop.run(sql);
        let found: ShopVerified = verified(&shop.admin(), &[&book]);
        assert!(found.findings.contains(&expected), "{sql}: {:?}", found.findings);
        assert!(!found.is_whole(), "{sql}");
        if !sql.contains("reader") {
            assert!(verified(&reader, &[&book]).findings.contains(&expected), "{sql}: a reader finds it, too");
        }
    }
}

#[test]
fn looking_leaves_nothing_behind() {
    let Some(shop) = Shop::new() else { return };
    let book = Book::new("Mill 3");
    book.send(&shop.station("a")).unwrap();
    let objects = "SELECT (SELECT count(*) FROM pg_class) + (SELECT count(*) FROM pg_proc)";
    let reader = access(&shop.login("reader", "fitcheck_reader"));
    let before = shop.text(objects);
    assert!(verified(&reader, &[&book]).is_complete());
    assert_eq!(shop.text(objects), before);
}

#[test]
fn what_cannot_be_compared_is_told() {
    let Some(shop) = Shop::new() else { return };
    let book = Book::new("Mill 3");
    book.send(&shop.station("a")).unwrap();
    shop.run(&format!("REVOKE TEMPORARY ON DATABASE {} FROM PUBLIC", shop.name));
    let found = verified(&access(&shop.login("reader", "fitcheck_reader")), &[&book]);
    assert!(matches!(found.not_compared, Some(ShopError::NoRight { .. })), "{:?}", found.not_compared);
    assert!(found.is_whole() && !found.is_complete());
}

#[test]
fn a_server_without_entries_was_not_verified() {
    let Some(shop) = Shop::new() else { return };
    let found = verified(&shop.admin(), &[]);
    assert_eq!((found.chains.len(), found.entries(), found.is_whole(), found.is_complete()), (0, 0, true, false));
}

#[test]
fn what_this_station_has_and_the_server_lacks_is_told() {
    let Some(shop) = Shop::new() else { return };
    let book = Book::new("Mill 3");
    let look = || {
        let own = [(book.chain, book.last())];
        let elsewhere = Elsewhere { sent: &[], own: &own };
        verify_beside(&shop.admin(), elsewhere, SHORT, &mut |_, _| ControlFlow::Continue(())).unwrap()
    };
    assert_eq!(look().behind, [(book.chain, book.last(), 0)], "never sent, or gone");
    book.send(&shop.station("a")).unwrap();
    let found = look();
    assert_eq!((&found.behind, found.chains[0].compared, found.is_complete()), (&Vec::new(), Some(1), true));
    book.checks(2);
    assert_eq!(look().behind, [(book.chain, book.last(), 1)]);
}
