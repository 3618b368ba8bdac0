//! Ctrl+C while something long goes on: the first one asks it to end, so that what is done stays whole; another one ends the program, and
//! so does the first where nothing heard it in time.

use std::sync::atomic::{AtomicBool, Ordering::SeqCst};

use super::{hearing, unfinished};

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
        Self { asked: hearing::begin() }
    }

    /// Whether what goes on is to end.
    pub fn is_asked(&self) -> bool {
        self.asked.load(SeqCst)
    }
}

impl Drop for Stop {
    fn drop(&mut self) {
        hearing::end();
    }
}
