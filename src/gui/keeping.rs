//! When the state is kept: soon after every change, on the thread of files, and at the end.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use eframe::egui::Context;

use super::effects::Runner;
use super::store::Store;
use crate::message::Message;
use crate::session::{Saved, Session};

/// How long a change waits for others, seconds: what a killed window loses at most.
const DELAY: f64 = 1.0;

/// Keeps what the session wants kept.
#[derive(Debug)]
pub(super) struct Keeper {
    store: Store,
    /// What is kept, or on its way there.
    kept: Saved,
    /// Since when there is something new, in seconds of the window.
    since: Option<f64>,
    failures: (Sender<Message>, Receiver<Message>),
    /// The last failure that the user was told.
    told: Option<Message>,
}

impl Keeper {
    /// A keeper of what was just read from the store.
    pub fn new(store: Store, kept: Saved) -> Self {
        Self { store, kept, since: None, failures: channel(), told: None }
    }

    /// Notices what commands have changed.
    pub fn look(&mut self, ctx: &Context, session: &Session) {
        if self.store == Store::nowhere() {
            return;
        }
        let is_new = session.saved() != self.kept;
        self.since = is_new.then(|| self.since.unwrap_or_else(|| ctx.input(|input| input.time)));
    }

    /// Keeps what has waited long enough, and tells what went wrong, each thing once.
    pub fn frame(&mut self, ctx: &Context, session: &mut Session, runner: &Runner) {
        for failure in self.failures.1.try_iter() {
            if self.told.as_ref() != Some(&failure) {
                session.tell(failure.clone());
                self.told = Some(failure);
                ctx.request_repaint();
            }
        }
        let Some(since) = self.since else { return };
        let waits = since + DELAY - ctx.input(|input| input.time);
        if 0.0 < waits {
            return ctx.request_repaint_after(Duration::from_secs_f64(waits));
        }
        self.keep(session, runner, Some(ctx.clone()), |_| ());
    }

    /// Keeps what is new, before the window goes. A drive that does not answer is not waited for forever.
    pub fn finish(&mut self, session: &Session, runner: &Runner) {
        const MOST: Duration = Duration::from_secs(3);
        let (sender, receiver) = channel();
        self.keep(session, runner, None, move |result| drop(sender.send(result)));
        match receiver.recv_timeout(MOST) {
            Ok(Ok(())) => {}
            Ok(Err(failure)) => log::error!("{failure}"),
            Err(error) => log::error!("the state was not kept: {error}"),
        }
    }

    /// Writes on the thread of files, so that a slow drive never holds up a frame and what is newer is written later.
    fn keep(
        &mut self,
        session: &Session,
        runner: &Runner,
        ctx: Option<Context>,
        done: impl FnOnce(Result<(), Message>) + Send + 'static,
    ) {
        self.since = None;
        let after = session.saved();
        let before = std::mem::replace(&mut self.kept, after.clone());
        let store = self.store.clone();
        let failures = self.failures.0.clone();
        runner.after_files(Box::new(move || {
            let result = if before == after { Ok(()) } else { store.save(&before, &after) };
            if let (Err(failure), Some(ctx)) = (&result, ctx) {
                log::error!("{failure}");
                // A closed window hears nothing; that is no error.
                let _closed = failures.send(failure.clone());
                ctx.request_repaint();
            }
            done(result);
        }));
    }
}
