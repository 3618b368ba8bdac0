//! The text fields of the fit page.

use crate::session::field::KeptField;
use crate::tolerance::Feature;

/// A text field of the fit page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FitField {
    /// Nominal size and both classes of a fit, `25 H7/g6`.
    Callout,
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
}

impl FitField {
    /// The field of a part's measured size.
    pub const fn measured(part: Feature) -> Self {
        match part {
            Feature::Hole => Self::HoleMeasured,
            Feature::Shaft => Self::ShaftMeasured,
        }
    }

    /// The field of a part's expansion.
    pub const fn expansion(part: Feature) -> Self {
        match part {
            Feature::Hole => Self::HoleExpansion,
            Feature::Shaft => Self::ShaftExpansion,
        }
    }
}

impl KeptField for FitField {
    const ALL: &'static [Self] = &[
        Self::Callout,
        Self::HoleMeasured,
        Self::ShaftMeasured,
        Self::Temperature,
        Self::HoleExpansion,
        Self::ShaftExpansion,
        Self::WantedMinimum,
        Self::WantedMaximum,
    ];

    fn declared(self) -> (&'static str, &'static str) {
        match self {
            Self::Callout => ("fit-callout", ""),
            Self::HoleMeasured => ("hole-measured", ""),
            Self::ShaftMeasured => ("shaft-measured", ""),
            Self::Temperature => ("temperature", "20"),
            Self::HoleExpansion => ("hole-expansion", "11.5"),
            Self::ShaftExpansion => ("shaft-expansion", "11.5"),
            Self::WantedMinimum => ("wanted-minimum", ""),
            Self::WantedMaximum => ("wanted-maximum", ""),
        }
    }
}
