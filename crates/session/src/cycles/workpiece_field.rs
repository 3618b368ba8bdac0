//! The figures of the simulated workpiece and probe: their names, their units, and which one an error means.

use fitcheck_core::probing::simulated::{Figure, Shape, WorkpieceError};
use fitcheck_core::text::Within as _;

/// The declaration of a figure.
struct Declared {
    name_id: &'static str,
    unit: &'static str,
    /// Its names in the errors of the simulated machine.
    refused_as: &'static [Figure],
}

/// The figures, a row each: what it is, the id of its name, its unit, and its names in the errors of the simulated
/// machine.
macro_rules! figures {
    ($($(#[$doc:meta])* $field:ident: $name:literal, $unit:literal, $refused:expr;)+) => {
        /// A figure of the simulated workpiece or probe.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum WorkpieceField {
            $($(#[$doc])* $field,)+
        }

        impl WorkpieceField {
            const ALL: &'static [Self] = &[$(Self::$field),+];

            const fn declared(self) -> Declared {
                match self {
                    $(Self::$field => Declared { name_id: $name, unit: $unit, refused_as: &$refused },)+
                }
            }
        }
    };
}

figures! {
    /// Centre, first axis of the plane, mm.
    CentreX: "workpiece-centre-1", "mm", [Figure::CentreX];
    /// Centre, second axis of the plane, mm.
    CentreY: "workpiece-centre-2", "mm", [Figure::CentreY];
    /// Mean diameter, mm.
    Diameter: "true-diameter", "mm", [Figure::Diameter];
    /// Ovality: amplitude in the radius, mm.
    Ovality: "ovality", "mm", [Figure::Ovality, Figure::OvalityCount];
    /// Direction of its crest, degrees.
    OvalityAngle: "workpiece-ovality-angle", "°", [Figure::OvalityAngle];
    /// Number of lobes.
    LobeCount: "lobes", "", [Figure::Lobes];
    /// Amplitude of the lobes in the radius, mm.
    LobeHeight: "lobe-height", "mm", [Figure::LobeHeight];
    /// Direction of the first crest, degrees.
    LobeAngle: "workpiece-lobe-angle", "°", [Figure::LobeAngle];
    /// A point of the surface, X, mm.
    PointX: "workpiece-point-x", "mm", [];
    /// The same in Y.
    PointY: "workpiece-point-y", "mm", [];
    /// The same in Z.
    PointZ: "workpiece-point-z", "mm", [];
    /// The normal out of the material, X.
    NormalX: "workpiece-normal-x", "", [Figure::Normal, Figure::NormalLength];
    /// The same in Y.
    NormalY: "workpiece-normal-y", "", [];
    /// The same in Z.
    NormalZ: "workpiece-normal-z", "", [];
    /// Amplitude of a wave, mm; empty is a plane face.
    WaveHeight: "workpiece-wave-height", "mm", [Figure::WaveAmplitude];
    /// From crest to crest, mm.
    WaveLength: "workpiece-wave-length", "mm", [Figure::WaveLength];
    /// The direction of a wave, X.
    WaveX: "workpiece-wave-x", "", [Figure::WaveDirection];
    /// The same in Y.
    WaveY: "workpiece-wave-y", "", [];
    /// The same in Z.
    WaveZ: "workpiece-wave-z", "", [];
    /// How far the surface lies out along the normal, mm.
    Deviation: "workpiece-deviation", "mm", [Figure::Deviation];
    /// Radius of the surface, mm; empty is flat.
    Radius: "workpiece-radius", "mm", [Figure::Radius];
    /// From wall to wall of a slot or ridge, mm.
    Width: "workpiece-width", "mm", [Figure::Width];
    /// From wall to wall of a rectangle, across the first pair, mm.
    FirstLength: "workpiece-length-1", "mm", [Figure::FirstLength];
    /// The same across the second pair.
    SecondLength: "workpiece-length-2", "mm", [Figure::SecondLength];
    /// The direction across the first pair of walls, degrees from the first axis.
    Angle: "workpiece-angle", "°", [Figure::Angle];
    /// Scatter of the surface, one sigma, mm.
    SurfaceScatter: "surface-scatter", "mm", [Figure::SurfaceScatter];
    /// Radius of the ball, mm.
    BallRadius: "workpiece-ball", "mm", [Figure::BallRadius];
    /// Scatter of the trigger point, one sigma, mm.
    TriggerScatter: "workpiece-trigger", "mm", [Figure::ProbeScatter];
    /// By how much the ball's radius was calibrated too large, mm.
    CalibrationError: "workpiece-calibration", "mm", [Figure::CalibrationError];
    /// How far the ball lies off the spindle's axis, X, mm; empty takes what calibration found.
    OffsetX: "workpiece-offset-x", "mm", [Figure::Offset];
    /// The same in Y.
    OffsetY: "workpiece-offset-y", "mm", [];
    /// Number of lobes of the probe's pre-travel.
    LobingCount: "workpiece-lobing-count", "", [Figure::LobingCount];
    /// Their amplitude, mm.
    LobingHeight: "workpiece-lobing", "mm", [Figure::Lobing];
    /// Direction of the first, degrees.
    LobingAngle: "workpiece-lobing-angle", "°", [Figure::LobingAngle];
    /// Seed of all scatter.
    Seed: "seed", "", [];
    /// Temperature of the workpiece, °C.
    Temperature: "workpiece-temperature", "°C", [Figure::Temperature];
    /// Its expansion, millionths per kelvin.
    Expansion: "workpiece-expansion", "µm/(m K)", [Figure::Expansion];
}

impl WorkpieceField {
    /// The figures of a surface, in reading order.
    pub fn of(shape: Shape) -> Vec<Self> {
        let place = Self::between(Self::PointX, Self::NormalZ);
        let centre = [Self::CentreX, Self::CentreY];
        match shape {
            Shape::Hole | Shape::Stud => {
                let form = Self::between(Self::Ovality, Self::LobeAngle);
                [&centre[..], &[Self::Diameter, Self::SurfaceScatter], form].concat()
            }
            Shape::Face => [place, &[Self::SurfaceScatter], Self::between(Self::WaveHeight, Self::WaveZ)].concat(),
            Shape::Point => [place, &[Self::Deviation, Self::Radius, Self::SurfaceScatter]].concat(),
            Shape::Slot | Shape::Ridge => [&centre[..], &[Self::Width, Self::Angle, Self::SurfaceScatter]].concat(),
            Shape::Pocket | Shape::Boss => {
                let lengths = [Self::FirstLength, Self::SecondLength];
                [&centre[..], &lengths, &[Self::Angle, Self::SurfaceScatter]].concat()
            }
        }
    }

    /// The figures of the probe, in reading order.
    pub fn of_probe() -> &'static [Self] {
        Self::between(Self::BallRadius, Self::LobingAngle)
    }

    /// The figures of the whole simulation, in reading order.
    pub fn of_machine() -> &'static [Self] {
        Self::between(Self::Seed, Self::Expansion)
    }

    /// The figures from one to another, in the order of the list.
    fn between(first: Self, last: Self) -> &'static [Self] {
        let place = |field: Self| Self::ALL.partition_point(|other| *other < field);
        Self::ALL.within(place(first)..=place(last))
    }

    /// Whether it may be empty.
    pub const fn is_optional(self) -> bool {
        matches!(self, Self::WaveHeight | Self::Radius | Self::OffsetX | Self::OffsetY)
    }

    pub const fn unit(self) -> &'static str {
        self.declared().unit
    }

    /// The id of its name in the locale files.
    pub const fn name_id(self) -> &'static str {
        self.declared().name_id
    }

    /// The field of the figure that an error of the simulated machine names.
    pub(super) fn named(error: &WorkpieceError, shape: Shape) -> Self {
        let place = if matches!(shape, Shape::Face | Shape::Point) { Self::PointX } else { Self::CentreX };
        let is_it = |field: &&Self| field.declared().refused_as.contains(&error.what);
        Self::ALL.iter().find(is_it).copied().unwrap_or(place)
    }
}
