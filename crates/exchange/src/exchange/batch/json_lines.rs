//! Rows as JSON, an object a line: the columns of the input as texts, those that are added as numbers and texts.

use fitcheck_core::length::Line;

use super::ADDED;
use super::judge::Take;
use super::judged::Judged;
use super::layout::Layout;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::row::{TextRow, unquoted};

/// Writes JSON lines.
#[derive(Debug)]
pub struct JsonLines {
    /// What was written.
    pub out: Line,
    /// The name of each column with what stands before and after it.
    names: Vec<Vec<u8>>,
    /// The same of the added columns.
    added: [Vec<u8>; ADDED.len()],
}

impl JsonLines {
    /// Nothing written yet; `prefix` stands before the names of the added columns.
    pub fn new(layout: &Layout, prefix: &str) -> Self {
        let key = |before: &[u8], name: &str| {
            let mut out = Line::default();
            out.append(before);
            text(name, &mut out);
            out.push(b':');
            out.bytes().to_vec()
        };
        let name = |(at, name): (usize, &String)| key(if at == 0 { b"{" } else { b"," }, name);
        let added = ADDED.map(|name| key(b",", &format!("{prefix}{name}")));
        Self { out: Line::default(), names: layout.names.iter().enumerate().map(name).collect(), added }
    }

    fn cells(&mut self, row: &TextRow<'_>) {
        for (at, name) in self.names.iter().enumerate() {
            self.out.append(name);
            match row.cell(at) {
                Some(cell) => text(&unquoted(cell), &mut self.out),
                None => self.out.append(b"null"),
            }
        }
    }

    fn reason(&mut self, reason: Option<&str>) {
        let [figures @ .., error] = &self.added;
        for name in figures {
            self.out.append(name);
            self.out.append(b"null");
        }
        self.out.append(error);
        match reason {
            Some(reason) => text(reason, &mut self.out),
            None => self.out.append(b"null"),
        }
        self.out.append(b"}\n");
    }
}

/// A text in quotation marks. Writing to memory does not fail.
fn text(text: &str, out: &mut Line) {
    let _written = serde_json::to_writer(out, text);
}

impl Take for JsonLines {
    fn judged(&mut self, row: &TextRow<'_>, judged: &Judged) {
        self.cells(row);
        let out = &mut self.out;
        let [minimum, maximum, deviation, status, remove, error] = &self.added;
        out.append(minimum);
        out.pieces(|out| judged.bounds.minimum().put_mm(0, out));
        out.append(maximum);
        out.pieces(|out| judged.bounds.maximum().put_mm(0, out));
        out.append(deviation);
        out.pieces(|out| judged.verdict().deviation.put_um(0, out));
        out.append(status);
        text(judged.status.word(), out);
        out.append(remove);
        match judged.verdict().removal {
            Some(removal) => out.pieces(|out| removal.to_limit.put_um(0, out)),
            None => out.append(b"null"),
        }
        out.append(error);
        out.append(b"null}\n");
    }

    fn refused(&mut self, row: &TextRow<'_>, reason: &str) {
        self.cells(row);
        let reason = super::with_cells_beyond(row, self.names.len(), reason);
        self.reason(Some(reason.as_ref()).filter(|reason| !reason.is_empty()));
    }

    fn broken(&mut self, line: &str, reason: &ImportErrorKind) {
        for (at, name) in self.names.iter().enumerate() {
            self.out.append(name);
            if at == 0 {
                text(line, &mut self.out);
            } else {
                self.out.append(b"null");
            }
        }
        self.reason(Some(&reason.to_string()));
    }

    /// A comment or an empty line is no object; the tally counts it.
    fn line(&mut self, _line: &[u8]) {}
}
