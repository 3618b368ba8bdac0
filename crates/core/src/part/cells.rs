//! Kinds of features as a plan and the command line have them: texts of a few cells.

use super::column::Column;
use super::fault::PlanFault;
use super::kind::{Direction, FeatureKind, Towards, WidthAxis};
use crate::length::Length;
use crate::probing::cycle::{Axis, number};
use crate::tolerance::callout::band;
use crate::tolerance::{Callout, Deviations, Feature};

/// The axes of a width.
const WIDTH_AXES: [&str; 2] = ["X", "Y"];

/// The directions of a face, and those of a point along an axis.
const DIRECTIONS: [&str; 6] = ["+X", "-X", "+Y", "-Y", "+Z", "-Z"];

/// Words that say diameter, and of which side: those of the drawing and of the languages of the window.
const DIAMETERS: [(&str, Feature); 6] = [
    ("hole", Feature::Hole),
    ("bore", Feature::Hole),
    ("boring", Feature::Hole),
    ("gat", Feature::Hole),
    ("shaft", Feature::Shaft),
    ("as", Feature::Shaft),
];

/// Words that say what no cycle measures, and the kind that they are of.
const BY_HAND: [(&str, &str); 14] = [
    ("distance", "length"),
    ("depth", "length"),
    ("height", "length"),
    ("thickness", "length"),
    ("radius", "length"),
    ("flatness", "form"),
    ("straightness", "form"),
    ("roundness", "form"),
    ("cylindricity", "form"),
    ("parallelism", "form"),
    ("perpendicularity", "form"),
    ("position", "form"),
    ("concentricity", "form"),
    ("runout", "form"),
];

/// The most characters of a cell that an error repeats.
const LONGEST: usize = 80;

/// A cell of a feature, and what is wrong with it.
pub type CellFault = (Column, PlanFault);

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

/// Hole or shaft, where the word for the kind says it.
pub(super) fn side_of(word: &str) -> Option<Feature> {
    DIAMETERS.into_iter().find(|(known, _)| known.eq_ignore_ascii_case(word)).map(|(_, side)| side)
}

impl KindCells<'_> {
    /// The kind.
    ///
    /// A width without an axis lies along X. The direction of a point is where the probe moves, such as `-Z` or three
    /// components with blanks between them: `0.5 0 -1`.
    ///
    /// # Errors
    /// Every column that is wrong, and what it has and what it may hold.
    pub fn read(&self) -> Result<FeatureKind, Vec<CellFault>> {
        let (kind, faults) = self.read_all();
        kind.filter(|_kind| faults.is_empty()).ok_or(faults)
    }

    /// The kind as far as its own cells say it, also beside a cell that it does not have, and every fault.
    pub(super) fn read_all(&self) -> (Option<FeatureKind>, Vec<CellFault>) {
        let word = self.kind.unwrap_or("diameter");
        let mut faults = Vec::new();
        let of_hand = BY_HAND.into_iter().find(|(known, _)| known.eq_ignore_ascii_case(word)).map(|(_, kind)| kind);
        let known = FeatureKind::WORDS.into_iter().find(|known| known.eq_ignore_ascii_case(word));
        if let Some(word) = known.or(of_hand) {
            return (self.of_kind(word, &mut faults), faults);
        }
        if let Some(side) = side_of(word) {
            let kind = self.of_kind("diameter", &mut faults);
            if let Some(FeatureKind::Diameter(callout)) = kind
                && let Some(other) = callout.feature().filter(|other| *other != side)
            {
                let given = word.to_owned();
                let text = callout.to_string();
                let fault = PlanFault::OtherSide { given, column: "callout", text, side: other };
                faults.push((Column::Kind, fault));
            }
            return (kind, faults);
        }
        faults.push((Column::Kind, unknown("kind", word, &FeatureKind::WORDS)));
        self.of_no_kind(&mut faults);
        (None, faults)
    }

    fn of_kind(&self, word: &'static str, faults: &mut Vec<CellFault>) -> Option<FeatureKind> {
        let is_rectangle = ["pocket", "boss"].contains(&word);
        let is_point = word == "point";
        for (column, given, is_of) in [
            (Column::SecondCallout, self.second, is_rectangle),
            (Column::Axis, self.axis, ["width", "face", "point"].contains(&word)),
        ] {
            if given.is_some() && !is_of {
                faults.push((column, PlanFault::NotOf { column: column.key(), kind: word }));
            }
        }
        if self.axis.is_none() && ["face", "point"].contains(&word) {
            faults.push((Column::Axis, PlanFault::NoCell { column: "axis" }));
        }
        let first = |faults: &mut Vec<CellFault>| kept(faults, Column::Callout, callout(self.callout));
        match word {
            "width" => {
                let first = first(faults);
                let axis = match self.axis.map(|axis| (axis, at(&WIDTH_AXES, axis))) {
                    None | Some((_, Some(0))) => WidthAxis::X,
                    Some((_, Some(_))) => WidthAxis::Y,
                    Some((given, None)) => {
                        faults.push((Column::Axis, unknown("axis", given, &WIDTH_AXES)));
                        return None;
                    }
                };
                Some(FeatureKind::Width(first?, axis))
            }
            "face" => {
                let first = first(faults);
                let axis = self.axis?;
                let towards = towards(axis).ok_or_else(|| unknown("axis", axis, &DIRECTIONS));
                let towards = kept(faults, Column::Axis, towards);
                Some(FeatureKind::Face(first?, towards?))
            }
            _ if is_point => {
                let band = kept(faults, Column::Callout, point_band(self.callout));
                let axis = self.axis?;
                let direction = kept(faults, Column::Axis, direction(axis).ok_or_else(|| no_direction(axis)));
                Some(FeatureKind::Point(band?, direction?))
            }
            _ if is_rectangle => {
                let first = first(faults);
                let second = match self.second {
                    Some(text) => kept(faults, Column::SecondCallout, callout(text)),
                    None => first,
                };
                let sides = [first?, second?];
                Some(if word == "boss" { FeatureKind::Boss(sides) } else { FeatureKind::Pocket(sides) })
            }
            "length" => Some(FeatureKind::Length(first(faults)?)),
            "form" => Some(FeatureKind::Form(kept(faults, Column::Callout, most(self.callout))?)),
            _ => Some(FeatureKind::Diameter(first(faults)?)),
        }
    }

    /// Of an unknown kind: what no kind could have in the other cells.
    fn of_no_kind(&self, faults: &mut Vec<CellFault>) {
        if point_band(self.callout).is_err() {
            kept(faults, Column::Callout, callout(self.callout));
        }
        if let Some(second) = self.second {
            kept(faults, Column::SecondCallout, callout(second));
        }
        if let Some(axis) = self.axis.filter(|axis| at(&WIDTH_AXES, axis).is_none()) {
            kept(faults, Column::Axis, direction(axis).ok_or_else(|| no_direction(axis)));
        }
    }
}

/// What a cell has, or its fault among the others.
fn kept<T>(faults: &mut Vec<CellFault>, column: Column, read: Result<T, PlanFault>) -> Option<T> {
    read.map_err(|fault| faults.push((column, fault))).ok()
}

fn no_direction(axis: &str) -> PlanFault {
    PlanFault::Direction { given: shortened(axis), known: DIRECTIONS.join(", ") }
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

/// The one limit of a form or location tolerance: a length above 0.
fn most(text: &str) -> Result<Length, PlanFault> {
    let read = text.trim().parse::<Length>().ok().filter(|most| Length::ZERO < *most);
    read.ok_or_else(|| PlanFault::NoFormLimit { text: shortened(text) })
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

/// What the cells of a kind say together: letters, band and coordinate go with it.
pub(super) fn check_kind(kind: &FeatureKind, place: [Option<Length>; 3]) -> Vec<CellFault> {
    let fault = match kind {
        FeatureKind::Diameter(_) | FeatureKind::Width(..) | FeatureKind::Length(_) | FeatureKind::Form(_) => None,
        FeatureKind::Face(callout, towards) => check_face(*callout, *towards, place),
        FeatureKind::Pocket(sides) => return check_sides(kind, *sides, Feature::Hole, "H7"),
        FeatureKind::Boss(sides) => return check_sides(kind, *sides, Feature::Shaft, "h7"),
        FeatureKind::Point(band, _) if is_band_of_cycle(band) => None,
        FeatureKind::Point(band, _) => Some(PlanFault::BandSide { upper: band.upper(), lower: band.lower() }),
    };
    fault.map(|what| (Column::Callout, what)).into_iter().collect()
}

/// The coordinate of a face is the nominal size, and it is judged as an outside dimension: too large is rework.
fn check_face(callout: Callout, towards: Towards, [x, y, z]: [Option<Length>; 3]) -> Option<PlanFault> {
    if callout.feature() == Some(Feature::Hole) {
        return Some(PlanFault::FaceClass { callout });
    }
    let coordinate = match towards.axis {
        Axis::First => x,
        Axis::Second => y,
        Axis::Third => z,
    };
    let coordinate = coordinate.filter(|coordinate| *coordinate != callout.nominal())?;
    Some(PlanFault::FacePlace { callout, coordinate })
}

/// The word and the letters say the same.
fn check_sides(kind: &FeatureKind, sides: [Callout; 2], feature: Feature, example: &'static str) -> Vec<CellFault> {
    let [first, second] = sides;
    let is_other = |callout: &Callout| callout.feature().is_some_and(|side| side != feature);
    // Without a cell of its own the second side has the callout of the first.
    let second = Some(second).filter(|second| *second != first);
    let all = [(Column::Callout, Some(first)), (Column::SecondCallout, second)];
    let others = all.into_iter().filter_map(|(column, callout)| Some((column, callout.filter(is_other)?)));
    others.map(|(column, callout)| (column, PlanFault::SideClass { callout, kind: kind.word(), example })).collect()
}

/// Whether the cycle takes a band: its text has an upper deviation of 0 or more and a lower one of 0 or less, and a band
/// without a width monitors nothing.
fn is_band_of_cycle(band: &Deviations) -> bool {
    band.lower() <= Length::ZERO && Length::ZERO <= band.upper() && band.lower() < band.upper()
}
