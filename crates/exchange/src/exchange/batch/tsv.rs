//! Rows as spreadsheets take them, separated by tabs: every row has as many cells, and no cell needs quotation marks.

use fitcheck_core::length::Line;

use super::ADDED;
use super::judge::Take;
use super::judged::Judged;
use super::layout::Layout;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::row::{TextRow, unquoted};
use fitcheck_core::text::Within as _;

/// Writes TSV.
#[derive(Debug)]
pub struct Tsv {
    /// How many columns the input has.
    count: usize,
    /// What was written.
    pub out: Line,
}

impl Tsv {
    /// Nothing written yet.
    pub fn new(layout: &Layout) -> Self {
        Self { count: layout.names.len(), out: Line::default() }
    }

    /// The names of all columns, those of the added ones behind `prefix`. What else is above the rows is not written.
    pub fn header(layout: &Layout, prefix: &str) -> Vec<u8> {
        let mut header = Self::new(layout);
        for (at, name) in layout.names.iter().enumerate() {
            header.next(at);
            header.text(name);
        }
        for name in ADDED {
            header.out.push(b'\t');
            header.text(&format!("{prefix}{name}"));
        }
        header.out.push(b'\n');
        header.out.bytes().to_vec()
    }

    /// What stands before a cell.
    fn next(&mut self, at: usize) {
        if 0 < at {
            self.out.push(b'\t');
        }
    }

    /// A cell: a space for each tab and line break in it.
    fn text(&mut self, text: &str) {
        self.bytes(text.as_bytes());
    }

    fn bytes(&mut self, text: &[u8]) {
        let mut rest = text;
        while let Some(at) = memchr::memchr3(b'\t', b'\n', b'\r', rest) {
            self.out.append(rest.within(..at));
            self.out.push(b' ');
            let after = rest.within(at..);
            rest = after.strip_prefix(b"\r\n").unwrap_or_else(|| after.within(1..));
        }
        self.out.append(rest);
    }

    /// The cells of a row, as many as there are columns.
    fn cells(&mut self, row: &TextRow<'_>) {
        for at in 0..self.count {
            self.next(at);
            match row.cell(at).unwrap_or(b"") {
                quoted @ [b'"', ..] => self.text(&unquoted(quoted)),
                plain => self.bytes(plain),
            }
        }
    }

    /// What is added to a row without a verdict.
    fn reason(&mut self, reason: &str) {
        for _ in ADDED {
            self.out.push(b'\t');
        }
        self.text(reason);
        self.out.push(b'\n');
    }
}

impl Take for Tsv {
    fn judged(&mut self, row: &TextRow<'_>, judged: &Judged) {
        self.cells(row);
        self.out.pieces(|out| {
            judged.put_figures(b'\t', out);
            out.push(b'\t');
        });
        self.out.append(judged.status.word().as_bytes());
        self.out.pieces(|out| {
            out.push(b'\t');
            if let Some(removal) = judged.verdict().removal {
                removal.to_limit.put_um(0, out);
            }
            out.push(b'\t');
            out.push(b'\n');
        });
    }

    fn refused(&mut self, row: &TextRow<'_>, reason: &str) {
        self.cells(row);
        self.reason(&super::with_cells_beyond(row, self.count, reason));
    }

    fn broken(&mut self, line: &str, reason: &ImportErrorKind) {
        self.text(line);
        for at in 1..self.count {
            self.next(at);
        }
        self.reason(&reason.to_string());
    }

    /// A comment or an empty line is no row; the tally counts it.
    fn line(&mut self, _line: &[u8]) {}
}
