//! One measured value judged.

use fitcheck_core::length::Length;
use fitcheck_core::probing::measurement::Caveat;
use fitcheck_core::probing::{Measurement, Origin};
use fitcheck_core::verdict::Status;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::row;
use jiff::Zoned;
use jiff::civil::DateTime;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyList, PyString};
use serde_json::Value;

use crate::error::with_code;
use crate::given::{chars, diameter, mm, um};
use crate::limits::Asked;
use crate::rule::Told;

/// A measured value with its limits and what follows.
#[pyclass(frozen, module = "fitcheck")]
#[derive(Debug)]
pub(crate) struct Verdict {
    record: Record,
    asked: Asked,
}

/// The members of `fitcheck.Status`, in the order of [`Status::ALL`].
static STATUSES: PyOnceLock<Vec<Py<PyAny>>> = PyOnceLock::new();

/// A status as Python has it.
pub(crate) fn status_of(py: Python<'_>, status: Status) -> PyResult<Py<PyAny>> {
    let all = STATUSES.get_or_try_init(py, || {
        let of = py.import("fitcheck")?.getattr("Status")?;
        Status::ALL.iter().map(|status| Ok(of.call1((status.word(),))?.unbind())).collect::<PyResult<_>>()
    })?;
    // The list has one for each.
    Ok(all.get(status.at()).map_or_else(|| py.None(), |status| status.clone_ref(py)))
}

impl Verdict {
    fn size(&self) -> &fitcheck_core::verdict::SizeVerdict {
        &self.record.verdict.size
    }

    fn removal<'py>(
        &self,
        py: Python<'py>,
        of: impl Fn(fitcheck_core::verdict::Removal) -> Length,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.size().removal.map(|removal| um(py, of(removal))).transpose()
    }

    fn zone(&self, at: usize) -> Option<Length> {
        self.record.decision()?.zones.accepted?.get(at).copied()
    }
}

#[pymethods]
impl Verdict {
    #[getter]
    fn status(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        status_of(py, self.record.verdict.status())
    }

    #[getter]
    fn is_good(&self) -> bool {
        self.record.verdict.status() == Status::Good && self.warnings().is_empty()
    }

    #[getter]
    fn callout(&self) -> String {
        self.asked.callout.to_string()
    }

    #[getter]
    fn feature(&self) -> Option<&'static str> {
        self.record.limits.feature.map(fitcheck_core::tolerance::Feature::word)
    }

    #[getter]
    fn nominal<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        mm(py, self.record.limits.nominal)
    }

    #[getter]
    fn minimum<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        mm(py, self.record.limits.minimum())
    }

    #[getter]
    fn maximum<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        mm(py, self.record.limits.maximum())
    }

    #[getter]
    fn measured<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        mm(py, self.record.measurement.diameter)
    }

    #[getter]
    fn deviation_um<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        um(py, self.size().deviation)
    }

    #[getter]
    fn remove_um<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.removal(py, |removal| removal.to_limit)
    }

    #[getter]
    fn remove_to_middle_um<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.removal(py, |removal| removal.to_middle)
    }

    #[getter]
    fn rule(&self) -> &'static str {
        self.record.verdict.rule.name().word()
    }

    #[getter]
    fn accepted_minimum<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.zone(0).map(|length| mm(py, length)).transpose()
    }

    #[getter]
    fn accepted_maximum<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.zone(1).map(|length| mm(py, length)).transpose()
    }

    #[getter]
    fn is_proven(&self) -> Option<bool> {
        self.record.decision()?.proven
    }

    #[getter]
    fn source(&self) -> String {
        self.record.limits.source.with_difference()
    }

    /// What stands against the answer. That one diameter says nothing of form and position stands in `as_dict`.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        let mut warnings = self.asked.zone_warnings();
        warnings.extend(self.record.doubt.map(|doubt| doubt.to_string()));
        let caveats = self.record.caveats().into_iter().filter(|caveat| *caveat != Caveat::OnlyADiameter);
        warnings.extend(caveats.map(|caveat| caveat.to_string()));
        warnings.extend(self.asked.figure_warnings());
        warnings
    }

    /// What `fitcheck check --format json` says, with the time of this call.
    fn as_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let record = Record { time: Zoned::now().datetime(), ..self.record.clone() };
        let object = row::object(&record).map_err(|error| with_code(format!("record: {error}"), "python-no-record"))?;
        let dict = PyDict::new(py);
        for (name, value) in &object {
            dict.set_item(name, python(py, value)?)?;
        }
        Ok(dict)
    }

    fn __repr__(&self) -> String {
        let Record { limits, measurement, verdict, .. } = &self.record;
        let (status, callout) = (verdict.status().word(), self.asked.callout);
        format!(
            "Verdict({status}, '{callout}', measured={}, minimum={}, maximum={})",
            measurement.diameter,
            limits.minimum(),
            limits.maximum()
        )
    }
}

/// A value of JSON as Python's own.
fn python<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    Ok(match value {
        Value::Null => py.None().into_bound(py),
        Value::Bool(is) => is.into_pyobject(py)?.to_owned().into_any(),
        Value::Number(number) => match number.as_i64() {
            Some(whole) => whole.into_pyobject(py)?.into_any(),
            None => number.as_f64().into_pyobject(py)?,
        },
        Value::String(text) => PyString::new(py, text).into_any(),
        Value::Array(values) => {
            let values: Vec<_> = values.iter().map(|value| python(py, value)).collect::<PyResult<_>>()?;
            PyList::new(py, values)?.into_any()
        }
        Value::Object(fields) => {
            let dict = PyDict::new(py);
            for (name, value) in fields {
                dict.set_item(name, python(py, value)?)?;
            }
            dict.into_any()
        }
    })
}

/// Judges one measured diameter.
///
/// Without a rule the limits alone decide, and belong to the zone, as on a control. rule: simple, iso14253-2017, iso14253-1998,
/// ilac-g8, asme-simple, asme-stringent, asme-relaxed or fixed. u_um is the standard uncertainty, expanded_um the expanded one
/// with its coverage factor k (2 unless given), guard_um the guard band of "fixed": micrometres. prover: who has to prove
/// (ISO 14253-1). Raises FitcheckError for what is not defined or is no number, and for an uncertainty without the rule that uses it.
#[pyfunction]
#[pyo3(signature = (
    callout, measured, *, feature = None, rule = None, u_um = None, expanded_um = None, k = None, factor = None,
    guard_um = None, prover = None
))]
#[expect(clippy::too_many_arguments, reason = "each has its name in Python")]
pub(crate) fn check(
    callout: &Bound<'_, PyAny>,
    measured: &Bound<'_, PyAny>,
    feature: Option<&str>,
    rule: Option<&str>,
    u_um: Option<&Bound<'_, PyAny>>,
    expanded_um: Option<&Bound<'_, PyAny>>,
    k: Option<&Bound<'_, PyAny>>,
    factor: Option<&Bound<'_, PyAny>>,
    guard_um: Option<&Bound<'_, PyAny>>,
    prover: Option<&str>,
) -> PyResult<Verdict> {
    let rule = Told { rule, u_um, expanded_um, k, factor, guard_um, prover }.rule()?;
    let asked = Asked::of(&chars(callout, "callout")?, feature)?;
    let measured = Measurement::of_diameter(diameter(measured, "measured")?, Origin::Typed);
    let (callout, limits) = (Some(asked.callout), asked.limits.clone());
    // The time is that of the question, where it is asked for.
    let record = Record::judged(DateTime::ZERO, String::new(), callout, limits, measured, None).by(rule);
    Ok(Verdict { record, asked })
}
