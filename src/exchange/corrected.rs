//! The columns that a CSV of Fitcheck has for values brought to 20 °C: read back, so that no value is corrected twice.

use csv::StringRecord;

use super::error::ImportErrorKind;
use super::rules::{Cell, Refused};
use crate::length::Length;
use crate::tolerance::fit::thermal::{Correction, Warm};

/// Where they are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct CorrectedColumns {
    /// The value as it was measured.
    as_measured: usize,
    /// Temperature and expansion of the part, and of the scales.
    part: [usize; 2],
    scale: Option<[usize; 2]>,
}

impl CorrectedColumns {
    /// The columns of a header; `None` where it is not one of these files.
    pub(super) fn of(header: &StringRecord) -> Option<Self> {
        let at = |name: &str| header.iter().position(|cell| cell.trim() == name);
        let scale = at("scale_temperature_c").zip(at("scale_expansion_um_per_m_k")).map(<[usize; 2]>::from);
        let part = [at("temperature_c")?, at("expansion_um_per_m_k")?];
        Some(Self { as_measured: at("as_measured_mm")?, part, scale })
    }

    /// All of them.
    pub(super) fn all(&self) -> impl Iterator<Item = usize> {
        [self.as_measured].into_iter().chain(self.part).chain(self.scale.into_iter().flatten())
    }

    /// How a row's value was brought to 20 °C; `None` where it was not.
    pub(super) fn read<'c>(self, cells: &'c StringRecord, measured: Length) -> Result<Option<Correction>, Refused<'c>> {
        let cell = |at: usize| Cell { at: Some(at), text: cells.get(at).unwrap_or_default() };
        let text = |at: usize| cell(at).text.trim();
        if text(self.as_measured).is_empty() {
            return Ok(None);
        }
        let refused = |at: usize| (cell(at), ImportErrorKind::Correction);
        let warm = |[temperature, expansion]: [usize; 2]| -> Result<Warm, Refused<'c>> {
            let temperature_c = text(temperature).parse().map_err(|_not_one| refused(temperature))?;
            let expansion_of = text(expansion).parse().map_err(|_not_one| refused(expansion))?;
            Ok(Warm { expansion: expansion_of, temperature: temperature_c })
        };
        let scale = self.scale.filter(|[temperature, _]| !text(*temperature).is_empty()).map(warm).transpose()?;
        let as_measured: Length = text(self.as_measured).parse().map_err(|_not_one| refused(self.as_measured))?;
        let correction = Correction::new(as_measured, warm(self.part)?, scale);
        if correction.at_reference == measured { Ok(Some(correction)) } else { Err(refused(self.as_measured)) }
    }
}
