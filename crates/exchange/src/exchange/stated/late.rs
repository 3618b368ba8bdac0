//! Lines that are no rows and state another unit than the one that rows are read by.

use csv::StringRecord;

use super::mention::{Mention, mentions, split};
use super::{joined, sign, squeezed};
use crate::exchange::cells;
use crate::exchange::columns::Columns;
use crate::exchange::delimited::lines;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use crate::exchange::pieces::Pieces;
use fitcheck_core::text::Within as _;

fn has_figure(cells: &StringRecord) -> bool {
    cells.iter().any(|cell| cell.contains(|c: char| c.is_ascii_digit()))
}

pub(super) fn late(columns: &Columns, line: Option<usize>, unit: &str, text: &str) -> ImportErrorKind {
    let read = columns.stated.decided(columns.measured).map_or("-", sign);
    let unit = shorten(unit);
    let text = shorten(text);
    match line {
        Some(line) => ImportErrorKind::UnitLate { line, unit, text, read },
        None => ImportErrorKind::UnitStray { unit, text, read },
    }
}

/// Why a line that is no row contradicts the units that rows are read by; whoever tells it says where it stands.
pub(in crate::exchange) fn stray(columns: &Columns, cells: &StringRecord) -> Option<ImportErrorKind> {
    let may_be = cells::is_comment(cells) || !has_figure(cells) && columns.stated.columns.is_empty();
    may_be.then(|| stray_of(columns, None, || cells.iter(), || joined(cells))).flatten()
}

/// The same of a row of a sheet, which may be one with values.
pub(in crate::exchange) fn stray_row(columns: &Columns, line: usize, cells: &StringRecord) -> Option<ImportErrorKind> {
    let says_its_own = !columns.stated.columns.is_empty();
    let may_be = columns.stated.first < line && (cells::is_comment(cells) || !says_its_own && !has_figure(cells));
    may_be.then(|| stray_of(columns, Some(line), || cells.iter(), || joined(cells))).flatten()
}

fn stray_of<'c, C: Iterator<Item = &'c str>>(
    columns: &Columns,
    line: Option<usize>,
    cells: impl Fn() -> C,
    text: impl Fn() -> String,
) -> Option<ImportErrorKind> {
    let stated = &columns.stated;
    let mentions = mentions(cells());
    if mentions.is_empty() || stated.row.as_ref().is_some_and(|(row, _)| Some(*row) == line) {
        return None;
    }
    if stated.header == squeezed(cells()) {
        return None;
    }
    let decided = stated.decided(columns.measured);
    for (unit, is_clear) in mentions {
        match unit {
            Ok(unit) if decided == Some(unit) => {}
            Ok(unit) if is_clear || !stated.is_given => return Some(late(columns, line, sign(unit), &text())),
            Err(unknown) if !stated.is_given => return Some(late(columns, line, &unknown, &text())),
            Ok(_) | Err(_) => {}
        }
    }
    None
}

/// The most different statements that are kept: long before, two of them contradict each other.
const MOST_SAID: usize = 1_000;

type Line = (usize, String);

/// The lines of a text that may state a unit and are no rows: comments, and those without any figure.
pub(in crate::exchange) fn unit_lines(pieces: &mut Pieces<'_>) -> Vec<Line> {
    // Of lines that say the same, the first one and the last one tell all. What cannot be read is told where rows are.
    let mut found: Vec<(Vec<Mention>, [Line; 2])> = Vec::new();
    let mut next = 1;
    while let Ok(Some(piece)) = pieces.next() {
        let mut last = next;
        for (line, from, to) in lines(&piece, 0, next) {
            last = line + 1;
            let text = piece.within(from..to);
            let may_be = || !text.bytes().any(|byte| byte.is_ascii_digit());
            let is_comment = text.trim_start_matches([' ', '\t', '"']).starts_with('#');
            if !is_comment && !may_be() {
                continue;
            }
            let said = mentions(split(text));
            let this = || (line, text.trim().to_owned());
            let has_room = found.len() < MOST_SAID;
            match found.iter_mut().find(|(before, _)| *before == said) {
                _ if said.is_empty() => {}
                Some((_, [_, last])) => *last = this(),
                None if has_room => found.push((said, [this(), this()])),
                None => {}
            }
        }
        next = last;
    }
    found.into_iter().flat_map(|(_, lines)| lines).collect()
}

/// Refuses a file with a line behind its first row that states another unit.
pub(in crate::exchange) fn agree(columns: &Columns, lines: &[Line]) -> Result<(), ImportErrorKind> {
    // Where each row states its unit, only comments are about others.
    let is_about_rows = |text: &str| columns.stated.columns.is_empty() || text.starts_with('#');
    let behind = lines.iter().filter(|(line, text)| columns.stated.first < *line && is_about_rows(text));
    let mut reasons =
        behind.filter_map(|(line, text)| stray_of(columns, Some(*line), || split(text), || shorten(text)));
    reasons.next().map_or(Ok(()), Err)
}
