//! What a parameter of a cycle means, so that a drawing can show it.
//!
//! Meanings as in the facts of the cycles: the manuals of TNC 640, CNC PILOT 640 and
//! TNC7 and the cycle manual of the TNC 320. A cycle that is not known here is drawn all the same:
//! by what its Q numbers mean in every milling cycle, else by the range of the value.

use crate::probing::cycle::{Cycle, Key, Parameter, Range};

/// What is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scene {
    Hole,
    Stud,
    /// A plane face.
    Face,
    /// A point of a free surface.
    Surface,
    /// A circle in any plane, inside or outside.
    Turned,
}

/// What a parameter means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Meaning {
    /// The nominal centre, in the axis so many.
    Centre(Axis),
    /// The permitted deviation of the centre.
    CentreTolerance(Axis),
    Diameter,
    MaximumSize,
    MinimumSize,
    StartDiameter,
    FirstAngle,
    Step,
    /// The longest probing path, with its direction.
    Path,
    /// How far two touches of one contact may differ.
    Difference,
    MeasuringHeight,
    SetUpClearance,
    ClearanceHeight,
    /// The point to be touched.
    Point(Axis),
    MaximumCoordinate,
    MinimumCoordinate,
    /// A component of the surface normal.
    Normal(Axis),
    /// The permitted deviation along the normal.
    Band,
    Retract,
    // One of a few numbers.
    MoveToClearance,
    Traverse,
    ContactCount,
    Plane,
    Side,
    MeasuredAxis,
    Direction,
    Log,
    Stop,
    /// With a stop for undersize only.
    StopOnUndersize,
    Tool,
    // What a cycle that is not known here asks for.
    Length,
    Angle,
    Choice(&'static [i64]),
    Number,
}

/// An axis of the machine, or of the plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Axis {
    First,
    Second,
    Third,
}

type Meanings = &'static [(Key, Meaning)];

/// What every milling cycle calls by these numbers.
const MILLING: Meanings = &[
    (Key::Q(260), Meaning::ClearanceHeight),
    (Key::Q(261), Meaning::MeasuringHeight),
    (Key::Q(320), Meaning::SetUpClearance),
    (Key::Q(281), Meaning::Log),
    (Key::Q(309), Meaning::Stop),
    (Key::Q(330), Meaning::Tool),
    (Key::Q(301), Meaning::MoveToClearance),
    (Key::Q(263), Meaning::Point(Axis::First)),
    (Key::Q(264), Meaning::Point(Axis::Second)),
    (Key::Q(294), Meaning::Point(Axis::Third)),
    (Key::Q(272), Meaning::MeasuredAxis),
    (Key::Q(267), Meaning::Direction),
    (Key::Q(288), Meaning::MaximumCoordinate),
    (Key::Q(289), Meaning::MinimumCoordinate),
    (Key::Q(581), Meaning::Normal(Axis::First)),
    (Key::Q(582), Meaning::Normal(Axis::Second)),
    (Key::Q(583), Meaning::Normal(Axis::Third)),
    (Key::Qs(400), Meaning::Band),
    (Key::Word("MB"), Meaning::Retract),
];

const CIRCLES: Meanings = &[
    (Key::Q(273), Meaning::Centre(Axis::First)),
    (Key::Q(274), Meaning::Centre(Axis::Second)),
    (Key::Q(262), Meaning::Diameter),
    (Key::Q(325), Meaning::FirstAngle),
    (Key::Q(247), Meaning::Step),
    (Key::Q(275), Meaning::MaximumSize),
    (Key::Q(276), Meaning::MinimumSize),
    (Key::Q(277), Meaning::MaximumSize),
    (Key::Q(278), Meaning::MinimumSize),
    (Key::Q(279), Meaning::CentreTolerance(Axis::First)),
    (Key::Q(280), Meaning::CentreTolerance(Axis::Second)),
    (Key::Q(423), Meaning::ContactCount),
    (Key::Q(365), Meaning::Traverse),
];

const SURFACES: Meanings = &[(Key::Q(309), Meaning::StopOnUndersize)];

const LATHE: Meanings = &[
    (Key::Word("R"), Meaning::Plane),
    (Key::Word("BR"), Meaning::Side),
    (Key::Word("K"), Meaning::Path),
    (Key::Word("C"), Meaning::FirstAngle),
    (Key::Word("RC"), Meaning::Step),
    (Key::Word("D"), Meaning::StartDiameter),
    (Key::Word("WB"), Meaning::MeasuringHeight),
    (Key::Word("I"), Meaning::Centre(Axis::First)),
    (Key::Word("J"), Meaning::Centre(Axis::Second)),
    (Key::Word("WE"), Meaning::Difference),
];

/// What is drawn for a cycle, and what only its own parameters mean. A new cycle needs a line here only where it wants
/// more than what the milling cycles share.
const SCENES: &[(u16, Scene, Meanings)] = &[
    (421, Scene::Hole, CIRCLES),
    (422, Scene::Stud, CIRCLES),
    (427, Scene::Face, &[]),
    (444, Scene::Surface, SURFACES),
    (785, Scene::Turned, LATHE),
];

impl Scene {
    /// What is measured by a cycle; a face where it is not known.
    pub(super) fn of(cycle: &Cycle) -> Self {
        SCENES.iter().find(|(number, ..)| *number == cycle.number).map_or(Self::Face, |(_, scene, _)| *scene)
    }
}

impl Meaning {
    /// What a parameter of a cycle means.
    pub(super) fn of(cycle: &Cycle, parameter: &Parameter) -> Self {
        let own = SCENES.iter().find(|(number, ..)| *number == cycle.number);
        let own = own.map_or(&[][..], |(_, _, own)| *own);
        let known = own.iter().chain(MILLING).find(|(key, _)| *key == parameter.key);
        known.map_or_else(|| Self::by_range(parameter.range), |(_, meaning)| *meaning)
    }

    const fn by_range(range: Range) -> Self {
        match range {
            Range::Length { .. } => Self::Length,
            Range::Angle { .. } => Self::Angle,
            Range::OneOf(of) => Self::Choice(of),
            Range::Number { .. } => Self::Number,
            Range::Tool => Self::Tool,
            Range::Band => Self::Band,
        }
    }

    /// The name of its sentence.
    pub(super) const fn id(self) -> &'static str {
        match self {
            Self::Centre(Axis::First) => "cycle-picture-centre-1",
            Self::Centre(_) => "cycle-picture-centre-2",
            Self::CentreTolerance(Axis::First) => "cycle-picture-centre-tolerance-1",
            Self::CentreTolerance(_) => "cycle-picture-centre-tolerance-2",
            Self::Diameter => "cycle-picture-diameter",
            Self::MaximumSize => "cycle-picture-maximum-size",
            Self::MinimumSize => "cycle-picture-minimum-size",
            Self::StartDiameter => "cycle-picture-start-diameter",
            Self::FirstAngle => "cycle-picture-first-angle",
            Self::Step => "cycle-picture-step",
            Self::Path => "cycle-picture-longest-path",
            Self::Difference => "cycle-picture-difference",
            Self::MeasuringHeight => "cycle-picture-measuring-height",
            Self::SetUpClearance => "cycle-picture-set-up-clearance",
            Self::ClearanceHeight => "cycle-picture-clearance-height",
            Self::Point(Axis::First) => "cycle-picture-point-1",
            Self::Point(Axis::Second) => "cycle-picture-point-2",
            Self::Point(Axis::Third) => "cycle-picture-point-3",
            Self::MaximumCoordinate => "cycle-picture-maximum-coordinate",
            Self::MinimumCoordinate => "cycle-picture-minimum-coordinate",
            Self::Normal(Axis::First) => "cycle-picture-normal-1",
            Self::Normal(Axis::Second) => "cycle-picture-normal-2",
            Self::Normal(Axis::Third) => "cycle-picture-normal-3",
            Self::Band => "cycle-picture-band",
            Self::Retract => "cycle-picture-retract",
            Self::MoveToClearance => "cycle-picture-move-to-clearance",
            Self::Traverse => "cycle-picture-traverse",
            Self::ContactCount => "cycle-picture-contact-count",
            Self::Plane => "cycle-picture-plane",
            Self::Side => "cycle-picture-side",
            Self::MeasuredAxis => "cycle-picture-measured-axis",
            Self::Direction => "cycle-picture-direction",
            Self::Log => "cycle-picture-log",
            Self::Stop => "cycle-picture-stop",
            Self::StopOnUndersize => "cycle-picture-stop-on-undersize",
            Self::Tool => "cycle-picture-tool",
            Self::Length => "cycle-picture-any-length",
            Self::Angle => "cycle-picture-any-angle",
            Self::Choice(_) => "cycle-picture-any-choice",
            Self::Number => "cycle-picture-any-number",
        }
    }
}
