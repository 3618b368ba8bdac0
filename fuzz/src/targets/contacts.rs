//! Any bytes as CSV of contacts: what is read reads back from a plain CSV, an import reads the same, and a few contacts
//! are evaluated.

use std::fmt::Write as _;

use fitcheck::exchange::{self, contacts};
use fitcheck::tolerance::Sources;

use super::circle;
use super::shared::{NOW, told};

pub fn run(bytes: &[u8]) {
    let read = match contacts::read(bytes) {
        Ok(read) => read,
        Err(error) => return told(bytes, &error),
    };
    assert!(!read.contacts.is_empty());
    let mut plain = String::from("x;y;z\n");
    for at in &read.contacts {
        assert!(at.place().iter().all(|number| number.is_finite()));
        writeln!(plain, "{};{};{}", at.x, at.y, at.z).expect("a text takes everything");
    }
    let again = contacts::read(plain.as_bytes()).expect("a plain CSV");
    assert_eq!((again.contacts, again.ignored), (read.contacts.clone(), Vec::new()));
    let imported = exchange::import("a.csv", bytes, &Sources::default(), NOW);
    assert!(imported.contacts.is_none_or(|contacts| contacts == read.contacts));
    if read.contacts.len() <= 9 {
        circle::check(bytes, &read.contacts);
    }
}
