//! The check page for an operator: a verdict is read before the next value is typed.

use fitcheck_core::tolerance::Sources;

use super::{CheckField, CheckPage};
use crate::effect::Effect;
use crate::shared::Shared;

impl CheckPage {
    /// What an operator types: a verdict that asks for a look waits until it was read, and no value goes on to another size.
    pub(super) fn type_as_operator(&mut self, field: CheckField, text: String, shared: &mut Shared) {
        match field {
            CheckField::Measured if self.waits() => return shared.tell_to_go_on(),
            CheckField::Callout => self.clear_value(&shared.sources),
            _ => {}
        }
        self.type_text(field, text, &shared.sources);
    }

    /// The verdict has been read: the next value is asked for.
    pub(crate) fn go_on(&mut self, sources: &Sources) -> Vec<Effect> {
        self.clear_value(sources);
        vec![Effect::Focus(CheckField::Measured.into())]
    }

    pub(super) fn clear_value(&mut self, sources: &Sources) {
        self.texts.set(CheckField::Measured, "");
        self.measured_is_used = false;
        self.gauge = None;
        self.clear(sources);
    }

    /// Whether a verdict is shown that asks for a look.
    pub(crate) fn waits(&self) -> bool {
        self.would_repeat() && self.shown.as_ref().is_some_and(|shown| shown.record.verdict.asks_for_a_look())
    }
}
