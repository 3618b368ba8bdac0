//! The view for spreadsheets: one row a check in plain columns, from bodies that are really written, and nothing breaks it.

use std::collections::BTreeMap;

use fitcheck::journal::entry::{Check, Checked, Compared, Content, Correction, CycleCheck, CycleOrigin, Entry};
use fitcheck::length::Length;
use fitcheck::verdict::Status;

use crate::harness::{Book, Shop, bore, check};

const COLUMNS: &str = "number, who, part, serial, feature, callout, class, min_mm, max_mm, measured_mm, deviation_um, rule, u_um, \
     status, simulated, origin, remark, correction_of, corrected_by";

fn row(shop: &Shop, number: u64) -> String {
    let columns: Vec<String> = COLUMNS.split(", ").map(|column| format!("coalesce({column}::text, '-')")).collect();
    shop.text(&format!("SELECT concat_ws('|', {}) FROM fitcheck.checks WHERE number = {number}", columns.join(", ")))
}

#[test]
fn a_check_is_a_row_of_plain_columns() {
    let Some(shop) = Shop::new() else { return };
    let book = Book::new("Mill 3");
    let about = |serial: &str| book.about(serial);
    let first = book.add(&Entry { about: about("1"), content: check(bore("25.012"), None) });
    let correction = Correction { target: first, reason: "the next part".to_owned(), by: "Bert".to_owned() };
    let second = book.add(&Entry { about: about("2"), content: check(bore("24.9995"), Some(correction)) });
    let withdrawal = Correction { target: second, reason: "no part".to_owned(), by: "Bert".to_owned() };
    book.add(&Entry { about: about("2"), content: Content::Withdrawal(withdrawal) });
    let nm = |nm| Length::from_nanometres(nm).unwrap();
    let cycle = CycleCheck {
        cycle: 421,
        parameters: vec![("Q262".to_owned(), "25".to_owned())],
        origin: CycleOrigin::Workpiece { file: "ring.toml".into(), seed: 7 },
        contacts: Vec::new(),
        figures: BTreeMap::new(),
        compared: Vec::<Compared>::new(),
        limits: Some([nm(24_900_000), nm(25_100_000)]),
        measured: Some(nm(25_000_001)),
        status: Some(Status::Good),
        block: None,
        datum: None,
    };
    let cycle = Check { what: Checked::Cycle(Box::new(cycle)), files: Vec::new(), corrects: None };
    book.add(&Entry { about: about("3"), content: Content::Check(Box::new(cycle)) });
    // A report is no check.
    book.add(&Entry { about: about(""), content: crate::asking::report(second) });
    book.send(&shop.station("a")).unwrap();
    let remark = "after the second cut";
    assert_eq!(
        row(&shop, 2),
        format!("2|Anna|Flange|1|B1|25 H7|H7|25|25.021|25.012|12|simple|-|GOOD|false|typed|{remark}|-|3")
    );
    assert_eq!(
        row(&shop, 3),
        format!("3|Anna|Flange|2|B1|25 H7|H7|25|25.021|24.9995|-0.5|simple|-|REWORK|false|typed|{remark}|2|4")
    );
    assert_eq!(
        row(&shop, 5),
        format!("5|Anna|Flange|3|B1|-|-|24.9|25.1|25.000001|-|-|-|GOOD|true|workpiece ring.toml|{remark}|-|-")
    );
    assert_eq!(shop.text("SELECT string_agg(number::text, ' ' ORDER BY number) FROM fitcheck.checks"), "2 3 5");
    let time = book.about("").time;
    assert_eq!(shop.text("SELECT offset_min FROM fitcheck.checks LIMIT 1"), time.offset_min.to_string());
    let late: f64 = shop.text("SELECT clock_difference_s FROM fitcheck.checks WHERE number = 2").parse().unwrap();
    assert!((0.0..60.0).contains(&late), "{late}");
    assert_eq!(shop.text("SELECT hash FROM fitcheck.checks WHERE number = 2"), first.hash.to_string());
    assert_eq!(shop.text("SELECT chain FROM fitcheck.checks WHERE number = 2"), book.chain.to_string());
    let login = shop.text("SELECT login FROM fitcheck.checks WHERE number = 2");
    assert_eq!(login, format!("{}_a", shop.name), "whose login it came by");
}

#[test]
fn an_entry_keeps_the_station_that_was_recorded_with_it_whoever_sends_it() {
    let Some(shop) = Shop::new() else { return };
    let book = Book::new("Mill 3");
    book.checks(2);
    book.add_body(b"no entry");
    let mut sender = book.clone();
    "Office".clone_into(&mut sender.station);
    sender.send(&shop.station("a")).unwrap();
    let stations = "SELECT string_agg(station, ', ' ORDER BY number) FROM fitcheck";
    assert_eq!(
        shop.text(&format!("{stations}.entry")),
        "Mill 3, Mill 3, Mill 3, Office",
        "what says none has the sender's"
    );
    assert_eq!(shop.text(&format!("{stations}.checks WHERE status IS NOT NULL")), "Mill 3, Mill 3");
    let verified = crate::chains::verified(&shop.admin(), &[&book]);
    assert_eq!((verified.is_whole(), verified.chains[0].renamed), (true, 0));
    shop.run(
        "ALTER TABLE fitcheck.entry DISABLE TRIGGER entry_keeps; UPDATE fitcheck.entry SET station = 'Mill 4' WHERE number = 2; \
         ALTER TABLE fitcheck.entry ENABLE ALWAYS TRIGGER entry_keeps",
    );
    assert_eq!(crate::chains::verified(&shop.admin(), &[&book]).chains[0].renamed, 1, "and another name is noticed");
}

#[test]
fn the_bodies_of_the_repository_are_rows_too() {
    let Some(shop) = Shop::new() else { return };
    let book = Book::new("Mill 3");
    book.cut(0);
    for name in ["1", "2", "3"] {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/data/journal/{name}.json"));
        book.add_body(&std::fs::read(path).unwrap());
    }
    book.send(&shop.station("a")).unwrap();
    let row = row(&shop, 3);
    assert!(row.starts_with("3|Anna|Flange|17-0043|B1|25 H7|H7|25|25.021|25.007892|7.892|iso14253-2017|1.2|GOOD|false|contacts bore.csv|"), "{row}");
    assert!(row.ends_with("|2|-"), "{row}");
    assert_eq!(shop.text("SELECT corrected_by FROM fitcheck.checks WHERE number = 2"), "3");
    assert_eq!(
        shop.text("SELECT at AT TIME ZONE 'UTC' FROM fitcheck.checks WHERE number = 3"),
        "2026-11-23 12:00:00.123"
    );
}

#[test]
fn a_body_that_is_no_entry_is_an_empty_row_and_breaks_nothing() {
    let Some(shop) = Shop::new() else { return };
    let book = Book::new("Mill 3");
    let odd = [
        "",
        "no JSON",
        "[]",
        "7",
        r#"{"v":1,"kind":"check"}"#,
        r#"{"v":1,"kind":"check","about":7,"check":[]}"#,
        r#"{"v":1,"kind":"check","about":{"time":{"utc_ms":"yesterday"}},"check":{"status":"GOOD"}}"#,
        r#"{"v":1,"kind":"check","about":{"time":{"utc_ms":9223372036854775807}},"check":{"size":{"limits":{"min_nm":1e300}}}}"#,
        r#"{"v":1,"kind":"check","about":{"who":"\u0000"},"check":{"status":"GOOD"}}"#,
        r#"{"v":1,"kind":"check","check":{"corrects":{"number":"2; DROP TABLE"}}}"#,
        r#"{"v":1,"kind":"check","check":{"corrects":{"number":99999999999999999999}}}"#,
        r#"{"v":9,"kind":"measured in another way"}"#,
    ];
    for body in odd {
        book.add_body(body.as_bytes());
    }
    book.add_body("[".repeat(50_000).as_bytes());
    book.checks(1);
    book.send(&shop.station("a")).unwrap();
    assert_eq!(shop.number("SELECT count(*) FROM fitcheck.checks"), 13);
    assert_eq!(
        shop.text("SELECT string_agg(number::text, ' ' ORDER BY number) FROM fitcheck.checks WHERE status IS NOT NULL"),
        "15"
    );
    assert_eq!(shop.number("SELECT count(*) FROM fitcheck.checks WHERE corrected_by IS NOT NULL"), 0);
}
