//! What texts and numbers of a body may be: the same when it is written and when it is read.

use std::fmt::Display;
use std::str::FromStr;

use fitcheck_core::length::Length;
use fitcheck_core::probing::Contact;

use super::wire::Three;
use super::{BodyError, MOST, MOST_CONTACTS};
use crate::journal::entry::About;

/// The largest whole number that every reader of JSON has exactly: 2^53.
const LARGEST: u64 = 1 << 53;

/// The longest text of a binary fraction: the smallest one has 1 076 figures, and no contact is there.
const LONGEST_FRACTION: usize = 400;

/// A name of something.
pub(super) fn name(field: &'static str, text: &str) -> Result<String, BodyError> {
    sound(field, text, About::LONGEST_NAME)
}

/// A longer text.
pub(super) fn long(field: &'static str, text: &str) -> Result<String, BodyError> {
    sound(field, text, About::LONGEST_REMARK)
}

fn sound(field: &'static str, text: &str, most: usize) -> Result<String, BodyError> {
    if most < text.len() {
        return Err(BodyError::TooLong { field, bytes: text.len(), most });
    }
    if let Some((place, found)) = (1..).zip(text.chars()).find(|(_, c)| c.is_control()) {
        return Err(BodyError::Control { field, code: format!("U+{:04X}", u32::from(found)), place });
    }
    Ok(text.to_owned())
}

/// A value that is kept as the text that it prints.
pub(super) fn printed<T: FromStr + Display>(field: &'static str, text: &str) -> Result<T, BodyError> {
    let read = (text.len() <= About::LONGEST_NAME).then(|| text.parse::<T>().ok()).flatten();
    read.filter(|read| read.to_string() == text).ok_or_else(|| BodyError::value(field, text))
}

/// A seed: it is a text, for it has up to 20 figures.
pub(super) fn seed(field: &'static str, text: &str) -> Result<u64, BodyError> {
    printed(field, text)
}

/// A length of so many nanometres.
pub(super) fn length(field: &'static str, nm: i64) -> Result<Length, BodyError> {
    Length::from_nanometres(nm).map_err(|_range| BodyError::value(field, nm))
}

/// The same for one that may be missing.
pub(super) fn some_length(field: &'static str, nm: Option<i64>) -> Result<Option<Length>, BodyError> {
    nm.map(|nm| length(field, nm)).transpose()
}

/// The same for a pair.
pub(super) fn two_lengths(field: &'static str, nm: Option<[i64; 2]>) -> Result<Option<[Length; 2]>, BodyError> {
    nm.map(|[one, other]| Ok([length(field, one)?, length(field, other)?])).transpose()
}

/// A whole number that JSON holds everywhere.
pub(super) fn whole(field: &'static str, number: u64) -> Result<u64, BodyError> {
    if number <= LARGEST { Ok(number) } else { Err(BodyError::value(field, number)) }
}

/// A list that is not too long.
pub(super) fn bounded<T>(field: &'static str, list: &[T]) -> Result<(), BodyError> {
    at_most(field, list, MOST)
}

fn at_most<T>(field: &'static str, list: &[T], most: usize) -> Result<(), BodyError> {
    let count = list.len();
    if count <= most { Ok(()) } else { Err(BodyError::TooMany { field, count, most }) }
}

/// Binary fractions as the shortest texts that read back as the same.
pub(super) fn fractions<const N: usize>(field: &'static str, numbers: [f64; N]) -> Result<[String; N], BodyError> {
    let texts = numbers.map(|number| number.to_string());
    match texts.iter().zip(numbers).find(|(text, number)| !number.is_finite() || LONGEST_FRACTION < text.len()) {
        Some((text, _)) => Err(BodyError::value(field, text)),
        None => Ok(texts),
    }
}

/// Binary fractions from their texts.
pub(super) fn of_fractions<const N: usize>(field: &'static str, texts: &[String; N]) -> Result<[f64; N], BodyError> {
    let mut numbers = [0.0; N];
    for (number, text) in numbers.iter_mut().zip(texts) {
        let is_plain = text.len() <= LONGEST_FRACTION && text.bytes().all(|b| b.is_ascii_digit() || b"-.".contains(&b));
        let read = is_plain.then(|| text.parse::<f64>().ok()).flatten().filter(|read| read.is_finite());
        *number = read.ok_or_else(|| BodyError::value(field, text))?;
    }
    Ok(numbers)
}

pub(super) fn contacts(field: &'static str, contacts: &[Contact]) -> Result<Vec<Three>, BodyError> {
    at_most(field, contacts, MOST_CONTACTS)?;
    contacts.iter().map(|contact| fractions(field, contact.place())).collect()
}

pub(super) fn of_contacts(field: &'static str, texts: &[Three]) -> Result<Vec<Contact>, BodyError> {
    at_most(field, texts, MOST_CONTACTS)?;
    texts.iter().map(|texts| of_fractions(field, texts).map(Contact::at)).collect()
}
