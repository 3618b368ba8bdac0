//! What is measured of a feature of a plan, and the blocks of the program that measures it.
//!
//! A diameter is measured by the built-in program 82551 (see `programs`). For a width and for a face the same program
//! gets another cycle in place of its two: the one that the declaration of the cycles has for that shape, with the
//! parameters of the plan by their meaning. No number of a cycle or of its parameters is named here.

use crate::probing::cycle::{Axis, Control, Cycle, Meaning};
use crate::probing::cycles::cycles_of;
use crate::probing::simulated::Shape;
use crate::tolerance::Feature;
use crate::words::Dialogue;

/// What is measured of a feature.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NcKind {
    /// The diameter of a hole or a shaft.
    #[default]
    Diameter,
    /// The width of a slot or a ridge.
    Width(WidthAxis),
    /// The coordinate of a face.
    Face(Towards),
}

/// The axis across the walls of a slot or ridge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum WidthAxis {
    /// X.
    #[default]
    X,
    /// Y.
    Y,
}

/// The direction in which a face is probed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Towards {
    /// The axis.
    pub axis: Axis,
    /// Whether the probe moves in plus direction.
    pub is_plus: bool,
}

/// The kinds of called programs, in the order of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Called {
    Diameter,
    Width,
    Face,
}

impl Called {
    pub(super) const ALL: [Self; 3] = [Self::Diameter, Self::Width, Self::Face];

    /// The shape that a feature has.
    const fn shape(self, feature: Feature) -> Shape {
        match (self, feature) {
            (Self::Diameter, Feature::Hole) => Shape::Hole,
            (Self::Diameter, Feature::Shaft) => Shape::Stud,
            (Self::Width, Feature::Hole) => Shape::Slot,
            (Self::Width, Feature::Shaft) => Shape::Ridge,
            (Self::Face, _) => Shape::Face,
        }
    }

    /// The cycle that measures it.
    pub(super) fn cycle(self, feature: Feature) -> Option<&'static Cycle> {
        cycles_of(Control::Milling).find(|cycle| cycle.shape() == self.shape(feature))
    }

    /// The blocks that measure it: the cycle with the parameters of the set.
    pub(super) fn blocks(self, feature: Feature, nominal: &str, language: Dialogue) -> Vec<u8> {
        let Some(cycle) = self.cycle(feature) else { return Vec::new() };
        let points = cycle.meant(Meaning::SecondPoint(Axis::First)).map_or("", |_| POINTS);
        let lines: Vec<String> = cycle
            .parameters
            .iter()
            .filter_map(|parameter| {
                let value = match parameter.meaning {
                    Meaning::Start(Axis::First) | Meaning::Point(Axis::First) => "Q11",
                    Meaning::Start(Axis::Second) | Meaning::Point(Axis::Second) => "Q21",
                    Meaning::FirstPoint(Axis::First) => "Q63",
                    Meaning::FirstPoint(_) => "Q64",
                    Meaning::SecondPoint(Axis::First) => "Q65",
                    Meaning::SecondPoint(_) => "Q66",
                    Meaning::MeasuringHeight => "Q31",
                    Meaning::AxisOfPlane | Meaning::MeasuredAxis => "Q41",
                    Meaning::Direction => "Q42",
                    Meaning::SetUpClearance => "Q51",
                    Meaning::ClearanceHeight => "Q61",
                    Meaning::Width => nominal,
                    Meaning::MaximumWidth | Meaning::MaximumCoordinate => "Q23",
                    Meaning::MinimumWidth | Meaning::MinimumCoordinate => "Q33",
                    // No shift, no log, no stop, no tool, no move to the clearance height between the contacts.
                    Meaning::Shift | Meaning::Log | Meaning::Stop | Meaning::Tool | Meaning::MoveToClearance => "0",
                    // What a program need not have keeps its default.
                    _ => return None,
                };
                Some(format!("{}=+{value} ;{}", parameter.key, parameter.name_in(language)))
            })
            .collect();
        let name = cycle.name(language);
        let lines = lines.join(" ~\n  ");
        format!("{points}TCH PROBE {} {name} ~\n  {lines}\n", cycle.code).into_bytes()
    }
}

/// The two points of a ridge: the walls at nominal size, the one with the larger coordinate first.
const POINTS: &str = "Q63 = Q11
Q64 = Q21
Q65 = Q11
Q66 = Q21
FN 9: IF +Q41 EQU +2 GOTO LBL 95
Q63 = Q11 + Q1 / 2
Q65 = Q11 - Q1 / 2
FN 9: IF +0 EQU +0 GOTO LBL 96
LBL 95
Q64 = Q21 + Q1 / 2
Q66 = Q21 - Q1 / 2
LBL 96
";

impl NcKind {
    /// Which program measures it.
    pub(super) const fn called(self) -> Called {
        match self {
            Self::Diameter => Called::Diameter,
            Self::Width(_) => Called::Width,
            Self::Face(_) => Called::Face,
        }
    }

    /// The number of the measured axis, 1 to 3; `None` for a diameter.
    pub(super) const fn axis(self) -> Option<usize> {
        match self {
            Self::Diameter => None,
            Self::Width(WidthAxis::X) | Self::Face(Towards { axis: Axis::First, .. }) => Some(1),
            Self::Width(WidthAxis::Y) | Self::Face(Towards { axis: Axis::Second, .. }) => Some(2),
            Self::Face(Towards { axis: Axis::Third, .. }) => Some(3),
        }
    }

    /// The unit vector of the measured axis, in the direction of the approach for a face.
    pub(super) fn direction(self) -> [f64; 3] {
        let sign = if let Self::Face(Towards { is_plus: false, .. }) = self { -1.0 } else { 1.0 };
        [1, 2, 3].map(|axis| if self.axis() == Some(axis) { sign } else { 0.0 })
    }

    /// Its name in a plan.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Diameter => "diameter",
            Self::Width(_) => "width",
            Self::Face(_) => "face",
        }
    }

    /// The names of all kinds in a plan.
    pub const WORDS: [&'static str; 3] = ["diameter", "width", "face"];

    /// The axes of a width.
    pub const WIDTH_AXES: [&'static str; 2] = ["X", "Y"];

    /// The directions of a face.
    pub const FACE_AXES: [&'static str; 6] = ["+X", "-X", "+Y", "-Y", "+Z", "-Z"];

    /// A kind by its name and its axis as a plan has them. A width without an axis lies along X.
    ///
    /// # Errors
    /// The column that is wrong, and what it may hold; nothing where it must stay empty.
    pub fn read(word: Option<&str>, axis: Option<&str>) -> Result<Self, (&'static str, &'static [&'static str])> {
        let is = |known: &&str, given: &str| known.eq_ignore_ascii_case(given);
        let word = word.unwrap_or("diameter");
        match Self::WORDS.iter().position(|known| is(known, word)) {
            Some(0) => {
                if axis.is_none() {
                    Ok(Self::Diameter)
                } else {
                    Err(("axis", &[]))
                }
            }
            Some(1) => match axis {
                None => Ok(Self::Width(WidthAxis::X)),
                Some(axis) if is(&"X", axis) => Ok(Self::Width(WidthAxis::X)),
                Some(axis) if is(&"Y", axis) => Ok(Self::Width(WidthAxis::Y)),
                Some(_) => Err(("axis", &Self::WIDTH_AXES)),
            },
            Some(_) => {
                let axis = axis.unwrap_or_default().replace('\u{2212}', "-");
                let at =
                    Self::FACE_AXES.iter().position(|known| is(known, &axis)).ok_or(("axis", &Self::FACE_AXES[..]))?;
                let axis = [Axis::First, Axis::Second, Axis::Third].into_iter().nth(at / 2).unwrap_or(Axis::Third);
                Ok(Self::Face(Towards { axis, is_plus: at % 2 == 0 }))
            }
            None => Err(("kind", &Self::WORDS)),
        }
    }
}

/// The parameter that replaces the nominal size where that must lie between the limits.
pub(super) const BETWEEN: &str = "Q62";

/// The parameter of the nominal size.
pub(super) const NOMINAL: &str = "Q1";
