//! Why a callout has no limits.

use std::sync::Arc;

use crate::length::Length;
use crate::message::{Message, Say};
use crate::tolerance::callout::Callout;
use crate::tolerance::class::ToleranceClass;
use crate::tolerance::proportion::ZoneDoubt;
use crate::tolerance::ranges;

/// Why a callout has no limits.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "limits", error)]
pub enum LimitsError {
    /// The standard does not define it, in its own words.
    #[say(transparent)]
    Standard(Message),
    /// No table has the class.
    UnknownClass {
        /// The class that was asked for.
        class: ToleranceClass,
        /// The tables for this kind of feature, by name.
        table: String,
        /// The known classes for this kind of feature.
        known: String,
    },
    /// A name that only an own column can have, and there is no own table.
    NoOwnTable {
        /// The name that was asked for.
        class: ToleranceClass,
    },
    /// A name that only an own column can have, and no own table has it.
    NoOwnColumn {
        /// The name that was asked for.
        class: ToleranceClass,
        /// The own tables, by name.
        table: String,
        /// Their columns for this kind of feature, or for the other one where there are none.
        known: String,
    },
    /// No table has the class, but one has that of the other case: the user may have meant that.
    #[say(args(feature = class.feature()))]
    OtherCase {
        /// The class that was asked for.
        class: ToleranceClass,
        /// The tables for this kind of feature, by name.
        table: String,
        /// The class that the table has.
        other: ToleranceClass,
    },
    /// The size is beyond the table's last range.
    BeyondLastRange {
        /// The size that was asked for.
        nominal: Length,
        /// The table.
        table: Arc<str>,
        /// The last range: above this,
        over: Length,
        /// up to and including this.
        to: Length,
    },
    /// The table's cell is empty.
    #[say(args(where = ranges::message(defined)))]
    NotDefined {
        /// The class that was asked for.
        class: ToleranceClass,
        /// The table.
        table: Arc<str>,
        /// The range: above this,
        over: Length,
        /// up to and including this.
        to: Length,
        /// Where the class is defined, above and up to: joined ranges, ascending.
        #[say(skip)]
        defined: Vec<(Length, Length)>,
    },
    /// A callout without letters does not name hole or shaft, and a fit names both.
    NoFeature {
        /// What was asked for.
        callout: Callout,
    },
    /// The letter's case says hole and a shaft was asked for, or the other way round.
    #[say(args(feature = class.feature()))]
    OtherFeature {
        /// The class that was asked for.
        class: ToleranceClass,
    },
    /// A limit would be beyond what a length can hold.
    TooLarge {
        /// The size that was asked for.
        nominal: Length,
    },
    /// The user's own tables, which come first, are still being read.
    OwnAwaited {
        /// Their folder.
        folder: Arc<str>,
    },
    /// A zone out of all proportion to its size.
    #[say(transparent)]
    Zone(Box<ZoneDoubt>),
}
