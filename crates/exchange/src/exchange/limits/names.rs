//! What the name of a column says of a limit; `vocabulary` has the words.

use std::collections::HashMap;
use std::sync::LazyLock;

use csv::StringRecord;

use crate::exchange::claim::letters;
use crate::exchange::role::Role;
use crate::exchange::vocabulary::{
    LARGEST, LOWER, LOWER_DEVIATION, MAXIMUM, MINIMUM, MINUS, Rank, SIGNED, SMALLEST, UPPER, UPPER_DEVIATION, by_word,
};
use crate::exchange::{units, words};

/// What a name says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::exchange) enum LimitName {
    UpperDeviation,
    LowerDeviation,
    /// The lower deviation, with or without its sign.
    Minus,
    Maximum,
    Minimum,
    /// A limit or a deviation.
    Upper,
    Lower,
    /// A limit, or one of several readings.
    Largest,
    Smallest,
}

impl LimitName {
    pub(in crate::exchange) const fn is_upper(self) -> bool {
        matches!(self, Self::UpperDeviation | Self::Maximum | Self::Upper | Self::Largest)
    }

    pub(in crate::exchange) const fn may_be_reading(self) -> bool {
        matches!(self, Self::Largest | Self::Smallest)
    }

    /// Whether it says a limit and nothing else, or a deviation and nothing else.
    pub(in crate::exchange) const fn is_sure(self) -> bool {
        !matches!(self, Self::Upper | Self::Lower | Self::Largest | Self::Smallest)
    }

    pub(super) const fn is_deviation(self) -> bool {
        matches!(self, Self::UpperDeviation | Self::LowerDeviation | Self::Minus)
    }

    /// What a column of the name holds, and how sure that is.
    pub(in crate::exchange) const fn role(self) -> (Role, Rank) {
        match self {
            Self::UpperDeviation => (Role::Upper, Rank::Exact),
            Self::LowerDeviation => (Role::Lower, Rank::Exact),
            Self::Minus => (Role::Lower, Rank::Weak),
            Self::Maximum => (Role::Maximum, Rank::Exact),
            Self::Minimum => (Role::Minimum, Rank::Exact),
            Self::Upper | Self::Largest => (Role::Maximum, Rank::Weak),
            Self::Lower | Self::Smallest => (Role::Minimum, Rank::Weak),
        }
    }
}

/// Every whole name of a limit; of two lists that have a name, the first counts.
static NAMES: LazyLock<HashMap<&'static str, LimitName>> = LazyLock::new(|| {
    let lists = [
        (UPPER_DEVIATION, LimitName::UpperDeviation),
        (LOWER_DEVIATION, LimitName::LowerDeviation),
        (MINUS, LimitName::Minus),
        (MAXIMUM, LimitName::Maximum),
        (MINIMUM, LimitName::Minimum),
        (UPPER, LimitName::Upper),
        (LOWER, LimitName::Lower),
        (LARGEST, LimitName::Largest),
        (SMALLEST, LimitName::Smallest),
    ];
    by_word(lists)
});

/// What the name of a column says of a limit.
pub(in crate::exchange) fn by_name(header: &str) -> Option<LimitName> {
    match sign(header) {
        Some('+') => return Some(LimitName::UpperDeviation),
        Some(_) => return Some(LimitName::Minus),
        None => {}
    }
    NAMES.get(words::bare(header).as_str()).copied()
}

/// What two columns with a sign alone as their names hold, where there is one of each: a single `-` says that a column has no name.
pub(super) fn by_sign(header: &str, names: &StringRecord) -> Option<LimitName> {
    let alone = |name: &str| match name.trim() {
        "+" => Some('+'),
        "-" | "\u{2212}" | "\u{2013}" => Some('-'),
        _ => None,
    };
    let has_one = |sign: char| names.iter().filter(|name| alone(name) == Some(sign)).count() == 1;
    let found = alone(header).filter(|_| has_one('+') && has_one('-'))?;
    Some(if found == '+' { LimitName::UpperDeviation } else { LimitName::Minus })
}

/// The sign of a deviation in a name: `+TOL`, `Tol. (-)`.
fn sign(header: &str) -> Option<char> {
    if goes_both_ways(header) {
        return None;
    }
    let name = match header.trim().rsplit_once(['[', '(']) {
        Some((name, unit)) if units::known(unit.trim_end_matches([']', ')'])).is_some() => name,
        _ => header.trim(),
    };
    let name = name.replace(['\u{2212}', '\u{2013}'], "-");
    let is_at_end = |c: char| {
        name.trim_matches([' ', '(', ')', '[', ']']).starts_with(c)
            || name.trim_end_matches([' ', ')', ']']).ends_with(c)
    };
    let found = ['+', '-'].into_iter().filter(|c| is_at_end(*c)).collect::<Vec<_>>();
    let [found] = found.as_slice() else { return None };
    SIGNED.has(&letters(&name)).then_some(*found)
}

/// Whether the name of a tolerance says that its number goes both ways: `Tol ±`, `+/- Tol`.
pub(in crate::exchange) fn goes_both_ways(header: &str) -> bool {
    header.contains('±') || header.replace(' ', "").contains("+/-")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_limits_and_deviations() {
        for (name, expected) in [
            ("+TOL", Some(LimitName::UpperDeviation)),
            ("Tol +", Some(LimitName::UpperDeviation)),
            ("Tol. (+)", Some(LimitName::UpperDeviation)),
            ("Tol+ [mm]", Some(LimitName::UpperDeviation)),
            ("-TOL", Some(LimitName::Minus)),
            ("Tol\u{2212}", Some(LimitName::Minus)),
            ("-", None),
            ("oberes Abmaß", Some(LimitName::UpperDeviation)),
            ("Unteres Abmass (µm)", Some(LimitName::LowerDeviation)),
            ("Upper limit", Some(LimitName::Maximum)),
            ("LSL", Some(LimitName::Minimum)),
            ("cote maxi", Some(LimitName::Maximum)),
            ("Max", Some(LimitName::Largest)),
            ("superior", Some(LimitName::Upper)),
            ("+/- Tol", None),
            ("X-Pos", None),
            ("Tol-Klasse", None),
            ("Tol", None),
        ] {
            assert_eq!(by_name(name), expected, "{name}");
        }
        let pair = StringRecord::from(vec!["nominal", "+", "-", "measured"]);
        assert_eq!(by_sign("-", &pair), Some(LimitName::Minus));
        assert_eq!(by_sign("-", &StringRecord::from(vec!["nominal", "measured", "-"])), None);
        assert!(goes_both_ways("Tol ±") && goes_both_ways("+ / - Tol") && !goes_both_ways("+Tol"));
    }
}
