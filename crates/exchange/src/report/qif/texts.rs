//! How QIF writes a time, a length and the kind of a characteristic.

use fitcheck_core::length::Length;
use jiff::civil::DateTime;

use crate::report::given::Quantity;
use crate::row::Millimetres;

/// A date and time to the second, as XML has it.
pub(super) fn time(time: DateTime) -> String {
    time.strftime("%Y-%m-%dT%H:%M:%S").to_string()
}

/// The kind of a characteristic, as names of elements begin with it.
pub(super) const fn kind(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Diameter => "Diameter",
        Quantity::Width(_) => "Width",
        Quantity::Coordinate | Quantity::Length => "Length",
    }
}

/// Millimetres exactly.
pub(super) fn mm(length: Length) -> String {
    Millimetres(length).text(0)
}
