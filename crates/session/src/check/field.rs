//! The text fields of the check page.

use crate::texts::kept_fields;

kept_fields! {
    /// A text field of the check page.
    CheckField

    /// Nominal size and class, `25 H7`.
    Callout: "callout", "";
    /// The measured diameter, mm, when it is typed.
    Measured: "measured", "";
    /// Name of the part or feature, free text.
    Part: "part", "";
    /// Serial number of the part, free text, for the record.
    Serial: "serial", "";
    /// Anything else for the record, free text.
    Remark: "remark", "";
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
    /// Uncertainty of the measured value, µm, as it is told: standard or expanded; empty is not known.
    Uncertainty: "uncertainty", "";
    /// Coverage factor of the expanded uncertainty.
    Coverage: "coverage-factor", "2";
    /// Guard band as a multiple of the expanded uncertainty, where the rule takes one.
    GuardFactor: "guard-factor", "1";
    /// Guard band, µm, where the rule takes one.
    GuardWidth: "guard-width", "";
    /// Mean of what the process makes, mm; empty is the middle of the zone.
    ProcessMean: "process-mean", "";
    /// Standard deviation of what the process makes, µm; empty is not known.
    ProcessSpread: "process-spread", "";
    /// Temperature of the measured part, °C; empty is not corrected.
    PartTemperature: "part-temperature", "";
    /// Expansion of the part's material, 10⁻⁶/K.
    PartExpansion: "part-expansion", "11.5";
    /// Temperature of the machine's scales, °C; empty where the machine compensates them.
    ScaleTemperature: "scale-temperature", "";
    /// Expansion of the scales, 10⁻⁶/K.
    ScaleExpansion: "scale-expansion", "10";
    /// Words that the listed checks of the history must have.
    HistoryFilter: "history-filter", "";
    /// Words that the listed rows of a large file must have.
    RowsFilter: "rows-filter", "";
}
