//! Any bytes as a page of points: a measurement that is read can be written, and reads back as the same; a page with
//! one more keeps those that it has.

use fitcheck::control::point_log::{PointLog, append, read, write};
use fitcheck::exchange::import;
use fitcheck::tolerance::Sources;
use fitcheck::words::Dialogue;

use super::shared::{NOW, told};

pub fn run(bytes: &[u8]) {
    let answers = read(bytes);
    answers.iter().filter_map(|answer| answer.as_ref().err()).for_each(|error| told(bytes, error));
    let logs: Vec<PointLog> = answers.iter().flatten().map(|(_, log)| log.clone()).collect();
    let imported = import("a.html", bytes, &Sources::default(), NOW);
    assert_eq!(imported.rows, imported.records.len() + imported.unjudged.len() + imported.errors.len());
    if logs.is_empty() {
        return;
    }
    let language = Dialogue::ALL[bytes.len() % Dialogue::ALL.len()];
    let page = write(&logs, language).expect("a measurement that was read agrees with itself");
    assert_eq!(on_page(&page), logs);
    assert_eq!(write(&on_page(&page), language).as_ref(), Ok(&page));
    let more = append(&page, &logs[0], language).expect("a page of Fitcheck's own");
    assert_eq!(on_page(&more), [logs.as_slice(), &logs[..1]].concat());
}

fn on_page(page: &[u8]) -> Vec<PointLog> {
    read(page).into_iter().map(|answer| answer.expect("written by Fitcheck").1).collect()
}
