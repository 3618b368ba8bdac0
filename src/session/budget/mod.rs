//! The budget page: how sure a measured value is, and what would help most.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `field` | the text fields |
//! | `command`, `apply` | what can be done, and doing it |

mod apply;
mod command;
mod field;

use std::collections::BTreeMap;

pub use command::BudgetCommand;
pub use field::BudgetField;

use super::field::Texts;
use super::saved::SavedInputs;
use crate::budget::Budget;
use crate::message::Message;

/// A budget whose uncertainty checks may use.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenBudget {
    /// Its file's name without the folder.
    pub file: String,
    /// The budget.
    pub budget: Budget,
}

/// The state of the budget page.
#[derive(Debug, Default)]
pub struct BudgetPage {
    texts: Texts<BudgetField>,
    errors: BTreeMap<BudgetField, Message>,
}

impl BudgetPage {
    /// The page with what was saved, or with empty fields.
    pub(super) fn new(saved: &SavedInputs) -> Self {
        Self { texts: Texts::restored(&saved.texts), ..Self::default() }
    }

    pub(super) fn texts(&self) -> impl Iterator<Item = (String, String)> {
        self.texts.saved()
    }

    /// The text of a field.
    pub fn text(&self, field: BudgetField) -> &str {
        self.texts.text(field)
    }

    /// What is wrong with a field.
    pub fn error(&self, field: BudgetField) -> Option<&Message> {
        self.errors.get(&field)
    }
}
