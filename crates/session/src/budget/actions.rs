//! What can be done on the budget page.

use std::sync::Arc;

use fitcheck_core::budget::{Evaluated, KindName, Law};
use fitcheck_exchange::journal::Record;

use super::{BudgetCommand, BudgetForce, BudgetPage, BudgetView, GivenAs, KindChoice, UseOf, WrittenContribution};
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

    /// Shows the budget as a table or as text.
    ShowBudget(BudgetView): BudgetView::ALL;
    /// Adds a contribution.
    AddContribution;
    /// Removes the contribution that is open in the table.
    RemoveContribution;
    /// Says what the open contribution does to the diameter.
    KindOfContribution(KindChoice): KindChoice::all();
    /// Says the law of its values.
    LawOfContribution(Law): Law::ALL;
    /// Says how it was evaluated.
    TypeOfContribution(Evaluated): [Evaluated::A, Evaluated::B];
    /// Says how its uncertainty is given.
    GiveContribution(GivenAs): GivenAs::ALL;
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
            Self::ShowBudget(shows) => {
                let text = match shows {
                    BudgetView::Table => "budget-show-table",
                    BudgetView::Text => "budget-show-text",
                };
                of_page(text, BudgetCommand::Show(shows))
            }
            Self::AddContribution => {
                of_page("budget-row-add", BudgetCommand::Add).when(|session| session.budget().has_table())
            }
            Self::RemoveContribution => of_page("budget-row-remove", BudgetCommand::Remove).when(has_open_row),
            Self::KindOfContribution(KindChoice(kind)) => {
                let text = match kind {
                    None => "budget-kind-plain",
                    Some(KindName::Scatter) => "budget-kind-scatter",
                    Some(KindName::PartTemperature) => "budget-kind-part-temperature",
                    Some(KindName::ScaleTemperature) => "budget-kind-scale-temperature",
                    Some(KindName::PartExpansion) => "budget-kind-part-expansion",
                    Some(KindName::ScaleExpansion) => "budget-kind-scale-expansion",
                    Some(KindName::Resolution) => "budget-kind-resolution",
                };
                of_page(text, BudgetCommand::SetKind(KindChoice(kind))).when(has_open_row)
            }
            Self::LawOfContribution(law) => {
                let text = match law {
                    Law::Normal => "budget-law-normal",
                    Law::Rectangular => "budget-law-rectangular",
                    Law::UShaped => "budget-law-u-shaped",
                    Law::Triangular => "budget-law-triangular",
                };
                of_page(text, BudgetCommand::SetLaw(law)).when(has_law)
            }
            Self::TypeOfContribution(evaluated) => {
                let text = match evaluated {
                    Evaluated::A => "budget-type-a",
                    Evaluated::B => "budget-type-b",
                };
                of_page(text, BudgetCommand::SetType(evaluated)).when(has_open_row)
            }
            Self::GiveContribution(given) => {
                let text = match given {
                    GivenAs::Standard => "budget-given-standard",
                    GivenAs::Expanded => "budget-given-expanded",
                };
                of_page(text, BudgetCommand::Give(given))
                    .when(|session| open_row(session).is_some_and(|row| BudgetPage::given_as(row).is_some()))
            }
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

    fn is_on(&self, session: &Session) -> Option<bool> {
        let row = open_row(session);
        Some(match *self {
            Self::ShowBudget(shows) => session.budget().shows == shows,
            Self::KindOfContribution(KindChoice(kind)) => row.is_some_and(|row| BudgetPage::kind(row) == kind),
            Self::LawOfContribution(law) => row.is_some_and(|row| BudgetPage::law(row) == Some(law)),
            Self::TypeOfContribution(evaluated) => row.is_some_and(|row| BudgetPage::evaluated(row) == Some(evaluated)),
            Self::GiveContribution(given) => row.is_some_and(|row| BudgetPage::given_as(row) == Some(given)),
            _ => return None,
        })
    }
}

/// The contribution that is open in the table, where the table can change it.
fn open_row(session: &Session) -> Option<&WrittenContribution> {
    session.budget().open_row().filter(|_| session.budget().has_table())
}

fn has_open_row(session: &Session) -> bool {
    open_row(session).is_some()
}

/// A step of a display is rectangular.
fn has_law(session: &Session) -> bool {
    open_row(session).is_some_and(|row| BudgetPage::kind(row) != Some(KindName::Resolution))
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
    let is_in_use = budget.use_of(session.used_budget()) == UseOf::This;
    budget.can_be_used() && !(is_in_use && session.budget_force() != BudgetForce::TypedCounts)
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
