//! Materials and temperatures: arguments, and their effect on a fit.

use std::path::{Path, PathBuf};

use crate::cli::material::{Part, materials, refuse_far};
use crate::cli::{CliError, ErrorSubject, IntoCliError as _};
use crate::length::Length;
use crate::tolerance::fit::thermal::{Temperature, ThermalDoubt, clearance_change_apart};
use crate::tolerance::fit::{Fit, FitKind};

/// Materials and temperatures.
#[derive(Debug, clap::Args)]
pub(super) struct HeatArgs {
    /// Material of the hole, or its expansion in millionths per kelvin, such as 11.5
    #[arg(
        long,
        alias = "hub-material",
        value_name = "NAME",
        requires = "shaft_material",
        requires = "heat",
        allow_hyphen_values = true
    )]
    hole_material: Option<String>,

    /// Material of the shaft, or its expansion
    #[arg(long, value_name = "NAME", requires = "hole_material", allow_hyphen_values = true)]
    shaft_material: Option<String>,

    #[command(flatten)]
    temperatures: TemperatureArgs,

    /// TOML file with your own materials; they replace built-in ones of the same name and add others
    #[arg(long, value_name = "FILE.toml", requires = "hole_material")]
    materials: Option<PathBuf>,

    /// Accept a temperature outside the range of the expansion
    #[arg(long, requires = "hole_material")]
    far_temperature: bool,
}

/// One temperature for both parts, or one for each.
#[derive(Debug, clap::Args)]
#[group(id = "heat", multiple = true)]
struct TemperatureArgs {
    /// Temperature of both parts in °C
    #[arg(
        long,
        value_name = "C",
        requires = "hole_material",
        conflicts_with_all = ["hole_temperature", "shaft_temperature"],
        allow_hyphen_values = true
    )]
    temperature: Option<String>,

    /// Temperature of the hole in °C; default: 20
    #[arg(long, value_name = "C", requires = "hole_material", allow_hyphen_values = true)]
    hole_temperature: Option<String>,

    /// Temperature of the shaft in °C; default: 20
    #[arg(long, value_name = "C", requires = "hole_material", allow_hyphen_values = true)]
    shaft_temperature: Option<String>,
}

/// Both parts.
#[derive(Debug, Clone)]
pub(super) struct Heat {
    pub hole: Part,
    pub shaft: Part,
    /// What is doubtful about the temperatures, and meant.
    pub doubts: Vec<ThermalDoubt>,
}

/// A fit at these temperatures.
#[derive(Debug, Clone, Copy)]
pub(super) struct Heated {
    /// How much larger the clearance is than at 20 °C.
    pub change: Length,
    pub minimum: Length,
    pub maximum: Length,
    pub actual: Option<Length>,
}

impl Heated {
    pub(super) fn kind(&self) -> FitKind {
        FitKind::of(self.minimum, self.maximum)
    }
}

impl HeatArgs {
    pub(super) const fn is_asked(&self) -> bool {
        self.hole_material.is_some() || self.shaft_material.is_some()
    }

    /// The names of the materials of hole and shaft, and the file of the user's own.
    pub(super) fn materials(&self) -> ([Option<&str>; 2], Option<&Path>) {
        ([self.hole_material.as_deref(), self.shaft_material.as_deref()], self.materials.as_deref())
    }

    /// The materials at their temperatures; `None` without them, or where a press fit alone needs them.
    pub(super) fn load(&self, is_press: bool) -> Result<Option<Heat>, CliError> {
        let TemperatureArgs { temperature, hole_temperature, shaft_temperature } = &self.temperatures;
        if is_press && temperature.is_none() && hole_temperature.is_none() && shaft_temperature.is_none() {
            return Ok(None);
        }
        let (Some(hole), Some(shaft)) = (&self.hole_material, &self.shaft_material) else { return Ok(None) };
        let materials = materials(self.materials.as_deref())?;
        let part = |name: &str, own_temperature: Option<&String>, which: ErrorSubject<'_>| {
            let temperature = match self.temperatures.temperature.as_ref().or(own_temperature) {
                Some(text) => text.parse().about(&ErrorSubject::Temperature)?,
                None => Temperature::REFERENCE,
            };
            Part::of(name, &materials, temperature).about(&which)
        };
        let hole = part(hole, self.temperatures.hole_temperature.as_ref(), ErrorSubject::HoleMaterial)?;
        let shaft = part(shaft, self.temperatures.shaft_temperature.as_ref(), ErrorSubject::ShaftMaterial)?;
        let mut doubts = Vec::new();
        for part in [&hole, &shaft] {
            doubts.extend(refuse_far(part.doubt(false), self.far_temperature)?);
        }
        Ok(Some(Heat { hole, shaft, doubts }))
    }
}

impl Heat {
    /// A fit at these temperatures; `None` beyond what a length holds.
    pub(super) fn of(&self, fit: &Fit, actual: Option<Length>) -> Option<Heated> {
        let change = clearance_change_apart(fit.nominal(), self.hole.warm, self.shaft.warm);
        Some(Heated {
            change,
            minimum: fit.minimum_clearance().checked_add(change)?,
            maximum: fit.maximum_clearance().checked_add(change)?,
            actual: match actual {
                Some(actual) => Some(actual.checked_add(change)?),
                None => None,
            },
        })
    }
}
