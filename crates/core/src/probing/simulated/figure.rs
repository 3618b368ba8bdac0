//! The figures of a workpiece file: how errors name them, and their keys in the file.

use crate::message::Say;

/// A figure of the simulated workpiece, its probe or its material.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "figure")]
pub enum Figure {
    /// Of the workpiece, °C.
    Temperature,
    /// Of its material, millionths per kelvin.
    Expansion,
    /// Of the trigger point.
    ProbeScatter,
    /// Of the probe.
    BallRadius,
    /// By how much the ball's radius was calibrated too large.
    CalibrationError,
    /// Of the ball from the spindle's axis.
    Offset,
    /// Of the probe's pre-travel.
    Lobing,
    /// Of its first lobe.
    LobingAngle,
    /// How many lobes it has.
    LobingCount,
    /// In the first axis of the plane.
    CentreX,
    /// In the second.
    CentreY,
    /// Of a round feature.
    Diameter,
    /// Of the surface.
    SurfaceScatter,
    /// Its amplitude.
    Ovality,
    /// The direction of its crest.
    OvalityAngle,
    /// How many crests: always 2.
    OvalityCount,
    /// The amplitude of the lobes.
    LobeHeight,
    /// The direction of the first.
    LobeAngle,
    /// How many.
    Lobes,
    /// A coordinate of a point of the surface.
    Point,
    /// A component of the normal.
    Normal,
    /// Of all three components.
    NormalLength,
    /// From crest to crest.
    WaveLength,
    /// Half from crest to trough.
    WaveAmplitude,
    /// The length of its direction across the normal.
    WaveDirection,
    /// Along the normal.
    Deviation,
    /// Of a curved surface.
    Radius,
    /// Of a slot or ridge.
    Width,
    /// Of a rectangle, across its first pair of walls.
    FirstLength,
    /// Across the second pair.
    SecondLength,
    /// Across the first pair of walls.
    Angle,
    /// Of walls, along the axis of their plane.
    Top,
    /// The floor of a hole, slot or pocket, or the end of a body.
    Bottom,
    /// Of the walls of a slot or ridge.
    Length,
    /// Of a face or point, about its point.
    Reach,
    /// Of the stylus above the ball.
    StylusRadius,
}

/// The table of a workpiece file in which a figure is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Table {
    /// None: the key is at the top of the file.
    Top,
    /// `[probe]`.
    Probe,
    /// That of the shape: `[bore]`, `[face]`.
    Shape,
}

impl Figure {
    /// Where the figure is in a file: its table and its key.
    pub(super) const fn place(self) -> (Table, &'static str) {
        match self {
            Self::Temperature => (Table::Top, "temperature"),
            Self::Expansion => (Table::Top, "expansion"),
            Self::ProbeScatter => (Table::Probe, "trigger_scatter"),
            Self::BallRadius => (Table::Probe, "ball_radius"),
            Self::CalibrationError => (Table::Probe, "calibration_error"),
            Self::Offset => (Table::Probe, "offset"),
            Self::Lobing | Self::LobingAngle | Self::LobingCount => (Table::Probe, "lobing"),
            Self::CentreX | Self::CentreY => (Table::Shape, "centre"),
            Self::Diameter => (Table::Shape, "diameter"),
            Self::SurfaceScatter => (Table::Shape, "surface_scatter"),
            Self::Ovality | Self::OvalityAngle | Self::OvalityCount => (Table::Shape, "ovality"),
            Self::LobeHeight | Self::LobeAngle | Self::Lobes => (Table::Shape, "lobes"),
            Self::Point => (Table::Shape, "point"),
            Self::Normal | Self::NormalLength => (Table::Shape, "normal"),
            Self::WaveLength | Self::WaveAmplitude | Self::WaveDirection => (Table::Shape, "wave"),
            Self::Deviation => (Table::Shape, "deviation"),
            Self::Radius => (Table::Shape, "radius"),
            Self::Width => (Table::Shape, "width"),
            Self::FirstLength | Self::SecondLength => (Table::Shape, "lengths"),
            Self::Angle => (Table::Shape, "angle"),
            Self::Top => (Table::Shape, "top"),
            Self::Bottom => (Table::Shape, "bottom"),
            Self::Length => (Table::Shape, "length"),
            Self::Reach => (Table::Shape, "reach"),
            Self::StylusRadius => (Table::Probe, "stylus_radius"),
        }
    }
}
