//! The text fields of the check page.

use crate::session::field::kept_fields;

kept_fields! {
    /// A text field of the check page.
    CheckField

    /// Nominal size and class, `25 H7`.
    Callout: "callout", "";
    /// The measured diameter, mm, when it is typed.
    Measured: "measured", "";
    /// Name of the part or feature, free text.
    Part: "part", "";
    /// The nominal size alone, mm; typing here rewrites the callout.
    Nominal: "nominal", "";
    /// Centre in X (Q11, Q273), mm.
    CentreX: "centre-x", "0";
    /// Centre in Y (Q21, Q274), mm.
    CentreY: "centre-y", "0";
    /// Measuring height in Z (Q31, Q261), mm.
    Height: "height", "-5";
    /// Angle of the first contact (Q41, Q325), degrees.
    FirstAngle: "first-angle", "0";
    /// Set-up clearance (Q51, Q320), mm.
    Clearance: "clearance", "2";
    /// Permitted deviation of the centre either way (Q279 and Q280), mm; 0 is not monitored.
    CentreTolerance: "centre-tolerance", "0";
    /// True diameter of the simulated workpiece, mm; empty is the middle of the zone.
    TrueDiameter: "true-diameter", "";
    /// Where the simulated workpiece really lies: X off the nominal centre, mm.
    OffsetX: "offset-x", "0.003";
    /// The same in Y, mm.
    OffsetY: "offset-y", "-0.001";
    /// Ovality of the simulated workpiece: amplitude in the radius, mm.
    Ovality: "ovality", "0.001";
    /// Number of lobes.
    Lobes: "lobes", "3";
    /// Amplitude of the lobes in the radius, mm.
    LobeHeight: "lobe-height", "0";
    /// Scatter of the surface along the radius, one sigma, mm.
    SurfaceScatter: "surface-scatter", "0.0003";
    /// Scatter of the probe's trigger point, one sigma, mm.
    ProbeScatter: "probe-scatter", "0.0005";
    /// Seed of the scatter; counts up with every simulated measurement.
    Seed: "seed", "1";
    /// Words that the listed checks of the history must have.
    HistoryFilter: "history-filter", "";
}
