//! What a column of a table can be: the roles that its name or the user gives it.

use fitcheck_core::message::Say;

/// What a column can be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Say)]
#[say(prefix = "exchange-role")]
pub enum Role {
    /// Name of the part or feature.
    Id,
    /// Callout or tolerance class.
    Tolerance,
    /// Nominal size.
    Nominal,
    Measured,
    /// Date, time or both.
    Time,
    /// Whether nobody measured.
    Simulated,
    /// Number of the characteristic.
    Number,
    /// The part, such as its drawing number.
    Part,
    /// The part's serial number.
    Serial,
    /// Who measured.
    Who,
    /// Where the feature is.
    X,
    /// As above.
    Y,
    /// As above.
    Z,
    /// What was measured.
    Quantity,
    /// Upper limit deviation, with its sign.
    Upper,
    /// Lower limit deviation, with its sign.
    Lower,
    /// Lower limit deviation without its minus.
    Minus,
    /// Largest permitted size.
    Maximum,
    /// Smallest permitted size.
    Minimum,
    /// Hole or shaft.
    Kind,
    /// The unit of the row.
    Units,
    /// What somebody or something else decided.
    Status,
    /// The machine that made the part.
    Machine,
    /// The batch.
    Batch,
    /// A measured value beside others of its row: each is of another part, or is a repeat.
    Sample,
}
