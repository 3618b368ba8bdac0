//! A page back to measurements: from the JSON blocks, never from the table.

use super::error::{PointFault, PointLogError};
use super::point::PointLog;
use super::stored::{CLOSE, COUNT, OPEN, parse};
use crate::control::text;

/// Reads every measurement of a page, each with its line: one result per measurement, so that a broken one does not
/// affect the others. A page with fewer or more measurements than it announces gives one more result, an error.
///
/// ```
/// use fitcheck::control::point_log::{PointFault, read};
///
/// let answers = read(b"<html></html>");
/// let error = answers.first().and_then(|answer| answer.as_ref().err());
/// assert_eq!(error.map(|error| &error.what), Some(&PointFault::NoLog));
/// ```
pub fn read(bytes: &[u8]) -> Vec<Result<(usize, PointLog), PointLogError>> {
    let page = text::decode(bytes);
    let mut answers = Vec::new();
    let mut line = 1;
    let mut parts = page.split(OPEN);
    let head = parts.next().unwrap_or_default();
    line += newlines(head);
    for part in parts {
        answers.push(match part.split_once(CLOSE) {
            Some((json, _)) => parse(json).map(|log| (line, log)).map_err(|fault| fault.at(line)),
            None => Err(PointFault::CutOff.at(line)),
        });
        line += newlines(part);
    }
    let found = answers.len();
    match expected(head) {
        Some(expected) if expected != found => answers.push(Err(PointFault::Count { expected, found }.at(line))),
        None if found == 0 => answers.push(Err(PointFault::NoLog.at(1))),
        _ => {}
    }
    answers
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
