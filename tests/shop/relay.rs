//! A network between a station and its server that can be cut, fall silent and come back.

use std::io::{Read as _, Write as _};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::atomic::{AtomicBool, AtomicI64, AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

/// What is shared with the threads.
#[derive(Default)]
struct State {
    /// Bytes that still go through, of all connections together; beyond them everything is cut. `i64::MAX` for no end.
    budget: AtomicI64,
    silent: AtomicBool,
    closed: AtomicBool,
    cuts: AtomicU64,
    connections: AtomicU64,
    open: Mutex<Vec<TcpStream>>,
}

/// A relay on a port of this computer.
pub struct Relay {
    pub port: u16,
    state: Arc<State>,
}

impl Relay {
    /// A relay to a port of this computer.
    pub fn to(port: u16) -> Self {
        Self::on(0, port)
    }

    /// The same on a port.
    pub fn on(own: u16, port: u16) -> Self {
        let listener = TcpListener::bind(("127.0.0.1", own)).unwrap();
        let state = Arc::new(State { budget: AtomicI64::new(i64::MAX), ..State::default() });
        let relay = Self { port: listener.local_addr().unwrap().port(), state: Arc::clone(&state) };
        let accept = move || {
            for stream in listener.incoming() {
                if state.closed.load(Ordering::SeqCst) {
                    return;
                }
                let (Ok(here), Ok(there)) = (stream, TcpStream::connect(("127.0.0.1", port))) else { continue };
                state.connections.fetch_add(1, Ordering::SeqCst);
                let mut open = state.open.lock().unwrap();
                open.extend([here.try_clone().unwrap(), there.try_clone().unwrap()]);
                drop(open);
                for (from, to) in [(here.try_clone().unwrap(), there.try_clone().unwrap()), (there, here)] {
                    let state = Arc::clone(&state);
                    thread::Builder::new().name("relay".to_owned()).spawn(move || pump(&state, from, to)).unwrap();
                }
            }
        };
        thread::Builder::new().name("relay".to_owned()).spawn(accept).unwrap();
        relay
    }

    /// An address through it.
    pub fn address(&self, address: &str) -> String {
        through(address, self.port)
    }

    /// Cuts everything after so many bytes.
    pub fn cut_after(&self, bytes: i64) {
        self.state.budget.store(bytes, Ordering::SeqCst);
    }

    /// Lets everything through, without an end.
    pub fn mend(&self) {
        self.cut_after(i64::MAX);
        self.state.silent.store(false, Ordering::SeqCst);
    }

    /// Forwards nothing and stays open.
    pub fn fall_silent(&self) {
        self.state.silent.store(true, Ordering::SeqCst);
    }

    pub fn cuts(&self) -> u64 {
        self.state.cuts.load(Ordering::SeqCst)
    }

    pub fn connections(&self) -> u64 {
        self.state.connections.load(Ordering::SeqCst)
    }
}

impl Drop for Relay {
    fn drop(&mut self) {
        self.state.closed.store(true, Ordering::SeqCst);
        for stream in self.state.open.lock().unwrap().drain(..) {
            drop(stream.shutdown(Shutdown::Both));
        }
        drop(TcpStream::connect(("127.0.0.1", self.port)));
    }
}

/// An address on another port.
pub fn through(address: &str, port: u16) -> String {
    let (start, rest) = address.rsplit_once(':').unwrap();
    let (_port, database) = rest.split_once('/').unwrap();
    format!("{start}:{port}/{database}")
}

/// The port of an address.
pub fn port(address: &str) -> u16 {
    address.rsplit_once(':').unwrap().1.split('/').next().unwrap().parse().unwrap()
}

fn pump(state: &State, mut from: TcpStream, mut to: TcpStream) {
    let mut buffer = [0; 4096];
    while let Ok(read) = from.read(&mut buffer) {
        while state.silent.load(Ordering::SeqCst) && !state.closed.load(Ordering::SeqCst) {
            thread::sleep(Duration::from_millis(2));
        }
        if read == 0 {
            break;
        }
        let length = i64::try_from(read).unwrap();
        let is_endless = state.budget.load(Ordering::SeqCst) == i64::MAX;
        let left = if is_endless { length } else { state.budget.fetch_sub(length, Ordering::SeqCst) };
        let through = usize::try_from(left.clamp(0, length)).unwrap();
        if to.write_all(&buffer[..through]).is_err() {
            break;
        }
        if through < read {
            // Within an answer or a question; the next connection gets further.
            state.cuts.fetch_add(1, Ordering::SeqCst);
            break;
        }
    }
    drop(from.shutdown(Shutdown::Both));
    drop(to.shutdown(Shutdown::Both));
}
