//! The texts of text fields: one text per field, read anew at every change.

use std::collections::BTreeMap;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};

/// The fields of a page whose texts survive a restart.
pub(super) trait KeptField: Copy + Ord + 'static {
    /// Every field in reading order.
    const ALL: &'static [Self];

    /// Its key in the state file, and its text at the first start.
    fn declared(self) -> (&'static str, &'static str);
}

/// The fields of a page whose texts survive a restart, a row each: what it is, its key in the state file, and its text
/// at the first start.
macro_rules! kept_fields {
    ($(#[$doc:meta])* $name:ident $($(#[$field_doc:meta])* $field:ident: $key:literal, $first:literal;)+) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum $name {
            $($(#[$field_doc])* $field,)+
        }

        impl $crate::texts::KeptField for $name {
            const ALL: &'static [Self] = &[$(Self::$field),+];

            fn declared(self) -> (&'static str, &'static str) {
                match self {
                    $(Self::$field => ($key, $first),)+
                }
            }
        }
    };
}

pub(crate) use kept_fields;

/// The texts of a page's fields; a missing one counts as the text of the first start.
#[derive(Debug, Clone)]
pub(super) struct Texts<F> {
    texts: BTreeMap<F, String>,
}

impl<F> Default for Texts<F> {
    fn default() -> Self {
        Self { texts: BTreeMap::new() }
    }
}

impl<F: KeptField> Texts<F> {
    pub fn text(&self, field: F) -> &str {
        self.texts.get(&field).map_or_else(|| field.declared().1, String::as_str)
    }

    pub fn set(&mut self, field: F, text: impl Into<String>) {
        self.texts.insert(field, text.into());
    }

    /// What was put into fields, by their keys in the state file.
    pub fn saved(&self) -> impl Iterator<Item = (String, String)> {
        self.texts.iter().map(|(field, text)| (field.declared().0.to_owned(), text.clone()))
    }

    /// The page's texts from those of a state file.
    pub fn restored(saved: &BTreeMap<String, String>) -> Self {
        let of_field = |field: &F| Some((*field, saved.get(field.declared().0)?.clone()));
        Self { texts: F::ALL.iter().filter_map(of_field).collect() }
    }
}

/// The whole number in a field.
///
/// # Errors
/// What is shown beside the field where its text is not a whole number.
pub(super) fn whole<T: std::str::FromStr>(text: &str) -> Result<T, Message> {
    let text = text.trim();
    text.parse().map_err(|_not_whole| message!("field-not-whole").text("given", text))
}

/// The largest length of a field, of either sign: 99999.9999 mm.
const LARGEST: Length = Length::constant(99_999_999_900);

/// What a field's length may be, within the control's ±99999.9999 mm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Range {
    /// Of either sign.
    Any,
    /// Not below zero.
    ZeroOrMore,
    AboveZero,
}

impl Range {
    /// The length in a field.
    ///
    /// # Errors
    /// What is shown beside the field where its text is not a length, or is one outside the range.
    pub(super) fn read(self, text: &str) -> Result<Length, Message> {
        let value = text.parse::<Length>().map_err(|error| error.message())?;
        let outside = |id| Err(Message::new(id).number("given", value).number("limit", LARGEST));
        match self {
            Self::ZeroOrMore if value < Length::ZERO => outside("field-not-negative"),
            Self::AboveZero if value <= Length::ZERO => outside("field-above-zero"),
            _ if LARGEST < value.abs() => outside("field-range"),
            _ => Ok(value),
        }
    }
}
