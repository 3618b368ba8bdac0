//! The rows of the budget page in the table of actions.

use std::sync::Arc;

use fitcheck_exchange::journal::Record;

use super::possible::has_history;
use super::row::{Row, Sends, on};
use super::{Place, Shortcut};
use crate::budget::UseOf;
use crate::{BudgetCommand, Command, Page, Purpose, Session};

fn of_page(text: &'static str, command: BudgetCommand) -> Row {
    on(Page::Budget, text, command)
}

fn opening(text: &'static str, purpose: Purpose) -> Row {
    on(Page::Budget, text, Command::OpenDialog(purpose))
}

pub(super) fn begin() -> Row {
    of_page("budget-page-new", BudgetCommand::New).key(Shortcut::ctrl('N'))
}

pub(super) fn open() -> Row {
    opening("budget-page-open", Purpose::OpenBudget).key(Shortcut::ctrl('O'))
}

pub(super) fn save() -> Row {
    opening("budget-page-save", Purpose::SaveBudget)
        .key(Shortcut::ctrl('S'))
        .when(|session| !session.budget().toml().is_empty())
}

pub(super) fn use_it() -> Row {
    of_page("budget-page-use", BudgetCommand::Use).when(can_use_budget)
}

pub(super) fn leave() -> Row {
    of_page("budget-page-leave", BudgetCommand::Leave).when(|session| session.used_budget().is_some())
}

pub(super) fn contacts_of_check() -> Row {
    Row::new(Place::Page(Page::Budget), "budget-page-take-check", Sends::FromState(contacts_taken))
        .when(|session| checked_contacts(session).is_some())
}

pub(super) fn contacts_recorded() -> Row {
    of_page("budget-page-take-recorded", BudgetCommand::TakeRecorded).when(|session| session.recorded().is_some())
}

pub(super) fn own_contacts() -> Row {
    of_page("budget-page-own-contacts", BudgetCommand::OwnContacts)
        .when(|session| session.budget().contacts().is_some())
}

pub(super) fn open_readings() -> Row {
    opening("budget-page-open-readings", Purpose::OpenReadings).when(|session| session.budget().asks().readings)
}

pub(super) fn take_readings() -> Row {
    of_page("budget-page-take-readings", BudgetCommand::TakeRecords)
        .when(|session| session.budget().asks().readings && has_history(session))
}

pub(super) fn own_readings() -> Row {
    of_page("budget-page-own-readings", BudgetCommand::OwnReadings)
        .when(|session| session.budget().readings().is_some())
}

/// Whether checks can use the budget on the page, and do not use it yet.
fn can_use_budget(session: &Session) -> bool {
    let budget = session.budget();
    budget.can_be_used() && budget.use_of(session.used_budget()) != UseOf::This
}

/// The check that is shown, where its contacts are known.
fn checked_contacts(session: &Session) -> Option<&Arc<Record>> {
    let shown = session.check().shown().map(|shown| &shown.record);
    shown.filter(|record| !record.measurement.contacts.is_empty())
}

fn contacts_taken(session: &Session) -> Command {
    // Without one there is nothing to take, and the action is not possible.
    checked_contacts(session)
        .map_or(BudgetCommand::OwnContacts, |record| BudgetCommand::TakeContacts(Arc::clone(record)))
        .into()
}
