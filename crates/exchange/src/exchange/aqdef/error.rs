//! What is wrong with a file of AQDEF, and what is said of one that was read.

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::message::{Message, Say};
use fitcheck_core::tolerance::{Callout, Feature};

/// What is wrong with a line or a file.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "aqdef", error)]
pub enum AqdefFault {
    /// A line that is neither an entry nor values.
    Line,
    /// An entry whose number cannot be read.
    Number {
        /// The key, such as `K2110`.
        key: String,
        /// What is wrong with the number.
        reason: LengthError,
    },
    /// An entry that is not a whole number.
    Whole {
        /// The key, such as `K2009`.
        key: String,
        given: String,
    },
    /// A value of a characteristic that the file does not declare.
    Undeclared {
        /// The number of the characteristic.
        number: u32,
    },
    /// A value for all characteristics.
    OfAll { key: String },
    /// A value that ends the file without a line end.
    CutOff {
        /// What is left of it.
        given: String,
    },
    /// A line with bytes 0 in it.
    Zeros,
    /// An attribute for all values, between two rows.
    MarkBetween {
        /// The attribute.
        given: String,
    },
    /// An entry of a characteristic that stands twice with different texts.
    Twice { key: String, other: String },
    /// A value with more fields than there are.
    Fields {
        /// How many it has.
        found: usize,
        /// How many there are.
        most: usize,
    },
    /// Characteristics without a value: a plan.
    NoValues {
        /// How many characteristics.
        count: usize,
    },
    /// The same, and no values in a file beside it.
    NoValuesBeside {
        /// How many characteristics.
        count: usize,
        /// The file that would have them.
        file: String,
        /// The largest one that is looked for, MiB.
        most: u64,
    },
    /// Values without the file that declares their characteristics.
    NoDescription {
        /// The file that should be beside it.
        file: String,
    },
    /// Fewer or more characteristics than the file announces.
    Count {
        /// How many it announces.
        expected: u32,
        /// How many it declares.
        found: usize,
    },
    /// Characteristics that take too much memory.
    TooLarge {
        /// The most, MiB.
        most: usize,
    },
    /// Something in the file beside this one.
    Beside {
        /// The name of that file.
        file: String,
        line: usize,
        /// What is wrong there.
        reason: Message,
    },
}

/// What is said of a file that was read.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "aqdef-warning")]
pub enum AqdefWarning {
    /// Fewer or more characteristics than the file announces.
    Count {
        /// How many it announces.
        expected: u32,
        /// How many it declares.
        found: usize,
    },
    /// A part with fewer values than characteristics.
    Fewer {
        /// How many values.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// Values marked as missing, or empty.
    Missing {
        /// How many.
        count: usize,
    },
    /// Entries that are not used.
    Skipped {
        /// Their keys.
        keys: String,
    },
    /// An entry that stands twice with different texts: the last one counts.
    Repeated { key: String },
    /// An entry of a value that is not the one before it.
    Late { key: String },
    /// Limits and allowances contradict each other: the limits count.
    Allowance {
        /// What the nominal size and the allowance make.
        limit: Length,
    },
    /// The width of the zone as a number, and the limits have another one: the limits count.
    Tolerance {
        /// The key of the number.
        key: String,
        given: Length,
        /// What the limits make.
        expected: Length,
    },
    /// A limit that the file says to be none.
    NoLimit {
        /// The key of the limit.
        key: String,
    },
    /// A kind of limit that is not known, taken for a limit.
    KindOfLimit { given: String },
    /// A scrap limit that is not the limit: it is not used.
    ScrapLimit {
        /// The scrap limit.
        limit: Length,
    },
    /// A scrap limit of a hole at a shaft, or the other way round: the tolerance class counts.
    ScrapFeature {
        callout: Callout,
        /// What the scrap limit says.
        feature: Feature,
    },
    /// The values are those of the file beside this one.
    ValuesBeside {
        /// Its name.
        file: String,
    },
    /// The characteristics are those of the file beside this one.
    DescriptionBeside {
        /// Its name.
        file: String,
    },
    /// What ends the file is shorter than the others of its kind.
    CutOff {
        /// What is left of it.
        given: String,
    },
    /// A line of bytes 0 alone.
    Zeros,
    /// Values in the file of characteristics beside this one, which are not read.
    ValuesLeft {
        file: String,
        /// How many lines.
        count: usize,
    },
    /// Something in the file beside this one.
    Beside {
        /// The name of that file.
        file: String,
        line: usize,
        reason: Message,
        /// As it stands against the answers by itself.
        #[say(skip)]
        stands_against: bool,
    },
}

impl AqdefWarning {
    /// Whether values of the file are not read.
    pub const fn is_loss(&self) -> bool {
        matches!(
            self,
            Self::Fewer { .. } | Self::Late { .. } | Self::CutOff { .. } | Self::ValuesLeft { .. } | Self::Zeros
        )
    }
    /// As [`ImportWarningKind::stands_against`](crate::exchange::ImportWarningKind::stands_against).
    pub const fn stands_against(&self) -> bool {
        match self {
            Self::Count { .. }
            | Self::Fewer { .. }
            | Self::Missing { .. }
            | Self::Repeated { .. }
            | Self::Late { .. }
            | Self::Allowance { .. }
            | Self::Tolerance { .. }
            | Self::NoLimit { .. }
            | Self::ScrapLimit { .. }
            | Self::ScrapFeature { .. }
            | Self::CutOff { .. }
            | Self::Zeros
            | Self::ValuesLeft { .. } => true,
            Self::Skipped { .. }
            | Self::KindOfLimit { .. }
            | Self::ValuesBeside { .. }
            | Self::DescriptionBeside { .. } => false,
            Self::Beside { stands_against, .. } => *stands_against,
        }
    }
}
