//! The text fields of the budget page.

use crate::texts::kept_fields;

kept_fields! {
    /// A text field of the budget page.
    BudgetField

    /// The measured size in mm, for contributions of temperature.
    Size: "budget-size", "25";
    /// How many contacts; empty where those of the budget count.
    Touches: "budget-touches", "";
    /// The angle from one contact to the next, degrees.
    Step: "budget-step", "";
    /// The day on which the budget must be valid; empty is today.
    Day: "budget-day", "";
}

impl BudgetField {
    /// Whether its text survives a restart: contacts and a day that were tried out would be forgotten in the fields.
    pub(super) fn is_kept(key: &str) -> bool {
        use crate::texts::KeptField as _;
        key == Self::Size.declared().0
    }
}
