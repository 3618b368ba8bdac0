//! The budget that checks use.

use fitcheck_core::budget::Budget;
use fitcheck_exchange::journal::chain::Hash;

/// A budget whose uncertainty checks may use.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenBudget {
    /// Its file's name without the folder.
    pub file: String,
    pub budget: Budget,
    /// SHA-256 of the file, where it holds this budget.
    pub sha256: Option<Hash>,
}
