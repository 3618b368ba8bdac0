//! A window that was built without the server of a shop.

use std::path::Path;

use crate::message::message;
use crate::session::{Command, RecordsCommand};

/// No server.
#[derive(Default)]
pub(super) struct Shop;

impl Shop {
    pub fn send_to(&mut self, _address: &str, _from: (&Path, &str), tell: impl Fn(Command)) {
        tell(RecordsCommand::Server(Err(message!("records-page-no-shop"))).into());
    }

    pub const fn wake(&self) {}

    pub const fn again(&self) {}

    pub const fn leave(&mut self) {}
}
