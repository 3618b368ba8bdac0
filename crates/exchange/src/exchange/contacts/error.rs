//! Why contacts cannot be read.

use fitcheck_core::message::Say;

use super::MOST_CONTACTS;
use crate::exchange::index::LONGEST_ROW;

/// Why contacts cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "contacts", error)]
pub enum ContactsError {
    /// There is no contact in the file.
    FileEmpty,
    /// The header does not name both x and y.
    NoColumns {
        /// The header.
        given: String,
    },
    /// The header names the same coordinate twice: either could be meant.
    Twice {
        /// x, y or z.
        name: char,
        /// The first of the columns.
        first: usize,
        /// The second.
        second: usize,
    },
    /// A row with more or fewer cells than it should have.
    Cells {
        /// How many there are.
        cells: usize,
        /// How many there should be.
        wanted: usize,
        /// The row.
        given: String,
    },
    /// A cell that is not a number.
    NotANumber {
        /// x, y or z.
        name: char,
        /// What was found.
        given: String,
    },
    /// A decimal sign that is not that of the rows before.
    MixedSigns {
        /// What was found.
        given: String,
    },
    /// A comment that holds coordinates: a circle without them would be a guess.
    Comment,
    /// Contacts that nobody measured.
    Simulated,
    /// A column that says neither measured nor simulated.
    Origin {
        /// What was found.
        given: String,
    },
    /// Another unit than millimetres, in a comment, in a row of units or in a column of them.
    OtherUnit { given: String },
    /// A quotation mark that is not closed.
    OpenQuote,
    #[say(args(most = LONGEST_ROW >> 10))]
    RowTooLong,
    /// More contacts than [`MOST_CONTACTS`].
    #[say(args(most = MOST_CONTACTS))]
    TooMany,
}
