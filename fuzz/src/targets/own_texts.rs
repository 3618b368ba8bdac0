//! Any bytes as a file of own texts: what counts is said, and the words of verdicts stay different from each other.

use std::sync::Arc;

use fitcheck::message::OwnTexts;
use fitcheck::verdict::Status;
use fitcheck::words::{Language, Words};

use super::shared::told;

pub fn run(bytes: &[u8]) {
    let own = match OwnTexts::read("nl_fuzz.ftl", bytes) {
        Ok(own) => own,
        Err(error) => return told(bytes, &error),
    };
    assert!(own.refused().len() <= own.refused_count());
    for refused in own.refused() {
        told(bytes, refused);
        assert!(refused.place.line.is_some() && refused.place.column.is_some());
    }
    let words = Words::new(Language::Nl).with_own(Some(Arc::new(own)));
    let said = Status::ALL.map(|status| words.told(&status));
    for (number, word) in said.iter().enumerate() {
        assert!(!word.trim().is_empty() && !said[..number].contains(word), "{said:?}");
    }
}
