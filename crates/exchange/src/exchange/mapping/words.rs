//! The words of a mapping: what a column holds.

use super::MappingError;
use crate::exchange::role::Role;

/// The words of what a column holds.
pub(super) const ROLES: [(Role, &str); 14] = [
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
];

/// Other words for the same.
const OTHER_WORDS: [(&str, Role); 4] =
    [("id", Role::Id), ("class", Role::Tolerance), ("date", Role::Time), ("type", Role::Quantity)];

/// Words beside those of columns.
const OF_THE_FILE: [&str; 6] = ["separator", "decimal", "unit", "place-unit", "first-row", "sheet"];

impl Role {
    /// Whether two columns may have it: date and time, the type of a feature and the axis of a value.
    pub(super) const fn may_be_two(self) -> bool {
        matches!(self, Self::Time | Self::Quantity)
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
