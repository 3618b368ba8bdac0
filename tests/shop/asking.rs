//! Questions about the checks of all stations: the same answers as a station's own journal gives, page by page.

use fitcheck::journal::ask::{AskedKinds, Question};
use fitcheck::journal::chain::{Hash, Head};
use fitcheck::journal::entry::{Content, Correction, Entry, Reported, Shown};
use fitcheck::journal::ranges::EntryRanges;
use fitcheck::store::shop::{ShopReader, Stop};
use fitcheck::verdict::Status;

use crate::harness::{Book, SHORT, Shop, bore, check};

fn asked(reader: &ShopReader, question: &Question, most: usize) -> Vec<(String, u64)> {
    let (mut found, mut place) = (Vec::new(), None);
    loop {
        let page = reader.page(question, place, most).unwrap();
        assert!(page.rows.len() <= most);
        found.extend(page.rows.iter().map(|row| (row.station.clone(), row.row.kept.head.number)));
        place = page.next;
        if place.is_none() {
            return found;
        }
    }
}

#[test]
fn every_part_of_a_question_is_answered_for_all_stations() {
    let Some(shop) = Shop::new() else { return };
    let books = ["Mill 3", "Mühle 4"].map(Book::new);
    for (book, who) in books.iter().zip(["Anna", "Jürgen"]) {
        let add = |serial: &str, measured: &str, corrects| {
            let mut about = book.about(serial);
            who.clone_into(&mut about.who);
            about.time.utc_ms = 1_000_000 + i64::try_from(book.length()).unwrap();
            book.add(&Entry { about, content: check(bore(measured), corrects) })
        };
        let first = add("17-0042", "25.012", None);
        add("17-0043", "25.030", None);
        let third = add(
            "18-0001",
            "24.99",
            Some(Correction { target: first, reason: "other part".to_owned(), by: "Bert".to_owned() }),
        );
        let withdrawal = Correction { target: third, reason: "no part".to_owned(), by: "Bert".to_owned() };
        book.add(&Entry { about: book.about("18-0001"), content: Content::Withdrawal(withdrawal) });
        book.add_body(b"not an entry");
        book.send(&shop.station(if who == "Anna" { "a" } else { "b" })).unwrap();
    }
    let reader = ShopReader::open(&shop.admin(), SHORT, &Stop::default()).unwrap();
    let all = [
        ("Mühle 4", 5),
        ("Mühle 4", 4),
        ("Mühle 4", 3),
        ("Mühle 4", 2),
        ("Mill 3", 5),
        ("Mill 3", 4),
        ("Mill 3", 3),
        ("Mill 3", 2),
    ];
    let some = |numbers: &[u64]| -> Vec<(String, u64)> {
        all.iter()
            .filter(|(_, number)| numbers.contains(number))
            .map(|(station, number)| ((*station).to_owned(), *number))
            .collect()
    };
    let text = |text: &str| Some(text.to_owned());
    let none = Question::default;
    for most in [1, 3, 100] {
        assert_eq!(asked(&reader, &none(), most), some(&[2, 3, 4, 5]));
    }
    assert_eq!(reader.page(&none(), None, 100).unwrap().unread, 2);
    let cases = [
        (Question { part: text("flange"), ..none() }, some(&[2, 3, 4, 5])),
        (Question { part: text("flang"), ..none() }, some(&[])),
        (Question { serial: text("17-0043"), ..none() }, some(&[3])),
        (Question { serial: text("17*"), ..none() }, some(&[2, 3])),
        (Question { feature: text("b1"), ..none() }, some(&[2, 3, 4, 5])),
        (Question { callout: text("25 H7"), ..none() }, some(&[2, 3, 4])),
        (Question { callout: text("25 h7"), ..none() }, some(&[])),
        (Question { class: text("H7"), ..none() }, some(&[2, 3, 4])),
        (Question { verdicts: vec![Status::Scrap], ..none() }, some(&[3])),
        (Question { verdicts: vec![Status::Rework, Status::Good], ..none() }, some(&[2, 4])),
        (Question { standing: true, ..none() }, some(&[3])),
        (Question { simulated: Some(true), ..none() }, some(&[])),
        (Question { before_ms: Some(1_000_002), ..none() }, some(&[2])),
        (Question { from_ms: Some(1_000_003), ..none() }, some(&[4, 5])),
        (Question { words: vec!["seco".to_owned(), "flan".to_owned()], ..none() }, some(&[2, 3, 4, 5])),
        (Question { words: vec!["econd".to_owned()], ..none() }, some(&[])),
        (Question { words: vec!["--".to_owned()], ..none() }, some(&[])),
        (Question { words: vec!["'; DROP TABLE fitcheck.entry".to_owned()], ..none() }, some(&[])),
    ];
    for (question, expected) in cases {
        assert_eq!(asked(&reader, &question, 2), expected, "{question:?}");
    }
    let of = |station: &str| some(&[2, 3, 4]).into_iter().filter(|(name, _)| name == station).collect::<Vec<_>>();
    assert_eq!(asked(&reader, &Question { who: text("JÜRGEN"), ..none() }, 2), of("Mühle 4"));
    assert_eq!(
        asked(&reader, &Question { station: text("mühle 4"), callout: text("25 H7"), ..none() }, 2),
        of("Mühle 4")
    );
    assert_eq!(asked(&reader, &Question { words: vec!["jurg".to_owned()], ..none() }, 2), of("Mühle 4"));
    let page = reader.page(&none(), None, 8).unwrap();
    let corrected: Vec<Option<u64>> = page.rows.iter().take(4).map(|row| row.row.corrected_by).collect();
    assert_eq!(corrected, [None, Some(5), None, Some(4)]);
    assert!(page.rows.iter().all(|row| row.row.entry.is_ok()));
}

/// A report of two checks, as a station sends it.
pub(crate) fn report(head: Head) -> Content {
    let shown = Shown { checks: EntryRanges::of([2, 3]), unrecorded: 1, head: Some(head) };
    Content::Report(Reported {
        name: "Flansch \"corrects\":{.html".to_owned(),
        format: "html".to_owned(),
        sha256: Hash([7; 32]),
        bytes: 9,
        title: "Lot 8".to_owned(),
        shown,
    })
}

#[test]
fn reports_of_all_stations_are_listed_and_no_question_for_checks_finds_one() {
    let Some(shop) = Shop::new() else { return };
    let book = Book::new("Mill 3");
    book.checks(2);
    let head = book.add(&Entry { about: book.about("17-0042"), content: check(bore("25.012"), None) });
    let mut about = book.about("");
    about.part = String::new();
    let own = book.add(&Entry { about, content: report(head) });
    book.send(&shop.station("a")).unwrap();
    let reader = ShopReader::open(&shop.admin(), SHORT, &Stop::default()).unwrap();
    let numbers =
        |question: &Question| asked(&reader, question, 2).into_iter().map(|(_, number)| number).collect::<Vec<_>>();
    let none = Question::default;
    assert!(numbers(&none()).contains(&own.number));
    assert_eq!(numbers(&Question { kinds: AskedKinds::Reports, ..none() }), [own.number]);
    assert_eq!(numbers(&Question { words: vec!["flansch".to_owned(), "lot".to_owned()], ..none() }), [own.number]);
    for of_checks in [
        Question { kinds: AskedKinds::Checks, ..none() },
        Question { standing: true, ..none() },
        Question { simulated: Some(false), ..none() },
    ] {
        let found = numbers(&of_checks);
        assert!(!found.is_empty() && !found.contains(&own.number), "{of_checks:?}: {found:?}");
    }
}

#[test]
fn pages_go_on_where_many_entries_came_at_once() {
    let Some(shop) = Shop::new() else { return };
    for number in 0..3 {
        let book = Book::new(&format!("Mill {number}"));
        book.checks(1_700);
        book.send(&shop.station(&format!("mill{number}"))).unwrap();
    }
    // As after a restore that lost the times: the same instant for all.
    shop.run("ALTER TABLE fitcheck.entry DISABLE TRIGGER USER; UPDATE fitcheck.entry SET received = '2026-11-23T12:00:00.123457Z'");
    let reader = ShopReader::open(&shop.admin(), SHORT, &Stop::default()).unwrap();
    let mut found = asked(&reader, &Question::default(), 999);
    assert_eq!(found.len(), 5_100);
    found.sort();
    found.dedup();
    assert_eq!(found.len(), 5_100);
}
