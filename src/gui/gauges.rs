//! The ports of gauges, on a thread of their own: it opens and closes them one after the other, so that a port is closed before it is
//! opened anew. What comes from a port asks for a frame.

use std::sync::Mutex;
use std::sync::mpsc::{Sender, channel};

use eframe::egui::Context;

use super::errands::Errands;
use crate::gauges::PortSettings;
use crate::session::Command;

/// What is done with ports.
pub(super) enum PortOrder {
    Open { run: u64, settings: PortSettings },
    Close(u64),
    Find,
}

/// Where commands go, and which window draws them.
#[derive(Clone)]
pub(super) struct Listener {
    pub ctx: Context,
    pub answers: Sender<Command>,
}

impl Listener {
    pub fn say(&self, command: Command) {
        // A closed window hears no answer; that is not an error.
        let _closed = self.answers.send(command);
        self.ctx.request_repaint();
    }
}

/// The thread of the ports, once one was asked for. Dropped, it closes them all.
#[derive(Debug, Default)]
pub(super) struct Ports(Mutex<Option<Sender<(PortOrder, Listener)>>>);

impl Ports {
    /// Does something with ports, in the order in which it was asked for. Tests open none.
    pub fn give(&self, errands: Errands, order: PortOrder, listener: Listener) {
        if errands == Errands::AtOnce {
            return;
        }
        let mut thread = self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let orders = thread.get_or_insert_with(|| {
            let (sender, orders) = channel::<(PortOrder, Listener)>();
            let serve = move || {
                let mut open = OpenPorts::default();
                for (order, listener) in orders {
                    open.serve(order, &listener);
                }
            };
            if let Err(error) = std::thread::Builder::new().name("gauges".to_owned()).spawn(serve) {
                log::error!("no thread for gauges: {error}");
            }
            sender
        });
        if orders.send((order, listener)).is_err() {
            log::error!("the thread of the gauges has ended");
        }
    }

    /// Closes them all.
    pub fn stop(&self) {
        *self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner) = None;
    }
}

#[cfg(feature = "gauges")]
use with_ports::OpenPorts;
#[cfg(not(feature = "gauges"))]
use without_ports::OpenPorts;

#[cfg(feature = "gauges")]
mod with_ports {
    use std::collections::BTreeMap;

    use super::{Listener, PortOrder};
    use crate::gauges::port::{Port, list};
    use crate::gauges::{News, Trouble};
    use crate::message::message;
    use crate::session::{Command, GaugeCommand, SettingsCommand};

    /// The open ports by their numbers.
    #[derive(Default)]
    pub(super) struct OpenPorts(BTreeMap<u64, Port>);

    impl OpenPorts {
        pub(super) fn serve(&mut self, order: PortOrder, listener: &Listener) {
            match order {
                PortOrder::Open { run, settings } => {
                    let name = settings.port.clone();
                    let heard = listener.clone();
                    match Port::open(settings, Box::new(move |news| heard.say(Command::Heard { run, news }))) {
                        Ok(port) => {
                            self.0.insert(run, port);
                        }
                        Err(error) => {
                            let trouble = Trouble::Other { port: name, reason: error.to_string() };
                            listener.say(Command::Heard { run, news: News::Lost(trouble) });
                        }
                    }
                }
                PortOrder::Close(run) => {
                    self.0.remove(&run);
                }
                PortOrder::Find => {
                    let failed = |error: std::io::Error| message!("gauges-no-ports").text("reason", error);
                    listener.say(SettingsCommand::Gauge(GaugeCommand::Ports(list().map_err(failed))).into());
                }
            }
        }
    }
}

#[cfg(not(feature = "gauges"))]
mod without_ports {
    use std::collections::BTreeSet;

    use super::{Listener, PortOrder};
    use crate::gauges::{News, Trouble};
    use crate::session::Command;

    /// What a window that was built without ports was asked to open.
    #[derive(Default)]
    pub(super) struct OpenPorts(BTreeSet<u64>);

    impl OpenPorts {
        pub(super) fn serve(&mut self, order: PortOrder, listener: &Listener) {
            match order {
                PortOrder::Open { run, settings } => {
                    log::info!("{} is not opened: this build has no ports", settings.port);
                    self.0.insert(run);
                    listener.say(Command::Heard { run, news: News::Lost(Trouble::NotBuilt) });
                }
                PortOrder::Close(run) => {
                    self.0.remove(&run);
                }
                PortOrder::Find => {}
            }
        }
    }
}
