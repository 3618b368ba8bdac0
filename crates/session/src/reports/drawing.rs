//! How far the pages of a report are, and their end before that.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};

use fitcheck_core::message::message;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::report::Checks;
use fitcheck_exchange::report::csv::More;

/// The drawing of pages, for whoever wants to know how far it is, or to stop it.
#[derive(Debug, Default)]
pub struct Drawing {
    checks: AtomicU64,
    is_stopped: AtomicBool,
}

impl Drawing {
    /// How many checks were looked at; one is looked at several times.
    pub fn checks(&self) -> u64 {
        self.checks.load(Relaxed)
    }

    pub(super) fn stop(&self) {
        self.is_stopped.store(true, Relaxed);
    }

    pub(super) fn is_stopped(&self) -> bool {
        self.is_stopped.load(Relaxed)
    }
}

/// Checks that say how many of them were looked at.
#[derive(Debug)]
pub(super) struct WatchedChecks {
    pub checks: Arc<dyn Checks>,
    pub drawing: Arc<Drawing>,
}

impl Checks for WatchedChecks {
    fn each(&self, see: &mut dyn FnMut(&Record) -> io::Result<()>) -> io::Result<()> {
        self.checks.each(&mut |record| {
            if self.drawing.is_stopped() {
                return Err(io::Error::other(message!("reports-page-stopped").to_string()));
            }
            self.drawing.checks.fetch_add(1, Relaxed);
            see(record)
        })
    }

    fn more(&self) -> io::Result<More> {
        self.checks.more()
    }
}
