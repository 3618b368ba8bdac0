//! Limits of size of a callout.

use std::sync::LazyLock;

use fitcheck_core::probing::noted;
use fitcheck_core::tolerance::{Callout, Feature, FigureWarning, Limits as Found, Sources};
use pyo3::prelude::*;

use crate::error::{refused, with_code};
use crate::given::{chars, mm, um};

/// ISO 286 and the general tolerances.
pub(crate) static SOURCES: LazyLock<Sources> = LazyLock::new(Sources::default);

/// A callout with its limits.
#[derive(Debug, Clone)]
pub(crate) struct Asked {
    pub(crate) callout: Callout,
    pub(crate) limits: Found,
}

impl Asked {
    pub(crate) fn of(callout: &str, feature: Option<&str>) -> PyResult<Self> {
        let about = callout.trim();
        let feature = feature.map(side).transpose()?;
        let parsed: Callout = callout.parse().map_err(|error| refused(about, &error))?;
        let limits = SOURCES.limits(&parsed, feature).map_err(|error| refused(about, &error))?;
        Ok(Self { callout: parsed.of_part(limits.feature), limits })
    }

    /// What is doubtful about the zone of the callout.
    pub(crate) fn zone_warnings(&self) -> Vec<String> {
        SOURCES.zone_doubt(&self.callout, &self.limits).map(|doubt| doubt.to_string()).into_iter().collect()
    }

    /// What to check about the figures behind its limits.
    pub(crate) fn figure_warnings(&self) -> Vec<String> {
        let warning = FigureWarning::of_limits(&self.callout, &self.limits, &SOURCES);
        warning.map(|warning| warning.to_string()).into_iter().collect()
    }
}

fn side(word: &str) -> PyResult<Feature> {
    [Feature::Hole, Feature::Shaft]
        .into_iter()
        .find(|feature| feature.word() == word)
        .ok_or_else(|| with_code(format!("feature: {word:?} is neither \"hole\" nor \"shaft\""), "python-no-feature"))
}

/// The limits of size of a callout, in millimetres.
#[pyclass(frozen, module = "fitcheck")]
#[derive(Debug)]
pub(crate) struct Limits(pub(crate) Asked);

#[pymethods]
impl Limits {
    #[getter]
    fn callout(&self) -> String {
        self.0.callout.to_string()
    }

    #[getter]
    fn feature(&self) -> Option<&'static str> {
        self.0.limits.feature.map(Feature::word)
    }

    #[getter]
    fn nominal<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        mm(py, self.0.limits.nominal)
    }

    #[getter]
    fn minimum<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        mm(py, self.0.limits.minimum())
    }

    #[getter]
    fn maximum<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        mm(py, self.0.limits.maximum())
    }

    #[getter]
    fn lower_um<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        um(py, self.0.limits.deviations.lower())
    }

    #[getter]
    fn upper_um<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        um(py, self.0.limits.deviations.upper())
    }

    #[getter]
    fn source(&self) -> String {
        self.0.limits.source.with_difference()
    }

    #[getter]
    fn warnings(&self) -> Vec<String> {
        let differs = noted::differing(self.0.callout.notes(), &self.0.limits);
        let mut warnings = self.0.zone_warnings();
        warnings.extend(differs.map(|differs| differs.to_string()));
        warnings
    }

    fn __repr__(&self) -> String {
        let Asked { callout, limits } = &self.0;
        format!(
            "Limits('{callout}', minimum={}, maximum={}, source='{}')",
            limits.minimum(),
            limits.maximum(),
            limits.source
        )
    }
}

/// The limits of size of a callout: "25 H7", "12 ±0.02", "10m", "12 +0.01 -0.015", or one part of "25 H7/g6" with its feature.
///
/// Limits: ISO 286-1 and -2 (classes to 3150 mm), ISO 2768-1. Raises FitcheckError where a class is not defined at a size.
#[pyfunction]
#[pyo3(signature = (callout, *, feature = None))]
pub(crate) fn limits(callout: &Bound<'_, PyAny>, feature: Option<&str>) -> PyResult<Limits> {
    Asked::of(&chars(callout, "callout")?, feature).map(Limits)
}
