//! The walk along the chain: begun, going on, stopped, ended. What comes late of another walk changes nothing.

use super::{RecordsCommand, RecordsPage, Walk};
use crate::effect::Effect;

impl RecordsPage {
    /// Begins a walk, stops it, or takes what is said of it.
    pub(super) fn walk_on(&mut self, command: RecordsCommand) -> Vec<Effect> {
        let is_running = matches!(self.walk, Walk::Running { .. });
        match command {
            RecordsCommand::Verify => {
                self.runs += 1;
                self.walks = self.runs;
                self.walk = Walk::Running { done: 0, of: 0 };
                return vec![Effect::VerifyRecords { run: self.walks }];
            }
            RecordsCommand::CancelVerify if is_running => {
                self.walk = Walk::Cancelled;
                return vec![Effect::StopVerify];
            }
            RecordsCommand::Verifying { run, done, of } if is_running && run == self.walks => {
                self.walk = Walk::Running { done, of };
            }
            RecordsCommand::Verified { run, result, at } if is_running && run == self.walks => {
                self.walk = Walk::Done { result, at };
            }
            _ => {}
        }
        Vec::new()
    }
}
