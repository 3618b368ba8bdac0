//! Figures of values of one feature in a row: control chart, capability, trend and advice.

use fitcheck_core::length::Length;
use fitcheck_core::probing::{Measurement, Origin};
use fitcheck_exchange::exchange::Labels;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::series::{Answer, Figure as Found, Grouping, LeftOut, Series, SeriesError, Value, Wanted};
use jiff::civil::DateTime;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::{refused, with_code};
use crate::given::{diameter, length};
use crate::limits::Asked;

/// A figure with its interval, or why there is none.
#[pyclass(frozen, module = "fitcheck", get_all)]
#[derive(Debug, Clone)]
pub(crate) struct Figure {
    value: Option<f64>,
    lower: Option<f64>,
    upper: Option<f64>,
    method: String,
    reason: Option<String>,
}

impl Figure {
    fn of(found: &Found) -> Self {
        let method = found.method.to_string();
        let (value, interval, reason) = match &found.value {
            Ok((value, interval)) => (Some(*value), *interval, None),
            Err(reason) => (None, None, Some(reason.to_string())),
        };
        let [lower, upper] = interval.map_or([None, None], |[lower, upper]| [Some(lower), Some(upper)]);
        Self { value, lower, upper, method, reason }
    }
}

#[pymethods]
impl Figure {
    /// The value, so that it can be rounded and printed as a number.
    fn __float__(&self) -> PyResult<f64> {
        self.value.ok_or_else(|| {
            let why = self.reason.as_deref().unwrap_or("");
            with_code(format!("the figure has no value: {why}"), "python-no-figure")
        })
    }

    fn __repr__(&self) -> String {
        match (self.value, self.lower, self.upper) {
            (Some(value), Some(lower), Some(upper)) => format!("Figure({value}, {lower} to {upper})"),
            (Some(value), ..) => format!("Figure({value})"),
            _ => format!("Figure(none: {})", self.reason.as_deref().unwrap_or("")),
        }
    }
}

/// What values in a row say.
#[pyclass(frozen, module = "fitcheck")]
#[derive(Debug)]
pub(crate) struct Statistics {
    count: usize,
    left_out: Vec<(&'static str, usize)>,
    answer: Answer,
}

#[pymethods]
impl Statistics {
    #[getter]
    const fn count(&self) -> usize {
        self.count
    }

    /// The level of the intervals.
    #[getter]
    const fn level(&self) -> f64 {
        self.answer.wanted.level
    }

    /// How many values count for nothing, by the reason.
    #[getter]
    fn left_out<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (why, count) in &self.left_out {
            dict.set_item(why, count)?;
        }
        Ok(dict)
    }

    /// How many values are below the lower and above the upper limit.
    #[getter]
    fn outside(&self) -> (usize, usize) {
        self.answer.outside.into()
    }

    /// Every figure by its name, as `fitcheck stats --format json` has it.
    #[getter]
    fn figures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for figure in &self.answer.figures {
            dict.set_item(figure.name, Figure::of(figure))?;
        }
        Ok(dict)
    }

    /// The rules of control charts that fire, each with its points from 1.
    #[getter]
    fn rules<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (rule, points) in &self.answer.fired {
            dict.set_item(rule.word(), points)?;
        }
        Ok(dict)
    }

    #[getter]
    fn advice(&self) -> Vec<String> {
        self.answer.sentences().collect()
    }

    fn __repr__(&self) -> String {
        format!("Statistics({} values, {} figures)", self.count, self.answer.figures.len())
    }
}

/// What the limits of the values are.
enum Limits {
    Callout(Asked),
    Stated([Option<Length>; 2]),
}

impl Limits {
    fn value(&self, given: &Bound<'_, PyAny>, at: usize) -> PyResult<Value> {
        let what = format!("values[{at}]");
        let asked = match self {
            Self::Stated(limits) => {
                let (name, origin) = (String::new(), fitcheck_exchange::series::Origin::default());
                let measured = length(given, &what)?;
                return Ok(Value { name, measured, nominal: None, limits: *limits, origin, left_out: None });
            }
            Self::Callout(asked) => asked,
        };
        let measured = diameter(given, &what)?;
        let (callout, limits) = (Some(asked.callout), asked.limits.clone());
        let measured = Measurement::of_diameter(measured, Origin::Typed);
        let record = Record::judged(DateTime::ZERO, String::new(), callout, limits, measured, None);
        Ok(Value::of_record(&record, &Labels::default(), record.doubt.is_some()))
    }
}

/// Control chart, capability, trend and advice for measured values in their order, as `fitcheck stats` computes them.
///
/// Limits come from a callout, or are given in millimetres. group: how many values in a row are a subgroup. level: of the intervals,
/// from 0.5 to below 1. What cannot be computed of too few values has its reason in the figure.
#[pyfunction]
#[pyo3(signature = (values, *, callout = None, lower = None, upper = None, target = None, group = 1, level = 0.95))]
#[expect(clippy::too_many_arguments, reason = "each has its name in Python")]
#[expect(clippy::needless_pass_by_value, reason = "a sequence of Python becomes a list of its own")]
pub(crate) fn statistics(
    py: Python<'_>,
    values: Vec<Bound<'_, PyAny>>,
    callout: Option<&str>,
    lower: Option<&Bound<'_, PyAny>>,
    upper: Option<&Bound<'_, PyAny>>,
    target: Option<&Bound<'_, PyAny>>,
    group: usize,
    level: f64,
) -> PyResult<Statistics> {
    let limits = match callout {
        Some(_) if lower.is_some() || upper.is_some() => {
            let text = "callout states the limits: give it or lower and upper".to_owned();
            return Err(with_code(text, "python-two-limits"));
        }
        Some(callout) => Limits::Callout(Asked::of(callout, None)?),
        None => {
            let lower = lower.map(|lower| length(lower, "lower")).transpose()?;
            Limits::Stated([lower, upper.map(|upper| length(upper, "upper")).transpose()?])
        }
    };
    if !(0.5..1.0).contains(&level) {
        return Err(with_code(format!("level: {level} is not from 0.5 up to 1"), "python-no-level"));
    }
    let values: Vec<Value> =
        values.iter().enumerate().map(|(at, given)| limits.value(given, at)).collect::<PyResult<_>>()?;
    let grouping = match group {
        0 => return Err(with_code("group: a group has at least one value".to_owned(), "python-no-group")),
        1 => Grouping::Single,
        size => Grouping::Of(size),
    };
    let target = target.map(|target| length(target, "target").map(Length::to_mm_f64)).transpose()?;
    let found = py.detach(|| {
        let series = Series::of(&values, None, grouping)?;
        let wanted = Wanted { limits: series.limits()?, target, level, ..Wanted::default() };
        wanted.checked(&series)?;
        let left_out = series.left_out().map(|(why, count): (LeftOut, usize)| (why.word(), count)).collect();
        Ok(Statistics { count: series.count(), left_out, answer: Answer::of(&series, &wanted) })
    });
    found.map_err(|error| match error {
        SeriesError::Reason(why) => refused("values", &why),
        // Values without names are of one feature and have the limits that were given; nobody can ask for one point.
        SeriesError::Features(_) | SeriesError::NoFeature(_) | SeriesError::Limits | SeriesError::NoPoint { .. } => {
            with_code("values: they are not one series".to_owned(), "python-no-series")
        }
    })
}
