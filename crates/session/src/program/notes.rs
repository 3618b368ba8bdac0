//! Notes about the program, block by block: warnings of the reader, remarks of the run, and the error that ended it.

use std::path::Path;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_nc::machine::{BlockPlace, Fault, FaultKind, Remark, StoreError};

use super::{Origin, ProgramPage};

/// An error, a warning or a remark.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    pub kind: NoteKind,
    pub place: BlockPlace,
    pub message: Message,
}

/// How much it matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum NoteKind {
    /// An error: it ended the run.
    Error,
    /// A remark of the run.
    Remark,
    /// A warning of the reader.
    Warning,
    /// A file that the run has read.
    File,
}

/// An error, and what can be done about it in the window; `folder` is that of the program.
fn fault_message(fault: &Fault, folder: Option<&Path>) -> Message {
    match *fault.kind {
        FaultKind::Store(StoreError::Missing { .. }) if let Some(folder) = folder => {
            message!("program-page-missing-file").message("fault", fault.message()).text("folder", folder.display())
        }
        ref kind if kind.is_of_datum() => message!("program-page-unknown-datum").message("fault", fault.message()),
        FaultKind::UnknownCycle { .. } | FaultKind::UnknownBlock => {
            message!("program-page-unknown").message("fault", fault.message())
        }
        _ => fault.message(),
    }
}

/// A remark in the words of the window: it writes no files of a program.
fn remark_message(remark: &Remark) -> Message {
    match remark {
        Remark::NotWritten { path } => message!("program-page-not-written").text("path", path),
        remark => remark.message(),
    }
}

impl ProgramPage {
    /// The folder of the program that was opened, in which it finds other files.
    fn folder(&self) -> Option<&Path> {
        if let Some(Origin::File(path)) = &self.origin { path.parent() } else { None }
    }

    /// How many notes there are.
    pub fn note_count(&self) -> usize {
        let run = self.run.as_ref();
        let of_run = run.map_or(0, |run| usize::from(run.fault.is_some()) + run.remark_count());
        let count = of_run + self.warnings.len();
        // Where nothing is odd, nobody asks where the files came from.
        let files = run.filter(|_| 0 < count).map_or(0, super::Run::file_count);
        count + files
    }

    /// A note by its number: the error first, then the remarks of the run, the warnings of the reader, and the files
    /// that the run has read.
    pub fn note(&self, number: usize) -> Option<Note> {
        let run = self.run.as_ref();
        let fault = run.and_then(|run| run.fault.as_ref());
        let Some(number) = number.checked_sub(usize::from(fault.is_some())) else {
            let fault = fault?;
            return Some(Note {
                kind: NoteKind::Error,
                place: fault.place.clone(),
                message: fault_message(fault, self.folder()),
            });
        };
        if let Some((place, remark)) = run.and_then(|run| run.remark(number)) {
            return Some(self.remark_at(place, remark_message(remark)));
        }
        let number = number.checked_sub(run.map_or(0, super::Run::remark_count))?;
        let main = self.main()?;
        let Some(warning) = self.warnings.get(number) else {
            if self.note_count() == 0 {
                return None;
            }
            let file = run?.file(number.checked_sub(self.warnings.len())?)?;
            let place = BlockPlace { program: main.path.clone(), block: 0 };
            return Some(Note { kind: NoteKind::File, place, message: file.message() });
        };
        // A line between blocks belongs to the block before it; what is about the whole file is told at its beginning.
        let line = warning.place.line.map_or(0, |line| line.saturating_sub(1));
        let block = main.program.blocks().partition_point(|block| block.lines.start <= line).saturating_sub(1);
        let place = BlockPlace { program: main.path.clone(), block };
        Some(Note { kind: NoteKind::Warning, place, message: warning.message() })
    }

    /// A remark with the number of its block, or with its line.
    fn remark_at(&self, place: &BlockPlace, what: Message) -> Note {
        let line = self.documents.get(&place.program).map(|document| document.first_line(place.block) + 1);
        let message = match (self.block_number(place), line) {
            (Some(number), _) => message!("program-page-at-block").text("number", number),
            (None, Some(line)) => message!("program-page-at-line").text("line", line),
            (None, None) => message!("program-page-at-block").text("number", place.block),
        };
        Note { kind: NoteKind::Remark, place: place.clone(), message: message.message("what", what) }
    }

    fn block_number(&self, place: &BlockPlace) -> Option<u32> {
        let program = match self.documents.get(&place.program) {
            Some(document) => std::sync::Arc::clone(&document.program),
            None => self.run.as_ref()?.program(&place.program)?,
        };
        program.blocks().get(place.block)?.number
    }
}
