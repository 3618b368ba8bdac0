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
    /// The name of the budget.
    HeadName: "budget-head-name", "";
    /// Who made it.
    HeadBy: "budget-head-by", "";
    /// The name of the contribution that is open in the table.
    RowName: "budget-row-name", "";
    /// The figure of its uncertainty, in the unit of its kind.
    RowValue: "budget-row-value", "";
    /// The factor of its expanded uncertainty.
    RowCoverage: "budget-row-k", "";
    /// The expansion per kelvin by which a temperature counts.
    RowAlpha: "budget-row-alpha", "";
    /// How far the temperature is from 20 °C, K, by which an expansion counts.
    RowDelta: "budget-row-delta", "";
    /// How many contacts, by which the scatter of a touch counts.
    RowTouches: "budget-row-touches", "";
    /// The angle from one contact to the next, degrees.
    RowStep: "budget-row-step", "";
    /// By what it is multiplied; empty is 1.
    RowSensitivity: "budget-row-sensitivity", "";
    /// Its degrees of freedom; empty is infinite.
    RowFreedom: "budget-row-freedom", "";
}

impl BudgetField {
    /// The fields of the budget as a whole, which write into its text, each with its key.
    pub const OF_HEAD: [(Self, &str); 2] = [(Self::HeadName, "name"), (Self::HeadBy, "by")];

    /// The key of the budget as a whole that it writes.
    pub(super) fn head_key(self) -> Option<&'static str> {
        Self::OF_HEAD.into_iter().find(|(field, _)| *field == self).map(|(_, key)| key)
    }

    /// The fields of the contribution that is open in the table.
    pub const OF_ROW: [Self; 9] = [
        Self::RowName,
        Self::RowValue,
        Self::RowCoverage,
        Self::RowAlpha,
        Self::RowDelta,
        Self::RowTouches,
        Self::RowStep,
        Self::RowSensitivity,
        Self::RowFreedom,
    ];

    /// Whether its text survives a restart: contacts and a day that were tried out would be forgotten in the fields.
    pub(super) fn is_kept(key: &str) -> bool {
        use crate::texts::KeptField as _;
        key == Self::Size.declared().0
    }
}
