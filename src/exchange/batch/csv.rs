//! CSV as it came, with six columns added: every line stays as it is, and the answer stands behind it.

use super::judge::{Judged, Take};
use super::layout::Layout;
use super::row::Row;
use super::{ADDED, index};
use crate::exchange::error::ImportErrorKind;
use crate::length::Unit;

/// Writes CSV.
#[derive(Debug)]
pub struct Csv {
    separator: u8,
    /// How many columns the input has.
    count: usize,
    line_end: &'static [u8],
    /// What was written.
    pub out: Vec<u8>,
}

impl Csv {
    /// Nothing written yet.
    pub const fn new(layout: &Layout) -> Self {
        let Layout { separator, line_end, .. } = *layout;
        Self { separator, count: layout.columns.count, line_end, out: Vec::new() }
    }

    /// Everything above the first row, with the names of the added columns, each behind `prefix`. An input without names
    /// gets none.
    pub fn header(layout: &Layout, prefix: &str) -> Vec<u8> {
        let mut out = layout.above.clone();
        if !layout.has_header {
            return out;
        }
        let end = out.len() - out.iter().rev().take_while(|byte| matches!(byte, b'\n' | b'\r')).count();
        out.truncate(end);
        let mut header = Self { out, ..Self::new(layout) };
        for name in ADDED {
            header.out.push(layout.separator);
            header.text(&format!("{prefix}{name}"));
        }
        header.out.extend_from_slice(layout.line_end);
        header.out
    }

    /// A cell with quotation marks where it needs some.
    fn text(&mut self, text: &str) {
        let separator = self.separator;
        if text.bytes().all(|byte| byte != separator && !matches!(byte, b'"' | b'\n' | b'\r')) {
            self.out.extend_from_slice(text.as_bytes());
        } else {
            self.out.push(b'"');
            self.out.extend_from_slice(text.replace('"', "\"\"").as_bytes());
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
    fn cells(&mut self, row: &Row<'_>) {
        if row.len() == self.count {
            self.out.extend_from_slice(row.bytes());
        } else {
            self.out.extend_from_slice(row.first_cells(self.count.min(row.len())));
            self.separators(self.count.saturating_sub(row.len()));
        }
    }

    #[inline]
    fn end(&mut self, row: &Row<'_>) {
        match row.line_end() {
            b"\n" => self.out.push(b'\n'),
            b"" => self.out.extend_from_slice(self.line_end),
            end => self.out.extend_from_slice(end),
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
    fn judged(&mut self, row: &Row<'_>, judged: &Judged) {
        self.cells(row);
        let (out, separator) = (&mut self.out, self.separator);
        out.push(separator);
        judged.bounds.minimum().put_exact(Unit::Millimetre, 3, out);
        out.push(separator);
        judged.bounds.maximum().put_exact(Unit::Millimetre, 3, out);
        out.push(separator);
        judged.verdict.deviation.put_exact(Unit::Micrometre, 0, out);
        out.push(separator);
        out.extend_from_slice(judged.verdict.status.word().as_bytes());
        out.push(separator);
        if let Some(removal) = judged.verdict.removal {
            removal.to_limit.put_exact(Unit::Micrometre, 0, out);
        }
        out.push(separator);
        self.end(row);
    }

    fn refused(&mut self, row: &Row<'_>, reason: &str) {
        self.cells(row);
        self.reason(&super::with_cells_beyond(row, self.count, reason));
        self.end(row);
    }

    fn broken(&mut self, line: &str, reason: &ImportErrorKind) {
        // One cell, so that its quotation marks open nothing.
        self.out.push(b'"');
        self.out.extend_from_slice(line.replace('"', "\"\"").as_bytes());
        self.out.push(b'"');
        self.separators(self.count.saturating_sub(1));
        self.reason(&reason.to_string());
        self.out.extend_from_slice(self.line_end);
    }

    fn line(&mut self, line: &[u8]) {
        self.out.extend_from_slice(line);
        if index::line_end(line, line.len().saturating_sub(1)) == 0 {
            self.out.extend_from_slice(self.line_end);
        }
    }
}
