//! Materials of parts, by name or by expansion, and the temperature of a measured part.

use std::path::{Path, PathBuf};

use super::{CliError, ErrorSubject, IntoCliError as _};
use crate::files;
use crate::length::Length;
use crate::message::IntoArg as _;
use crate::text::decode;
use crate::tolerance::fit::materials::{Certainty, Materials};
use crate::tolerance::fit::thermal::{Correction, Expansion, Range, Temperature, ThermalDoubt, ThermalError, Warm};

/// The built-in materials, with a user's own file before them.
pub(super) fn materials(own: Option<&Path>) -> Result<Materials, CliError> {
    let shipped = Materials::shipped();
    let Some(path) = own else { return Ok(shipped.clone()) };
    let own = Materials::read(&decode(&files::read(path)?));
    Ok(shipped.with_own(own.about(&path.display().to_string())?))
}

/// The material of a part.
#[derive(Debug, Clone)]
pub(super) struct Part {
    /// Its English name; `None` where the expansion itself was given.
    pub name: Option<String>,
    pub certainty: Certainty,
    pub source: Option<String>,
    pub warm: Warm,
    /// At which temperatures it expands as much.
    pub range: Range,
}

impl Part {
    /// A material by its name, which may be a number such as 1.4301, or else an expansion.
    pub(super) fn of(text: &str, materials: &Materials, temperature: Temperature) -> Result<Self, CliError> {
        let warm = |expansion| Warm { expansion, temperature };
        match materials.find(text) {
            Ok(material) => Ok(Self {
                name: Some(material.name.clone()),
                certainty: material.certainty,
                source: material.source.clone(),
                warm: warm(material.expansion),
                range: material.range,
            }),
            Err(unknown) => match text.parse::<Expansion>() {
                Ok(expansion) => Ok(Self {
                    name: None,
                    certainty: Certainty::Own,
                    source: None,
                    warm: warm(expansion),
                    range: Range::USUAL,
                }),
                Err(ThermalError::NotANumber { .. }) => Err(unknown).said(),
                Err(error) => Err(error).said(),
            },
        }
    }

    /// What is doubtful about its temperature, whether it is measured or only warm.
    pub(super) fn doubt(&self, is_measured: bool) -> Option<ThermalDoubt> {
        let Warm { expansion, temperature } = self.warm;
        let measured = if is_measured { ThermalDoubt::of_measured(temperature) } else { None };
        measured.or_else(|| ThermalDoubt::of_expansion(temperature, expansion, self.range))
    }
}

/// Refuses a doubtful temperature, unless it is meant.
pub(super) fn refuse_far(doubt: Option<ThermalDoubt>, is_meant: bool) -> Result<Option<ThermalDoubt>, CliError> {
    match doubt {
        Some(error) if !is_meant => Err(CliError::AddFarTemperature { what: ErrorSubject::Temperature.arg(), error }),
        doubt => Ok(doubt),
    }
}

/// The temperature at which a part was measured.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Temperature")]
pub(super) struct WarmArgs {
    /// Temperature of the measured part in °C; the value is corrected to 20 °C before it is judged
    #[arg(long, value_name = "C", requires = "material", allow_hyphen_values = true)]
    temperature: Option<String>,
    /// Material of the part, or its expansion in millionths per kelvin, such as 11.5
    #[arg(long, value_name = "NAME", requires = "temperature", allow_hyphen_values = true)]
    material: Option<String>,
    /// Temperature of the machine's scales in °C, if the machine does not compensate for it
    #[arg(long, value_name = "C", requires_all = ["scale_material", "temperature"], allow_hyphen_values = true)]
    scale_temperature: Option<String>,
    /// Material of the scales, or their expansion
    #[arg(long, value_name = "NAME", requires = "scale_temperature", allow_hyphen_values = true)]
    scale_material: Option<String>,
    /// TOML file with your own materials; they replace built-in ones of the same name and add others
    #[arg(long, value_name = "FILE.toml", requires = "material")]
    materials: Option<PathBuf>,
    /// Accept a temperature below -20 °C, above 50 °C or outside the range of the expansion
    #[arg(long, requires = "temperature")]
    far_temperature: bool,
}

/// How warm a measured part is, and the scales that it was measured with where they count.
#[derive(Debug, Clone)]
pub(super) struct Warmth {
    pub part: Part,
    pub scale: Option<Warm>,
    /// What is doubtful about the temperatures, and meant.
    pub doubts: Vec<ThermalDoubt>,
}

impl WarmArgs {
    /// The correction of a measured length; `None` where no temperature was given.
    pub(super) fn correction(&self, measured: Length) -> Result<Option<(Correction, Warmth)>, CliError> {
        let Some(warmth) = self.warmth()? else { return Ok(None) };
        Ok(Some((Correction::new(measured, warmth.part.warm, warmth.scale), warmth)))
    }

    /// From which temperature values are brought to 20 °C, or 20 °C where none was given.
    pub(super) fn counted(&self) -> Result<Temperature, CliError> {
        Ok(self.warmth()?.map_or(Temperature::REFERENCE, |warmth| warmth.part.warm.temperature))
    }

    /// The temperatures; `None` where none was given.
    pub(super) fn warmth(&self) -> Result<Option<Warmth>, CliError> {
        let (Some(temperature), Some(material)) = (&self.temperature, &self.material) else { return Ok(None) };
        let materials = materials(self.materials.as_deref())?;
        let read = |text: &str| text.parse::<Temperature>().about(&ErrorSubject::Temperature);
        let part =
            Part::of(material, &materials, read(temperature)?).about(&ErrorSubject::Option { name: "material" })?;
        let scale = match (&self.scale_temperature, &self.scale_material) {
            (Some(temperature), Some(material)) => {
                let scale = Part::of(material, &materials, read(temperature)?);
                Some(scale.about(&ErrorSubject::Option { name: "scale-material" })?)
            }
            _ => None,
        };
        let mut doubts = Vec::new();
        for of in std::iter::once(&part).chain(&scale) {
            doubts.extend(refuse_far(of.doubt(true), self.far_temperature)?);
        }
        let scale = scale.map(|scale| scale.warm);
        Ok(Some(Warmth { part, scale, doubts }))
    }
}
