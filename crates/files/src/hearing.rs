//! Whether something long hears Ctrl+C, and whether it was asked to end.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::SeqCst};

/// Whether somebody pressed Ctrl+C while something long went on.
static ASKED: AtomicBool = AtomicBool::new(false);

/// How many long things go on that hear it.
static HEARING: AtomicUsize = AtomicUsize::new(0);

/// From here on one thing more hears it. What is given says whether it is to end.
pub(super) fn begin() -> &'static AtomicBool {
    HEARING.fetch_add(1, SeqCst);
    &ASKED
}

/// One thing less hears it.
pub(super) fn end() {
    HEARING.fetch_sub(1, SeqCst);
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
