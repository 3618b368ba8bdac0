//! A hole and a shaft of the same nominal size.

use fitcheck_core::tolerance::Callout;
use fitcheck_core::tolerance::fit::Fit as Found;
use fitcheck_core::verdict::fit::Actual;
use pyo3::prelude::*;

use crate::check::status_of;
use crate::error::refused;
use crate::given::{chars, diameter, mm, um};
use crate::limits::{Asked, Limits, SOURCES};

/// A fit, and two parts where they were measured.
#[pyclass(frozen, module = "fitcheck")]
#[derive(Debug)]
pub(crate) struct Fit {
    callout: Callout,
    found: Found,
    actual: Option<Actual>,
}

#[pymethods]
impl Fit {
    #[getter]
    fn callout(&self) -> String {
        self.callout.to_string()
    }

    #[getter]
    fn kind(&self) -> &'static str {
        self.found.kind().word()
    }

    #[getter]
    fn nominal<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        mm(py, self.found.hole().nominal)
    }

    #[getter]
    fn minimum_clearance_um<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        um(py, self.found.minimum_clearance())
    }

    #[getter]
    fn maximum_clearance_um<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        um(py, self.found.maximum_clearance())
    }

    #[getter]
    fn hole(&self) -> Limits {
        Limits(Asked { callout: self.callout.of_part(self.found.hole().feature), limits: self.found.hole().clone() })
    }

    #[getter]
    fn shaft(&self) -> Limits {
        Limits(Asked { callout: self.callout.of_part(self.found.shaft().feature), limits: self.found.shaft().clone() })
    }

    #[getter]
    fn clearance_um<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.actual.map(|actual| um(py, actual.clearance)).transpose()
    }

    #[getter]
    fn status(&self, py: Python<'_>) -> PyResult<Option<Py<PyAny>>> {
        self.actual.map(|actual| status_of(py, actual.status())).transpose()
    }

    fn __repr__(&self) -> String {
        let Self { callout, found: fit, .. } = self;
        let (least, most) = (fit.minimum_clearance().signed_um(), fit.maximum_clearance().signed_um());
        format!("Fit('{callout}', {}, clearance {least} to {most} µm)", fit.kind().word())
    }
}

/// A fit such as "25 H7/g6"; with both measured diameters, how the parts go together. Raises FitcheckError as limits() does.
#[pyfunction]
#[pyo3(signature = (callout, *, hole = None, shaft = None))]
pub(crate) fn fit(
    callout: &Bound<'_, PyAny>,
    hole: Option<&Bound<'_, PyAny>>,
    shaft: Option<&Bound<'_, PyAny>>,
) -> PyResult<Fit> {
    let text = chars(callout, "callout")?;
    let about = text.trim();
    let callout: Callout = text.parse().map_err(|error| refused(about, &error))?;
    let fit = Found::of_callout(&callout, &SOURCES).map_err(|error| refused(about, &error))?;
    let actual = match (hole, shaft) {
        (Some(hole), Some(shaft)) => Some(Actual::of(&fit, diameter(hole, "hole")?, diameter(shaft, "shaft")?)),
        (None, None) => None,
        (Some(_), None) | (None, Some(_)) => {
            let text = "hole and shaft: give both measured diameters; check() judges one of them".to_owned();
            return Err(crate::error::with_code(text, "python-one-part"));
        }
    };
    Ok(Fit { callout, found: fit, actual })
}
