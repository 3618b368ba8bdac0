//! Chains on the server are walked here, and the first entry that is not what was written is named.

use std::ops::ControlFlow;

use fitcheck::journal::chain::{ChainId, Head, entry_hash};
use fitcheck::journal::inspection::Break;
use fitcheck::store::shop::{Access, ShopError, ShopFinding, ShopVerified, Thing, clocks, verify};

use crate::harness::{Book, SHORT, Shop, bore, check};

/// What is found on the server, compared with what these journals have.
pub fn verified(access: &Access, books: &[&Book]) -> ShopVerified {
    let known: Vec<(ChainId, Head)> = books.iter().map(|book| (book.chain, book.last())).collect();
    verify(access, &known, SHORT, &mut |_, _| ControlFlow::Continue(())).unwrap()
}

/// Three stations with 2 500 entries each, of which something is done to the second.
fn found(harm: impl Fn(&Shop, &Book)) -> Option<(ShopVerified, [Book; 3])> {
    let shop = Shop::new()?;
    let books = [1, 2, 3].map(|number| {
        let book = Book::new(&format!("Mill {number}"));
        book.checks(2_499);
        book.send(&shop.station(&format!("mill{number}"))).unwrap();
        book
    });
    shop.run("ALTER TABLE fitcheck.entry DISABLE TRIGGER USER");
    harm(&shop, &books[1]);
    shop.run("ALTER TABLE fitcheck.entry ENABLE TRIGGER USER; ALTER TABLE fitcheck.entry ENABLE ALWAYS TRIGGER entry_keeps; ALTER TABLE fitcheck.entry ENABLE ALWAYS TRIGGER entry_stays");
    let all: Vec<&Book> = books.iter().collect();
    Some((verified(&shop.admin(), &all), books))
}

fn of(chain: ChainId) -> String {
    format!("chain = '\\x{chain}'::bytea")
}

#[track_caller]
fn breaks(harm: impl Fn(&Shop, &Book), expected: &[Break]) {
    let Some((verified, books)) = found(harm) else { return };
    assert_eq!((&verified.missing, &verified.findings), (&Vec::new(), &Vec::new()));
    assert!(verified.is_complete() && verified.entries() > 7_000);
    for (book, station) in books.iter().zip(["Mill 1", "Mill 2", "Mill 3"]) {
        let chain = verified.chains.iter().find(|chain| chain.chain == book.chain).unwrap();
        assert_eq!(chain.station, station);
        assert!(chain.login.as_ref().unwrap().contains("_mill"));
        let expected = if station == "Mill 2" { expected } else { &[] };
        assert_eq!(chain.inspected.breaks, expected, "{station}");
    }
    assert_eq!(verified.is_whole(), expected.is_empty());
}

#[test]
fn whole_chains_are_whole() {
    breaks(|_, _| {}, &[]);
}

#[test]
fn one_changed_byte_is_named() {
    let change = |shop: &Shop, book: &Book| {
        shop.run(&format!(
            "UPDATE fitcheck.entry SET body = replace(body, 'Flange', 'Flangf') WHERE {} AND number = 1234",
            of(book.chain)
        ));
    };
    breaks(change, &[Break::Changed { number: 1234 }]);
}

#[test]
fn a_removed_entry_is_named() {
    let remove = |shop: &Shop, book: &Book| {
        shop.run(&format!("DELETE FROM fitcheck.entry WHERE {} AND number = 2001", of(book.chain)));
    };
    breaks(remove, &[Break::Removed { number: 2001, count: 1 }]);
}

#[test]
fn a_removed_entry_is_named_where_the_others_moved_up() {
    let remove = |shop: &Shop, book: &Book| {
        let of = of(book.chain);
        shop.run(&format!(
            "DELETE FROM fitcheck.entry WHERE {of} AND number = 2001; \
             UPDATE fitcheck.entry SET number = -number WHERE {of} AND 2001 < number; \
             UPDATE fitcheck.entry SET number = -number - 1 WHERE {of} AND number < 0"
        ));
    };
    let with_check = |shop: &Shop, book: &Book| {
        shop.run("ALTER TABLE fitcheck.entry DROP CONSTRAINT entry_number_check");
        remove(shop, book);
    };
    let Some((verified, books)) = found(with_check) else { return };
    let gone = ShopFinding::Gone { kind: Thing::Table, name: "entry_number_check".to_owned() };
    assert_eq!(verified.findings, [gone], "what was taken away for it is told, too");
    let chain = verified.chains.iter().find(|chain| chain.chain == books[1].chain).unwrap();
    assert_eq!(chain.inspected.breaks.first(), Some(&Break::Removed { number: 2001, count: 1 }));
    assert!(chain.inspected.breaks.contains(&Break::CutOff { last: 2499, known: 2500 }));
}

#[test]
fn an_inserted_entry_is_named() {
    let insert = |shop: &Shop, book: &Book| {
        let of = of(book.chain);
        shop.run(&format!(
            "ALTER TABLE fitcheck.entry DROP CONSTRAINT entry_number_check; \
             UPDATE fitcheck.entry SET number = -number WHERE {of} AND 100 < number; \
             UPDATE fitcheck.entry SET number = -number + 1 WHERE {of} AND number < 0; \
             INSERT INTO fitcheck.entry SELECT chain, 101, station, hash, body FROM fitcheck.entry WHERE {of} AND number = 7"
        ));
    };
    let Some((verified, books)) = found(insert) else { return };
    let chain = verified.chains.iter().find(|chain| chain.chain == books[1].chain).unwrap();
    assert_eq!(chain.inspected.breaks.first(), Some(&Break::Inserted { number: 101 }));
}

#[test]
fn a_number_that_is_there_twice_is_found() {
    let double = |shop: &Shop, book: &Book| {
        shop.run(&format!(
            "ALTER TABLE fitcheck.entry DROP CONSTRAINT entry_pkey; \
             INSERT INTO fitcheck.entry SELECT * FROM fitcheck.entry WHERE {} AND number = 2000",
            of(book.chain)
        ));
    };
    let Some((verified, books)) = found(double) else { return };
    let chain = verified.chains.iter().find(|chain| chain.chain == books[1].chain).unwrap();
    assert!(
        matches!(
            chain.inspected.breaks.first(),
            Some(Break::Inserted { number: 1999..=2001 } | Break::Changed { number: 2000 })
        ),
        "{:?}",
        chain.inspected.breaks
    );
}

#[test]
fn two_entries_that_changed_places_are_named() {
    let swap = |shop: &Shop, book: &Book| {
        let of = of(book.chain);
        shop.run(&format!(
            "ALTER TABLE fitcheck.entry DROP CONSTRAINT entry_number_check; \
             UPDATE fitcheck.entry SET number = -40 WHERE {of} AND number = 40; \
             UPDATE fitcheck.entry SET number = 40 WHERE {of} AND number = 41; \
             UPDATE fitcheck.entry SET number = 41 WHERE {of} AND number = -40; \
             ALTER TABLE fitcheck.entry ADD CONSTRAINT entry_number_check CHECK (0 < number)"
        ));
    };
    breaks(swap, &[Break::Reordered { number: 40, other: 41 }]);
}

#[test]
fn what_was_cut_off_is_known_from_the_station() {
    let cut = |shop: &Shop, book: &Book| {
        shop.run(&format!("DELETE FROM fitcheck.entry WHERE {} AND 2400 < number", of(book.chain)));
    };
    breaks(cut, &[Break::CutOff { last: 2400, known: 2500 }]);
}

#[test]
fn a_chain_that_was_written_anew_is_known_from_the_station() {
    let rewrite = |shop: &Shop, book: &Book| {
        let kept = book.kept(2_499);
        let before = kept.head;
        let body = r#"{"v":1,"forged":true}"#;
        let hash = entry_hash(book.chain, before, body.as_bytes()).unwrap();
        shop.run(&format!(
            "UPDATE fitcheck.entry SET body = '{body}', hash = '\\x{hash}' WHERE {} AND number = 2500",
            of(book.chain)
        ));
    };
    breaks(rewrite, &[Break::Rewritten { number: 2500 }]);
}

#[test]
fn a_chain_that_is_gone_altogether_is_missing() {
    let gone = |shop: &Shop, book: &Book| {
        shop.run(&format!("DELETE FROM fitcheck.entry WHERE {}", of(book.chain)));
    };
    let Some((verified, books)) = found(gone) else { return };
    assert_eq!(verified.findings, []);
    assert_eq!(verified.missing, [(books[1].chain, books[1].last())]);
    assert_eq!(verified.chains.len(), 2);
    assert!(!verified.is_whole());
}

#[test]
fn looking_tells_how_far_it_is_and_can_be_stopped() {
    let Some(shop) = Shop::new() else { return };
    let book = Book::new("Mill 3");
    book.checks(5_000);
    book.send(&shop.station("a")).unwrap();
    shop.run("ANALYZE fitcheck.entry");
    let mut told = Vec::new();
    let known = [(book.chain, book.last())];
    let whole = verify(&shop.admin(), &known, SHORT, &mut |done, all| {
        told.push((done, all));
        ControlFlow::Continue(())
    });
    assert!(whole.unwrap().is_whole());
    assert_eq!(told, [(2_000, 5_001), (4_000, 5_001)]);
    let stopped = verify(&shop.admin(), &known, SHORT, &mut |_, _| ControlFlow::Break(()));
    assert_eq!(stopped, Err(ShopError::Stopped));
}

#[test]
fn the_clocks_of_stations_are_told_and_change_nothing() {
    let Some(shop) = Shop::new() else { return };
    let hour = 3_600_000;
    for (number, ahead_ms) in [(1, 0), (2, hour), (3, -hour)] {
        let book = Book::new(&format!("Mill {number}"));
        for _ in 0..3 {
            let mut about = book.about("1");
            about.time.utc_ms += ahead_ms;
            book.add(&fitcheck::journal::entry::Entry { about, content: check(bore("25.012"), None) });
        }
        book.add_body(b"no entry");
        book.send(&shop.station(&format!("mill{number}"))).unwrap();
    }
    let clocks = clocks(&shop.admin(), SHORT).unwrap();
    let stations: Vec<&str> = clocks.iter().map(|clock| clock.station.as_str()).collect();
    assert_eq!(stations, ["Mill 1", "Mill 2", "Mill 3"]);
    for (clock, late) in clocks.iter().zip([0, -hour, hour]) {
        assert!((clock.newest_ms - late).abs() < 60_000, "{clock:?}");
        assert!(clock.least_ms <= clock.newest_ms, "{clock:?}");
    }
    // The first entry has the right time and the others an hour more or less: nothing is sorted by it.
    let numbers = shop.text(
        "SELECT string_agg(number::text, ' ' ORDER BY received, number) FROM fitcheck.entry WHERE station = 'Mill 2'",
    );
    assert_eq!(numbers, "1 2 3 4 5");
}
