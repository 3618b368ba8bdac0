//! Standard output: whatever is written to it, writing goes on.

use std::io::Write;

use crate::message::{self, is_wild};

/// Standard output as it is. The first error is kept and told at the end, and what comes after it goes nowhere: a verdict is reached, and
/// recorded, whoever listens. So nothing that is written here can fail.
pub(in crate::cli) struct Out<'a> {
    pub(super) out: &'a mut (dyn Write + Send),
    pub(super) failed: Option<std::io::Error>,
}

impl Out<'_> {
    pub(super) fn keep(&mut self, written: std::io::Result<()>) {
        self.failed = self.failed.take().or(written.err());
    }

    pub(in crate::cli) fn write_all(&mut self, bytes: &[u8]) {
        if self.failed.is_none() {
            let written = self.out.write_all(bytes);
            self.keep(written);
        }
    }

    /// An object on one line.
    pub(in crate::cli) fn write_json(&mut self, object: &impl serde::Serialize) {
        let written = serde_json::to_writer(&mut *self, object);
        self.keep(written.map_err(std::io::Error::from));
    }

    pub(in crate::cli) fn write_fmt(&mut self, text: std::fmt::Arguments<'_>) {
        self.write_all(text.to_string().as_bytes());
    }

    pub(in crate::cli) fn flush(&mut self) {
        if self.failed.is_none() {
            let written = self.out.flush();
            self.keep(written);
        }
    }
}

/// For what writes files as well.
impl Write for Out<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.write_all(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.flush();
        Ok(())
    }
}

/// An output for people: every text that is written to it is tamed. What is formatted is a line: no name in it begins another one.
pub(in crate::cli) struct Tame<W>(pub(in crate::cli) W);

impl Tame<Out<'_>> {
    pub(in crate::cli) fn write_all(&mut self, bytes: &[u8]) {
        self.0.write_all(tame(&String::from_utf8_lossy(bytes)).as_bytes());
    }

    pub(in crate::cli) fn write_fmt(&mut self, text: std::fmt::Arguments<'_>) {
        self.0.write_all(tame_text(text).as_bytes());
    }
}

impl<W: Write> Write for Tame<W> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.write_all(tame(&String::from_utf8_lossy(bytes)).as_bytes())?;
        Ok(bytes.len())
    }

    fn write_fmt(&mut self, text: std::fmt::Arguments<'_>) -> std::io::Result<()> {
        self.0.write_all(tame_text(text).as_bytes())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.0.flush()
    }
}

/// What is formatted, as one line, with its end where it has one.
fn tame_text(text: std::fmt::Arguments<'_>) -> String {
    let text = text.to_string();
    match text.strip_suffix('\n') {
        Some(line) => tame_line(line) + "\n",
        None => tame_line(&text),
    }
}

/// Lines of text, safe for a terminal.
pub(super) fn tame(text: &str) -> String {
    text.chars().map(|c| if c != '\n' && is_wild(c) { ' ' } else { c }).collect()
}

/// The same for a single line.
pub(in crate::cli) fn tame_line(text: &str) -> String {
    message::tame(text).into_owned()
}
