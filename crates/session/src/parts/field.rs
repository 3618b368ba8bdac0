//! The text fields of the parts page.

use fitcheck_core::part::HeadField;

use crate::texts::kept_fields;

/// A text field of the parts page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PartsField {
    Walk(WalkField),
    Plan(PlanField),
}

kept_fields! {
    /// A text field of the walk through a part.
    WalkField

    /// The serial number of the part that is measured.
    Serial: "parts-serial", "";
    /// The value of the feature that is asked for.
    Value: "parts-value", "";
    /// Why a feature is left out.
    Reason: "parts-reason", "";
    /// Why a rule of a control chart has fired.
    Cause: "parts-cause", "";
    /// What was done about it.
    Action: "parts-action", "";
}

/// A text of the plan: it is in the draft, and nowhere else.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PlanField {
    /// The cell at which the keys are.
    Cell,
    /// A field of the part.
    Head(HeadField),
}
