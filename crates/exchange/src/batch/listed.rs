//! The listed rows of a stream as text of any form, in the order of the list.

use std::io::{self, Write};
use std::ops::Range;
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::text::{Within as _, long};

use super::{Form, Rendering, WithRendering};
use crate::exchange::ImportErrorKind;
use crate::exchange::batch::{ADDED, Block, Judged, Layout, ListedRows, Part, Take, TextRow};

/// What stands before the names of the added columns where the rows have some of them already.
const PREFIX: &str = "fitcheck_";

/// Writes listed rows as text of a form; rows of another form are not written.
///
/// # Errors
/// Those of both streams; [`io::ErrorKind::InvalidData`] where the rows are not those that were judged.
pub fn write_listed(rows: &ListedRows, form: Form, out: &mut dyn Write) -> io::Result<()> {
    form.with_rendering(ListedText { rows, out }).unwrap_or_else(|| Err(io::ErrorKind::Unsupported.into()))
}

struct ListedText<'a> {
    rows: &'a ListedRows,
    out: &'a mut dyn Write,
}

/// Why rows of a layout cannot be written in a form of text, if they cannot.
pub fn refusal(form: Form, layout: &Layout) -> Option<Message> {
    // Only CSV has a place for the mark.
    if layout.are_simulated() && form != Form::Csv {
        return Some(message!("rows-export-simulated"));
    }
    let names = &layout.names;
    let twice = (1..).zip(names).find(|(after, name)| names.iter().skip(*after).any(|other| other == *name));
    let (_, column) = twice.filter(|_| form.finds_by_name())?;
    Some(message!("rows-export-twice").text("column", column))
}

impl WithRendering for ListedText<'_> {
    type Rendered = io::Result<()>;

    fn rendering<R: Rendering>(self) -> Self::Rendered {
        let Self { rows, out } = self;
        let layout = &*rows.layout;
        let mut prefix = String::new();
        while layout.names.iter().any(|name| name.strip_prefix(&prefix).is_some_and(|name| ADDED.contains(&name))) {
            prefix.push_str(PREFIX);
        }
        out.write_all(&R::above(layout, &prefix))?;
        let court = rows.court();
        let mut judge = court.judge();
        let mut text = R::new(layout, &prefix);
        rows.each_portion(&mut |numbers, parts| {
            text.out().clear();
            let mut written: Vec<(u64, Range<usize>)> = Vec::new();
            for (part, wanted) in parts {
                let block = Block::again(rows.stream.bytes(part)?, layout.separator(), part.broken());
                let mut only = OnlyWanted { text: &mut text, part, wanted, at: 0, written: &mut written };
                judge.block(&block, &mut only);
                if only.at != part.len() {
                    return Err(io::ErrorKind::InvalidData.into());
                }
            }
            for number in numbers {
                let at = written.binary_search_by_key(number, |(number, _)| *number).ok();
                if let Some((_, bytes)) = at.and_then(|at| written.get(at)) {
                    out.write_all(text.out().bytes().within(bytes.clone()))?;
                }
            }
            Ok(())
        })
    }
}

/// Writes some of the rows of a part, and where each of them stands.
struct OnlyWanted<'a, R> {
    text: &'a mut R,
    part: &'a Arc<Part>,
    /// Their numbers in it, ascending.
    wanted: &'a [usize],
    /// The number of the next row.
    at: usize,
    written: &'a mut Vec<(u64, Range<usize>)>,
}

impl<R: Rendering> OnlyWanted<'_, R> {
    fn row(&mut self, write: impl FnOnce(&mut R)) {
        let number = self.at;
        self.at += 1;
        if self.wanted.binary_search(&number).is_ok() {
            let begin = self.text.out().bytes().len();
            write(self.text);
            self.written.push((self.part.first + long(number), begin..self.text.out().bytes().len()));
        }
    }
}

impl<R: Rendering> Take for OnlyWanted<'_, R> {
    fn judged(&mut self, row: &TextRow<'_>, judged: &Judged) {
        self.row(|text| text.judged(row, judged));
    }

    fn refused(&mut self, row: &TextRow<'_>, reason: &str) {
        // A row of empty cells is none.
        if !reason.is_empty() {
            self.row(|text| text.refused(row, reason));
        }
    }

    fn broken(&mut self, line: &str, reason: &ImportErrorKind) {
        self.row(|text| text.broken(line, reason));
    }

    fn line(&mut self, _line: &[u8]) {}
}
