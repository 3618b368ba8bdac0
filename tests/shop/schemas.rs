//! The schema: made once or again, by whoever may, brought to a newer version, and refused where it is not ours.

use fitcheck::store::shop::{SCHEMA, Schema, SchemaInit, ShopError, init, init_as};

use crate::chains::verified;
use crate::harness::{Book, SHORT, Shop, access};

/// The schema of a later program.
const LATER: Schema = Schema {
    steps: &[SCHEMA.steps[0], "ALTER TABLE fitcheck.chain ADD COLUMN place text NOT NULL DEFAULT ''"],
    again: SCHEMA.again,
};

/// One whose second step fails.
const BROKEN: Schema =
    Schema { steps: &[SCHEMA.steps[0], "ALTER TABLE fitcheck.chain ADD COLUMN place text; SELECT 1 / 0"], again: "" };

#[test]
fn a_schema_is_made_once_and_left_as_it_is_when_it_is_made_again() {
    let Some(shop) = Shop::new() else { return };
    let (book, access) = (Book::new("Mill 3"), shop.station("a"));
    book.checks(10);
    book.send(&access).unwrap();
    for _ in 0..3 {
        assert_eq!(init(&shop.admin(), SHORT), Ok(SchemaInit::Already { version: 1 }));
    }
    book.checks(1);
    book.send(&access).unwrap();
    assert!(verified(&shop.admin(), &[&book]).is_whole());
    assert_eq!(shop.text("SELECT pg_get_userbyid(relowner) FROM pg_class WHERE relname = 'entry' AND relnamespace = 'fitcheck'::regnamespace"), "fitcheck_owner");
    assert_eq!(shop.text("SELECT string_agg(rolname, ' ' ORDER BY rolname) FROM pg_roles WHERE rolname LIKE 'fitcheck%owner' AND NOT rolcanlogin"), "fitcheck_owner");
}

#[test]
fn several_make_it_at_once() {
    let Some(shop) = Shop::empty("FITCHECK_TEST_PG") else { return };
    let admin = shop.admin();
    let made: Vec<_> = std::thread::scope(|scope| {
        let all: Vec<_> = (0..6).map(|_| scope.spawn(|| init(&admin, SHORT))).collect();
        all.into_iter().map(|one| one.join().unwrap()).collect()
    });
    assert_eq!(made.iter().filter(|made| **made == Ok(SchemaInit::New { version: 1 })).count(), 1, "{made:?}");
    assert_eq!(made.iter().filter(|made| **made == Ok(SchemaInit::Already { version: 1 })).count(), 5, "{made:?}");
}

#[test]
fn an_older_schema_is_brought_to_the_new_version_with_all_that_is_in_it() {
    let Some(shop) = Shop::new() else { return };
    let (book, access) = (Book::new("Mill 3"), shop.station("a"));
    book.checks(10);
    book.send(&access).unwrap();
    assert_eq!(init_as(&shop.admin(), SHORT, LATER), Ok(SchemaInit::Upgraded { from: 1, version: 2 }));
    assert_eq!(init_as(&shop.admin(), SHORT, LATER), Ok(SchemaInit::Already { version: 2 }));
    assert_eq!(shop.text("SELECT place FROM fitcheck.chain"), "");
    assert!(verified(&shop.admin(), &[&book]).is_whole());
    // This program goes on sending to a newer server, and does not touch its schema.
    book.checks(1);
    book.send(&access).unwrap();
    assert_eq!(shop.counts(&book), (12, 12));
    assert_eq!(init(&shop.admin(), SHORT), Err(ShopError::Newer { version: 2, known: 1 }));
    assert_eq!(shop.text("SELECT version FROM fitcheck.meta"), "2");
}

#[test]
fn a_step_that_fails_changes_nothing() {
    let Some(shop) = Shop::new() else { return };
    let error = init_as(&shop.admin(), SHORT, BROKEN).unwrap_err();
    assert!(matches!(&error, ShopError::Server { code, .. } if code == "22012"), "{error:?}");
    assert_eq!(shop.text("SELECT version FROM fitcheck.meta"), "1");
    assert_eq!(
        shop.text(
            "SELECT count(*) FROM pg_attribute WHERE attrelid = 'fitcheck.chain'::regclass AND attname = 'place'"
        ),
        "0"
    );
}

#[test]
fn something_else_of_our_name_is_left_as_it_is() {
    let Some(shop) = Shop::empty("FITCHECK_TEST_PG") else { return };
    shop.run("CREATE SCHEMA fitcheck; CREATE TABLE fitcheck.meta (version int)");
    assert_eq!(init(&shop.admin(), SHORT), Err(ShopError::Foreign));
    assert_eq!(shop.text("SELECT count(*) FROM pg_class WHERE relnamespace = 'fitcheck'::regnamespace"), "1");
}

#[test]
fn a_database_of_another_encoding_is_refused() {
    let Some(server) = crate::harness::server("FITCHECK_TEST_PG") else { return };
    let shop = Shop::on(&server, "ENCODING 'LATIN1' TEMPLATE template0 LC_COLLATE 'C' LC_CTYPE 'C'");
    assert_eq!(init(&shop.admin(), SHORT), Err(ShopError::Encoding { encoding: "LATIN1".to_owned() }));
}

#[test]
fn whoever_owns_the_database_and_may_make_roles_is_enough() {
    let Some(shop) = Shop::empty("FITCHECK_TEST_PG") else { return };
    let keeper = shop.login("keeper", "");
    assert!(matches!(init(&access(&keeper), SHORT), Err(ShopError::NoRight { .. })));
    shop.run(&format!(
        "ALTER ROLE {name}_keeper CREATEROLE; ALTER DATABASE {name} OWNER TO {name}_keeper",
        name = shop.name
    ));
    assert_eq!(init(&access(&keeper), SHORT), Ok(SchemaInit::New { version: 1 }));
    let book = Book::new("Mill 3");
    book.checks(3);
    book.send(&shop.station("a")).unwrap();
    assert!(verified(&access(&keeper), &[&book]).is_whole());
    assert_eq!(init(&access(&keeper), SHORT), Ok(SchemaInit::Already { version: 1 }));
}
