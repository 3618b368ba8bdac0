//! How sure a measured value is: an uncertainty budget evaluated.

use fitcheck_core::budget::{Assessment, Budget as File, Conditions, Geometry};
use fitcheck_core::message::Say as _;
use jiff::Zoned;
use jiff::civil::Date;
use pyo3::prelude::*;

use crate::error::{refused, with_code};
use crate::given::{chars, decimal, diameter};

/// A budget and what it comes to.
#[pyclass(frozen, module = "fitcheck")]
#[derive(Debug)]
pub(crate) struct Budget(Assessment);

#[pymethods]
impl Budget {
    #[getter]
    fn name(&self) -> &str {
        &self.0.budget.name
    }

    #[getter]
    fn u_um(&self) -> f64 {
        self.0.u()
    }

    #[getter]
    fn k(&self) -> f64 {
        self.0.k()
    }

    #[getter]
    fn expanded_um(&self) -> f64 {
        self.0.expanded()
    }

    #[getter]
    fn degrees_of_freedom(&self) -> Option<f64> {
        self.0.degrees_of_freedom()
    }

    #[getter]
    fn valid_until(&self) -> String {
        self.0.budget.valid_until.to_string()
    }

    /// The standard uncertainty that a decision rule gets: to the picometre, for `check(..., u_um=…, k=…)`.
    #[getter]
    fn rule_u_um<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let uncertainty = self.0.uncertainty().map_err(|error| refused("budget", &error))?;
        decimal(py, &uncertainty.um())
    }

    #[getter]
    fn warnings(&self) -> Vec<String> {
        let template = self.0.budget.template_figures();
        self.0.warnings().iter().chain(&template).map(ToString::to_string).collect()
    }

    fn __repr__(&self) -> String {
        format!(
            "Budget('{}', u_um={}, k={}, expanded_um={})",
            self.0.budget.name,
            self.0.u(),
            self.0.k(),
            self.0.expanded()
        )
    }
}

/// Evaluates the text of a budget file (TOML, as `fitcheck budget` reads it).
///
/// size: the measured size in millimetres, for contributions that grow with it. touches and step_deg: how many contacts were taken,
/// and the angle between them in degrees. day: YYYY-MM-DD, today unless given; a budget that is not valid then says so.
#[pyfunction]
#[pyo3(signature = (text, *, size = None, touches = None, step_deg = None, day = None))]
pub(crate) fn budget(
    text: &Bound<'_, PyAny>,
    size: Option<&Bound<'_, PyAny>>,
    touches: Option<u32>,
    step_deg: Option<f64>,
    day: Option<&str>,
) -> PyResult<Budget> {
    let budget = File::read(&chars(text, "budget")?).map_err(|error| refused("budget", &error))?;
    let size = size.map(|size| diameter(size, "size")).transpose()?;
    let geometry = match (touches, step_deg) {
        (Some(touches), Some(step)) => {
            Some(Geometry::steps(touches, step).map_err(|error| refused("touches", &error))?)
        }
        (None, None) => None,
        _ => return Err(with_code("touches and step_deg: give both or none".to_owned(), "python-no-step")),
    };
    let day = match day {
        Some(text) => text.parse::<Date>().map_err(|error| with_code(format!("day: {error}"), "python-no-day"))?,
        None => Zoned::now().date(),
    };
    let conditions = Conditions { size, geometry, ..Conditions::default() };
    let found = Assessment::of(budget, &conditions, None, day);
    found.map(Budget).map_err(|error| with_code(format!("budget: {}", error.message()), error.message().id))
}
