//! The PIN that locks the operator's window. Its hash is made and compared outside; here is when it is asked for.

use fitcheck_core::message::message;

use super::{SettingsCommand, SettingsField, SettingsPage};
use crate::effect::Effect;
use crate::settings::Mode;
use crate::shared::Shared;

/// The least number of signs.
const LEAST: usize = 4;

impl SettingsPage {
    /// Whether the PIN is asked for.
    pub const fn asks_for_pin(&self) -> bool {
        self.pin.is_some()
    }

    pub(super) fn apply_pin(&mut self, command: SettingsCommand, shared: &mut Shared) -> Vec<Effect> {
        self.pin_error = None;
        match command {
            SettingsCommand::Type(SettingsField::NewPin, text) => self.new_pin = text,
            SettingsCommand::Type(SettingsField::Pin, text) => self.pin = self.pin.take().map(|_| text),
            SettingsCommand::SetPin => {
                if self.new_pin.trim().chars().count() < LEAST {
                    let short = message!("operator-pin-short").count("least", LEAST);
                    self.pin_error = Some((SettingsField::NewPin, short));
                } else {
                    return vec![Effect::HashPin(self.new_pin.trim().to_owned())];
                }
            }
            SettingsCommand::PinHashed(Ok(hash)) => {
                shared.pin = Some(hash);
                self.new_pin.clear();
                shared.note(message!("operator-pin-set"), Vec::new());
            }
            SettingsCommand::PinHashed(Err(why)) => self.pin_error = Some((SettingsField::NewPin, why)),
            SettingsCommand::RemovePin => {
                shared.pin = None;
                shared.note(message!("operator-pin-removed"), Vec::new());
            }
            SettingsCommand::LeaveOperator if shared.pin.is_none() => shared.set_mode(Mode::Full),
            SettingsCommand::LeaveOperator => {
                self.pin = Some(String::new());
                return vec![Effect::Focus(SettingsField::Pin.into())];
            }
            SettingsCommand::TryPin => {
                let tried = self.pin.as_ref().zip(shared.pin.clone());
                return tried
                    .map(|(pin, hash)| Effect::TryPin { pin: pin.trim().to_owned(), hash })
                    .into_iter()
                    .collect();
            }
            SettingsCommand::PinTried(true) if self.pin.is_some() => {
                self.pin = None;
                shared.set_mode(Mode::Full);
            }
            SettingsCommand::PinTried(false) if self.pin.is_some() => {
                self.pin = Some(String::new());
                self.pin_error = Some((SettingsField::Pin, message!("operator-pin-wrong")));
            }
            SettingsCommand::Stay => self.pin = None,
            _ => {}
        }
        Vec::new()
    }
}
