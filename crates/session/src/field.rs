//! The text fields of all pages, and the texts in them: one text per field, read anew at every change.

use std::collections::BTreeMap;
use std::ops;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::probing::cycle;

use super::Session;
use super::budget::{BudgetCommand, BudgetField};
use super::check::{CheckCommand, CheckField};
use super::command::Command;
use super::cycles::{CycleField, CyclesCommand, WorkpieceField};
use super::fit::{FitCommand, FitField};
use super::pairing::{PairingCommand, PairingField};
use super::parts::{PartsCommand, PartsField, PlanCommand, PlanField};
use super::program::{ProgramCommand, ProgramField};
use super::records::{RecordsCommand, RecordsField};
use super::tables::{TablesCommand, TablesField};
use super::workpiece::WorkpieceCommand;

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
    /// One of the parts page.
    Parts(PartsField),
    /// A text of the plan on that page.
    Plan(PlanField),
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
            Self::Parts(field) => PartsCommand::Type(field, text).into(),
            Self::Plan(field) => PartsCommand::Plan(PlanCommand::Type(field, text)).into(),
            Self::Records(field) => RecordsCommand::Type(field, text).into(),
            Self::Workpiece(field) => WorkpieceCommand::Type(field, text).into(),
        }
    }
}

from_variants!(Field: Check(CheckField), Fit(FitField), Cycles(CycleField), Tables(TablesField));
from_variants!(Field: Pairing(PairingField), Budget(BudgetField), Records(RecordsField), Parts(PartsField));
from_variants!(Field: Program(ProgramField), Plan(PlanField), Workpiece(WorkpieceField));

impl Session {
    pub fn text(&self, field: impl Into<Field>) -> &str {
        match field.into() {
            Field::Check(field) => self.check.text(field),
            Field::Fit(field) => self.fit.text(field),
            Field::Cycles(field) => self.cycles.text(field),
            Field::Tables(field) => self.tables.text(field),
            Field::Program(field) => self.program.text(field),
            Field::Pairing(field) => self.pairing.text(field),
            Field::Budget(field) => self.budget.text(field),
            Field::Parts(field) => self.parts.text(field),
            Field::Plan(field) => self.parts.plan_text(field),
            Field::Records(field) => self.records.text(field),
            Field::Workpiece(field) => self.shared.workpiece.form.text(field),
        }
    }

    /// What is wrong with a field.
    pub fn error(&self, field: impl Into<Field>) -> Option<&Message> {
        match field.into() {
            Field::Check(field) => self.check.error(field),
            Field::Fit(field) => self.fit.error(field),
            Field::Cycles(field) => self.cycles.error(field),
            Field::Tables(field) => self.tables.error(field),
            Field::Program(field) => self.program.error(field),
            Field::Pairing(field) => self.pairing.error(field),
            Field::Budget(field) => self.budget.error(field),
            Field::Parts(field) => self.parts.error(field),
            Field::Plan(PlanField::Head(field)) => self.parts.document().head_error(field),
            Field::Plan(PlanField::Cell) => None,
            Field::Records(field) => self.records.error(field),
            Field::Workpiece(field) => self.shared.workpiece.form.error(field),
        }
    }

    /// Whether a field holds a name or words, and no figures: then a point is a sign like any other.
    pub fn is_free_text(&self, field: impl Into<Field>) -> bool {
        match field.into() {
            Field::Check(field) => {
                use CheckField::{HistoryFilter, Part, Remark, Serial};
                matches!(field, Part | Serial | Remark | HistoryFilter)
            }
            // A tool may be called by its name.
            Field::Cycles(CycleField::Parameter(key)) => {
                let parameter = self.cycles.cycle().parameter(key);
                parameter.is_some_and(|parameter| parameter.range == cycle::Range::Tool)
            }
            Field::Tables(field) => field == TablesField::Filter,
            Field::Program(ProgramField::Tool(parameter)) => parameter.family.is_text(),
            Field::Program(field) => matches!(field, ProgramField::Filter | ProgramField::Name | ProgramField::Value),
            // Two points stand between two clearances.
            Field::Pairing(field) => field == PairingField::Wanted,
            Field::Records(field) => field != RecordsField::Measured,
            Field::Parts(field) => field != PartsField::Value,
            // A callout, a name and a place are typed into the same field.
            Field::Plan(_) => true,
            Field::Cycles(_) | Field::Fit(_) | Field::Budget(_) | Field::Workpiece(_) => false,
        }
    }

    /// Where in a field's text an error shows: characters counted from 0.
    pub fn culprit(&self, field: impl Into<Field>) -> Option<&ops::Range<usize>> {
        match field.into() {
            Field::Check(field) => self.check.culprit(field),
            Field::Fit(field) => self.fit.culprit(field),
            Field::Records(field) => self.records.culprit(field),
            Field::Cycles(_)
            | Field::Tables(_)
            | Field::Program(_)
            | Field::Pairing(_)
            | Field::Budget(_)
            | Field::Parts(_)
            | Field::Plan(_)
            | Field::Workpiece(_) => None,
        }
    }
}

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

        impl $crate::field::KeptField for $name {
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
    text.parse().map_err(|_not_whole| message!("field-not-whole").text("given", text))
}

/// What a field's length may be, within the control's ±99999.9999 mm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Range {
    /// Of either sign.
    Any,
    /// Not below zero.
    ZeroOrMore,
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
        let outside = |id| Err(Message::new(id).number("given", value).number("limit", largest));
        match self {
            Self::ZeroOrMore if value < Length::ZERO => outside("field-not-negative"),
            Self::AboveZero if value <= Length::ZERO => outside("field-above-zero"),
            _ if largest < value.abs() => outside("field-range"),
            _ => Ok(value),
        }
    }
}
