//! The text fields of the budget page.

use crate::session::field::kept_fields;

kept_fields! {
    /// A text field of the budget page.
    BudgetField

    /// The measured size in mm, for contributions of temperature.
    Size: "budget-size", "25";
}
