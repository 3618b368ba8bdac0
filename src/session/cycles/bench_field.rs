//! The figures of the simulated workpiece and probe: which there are, their units, and which one a refusal means.

use crate::probing::simulated::WorkpieceError;

/// What kind of surface there is to touch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BenchKind {
    /// A hole.
    Bore,
    /// A stud.
    Stud,
    /// A plane face.
    Face,
    /// A point of a free surface.
    Point,
}

impl BenchKind {
    /// All kinds.
    pub const ALL: [Self; 4] = [Self::Bore, Self::Stud, Self::Face, Self::Point];

    /// The figures of such a surface, in reading order.
    pub const fn fields(self) -> &'static [BenchField] {
        use BenchField as F;
        match self {
            Self::Bore | Self::Stud => &[
                F::CentreX,
                F::CentreY,
                F::Diameter,
                F::SurfaceScatter,
                F::Ovality,
                F::OvalityAngle,
                F::LobeCount,
                F::LobeHeight,
                F::LobeAngle,
            ],
            Self::Face => &[
                F::PointX,
                F::PointY,
                F::PointZ,
                F::NormalX,
                F::NormalY,
                F::NormalZ,
                F::SurfaceScatter,
                F::WaveHeight,
                F::WaveLength,
                F::WaveX,
                F::WaveY,
                F::WaveZ,
            ],
            Self::Point => &[
                F::PointX,
                F::PointY,
                F::PointZ,
                F::NormalX,
                F::NormalY,
                F::NormalZ,
                F::Deviation,
                F::Radius,
                F::SurfaceScatter,
            ],
        }
    }
}

/// A figure of the simulated workpiece or probe.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BenchField {
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

impl BenchField {
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

    /// The figures of the whole machine, in reading order.
    pub const MACHINE: &'static [Self] = &[Self::Seed, Self::Temperature, Self::Expansion];

    /// Whether nothing is an answer.
    pub const fn is_optional(self) -> bool {
        matches!(self, Self::WaveHeight | Self::Radius | Self::OffsetX | Self::OffsetY)
    }

    /// Its unit, where it has one.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::OvalityAngle | Self::LobeAngle | Self::LobingAngle => "°",
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

    /// The field of a figure that the simulated machine refuses by this name.
    pub(super) fn named(error: &WorkpieceError, kind: BenchKind) -> Self {
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
            _ if matches!(kind, BenchKind::Bore | BenchKind::Stud) => Self::CentreX,
            _ => Self::PointX,
        }
    }
}
