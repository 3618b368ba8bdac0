//! What is worth knowing about the run of a cycle.

use super::datum::{DatumTarget, NewRotation, RotaryAxis, TurnedBy};
use super::key::Key;
use super::value::Angle;
use crate::length::Length;
use crate::message::{Arg, Say};
use crate::probing::Caveat;
use crate::tolerance::ZoneDoubt;

/// Something worth knowing about a run.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "remark")]
pub enum Remark {
    /// A parameter was given that has no effect.
    WithoutEffect {
        /// The parameter.
        key: Key,
    },
    /// A tool was named (Q330), and there is no tool table: nothing monitors it.
    ToolNotMonitored {
        /// Its number or name.
        tool: String,
    },
    /// Rework and scrap follow the rule for an outside dimension.
    OutsideDimension,
    /// The nominal diameter is not between the limits, as a TNC7 requires.
    NominalOutsideLimits {
        /// The nominal diameter.
        nominal: Length,
    },
    /// The nominal width is not between the limits, as a TNC7 requires.
    NominalWidthOutsideLimits {
        /// The nominal width.
        nominal: Length,
    },
    /// The nominal coordinate is not between the limits, as the manual of TNC7 seems to ask of cycle 427.
    NominalCoordinateOutsideLimits {
        /// The nominal coordinate.
        nominal: Length,
    },
    /// Limits that are out of all proportion to the size: the cycle compares with them all the same.
    #[say(transparent)]
    Zone(ZoneDoubt),
    /// What the contacts say against the limits of the diameter: it is that of the mean circle.
    #[say(transparent)]
    Form(Caveat),
    /// Contacts lie apart from where the cycle probes.
    ContactAstray {
        /// How many do.
        count: usize,
        /// The number of the one that is farthest, from 1.
        contact: usize,
        /// How far it is from the probing movement, mm.
        distance: Length,
    },
    /// A control stores the deviation, but the manual names no parameter for it.
    DeviationWithoutParameter,
    /// The datum that the cycle sets.
    NewDatum {
        /// The measured coordinate of each axis, and the one that it gets.
        axes: Arg,
        /// Where it goes.
        target: DatumTarget,
    },
    /// The basic rotation that the cycle sets.
    NewRotation {
        /// The rotation.
        angle: Arg,
        /// Where it goes.
        target: DatumTarget,
    },
    /// A rotary axis turns by an angle about a centre that only the machine knows.
    AxisTurned {
        /// The axis.
        axis: RotaryAxis,
        /// The angle.
        angle: Arg,
    },
    /// What `#i99` holds is not documented.
    VariableHoldsDiameter,
    /// A tolerance text was given that is not a tolerance, such as `0.1+0.1`.
    NoTolerance {
        /// The parameter.
        key: Key,
    },
}

impl Remark {
    /// How the cycle turns the system, or the part.
    pub(super) fn of_rotation(new: &NewRotation) -> Self {
        let angle = Arg::Number(Angle::nearest(new.degrees).to_string());
        match new.by {
            TurnedBy::Rotation(target) => Self::NewRotation { angle, target },
            TurnedBy::Axis { axis, .. } => Self::AxisTurned { axis, angle },
        }
    }

    /// Whether it stands against what the cycle says: limits out of all proportion, contacts of somewhere else or of no circle, or a
    /// tolerance that was written and not understood.
    pub const fn stands_against(&self) -> bool {
        matches!(self, Self::Zone(_) | Self::Form(_) | Self::ContactAstray { .. } | Self::NoTolerance { .. })
    }
}
