//! ISO 286-1 and ISO 286-2: every tolerance class, over 0 up to 3150 mm.
//!
//! | file | what |
//! |---|---|
//! | `figures` | the printed tables: steps, standard tolerances, fundamental deviations |
//! | `grade` | grades and letters |
//! | `zone` | the rules: how the figures give a class at a size, with every exception |
//! | `remark` | what a reader should know about a figure |
//! | `undefined` | why a class is refused, and where it is defined |
//!
//! Nothing is clamped, extended or computed from a formula. Where the standard leaves a choice there is an option.

mod figures;
mod grade;
mod remark;
mod undefined;
mod zone;

pub use grade::{Grade, Letter};
pub use remark::Remark;
pub use undefined::{ANSI, Reason, Undefined, knows_letter};

use serde::{Deserialize, Serialize};

use self::figures::Steps;
use self::zone::{SizeSteps, Zone};
use super::class::{Feature, ToleranceClass};
use super::deviations::Deviations;
use crate::length::Length;

/// Which edition defines cd, ef and fg.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Edition {
    /// ISO 286:1988: cd, ef, fg (and CD, EF, FG) to 10 mm.
    #[serde(rename = "1988")]
    Of1988,
    /// ISO 286:2010: to 50 mm.
    #[default]
    #[serde(rename = "2010")]
    Of2010,
}

/// How half micrometres are treated in JS7 to JS11 and js7 to js11.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum JsHalves {
    /// They are kept: 100 JS9 is ±43.5 µm.
    #[default]
    Exact,
    /// The tolerance is rounded down to an even number of micrometres and halved, as in the 1988 edition: ±43 µm.
    Rounded,
}

/// The choices where editions differ.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(default)]
pub struct Options {
    /// The edition for cd, ef, fg.
    pub edition: Edition,
    /// Half micrometres of JS and js.
    pub js: JsHalves,
}

/// What the standard says for a class at a size.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cell {
    /// The limit deviations.
    pub deviations: Deviations,
    /// The size step that the letter is printed for: above this,
    pub over: Length,
    /// up to and including this.
    pub to: Length,
    /// What a reader should know about the figure.
    pub remark: Option<Remark>,
}

/// The limit deviations of a class at a nominal size.
///
/// ```
/// use fitcheck_core::tolerance::iso286;
///
/// let cell = iso286::deviations("M6".parse()?, "280".parse()?, iso286::Options::default())?;
/// assert_eq!(cell.deviations.upper().to_string(), "-0.009");
/// assert_eq!((cell.over.to_string(), cell.to.to_string()), ("250".into(), "315".into()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Undefined`] says why the standard has no such class at this size, and where it has it.
pub fn deviations(class: ToleranceClass, nominal: Length, options: Options) -> Result<Cell, Undefined> {
    let refused = |reason| Undefined::new(class, nominal, reason, options);
    let Some((letter, grade)) = parts(class) else { return Err(refused(Reason::NoClass)) };
    if nominal <= Length::ZERO {
        return Err(refused(Reason::NotPositive));
    }
    let Some(place) = SizeSteps::of(nominal) else { return Err(refused(Reason::TooLarge)) };
    zone::zone(class.feature(), letter, grade, place, options)
        .and_then(|zone| cell(zone, place))
        .map(|cell| Cell { remark: remark::remark(letter, grade, nominal, cell.deviations, options), ..cell })
        .ok_or_else(|| refused(Reason::NotHere))
}

/// The letter and grade of a class; `None` for one that the standard does not have (`Q7`, `H19`, but not `U1`).
pub fn parts(class: ToleranceClass) -> Option<(Letter, Grade)> {
    let text = class.as_str().as_bytes();
    let digits = text.iter().position(u8::is_ascii_digit)?;
    let (letters, digits) = text.split_at_checked(digits)?;
    Some((Letter::from_letters(letters)?, Grade::from_digits(digits)?))
}

/// The class of a letter and a grade for a hole or a shaft, whether or not it is defined anywhere.
pub fn class(feature: Feature, letter: Letter, grade: Grade) -> ToleranceClass {
    ToleranceClass::of_parts(feature, letter.text(), grade)
}

/// Every class that is defined at a size, by letter and then by grade.
pub fn classes_at(
    feature: Feature,
    nominal: Length,
    options: Options,
) -> impl Iterator<Item = (ToleranceClass, Deviations)> {
    Letter::ALL.into_iter().flat_map(Grade::of_letter).filter_map(move |(letter, grade)| {
        let place = SizeSteps::of(nominal).filter(|_| Length::ZERO < nominal)?;
        let zone = zone::zone(feature, letter, grade, place, options)?;
        Some((class(feature, letter, grade), cell(zone, place)?.deviations))
    })
}

/// Every class that is defined at some size, by letter and then by grade.
pub fn classes(feature: Feature, options: Options) -> impl Iterator<Item = ToleranceClass> {
    Letter::ALL.into_iter().flat_map(Grade::of_letter).filter_map(move |(letter, grade)| {
        let defined = |nominal| zone::zone(feature, letter, grade, SizeSteps::of(nominal)?, options);
        let somewhere = step_ends().any(|nominal| defined(nominal).is_some());
        somewhere.then(|| class(feature, letter, grade))
    })
}

/// The classes that are offered first: those of the control's tables (NC-Solution 8255) and the preferred ones of
/// ISO 286-1.
pub fn usual_classes(feature: Feature) -> impl Iterator<Item = ToleranceClass> {
    let usual = match feature {
        Feature::Hole => "A11 B11 C11 D10 E9 F7 F8 G7 G9 H6 H7 H8 H9 H11 H12 H13 JS7 JS9 K6 K7 M6 M7 N7 N9 P7 P9 R7 S7",
        Feature::Shaft => "a11 b11 c11 d9 e8 f7 g6 h5 h6 h7 h8 h9 h11 js5 js6 js13 js14 k5 k6 m5 m6 n6 p6 r6 s6 s7",
    };
    usual.split(' ').filter_map(|class| class.parse().ok())
}

/// The preferred classes of ISO 286-1.
pub fn preferred_classes(feature: Feature) -> impl Iterator<Item = ToleranceClass> {
    let preferred = match feature {
        Feature::Hole => "A11 B11 C11 D10 E9 F8 G7 H7 H8 H9 H11 JS7 K7 N7 P7 R7 S7",
        Feature::Shaft => "a11 b11 c11 d9 e8 f7 g6 h6 h7 h9 h11 js6 k6 n6 p6 r6 s6",
    };
    preferred.split(' ').filter_map(|class| class.parse().ok())
}

/// The upper, inclusive ends of all steps, ascending, with 1 mm among them: no class changes within a step.
pub fn step_ends() -> impl Iterator<Item = Length> {
    std::iter::once(1).chain(figures::SUB_ENDS).map(millimetres)
}

const fn millimetres(mm: i32) -> Length {
    Length::from_micrometres(mm.saturating_mul(1000))
}

/// The ends of the steps within a size range, its own end last: no class changes within a step.
pub(super) fn steps_within(over: Length, to: Length) -> impl Iterator<Item = Length> {
    step_ends().filter(move |end| over < *end && *end < to).chain([to])
}

/// The width of a standard tolerance at a size; `None` where the grade is not defined.
pub fn standard_tolerance(grade: Grade, nominal: Length) -> Option<Length> {
    let place = SizeSteps::of(nominal).filter(|_| Length::ZERO < nominal)?;
    // An H zone begins at the nominal size.
    Length::from_nanometres(zone::zone(Feature::Hole, Letter::H, grade, place, Options::default())?.upper).ok()
}

fn cell(zone: Zone, place: SizeSteps) -> Option<Cell> {
    let (ends, number): (&[i32], _) = match zone.steps {
        Steps::Main => (&figures::MAIN_ENDS, place.main),
        Steps::Sub => (&figures::SUB_ENDS, place.sub),
    };
    let first = i32::from(zone.above_one);
    let over = number.checked_sub(1).and_then(|before| ends.get(before)).copied().unwrap_or(first);
    let to = *ends.get(number)?;
    let length = |nm| Length::from_nanometres(nm).ok();
    let deviations = Deviations::new(length(zone.upper)?, length(zone.lower)?).ok()?;
    Some(Cell { deviations, over: millimetres(over), to: millimetres(to), remark: None })
}
