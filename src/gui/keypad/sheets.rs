//! What is on the keys: sheets of four rows of four, so that no key is smaller than another one, in any language.

use crate::session::{CheckField, Field, FitField};

/// What a key does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Key {
    Type(char),
    /// A tolerance class in the place of the one that is there.
    Class(&'static str),
    Back,
    Clear,
    /// Shows another sheet.
    Show(Sheet),
    /// Capital letters, or small ones.
    Shift,
    Enter,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Sheet {
    #[default]
    Figures,
    /// Classes of holes.
    Holes,
    /// Classes of shafts.
    Shafts,
    /// A to L.
    First,
    /// M to X.
    Second,
    /// The last letters, and signs.
    Signs,
}

/// The classes that drawings have most often; the others are typed.
const HOLES: [&str; 12] = ["H6", "H7", "H8", "H9", "H11", "F7", "F8", "G7", "JS7", "K7", "N7", "P7"];
const SHAFTS: [&str; 12] = ["h5", "h6", "h7", "h9", "h11", "f7", "g6", "js6", "k6", "m6", "n6", "p6"];

impl Sheet {
    /// What stands on the key that shows it.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Figures => "123",
            Self::Holes => "H7…",
            Self::Shafts => "h6…",
            Self::First => "ABC",
            Self::Second => "M–X",
            Self::Signs => "Z /",
        }
    }

    /// The id of what a screen reader says of that key.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Figures => "key-figures",
            Self::Holes => "key-holes",
            Self::Shafts => "key-shafts",
            Self::First => "key-letters",
            Self::Second => "key-more-letters",
            Self::Signs => "key-signs",
        }
    }

    /// The sixteen keys; where a large button below does what Enter does, another key has its place.
    pub fn keys(self, field: Field, has_enter: bool) -> Vec<Key> {
        let letters = |from: char| (from..='Z').take(12).map(Key::Type);
        let last = if has_enter { Key::Enter } else { Key::Clear };
        let figures = Self::Figures;
        match self {
            Self::Figures => {
                let classes = if takes_classes(field) { Self::Holes } else { Self::First };
                // What has a place of its own keeps it, whatever the field is for.
                let [middle, third, fourth] = match (has_enter, takes_classes(field)) {
                    (true, _) => [Key::Clear, Key::Show(classes), Key::Enter],
                    (false, true) => [Key::Show(classes), Key::Show(Self::First), Key::Clear],
                    (false, false) => [Key::Type('+'), Key::Show(Self::First), Key::Clear],
                };
                let mut keys = Vec::new();
                keys.extend(['7', '8', '9'].map(Key::Type));
                keys.push(Key::Back);
                keys.extend(['4', '5', '6'].map(Key::Type));
                keys.push(middle);
                keys.extend(['1', '2', '3', '-'].map(Key::Type));
                keys.extend([Key::Type('0'), Key::Type('.'), third, fourth]);
                keys
            }
            Self::Holes | Self::Shafts => {
                let (classes, other) = if self == Self::Holes { (HOLES, Self::Shafts) } else { (SHAFTS, Self::Holes) };
                let end = if has_enter { Key::Enter } else { Key::Back };
                let ends = [Key::Show(figures), Key::Show(Self::First), Key::Show(other), end];
                classes.map(Key::Class).into_iter().chain(ends).collect()
            }
            Self::First => letters('A').chain([Key::Show(figures), Key::Show(Self::Second), Key::Back, last]).collect(),
            Self::Second => letters('M').chain([Key::Show(figures), Key::Show(Self::Signs), Key::Back, last]).collect(),
            Self::Signs => {
                let signs = ['Y', 'Z', '/', '+', '-', '.', '_', '#', '(', ')', ' '].map(Key::Type);
                let ends = [Key::Shift, Key::Show(figures), Key::Show(Self::First), Key::Back, last];
                signs.into_iter().chain(ends).collect()
            }
        }
    }
}

/// Whether a field takes a callout.
pub(super) const fn takes_classes(field: Field) -> bool {
    matches!(field, Field::Check(CheckField::Callout) | Field::Fit(FitField::Callout))
}

/// A callout with another class. In a fit a hole's and a shaft's stand beside each other.
pub(super) fn with_class(text: &str, class: &str, is_fit: bool) -> String {
    let end = text.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(text.len());
    let (nominal, classes) = text.split_at(end);
    let nominal = nominal.trim();
    let is_hole = |class: &str| class.starts_with(|c: char| c.is_ascii_uppercase());
    let other = classes.split('/').map(str::trim).find(|of| is_fit && !of.is_empty() && is_hole(of) != is_hole(class));
    let classes = match other {
        Some(hole) if is_hole(hole) => format!("{hole}/{class}"),
        Some(shaft) => format!("{class}/{shaft}"),
        None => class.to_owned(),
    };
    if nominal.is_empty() { classes } else { format!("{nominal} {classes}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_class_takes_the_place_of_the_one_before() {
        for (text, class, is_fit, after) in [
            ("25", "H7", false, "25 H7"),
            ("25 H7", "h6", false, "25 h6"),
            ("", "H7", false, "H7"),
            ("12,5 JS9", "H11", false, "12,5 H11"),
            ("25", "H7", true, "25 H7"),
            ("25 H7", "g6", true, "25 H7/g6"),
            ("25 H7/g6", "H8", true, "25 H8/g6"),
            ("25 g6", "H8", true, "25 H8/g6"),
        ] {
            assert_eq!(with_class(text, class, is_fit), after, "{text} {class}");
        }
    }

    #[test]
    fn every_sheet_has_sixteen_keys_and_leads_back_to_the_figures() {
        let fields = [Field::Check(CheckField::Callout), Field::Check(CheckField::Part)];
        for sheet in [Sheet::Figures, Sheet::Holes, Sheet::Shafts, Sheet::First, Sheet::Second, Sheet::Signs] {
            for (field, has_enter) in fields.into_iter().flat_map(|field| [(field, true), (field, false)]) {
                let keys = sheet.keys(field, has_enter);
                assert_eq!(keys.len(), 16, "{sheet:?}");
                assert!(sheet == Sheet::Figures || keys.contains(&Key::Show(Sheet::Figures)), "{sheet:?}");
                assert_eq!(keys.contains(&Key::Enter), has_enter, "{sheet:?}");
            }
        }
    }
}
