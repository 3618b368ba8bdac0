//! The text fields of the fit page.

use fitcheck_core::tolerance::Feature;

use crate::texts::kept_fields;

kept_fields! {
    /// A text field of the fit page.
    FitField

    /// Nominal size and both classes of a fit, `25 H7/g6`.
    Callout: "fit-callout", "";
    /// The hole's measured diameter, mm; empty where it was not measured.
    HoleMeasured: "hole-measured", "";
    /// The shaft's measured diameter, mm; empty where it was not measured.
    ShaftMeasured: "shaft-measured", "";
    /// The temperature of both parts, °C.
    Temperature: "temperature", "20";
    /// Expansion of the hole's material, 10⁻⁶/K.
    HoleExpansion: "hole-expansion", "11.5";
    /// Expansion of the shaft's material, 10⁻⁶/K.
    ShaftExpansion: "shaft-expansion", "11.5";
    /// How long hub and shaft of a press fit touch, mm; empty where none is asked for.
    PressLength: "press-length", "";
    /// The outer diameter of its hub, mm.
    HubOuter: "hub-outer", "";
    /// The bore of its shaft, mm; 0 for a solid one.
    ShaftBore: "shaft-bore", "0";
    /// The smallest clearance to search for, mm; negative is an interference.
    WantedMinimum: "wanted-minimum", "";
    /// The largest clearance to search for, mm; negative is an interference.
    WantedMaximum: "wanted-maximum", "";
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
