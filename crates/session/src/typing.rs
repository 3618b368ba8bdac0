//! What stands in text fields, what is wrong there, and what typing sends.

use std::ops;

use fitcheck_core::message::Message;

use super::Session;
use super::command::Command;
use super::field::Field;
use super::page::pages;
use super::state::PageState;
use super::workpiece::WorkpieceCommand;

macro_rules! typing {
    ($($(#[$doc:meta])* $page:ident: $folder:ident, $State:ident, $Command:ident, $Field:ident, $Action:ident, $name:literal, $manual:literal;)+) => {
        impl Field {
            /// The command that replaces the field's text.
            pub fn typed(self, text: String) -> Command {
                match self {
                    $(Self::$page(field) => super::$folder::$Command::Type(field, text).into(),)+
                    Self::Workpiece(field) => WorkpieceCommand::Type(field, text).into(),
                }
            }
        }

        impl Session {
            pub fn text(&self, field: impl Into<Field>) -> &str {
                match field.into() {
                    $(Field::$page(field) => self.$folder.text(field),)+
                    Field::Workpiece(field) => self.shared.workpiece.form.text(field),
                }
            }

            /// What is wrong with a field.
            pub fn error(&self, field: impl Into<Field>) -> Option<&Message> {
                match field.into() {
                    $(Field::$page(field) => self.$folder.error(field),)+
                    Field::Workpiece(field) => self.shared.workpiece.form.error(field),
                }
            }

            /// Whether a field holds a name or words, and no figures: then a point is a sign like any other.
            pub fn is_free_text(&self, field: impl Into<Field>) -> bool {
                match field.into() {
                    $(Field::$page(field) => self.$folder.is_free_text(field),)+
                    Field::Workpiece(_) => false,
                }
            }

            /// Where in a field's text an error shows: characters counted from 0.
            pub fn culprit(&self, field: impl Into<Field>) -> Option<&ops::Range<usize>> {
                match field.into() {
                    $(Field::$page(field) => self.$folder.culprit(field),)+
                    Field::Workpiece(_) => None,
                }
            }
        }
    };
}

pages!(typing);
