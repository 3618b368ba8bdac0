//! The text fields of the records page, and the field for another name.

/// A text field of the records page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum RecordsField {
    /// Which records are listed, in the language of questions.
    Question,
    /// What another filter asks for.
    Filter,
    /// The name of who measures from now on; in the top bar of every page.
    Who,
    /// The address of the server of the shop.
    Server,
    /// Why a record is corrected.
    Reason,
    /// The part that it should have.
    Part,
    /// The serial number that it should have.
    Serial,
    /// The feature that it should have.
    Feature,
    /// Who measured.
    Measurer,
    /// The remark that it should have.
    Remark,
    /// The typed value that it should have, mm.
    Measured,
    /// The callout that it should have.
    Callout,
}
