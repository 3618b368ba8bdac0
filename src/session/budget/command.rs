//! What can be done on the budget page.

use super::BudgetField;

/// What can be done on the budget page.
#[derive(Debug, Clone)]
pub enum BudgetCommand {
    /// Replaces the text of a field.
    Type(BudgetField, String),
    /// Checks use no budget any more.
    Leave,
}
