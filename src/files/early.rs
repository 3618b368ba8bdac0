//! A long file that goes to the disk while it is being written, so that little is left to wait for at its end.

use std::fs::File;
use std::io::{self, Write};
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread::{Builder, Scope, ScopedJoinHandle};

/// How much is written before it is sent to the disk.
const PART: usize = 16 << 20;

/// Writes a file and sends it to the disk part by part, on a thread of its own. A file shorter than a part has none.
pub(super) struct Early<'scope, 'env, 'file> {
    file: &'file File,
    scope: &'scope Scope<'scope, 'env>,
    /// How much was written since a part was sent.
    waiting: usize,
    sender: Option<(SyncSender<()>, ScopedJoinHandle<'scope, io::Result<()>>)>,
}

impl<'scope, 'env, 'file: 'scope> Early<'scope, 'env, 'file> {
    pub(super) const fn new(file: &'file File, scope: &'scope Scope<'scope, 'env>) -> Self {
        Self { file, scope, waiting: 0, sender: None }
    }

    /// Sends what was written. Where it is behind, it sends more the next time.
    fn send(&mut self) {
        self.waiting = 0;
        if self.sender.is_none() {
            let file = self.file;
            let (sender, receiver) = sync_channel(1);
            let work = move || receiver.iter().try_for_each(|()| file.sync_data());
            // Without a thread all of it is sent at the end.
            let thread = Builder::new().name("disk".to_owned()).spawn_scoped(self.scope, work);
            self.sender = thread.ok().map(|thread| (sender, thread));
        }
        if let Some((sender, _)) = &self.sender {
            let _is_behind = sender.try_send(());
        }
    }

    /// Waits until everything is on the disk.
    ///
    /// # Errors
    /// What the disk reports, also of a part: it does so only once.
    pub(super) fn end(self) -> io::Result<()> {
        if let Some((sender, thread)) = self.sender {
            drop(sender);
            thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))?;
        }
        self.file.sync_all()
    }
}

impl<'scope, 'file: 'scope> Write for Early<'scope, '_, 'file> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = (&mut &*self.file).write(bytes)?;
        self.waiting += count;
        if PART <= self.waiting {
            self.send();
        }
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
