//! The network between a station and the server is cut anywhere, falls silent and comes back: each entry arrives once.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use fitcheck::store::shop::{Doing, Patience, ShopError, verify};

use crate::harness::{Book, SHORT, Shop};
use crate::relay::{Relay, port};

#[test]
fn a_network_that_is_cut_after_any_number_of_bytes_loses_and_doubles_nothing() {
    let Some(shop) = Shop::new() else { return };
    let relay = Relay::to(port(&shop.address));
    let book = Book::new("Mill 3");
    let address = relay.address(&shop.login("a", "fitcheck_station"));
    let (sender, told) = book.sender(&address, Patience { longest_pause: Duration::from_millis(20), ..SHORT });
    let mut seed = u64::from(std::process::id()) << 20 | 1;
    println!("seed {seed}");
    let begun = Instant::now();
    // Sixty times where the machine is fast enough, and twenty on any.
    while relay.cuts() < 21 || relay.cuts() < 60 && begun.elapsed() < Duration::from_mins(1) {
        // A batch of 100 has about 130 kB; a connection without entries about 3 kB.
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        book.checks(100);
        relay.cut_after(i64::try_from(seed % 400_000).unwrap());
        sender.wake();
        let wanted = relay.cuts() + 1;
        let waiting = Instant::now();
        while relay.cuts() < wanted && waiting.elapsed() < Duration::from_millis(300) {
            std::thread::sleep(Duration::from_millis(2));
        }
    }
    let cuts = relay.cuts();
    relay.mend();
    sender.try_again();
    told.all(&book);
    assert_eq!(shop.counts(&book), (book.length(), book.length()));
    let heads = [(book.chain, book.last())];
    assert!(verify(&shop.admin(), &heads, SHORT, &mut |_, _| ControlFlow::Continue(())).unwrap().is_whole());
    assert!(20 < cuts, "only {cuts}");
    let problems = told.0.lock().unwrap().iter().filter(|status| status.problem.is_some()).count();
    assert!(0 < problems);
    println!("{cuts} cuts of the network: {} entries, each once, 0 lost", book.length());
}

#[test]
fn a_network_that_falls_silent_is_given_up_and_tried_again() {
    let Some(shop) = Shop::new() else { return };
    let relay = Relay::to(port(&shop.address));
    let book = Book::new("Mill 3");
    let address = relay.address(&shop.login("a", "fitcheck_station"));
    let patience = Patience { connecting: Duration::from_secs(1), answer: Duration::from_millis(1_500), ..SHORT };
    let (sender, told) = book.sender(&address, patience);
    told.all(&book);
    relay.fall_silent();
    book.checks(700);
    sender.wake();
    let is_lost = |problem: &ShopError| matches!(problem, ShopError::Lost { .. } | ShopError::Unreachable { .. });
    let status = told.until("that it is given up", |status| status.problem.as_ref().is_some_and(is_lost));
    assert_eq!((status.doing, status.unsent), (Doing::Waiting, Some(700)));
    relay.mend();
    told.all(&book);
    // Silent in the midst of sending, again and again.
    for round in 0..5 {
        book.checks(2_000);
        sender.wake();
        std::thread::sleep(Duration::from_millis(7 * round));
        relay.fall_silent();
        std::thread::sleep(Duration::from_millis(1_800));
        relay.mend();
        told.all(&book);
    }
    assert_eq!(shop.counts(&book), (10_701, 10_701));
    println!("6 silences of the network: {} entries, each once", book.length());
}
