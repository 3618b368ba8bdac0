//! How far a batch has come, on standard error while somebody watches.

use std::sync::atomic::Ordering::Relaxed;

use indicatif::{ProgressBar, ProgressStyle};

use crate::batch::Watch;

/// A line that changes; nothing where standard error is no terminal.
pub(super) struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// For a stream of so many bytes, if that is known.
    pub(super) fn new(name: &str, size: Option<u64>) -> Self {
        let template = match size {
            Some(_) => "{prefix}: {msg} {bar:20} {percent} %, {eta} left",
            None => "{prefix}: {msg}",
        };
        let bar = size.map_or_else(ProgressBar::no_length, ProgressBar::new);
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        bar.set_prefix(name.replace(char::is_control, " "));
        Self { bar }
    }

    pub(super) fn show(&self, watch: &Watch) {
        if self.bar.is_hidden() {
            return;
        }
        let rows = watch.rows.load(Relaxed);
        // Ten times a second, so a tenth of a second is not nothing.
        let tenths = (self.bar.elapsed().as_millis() / 100).max(1);
        self.bar.set_message(format!("{rows} rows, {} a second", u128::from(rows) * 10 / tenths));
        self.bar.set_position(watch.bytes.load(Relaxed));
    }

    /// Takes the line away.
    pub(super) fn end(&self) {
        self.bar.finish_and_clear();
    }
}
