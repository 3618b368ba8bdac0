//! The nominal value of cycles 14xx: their text with the limits that it stands for.
//!
//! A cycle gets limits and never a class: this file looks them up where the text is read. Like the control, it asks ISO 286 and
//! ISO 2768-1 and no table. The control compares with the middle of the zone (remembered, `docs/SOURCES.md`, "Cycles 14xx").

use std::fmt;
use std::str::FromStr;

use super::callout::{CalloutError, CycleSize, CycleText};
use super::class::Feature;
use super::limits::Bounds;
use super::sources::{LimitsError, Sources};
use crate::length::Length;
use crate::message::Say;

/// A nominal value in millimetres with the limits of its tolerance, if it has one.
///
/// ```
/// use fitcheck_core::tolerance::{Feature, Nominal};
///
/// let nominal: Nominal = "10 H7".parse()?;
/// assert_eq!((nominal.to_string().as_str(), nominal.feature()), ("10H7", Some(Feature::Hole)));
/// assert_eq!(nominal.target().to_string(), "10.0075");
/// assert_eq!("-5±0.1".parse::<Nominal>()?.target().to_string(), "-5");
/// # Ok::<(), fitcheck_core::tolerance::NominalError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Nominal {
    text: CycleText,
    value: Length,
    limits: Option<(Length, Length)>,
}

/// Why a text is not a nominal value of cycles 14xx.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "nominal", error)]
pub enum NominalError {
    /// It is not a text of these cycles.
    #[say(transparent)]
    Text(CalloutError),
    /// Its tolerance has no limits.
    #[say(transparent)]
    Limits(LimitsError),
    /// A `?`: the operator positions the probe, and nobody stands at a simulated machine.
    ByOperator,
    /// An `@`: the cycle does not probe and takes the value behind the sign, so nothing would be measured.
    NotProbed,
}

impl Nominal {
    /// A number without a tolerance.
    pub const fn of(value: Length) -> Self {
        let text = CycleText { position_unknown: false, size: Some(CycleSize::Nominal(value)), actual: None };
        Self { text, value, limits: None }
    }

    /// The number itself, in millimetres.
    pub const fn value(&self) -> Length {
        self.value
    }

    /// The smallest and the largest permitted value, in millimetres; `None` without a tolerance.
    pub const fn limits(&self) -> Option<(Length, Length)> {
        self.limits
    }

    /// What the control probes for and compares with: the middle of the zone, with a half nanometre rounded up; without a
    /// tolerance the number itself.
    pub fn target(&self) -> Length {
        self.limits.map_or(self.value, |(minimum, maximum)| minimum.midpoint(maximum))
    }

    /// Hole or shaft, by the case of a class of ISO 286; other tolerances do not say.
    pub fn feature(&self) -> Option<Feature> {
        self.text.callout()?.feature()
    }
}

impl FromStr for Nominal {
    type Err = NominalError;

    /// Reads the grammar of [`CycleText`], without `?` and `@`. Wide zones are taken as they are written: the cycle remarks on them.
    fn from_str(text: &str) -> Result<Self, NominalError> {
        let text: CycleText = text.parse().map_err(NominalError::Text)?;
        let size = match text {
            CycleText { actual: Some(_), .. } => return Err(NominalError::NotProbed),
            CycleText { position_unknown: true, .. } | CycleText { size: None, .. } => {
                return Err(NominalError::ByOperator);
            }
            CycleText { size: Some(size), .. } => size,
        };
        let of = |bounds: Bounds| Some((bounds.minimum(), bounds.maximum()));
        let (value, limits) = match size {
            CycleSize::Nominal(value) => (value, None),
            CycleSize::Callout(callout) => {
                let sources = Sources::default().with_wide_zones(true);
                let limits = sources.limits(&callout, None).map_err(NominalError::Limits)?;
                (callout.nominal(), of(limits.bounds()))
            }
            CycleSize::Position(nominal, deviations) => {
                let too_large = || NominalError::Limits(LimitsError::TooLarge { nominal });
                (nominal, of(Bounds::new(None, nominal, deviations).ok_or_else(too_large)?))
            }
        };
        Ok(Self { text, value, limits })
    }
}

/// As the control writes it: `25H7`, `10+0.01-0.015`, `-5`.
impl fmt::Display for Nominal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.text.fmt(f)
    }
}
