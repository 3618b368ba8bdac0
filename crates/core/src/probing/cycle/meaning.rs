//! What a parameter means: how it is drawn, and which sentence explains it.
//!
//! A cycle declares the meaning of each of its parameters; the drawings, the log and the status window go by meaning,
//! never by the number of a parameter. A new cycle with meanings from here needs no drawing of its own.

use super::range::Range;

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
    /// The second point of a line, in one axis.
    NextPoint(Axis),
    /// The nominal centre of a second circle, in one axis.
    SecondCentre(Axis),
    /// Its nominal diameter.
    SecondDiameter,
    /// The height at which a second circle is probed.
    SecondHeight,
    /// Holes or studs: the first one and the second.
    Geometries,
    /// The diameter of the circle on which the probe waits before each contact.
    StartDiameter,
    /// The angle of the first contact.
    FirstAngle,
    /// The angle from contact to contact.
    Step,
    /// The angle over which the contacts lie.
    Arc,
    /// The longest probing path, with its direction.
    Path,
    /// How far two probings of one contact may differ.
    Difference,
    /// The height of the ball's centre during contact.
    MeasuringHeight,
    /// The clearance before the contact.
    SetUpClearance,
    /// The height at which the probe moves freely.
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
    /// Where the probe goes to the clearance height: never, before and after the cycle, each object, each contact.
    ClearanceMode,
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
    /// The measured axis with the direction of the approach as its sign.
    DirectedAxis,
    /// Whether the probe axis is probed, too, and set.
    ToolAxisProbing,
    /// Where the probe axis is probed, in one axis.
    ToolAxisPoint(Axis),
    /// The coordinate that the measured place gets, in one axis.
    NewDatum(Axis),
    /// The coordinate that the measured place gets in the axis that is measured.
    NewCoordinate,
    /// The row of a table that the datum is written into.
    TableRow,
    /// Which table that is.
    Transfer,
    /// Whether the active preset is corrected, and by which point.
    PresetCorrection,
    /// The angle that the measured edge is aligned to.
    AlignedAngle,
    /// The rotary axis that turns the edge into line.
    CompensationAxis,
    /// Whether that axis is set to zero afterwards.
    ZeroAfterAlignment,
    /// Whether rotary axes move to align the measured line.
    RotaryAlignment,
    /// What the measured angle becomes: nothing, a basic rotation, an offset of the rotary axis.
    RotationTransfer,
    /// The measuring log.
    Log,
    /// Whether the program stops.
    Stop,
    /// The same, with a stop for undersize only.
    StopOnUndersize,
    /// The same, with a stop for scrap only.
    StopOnScrap,
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

/// The group of a form in which a parameter stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ParameterGroup {
    /// What is measured and where.
    Position,
    /// How the probe gets there.
    Probing,
    /// What is permitted.
    Tolerance,
    /// What is made of it: log, stop, tool.
    Output,
}

impl ParameterGroup {
    /// Every group, in the order of a form.
    pub const ALL: [Self; 4] = [Self::Position, Self::Probing, Self::Tolerance, Self::Output];
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

// Sentences of the three axes.
const NEXT_POINT: [&str; 3] =
    ["cycle-picture-next-point-1", "cycle-picture-next-point-2", "cycle-picture-next-point-3"];
const POINT: [&str; 3] = ["cycle-picture-point-1", "cycle-picture-point-2", "cycle-picture-point-3"];
const NORMAL: [&str; 3] = ["cycle-picture-normal-1", "cycle-picture-normal-2", "cycle-picture-normal-3"];
const TOOL_AXIS_POINT: [&str; 3] =
    ["cycle-picture-tool-axis-point-1", "cycle-picture-tool-axis-point-2", "cycle-picture-tool-axis-point-3"];
const NEW_DATUM: [&str; 3] = ["cycle-picture-new-datum-1", "cycle-picture-new-datum-2", "cycle-picture-new-datum-3"];

impl Axis {
    const fn of_three(self, [first, second, third]: [&'static str; 3]) -> &'static str {
        match self {
            Self::First => first,
            Self::Second => second,
            Self::Third => third,
        }
    }

    /// A plane has two axes.
    const fn of_two(self, [first, second]: [&'static str; 2]) -> &'static str {
        self.of_three([first, second, second])
    }
}

impl Meaning {
    /// The group in which a parameter of this meaning stands.
    pub const fn group(self) -> ParameterGroup {
        match self {
            Self::Centre(_)
            | Self::Diameter
            | Self::Side(_)
            | Self::Width
            | Self::Start(_)
            | Self::FirstPoint(_)
            | Self::SecondPoint(_)
            | Self::NextPoint(_)
            | Self::SecondCentre(_)
            | Self::SecondDiameter
            | Self::SecondHeight
            | Self::Geometries
            | Self::Point(_)
            | Self::Normal(_)
            | Self::Plane
            | Self::InsideOutside
            | Self::MeasuredAxis
            | Self::AxisOfPlane
            | Self::DirectedAxis
            | Self::MeasuringHeight => ParameterGroup::Position,
            Self::CentreTolerance(_)
            | Self::MaximumDiameter
            | Self::MinimumDiameter
            | Self::MaximumSide(_)
            | Self::MinimumSide(_)
            | Self::MaximumWidth
            | Self::MinimumWidth
            | Self::MaximumCoordinate
            | Self::MinimumCoordinate
            | Self::Band => ParameterGroup::Tolerance,
            Self::Log
            | Self::Stop
            | Self::StopOnUndersize
            | Self::StopOnScrap
            | Self::Tool
            | Self::PresetCorrection
            | Self::AlignedAngle
            | Self::CompensationAxis
            | Self::ZeroAfterAlignment
            | Self::RotaryAlignment
            | Self::RotationTransfer
            | Self::NewDatum(_)
            | Self::NewCoordinate
            | Self::TableRow
            | Self::Transfer => ParameterGroup::Output,
            Self::Shift
            | Self::StartDiameter
            | Self::FirstAngle
            | Self::Step
            | Self::Arc
            | Self::Path
            | Self::Difference
            | Self::SetUpClearance
            | Self::ClearanceHeight
            | Self::Retract
            | Self::MoveToClearance
            | Self::ClearanceMode
            | Self::Traverse
            | Self::ContactCount
            | Self::Direction
            | Self::ToolAxisProbing
            | Self::ToolAxisPoint(_)
            | Self::Length
            | Self::Angle
            | Self::Choice
            | Self::Number => ParameterGroup::Probing,
        }
    }

    /// The other limit of a value, for a limit.
    pub const fn other_limit(self) -> Option<Self> {
        Some(match self {
            Self::MaximumDiameter => Self::MinimumDiameter,
            Self::MinimumDiameter => Self::MaximumDiameter,
            Self::MaximumSide(axis) => Self::MinimumSide(axis),
            Self::MinimumSide(axis) => Self::MaximumSide(axis),
            Self::MaximumWidth => Self::MinimumWidth,
            Self::MinimumWidth => Self::MaximumWidth,
            Self::MaximumCoordinate => Self::MinimumCoordinate,
            Self::MinimumCoordinate => Self::MaximumCoordinate,
            _ => return None,
        })
    }

    /// Whether programs leave such a parameter out (nc-programs, section 6).
    pub const fn may_be_left_out(self) -> bool {
        matches!(
            self,
            Self::CentreTolerance(_)
                | Self::Log
                | Self::Stop
                | Self::StopOnUndersize
                | Self::StopOnScrap
                | Self::PresetCorrection
                | Self::AlignedAngle
                | Self::ZeroAfterAlignment
                | Self::RotaryAlignment
                | Self::RotationTransfer
                | Self::Tool
                | Self::Shift
                | Self::SetUpClearance
                | Self::MoveToClearance
                | Self::Traverse
                | Self::ContactCount
                | Self::ToolAxisProbing
                | Self::ToolAxisPoint(_)
                | Self::NewDatum(_)
                | Self::NewCoordinate
                | Self::TableRow
                | Self::Transfer
        )
    }

    /// The meaning of a parameter whose declaration gives no more than its range.
    pub(super) const fn of_range(range: Range) -> Self {
        match range {
            Range::Length { .. } | Range::Nominal { .. } => Self::Length,
            Range::Angle { .. } => Self::Angle,
            Range::OneOf(_) => Self::Choice,
            Range::Number { .. } | Range::Count { .. } => Self::Number,
            Range::Tool => Self::Tool,
            Range::Band => Self::Band,
        }
    }

    /// Whether only the range is known.
    pub const fn is_general(self) -> bool {
        matches!(self, Self::Length | Self::Angle | Self::Choice | Self::Number)
    }

    /// The id of the sentence that explains it.
    pub const fn sentence(self) -> &'static str {
        match self {
            Self::Centre(axis) => axis.of_two(["cycle-picture-centre-1", "cycle-picture-centre-2"]),
            Self::CentreTolerance(axis) => {
                axis.of_two(["cycle-picture-centre-tolerance-1", "cycle-picture-centre-tolerance-2"])
            }
            Self::Side(axis) => axis.of_two(["cycle-picture-side-length-1", "cycle-picture-side-length-2"]),
            Self::MaximumSide(axis) => axis.of_two(["cycle-picture-maximum-side-1", "cycle-picture-maximum-side-2"]),
            Self::MinimumSide(axis) => axis.of_two(["cycle-picture-minimum-side-1", "cycle-picture-minimum-side-2"]),
            Self::Start(axis) => axis.of_two(["cycle-picture-start-1", "cycle-picture-start-2"]),
            Self::FirstPoint(axis) => axis.of_two(["cycle-picture-first-point-1", "cycle-picture-first-point-2"]),
            Self::SecondPoint(axis) => axis.of_two(["cycle-picture-second-point-1", "cycle-picture-second-point-2"]),
            Self::SecondCentre(axis) => axis.of_two(["cycle-picture-second-centre-1", "cycle-picture-second-centre-2"]),
            Self::SecondDiameter => "cycle-picture-second-diameter",
            Self::SecondHeight => "cycle-picture-second-height",
            Self::Geometries => "cycle-picture-geometries",
            Self::NextPoint(axis) => axis.of_three(NEXT_POINT),
            Self::Point(axis) => axis.of_three(POINT),
            Self::Normal(axis) => axis.of_three(NORMAL),
            Self::Diameter => "cycle-picture-diameter",
            Self::MaximumDiameter => "cycle-picture-maximum-size",
            Self::MinimumDiameter => "cycle-picture-minimum-size",
            Self::Width => "cycle-picture-width",
            Self::MaximumWidth => "cycle-picture-maximum-width",
            Self::MinimumWidth => "cycle-picture-minimum-width",
            Self::Shift => "cycle-picture-shift",
            Self::StartDiameter => "cycle-picture-start-diameter",
            Self::FirstAngle => "cycle-picture-first-angle",
            Self::Step => "cycle-picture-step",
            Self::Arc => "cycle-picture-arc",
            Self::Path => "cycle-picture-longest-path",
            Self::Difference => "cycle-picture-difference",
            Self::MeasuringHeight => "cycle-picture-measuring-height",
            Self::SetUpClearance => "cycle-picture-set-up-clearance",
            Self::ClearanceHeight => "cycle-picture-clearance-height",
            Self::MaximumCoordinate => "cycle-picture-maximum-coordinate",
            Self::MinimumCoordinate => "cycle-picture-minimum-coordinate",
            Self::Band => "cycle-picture-band",
            Self::Retract => "cycle-picture-retract",
            Self::MoveToClearance => "cycle-picture-move-to-clearance",
            Self::ClearanceMode => "cycle-picture-clearance-mode",
            Self::Traverse => "cycle-picture-traverse",
            Self::ContactCount => "cycle-picture-contact-count",
            Self::Plane => "cycle-picture-plane",
            Self::InsideOutside => "cycle-picture-side",
            Self::MeasuredAxis => "cycle-picture-measured-axis",
            Self::AxisOfPlane => "cycle-picture-axis-of-plane",
            Self::Direction => "cycle-picture-direction",
            Self::DirectedAxis => "cycle-picture-directed-axis",
            Self::ToolAxisProbing => "cycle-picture-tool-axis-probing",
            Self::ToolAxisPoint(axis) => axis.of_three(TOOL_AXIS_POINT),
            Self::NewDatum(axis) => axis.of_three(NEW_DATUM),
            Self::NewCoordinate => "cycle-picture-new-coordinate",
            Self::TableRow => "cycle-picture-table-row",
            Self::Transfer => "cycle-picture-transfer",
            Self::PresetCorrection => "cycle-picture-preset-correction",
            Self::AlignedAngle => "cycle-picture-aligned-angle",
            Self::CompensationAxis => "cycle-picture-compensation-axis",
            Self::ZeroAfterAlignment => "cycle-picture-zero-after-alignment",
            Self::RotaryAlignment => "cycle-picture-rotary-alignment",
            Self::RotationTransfer => "cycle-picture-rotation-transfer",
            Self::Log => "cycle-picture-log",
            Self::Stop => "cycle-picture-stop",
            Self::StopOnUndersize => "cycle-picture-stop-on-undersize",
            Self::StopOnScrap => "cycle-picture-stop-on-scrap",
            Self::Tool => "cycle-picture-tool",
            Self::Length => "cycle-picture-any-length",
            Self::Angle => "cycle-picture-any-angle",
            Self::Choice => "cycle-picture-any-choice",
            Self::Number => "cycle-picture-any-number",
        }
    }

    /// Its word in the ids of other texts: `cycles-choice-log-1` explains the choice 1.
    pub fn word(self) -> &'static str {
        self.sentence().trim_start_matches("cycle-picture-")
    }
}
