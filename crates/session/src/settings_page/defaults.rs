//! What a first start has, and the commands that lead back to it.

use super::{Control, SETTINGS, Section, Setting};
use crate::Session;
use crate::action::Action;
use crate::command::Command;
use crate::field::Field;
use crate::texts::KeptField as _;
use crate::zoom::Zoom;

impl Session {
    /// What leads back to the defaults of a section; nothing where it has them.
    pub(crate) fn commands_to_defaults(&self, section: Section) -> Vec<Command> {
        let settings = SETTINGS.iter().filter(|setting| setting.section == section);
        settings.filter_map(|setting| to_default(self, setting)).collect()
    }
}

impl Section {
    /// Whether it has anything with a default.
    pub fn has_defaults(self) -> bool {
        let has_default = |control: Control| match control {
            Control::OneOf(_, first) => first.is_some(),
            Control::Switch(_) | Control::Zoom | Control::Field(Field::Check(_), ..) => true,
            Control::Buttons(..)
            | Control::Ruler
            | Control::Field(..)
            | Control::Who
            | Control::Gauge(_)
            | Control::Port(_)
            | Control::Told(_) => false,
        };
        SETTINGS.iter().any(|setting| setting.section == self && has_default(setting.control))
    }
}

fn to_default(session: &Session, setting: &Setting) -> Option<Command> {
    let chosen = |action: &Action| action.is_on(session) == Some(true);
    match setting.control {
        Control::OneOf(_, first) => first.filter(|first| !chosen(first))?.command(session),
        Control::Switch(action) if chosen(&action) => action.command(session),
        Control::Field(Field::Check(field), ..) => {
            let first = field.declared().1;
            let field = Field::Check(field);
            (session.text(field) != first).then(|| field.typed(first.to_owned()))
        }
        Control::Zoom => (session.zoom() != Zoom::NORMAL).then_some(Command::SetZoom(Zoom::NORMAL)),
        // Files, names and addresses are the user's: nothing takes them away in passing.
        Control::Switch(_)
        | Control::Buttons(..)
        | Control::Ruler
        | Control::Field(..)
        | Control::Who
        | Control::Gauge(_)
        | Control::Port(_)
        | Control::Told(_) => None,
    }
}
