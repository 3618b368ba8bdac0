//! Sends a journal in the background: what is new at once, what could not be sent later, and what needs somebody not before
//! they say so.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use fitcheck_exchange::journal::chain::Head;

use super::access::{Access, PasswordRemark, Places};
use super::address::ShopAddress;
use super::error::ShopError;
use super::password::Password;
use super::send::{Sent, send};
use super::server::{Patience, Stop};
use super::source::Source;

/// How often a journal is looked at that nobody has told of: another program may have added to it.
const LOOKS: Duration = Duration::from_secs(30);
/// How long is waited for the thread when it is stopped. A keyring that waits for somebody is not waited for.
const ENDS: Duration = Duration::from_secs(2);

/// What is sent, and where to.
pub struct Sending {
    /// The journal; it is opened for this.
    pub source: Box<dyn Source + Send>,
    /// The station's name.
    pub station: String,
    /// The server.
    pub address: ShopAddress,
    /// The password that stood in the address.
    pub given: Option<Password>,
    /// Where a password is looked for.
    pub places: Places,
    /// The last entry that the server is known to have, from the last time; it is only told until the server was asked.
    pub known: Option<Head>,
    /// How long is waited.
    pub patience: Patience,
}

impl fmt::Debug for Sending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Sending")
            .field("station", &self.station)
            .field("address", &self.address)
            .finish_non_exhaustive()
    }
}

/// What the sender does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Doing {
    /// It waits for new entries.
    Resting,
    /// It connects or sends.
    Sending,
    /// It tries again by itself.
    Waiting,
    /// It does nothing until somebody says so.
    Stopped,
}

/// How it stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Status {
    /// What it does.
    pub doing: Doing,
    /// How many entries the server lacks; `None` where it was never asked.
    pub unsent: Option<u64>,
    /// The last entry that the server has; `None` where it was never asked.
    pub server: Option<Head>,
    /// Why the last attempt failed; `None` after one that did not.
    pub problem: Option<ShopError>,
    /// What is said of places that had no password to give; empty unless the server asked for one in vain.
    pub remarks: Vec<PasswordRemark>,
}

enum Order {
    Look,
    Again,
}

/// A sender at work. When it is dropped, it ends by itself.
#[derive(Debug)]
pub struct Sender {
    orders: mpsc::Sender<Order>,
    stop: Stop,
    thread: JoinHandle<()>,
}

impl Sender {
    /// Begins. `tell` is called on the sender's own thread whenever something has changed.
    ///
    /// # Errors
    /// [`ShopError::Machine`] where there is no thread for it.
    pub fn start(sending: Sending, tell: impl FnMut(&Status) + Send + 'static) -> Result<Self, ShopError> {
        let (orders, received) = mpsc::channel();
        let stop = Stop::default();
        let server = sending.known;
        let mut work = Work {
            pause: sending.patience.first_pause,
            status: Status { doing: Doing::Resting, unsent: None, server, problem: None, remarks: Vec::new() },
            sending,
            access: None,
            stop: stop.clone(),
            tell: Box::new(tell),
        };
        let thread = thread::Builder::new().name("shop".to_owned()).spawn(move || work.run(&received));
        let thread = thread.map_err(|error| ShopError::Machine { reason: error.to_string() })?;
        Ok(Self { orders, stop, thread })
    }

    /// Tells that the journal has a new entry.
    pub fn wake(&self) {
        // A thread that has ended was stopped.
        let _told = self.orders.send(Order::Look);
    }

    /// Tries at once, whatever went wrong before. The password is looked for anew.
    pub fn try_again(&self) {
        let _told = self.orders.send(Order::Again);
    }

    /// Ends it. What the server does not have yet is sent the next time.
    pub fn stop(self) {
        self.stop.stop();
        let Self { orders, thread, .. } = self;
        drop(orders);
        let begun = Instant::now();
        while !thread.is_finished() && begun.elapsed() < ENDS {
            thread::sleep(Duration::from_millis(5));
        }
    }
}

struct Work {
    sending: Sending,
    access: Option<Access>,
    pause: Duration,
    status: Status,
    stop: Stop,
    tell: Box<dyn FnMut(&Status) + Send>,
}

impl Work {
    fn run(&mut self, orders: &Receiver<Order>) {
        loop {
            let next = self.attempt();
            if self.stop.is_stopped() || self.rest(orders, next).is_break() {
                return;
            }
        }
    }

    /// Sends what there is, and says when to try again by itself.
    fn attempt(&mut self) -> Option<Instant> {
        self.change(|status| status.doing = Doing::Sending);
        let found = self.access.take();
        let Sending { source, station, address, given, places, patience, .. } = &self.sending;
        let access = found.unwrap_or_else(|| Access::find(address.clone(), given.clone(), places));
        let status = &mut self.status;
        let tell = &mut self.tell;
        let stop = &self.stop;
        let mut last = Instant::now();
        let mut progress = |sent: Sent| {
            let is_new = status.server.is_none();
            status.server = Some(sent.head);
            status.unsent = Some(sent.unsent);
            if is_new || Duration::from_millis(100) < last.elapsed() {
                last = Instant::now();
                tell(status);
            }
            if stop.is_stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let result = send(source.as_ref(), station, &access, (*patience, stop), &mut progress);
        let patience = *patience;
        let remarks = match &result {
            Err(ShopError::NoPassword { .. } | ShopError::Refused { .. }) if !access.has_password() => {
                access.remarks.clone()
            }
            _ => Vec::new(),
        };
        self.access = Some(access);
        self.status.remarks = remarks;
        match result {
            Ok(sent) => {
                self.pause = patience.first_pause;
                self.change(|status| {
                    status.doing = Doing::Resting;
                    status.server = Some(sent.head);
                    status.unsent = Some(sent.unsent);
                    status.problem = None;
                });
                None
            }
            Err(error) if error.is_passing() => {
                let pause = jittered(self.pause);
                self.pause = self.pause.saturating_mul(2).min(patience.longest_pause);
                self.failed(error, Doing::Waiting);
                Some(Instant::now() + pause)
            }
            Err(error) => {
                self.failed(error, Doing::Stopped);
                None
            }
        }
    }

    fn failed(&mut self, error: ShopError, doing: Doing) {
        let unsent = self.unsent();
        self.change(|status| (status.doing, status.problem, status.unsent) = (doing, Some(error), unsent));
    }

    /// Waits for an order, or for the time to try again. Ends where nobody can give an order any more.
    fn rest(&mut self, orders: &Receiver<Order>, next: Option<Instant>) -> ControlFlow<()> {
        loop {
            let patience = next.map_or(LOOKS, |next| next.saturating_duration_since(Instant::now()));
            let order = orders.recv_timeout(patience);
            if self.stop.is_stopped() {
                return ControlFlow::Break(());
            }
            let looks = match order {
                Ok(Order::Again) => {
                    self.access = None;
                    self.pause = self.sending.patience.first_pause;
                    return ControlFlow::Continue(());
                }
                Err(RecvTimeoutError::Disconnected) => return ControlFlow::Break(()),
                Err(RecvTimeoutError::Timeout) if next.is_some() => return ControlFlow::Continue(()),
                Ok(Order::Look) | Err(RecvTimeoutError::Timeout) => self.unsent(),
            };
            if self.status.doing == Doing::Resting {
                if looks != Some(0) {
                    return ControlFlow::Continue(());
                }
            } else {
                self.change(|status| status.unsent = looks);
            }
        }
    }

    /// How many entries the server lacks, by what it had last.
    fn unsent(&self) -> Option<u64> {
        let head = self.sending.source.head().ok()?;
        self.status.server.map(|server| head.number.saturating_sub(server.number))
    }

    /// Changes the status, and tells it if it is another one.
    fn change(&mut self, how: impl FnOnce(&mut Status)) {
        let before = self.status.clone();
        how(&mut self.status);
        if before != self.status {
            (self.tell)(&self.status);
        }
    }
}

/// A pause a fifth longer or shorter by chance, so that the stations of a shop do not all come back at once.
fn jittered(pause: Duration) -> Duration {
    // Without chance the pause is the shortest.
    let chance = getrandom::u32().unwrap_or(0) % 401;
    pause.saturating_mul(800 + chance) / 1000
}
