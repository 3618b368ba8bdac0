//! Kinds of features as a plan and the command line have them: texts of a few cells.

use super::column::Column;
use super::fault::PlanFault;
use super::kind::{Direction, Kind, Towards, WidthAxis};
use crate::length::Length;
use crate::probing::cycle::{Axis, number};
use crate::tolerance::callout::band;
use crate::tolerance::{Callout, Deviations};

/// The axes of a width.
const WIDTH_AXES: [&str; 2] = ["X", "Y"];

/// The directions of a face, and those of a point along an axis.
const DIRECTIONS: [&str; 6] = ["+X", "-X", "+Y", "-Y", "+Z", "-Z"];

/// The most characters of a cell that an error repeats.
const LONGEST: usize = 80;

/// What a plan says of a feature's kind and its sizes.
#[derive(Debug, Clone, Copy)]
pub struct KindCells<'a> {
    /// The kind; a diameter if not given.
    pub kind: Option<&'a str>,
    /// The measured axis, or the direction.
    pub axis: Option<&'a str>,
    /// Nominal size and class, or the band of a point.
    pub callout: &'a str,
    /// The same for the side of a pocket or boss along Y; if not given, that along X.
    pub second: Option<&'a str>,
}

impl KindCells<'_> {
    /// The kind.
    ///
    /// A width without an axis lies along X. The direction of a point is where the probe moves, such as `-Z` or three
    /// components with blanks between them: `0.5 0 -1`.
    ///
    /// # Errors
    /// The column, and what it has and what it may hold.
    pub fn read(&self) -> Result<Kind, (Column, PlanFault)> {
        let word = self.kind.unwrap_or("diameter");
        let Some(word) = Kind::WORDS.into_iter().find(|known| known.eq_ignore_ascii_case(word)) else {
            return Err((Column::Kind, unknown("kind", word, &Kind::WORDS)));
        };
        let has_no = |column: Column, given: Option<&str>| match given {
            Some(_) => Err((column, PlanFault::NotOf { column: column.key(), kind: word })),
            None => Ok(()),
        };
        if !["pocket", "boss"].contains(&word) {
            has_no(Column::SecondCallout, self.second)?;
        }
        let first = || callout(self.callout).map_err(|fault| (Column::Callout, fault));
        let axis = || self.axis.ok_or((Column::Axis, PlanFault::NoCell { column: "axis" }));
        match word {
            "width" => {
                let axis = match self.axis.map_or(Some(0), |axis| at(&WIDTH_AXES, axis)) {
                    Some(0) => WidthAxis::X,
                    Some(_) => WidthAxis::Y,
                    None => {
                        let given = self.axis.unwrap_or_default();
                        return Err((Column::Axis, unknown("axis", given, &WIDTH_AXES)));
                    }
                };
                Ok(Kind::Width(first()?, axis))
            }
            "face" => {
                let axis = axis()?;
                let towards = towards(axis).ok_or_else(|| (Column::Axis, unknown("axis", axis, &DIRECTIONS)))?;
                Ok(Kind::Face(first()?, towards))
            }
            "point" => {
                let axis = axis()?;
                let no_direction = || PlanFault::Direction { given: shortened(axis), known: DIRECTIONS.join(", ") };
                let direction = direction(axis).ok_or_else(|| (Column::Axis, no_direction()))?;
                let band = point_band(self.callout).map_err(|fault| (Column::Callout, fault))?;
                Ok(Kind::Point(band, direction))
            }
            "pocket" | "boss" => {
                has_no(Column::Axis, self.axis)?;
                let first = first()?;
                let second = self.second.map_or(Ok(first), callout);
                let sides = [first, second.map_err(|fault| (Column::SecondCallout, fault))?];
                Ok(if word == "boss" { Kind::Boss(sides) } else { Kind::Pocket(sides) })
            }
            _ => {
                has_no(Column::Axis, self.axis)?;
                Ok(Kind::Diameter(first()?))
            }
        }
    }
}

/// Which of the known words it is.
fn at(known: &[&str], given: &str) -> Option<usize> {
    known.iter().position(|known| known.eq_ignore_ascii_case(given))
}

fn unknown(column: &'static str, given: &str, known: &[&str]) -> PlanFault {
    PlanFault::Unknown { column, given: given.chars().take(40).collect(), known: known.join(", ") }
}

fn shortened(text: &str) -> String {
    text.chars().take(LONGEST).collect()
}

fn callout(text: &str) -> Result<Callout, PlanFault> {
    text.parse().map_err(|error| PlanFault::Callout { text: shortened(text), error: Box::new(error) })
}

/// A band about the nominal place; whether the cycle takes it is checked with the plan.
fn point_band(text: &str) -> Result<Deviations, PlanFault> {
    band(text).map_err(|error| PlanFault::NoBand { text: shortened(text), error: Box::new(error) })
}

/// `+X` to `-Z`, also with a true minus.
fn towards(text: &str) -> Option<Towards> {
    let at = at(&DIRECTIONS, &text.replace('\u{2212}', "-"))?;
    let axis = [Axis::First, Axis::Second, Axis::Third].into_iter().nth(at / 2)?;
    Some(Towards { axis, is_plus: at % 2 == 0 })
}

/// One of the six, or three numbers.
fn direction(text: &str) -> Option<Direction> {
    if let Some(towards) = towards(text) {
        return Direction::new(towards.vector());
    }
    let parts: Option<Vec<f64>> = text.split_whitespace().map(number).collect();
    Direction::new(parts?.try_into().ok()?)
}

/// Whether the cycle takes a band: its text has an upper deviation of 0 or more and a lower one of 0 or less, and a band
/// without a width monitors nothing.
pub(super) fn is_band_of_cycle(band: &Deviations) -> bool {
    band.lower() <= Length::ZERO && Length::ZERO <= band.upper() && band.lower() < band.upper()
}
