//! The text fields of all pages, and the texts in them: one text per field, read anew at every change.

use std::collections::BTreeMap;

use super::budget::{BudgetCommand, BudgetField};
use super::check::{CheckCommand, CheckField};
use super::command::Command;
use super::cycles::{CycleField, CyclesCommand, WorkpieceField};
use super::fit::{FitCommand, FitField};
use super::pairing::{PairingCommand, PairingField};
use super::program::{ProgramCommand, ProgramField};
use super::records::{RecordsCommand, RecordsField};
use super::tables::{TablesCommand, TablesField};
use super::workpiece::WorkpieceCommand;
use crate::length::Length;
use crate::message::{Message, Say as _};

/// A text field of the window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Field {
    /// One of the check page.
    Check(CheckField),
    /// One of the fit page.
    Fit(FitField),
    /// One of the cycles page.
    Cycles(CycleField),
    /// One of the table page.
    Tables(TablesField),
    /// One of the program page.
    Program(ProgramField),
    /// One of the pairing page.
    Pairing(PairingField),
    /// One of the budget page.
    Budget(BudgetField),
    /// One of the records page.
    Records(RecordsField),
    /// A figure of the simulated workpiece, which the cycles page and the program page share.
    Workpiece(WorkpieceField),
}

impl Field {
    /// The command that replaces the field's text.
    pub fn typed(self, text: String) -> Command {
        match self {
            Self::Check(field) => CheckCommand::Type(field, text).into(),
            Self::Fit(field) => FitCommand::Type(field, text).into(),
            Self::Cycles(field) => CyclesCommand::Type(field, text).into(),
            Self::Tables(field) => TablesCommand::Type(field, text).into(),
            Self::Program(field) => ProgramCommand::Type(field, text).into(),
            Self::Pairing(field) => PairingCommand::Type(field, text).into(),
            Self::Budget(field) => BudgetCommand::Type(field, text).into(),
            Self::Records(field) => RecordsCommand::Type(field, text).into(),
            Self::Workpiece(field) => WorkpieceCommand::Type(field, text).into(),
        }
    }
}

from_variants!(Field: Check(CheckField), Fit(FitField), Cycles(CycleField), Tables(TablesField));
from_variants!(Field: Pairing(PairingField), Budget(BudgetField), Records(RecordsField));
from_variants!(Field: Program(ProgramField), Workpiece(WorkpieceField));

/// The fields of a page whose texts survive a restart.
pub(super) trait KeptField: Copy + Ord + 'static {
    /// Every field in reading order.
    const ALL: &'static [Self];

    /// Its key in the state file, and its text at the first start.
    fn declared(self) -> (&'static str, &'static str);
}

/// The fields of a page whose texts survive a restart, a row each: what it is, its key in the state file, and its text
/// at the first start.
macro_rules! kept_fields {
    ($(#[$doc:meta])* $name:ident $($(#[$field_doc:meta])* $field:ident: $key:literal, $first:literal;)+) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum $name {
            $($(#[$field_doc])* $field,)+
        }

        impl $crate::session::field::KeptField for $name {
            const ALL: &'static [Self] = &[$(Self::$field),+];

            fn declared(self) -> (&'static str, &'static str) {
                match self {
                    $(Self::$field => ($key, $first),)+
                }
            }
        }
    };
}

pub(super) use kept_fields;

/// The texts of a page's fields; a missing one counts as the text of the first start.
#[derive(Debug, Clone)]
pub(super) struct Texts<F> {
    texts: BTreeMap<F, String>,
}

impl<F> Default for Texts<F> {
    fn default() -> Self {
        Self { texts: BTreeMap::new() }
    }
}

impl<F: KeptField> Texts<F> {
    pub fn text(&self, field: F) -> &str {
        self.texts.get(&field).map_or_else(|| field.declared().1, String::as_str)
    }

    pub fn set(&mut self, field: F, text: impl Into<String>) {
        self.texts.insert(field, text.into());
    }

    /// What was put into fields, by their keys in the state file.
    pub fn saved(&self) -> impl Iterator<Item = (String, String)> {
        self.texts.iter().map(|(field, text)| (field.declared().0.to_owned(), text.clone()))
    }

    /// The page's texts from those of a state file.
    pub fn restored(saved: &BTreeMap<String, String>) -> Self {
        let of_field = |field: &F| Some((*field, saved.get(field.declared().0)?.clone()));
        Self { texts: F::ALL.iter().filter_map(of_field).collect() }
    }
}

/// The whole number in a field.
///
/// # Errors
/// What is shown beside the field where its text is not a whole number.
pub(super) fn whole<T: std::str::FromStr>(text: &str) -> Result<T, Message> {
    let text = text.trim();
    text.parse().map_err(|_not_whole| Message::new("field-not-whole").text("given", text))
}

/// What a field's length may be, within the control's ±99999.9999 mm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Range {
    /// Of either sign.
    Any,
    /// Not below zero.
    ZeroOrMore,
    /// Above zero.
    AboveZero,
}

impl Range {
    /// The length in a field.
    ///
    /// # Errors
    /// What is shown beside the field where its text is not a length, or is one outside the range.
    pub(super) fn read(self, text: &str) -> Result<Length, Message> {
        let value = text.parse::<Length>().map_err(|error| error.message())?;
        let largest = Length::from_nanometres(99_999_999_900).unwrap_or_default();
        let outside = |id| Err(Message::new(id).mm("given", value).mm("limit", largest));
        match self {
            Self::ZeroOrMore if value < Length::ZERO => outside("field-not-negative"),
            Self::AboveZero if value <= Length::ZERO => outside("field-above-zero"),
            _ if largest < value.abs() => outside("field-range"),
            _ => Ok(value),
        }
    }
}
