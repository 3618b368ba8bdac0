//! Which measured holes go with which measured shafts.

use fitcheck_core::length::Length;
use fitcheck_core::pairing::{PairClearances, Pairing as Found, pair as paired};
use fitcheck_core::tolerance::Callout;
use fitcheck_core::tolerance::fit::Fit;
use pyo3::prelude::*;

use crate::error::{refused, with_code};
use crate::given::{chars, diameter, length, um};
use crate::limits::SOURCES;

/// Pairs, and what is left over.
#[pyclass(frozen, module = "fitcheck")]
#[derive(Debug)]
pub(crate) struct Pairing(Found);

#[pymethods]
impl Pairing {
    /// The positions of hole and shaft in the given lists, and the clearance in micrometres.
    #[getter]
    fn pairs<'py>(&self, py: Python<'py>) -> PyResult<Vec<(usize, usize, Bound<'py, PyAny>)>> {
        self.0.pairs.iter().map(|pair| Ok((pair.hole, pair.shaft, um(py, pair.clearance)?))).collect()
    }

    #[getter]
    fn holes_left(&self) -> Vec<usize> {
        self.0.holes.clone()
    }

    #[getter]
    fn shafts_left(&self) -> Vec<usize> {
        self.0.shafts.clone()
    }

    #[getter]
    fn band_um<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        um(py, self.0.band)
    }

    fn __repr__(&self) -> String {
        let Found { pairs, holes, shafts, .. } = &self.0;
        format!("Pairing({} pairs, {} holes and {} shafts left)", pairs.len(), holes.len(), shafts.len())
    }
}

/// Measured diameters, each named by its place where it is none.
fn sizes(given: &[Bound<'_, PyAny>], what: &str) -> PyResult<Vec<Length>> {
    given.iter().enumerate().map(|(at, size)| diameter(size, &format!("{what}[{at}]"))).collect()
}

/// Pairs measured holes with measured shafts (selective assembly), for clearances in millimetres, both ends included, or for a fit.
///
/// A negative clearance is an interference. Raises FitcheckError for a size that is none, named by its place.
#[pyfunction]
#[pyo3(signature = (holes, shafts, *, clearance = None, fit = None))]
#[expect(clippy::needless_pass_by_value, reason = "a sequence of Python becomes a list of its own")]
pub(crate) fn pair(
    py: Python<'_>,
    holes: Vec<Bound<'_, PyAny>>,
    shafts: Vec<Bound<'_, PyAny>>,
    clearance: Option<(Bound<'_, PyAny>, Bound<'_, PyAny>)>,
    fit: Option<&Bound<'_, PyAny>>,
) -> PyResult<Pairing> {
    let wanted = match (clearance, fit) {
        (Some((least, most)), None) => {
            let wanted = PairClearances::new(length(&least, "clearance")?, length(&most, "clearance")?);
            wanted.map_err(|error| refused("clearance", &error))?
        }
        (None, Some(fit)) => {
            let text = chars(fit, "fit")?;
            let callout: Callout = text.parse().map_err(|error| refused("fit", &error))?;
            let fit = Fit::of_callout(&callout, &SOURCES).map_err(|error| refused("fit", &error))?;
            PairClearances::new(fit.minimum_clearance(), fit.maximum_clearance())
                .map_err(|error| refused("fit", &error))?
        }
        _ => {
            let text =
                "give clearance=(least, most) in millimetres or fit=\"25 H7/g6\", and one of them only".to_owned();
            return Err(with_code(text, "python-no-clearance"));
        }
    };
    let (holes, shafts) = (sizes(&holes, "holes")?, sizes(&shafts, "shafts")?);
    Ok(Pairing(py.detach(|| paired(&holes, &shafts, wanted))))
}
