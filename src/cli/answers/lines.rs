//! Lines of standard input in bounded memory.

use std::io::BufRead;

use fitcheck_core::text::Within as _;

/// The longest line of standard input in bytes; a longer one is refused.
pub(in crate::cli) const LONGEST_LINE: usize = 1 << 16;

/// A line of input, in memory that is used again.
#[derive(Default)]
pub(super) struct Line {
    pub(super) bytes: Vec<u8>,
    /// Whether the input's buffer is used up: the next read may have to wait.
    is_drained: bool,
}

/// The result of looking for the next line.
pub(super) enum NextLine {
    /// No more lines.
    End,
    /// A line.
    Whole,
    /// The line is too long; `bytes` holds its beginning.
    TooLong,
}

impl Line {
    /// Reads a line without its end (LF or CRLF); calls `before_waiting` when the input may take its time.
    pub(super) fn read(
        &mut self,
        input: &mut dyn BufRead,
        mut before_waiting: impl FnMut(),
    ) -> std::io::Result<NextLine> {
        self.bytes.clear();
        let mut is_whole = true;
        let mut is_end = true;
        loop {
            if self.is_drained {
                before_waiting();
            }
            let buffer = match input.fill_buf() {
                Ok(buffer) => buffer,
                Err(error) if error.kind() == std::io::ErrorKind::Interrupted => continue,
                Err(error) => return Err(error),
            };
            if buffer.is_empty() {
                break;
            }
            is_end = false;
            let end = buffer.iter().position(|&byte| byte == b'\n');
            let used = end.map_or(buffer.len(), |end| end + 1);
            // One more than allowed, for a carriage return.
            let room = (LONGEST_LINE + 1).saturating_sub(self.bytes.len());
            let part = buffer.within(..end.unwrap_or(used));
            is_whole &= part.len() <= room;
            self.bytes.extend(part.iter().take(room));
            self.is_drained = used == buffer.len();
            input.consume(used);
            if end.is_some() {
                break;
            }
        }
        if self.bytes.last() == Some(&b'\r') && is_whole {
            self.bytes.pop();
        }
        match (is_end, is_whole && self.bytes.len() <= LONGEST_LINE) {
            (true, _) => Ok(NextLine::End),
            (false, true) => Ok(NextLine::Whole),
            (false, false) => Ok(NextLine::TooLong),
        }
    }
}
