//! The kinds of contributions as a file names them, and the keys that follow from them.

use serde::Deserialize;

use super::numbers::{ALPHA, FAR};

crate::named! {
    /// The kind of a contribution as it is written.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum KindName {
        /// Every kind; a contribution without one is plain.
        ALL;
        /// Its name in files.
        fn name;
        /// The scatter of one touch.
        Scatter = "scatter",
        /// The temperature of the part.
        PartTemperature = "part-temperature",
        /// That of the machine's scales.
        ScaleTemperature = "scale-temperature",
        /// The expansion of the part.
        PartExpansion = "part-expansion",
        /// That of the machine's scales.
        ScaleExpansion = "scale-expansion",
        /// The step of the display.
        Resolution = "resolution",
    }
}

/// The keys of a standard uncertainty, an expanded one with its factor, and a half width, in the unit of a kind.
#[derive(Debug)]
pub struct Keys {
    /// The key of a standard uncertainty.
    pub standard: &'static str,
    /// That of an expanded one.
    pub expanded: &'static str,
    /// That of a half width.
    pub half_width: &'static str,
    /// For what is missing.
    pub(super) normal: &'static str,
    /// By what the number is multiplied for the unit of [`Contribution::u`].
    pub(super) unit: f64,
    /// The largest number that is allowed.
    pub(super) most: f64,
}

const MICROMETRES: Keys = Keys {
    standard: "standard_um",
    expanded: "expanded_um",
    half_width: "half_width_um",
    normal: "standard_um, or expanded_um with k",
    unit: 1.0,
    most: FAR,
};

const KELVINS: Keys = Keys {
    standard: "standard_k",
    expanded: "expanded_k",
    half_width: "half_width_k",
    normal: "standard_k, or expanded_k with k",
    unit: 1.0,
    most: FAR,
};

const PER_KELVIN: Keys = Keys {
    standard: "standard_per_k",
    expanded: "expanded_per_k",
    half_width: "half_width_per_k",
    normal: "standard_per_k, or expanded_per_k with k",
    unit: 1e6,
    most: ALPHA,
};

impl KindName {
    /// The keys of its uncertainty.
    pub const fn keys(kind: Option<Self>) -> &'static Keys {
        match kind {
            Some(Self::PartTemperature | Self::ScaleTemperature) => &KELVINS,
            Some(Self::PartExpansion | Self::ScaleExpansion) => &PER_KELVIN,
            Some(Self::Scatter | Self::Resolution) | None => &MICROMETRES,
        }
    }

    /// The keys that a kind has besides.
    pub const fn besides(kind: Option<Self>) -> &'static [&'static str] {
        match kind {
            Some(Self::Scatter) => &["touches", "step_deg"],
            Some(Self::PartTemperature | Self::ScaleTemperature) => &["alpha_per_k"],
            Some(Self::PartExpansion | Self::ScaleExpansion) => &["delta_k"],
            Some(Self::Resolution) | None => &[],
        }
    }
}
