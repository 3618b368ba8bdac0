//! The text fields of the check page.

use crate::session::field::KeptField;

/// A text field of the check page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CheckField {
    /// Nominal size and class, `25 H7`.
    Callout,
    /// The measured diameter, mm, when it is typed.
    Measured,
    /// Name of the part or feature, free text.
    Part,
    /// The nominal size alone, mm; typing here rewrites the callout.
    Nominal,
    /// Centre in X (Q11, Q273), mm.
    CentreX,
    /// Centre in Y (Q21, Q274), mm.
    CentreY,
    /// Measuring height in Z (Q31, Q261), mm.
    Height,
    /// Angle of the first contact (Q41, Q325), degrees.
    FirstAngle,
    /// Set-up clearance (Q51, Q320), mm.
    Clearance,
    /// Permitted deviation of the centre either way (Q279 and Q280), mm; 0 is not monitored.
    CentreTolerance,
    /// True diameter of the simulated workpiece, mm; empty is the middle of the zone.
    TrueDiameter,
    /// Where the simulated workpiece really lies: X off the nominal centre, mm.
    OffsetX,
    /// The same in Y, mm.
    OffsetY,
    /// Ovality of the simulated workpiece: amplitude in the radius, mm.
    Ovality,
    /// Number of lobes.
    Lobes,
    /// Amplitude of the lobes in the radius, mm.
    LobeHeight,
    /// Scatter of the surface along the radius, one sigma, mm.
    SurfaceScatter,
    /// Scatter of the probe's trigger point, one sigma, mm.
    ProbeScatter,
    /// Seed of the scatter; counts up with every simulated measurement.
    Seed,
}

impl KeptField for CheckField {
    const ALL: &'static [Self] = &[
        Self::Callout,
        Self::Measured,
        Self::Part,
        Self::Nominal,
        Self::CentreX,
        Self::CentreY,
        Self::Height,
        Self::FirstAngle,
        Self::Clearance,
        Self::CentreTolerance,
        Self::TrueDiameter,
        Self::OffsetX,
        Self::OffsetY,
        Self::Ovality,
        Self::Lobes,
        Self::LobeHeight,
        Self::SurfaceScatter,
        Self::ProbeScatter,
        Self::Seed,
    ];

    fn declared(self) -> (&'static str, &'static str) {
        match self {
            Self::Callout => ("callout", ""),
            Self::Measured => ("measured", ""),
            Self::Part => ("part", ""),
            Self::Nominal => ("nominal", ""),
            Self::CentreX => ("centre-x", "0"),
            Self::CentreY => ("centre-y", "0"),
            Self::Height => ("height", "-5"),
            Self::FirstAngle => ("first-angle", "0"),
            Self::Clearance => ("clearance", "2"),
            Self::CentreTolerance => ("centre-tolerance", "0"),
            Self::TrueDiameter => ("true-diameter", ""),
            Self::OffsetX => ("offset-x", "0.003"),
            Self::OffsetY => ("offset-y", "-0.001"),
            Self::Ovality => ("ovality", "0.001"),
            Self::Lobes => ("lobes", "3"),
            Self::LobeHeight => ("lobe-height", "0"),
            Self::SurfaceScatter => ("surface-scatter", "0.0003"),
            Self::ProbeScatter => ("probe-scatter", "0.0005"),
            Self::Seed => ("seed", "1"),
        }
    }
}
