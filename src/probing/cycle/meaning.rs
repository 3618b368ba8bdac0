//! What a parameter means: how it is drawn, and which sentence explains it.
//!
//! A cycle declares the meaning of each of its parameters; the drawings, the log and the status window ask for a meaning
//! and never for the number of a parameter. A new cycle whose meanings are here needs no drawing of its own.

use super::parameter::Range;

/// What a parameter means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Meaning {
    /// The nominal centre, in one axis.
    Centre(Axis),
    /// The permitted deviation of the centre, in one axis.
    CentreTolerance(Axis),
    /// The nominal diameter.
    Diameter,
    /// The largest permitted diameter.
    MaximumDiameter,
    /// The smallest permitted diameter.
    MinimumDiameter,
    /// The nominal length of a rectangle's side, along one axis.
    Side(Axis),
    /// The largest permitted length of a side.
    MaximumSide(Axis),
    /// The smallest permitted length of a side.
    MinimumSide(Axis),
    /// The nominal width of a slot or ridge.
    Width,
    /// The largest permitted width.
    MaximumWidth,
    /// The smallest permitted width.
    MinimumWidth,
    /// Where the probe begins in a slot, in one axis.
    Start(Axis),
    /// How far the second contact is shifted across the measured axis.
    Shift,
    /// The first point of a ridge, in one axis.
    FirstPoint(Axis),
    /// The second point of a ridge, in one axis.
    SecondPoint(Axis),
    /// The diameter of the circle on which the probe stands before each contact.
    StartDiameter,
    /// The angle of the first contact.
    FirstAngle,
    /// The angle from contact to contact.
    Step,
    /// The longest probing path, with its direction.
    Path,
    /// How far two readings of one contact may differ.
    Difference,
    /// The height of the ball's centre during contact.
    MeasuringHeight,
    /// The clearance before the contact.
    SetUpClearance,
    /// The height at which nothing is in the way.
    ClearanceHeight,
    /// The point that is probed, in one axis.
    Point(Axis),
    /// The largest permitted coordinate.
    MaximumCoordinate,
    /// The smallest permitted coordinate.
    MinimumCoordinate,
    /// A component of the surface normal.
    Normal(Axis),
    /// The permitted deviation along the normal.
    Band,
    /// The way back from the contact.
    Retract,
    /// The way between contacts: at measuring height, or over the clearance height.
    MoveToClearance,
    /// The way to the next contact: straight, or on an arc.
    Traverse,
    /// The number of contacts.
    ContactCount,
    /// The plane of a circle.
    Plane,
    /// Inside or outside.
    InsideOutside,
    /// The measured axis, one of three.
    MeasuredAxis,
    /// The measured axis, one of the two of the plane.
    AxisOfPlane,
    /// The direction of the approach.
    Direction,
    /// The measuring log.
    Log,
    /// Whether the program stops.
    Stop,
    /// The same, with a stop for undersize only.
    StopOnUndersize,
    /// The tool to be monitored.
    Tool,
    /// A length without a drawing of its own.
    Length,
    /// An angle without a drawing of its own.
    Angle,
    /// A choice without a drawing of its own.
    Choice,
    /// A number without a drawing of its own.
    Number,
}

/// An axis of the machine, or of the plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// The first.
    First,
    /// The second.
    Second,
    /// The third.
    Third,
}

impl Meaning {
    /// What is said of a parameter whose declaration says no more than its range.
    pub(super) const fn of_range(range: Range) -> Self {
        match range {
            Range::Length { .. } => Self::Length,
            Range::Angle { .. } => Self::Angle,
            Range::OneOf(_) => Self::Choice,
            Range::Number { .. } => Self::Number,
            Range::Tool => Self::Tool,
            Range::Band => Self::Band,
        }
    }

    /// Whether nothing but the range is known.
    pub const fn is_general(self) -> bool {
        matches!(self, Self::Length | Self::Angle | Self::Choice | Self::Number)
    }

    /// Its word in the ids of texts: `cycle-picture-diameter` is its sentence, `cycles-choice-log-1` what 1 chooses.
    pub fn word(self) -> String {
        let of = |word: &str, axis: Axis| format!("{word}-{}", axis.number());
        match self {
            Self::Centre(axis) => of("centre", axis),
            Self::CentreTolerance(axis) => of("centre-tolerance", axis),
            Self::Side(axis) => of("side-length", axis),
            Self::MaximumSide(axis) => of("maximum-side", axis),
            Self::MinimumSide(axis) => of("minimum-side", axis),
            Self::Start(axis) => of("start", axis),
            Self::FirstPoint(axis) => of("first-point", axis),
            Self::SecondPoint(axis) => of("second-point", axis),
            Self::Point(axis) => of("point", axis),
            Self::Normal(axis) => of("normal", axis),
            other => other.plain_word().to_owned(),
        }
    }

    const fn plain_word(self) -> &'static str {
        match self {
            Self::Diameter => "diameter",
            Self::MaximumDiameter => "maximum-size",
            Self::MinimumDiameter => "minimum-size",
            Self::Width => "width",
            Self::MaximumWidth => "maximum-width",
            Self::MinimumWidth => "minimum-width",
            Self::Shift => "shift",
            Self::StartDiameter => "start-diameter",
            Self::FirstAngle => "first-angle",
            Self::Step => "step",
            Self::Path => "longest-path",
            Self::Difference => "difference",
            Self::MeasuringHeight => "measuring-height",
            Self::SetUpClearance => "set-up-clearance",
            Self::ClearanceHeight => "clearance-height",
            Self::MaximumCoordinate => "maximum-coordinate",
            Self::MinimumCoordinate => "minimum-coordinate",
            Self::Band => "band",
            Self::Retract => "retract",
            Self::MoveToClearance => "move-to-clearance",
            Self::Traverse => "traverse",
            Self::ContactCount => "contact-count",
            Self::Plane => "plane",
            Self::InsideOutside => "side",
            Self::MeasuredAxis => "measured-axis",
            Self::AxisOfPlane => "axis-of-plane",
            Self::Direction => "direction",
            Self::Log => "log",
            Self::Stop => "stop",
            Self::StopOnUndersize => "stop-on-undersize",
            Self::Tool => "tool",
            Self::Angle => "any-angle",
            Self::Choice => "any-choice",
            Self::Number => "any-number",
            _ => "any-length",
        }
    }
}

impl Axis {
    /// 1, 2 or 3.
    pub const fn number(self) -> i64 {
        match self {
            Self::First => 1,
            Self::Second => 2,
            Self::Third => 3,
        }
    }
}
