//! The columns that a CSV of Fitcheck has beside the measured value and that its verdict depended on: read back, so that no value
//! is corrected twice and nothing is good that was not.

use csv::StringRecord;
use fitcheck_core::length::Length;
use fitcheck_core::tolerance::fit::thermal::{Correction, ThermalDoubt, Warm};

use super::error::ImportErrorKind;
use super::given::shorten;
use super::refused::{Cell, Refused};
use crate::exchange::cell::Cells as _;

/// The cell of a position that is out.
const OUT: &str = "OUT";

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct OwnColumns {
    /// The value as it was measured, where it was brought to 20 °C.
    as_measured: Option<usize>,
    /// Temperature and expansion of the part, and of the scales.
    part: Option<[usize; 2]>,
    scale: Option<[usize; 2]>,
    /// Whether the centre was in position.
    position: Option<usize>,
    /// Why nothing was decided.
    reason: Option<usize>,
    /// The rule that judged.
    rule: Option<usize>,
    /// The limits that it judged by.
    limits: [Option<usize>; 2],
}

impl OwnColumns {
    /// The columns of a header; none where it is not one of these files. A database may have changed the case of names.
    pub(super) fn of(header: &StringRecord) -> Self {
        let at = |name: &str| header.iter().position(|cell| cell.trim().eq_ignore_ascii_case(name));
        let both = |temperature, expansion| at(temperature).zip(at(expansion)).map(<[usize; 2]>::from);
        let as_measured = at("as_measured_mm");
        if as_measured.is_none() && (at("deviation_um").is_none() || at("status").is_none()) {
            return Self::default();
        }
        Self {
            as_measured,
            part: both("temperature_c", "expansion_um_per_m_k"),
            scale: both("scale_temperature_c", "scale_expansion_um_per_m_k"),
            position: at("position"),
            reason: at("remeasure_reason"),
            rule: at("rule_name"),
            limits: [at("min_mm"), at("max_mm")],
        }
    }

    /// The columns of a correction, which are read.
    pub(super) fn of_correction(&self) -> impl Iterator<Item = usize> {
        self.as_measured.into_iter().chain(self.part.into_iter().chain(self.scale).flatten())
    }

    /// Whether values were brought to 20 °C.
    pub(super) const fn are_corrected(&self) -> bool {
        self.as_measured.is_some()
    }

    /// Whether another rule than the limits may have judged.
    pub(super) const fn have_rule(&self) -> bool {
        self.rule.is_some()
    }

    /// The limits that a row was judged by, as far as it has them.
    pub(super) fn limits(&self, cells: &StringRecord) -> [Option<Length>; 2] {
        self.limits.map(|at| cells.get(at?)?.trim().parse().ok())
    }

    /// The columns whose cells may say that the size alone does not decide.
    pub(super) const fn deciding(&self) -> [Option<usize>; 2] {
        [self.position, self.reason]
    }

    /// Refuses a row that was not judged by its size alone: a file has no position and no contacts.
    pub(super) fn decided_by_size<'c>(&self, cells: &'c StringRecord) -> Result<(), Refused<'c>> {
        let cell = |at: Option<usize>| Cell { at, text: cells.cell(at).trim() };
        let position = cell(self.position);
        let reason = cell(self.reason);
        if position.text.eq_ignore_ascii_case(OUT) {
            return Err((position, ImportErrorKind::PositionOut));
        }
        if !reason.text.is_empty() {
            let given = shorten(reason.text);
            return Err((reason, ImportErrorKind::Undecided { given }));
        }
        Ok(())
    }

    /// How a row's value was brought to 20 °C; `None` where it was not.
    pub(super) fn correction<'c>(
        &self,
        cells: &'c StringRecord,
        measured: Length,
    ) -> Result<Option<Correction>, Refused<'c>> {
        let cell = |at: usize| Cell { at: Some(at), text: cells.cell(at) };
        let text = |at: usize| cell(at).text.trim();
        let Some(as_measured) = self.as_measured.filter(|at| !text(*at).is_empty()) else { return Ok(None) };
        let refused = |at: usize| (cell(at), ImportErrorKind::Correction);
        let warm = |[temperature, expansion]: [usize; 2]| -> Result<Warm, Refused<'c>> {
            let temperature_c = text(temperature).parse().map_err(|_not_one| refused(temperature))?;
            if let Some(doubt) = ThermalDoubt::of_measured(temperature_c) {
                return Err((cell(temperature), ImportErrorKind::Temperature(doubt)));
            }
            let expansion_of = text(expansion).parse().map_err(|_not_one| refused(expansion))?;
            Ok(Warm { expansion: expansion_of, temperature: temperature_c })
        };
        let scale = self.scale.filter(|[temperature, _]| !text(*temperature).is_empty()).map(warm).transpose()?;
        let part = warm(self.part.ok_or_else(|| refused(as_measured))?)?;
        let length: Length = text(as_measured).parse().map_err(|_not_one| refused(as_measured))?;
        let correction = Correction::new(length, part, scale);
        if correction.at_reference == measured { Ok(Some(correction)) } else { Err(refused(as_measured)) }
    }
}
