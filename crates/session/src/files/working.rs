//! A file that is being read or written: how far it is, and its end before that.

/// How far the file is that is being read or written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Working {
    /// Its name without the folder.
    pub name: String,
    /// Whether it is written; otherwise it is read.
    pub is_writing: bool,
    /// How many rows were read so far.
    pub rows: u64,
    /// How many bytes were read or written so far.
    pub bytes: u64,
    /// How many there are to read; `None` where nobody knows.
    pub all: Option<u64>,
    /// For how long it has been going on, in milliseconds.
    pub elapsed_ms: u64,
}

impl Working {
    /// How many rows come in a second; `None` as long as that says nothing.
    pub fn rate(&self) -> Option<u64> {
        self.rows.checked_mul(1_000)?.checked_div(self.elapsed_ms).filter(|_| 0 < self.rows)
    }
}
