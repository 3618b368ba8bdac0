//! Why the standard has no class at a size, and where it has it.

use super::super::class::ToleranceClass;
use super::super::ranges;
use super::zone::{self, SizeSteps};
use super::{Grade, Letter, Options, parts, step_ends};
use crate::length::Length;
use crate::message::{Message, Say, display, message};

/// The fits of ANSI B4.1: running, locational clearance, transition and interference, force.
pub const ANSI: [&str; 5] = ["RC", "LC", "LT", "LN", "FN"];

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
    /// The letter or the grade is not in the standard.
    NoClass,
    /// A size of 0 or less.
    NotPositive,
    /// Above 3150 mm, where the standard ends.
    TooLarge,
    /// Not defined at this size, but perhaps at others.
    NotHere,
}

impl Undefined {
    pub(super) const fn new(class: ToleranceClass, nominal: Length, reason: Reason, options: Options) -> Self {
        Self { class, nominal, reason, options }
    }

    /// Where the class is defined: above and up to, in mm, joined and ascending; empty when nowhere.
    pub fn defined(&self) -> Vec<(Length, Length)> {
        let Some((letter, grade)) = parts(self.class) else { return Vec::new() };
        let feature = self.class.feature();
        let zone = |size| zone::zone(feature, letter, grade, SizeSteps::of(size)?, self.options);
        ranges::where_defined(step_ends().map(|to| (to, zone(to).is_some())))
    }

    fn knows_letter(&self) -> bool {
        knows_letter(self.class)
    }
}

/// Whether the standard has the letters of a class, with whatever grade.
pub fn knows_letter(class: ToleranceClass) -> bool {
    Letter::from_letters(class.letters().as_bytes()).is_some()
}

/// Whether a class is one of the fits of ANSI B4.1: `RC4`.
fn is_ansi(class: ToleranceClass) -> bool {
    class.has_grade() && ANSI.iter().any(|letters| letters.eq_ignore_ascii_case(class.letters()))
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

display!(Undefined);

impl std::error::Error for Undefined {}

impl Say for Undefined {
    fn message(&self) -> Message {
        let Self { class, nominal, .. } = self;
        match self.reason {
            Reason::NoClass if self.knows_letter() && !class.has_grade() => {
                message!("iso286-grade-missing").with("class", class)
            }
            Reason::NoClass if self.knows_letter() => {
                message!("iso286-no-grade").with("class", class).with("grades", &all_grades())
            }
            Reason::NoClass if class.letters().eq_ignore_ascii_case("it") && class.has_grade() => {
                message!("iso286-grade-alone").with("class", class).text("grade", class.as_str().to_ascii_uppercase())
            }
            Reason::NoClass if is_ansi(*class) => message!("callout-ansi").with("class", class),
            Reason::NoClass => message!("iso286-no-letter")
                .with("class", class)
                .with("letters", class.letters())
                .with("known", &all_letters(*class)),
            Reason::NotPositive => message!("callout-not-positive").with("nominal", nominal),
            Reason::TooLarge => message!("iso286-too-large").with("nominal", nominal),
            Reason::NotHere => message!("iso286-not-here")
                .with("class", class)
                .with("nominal", nominal)
                .with("where", &ranges::message(&self.defined())),
        }
    }
}
