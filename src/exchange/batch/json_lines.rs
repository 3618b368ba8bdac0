//! Rows as JSON, an object a line: the columns of the input as texts, those that are added as numbers and texts.

use super::judge::{Judged, Take};
use super::layout::Layout;
use super::row::{Row, unquoted};
use crate::length::Unit;

/// Writes JSON lines.
#[derive(Debug)]
pub struct JsonLines {
    /// What was written.
    pub out: Vec<u8>,
    /// The name of each column with what stands before and after it.
    names: Vec<Vec<u8>>,
}

impl JsonLines {
    /// Nothing written yet.
    pub fn new(layout: &Layout) -> Self {
        let name = |(at, name): (usize, &String)| {
            let mut out = if at == 0 { b"{".to_vec() } else { b",".to_vec() };
            text(name, &mut out);
            out.push(b':');
            out
        };
        Self { out: Vec::new(), names: layout.names.iter().enumerate().map(name).collect() }
    }

    fn cells(&mut self, row: &Row<'_>) {
        for (at, name) in self.names.iter().enumerate() {
            self.out.extend_from_slice(name);
            match row.cell(at) {
                Some(cell) => text(&unquoted(cell), &mut self.out),
                None => self.out.extend_from_slice(b"null"),
            }
        }
        self.out.push(b',');
    }

    fn reason(&mut self, reason: Option<&str>) {
        let nothing = "\"min_mm\":null,\"max_mm\":null,\"deviation_um\":null,\"status\":null,\"remove_um\":null";
        self.out.extend_from_slice(nothing.as_bytes());
        self.out.extend_from_slice(b",\"error\":");
        match reason {
            Some(reason) => text(reason, &mut self.out),
            None => self.out.extend_from_slice(b"null"),
        }
        self.out.extend_from_slice(b"}\n");
    }
}

/// A text in quotation marks. Writing to memory does not fail.
fn text(text: &str, out: &mut Vec<u8>) {
    let _written = serde_json::to_writer(out, text);
}

impl Take for JsonLines {
    fn judged(&mut self, row: &Row<'_>, judged: &Judged) {
        self.cells(row);
        let out = &mut self.out;
        out.extend_from_slice(b"\"min_mm\":");
        judged.bounds.minimum().put_exact(Unit::Millimetre, 0, out);
        out.extend_from_slice(b",\"max_mm\":");
        judged.bounds.maximum().put_exact(Unit::Millimetre, 0, out);
        out.extend_from_slice(b",\"deviation_um\":");
        judged.verdict.deviation.put_exact(Unit::Micrometre, 0, out);
        out.extend_from_slice(b",\"status\":\"");
        out.extend_from_slice(judged.verdict.status.word().as_bytes());
        out.extend_from_slice(b"\",\"remove_um\":");
        match judged.verdict.removal {
            Some(removal) => removal.to_limit.put_exact(Unit::Micrometre, 0, out),
            None => out.extend_from_slice(b"null"),
        }
        out.extend_from_slice(b",\"error\":null}\n");
    }

    fn refused(&mut self, row: &Row<'_>, reason: &str) {
        self.cells(row);
        let reason = super::with_cells_beyond(row, self.names.len(), reason);
        self.reason(Some(reason.as_ref()).filter(|reason| !reason.is_empty()));
    }

    fn broken(&mut self, line: &str, reason: &str) {
        for (at, name) in self.names.iter().enumerate() {
            self.out.extend_from_slice(name);
            if at == 0 {
                text(line, &mut self.out);
            } else {
                self.out.extend_from_slice(b"null");
            }
        }
        self.out.push(b',');
        self.reason(Some(reason));
    }

    /// A comment or an empty line is no object; the tally counts it.
    fn line(&mut self, _line: &[u8]) {}
}
