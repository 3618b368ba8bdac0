//! CSV as it came, with six columns added: every line stays as it is, and the answer stands behind it.

use fitcheck_core::length::Line;
use fitcheck_core::message::guarded;
use fitcheck_core::verdict::Status;

use super::ADDED;
use super::judge::Take;
use super::judged::Judged;
use super::layout::Layout;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::index::line_end;
use crate::exchange::row::TextRow;
use fitcheck_core::text::Within as _;

/// Room for the longest word of a status between two separators.
const LONGEST_STATUS: usize = 16;

/// Writes CSV.
#[derive(Debug)]
pub struct Csv {
    separator: u8,
    /// How many columns the input has.
    count: usize,
    line_end: &'static [u8],
    /// The word of each status between two separators, and how long that is.
    statuses: [([u8; LONGEST_STATUS], u8); Status::ALL.len()],
    /// What was written.
    pub out: Line,
}

impl Csv {
    /// Nothing written yet.
    pub fn new(layout: &Layout) -> Self {
        let Layout { separator, line_end, .. } = *layout;
        let statuses = Status::ALL.map(|status| {
            let text = [&[separator], status.word().as_bytes(), &[separator]].concat();
            let [count, ..] = text.len().min(LONGEST_STATUS).to_le_bytes();
            let mut word = [separator; LONGEST_STATUS];
            word.iter_mut().zip(&text).for_each(|(place, byte)| *place = *byte);
            (word, count)
        });
        Self { separator, count: layout.columns.count, line_end, statuses, out: Line::default() }
    }

    /// Everything above the first row, with the names of the added columns, each behind `prefix`. An input without names
    /// gets none.
    pub fn header(layout: &Layout, prefix: &str) -> Vec<u8> {
        if !layout.has_header {
            return layout.above.clone();
        }
        let above = layout.above.as_slice();
        let end = above.len() - above.iter().rev().take_while(|byte| matches!(byte, b'\n' | b'\r')).count();
        let mut header = Self::new(layout);
        header.out.append_part(above, 0, end);
        for name in ADDED {
            header.out.push(layout.separator);
            header.text(&format!("{prefix}{name}"));
        }
        header.out.append(layout.line_end);
        header.out.bytes().to_vec()
    }

    /// The comments above the first row of an input that is not the first one, whose header stands there already.
    pub fn comments(layout: &Layout) -> &[u8] {
        layout.above.within(layout.comments.clone())
    }

    /// A cell with quotation marks where it needs some.
    fn text(&mut self, text: &str) {
        let separator = self.separator;
        // It may repeat what a cell has.
        let text = &*guarded(text);
        if text.bytes().all(|byte| byte != separator && !matches!(byte, b'"' | b'\n' | b'\r')) {
            self.out.append(text.as_bytes());
        } else {
            self.out.push(b'"');
            self.out.append(text.replace('"', "\"\"").as_bytes());
            self.out.push(b'"');
        }
    }

    fn separators(&mut self, count: usize) {
        for _ in 0..count {
            self.out.push(self.separator);
        }
    }

    /// The cells of a row, as many as there are columns.
    #[inline]
    fn cells(&mut self, row: &TextRow<'_>) {
        if row.len() == self.count {
            self.out.append_part(row.text, row.start, row.end);
        } else {
            self.out.append(row.first_cells(self.count.min(row.len())));
            self.separators(self.count.saturating_sub(row.len()));
        }
    }

    fn end(&mut self, row: &TextRow<'_>) {
        match row.line_end() {
            b"" => self.out.append(self.line_end),
            end => self.out.append(end),
        }
    }

    /// What is added to a row without a verdict.
    fn reason(&mut self, reason: &str) {
        self.separators(ADDED.len());
        self.text(reason);
    }
}

impl Take for Csv {
    #[inline]
    fn judged(&mut self, row: &TextRow<'_>, judged: &Judged) {
        self.cells(row);
        let separator = self.separator;
        // Every status has a word.
        let (word, count) = self.statuses.get(judged.status.at()).copied().unwrap_or_default();
        let is_lf = row.text.get(row.end) == Some(&b'\n');
        self.out.pieces(|out| {
            judged.put_figures(separator, out);
            out.piece(word, count);
            if let Some(removal) = judged.verdict().removal {
                removal.to_limit.put_um(0, out);
            }
            // Most lines end so.
            out.piece([separator, b'\n'], if is_lf { 2 } else { 1 });
        });
        if !is_lf {
            self.end(row);
        }
    }

    fn refused(&mut self, row: &TextRow<'_>, reason: &str) {
        self.cells(row);
        self.reason(&super::with_cells_beyond(row, self.count, reason));
        self.end(row);
    }

    fn broken(&mut self, line: &str, reason: &ImportErrorKind) {
        // One cell, so that its quotation marks open nothing.
        self.out.push(b'"');
        self.out.append(line.replace('"', "\"\"").as_bytes());
        self.out.push(b'"');
        self.separators(self.count.saturating_sub(1));
        self.reason(&reason.to_string());
        self.out.append(self.line_end);
    }

    fn line(&mut self, line: &[u8]) {
        self.out.append(line);
        if line_end(line, line.len().saturating_sub(1)) == 0 {
            self.out.append(self.line_end);
        }
    }
}
