//! An entry as the bytes that are hashed and kept: JSON of fixed field order. `docs/JOURNAL.md` has the format.
//!
//! | file | what |
//! |---|---|
//! | here | from an entry to bytes and back, and why not |
//! | `wire` | the fields, in their order |
//! | `write` | an entry as these fields |
//! | `read` | an entry from these fields, each of them bounded and checked |
//! | `alarms` | an alarm as its fields, and from them |
//! | `brief` | what an entry is found by, without reading all of it |
//! | `size` | a record from its fields: its limits, its rule, its verdict as it was given |
//! | `texts` | what texts and numbers may be |
//!
//! Lengths are whole nanometres, uncertainties whole picometres, factors whole thousandths; coordinates of contacts, which are
//! binary fractions, are texts that read back as the very same. So every program reads the same numbers, and none rounds.

mod alarms;
mod brief;
mod read;
mod size;
mod texts;
mod wire;
mod write;

pub use brief::found;
use fitcheck_core::message::{Say, printed, shortened};
use fitcheck_core::verdict::Doubt;
use serde::Deserialize;

use super::entry::{Checked, Content, Entry};

/// The newest version of the format: every version up to it is read.
pub const VERSION: u64 = 6;

/// The longest body, bytes.
pub const LONGEST: usize = 16 << 20;

/// The most contacts of a check.
pub const MOST_CONTACTS: usize = 100_000;

/// The most entries of every other list: files, parameters, results, warnings.
pub const MOST: usize = 1_000;

/// Why bytes are no entry, or an entry cannot be written. A field has its name in the body: `check.size.limits.upper_nm`.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "journal-body", error)]
pub enum BodyError {
    /// Not the JSON of an entry.
    Json {
        /// What the reader says.
        reason: String,
    },
    /// A format of a later version.
    #[say(args(known = VERSION))]
    Newer { version: u64 },
    /// More bytes than any entry has.
    #[say(args(most = LONGEST))]
    TooLarge {
        /// How many.
        #[say(with = printed)]
        bytes: usize,
    },
    TooLong {
        field: &'static str,
        /// How many bytes of UTF-8 it has.
        #[say(with = printed)]
        bytes: usize,
        /// How many it may have.
        #[say(with = printed)]
        most: usize,
    },
    /// A text has a control character.
    Control {
        field: &'static str,
        /// The character as Unicode writes it: `U+000A`.
        code: String,
        /// Which character of the text it is, from 1.
        #[say(with = printed)]
        place: usize,
    },
    /// A text that must not be empty is.
    Empty { field: &'static str },
    /// A list is too long.
    TooMany {
        field: &'static str,
        /// How many it has.
        #[say(with = printed)]
        count: usize,
        /// How many it may have.
        #[say(with = printed)]
        most: usize,
    },
    /// A value that the field cannot have.
    Value { field: &'static str, given: String },
    /// A field says something else than the fields that it follows from.
    Contradiction { field: &'static str },
}

impl BodyError {
    fn json(error: &serde_json::Error) -> Self {
        Self::Json { reason: shortened(&error.to_string(), 200) }
    }

    fn value(field: &'static str, given: impl std::fmt::Display) -> Self {
        Self::Value { field, given: shortened(&given.to_string(), 80) }
    }
}

/// What every body has, whatever its version.
#[derive(Deserialize)]
struct Head {
    v: u64,
}

/// The version that an entry is written as: the smallest that can hold it, so that older versions of Fitcheck read all that they know.
fn version_of(content: &Content) -> u64 {
    match content {
        Content::Alarm(_) => 6,
        Content::Check(check) if is_confirmed(&check.what) => 6,
        Content::Check(check) if is_turned(&check.what) => 5,
        Content::Check(check) if has_datum(&check.what) => 4,
        Content::Check(check) if is_of_third(&check.what) => 3,
        Content::Begin(_) | Content::Check(_) | Content::Withdrawal(_) => 1,
        Content::Report(_) => 2,
    }
}

/// Whether somebody confirmed a value that its plan says cannot be.
fn is_confirmed(what: &Checked) -> bool {
    matches!(what, Checked::Size(record) if matches!(record.doubt, Some(Doubt::Implausible { .. })))
}

/// Whether a size is neither a hole nor a shaft, or its callout says more than size and tolerance.
fn is_of_third(what: &Checked) -> bool {
    let Checked::Size(record) = what else { return false };
    record.limits.feature.is_none() || record.callout.is_some_and(|callout| !callout.notes().is_empty())
}

/// Whether a cycle counted from a datum that another one had set.
fn has_datum(what: &Checked) -> bool {
    matches!(what, Checked::Cycle(cycle) if cycle.datum.is_some())
}

/// Whether the axes of that datum are turned, or no cycle has set it.
fn is_turned(what: &Checked) -> bool {
    let Checked::Cycle(cycle) = what else { return false };
    let datum = cycle.datum.as_ref();
    datum.is_some_and(|datum| datum.set_by.is_none() || datum.rotation.is_some() || datum.tilt.is_some())
}

/// The bytes of an entry.
///
/// # Errors
/// [`BodyError`] where a text is too long or has control characters, a list is too long, or a number is none.
pub fn write(entry: &Entry) -> Result<Vec<u8>, BodyError> {
    let body = write::body(entry)?;
    let bytes = serde_json::to_vec(&body).map_err(|error| BodyError::json(&error))?;
    if LONGEST < bytes.len() {
        return Err(BodyError::TooLarge { bytes: bytes.len() });
    }
    Ok(bytes)
}

/// The station that wrote an entry; `None` where the bytes do not say it.
pub fn station(bytes: &[u8]) -> Option<String> {
    #[derive(Deserialize)]
    struct Body {
        about: About,
    }
    #[derive(Deserialize)]
    struct About {
        station: String,
    }
    serde_json::from_slice(bytes).ok().map(|body: Body| body.about.station)
}

/// The entry in bytes.
///
/// # Errors
/// [`BodyError`] where they are no entry that this version can read.
pub fn read(bytes: &[u8]) -> Result<Entry, BodyError> {
    if LONGEST < bytes.len() {
        return Err(BodyError::TooLarge { bytes: bytes.len() });
    }
    let Head { v: version } = serde_json::from_slice(bytes).map_err(|error| BodyError::json(&error))?;
    if VERSION < version {
        return Err(BodyError::Newer { version });
    }
    if version == 0 {
        return Err(BodyError::value("v", version));
    }
    read::entry(serde_json::from_slice(bytes).map_err(|error| BodyError::json(&error))?)
}
