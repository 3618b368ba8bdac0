//! What can be done on the budget page.

use std::sync::Arc;

use fitcheck_exchange::journal::Record;

use super::{BudgetCommand, UseOf};
use crate::Session;
use crate::action::possible::has_history;
use crate::action::row::{ActionRow, Actions, Sends, actions, on};
use crate::action::{ActionScope, Shortcut};
use crate::command::Command;
use crate::page::Page;
use crate::purpose::Purpose;

actions! {
    /// What can be done on the budget page.
    BudgetAction

    /// Begins a new uncertainty budget.
    NewBudget;
    /// Reads a budget.
    OpenBudget;
    /// Writes the budget.
    SaveBudget;
    /// Checks use the budget.
    UseBudget;
    /// Checks use no budget any more.
    LeaveBudget;
    /// Evaluates the budget for the contacts of the check that is shown on the check page.
    ContactsOfCheck;
    /// Evaluates the budget for the recorded contacts.
    ContactsRecorded;
    /// Evaluates the budget for its own contacts, or those of the fields.
    OwnContacts;
    /// Reads readings of a calibrated piece.
    OpenReadings;
    /// Takes the checks of the history as readings.
    TakeReadings;
    /// Takes the readings of the budget.
    OwnReadings;
}

impl Actions for BudgetAction {
    fn row(&self) -> ActionRow {
        match *self {
            Self::NewBudget => of_page("budget-page-new", BudgetCommand::New).key(Shortcut::ctrl('N')),
            Self::OpenBudget => opening("budget-page-open", Purpose::OpenBudget).key(Shortcut::ctrl('O')),
            Self::SaveBudget => opening("budget-page-save", Purpose::SaveBudget)
                .key(Shortcut::ctrl('S'))
                .when(|session| !session.budget().document.text.is_empty()),
            Self::UseBudget => of_page("budget-page-use", BudgetCommand::Use).when(can_use_budget),
            Self::LeaveBudget => {
                of_page("budget-page-leave", BudgetCommand::Leave).when(|session| session.used_budget().is_some())
            }
            Self::ContactsOfCheck => ActionRow::new(
                ActionScope::Page(Page::Budget),
                "budget-page-take-check",
                Sends::FromState(contacts_taken),
            )
            .when(|session| checked_contacts(session).is_some()),
            Self::ContactsRecorded => of_page("budget-page-take-recorded", BudgetCommand::TakeRecorded)
                .when(|session| session.recorded().is_some()),
            Self::OwnContacts => of_page("budget-page-own-contacts", BudgetCommand::OwnContacts)
                .when(|session| session.budget().contacts.is_some()),
            Self::OpenReadings => opening("budget-page-open-readings", Purpose::OpenReadings)
                .when(|session| session.budget().asks.readings),
            Self::TakeReadings => of_page("budget-page-take-readings", BudgetCommand::TakeRecords)
                .when(|session| session.budget().asks.readings && has_history(session)),
            Self::OwnReadings => of_page("budget-page-own-readings", BudgetCommand::OwnReadings)
                .when(|session| session.budget().readings.is_some()),
        }
    }
}

fn of_page(text: &'static str, command: BudgetCommand) -> ActionRow {
    on(Page::Budget, text, command)
}

fn opening(text: &'static str, purpose: Purpose) -> ActionRow {
    on(Page::Budget, text, Command::OpenDialog(purpose))
}

/// Whether checks can use the budget on the page, and do not use it yet.
fn can_use_budget(session: &Session) -> bool {
    let budget = session.budget();
    budget.can_be_used() && budget.use_of(session.used_budget()) != UseOf::This
}

/// The check that is shown, where its contacts are known.
fn checked_contacts(session: &Session) -> Option<&Arc<Record>> {
    let shown = session.check().shown.as_ref().map(|shown| &shown.record);
    shown.filter(|record| !record.measurement.contacts.is_empty())
}

fn contacts_taken(session: &Session) -> Command {
    // Without one there is nothing to take, and the action is not possible.
    checked_contacts(session)
        .map_or(BudgetCommand::OwnContacts, |record| BudgetCommand::TakeContacts(Arc::clone(record)))
        .into()
}
