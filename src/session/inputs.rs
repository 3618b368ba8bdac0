//! What the operator types: one text a field, read anew at every change.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::tolerance::Feature;

/// A text field of the window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Field {
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
    /// Nominal size and both classes of a fit, `25 H7/g6`.
    FitCallout,
    /// The hole's measured diameter, mm; empty where it was not measured.
    HoleMeasured,
    /// The shaft's measured diameter, mm; empty where it was not measured.
    ShaftMeasured,
    /// The temperature of both parts, °C.
    Temperature,
    /// Expansion of the hole's material, 10⁻⁶/K.
    HoleExpansion,
    /// Expansion of the shaft's material, 10⁻⁶/K.
    ShaftExpansion,
    /// The smallest clearance that is searched for, mm; negative is an interference.
    WantedMinimum,
    /// The largest clearance that is searched for, mm; negative is an interference.
    WantedMaximum,
    /// Table page: which classes are shown, and which size is marked.
    TableFilter,
    /// Table page: upper deviation of the selected cell, µm.
    CellUpper,
    /// Table page: lower deviation of the selected cell, µm.
    CellLower,
    /// Table page: classes to add or to make a table of.
    TableClasses,
    /// Table page: largest size of a new table, mm.
    TableTo,
}

impl Field {
    /// Every field in reading order.
    pub const ALL: [Self; 32] = [
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
        Self::FitCallout,
        Self::HoleMeasured,
        Self::ShaftMeasured,
        Self::Temperature,
        Self::HoleExpansion,
        Self::ShaftExpansion,
        Self::WantedMinimum,
        Self::WantedMaximum,
        Self::TableFilter,
        Self::CellUpper,
        Self::CellLower,
        Self::TableClasses,
        Self::TableTo,
    ];

    /// What stands in the field at the first start.
    const fn default_text(self) -> &'static str {
        match self {
            Self::Callout
            | Self::Measured
            | Self::Part
            | Self::Nominal
            | Self::TrueDiameter
            | Self::FitCallout
            | Self::HoleMeasured
            | Self::ShaftMeasured
            | Self::WantedMinimum
            | Self::WantedMaximum
            | Self::TableFilter
            | Self::CellUpper
            | Self::CellLower
            | Self::TableClasses => "",
            Self::CentreX | Self::CentreY | Self::FirstAngle | Self::CentreTolerance | Self::LobeHeight => "0",
            Self::Lobes => "3",
            Self::Height => "-5",
            Self::Clearance => "2",
            Self::OffsetX => "0.003",
            Self::OffsetY => "-0.001",
            Self::Ovality => "0.001",
            Self::SurfaceScatter => "0.0003",
            Self::ProbeScatter => "0.0005",
            Self::Seed => "1",
            Self::Temperature => "20",
            Self::HoleExpansion | Self::ShaftExpansion => "11.5",
            Self::TableTo => "500",
        }
    }
}

/// Where the next measurement comes from.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MeasureBy {
    /// A cycle on the simulated workpiece.
    #[default]
    Simulating,
    /// A diameter that is typed.
    Typing,
}

/// All texts.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Inputs {
    /// The texts; a missing one counts as its default.
    texts: BTreeMap<Field, String>,
    /// Where the next measurement comes from.
    pub by: MeasureBy,
    /// Hole or shaft, where the callout does not say it.
    pub feature: Option<Feature>,
}

impl Inputs {
    /// The text of a field.
    pub fn text(&self, field: Field) -> &str {
        self.texts.get(&field).map_or_else(|| field.default_text(), String::as_str)
    }

    /// Puts a text into a field.
    pub(super) fn set(&mut self, field: Field, text: String) {
        self.texts.insert(field, text);
    }
}
