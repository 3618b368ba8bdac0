//! The text fields of the parts page.

use fitcheck_core::part::HeadField;

use crate::field::kept_fields;

kept_fields! {
    /// A text field of the parts page.
    PartsField

    /// The serial number of the part that is measured.
    Serial: "parts-serial", "";
    /// The value of the feature that is asked for.
    Value: "parts-value", "";
    /// Why a feature is left out.
    Reason: "parts-reason", "";
}

/// A text of the plan: it is in the draft, and nowhere else.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PlanField {
    /// The cell at which the keys are.
    Cell,
    /// A field of the part.
    Head(HeadField),
}
