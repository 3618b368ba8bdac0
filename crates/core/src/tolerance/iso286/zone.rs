//! Where a tolerance zone lies: the rules of ISO 286-1 on its printed figures, in nanometres.
//!
//! The rules are numbered as in `docs/SOURCES.md`, ISO 286. Sizes come in as steps; nothing here reads text.

use super::figures::{self, FIRST_ABOVE_500, LetterDeviations, STANDARD_TOLERANCES, Steps};
use super::grade::{Grade, Letter};
use super::{Edition, JsHalves, Options};
use crate::length::Length;
use crate::tolerance::class::Feature;

/// The steps that contain a size.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct SizeSteps {
    /// The number of the main step.
    pub main: usize,
    /// The number of the sub-step.
    pub sub: usize,
    /// Up to 1 mm, where some classes are not used.
    pub up_to_one: bool,
}

/// A zone: deviations in nanometres, and the kind of steps that its letter is printed for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Zone {
    pub upper: i64,
    pub lower: i64,
    pub steps: Steps,
    /// The class is not used up to 1 mm: its first step begins there.
    pub above_one: bool,
}

impl SizeSteps {
    /// The steps of a size above 0, `None` above 3150 mm.
    pub fn of(nominal: Length) -> Option<Self> {
        let above = |end: &i32| Length::from_micrometres(end.saturating_mul(1000)) < nominal;
        let sub = figures::SUB_ENDS.partition_point(above);
        let main = figures::MAIN_ENDS.partition_point(above);
        let up_to_one = nominal <= Length::from_micrometres(1000);
        (main < figures::MAIN_ENDS.len()).then_some(Self { main, sub, up_to_one })
    }

    const fn above_500(self) -> bool {
        FIRST_ABOVE_500 <= self.main
    }

    const fn up_to_3(self) -> bool {
        self.main == 0
    }

    fn row(self, row: &LetterDeviations) -> Option<i64> {
        let step = match row.steps {
            Steps::Main => self.main,
            Steps::Sub => self.sub,
        };
        row.um.get(step.checked_sub(row.first)?).map(|um| i64::from(*um) * 1000)
    }
}

/// The zone of a class, `None` where the class is not defined.
pub(super) fn zone(feature: Feature, letter: Letter, grade: Grade, place: SizeSteps, options: Options) -> Option<Zone> {
    let steps = letter.row().map_or(Steps::Main, |row| row.steps);
    let above_one = not_up_to_one(feature, letter, grade);
    if place.up_to_one && above_one {
        return None;
    }
    let width = standard_tolerance(grade, place)?;
    let (upper, lower) = match (letter, feature) {
        (Letter::Js, _) => {
            let half = half(width, grade, options.js);
            (half, -half)
        }
        (Letter::J, Feature::Shaft) => from_lower(place.row(shaft_j(grade, place)?)?, width),
        (Letter::J, Feature::Hole) => from_upper(place.row(hole_j(grade)?)?, width),
        (letter, Feature::Shaft) if letter <= Letter::H => {
            from_upper(clearance_deviation(letter, place, options)?, width)
        }
        (letter, Feature::Shaft) => from_lower(shaft_lower(letter, grade, place)?, width),
        // Rule 4: A to H mirror a to h.
        (letter, Feature::Hole) if letter <= Letter::H => {
            from_lower(-clearance_deviation(letter, place, options)?, width)
        }
        (letter, Feature::Hole) => from_upper(hole_upper(letter, grade, place)?, width),
    };
    Some(Zone { upper, lower, steps, above_one })
}

const fn from_upper(upper: i64, width: i64) -> (i64, i64) {
    (upper, upper - width)
}

const fn from_lower(lower: i64, width: i64) -> (i64, i64) {
    (lower + width, lower)
}

/// Rule 2: the standard tolerance; IT01 and IT0 end at 500 mm.
fn standard_tolerance(grade: Grade, place: SizeSteps) -> Option<i64> {
    let tenths = STANDARD_TOLERANCES.get(grade.row())?.get(place.main)?;
    Some(i64::from(*tenths) * 100)
}

/// Rule 11: a, b and the grades from 14 on are not used up to 1 mm, nor is N from grade 9 on.
const fn not_up_to_one(feature: Feature, letter: Letter, grade: Grade) -> bool {
    matches!(letter, Letter::A | Letter::B)
        || grade.at_least(14)
        || (matches!((feature, letter), (Feature::Hole, Letter::N)) && grade.at_least(9))
}

/// Rule 5: halves are kept, unless the 1988 rounding is chosen, where an odd tolerance of grades 7 to 11 loses 1 µm.
const fn half(width: i64, grade: Grade, js: JsHalves) -> i64 {
    let rounded = matches!(js, JsHalves::Rounded) && grade.at_least(7) && grade.at_most(11);
    if rounded && width % 2000 == 1000 { (width - 1000) / 2 } else { width / 2 }
}

/// es of a to h. Rule 8: cd, ef and fg end at 10 mm in the 1988 edition.
fn clearance_deviation(letter: Letter, place: SizeSteps, options: Options) -> Option<i64> {
    let short = matches!(letter, Letter::Cd | Letter::Ef | Letter::Fg);
    if short && matches!(options.edition, Edition::Of1988) && 2 < place.main {
        return None;
    }
    match letter.row() {
        Some(row) => place.row(row),
        None => Some(0),
    }
}

/// Rule 8: j5, j6 and j7 to 500 mm, j8 to 3 mm, where its ei is −6 µm.
fn shaft_j(grade: Grade, place: SizeSteps) -> Option<&'static LetterDeviations> {
    if grade == Grade::IT5 || grade == Grade::IT6 {
        Some(&figures::J5_AND_6)
    } else if grade == Grade::IT7 {
        Some(&figures::J7)
    } else if grade == Grade::IT8 && place.up_to_3() {
        Some(&figures::J8)
    } else {
        None
    }
}

/// Rule 8: J6, J7 and J8 to 500 mm.
fn hole_j(grade: Grade) -> Option<&'static LetterDeviations> {
    let number = [Grade::IT6, Grade::IT7, Grade::IT8].iter().position(|&it| it == grade)?;
    figures::HOLE_J.get(number)
}

/// ei of k to zc.
fn shaft_lower(letter: Letter, grade: Grade, place: SizeSteps) -> Option<i64> {
    // Rule 7: k is above 0 only in IT4 to IT7 and up to 500 mm.
    if letter == Letter::K && (place.above_500() || !grade.at_least(4) || grade.at_least(8)) {
        return Some(0);
    }
    place.row(letter.row()?)
}

/// ES of K to ZC: rules 4, 6 and 7.
fn hole_upper(letter: Letter, grade: Grade, place: SizeSteps) -> Option<i64> {
    let k_to_n = letter <= Letter::N;
    if letter == Letter::K && grade.at_least(9) && !place.up_to_3() {
        return None;
    }
    if letter == Letter::K && place.above_500() {
        return Some(0);
    }
    let mirrored = -place.row(letter.row()?)?;
    if place.up_to_3() || place.above_500() {
        return Some(mirrored);
    }
    // Rule 10: no Δ is printed for IT01 to IT2, so these are refused.
    if !grade.at_least(3) {
        return None;
    }
    match letter {
        Letter::N if grade.at_least(9) => return Some(0),
        // The one printed exception: above 250 up to 315 mm.
        Letter::M if grade == Grade::IT6 && place.main == 10 => return Some(-9_000),
        _ => {}
    }
    let with_delta = grade.at_most(if k_to_n { 8 } else { 7 });
    Some(if with_delta { mirrored + delta(grade, place)? } else { mirrored })
}

/// Rule 6: Δ = IT(n) − IT(n − 1).
fn delta(grade: Grade, place: SizeSteps) -> Option<i64> {
    Some(standard_tolerance(grade, place)? - standard_tolerance(grade.finer()?, place)?)
}
