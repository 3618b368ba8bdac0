//! What can be done on the budget page.

use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::budget::{Evaluated, Law};
use fitcheck_core::message::Message;
use fitcheck_exchange::journal::Record;

use super::{BothSizes, BudgetField, BudgetView, GivenAs, KindChoice};

/// What can be done on the budget page.
#[derive(Debug, Clone)]
pub enum BudgetCommand {
    /// Replaces the text of a field.
    Type(BudgetField, String),
    /// Replaces the text of the budget.
    Edit(String),
    /// Shows the budget as a table or as text.
    Show(BudgetView),
    /// Opens a contribution in the table, or closes it.
    Choose(Option<usize>),
    /// Adds a contribution behind the last one.
    Add,
    /// Removes the contribution that is open.
    Remove,
    /// Says what it does to the diameter.
    SetKind(KindChoice),
    /// Says the law of its values.
    SetLaw(Law),
    /// Says how it was evaluated.
    SetType(Evaluated),
    /// Says how its uncertainty is given, where the law is normal.
    Give(GivenAs),
    /// Begins a new budget.
    New,
    /// A file of a budget was read, or not.
    Read { path: PathBuf, result: Result<String, Message> },
    /// The budget that checks used the last time was read, or not.
    UsedRead { path: PathBuf, result: Result<String, Message> },
    /// Evaluates for the contacts of a check.
    TakeContacts(Arc<Record>),
    /// Evaluates for the recorded contacts.
    TakeRecorded,
    /// Evaluates for the contacts of the fields or of the budget again.
    OwnContacts,
    /// A file of readings was read, or not.
    ReadingsRead {
        /// Its name without the folder.
        name: String,
        /// What it holds.
        result: Result<Box<BothSizes>, Message>,
    },
    /// Takes the checks of the history as readings: those that are chosen, or all.
    TakeRecords,
    /// Takes the readings of the budget again.
    OwnReadings,
    /// Checks use this budget from now on.
    Use,
    /// Checks use no budget any more.
    Leave,
}
