//! The rhythm of a value: Enter judges it, its verdict rests until it was read where an operator measures, and then the next one is asked for.

use jiff::civil::DateTime;

use crate::Session;
use crate::check::CheckField;
use crate::command::Command;
use crate::effect::Effect;
use crate::field::Field;
use crate::page::Page;
use crate::parts::WalkField;
use crate::settings::Mode;

impl Session {
    /// Enter was pressed in a field. A scanner or gauge that ends its line with two signs answers no question with the second one.
    pub(super) fn enter(&mut self, field: Field, now: DateTime) -> Vec<Effect> {
        if self.is_for_operators() && self.rests() && !matches!(field, Field::Settings(_)) {
            return if self.asking.is_in_passing(now) { Vec::new() } else { self.apply(Command::GoOn, now) };
        }
        if self.is_for_operators() && field == CheckField::Callout.into() && self.text(CheckField::Measured).is_empty()
        {
            // The value comes next; that it is not there yet is no error.
            return vec![Effect::Focus(CheckField::Measured.into())];
        }
        let Some(action) = self.on_enter(field) else { return Vec::new() };
        if self.answers().contains(&action) && self.asking.is_in_passing(now) {
            return Vec::new();
        }
        if self.repeats(action) {
            self.check.say_repeated();
            return Vec::new();
        }
        let mut effects = action.command(self).map_or_else(Vec::new, |command| self.apply(command, now));
        // What is typed next is the answer to what is asked about the value.
        if field == CheckField::Callout.into() && self.check.question.is_some() {
            effects.push(Effect::Focus(CheckField::Measured.into()));
        }
        effects
    }

    /// The verdict has been read: the next value is asked for.
    pub(super) fn go_on(&mut self) -> Vec<Effect> {
        if self.shared.page == Page::Parts { self.parts.go_on() } else { self.check.go_on(&self.shared.sources) }
    }

    /// Chooses whom the window is for. An operator begins in the field that is asked for.
    pub(super) fn set_mode(&mut self, mode: Mode) -> Vec<Effect> {
        self.shared.set_mode(mode);
        let field = if self.check.asked.limits.is_some() { CheckField::Measured } else { CheckField::Callout };
        let begins = self.is_for_operators() && self.page() == Page::Check;
        if begins { vec![Effect::Focus(field.into())] } else { Vec::new() }
    }

    /// Whether Enter would answer something: a question, or a verdict that has to be read.
    pub(super) fn asks_for_enter(&self) -> bool {
        !self.answers().is_empty() || self.is_for_operators() && self.rests()
    }

    /// A value that an operator has typed and not judged: Undo takes that back first.
    pub(super) fn half_typed(&self) -> Option<Field> {
        let field = match self.page() {
            Page::Parts => WalkField::Value.into(),
            Page::Check if !self.check.would_repeat() => CheckField::Measured.into(),
            _ => return None,
        };
        (self.is_for_operators() && !self.text(field).trim().is_empty()).then_some(field)
    }

    /// Whether a verdict stands on screen, and Enter goes on from it.
    pub fn rests(&self) -> bool {
        match self.page() {
            Page::Parts => self.parts.walking.rests(),
            Page::Check => self.check.would_repeat(),
            _ => false,
        }
    }
}
