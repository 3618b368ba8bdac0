//! Answers compared with what the file says beside the value. Words and shapes that were met before are not read again.

use fitcheck_core::length::Unit;
use fitcheck_core::message::Say as _;

use super::judged::Judged;
use super::layout::utf8;
use super::tally::{RowNoteKind, Tally};
use crate::exchange::ImportWarningKind;
use crate::exchange::claim::{Claim, ClaimAnswer};
use crate::exchange::columns::Columns;
use crate::exchange::remarks::{Heard, RemarkColumn, may_say};
use crate::exchange::row::TextRow;

/// So many words of a status are remembered.
const MOST_CLAIMS: usize = 15;

/// The column of a cell beside a value, the cell, and what it claims.
type Word = (usize, Vec<u8>, Option<Claim>);

/// What stands beside values, as far as it was met.
#[derive(Debug)]
pub(super) struct Compared<'a> {
    columns: &'a Columns,
    /// Whether something says of all values that they were not measured at 20 °C.
    are_warm: bool,
    /// What words in columns beside the value claim.
    claims: Vec<Word>,
    /// What remarks have said.
    heard: Heard,
}

impl<'a> Compared<'a> {
    pub(super) fn with(columns: &'a Columns) -> Self {
        let are_warm = columns.evidence.warm.as_ref().is_some_and(|warm| !warm.is_of_reference());
        Self { columns, are_warm, claims: Vec::new(), heard: Heard::default() }
    }

    /// Compares an answer with what the file says beside the value.
    #[inline]
    pub(super) fn compare(&mut self, row: &TextRow<'_>, judged: &Judged, tally: &mut Tally) {
        if self.are_warm || !self.columns.beside.is_empty() {
            self.ask(row, judged, tally);
        }
        let columns = self.columns;
        for column in &columns.remarks {
            let cell = row.cell(column.at).unwrap_or(b"");
            if may_say(cell) {
                self.hear(row, (column, cell), judged, tally);
            }
        }
    }

    fn ask(&mut self, row: &TextRow<'_>, judged: &Judged, tally: &mut Tally) {
        let columns = self.columns;
        let mut has_figures = self.are_warm;
        for column in &columns.beside {
            if !column.has_words() {
                has_figures = true;
                continue;
            }
            let cell = row.cell(column.at()).unwrap_or(b"");
            let claim = self.claim(column.at(), cell, |text| column.claim(text, Unit::Millimetre));
            let said = said_against(claim, judged);
            self.tell(row, said, tally);
        }
        if has_figures {
            for claim in columns.figures(&row.record()) {
                told(claim.tells(&answer(judged)), tally);
            }
        }
    }

    /// Compares an answer with a remark, unless another one like it has said nothing.
    fn hear(&mut self, row: &TextRow<'_>, (column, cell): (&RemarkColumn, &[u8]), judged: &Judged, tally: &mut Tally) {
        if !self.heard.says_nothing(column, unquoted(&utf8(cell))) {
            let claim = self.claim(column.at, cell, |text| column.claim(text, true));
            let said = said_against(claim, judged);
            self.tell(row, said, tally);
        }
    }

    /// What a cell of a column claims, which is read once where its words come again.
    fn claim(&mut self, at: usize, cell: &[u8], read: impl FnOnce(&str) -> Option<Claim>) -> Option<&Claim> {
        let known = self.claims.iter().position(|(of, word, _)| *of == at && word == cell);
        let place = known.unwrap_or_else(|| {
            // A column with ever new words claims nothing that is known here.
            self.claims.truncate(MOST_CLAIMS);
            self.claims.push((at, cell.to_vec(), read(unquoted(&utf8(cell)))));
            self.claims.len() - 1
        });
        self.claims.get(place).and_then(|(.., claim)| claim.as_ref())
    }

    /// Counts what a cell says against an answer; a temperature only where the value was not brought to 20 °C already.
    fn tell(&self, row: &TextRow<'_>, said: Option<(bool, ImportWarningKind)>, tally: &mut Tally) {
        if let Some((is_of_temperature, warning)) = said
            && (!is_of_temperature || self.columns.asks_temperature(&row.record()))
        {
            told(Some(warning), tally);
        }
    }
}

fn answer(judged: &Judged) -> ClaimAnswer {
    ClaimAnswer { bounds: judged.bounds, measured: judged.measured, status: judged.status }
}

/// What a claim says against an answer, and whether that is a temperature.
fn said_against(claim: Option<&Claim>, judged: &Judged) -> Option<(bool, ImportWarningKind)> {
    let claim = claim?;
    Some((claim.is_of_temperature(), claim.tells(&answer(judged))?))
}

fn unquoted(cell: &str) -> &str {
    cell.trim().trim_matches('"')
}

/// Counts what a file says against an answer.
pub(super) fn told(warning: Option<ImportWarningKind>, tally: &mut Tally) {
    let Some(warning) = warning else { return };
    tally.against += 1;
    let kind = match warning {
        ImportWarningKind::StatusDiffers { .. } => RowNoteKind::StatusDiffers,
        ImportWarningKind::StatusUnknown { .. } => RowNoteKind::StatusUnknown,
        _ => RowNoteKind::ClaimDiffers,
    };
    tally.note(kind, None, || warning.message());
}
