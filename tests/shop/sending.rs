//! A journal sent to the server: once, in the background, and when it is not the one that the server knows.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use fitcheck::files;
use fitcheck::journal::body::{self, BodyError};
use fitcheck::journal::chain::Head;
use fitcheck::journal::entry::Entry;
use fitcheck::message::Say as _;
use fitcheck::store::local::{Journal, Opening, Reader};
use fitcheck::store::shop::{
    Doing, LONGEST_BODY, Places, Sender, Sending, ShopAddress, ShopError, Source as _, send_once, verify,
};

use crate::harness::{Book, SHORT, Shop, access, bore, check};
use crate::relay::{Relay, port};

#[test]
fn what_the_server_lacks_is_sent_in_order_and_nothing_twice() {
    let Some(shop) = Shop::new() else { return };
    let station = shop.station("a");
    let book = Book::new("Mill 3");
    book.checks(1_300);
    let mut told = Vec::new();
    let sent = send_once(&book, "Mill 3", &station, SHORT, &mut |sent| {
        told.push(sent.unsent);
        ControlFlow::Continue(())
    });
    let sent = sent.unwrap();
    assert_eq!((sent.entries, sent.head, sent.unsent), (1_301, book.last(), 0));
    assert_eq!((told.first(), told.last()), (Some(&1_301), Some(&0)));
    assert!(told.is_sorted_by(|one, next| next <= one));
    assert_eq!(shop.counts(&book), (1_301, 1_301));
    let again = book.send(&station).unwrap();
    assert_eq!((again.entries, again.head), (0, book.last()));
    book.checks(3);
    assert_eq!(book.send(&station).unwrap().entries, 3);
    assert_eq!(shop.counts(&book), (1_304, 1_304));
    assert_eq!(shop.text("SELECT string_agg(DISTINCT station, ',') FROM fitcheck.entry"), "Mill 3");
    let stopped = Book::new("Mill 4");
    stopped.checks(1_200);
    let result = send_once(&stopped, "", &shop.station("b"), SHORT, &mut |sent| {
        if sent.entries < 500 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    assert_eq!(result, Err(ShopError::Stopped));
    assert_eq!(shop.counts(&stopped), (500, 500));
}

#[test]
fn the_journal_of_a_station_is_a_source() {
    let Some(shop) = Shop::new() else { return };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.sqlite");
    let book = Book::new("Mill 3");
    let opening = Opening { anchors: None, ..Opening::new("Mill 3", book.about("").time) };
    let mut journal = Journal::open(&path, &opening).unwrap();
    let entry = |serial: &str| Entry { about: book.about(serial), content: check(bore("25.012"), None) };
    journal.append(&[entry("1"), entry("2")]).unwrap();
    let reader = Reader::open(&path).unwrap();
    let access = shop.station("a");
    let send = || send_once(&reader, "Mill 3", &access, SHORT, &mut |_sent| ControlFlow::Continue(()));
    assert_eq!(send().unwrap().entries, 3);
    journal.append(&[entry("3")]).unwrap();
    let sent = send().unwrap();
    assert_eq!((sent.entries, sent.head), (1, journal.head().unwrap()));
    assert!(
        verify(&access, &[(journal.chain(), sent.head)], SHORT, &mut |_, _| ControlFlow::Continue(()))
            .unwrap()
            .is_whole()
    );
}

#[test]
fn a_thousand_checks_of_three_stations_arrive_once_each_after_the_server_was_down() {
    let Some(shop) = Shop::new() else { return };
    let free = std::net::TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
    let counts = [334_usize, 333, 333];
    let stations: Vec<_> = (1..)
        .zip(counts)
        .map(|(number, _)| {
            let book = Book::new(&format!("Mill {number}"));
            let address = shop.login(&format!("mill{number}"), "fitcheck_station");
            let (sender, told) = book.sender(&crate::relay::through(&address, free), SHORT);
            (book, sender, told)
        })
        .collect();
    for ((book, sender, told), count) in stations.iter().zip(counts) {
        let status = told.until("that nobody answers", |status| status.doing == Doing::Waiting);
        assert!(matches!(status.problem, Some(ShopError::Unreachable { .. })), "{status:?}");
        for _ in 0..count {
            book.checks(1);
            sender.wake();
        }
    }
    let relay = Relay::on(free, port(&shop.address));
    let (mut arrived, mut chains) = (0, Vec::new());
    for (book, _sender, told) in &stations {
        told.all(book);
        let (all, different) = shop.counts(book);
        assert_eq!((all, different), (book.length(), book.length()));
        arrived += all - 1;
        chains.push((book.chain, book.last()));
    }
    assert_eq!(
        (arrived, shop.number("SELECT count(DISTINCT (chain, number)) FROM fitcheck.entry WHERE 1 < number")),
        (1_000, 1_000)
    );
    let verified = verify(&shop.admin(), &chains, SHORT, &mut |_, _| ControlFlow::Continue(())).unwrap();
    assert!(verified.is_whole() && verified.chains.len() == 3, "{verified:?}");
    // And what is checked from now on arrives at once.
    for (book, sender, told) in stations {
        book.checks(1);
        let begun = Instant::now();
        sender.wake();
        told.all(&book);
        // Not by the look that comes every thirty seconds.
        assert!(begun.elapsed() < Duration::from_secs(28));
        sender.stop();
    }
    println!(
        "three stations, 1000 checks while the server was down: {arrived} arrived, each once; {} connections",
        relay.connections()
    );
}

#[test]
fn ten_stations_send_at_once() {
    let Some(shop) = Shop::new() else { return };
    let books: Vec<_> =
        (0..10).map(|number| (Book::new(&format!("Mill {number}")), shop.station(&format!("mill{number}")))).collect();
    let done = AtomicUsize::new(0);
    thread::scope(|scope| {
        for (book, access) in &books {
            scope.spawn(|| {
                for _ in 0..5 {
                    book.checks(100);
                    book.send(access).unwrap();
                }
                done.fetch_add(1, Ordering::SeqCst);
            });
        }
    });
    for (book, _) in &books {
        assert_eq!(shop.counts(book), (501, 501));
    }
    let heads: Vec<_> = books.iter().map(|(book, _)| (book.chain, book.last())).collect();
    assert!(verify(&shop.admin(), &heads, SHORT, &mut |_, _| ControlFlow::Continue(())).unwrap().is_whole());
    println!("ten stations at once: {} entries, each once", shop.number("SELECT count(*) FROM fitcheck.entry"));
}

#[test]
fn two_programs_send_the_same_journal_at_once() {
    let Some(shop) = Shop::new() else { return };
    let (book, access) = (Book::new("Mill 3"), shop.station("a"));
    book.checks(3_000);
    thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| {
                while let Err(error) = book.send(&access) {
                    assert!(error.is_passing(), "{error}");
                }
            });
        }
    });
    assert_eq!(shop.counts(&book), (3_001, 3_001));
}

#[test]
fn a_copy_of_a_journal_that_goes_its_own_way_is_stopped_with_both_hashes() {
    let Some(shop) = Shop::new() else { return };
    let (book, address) = (Book::new("Mill 3"), shop.login("a", "fitcheck_station"));
    book.checks(5);
    book.send(&access(&address)).unwrap();
    let copy = book.copied();
    book.checks(2);
    book.send(&access(&address)).unwrap();
    // Not more than the server has: an older copy was put back.
    assert_eq!(copy.send(&access(&address)), Err(ShopError::Ahead { ours: 6, theirs: 8 }));
    copy.checks(7);
    let (ours, theirs) = (copy.kept(8).head.hash, book.kept(8).head.hash);
    let fork = ShopError::Fork { number: 8, ours, theirs };
    assert_eq!(copy.send(&access(&address)), Err(fork.clone()));
    let said = fork.to_string();
    assert!(said.contains(&ours.short()) && said.contains(&theirs.short()), "{said}");
    let (sender, told) = copy.sender(&address, SHORT);
    let status = told.until("the fork", |status| status.doing == Doing::Stopped);
    assert_eq!(status.problem, Some(fork));
    // Nothing is tried before somebody says so.
    copy.checks(1);
    sender.wake();
    thread::sleep(Duration::from_millis(300));
    let told_before = told.0.lock().unwrap().len();
    thread::sleep(Duration::from_millis(300));
    assert_eq!(told.0.lock().unwrap().len(), told_before);
    assert_eq!(told_before, 2);
    sender.try_again();
    let again = told.clone();
    told.until("the fork again", |status| status.doing == Doing::Stopped && 3 < again.0.lock().unwrap().len());
    assert_eq!(shop.counts(&book), (8, 8));
}

#[test]
fn a_fork_is_found_in_the_middle_of_sending_too() {
    let Some(shop) = Shop::new() else { return };
    let (book, address) = (Book::new("Mill 3"), shop.login("a", "fitcheck_station"));
    book.checks(1_199);
    let copy = book.copied();
    copy.cut(700);
    copy.checks(900);
    let station = access(&address);
    // While one copy has sent its first batch, the other one sends everything.
    let mut first = true;
    let result = send_once(&book, "Mill 3", &station, SHORT, &mut |sent| {
        if sent.entries == 500 && std::mem::take(&mut first) {
            copy.send(&access(&address)).unwrap();
        }
        ControlFlow::Continue(())
    });
    let (ours, theirs) = (book.kept(701).head.hash, copy.kept(701).head.hash);
    assert_eq!(result, Err(ShopError::Fork { number: 701, ours, theirs }));
    assert_eq!(shop.counts(&copy), (1_600, 1_600));
}

#[test]
fn each_refusal_has_its_sentence_and_no_password() {
    let Some(shop) = Shop::empty("FITCHECK_TEST_PG") else { return };
    let book = Book::new("Mill 3");
    let not_made = ShopError::NotMade { database: shop.name.clone() };
    assert_eq!(book.send(&shop.admin()), Err(not_made));
    let none = shop.login("nobody", "");
    fitcheck::store::shop::init(&shop.admin(), SHORT).unwrap();
    assert!(matches!(book.send(&access(&none)), Err(ShopError::NoRight { .. })));
    let reader = shop.login("reader", "fitcheck_reader");
    assert!(matches!(book.send(&access(&reader)), Err(ShopError::NoRight { .. })));
    let station = shop.login("a", "fitcheck_station");
    book.send(&access(&station)).unwrap();
    let other = shop.login("b", "fitcheck_station");
    let name = |login: &str| format!("{}_{login}", shop.name);
    let expected = ShopError::OtherLogin { login: name("a"), ours: name("b") };
    assert_eq!(book.send(&access(&other)), Err(expected));
    let errors = [
        station.replace("secret%20a", "wrong"),
        station.replace(":top%20secret%20a@", "@"),
        station.replace(&shop.name, "nothing"),
        crate::relay::through(&station, 1),
        station.replace("127.0.0.1", "%2Fnowhere"),
    ]
    .map(|address| book.send(&access(&address)).unwrap_err());
    let kinds = errors.clone().map(|error| match error {
        ShopError::Refused { .. } => "refused",
        ShopError::NoPassword { .. } => "no password",
        ShopError::Unreachable { .. } => "unreachable",
        _ => "other",
    });
    assert_eq!(kinds, ["refused", "no password", "refused", "unreachable", "unreachable"], "{errors:?}");
    assert_eq!(errors.clone().map(|error| error.is_passing()), [false, false, false, true, true]);
    for error in errors {
        let text = format!("{error} {error:?} {:?}", error.message());
        assert!(!text.contains("secret") && !text.contains("wrong"), "{text}");
    }
}

#[test]
fn a_password_that_was_put_right_is_found_when_somebody_says_so() {
    let Some(shop) = Shop::new() else { return };
    let (book, login) = (Book::new("Mill 3"), shop.login("a", "fitcheck_station"));
    let (address, given) = ShopAddress::read(&login).unwrap();
    assert!(given.is_some());
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pgpass");
    let sending = Sending {
        source: Box::new(book.clone()),
        station: "Mill 3".to_owned(),
        address: address.clone(),
        given: None,
        places: Places { file: Some(path.clone()), ..Places::none() },
        known: Some(Head::default()),
        patience: SHORT,
    };
    let write = |password: &str| {
        files::write(&path, format!("*:*:*:{}:{password}\n", address.user()).as_bytes()).unwrap();
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o600)).unwrap();
        }
    };
    let (sender, told) = Book::sender_as(sending);
    let status = told.until("no password", |status| status.doing == Doing::Stopped);
    assert_eq!(status.problem, Some(ShopError::NoPassword { user: address.user().to_owned() }));
    write("wrong secret");
    sender.try_again();
    let status = told.until("a refusal", |status| matches!(status.problem, Some(ShopError::Refused { .. })));
    assert!(!format!("{status:?}").contains("secret"));
    assert_eq!(status.unsent, Some(1), "the journal is counted by what the server had last");
    book.checks(1);
    sender.wake();
    told.until("one more", |status| status.unsent == Some(2));
    write("top secret a");
    sender.try_again();
    told.until("the last entry", |status| status.server == Some(book.last()));
    for status in told.0.lock().unwrap().iter() {
        assert!(!format!("{status:?}").contains("secret"), "{status:?}");
    }
}

#[test]
fn statements_in_every_text_are_texts() {
    let Some(shop) = Shop::new() else { return };
    let access = shop.station("a");
    let nasty = "'; DROP TABLE fitcheck.entry; -- \\'; $$ \" %s {} \u{202e}é\u{1f600}";
    let book = Book::new(nasty);
    let mut about = book.about(nasty);
    for text in [&mut about.who, &mut about.part, &mut about.feature, &mut about.remark] {
        nasty.clone_into(text);
    }
    book.add(&Entry { about, content: check(bore("25.012"), None) });
    book.send(&access).unwrap();
    assert_eq!(shop.counts(&book), (2, 2));
    let kept = shop.text("SELECT concat_ws('|', station, who, part, serial, feature, remark) FROM fitcheck.checks");
    assert_eq!(kept, [nasty; 6].join("|"));
    assert!(
        verify(&access, &[(book.chain, book.last())], SHORT, &mut |_, _| ControlFlow::Continue(())).unwrap().is_whole()
    );
}

#[test]
fn texts_of_ten_megabytes_are_refused_before_they_are_an_entry_and_a_body_too_long_before_it_is_sent() {
    let book = Book::new("Mill 3");
    let long = "a".repeat(10 << 20);
    for field in 0..6 {
        let mut about = book.about("1");
        let texts = [
            &mut about.station,
            &mut about.who,
            &mut about.part,
            &mut about.serial,
            &mut about.feature,
            &mut about.remark,
        ];
        long.clone_into(texts.into_iter().nth(field).unwrap());
        let entry = Entry { about, content: check(bore("25.012"), None) };
        assert!(matches!(body::write(&entry), Err(BodyError::TooLong { .. })), "{field}");
    }
    assert_eq!(LONGEST_BODY, body::LONGEST);
    let Some(shop) = Shop::new() else { return };
    let access = shop.station("a");
    book.checks(2);
    book.add_body(format!("\"{}\"", "a".repeat(LONGEST_BODY)).as_bytes());
    let error = ShopError::TooLong { number: 4, bytes: LONGEST_BODY + 2 };
    assert_eq!(book.send(&access), Err(error));
    assert_eq!(shop.counts(&book), (3, 3), "those before it are sent");
    let other = Book::new("Mill 4");
    other.add_body(format!("\"{}\"", "é".repeat(LONGEST_BODY / 2 - 1)).as_bytes());
    other.add_body(&[b'"', 0xff, b'"']);
    let other_access = shop.station("b");
    assert_eq!(other.send(&other_access), Err(ShopError::NotText { number: 3 }));
    assert_eq!(shop.counts(&other), (2, 2), "the longest one is sent");
    let zero = Book::new("Mill 5");
    zero.add_body(b"\"\0\"");
    assert_eq!(zero.send(&shop.station("c")), Err(ShopError::NotText { number: 2 }));
}

#[test]
fn a_sender_stops_at_once_whatever_it_does() {
    // Nobody answers on this network: it is for documents.
    let book = Book::new("Mill 3");
    let (sender, told) = book.sender("postgres://a:b@192.0.2.250/c?sslrootcert=%2Fnowhere", SHORT);
    told.until("a file that is missing", |status| matches!(status.problem, Some(ShopError::Authorities { .. })));
    let stopped = |sender: Sender| {
        let begun = Instant::now();
        sender.stop();
        // Two seconds are as long as a thread is waited for that does not hear it.
        assert!(begun.elapsed() < Duration::from_secs(2), "{:?}", begun.elapsed());
    };
    stopped(sender);
    let silent = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let address = format!("postgres://a:b@127.0.0.1:{}/c", silent.local_addr().unwrap().port());
    let (sender, told) = book.sender(&address, SHORT);
    told.until("an attempt", |status| status.doing == Doing::Sending);
    let (_stream, _) = silent.accept().unwrap();
    stopped(sender);
}

#[test]
fn a_journal_without_entries_has_nothing_to_send() {
    let Some(shop) = Shop::new() else { return };
    let book = Book::new("Mill 3");
    book.cut(0);
    let sent = book.send(&shop.station("a")).unwrap();
    assert_eq!((sent.entries, sent.head, sent.unsent), (0, Head::default(), 0));
    assert_eq!(book.head().unwrap(), Head::default());
}
