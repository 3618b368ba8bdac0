//! The programs that measure the kinds of features: which cycle each calls, and with which parameters of the set.
//!
//! A diameter is measured by the built-in program 82551 (see `check`). For every other kind the same program gets
//! another cycle in place of its two: the one that the declaration of the cycles has for that shape, with the parameters
//! of the plan by their meaning. No number of a cycle or of its parameters is named here.
//!
//! | parameter of the set | what |
//! |---|---|
//! | Q1, QS1 | nominal size and class; of a pocket or boss along X; QS1 of a point: its band |
//! | Q71, QS6 | those of a pocket or boss along Y |
//! | Q11, Q21, Q31 | the place |
//! | Q41 | the first angle of a diameter; the measured axis of a width or face |
//! | Q42 | the direction of a face |
//! | Q41, Q42, Q43 | the normal of a point |
//! | QS9 | nominal size with its tolerance, where the cycle takes that as a text |
//! | Q51, Q61 | clearance and clearance height |
//! | Q23, Q33, Q62 | maximum, minimum, and the nominal size moved between them; of a pocket or boss along Y |
//! | Q73, Q83, Q72 | those of a pocket or boss along X |

use fitcheck_core::part::FeatureKind;
use fitcheck_core::probing::cycle::{Axis, Control as CycleControl, Cycle, Key, Meaning, Parameter};
use fitcheck_core::probing::cycles::{cycles_of, measuring_cycles_of};
use fitcheck_core::probing::simulated::Shape;
use fitcheck_core::tolerance::Feature;
use fitcheck_core::words::Dialogue;

/// The kinds of called programs, in the order of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Called {
    Diameter,
    Width,
    Face,
    Rectangle,
    Point,
}

/// The parameter that replaces the nominal size where that must lie between the limits.
pub(super) const BETWEEN: &str = "Q62";

/// The parameter of the nominal size.
pub(super) const NOMINAL: &str = "Q1";

/// The nominal size with its tolerance, for a cycle that takes both as a text.
const TEXT: &str = "QS9";

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

impl Called {
    pub(super) const ALL: [Self; 5] = [Self::Diameter, Self::Width, Self::Face, Self::Rectangle, Self::Point];

    /// The program of a kind; `None` of what no cycle measures.
    pub(super) const fn of(kind: &FeatureKind) -> Option<Self> {
        Some(match kind {
            FeatureKind::Diameter(_) => Self::Diameter,
            FeatureKind::Width(..) => Self::Width,
            FeatureKind::Face(..) => Self::Face,
            FeatureKind::Pocket(_) | FeatureKind::Boss(_) => Self::Rectangle,
            FeatureKind::Point(..) => Self::Point,
            FeatureKind::Length(_) | FeatureKind::Form(_) => return None,
        })
    }

    const fn shape(self, feature: Feature) -> Shape {
        match (self, feature) {
            (Self::Diameter, Feature::Hole) => Shape::Hole,
            (Self::Diameter, Feature::Shaft) => Shape::Stud,
            (Self::Width, Feature::Hole) => Shape::Slot,
            (Self::Width, Feature::Shaft) => Shape::Ridge,
            (Self::Rectangle, Feature::Hole) => Shape::Pocket,
            (Self::Rectangle, Feature::Shaft) => Shape::Boss,
            (Self::Face, _) => Shape::Face,
            (Self::Point, _) => Shape::Point,
        }
    }

    /// The cycle that measures it.
    pub(super) fn cycle(self, feature: Feature) -> Option<&'static Cycle> {
        measuring_cycles_of(CycleControl::Milling).find(|cycle| cycle.shape() == self.shape(feature))
    }

    /// The control's name of the first parameter that has one of these meanings.
    pub(super) fn name_of(self, meanings: &[Meaning], language: Dialogue) -> String {
        let cycle = self.cycle(Feature::Shaft);
        let parameter = meanings.iter().find_map(|meaning| cycle?.meant(*meaning));
        parameter.map_or("", |parameter| parameter.name_in(language)).to_owned()
    }

    /// The blocks that measure it: the cycle with the parameters of the set.
    pub(super) fn blocks(self, feature: Feature, nominal: &str, language: Dialogue) -> Vec<u8> {
        let Some(cycle) = self.cycle(feature) else { return Vec::new() };
        let points = cycle.meant(Meaning::SecondPoint(Axis::First)).map_or("", |_| POINTS);
        (points.to_owned() + &block(cycle, feature, nominal, language)).into_bytes()
    }

    /// The limits of the cycle as its own mask names them, and the parameters of the set that have them.
    pub(super) fn limits(self) -> Vec<(Key, &'static str)> {
        let pairs = [
            (Meaning::MaximumWidth, "Q23"),
            (Meaning::MaximumCoordinate, "Q23"),
            (Meaning::MinimumWidth, "Q33"),
            (Meaning::MinimumCoordinate, "Q33"),
            (Meaning::MaximumSide(Axis::First), "Q73"),
            (Meaning::MinimumSide(Axis::First), "Q83"),
            (Meaning::MaximumSide(Axis::Second), "Q23"),
            (Meaning::MinimumSide(Axis::Second), "Q33"),
            (Meaning::Band, "QS1"),
        ];
        let cycle = self.cycle(Feature::Hole).filter(|_| self != Self::Diameter);
        pairs.iter().filter_map(|(meaning, to)| Some((cycle?.meant(*meaning)?.key, *to))).collect()
    }
}

/// The cycle of a diameter that takes the tolerance as a text.
pub(super) fn by_text() -> Option<&'static Cycle> {
    cycles_of(CycleControl::Milling).find(|cycle| cycle.takes_nominals() && cycle.shape() == Shape::Hole)
}

/// The blocks that measure a diameter by it: the text is nominal size and class, or deviations.
pub(super) fn blocks_by_text(feature: Feature, language: Dialogue) -> Vec<u8> {
    let Some(cycle) = by_text() else { return Vec::new() };
    let text = format!("QS5 = TOCHAR ( DAT+Q1 )\n{TEXT} = QS5 || QS1\n");
    (text + &block(cycle, feature, TEXT, language)).into_bytes()
}

/// A cycle with the parameters of the set.
fn block(cycle: &Cycle, feature: Feature, nominal: &str, language: Dialogue) -> String {
    let line = |parameter: &Parameter| {
        let value = given(parameter.meaning, feature, nominal)?;
        let pair = match parameter.key {
            // A number in place of a text.
            Key::Qs(number) if !value.starts_with("QS") => format!("Q{number}=+{value}"),
            Key::Qs(number) => format!("QS{number}={value}"),
            key => format!("{key}=+{value}"),
        };
        Some(format!("{pair} ;{}", parameter.name_in(language)))
    };
    let lines: Vec<String> = cycle.parameters.iter().filter_map(line).collect();
    format!("TCH PROBE {} {} ~\n  {}\n", cycle.code, cycle.name(language), lines.join(" ~\n  "))
}

/// The value of a parameter of a cycle; `None` keeps the default of one that a program need not have.
fn given(meaning: Meaning, feature: Feature, nominal: &str) -> Option<&str> {
    Some(match meaning {
        Meaning::Start(Axis::First) | Meaning::Point(Axis::First) | Meaning::Centre(Axis::First) => "Q11",
        Meaning::Start(Axis::Second) | Meaning::Point(Axis::Second) | Meaning::Centre(Axis::Second) => "Q21",
        Meaning::MeasuringHeight | Meaning::Point(Axis::Third) => "Q31",
        Meaning::FirstPoint(Axis::First) => "Q63",
        Meaning::FirstPoint(_) => "Q64",
        Meaning::SecondPoint(Axis::First) => "Q65",
        Meaning::SecondPoint(_) => "Q66",
        Meaning::AxisOfPlane | Meaning::MeasuredAxis | Meaning::Normal(Axis::First) | Meaning::FirstAngle => "Q41",
        Meaning::Direction | Meaning::Normal(Axis::Second) => "Q42",
        Meaning::Normal(Axis::Third) => "Q43",
        Meaning::SetUpClearance => "Q51",
        Meaning::ClearanceHeight => "Q61",
        Meaning::Width | Meaning::Side(Axis::Second) | Meaning::Diameter => nominal,
        Meaning::ContactCount => "4",
        Meaning::Arc => "360",
        Meaning::ClearanceMode if feature == Feature::Shaft => "2",
        Meaning::ClearanceMode => "1",
        Meaning::MaximumWidth | Meaning::MaximumCoordinate | Meaning::MaximumSide(Axis::Second) => "Q23",
        Meaning::MinimumWidth | Meaning::MinimumCoordinate | Meaning::MinimumSide(Axis::Second) => "Q33",
        Meaning::Side(Axis::First) => "Q72",
        Meaning::MaximumSide(Axis::First) => "Q73",
        Meaning::MinimumSide(Axis::First) => "Q83",
        Meaning::Band => "QS1",
        // As the built-in program moves: over a shaft, along the walls of a hole.
        Meaning::MoveToClearance | Meaning::InsideOutside if feature == Feature::Shaft => "1",
        // No shift, no log, no stop, no tool, no monitored centre, no move to the clearance height between the contacts.
        Meaning::MoveToClearance
        | Meaning::Shift
        | Meaning::Log
        | Meaning::Stop
        | Meaning::StopOnUndersize
        | Meaning::StopOnScrap
        | Meaning::PresetCorrection
        | Meaning::InsideOutside
        | Meaning::Geometries
        | Meaning::Tool
        | Meaning::CentreTolerance(_) => "0",
        _ => return None,
    })
}
