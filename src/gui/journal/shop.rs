//! The server of the shop: what is new is sent on a thread of its own.

use std::path::Path;

use crate::message::{Message, Say, message};
use crate::session::{Command, RecordsCommand};
use crate::store::local::{Anchors, Reader};
use crate::store::shop::{
    Doing, Password, Patience, Places, Sender, Sending, ShopAddress, ShopError, Status, keep_in_keyring,
};

/// The sender of the window, where there is one.
#[derive(Default)]
pub(super) struct Shop {
    sender: Option<Sender>,
}

impl Shop {
    /// Begins to send the journal in a file, and tells how that goes.
    pub fn send_to(
        &mut self,
        address: &str,
        (file, station): (&Path, &str),
        tell: impl Fn(Command) + Clone + Send + 'static,
    ) {
        match begin(address, (file, station), tell.clone()) {
            Ok(sender) => self.sender = Some(sender),
            Err(problem) => tell(RecordsCommand::Server(Err(problem)).into()),
        }
    }

    /// Tells it that the journal has a new entry.
    pub fn wake(&self) {
        if let Some(sender) = &self.sender {
            sender.wake();
        }
    }

    /// Lets it try again.
    pub fn again(&self) {
        if let Some(sender) = &self.sender {
            sender.try_again();
        }
    }

    /// Ends it.
    pub fn leave(&mut self) {
        if let Some(sender) = self.sender.take() {
            sender.stop();
        }
    }
}

fn begin(
    address: &str,
    (file, station): (&Path, &str),
    tell: impl Fn(Command) + Clone + Send + 'static,
) -> Result<Sender, Message> {
    let (address, given) = ShopAddress::read(address).map_err(|error| error.message())?;
    let source = Reader::open(file).map_err(|error| error.message())?;
    // Before anything that the sender tells.
    tell(RecordsCommand::Server(Ok(address.to_string())).into());
    let chain = source.chain();
    let server = address.server();
    let mut to_keep = given.clone().map(|password| (address.clone(), password));
    let sending = Sending {
        source: Box::new(source),
        station: station.to_owned(),
        address,
        given,
        places: Places::of_system(),
        known: None,
        patience: Patience::default(),
    };
    let heard = move |status: &Status| {
        tell(RecordsCommand::Sent { unsent: status.unsent, trouble: trouble(status) }.into());
        if status.doing == Doing::Resting
            && let (Some(head), Some(path)) = (status.server, Anchors::of_servers())
            && let Err(reason) = Anchors::keep_of_server(&path, &server, chain, head)
        {
            log::warn!("{}: {reason}", path.display());
        }
        // A password that the server has taken.
        if status.doing == Doing::Resting
            && status.problem.is_none()
            && let Some((address, password)) = to_keep.take()
        {
            tell(kept(&address, &password));
        }
    };
    Sender::start(sending, heard).map_err(|error: ShopError| error.message())
}

/// What is wrong, with what is said of places that had no password to give.
fn trouble(status: &Status) -> Option<Message> {
    let problem = status.problem.as_ref()?.message();
    let and = |one, other| message!("records-page-and").message("one", one).message("other", other);
    Some(status.remarks.iter().map(Say::message).fold(problem, and))
}

/// Puts a password that stood in an address into the keyring, and tells whether that went well.
fn kept(address: &ShopAddress, password: &Password) -> Command {
    let id = |result: &Result<(), String>| match result {
        Ok(()) => "records-page-in-keyring",
        Err(_) => "records-page-not-in-keyring",
    };
    let result = keep_in_keyring(address, password);
    let said = Message::new(id(&result)).text("server", address);
    RecordsCommand::Note(match result {
        Ok(()) => said,
        Err(reason) => said.text("reason", reason),
    })
    .into()
}
