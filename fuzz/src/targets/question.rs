//! Any text as a question to a journal: it prints and reads back as the same, or the error points into the text.

use fitcheck::journal::ask::{LocalNow, Question};
use jiff::Timestamp;
use jiff::tz::{Offset, TimeZone};

use super::shared::told;

pub fn run(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let now = Timestamp::from_second(1_795_435_200).expect("a time");
    let here = LocalNow { now, zone: TimeZone::fixed(Offset::constant(-8)) };
    match Question::read(text, &here) {
        Ok(question) => assert_eq!(Question::read(&question.text(&here), &here), Ok(question)),
        Err(error) => {
            assert!(error.span.start <= error.span.end && error.span.end <= text.chars().count(), "{:?}", error.span);
            told(bytes, &error);
        }
    }
}
