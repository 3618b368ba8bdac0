//! Answers compared with what the file says beside the value. Words and shapes that were met before are not read again.

use std::collections::VecDeque;

use super::judge::Judged;
use super::layout::utf8;
use super::row::Row;
use super::tally::{Kind, Tally};
use crate::exchange::ImportWarningKind;
use crate::exchange::claim::{Answer, Claim};
use crate::exchange::columns::Columns;
use crate::exchange::remarks::{RemarkColumn, may_say, says_nothing, shape};
use crate::length::Unit;
use crate::message::Say as _;

/// So many words of a status are remembered.
const MOST_CLAIMS: usize = 15;

/// So many shapes of remarks are remembered.
const MOST_SHAPES: usize = 64;

/// A cell beside a value, the number of its column among these, and what it claims.
type Word = (usize, Vec<u8>, Option<Claim>);

/// What stands beside values, as far as it was met.
#[derive(Debug)]
pub(super) struct Compared<'a> {
    columns: &'a Columns,
    /// Whether something says of all values that they were not measured at 20 °C.
    are_warm: bool,
    /// What words in columns beside the value claim.
    claims: Vec<Word>,
    /// Shapes of remarks that say nothing, with their columns.
    shapes: VecDeque<(usize, Vec<u8>)>,
    shape: Vec<u8>,
}

impl<'a> Compared<'a> {
    pub(super) fn with(columns: &'a Columns) -> Self {
        let are_warm = columns.evidence.warm.as_ref().is_some_and(|warm| !warm.is_of_reference());
        Self { columns, are_warm, claims: Vec::new(), shapes: VecDeque::new(), shape: Vec::new() }
    }

    /// Compares an answer with what the file says beside the value.
    #[inline]
    pub(super) fn compare(&mut self, row: &Row<'_>, judged: &Judged, tally: &mut Tally) {
        if self.are_warm || !self.columns.beside.is_empty() {
            self.ask(row, judged, tally);
        }
        for column in &self.columns.remarks {
            let cell = row.cell(column.at).unwrap_or_default();
            if may_say(cell) {
                self.hear(row, (column, cell), judged, tally);
            }
        }
    }

    fn ask(&mut self, row: &Row<'_>, judged: &Judged, tally: &mut Tally) {
        let answer = answer(judged);
        let mut has_figures = self.are_warm;
        for (number, column) in self.columns.beside.iter().enumerate() {
            if !column.has_words() {
                has_figures = true;
                continue;
            }
            let cell = row.cell(column.at()).unwrap_or_default();
            let known = self.claims.iter().position(|(of, word, _)| *of == number && word == cell);
            let at = known.unwrap_or_else(|| {
                // A column with ever new words claims nothing that is known here.
                self.claims.truncate(MOST_CLAIMS);
                let claim = column.claim(utf8(cell).trim().trim_matches('"'), Unit::Millimetre);
                self.claims.push((number, cell.to_vec(), claim));
                self.claims.len() - 1
            });
            let claim = self.claims.get(at).and_then(|(.., claim)| claim.as_ref());
            told(claim.and_then(|claim| claim.tells(&answer)), tally);
        }
        if has_figures {
            for claim in self.columns.figures(&row.record()) {
                told(claim.tells(&answer), tally);
            }
        }
    }

    /// Compares an answer with a remark, unless another one like it has said nothing.
    fn hear(&mut self, row: &Row<'_>, (column, cell): (&RemarkColumn, &[u8]), judged: &Judged, tally: &mut Tally) {
        shape(cell, &mut self.shape);
        if self.shapes.iter().any(|(of, known)| *of == column.at && *known == self.shape) {
            return;
        }
        if says_nothing(column, unquoted(&utf8(&self.shape))) {
            if self.shapes.len() == MOST_SHAPES {
                self.shapes.pop_front();
            }
            return self.shapes.push_back((column.at, self.shape.clone()));
        }
        let asks = self.columns.asks_temperature(&row.record());
        let claim = column.claim(unquoted(&utf8(cell)), asks);
        told(claim.and_then(|claim| claim.tells(&answer(judged))), tally);
    }
}

fn answer(judged: &Judged) -> Answer {
    Answer { bounds: judged.bounds, measured: judged.measured, status: judged.status }
}

fn unquoted(cell: &str) -> &str {
    cell.trim().trim_matches('"')
}

/// Counts what a file says against an answer.
pub(super) fn told(warning: Option<ImportWarningKind>, tally: &mut Tally) {
    let Some(warning) = warning else { return };
    tally.against += 1;
    let kind = match warning {
        ImportWarningKind::StatusDiffers { .. } => Kind::StatusDiffers,
        ImportWarningKind::StatusUnknown { .. } => Kind::StatusUnknown,
        _ => Kind::ClaimDiffers,
    };
    tally.note(kind, None, || warning.message());
}
