//! The server of the shop: which one, what it lacks, and what is wrong with sending.

use fitcheck_core::message::Message;

use super::Recording;
use crate::effect::Effect;

/// What is known of the server of the shop.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Server {
    /// How many entries it does not have yet; `None` where nobody has asked it.
    pub unsent: Option<u64>,
    /// What is wrong.
    pub trouble: Option<Message>,
    /// Whether the form for its address is open.
    pub is_asked: bool,
}

impl Recording {
    /// The address of the server of the shop, without its password; `None` where there is none.
    pub fn server(&self) -> Option<&str> {
        self.settings.server.as_deref()
    }

    /// How many entries the server of the shop does not have yet; `None` where there is none, or nobody has asked it.
    pub const fn unsent(&self) -> Option<u64> {
        self.server.unsent
    }

    /// What is wrong with sending.
    pub const fn trouble(&self) -> Option<&Message> {
        self.server.trouble.as_ref()
    }

    /// Whether the form for the server's address is open.
    pub const fn asks_for_server(&self) -> bool {
        self.server.is_asked
    }

    pub(crate) const fn ask_for_server(&mut self, is_asked: bool) {
        self.server.is_asked = is_asked;
    }

    /// Sends to the server at an address, which may have a password: that stays outside.
    pub(crate) fn try_server(&mut self, address: &str) {
        self.errands.push(Effect::SendTo(Some(address.to_owned())));
    }

    /// The address is one, without its password. Whether the server can be asked is told later.
    pub(crate) fn use_server(&mut self, address: String) {
        self.settings.server = Some(address);
        self.server = Server::default();
    }

    /// Sends to no server any more.
    pub(crate) fn leave_server(&mut self) {
        if self.settings.server.take().is_some() {
            self.errands.push(Effect::SendTo(None));
        }
        self.server = Server::default();
    }

    /// What is known of it now. What comes late from a server that was left is of no use.
    pub(crate) fn of_server(&mut self, unsent: Option<u64>, trouble: Option<Message>) {
        if self.settings.server.is_some() {
            self.server.unsent = unsent;
            self.server.trouble = trouble;
        }
    }

    /// Sends at once, whatever went wrong before.
    pub(crate) fn send_again(&mut self) {
        self.errands.push(Effect::SendAgain);
    }

    /// The journal was opened: it is sent from now on.
    pub(super) fn begin_sending(&mut self) {
        if let Some(address) = self.settings.server.clone() {
            self.try_server(&address);
        }
    }

    /// The journal has a new entry.
    pub(super) fn wake_sender(&mut self) {
        if self.settings.server.is_some() {
            self.errands.push(Effect::WakeSender);
        }
    }
}
