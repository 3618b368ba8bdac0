//! The figures of the simulated workpiece and probe: which there are, their units, and which one a refusal means.

use crate::probing::simulated::{Shape, WorkpieceError};

/// A figure of the simulated workpiece or probe.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum WorkpieceField {
    /// Centre, first axis of the plane, mm.
    CentreX,
    /// Centre, second axis of the plane, mm.
    CentreY,
    /// Mean diameter, mm.
    Diameter,
    /// Ovality: amplitude in the radius, mm.
    Ovality,
    /// Direction of its crest, degrees.
    OvalityAngle,
    /// Number of lobes.
    LobeCount,
    /// Amplitude of the lobes in the radius, mm.
    LobeHeight,
    /// Direction of the first crest, degrees.
    LobeAngle,
    /// A point of the surface, X, mm.
    PointX,
    /// The same in Y.
    PointY,
    /// The same in Z.
    PointZ,
    /// The normal out of the material, X.
    NormalX,
    /// The same in Y.
    NormalY,
    /// The same in Z.
    NormalZ,
    /// Amplitude of a wave, mm; empty is a plane face.
    WaveHeight,
    /// From crest to crest, mm.
    WaveLength,
    /// The direction of a wave, X.
    WaveX,
    /// The same in Y.
    WaveY,
    /// The same in Z.
    WaveZ,
    /// How far the surface lies out along the normal, mm.
    Deviation,
    /// Radius of the surface, mm; empty is flat.
    Radius,
    /// From wall to wall of a slot or ridge, mm.
    Width,
    /// From wall to wall of a rectangle, across the first pair, mm.
    FirstLength,
    /// The same across the second pair.
    SecondLength,
    /// The direction across the first pair of walls, degrees from the first axis.
    Angle,
    /// Scatter of the surface, one sigma, mm.
    SurfaceScatter,
    /// Radius of the ball, mm.
    BallRadius,
    /// Scatter of the trigger point, one sigma, mm.
    TriggerScatter,
    /// How much too large the ball's radius was calibrated, mm.
    CalibrationError,
    /// How far the ball lies off the spindle's axis, X, mm; empty is what calibration found.
    OffsetX,
    /// The same in Y.
    OffsetY,
    /// Number of lobes of the probe's pre-travel.
    LobingCount,
    /// Their amplitude, mm.
    LobingHeight,
    /// Direction of the first, degrees.
    LobingAngle,
    /// Seed of all scatter.
    Seed,
    /// Temperature of the workpiece, °C.
    Temperature,
    /// How much it grows, millionths per kelvin.
    Expansion,
}

impl WorkpieceField {
    /// The figures of a surface, in reading order.
    pub const fn of(shape: Shape) -> &'static [Self] {
        match shape {
            Shape::Hole | Shape::Stud => &[
                Self::CentreX,
                Self::CentreY,
                Self::Diameter,
                Self::SurfaceScatter,
                Self::Ovality,
                Self::OvalityAngle,
                Self::LobeCount,
                Self::LobeHeight,
                Self::LobeAngle,
            ],
            Shape::Face => &[
                Self::PointX,
                Self::PointY,
                Self::PointZ,
                Self::NormalX,
                Self::NormalY,
                Self::NormalZ,
                Self::SurfaceScatter,
                Self::WaveHeight,
                Self::WaveLength,
                Self::WaveX,
                Self::WaveY,
                Self::WaveZ,
            ],
            Shape::Point => &[
                Self::PointX,
                Self::PointY,
                Self::PointZ,
                Self::NormalX,
                Self::NormalY,
                Self::NormalZ,
                Self::Deviation,
                Self::Radius,
                Self::SurfaceScatter,
            ],
            Shape::Slot | Shape::Ridge => {
                &[Self::CentreX, Self::CentreY, Self::Width, Self::Angle, Self::SurfaceScatter]
            }
            Shape::Pocket | Shape::Boss => &[
                Self::CentreX,
                Self::CentreY,
                Self::FirstLength,
                Self::SecondLength,
                Self::Angle,
                Self::SurfaceScatter,
            ],
        }
    }

    /// The figures of the probe, in reading order.
    pub const PROBE: &'static [Self] = &[
        Self::BallRadius,
        Self::TriggerScatter,
        Self::CalibrationError,
        Self::OffsetX,
        Self::OffsetY,
        Self::LobingCount,
        Self::LobingHeight,
        Self::LobingAngle,
    ];

    /// The figures of the whole simulation, in reading order.
    pub const MACHINE: &'static [Self] = &[Self::Seed, Self::Temperature, Self::Expansion];

    /// Whether nothing is an answer.
    pub const fn is_optional(self) -> bool {
        matches!(self, Self::WaveHeight | Self::Radius | Self::OffsetX | Self::OffsetY)
    }

    /// Its unit, where it has one.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::OvalityAngle | Self::LobeAngle | Self::LobingAngle | Self::Angle => "°",
            Self::LobeCount
            | Self::LobingCount
            | Self::Seed
            | Self::NormalX
            | Self::NormalY
            | Self::NormalZ
            | Self::WaveX
            | Self::WaveY
            | Self::WaveZ => "",
            Self::Temperature => "°C",
            Self::Expansion => "µm/(m K)",
            _ => "mm",
        }
    }

    /// The id of its name in the locale files.
    pub const fn name_id(self) -> &'static str {
        match self {
            Self::CentreX => "workpiece-centre-1",
            Self::CentreY => "workpiece-centre-2",
            Self::Diameter => "true-diameter",
            Self::Ovality => "ovality",
            Self::OvalityAngle => "workpiece-ovality-angle",
            Self::LobeCount => "lobes",
            Self::LobeHeight => "lobe-height",
            Self::LobeAngle => "workpiece-lobe-angle",
            Self::PointX => "workpiece-point-x",
            Self::PointY => "workpiece-point-y",
            Self::PointZ => "workpiece-point-z",
            Self::NormalX => "workpiece-normal-x",
            Self::NormalY => "workpiece-normal-y",
            Self::NormalZ => "workpiece-normal-z",
            Self::WaveHeight => "workpiece-wave-height",
            Self::WaveLength => "workpiece-wave-length",
            Self::WaveX => "workpiece-wave-x",
            Self::WaveY => "workpiece-wave-y",
            Self::WaveZ => "workpiece-wave-z",
            Self::Deviation => "workpiece-deviation",
            Self::Radius => "workpiece-radius",
            Self::Width => "workpiece-width",
            Self::FirstLength => "workpiece-length-1",
            Self::SecondLength => "workpiece-length-2",
            Self::Angle => "workpiece-angle",
            Self::SurfaceScatter => "surface-scatter",
            Self::BallRadius => "workpiece-ball",
            Self::TriggerScatter => "workpiece-trigger",
            Self::CalibrationError => "workpiece-calibration",
            Self::OffsetX => "workpiece-offset-x",
            Self::OffsetY => "workpiece-offset-y",
            Self::LobingCount => "workpiece-lobing-count",
            Self::LobingHeight => "workpiece-lobing",
            Self::LobingAngle => "workpiece-lobing-angle",
            Self::Seed => "seed",
            Self::Temperature => "workpiece-temperature",
            Self::Expansion => "workpiece-expansion",
        }
    }

    /// The field of a figure that the simulated machine refuses by this name.
    pub(super) fn named(error: &WorkpieceError, shape: Shape) -> Self {
        match error.what {
            "temperature" => Self::Temperature,
            "expansion" => Self::Expansion,
            "probe scatter" => Self::TriggerScatter,
            "ball radius" => Self::BallRadius,
            "calibration error" => Self::CalibrationError,
            "offset" => Self::OffsetX,
            "lobing" => Self::LobingHeight,
            "lobing angle" => Self::LobingAngle,
            "lobing count" => Self::LobingCount,
            "centre x" => Self::CentreX,
            "centre y" => Self::CentreY,
            "diameter" => Self::Diameter,
            "surface scatter" => Self::SurfaceScatter,
            "ovality" | "ovality count" => Self::Ovality,
            "ovality angle" => Self::OvalityAngle,
            "lobes" => Self::LobeCount,
            "lobe height" => Self::LobeHeight,
            "lobe angle" => Self::LobeAngle,
            "wave length" => Self::WaveLength,
            "wave amplitude" => Self::WaveHeight,
            "wave direction" => Self::WaveX,
            "normal" | "length of the normal" => Self::NormalX,
            "deviation" => Self::Deviation,
            "radius" => Self::Radius,
            "width" => Self::Width,
            "1st length" => Self::FirstLength,
            "2nd length" => Self::SecondLength,
            "angle" => Self::Angle,
            _ if matches!(shape, Shape::Face | Shape::Point) => Self::PointX,
            _ => Self::CentreX,
        }
    }
}
