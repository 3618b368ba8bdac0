//! The text fields of the pairing page.

use crate::texts::kept_fields;

kept_fields! {
    /// A text field of the pairing page.
    PairingField

    /// Wanted clearances in mm, `0.010..0.030`, or a fit, `25 H7/g6`.
    Wanted: "pairing-wanted", "";
    /// Into how many groups the parts are sorted; empty for none.
    Groups: "pairing-groups", "";
}
