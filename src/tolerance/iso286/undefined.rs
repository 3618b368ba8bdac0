//! Why the standard has no class at a size, and where it has it.

use std::fmt;

use super::super::class::ToleranceClass;
use super::super::ranges;
use super::zone::{self, Place};
use super::{Grade, Letter, Options, parts, sizes};
use crate::length::{Length, signed_mm};
use crate::message::{Message, Say};

/// A class that the standard does not define at a size.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Undefined {
    /// The class that was asked for.
    pub class: ToleranceClass,
    /// The size that was asked for.
    pub nominal: Length,
    /// Why it is refused.
    pub reason: Reason,
    options: Options,
}

/// Why a class is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// No letter or no grade of the standard.
    NoClass,
    /// A size of 0 or less.
    NotPositive,
    /// Above 3150 mm, where the standard ends.
    TooLarge,
    /// Not at this size, but perhaps at others.
    NotHere,
}

impl Undefined {
    pub(super) const fn new(class: ToleranceClass, nominal: Length, reason: Reason, options: Options) -> Self {
        Self { class, nominal, reason, options }
    }

    /// Where the class is defined: above and up to, in mm, joined and ascending; empty when nowhere.
    pub fn defined(&self) -> Vec<(Length, Length)> {
        let mut ranges: Vec<(Length, Length)> = Vec::new();
        let Some((letter, grade)) = parts(self.class) else { return ranges };
        let mut over = Length::ZERO;
        for to in sizes() {
            let place = Place::of(to);
            let zone = place.and_then(|place| zone::zone(self.class.feature(), letter, grade, place, self.options));
            if zone.is_some() {
                match ranges.last_mut() {
                    Some(last) if last.1 == over => last.1 = to,
                    _ => ranges.push((over, to)),
                }
            }
            over = to;
        }
        ranges
    }

    fn knows_letter(&self) -> bool {
        Letter::from_letters(self.class.letters().as_bytes()).is_some()
    }
}

fn all_letters(class: ToleranceClass) -> String {
    let is_hole = class.feature() == super::Feature::Hole;
    let text = |letter: Letter| if is_hole { letter.text().to_ascii_uppercase() } else { letter.text().to_owned() };
    Letter::ALL.map(text).join(" ")
}

fn all_grades() -> String {
    let grades: Vec<String> = Grade::all().map(|grade| grade.to_string()).collect();
    grades.join(" ")
}

impl fmt::Display for Undefined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { class, nominal, .. } = self;
        match self.reason {
            Reason::NoClass if self.knows_letter() => {
                write!(f, "{class} is no class of ISO 286: its grades are {}", all_grades())
            }
            Reason::NoClass => {
                let letters = class.letters();
                write!(f, "{class} is no class of ISO 286: it has no letter {letters}, only {}", all_letters(*class))
            }
            Reason::NotPositive => write!(f, "nominal size {nominal} mm is not above 0"),
            Reason::TooLarge => write!(f, "nominal size {nominal} mm is beyond ISO 286, which ends at 3150 mm"),
            Reason::NotHere => {
                let defined = ranges::text(&self.defined());
                write!(f, "{class} is not defined at {nominal} mm in ISO 286; {defined}")
            }
        }
    }
}

impl std::error::Error for Undefined {}

impl Say for Undefined {
    fn message(&self) -> Message {
        let Self { class, nominal, .. } = self;
        match self.reason {
            Reason::NoClass if self.knows_letter() => {
                Message::new("iso286-no-grade").text("class", class).text("grades", all_grades())
            }
            Reason::NoClass => Message::new("iso286-no-letter")
                .text("class", class)
                .text("letters", class.letters())
                .text("known", all_letters(*class)),
            Reason::NotPositive => signed_mm(Message::new("callout-not-positive"), "nominal-sign", "nominal", *nominal),
            Reason::TooLarge => Message::new("iso286-too-large").mm("nominal", *nominal),
            Reason::NotHere => Message::new("iso286-not-here")
                .text("class", class)
                .mm("nominal", *nominal)
                .message("where", ranges::message(&self.defined())),
        }
    }
}
