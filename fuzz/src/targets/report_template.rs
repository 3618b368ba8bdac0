//! Any bytes as a template of reports: it is refused with a sentence, or a report of one check by it has a page.

use fitcheck::journal::Record;
use fitcheck::probing::{Measurement, Origin};
use fitcheck::report::Report;
use fitcheck::report::pdf::Pages;
use fitcheck::report::template::Template;
use fitcheck::tolerance::Sources;
use fitcheck::words::{Language, Words};
use jiff::civil::DateTime;
use std::sync::Arc;

use super::shared::told;

pub fn run(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let template = match Template::read(&text) {
        Ok(template) => Arc::new(template),
        Err(error) => return told(bytes, &error),
    };
    let callout = "25 H7".parse().expect("a callout");
    let limits = Sources::default().limits(&callout, None).expect("limits of the standard");
    let measurement = Measurement::of_diameter("25.012".parse().expect("a length"), Origin::Typed);
    let time = DateTime::constant(2026, 11, 21, 10, 42, 7, 0);
    let record = Record::judged(time, "Bore".to_owned(), Some(callout), limits, measurement, None);
    let report = Report::new(time, vec![record]).by(&template);
    let words = Words::new(template.language().unwrap_or_else(Language::default));
    let pages = Pages::of(&report, &words).expect("nothing is read from outside");
    assert!(0 < pages.count(), "a report without a page");
}
