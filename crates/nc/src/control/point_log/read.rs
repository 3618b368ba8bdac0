//! A page back to measurements: from the JSON blocks, never from the table.

use fitcheck_core::text;

use super::error::{PointFault, PointLogError};
use super::point::PointLog;
use super::stored::{CLOSE, COUNT, OPEN, parse};

/// Reads every measurement of a page, each with its line: one result per measurement, so that a broken one does not
/// affect the others. A page with fewer or more measurements than it announces gives one more result, an error.
///
/// ```
/// use fitcheck_nc::control::point_log::{PointFault, read};
///
/// let answers = read(b"<html></html>");
/// let error = answers.first().and_then(|answer| answer.as_ref().err());
/// assert_eq!(error.map(|error| &error.what), Some(&PointFault::NoLog));
/// ```
pub fn read(bytes: &[u8]) -> Vec<Result<(usize, PointLog), PointLogError>> {
    each(&text::decode(bytes)).collect()
}

/// The same for a text, one measurement after the other: memory stays the same however many there are.
pub fn each(page: &str) -> impl Iterator<Item = Result<(usize, PointLog), PointLogError>> {
    let head = page.split_once(OPEN).map_or(page, |(head, _)| head);
    let mut parts = page.split(OPEN).skip(1);
    let mut line = 1 + newlines(head);
    let mut found = 0;
    let mut is_over = false;
    std::iter::from_fn(move || {
        if let Some(part) = parts.next() {
            let answer = match part.split_once(CLOSE) {
                Some((json, _)) => parse(json).map(|log| (line, log)).map_err(|fault| fault.at(line)),
                None => Err(PointFault::CutOff.at(line)),
            };
            line += newlines(part);
            found += 1;
            return Some(answer);
        }
        if std::mem::replace(&mut is_over, true) {
            return None;
        }
        match expected(head) {
            Some(expected) if expected != found => Some(Err(PointFault::Count { expected, found }.at(line))),
            None if found == 0 => Some(Err(PointFault::NoLog.at(1))),
            _ => None,
        }
    })
}

/// Whether a text looks like such a page.
pub fn is_log(text: &str) -> bool {
    text.contains(OPEN) || expected(text).is_some()
}

fn newlines(text: &str) -> usize {
    text.bytes().filter(|&byte| byte == b'\n').count()
}

/// How many measurements the page announces.
fn expected(head: &str) -> Option<usize> {
    let (_, rest) = head.split_once(&format!(r#"<meta name="{COUNT}" content=""#))?;
    rest.split_once('"')?.0.parse().ok()
}
