//! How commands and news change the pairing page.

use jiff::civil::DateTime;

use super::{PairingCommand, PairingPage};
use crate::session::command::Effect;
use crate::session::shared::{News, PageState, Shared};

impl PageState for PairingPage {
    type Command = PairingCommand;

    fn apply(&mut self, command: PairingCommand, _shared: &mut Shared, _now: DateTime) -> Vec<Effect> {
        match command {
            PairingCommand::Type(field, text) => self.texts.set(field, text),
        }
        Vec::new()
    }

    fn follow(&mut self, _news: &News, _shared: &mut Shared) {}
}
