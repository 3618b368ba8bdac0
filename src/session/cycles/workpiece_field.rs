//! The figures of the simulated workpiece and probe: their names, their units, and which one an error means.

use crate::probing::simulated::{Shape, WorkpieceError};

/// The declaration of a figure.
struct Declared {
    name_id: &'static str,
    unit: &'static str,
    /// Its names in the errors of the simulated machine.
    refused_as: &'static [&'static str],
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
    CentreX: "workpiece-centre-1", "mm", ["centre x"];
    /// Centre, second axis of the plane, mm.
    CentreY: "workpiece-centre-2", "mm", ["centre y"];
    /// Mean diameter, mm.
    Diameter: "true-diameter", "mm", ["diameter"];
    /// Ovality: amplitude in the radius, mm.
    Ovality: "ovality", "mm", ["ovality", "ovality count"];
    /// Direction of its crest, degrees.
    OvalityAngle: "workpiece-ovality-angle", "°", ["ovality angle"];
    /// Number of lobes.
    LobeCount: "lobes", "", ["lobes"];
    /// Amplitude of the lobes in the radius, mm.
    LobeHeight: "lobe-height", "mm", ["lobe height"];
    /// Direction of the first crest, degrees.
    LobeAngle: "workpiece-lobe-angle", "°", ["lobe angle"];
    /// A point of the surface, X, mm.
    PointX: "workpiece-point-x", "mm", [];
    /// The same in Y.
    PointY: "workpiece-point-y", "mm", [];
    /// The same in Z.
    PointZ: "workpiece-point-z", "mm", [];
    /// The normal out of the material, X.
    NormalX: "workpiece-normal-x", "", ["normal", "length of the normal"];
    /// The same in Y.
    NormalY: "workpiece-normal-y", "", [];
    /// The same in Z.
    NormalZ: "workpiece-normal-z", "", [];
    /// Amplitude of a wave, mm; empty is a plane face.
    WaveHeight: "workpiece-wave-height", "mm", ["wave amplitude"];
    /// From crest to crest, mm.
    WaveLength: "workpiece-wave-length", "mm", ["wave length"];
    /// The direction of a wave, X.
    WaveX: "workpiece-wave-x", "", ["wave direction"];
    /// The same in Y.
    WaveY: "workpiece-wave-y", "", [];
    /// The same in Z.
    WaveZ: "workpiece-wave-z", "", [];
    /// How far the surface lies out along the normal, mm.
    Deviation: "workpiece-deviation", "mm", ["deviation"];
    /// Radius of the surface, mm; empty is flat.
    Radius: "workpiece-radius", "mm", ["radius"];
    /// From wall to wall of a slot or ridge, mm.
    Width: "workpiece-width", "mm", ["width"];
    /// From wall to wall of a rectangle, across the first pair, mm.
    FirstLength: "workpiece-length-1", "mm", ["1st length"];
    /// The same across the second pair.
    SecondLength: "workpiece-length-2", "mm", ["2nd length"];
    /// The direction across the first pair of walls, degrees from the first axis.
    Angle: "workpiece-angle", "°", ["angle"];
    /// Scatter of the surface, one sigma, mm.
    SurfaceScatter: "surface-scatter", "mm", ["surface scatter"];
    /// Radius of the ball, mm.
    BallRadius: "workpiece-ball", "mm", ["ball radius"];
    /// Scatter of the trigger point, one sigma, mm.
    TriggerScatter: "workpiece-trigger", "mm", ["probe scatter"];
    /// By how much the ball's radius was calibrated too large, mm.
    CalibrationError: "workpiece-calibration", "mm", ["calibration error"];
    /// How far the ball lies off the spindle's axis, X, mm; empty takes what calibration found.
    OffsetX: "workpiece-offset-x", "mm", ["offset"];
    /// The same in Y.
    OffsetY: "workpiece-offset-y", "mm", [];
    /// Number of lobes of the probe's pre-travel.
    LobingCount: "workpiece-lobing-count", "", ["lobing count"];
    /// Their amplitude, mm.
    LobingHeight: "workpiece-lobing", "mm", ["lobing"];
    /// Direction of the first, degrees.
    LobingAngle: "workpiece-lobing-angle", "°", ["lobing angle"];
    /// Seed of all scatter.
    Seed: "seed", "", [];
    /// Temperature of the workpiece, °C.
    Temperature: "workpiece-temperature", "°C", ["temperature"];
    /// Its expansion, millionths per kelvin.
    Expansion: "workpiece-expansion", "µm/(m K)", ["expansion"];
}

impl WorkpieceField {
    /// The figures of a surface, in reading order.
    pub fn of(shape: Shape) -> Vec<Self> {
        let (place, centre) = (Self::between(Self::PointX, Self::NormalZ), [Self::CentreX, Self::CentreY]);
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
        Self::ALL.get(place(first)..=place(last)).unwrap_or_default()
    }

    /// Whether it may be empty.
    pub const fn is_optional(self) -> bool {
        matches!(self, Self::WaveHeight | Self::Radius | Self::OffsetX | Self::OffsetY)
    }

    /// Its unit, where it has one.
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
