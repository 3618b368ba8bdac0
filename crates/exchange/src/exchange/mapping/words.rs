//! The words of a mapping: what a column holds, separators, decimal signs and units.

use fitcheck_core::length::Unit;

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

pub(super) const SEPARATORS: [(&str, u8); 4] = [("semicolon", b';'), ("comma", b','), ("tab", b'\t'), ("pipe", b'|')];
pub(super) const DECIMALS: [(&str, char); 2] = [("point", '.'), ("comma", ',')];
pub(super) const UNITS: [(&str, Unit); 3] = [("mm", Unit::Millimetre), ("um", Unit::Micrometre), ("inch", Unit::Inch)];

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

/// What a word means, if there is one.
pub(super) fn known<T: Copy>(
    word: &str,
    given: Option<&str>,
    list: &[(&'static str, T)],
) -> Result<Option<T>, MappingError> {
    let Some(given) = given else { return Ok(None) };
    let found = list.iter().find(|(known, _)| *known == given).map(|(_, value)| *value);
    found.map(Some).ok_or_else(|| MappingError::Value {
        word: word.to_owned(),
        given: given.to_owned(),
        allowed: list.iter().map(|(known, _)| *known).collect::<Vec<_>>().join(" "),
    })
}

pub(super) fn word_for<T: Copy + PartialEq>(meant: T, list: &[(&'static str, T)]) -> Option<&'static str> {
    list.iter().find(|(_, known)| *known == meant).map(|(word, _)| *word)
}
