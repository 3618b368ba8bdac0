//! What the roles may do, and what nobody may but a superuser who takes the triggers away.

use fitcheck::store::shop::ShopFinding;

use crate::chains::verified;
use crate::harness::{Book, Shop, access, by};

#[test]
fn a_station_only_reads_and_adds_to_its_own_journal() {
    let Some(shop) = Shop::new() else { return };
    let (own, other) = (shop.login("a", "fitcheck_station"), shop.login("b", "fitcheck_station"));
    let (book, another) = (Book::new("Mill 3"), Book::new("Mill 4"));
    book.checks(3);
    another.checks(3);
    book.send(&access(&own)).unwrap();
    another.send(&access(&other)).unwrap();
    let (chain, foreign) = (format!("'\\x{}'::bytea", book.chain), format!("'\\x{}'::bytea", another.chain));
    for sql in
        ["SELECT count(*) FROM fitcheck.entry", "SELECT * FROM fitcheck.checks", "SELECT version FROM fitcheck.meta"]
    {
        assert_eq!(by(&own, sql), Ok(()), "{sql}");
    }
    book.checks(1);
    another.checks(1);
    let insert = |chain: &str, book: &Book| {
        let kept = book.kept(5);
        let body = String::from_utf8(kept.body.to_vec()).unwrap().replace('\'', "''");
        format!(
            "INSERT INTO fitcheck.entry (chain, number, station, hash, body) VALUES ({chain}, 5, 'x', '\\x{}', '{body}')",
            kept.head.hash
        )
    };
    let right = "42501".to_owned();
    let refused = [
        "UPDATE fitcheck.entry SET station = 'x'".to_owned(),
        "UPDATE fitcheck.entry SET body = '{}' WHERE number = 2".to_owned(),
        "DELETE FROM fitcheck.entry".to_owned(),
        "TRUNCATE fitcheck.entry".to_owned(),
        "TRUNCATE fitcheck.chain CASCADE".to_owned(),
        "DELETE FROM fitcheck.chain".to_owned(),
        "UPDATE fitcheck.chain SET login = session_user".to_owned(),
        "UPDATE fitcheck.meta SET version = 9".to_owned(),
        "DROP TRIGGER entry_keeps ON fitcheck.entry".to_owned(),
        "ALTER TABLE fitcheck.entry DISABLE TRIGGER ALL".to_owned(),
        "ALTER TABLE fitcheck.entry DISABLE ROW LEVEL SECURITY".to_owned(),
        "DROP TABLE fitcheck.entry".to_owned(),
        "DROP SCHEMA fitcheck CASCADE".to_owned(),
        "DROP VIEW fitcheck.checks".to_owned(),
        "CREATE TABLE fitcheck.mine (a int)".to_owned(),
        "CREATE OR REPLACE FUNCTION fitcheck.follow() RETURNS trigger LANGUAGE plpgsql AS 'BEGIN RETURN NULL; END'"
            .to_owned(),
        "SET session_replication_role = replica".to_owned(),
        "SET ROLE fitcheck_owner".to_owned(),
        "SET SESSION AUTHORIZATION postgres".to_owned(),
        insert(&foreign, &another),
        format!("{} ON CONFLICT (chain, number) DO UPDATE SET station = 'y'", insert(&chain, &book)),
        format!("INSERT INTO fitcheck.chain (chain, login) VALUES ('\\x{}', 'fitadmin')", "00".repeat(16)),
        format!(
            "INSERT INTO fitcheck.entry (chain, number, station, hash, body, received) VALUES ({chain}, 5, 'x', '\\x00', '', now())"
        ),
    ];
    for sql in refused {
        let error = by(&own, &sql).expect_err(&sql);
        assert!(error == right || error == "22023" || error == "42P17", "{sql}: {error}");
    }
    let link = "23000".to_owned();
    // A hash of its own, a number too far, an entry that is another chain's.
    let wrong_hash = insert(&chain, &book).replace(&book.kept(5).head.hash.to_string(), &"ab".repeat(32));
    let too_far = insert(&chain, &book).replace(", 5, 'x'", ", 6, 'x'");
    for sql in [wrong_hash, too_far, insert(&chain, &another)] {
        assert_eq!(by(&own, &sql), Err(link.clone()), "{sql}");
    }
    assert_eq!(by(&own, &insert(&chain, &book)), Ok(()));
    assert_eq!(by(&own, &insert(&chain, &book)), Err("23505".to_owned()));
    assert!(verified(&shop.admin(), &[&book]).is_whole());
}

#[test]
fn a_reader_only_reads_and_nobody_else_sees_anything() {
    let Some(shop) = Shop::new() else { return };
    let book = Book::new("Mill 3");
    book.send(&shop.station("a")).unwrap();
    let (reader, nobody) = (shop.login("reader", "fitcheck_reader"), shop.login("nobody", ""));
    for table in ["checks", "entry", "chain", "meta"] {
        assert_eq!(by(&reader, &format!("SELECT count(*) FROM fitcheck.{table}")), Ok(()), "{table}");
        assert_eq!(by(&nobody, &format!("SELECT count(*) FROM fitcheck.{table}")), Err("42501".to_owned()), "{table}");
    }
    for sql in [
        "INSERT INTO fitcheck.chain (chain) VALUES ('\\x00')",
        "DELETE FROM fitcheck.entry",
        "UPDATE fitcheck.entry SET body = ''",
    ] {
        assert_eq!(by(&reader, sql), Err("42501".to_owned()), "{sql}");
    }
    assert!(verified(&access(&reader), &[&book]).is_whole(), "whoever reads can verify");
}

#[test]
fn even_a_superuser_is_refused_until_the_triggers_are_off_and_then_verify_says_so() {
    let Some(shop) = Shop::new() else { return };
    let book = Book::new("Mill 3");
    book.checks(3);
    book.send(&shop.station("a")).unwrap();
    for sql in [
        "UPDATE fitcheck.entry SET station = 'x'",
        "DELETE FROM fitcheck.entry WHERE false",
        "TRUNCATE fitcheck.entry",
        "TRUNCATE fitcheck.chain CASCADE",
        "DELETE FROM fitcheck.chain",
        "SET session_replication_role = replica; DELETE FROM fitcheck.entry",
    ] {
        assert_eq!(shop.attempt(sql), Err("42501".to_owned()), "{sql}");
    }
    shop.run("SET session_replication_role = origin");
    assert!(verified(&shop.admin(), &[&book]).is_whole());
    let cases = [
        (
            "ALTER TABLE fitcheck.entry DISABLE TRIGGER entry_keeps",
            "ALTER TABLE fitcheck.entry ENABLE ALWAYS TRIGGER entry_keeps",
            "entry_keeps",
        ),
        (
            "ALTER TABLE fitcheck.entry ENABLE TRIGGER entry_stays",
            "ALTER TABLE fitcheck.entry ENABLE ALWAYS TRIGGER entry_stays",
            "entry_stays",
        ),
        (
            "ALTER TABLE fitcheck.entry DISABLE TRIGGER entry_follows",
            "ALTER TABLE fitcheck.entry ENABLE TRIGGER entry_follows",
            "entry_follows",
        ),
        ("DROP TRIGGER chain_stays ON fitcheck.chain", "", "chain_stays"),
    ];
    for (change, back, name) in cases {
        shop.run(change);
        let found = verified(&shop.admin(), &[&book]);
        assert_eq!(found.findings, [ShopFinding::Altered { name: name.to_owned() }], "{change}");
        shop.run(back);
    }
    shop.run("ALTER TABLE fitcheck.entry DISABLE ROW LEVEL SECURITY");
    assert!(
        verified(&shop.admin(), &[&book]).findings.contains(&ShopFinding::RowSecurity { name: "entry".to_owned() })
    );
}
