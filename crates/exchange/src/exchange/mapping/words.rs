//! The words of a mapping: what a column holds.

use super::MappingError;
use crate::exchange::role::Role;

/// The most values that stand side by side in a row.
pub(in crate::exchange) const MOST_SAMPLES: usize = 250;

/// The words of what a column holds.
pub(super) const ROLES: [(Role, &str); 25] = [
    (Role::Id, "name"),
    (Role::Tolerance, "callout"),
    (Role::Nominal, "nominal"),
    (Role::Measured, "measured"),
    (Role::Time, "time"),
    (Role::Simulated, "simulated"),
    (Role::Number, "number"),
    (Role::Part, "part"),
    (Role::Serial, "serial"),
    (Role::Who, "who"),
    (Role::X, "x"),
    (Role::Y, "y"),
    (Role::Z, "z"),
    (Role::Quantity, "quantity"),
    (Role::Upper, "upper"),
    (Role::Lower, "lower"),
    (Role::Minus, "minus"),
    (Role::Maximum, "maximum"),
    (Role::Minimum, "minimum"),
    (Role::Kind, "kind"),
    (Role::Units, "units"),
    (Role::Status, "status"),
    (Role::Machine, "machine"),
    (Role::Batch, "batch"),
    (Role::Sample, "sample"),
];

/// Other words for the same.
const OTHER_WORDS: [(&str, Role); 18] = [
    ("id", Role::Id),
    ("feature", Role::Id),
    ("class", Role::Tolerance),
    ("tolerance", Role::Tolerance),
    ("requirement", Role::Tolerance),
    ("result", Role::Measured),
    ("date", Role::Time),
    ("type", Role::Quantity),
    ("axis", Role::Quantity),
    ("balloon", Role::Number),
    ("operator", Role::Who),
    ("usl", Role::Maximum),
    ("max", Role::Maximum),
    ("lsl", Role::Minimum),
    ("min", Role::Minimum),
    ("hole-shaft", Role::Kind),
    ("samples", Role::Sample),
    ("lot", Role::Batch),
];

/// Words beside those of columns.
const OF_THE_FILE: [&str; 6] = ["separator", "decimal", "unit", "place-unit", "first-row", "sheet"];

impl Role {
    /// How many columns may have it: date and time are two, and so are the type of a feature and the axis of a value.
    pub(super) const fn most(self) -> usize {
        match self {
            Self::Time | Self::Quantity => 2,
            Self::Sample => MOST_SAMPLES,
            _ => 1,
        }
    }

    /// Everything that a column may hold.
    pub fn all() -> impl Iterator<Item = Self> {
        ROLES.into_iter().map(|(role, _)| role)
    }

    /// Its word in a mapping.
    pub fn word(self) -> &'static str {
        ROLES.iter().find(|(known, _)| *known == self).map_or("", |(_, word)| *word)
    }
}

pub(super) fn role_of(word: &str) -> Result<Role, MappingError> {
    let small = word.to_lowercase();
    let role = ROLES.iter().find(|(_, known)| *known == small).map(|(role, _)| *role);
    let role = role.or_else(|| OTHER_WORDS.iter().find(|(known, _)| *known == small).map(|(_, role)| *role));
    role.ok_or_else(|| {
        let words = ROLES.iter().map(|(_, word)| *word).chain(OF_THE_FILE);
        MappingError::Word { given: word.to_owned(), allowed: words.collect::<Vec<_>>().join(" ") }
    })
}
