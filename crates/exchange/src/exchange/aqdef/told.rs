//! What is said of a file: of its lines, of the file beside it, and of all values together.

use fitcheck_core::message::{FilePlace, Say as _};

use super::error::{AqdefFault, AqdefWarning};
use crate::exchange::error::{ImportErrorKind, ImportWarningKind};
use crate::exchange::given::shorten;
use crate::exchange::imported::Sink;

/// Values that are told together: the line of the first one, and how many.
type Together = Option<(usize, usize)>;

/// Says it.
pub(super) struct AqdefReporter<'s, 'a> {
    pub(super) sink: &'a mut Sink<'s>,
    /// The file beside this one that has the characteristics.
    beside: Option<String>,
    missing: Together,
    rounded: Together,
    said_unit: bool,
}

impl<'s, 'a> AqdefReporter<'s, 'a> {
    pub(super) const fn new(sink: &'a mut Sink<'s>) -> Self {
        Self { sink, beside: None, missing: None, rounded: None, said_unit: false }
    }

    /// From here on what is declared is in the file beside this one.
    pub(super) fn declared_beside(&mut self, file: String) {
        self.beside = Some(file);
    }

    pub(super) fn is_full(&mut self, line: usize) -> bool {
        self.sink.is_full(line)
    }

    /// An error of a line of values.
    pub(super) fn refuse(&mut self, line: usize, kind: ImportErrorKind, given: &str) {
        self.sink.refuse(FilePlace::line(line), kind, shorten(given));
    }

    /// A warning that belongs to no row.
    pub(super) fn warn(&mut self, line: usize, kind: ImportWarningKind) {
        self.sink.warn(FilePlace::line(line), None, kind);
    }

    /// A warning about the value on a line.
    pub(super) fn warn_of(&mut self, line: usize, kind: ImportWarningKind) {
        self.sink.warn(FilePlace::line(line), Some(line), kind);
    }

    /// An error of a line that declares something.
    pub(super) fn fault(&mut self, line: usize, kind: ImportErrorKind, given: &str) {
        match self.beside.clone() {
            Some(file) => self.refuse(1, AqdefFault::Beside { file, line, reason: kind.message() }.into(), given),
            None => self.refuse(line, kind, given),
        }
    }

    /// A warning about a line that declares something.
    pub(super) fn declared(&mut self, line: usize, kind: ImportWarningKind) {
        match self.beside.clone() {
            Some(file) => {
                let reason = kind.message();
                let stands_against = kind.stands_against();
                self.warn(1, AqdefWarning::Beside { file, line, reason, stands_against }.into());
            }
            None => self.warn(line, kind),
        }
    }

    /// A characteristic without a unit: once in a file.
    pub(super) fn unit_assumed(&mut self, line: usize) {
        if !std::mem::replace(&mut self.said_unit, true) {
            self.declared(line, ImportWarningKind::UnitAssumed);
        }
    }

    /// A value that is none.
    pub(super) fn missing(&mut self, line: usize) {
        add(&mut self.missing, line);
    }

    pub(super) fn rounded(&mut self, line: usize) {
        add(&mut self.rounded, line);
    }

    /// What was counted.
    pub(super) fn end(&mut self) {
        if let Some((line, count)) = self.missing.take() {
            self.warn(line, AqdefWarning::Missing { count }.into());
        }
        if let Some((line, count)) = self.rounded.take() {
            self.warn(line, ImportWarningKind::RoundedValues { count });
        }
    }
}

fn add(together: &mut Together, line: usize) {
    let (first, count) = together.unwrap_or((line, 0));
    *together = Some((first, count + 1));
}
