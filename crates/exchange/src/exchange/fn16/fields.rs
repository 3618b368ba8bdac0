//! The fields of a mask with what was printed in them, and a measured value as numbers of fields.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::tolerance::Callout;
use fitcheck_core::verdict::Status;
use fitcheck_nc::control::mask::{FieldContent, Printed, Slot};
use fitcheck_nc::control::status::status_of;
use fitcheck_nc::control::variables::{Family, Parameter};

/// What a measured value is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ReadingKind {
    /// A diameter, a width or the side of a rectangle.
    Size,
    Coordinate,
    /// A deviation along the normal.
    Point,
}

/// A measured value and what it is compared with, as numbers of fields.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Reading {
    pub(super) measured: usize,
    pub(super) kind: ReadingKind,
    pub(super) minimum: Option<usize>,
    pub(super) maximum: Option<usize>,
    pub(super) nominal: Option<usize>,
    /// What the mask calls it; empty where only a text beside it has a name.
    pub(super) name: String,
    /// Its own callout and status, where the mask prints several values of a part.
    pub(super) callout: Option<usize>,
    pub(super) status: Option<usize>,
    /// Whether the words before its fields say that it is of a hole, or else of a shaft.
    pub(super) is_hole: Option<bool>,
}

impl Reading {
    pub(super) const fn of(measured: usize, kind: ReadingKind) -> Self {
        Self {
            measured,
            kind,
            minimum: None,
            maximum: None,
            nominal: None,
            name: String::new(),
            callout: None,
            status: None,
            is_hole: None,
        }
    }

    /// Its fields besides the measured value.
    pub(super) fn others(&self) -> [Option<usize>; 5] {
        [self.minimum, self.maximum, self.nominal, self.callout, self.status]
    }
}

/// Deviations from nominal values, which are computed here.
const DEVIATIONS: std::ops::RangeInclusive<u16> = 161..=166;

/// Markers of measuring cycles that are 1: the workpiece is good, can be reworked, or is scrap.
pub(super) const MARKERS: [(u16, Status); 3] = [(180, Status::Good), (181, Status::Rework), (182, Status::Scrap)];

/// The status of cycles that have one number for it: -1 undefined, 0 good, 1 rework, 2 scrap.
pub(super) const STATUS: u16 = 183;

/// The fields of a mask and what was printed in them.
pub(super) struct Fields<'a> {
    pub(super) slots: &'a [Slot],
    pub(super) sample: &'a [Printed],
}

impl Fields<'_> {
    /// The field of a parameter; of several, the first, which has the values of all of them.
    pub(super) fn at(&self, parameter: Parameter) -> Option<usize> {
        self.slots.iter().position(|slot| slot.of == FieldContent::Parameter(parameter))
    }

    pub(super) fn number(&self, number: u16) -> Option<usize> {
        self.at(Parameter::q(number))
    }

    /// The fields for texts of parameters.
    pub(super) fn texts(&self) -> impl Iterator<Item = usize> {
        let is_first = |at: usize, slot: &Slot| self.slots.iter().position(|other| other.of == slot.of) == Some(at);
        let is_text = |slot: &Slot| slot.digits.is_none() && matches!(slot.of, FieldContent::Parameter(_));
        (0..).zip(self.slots).filter(move |(at, slot)| is_text(slot) && is_first(*at, slot)).map(|(at, _)| at)
    }

    /// What was printed in a field.
    pub(super) fn values(&self, at: usize) -> impl Iterator<Item = &str> {
        let values = self.sample.iter().flat_map(|printed| &printed.values);
        values.filter(move |(slot, _)| *slot == at).map(|(_, value)| value.as_str())
    }

    /// The first text that is always of a kind, where there is one.
    pub(super) fn text(&self, kind: fn(&str) -> bool) -> Option<usize> {
        self.texts_that(kind).next()
    }

    /// The texts that are always of a kind.
    pub(super) fn texts_that(&self, kind: fn(&str) -> bool) -> impl Iterator<Item = usize> {
        self.texts().filter(move |at| {
            let mut texts = self.values(*at).filter(|text| !text.is_empty()).peekable();
            texts.peek().is_some() && texts.all(kind)
        })
    }

    /// The numbers with decimals of the user's own parameters, each by its first field.
    pub(super) fn numbers(&self) -> Vec<usize> {
        let is_own = |slot: &Slot| match slot.of {
            FieldContent::Parameter(Parameter { family: Family::Q, number }) => {
                !DEVIATIONS.contains(&number) && !is_marker(number)
            }
            FieldContent::Parameter(_) => true,
            FieldContent::Word(_) => false,
        };
        let is_first =
            |(at, slot): &(usize, &Slot)| self.slots.iter().position(|other| other.of == slot.of) == Some(*at);
        let numbers =
            (0..).zip(self.slots).filter(|(_, slot)| slot.digits.is_some_and(|digits| 0 < digits) && is_own(slot));
        numbers.filter(is_first).map(|(at, _)| at).collect()
    }
}

/// Whether a parameter is one of them.
fn is_marker(number: u16) -> bool {
    number == STATUS || MARKERS.iter().any(|(marker, _)| *marker == number)
}

/// What a print has in a field.
pub(super) fn value(printed: &Printed, at: usize) -> Option<&str> {
    printed.values.iter().find(|(slot, _)| *slot == at).map(|(_, value)| value.as_str())
}

/// A length in a field, in millimetres.
pub(super) fn length(printed: &Printed, at: usize) -> Option<Length> {
    Length::parse_in(value(printed, at)?, Unit::Millimetre).ok()
}

pub(super) fn is_status(text: &str) -> bool {
    status_of(text).is_some()
}

pub(super) fn is_callout(text: &str) -> bool {
    text.parse::<Callout>().is_ok()
}
