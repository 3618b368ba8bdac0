//! Ctrl+C while something long goes on: the first one asks it to end, so that what is done stays whole; another one ends the program, and
//! so does the first where nothing heard it in time.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::SeqCst};

use super::unfinished;

/// Whether somebody pressed Ctrl+C while something long went on.
static ASKED: AtomicBool = AtomicBool::new(false);

/// How many long things go on that hear it.
static HEARING: AtomicUsize = AtomicUsize::new(0);

/// As long as it is there, the first Ctrl+C does not end the program but asks for the end of what goes on.
///
/// Where the system has no such signals, Ctrl+C ends the program at once.
#[derive(Debug)]
pub struct Stop {
    asked: &'static AtomicBool,
}

impl Stop {
    /// From here on Ctrl+C is heard.
    pub fn heard() -> Self {
        unfinished::remove_at_signals();
        HEARING.fetch_add(1, SeqCst);
        Self { asked: &ASKED }
    }

    /// Whether what goes on is to end.
    pub fn is_asked(&self) -> bool {
        self.asked.load(SeqCst)
    }
}

impl Drop for Stop {
    fn drop(&mut self) {
        HEARING.fetch_sub(1, SeqCst);
    }
}

/// Takes a Ctrl+C; `false` where nothing hears it, or it was asked before.
#[cfg(unix)]
pub(super) fn ask() -> bool {
    0 < HEARING.load(SeqCst) && !ASKED.swap(true, SeqCst)
}

/// Whether something still goes on that was asked to end.
#[cfg(unix)]
pub(super) fn is_awaited() -> bool {
    0 < HEARING.load(SeqCst)
}
