//! The form for the server of the shop, and what is known of it.

use super::{RecordsCommand, RecordsField, RecordsPage};
use crate::effect::Effect;
use crate::shared::Shared;
use crate::state::PageState as _;

impl RecordsPage {
    /// Applies a command about the server.
    pub(super) fn apply_server(&mut self, command: RecordsCommand, shared: &mut Shared) -> Vec<Effect> {
        let recording = &mut shared.recording;
        match command {
            RecordsCommand::AskForServer(is_asked) => {
                // What was typed may have a password: it does not stay.
                let shown = recording.server().map_or_else(String::new, str::to_owned);
                self.texts.insert(RecordsField::Server, shown);
                self.errors.remove(&RecordsField::Server);
                recording.ask_for_server(is_asked);
                if is_asked {
                    return vec![Effect::Focus(RecordsField::Server.into())];
                }
            }
            RecordsCommand::TakeServer => recording.try_server(self.text(RecordsField::Server).trim()),
            RecordsCommand::LeaveServer => recording.leave_server(),
            RecordsCommand::SendAgain => recording.send_again(),
            RecordsCommand::Server(Ok(address)) => {
                self.texts.remove(&RecordsField::Server);
                recording.use_server(address);
            }
            RecordsCommand::Server(Err(problem)) if recording.asks_for_server() => {
                self.errors.insert(RecordsField::Server, problem);
            }
            // The address of the state file.
            RecordsCommand::Server(Err(problem)) => recording.of_server(None, Some(problem)),
            RecordsCommand::Sent { unsent, trouble } => recording.of_server(unsent, trouble),
            _ => {}
        }
        Vec::new()
    }
}
