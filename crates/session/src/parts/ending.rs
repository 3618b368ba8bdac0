//! A part begins with its serial number, and the next one comes.

use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use jiff::civil::DateTime;

use super::{PartsPage, serials};
use crate::effect::Effect;
use crate::parts::WalkField;
use crate::shared::Shared;

impl PartsPage {
    /// Begins a part; a serial number that was measured already is asked about once.
    pub(super) fn begin(&mut self, shared: &mut Shared, now: DateTime) -> Vec<Effect> {
        let serial = self.texts.text(WalkField::Serial).trim().to_owned();
        let Some(plan) = self.document.plan().map(Arc::clone) else { return Vec::new() };
        if self.is_measured_already(&plan.head.part, &serial, shared) {
            let is_new = self.again.as_ref() != Some(&serial);
            if is_new {
                self.asking.ask(now);
            }
            if is_new || !self.asking.is_answered(now) {
                let question = message!("walk-page-serial-again").text("serial", &serial);
                self.errors.insert(WalkField::Serial, question);
                self.again = Some(serial);
                return Vec::new();
            }
        }
        self.again = None;
        // A plan that was changed and not saved cannot be read again.
        let path = self.document.path().filter(|_| !self.document.is_unsaved()).map(std::path::Path::to_owned);
        if let Some(waiting) = self.give_up_resuming() {
            shared.tell(message!("walk-page-given-up").text("serial", waiting.serial));
        }
        self.walking.begin(&plan, path, serial, shared.recording.newest);
        self.walking.opened = self.document.opened;
        self.suggested = None;
        self.clear_value();
        self.errors.clear();
        self.watch_plan(&plan, shared);
        vec![Effect::Focus(WalkField::Value.into())]
    }

    /// Whether a part of this serial number was measured since the window was opened, has values from files that were read meanwhile, or
    /// is among the newest of the journal.
    pub(super) fn is_measured_already(&self, part: &str, serial: &str, shared: &Shared) -> bool {
        let is_ended = || self.ended.contains(&(part.to_owned(), serial.to_owned()));
        !serial.is_empty() && (is_ended() || shared.recording.has_serial(part, serial))
    }

    /// Puts another serial number into the field.
    pub(super) fn set_serial(&mut self, serial: String) {
        self.texts.set(WalkField::Serial, serial);
        self.errors.remove(&WalkField::Serial);
        self.again = None;
    }

    /// The next part: what is missing of this one is said first, and what was left out of it at last.
    pub(super) fn next_part(&mut self, shared: &mut Shared) -> Vec<Effect> {
        let standing = self.walking.standing();
        if 0 < standing.missing && !self.walking.is_warned {
            self.walking.quiet();
            self.walking.is_warned = true;
            return Vec::new();
        }
        if let Some(plan) = self.walking.plan.as_ref()
            && 0 < standing.measured
        {
            self.ended.insert((plan.head.part.clone(), self.walking.serial().to_owned()));
        }
        self.say_left_out(shared);
        // The parts of another plan have numbers of their own.
        let next = if self.is_other_open() { String::new() } else { serials::next(self.walking.serial()) };
        // An answer of the journal that comes now is of no part any more.
        self.give_up_resuming();
        self.walking.end();
        self.errors.clear();
        self.suggested = Some(next.clone());
        self.set_serial(next);
        self.clear_value();
        vec![Effect::Focus(WalkField::Serial.into())]
    }

    /// Another plan is open: the number that was counted up for the parts of the one before is not that of its first part.
    pub(super) fn forget_suggested(&mut self) {
        if self.suggested.take().is_some_and(|serial| serial == self.texts.text(WalkField::Serial)) {
            self.set_serial(String::new());
        }
    }

    /// The sizes without a value and the reasons: no record has them.
    fn say_left_out(&self, shared: &mut Shared) {
        let of_size = |(name, reason)| message!("walk-page-ended-size").text("name", name).text("reason", reason);
        let left_out: Vec<Message> = self.walking.left_out().map(of_size).collect();
        let ended = message!("walk-page-ended").text("serial", self.walking.serial());
        shared.note_details(ended, left_out);
    }
}
