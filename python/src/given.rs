//! A number as Python has it, as exact text; lengths as `Decimal`.

use std::borrow::Cow;

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::Message;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyBool, PyFloat, PyInt, PyString, PyType};

use crate::error::{refused, with_code};

static DECIMAL: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// `decimal.Decimal`.
fn decimal_type(py: Python<'_>) -> PyResult<&Bound<'_, PyType>> {
    DECIMAL.import(py, "decimal", "Decimal")
}

/// A decimal number of Python with these figures.
pub(crate) fn decimal<'py>(py: Python<'py>, text: &str) -> PyResult<Bound<'py, PyAny>> {
    decimal_type(py)?.call1((text,))
}

/// A length in millimetres, with all its figures and none that it lacks.
pub(crate) fn mm(py: Python<'_>, length: Length) -> PyResult<Bound<'_, PyAny>> {
    decimal(py, &length.exact(Unit::Millimetre, 0))
}

/// A length in micrometres.
pub(crate) fn um(py: Python<'_>, length: Length) -> PyResult<Bound<'_, PyAny>> {
    decimal(py, &length.exact(Unit::Micrometre, 0))
}

/// The characters of a `str`.
///
/// # Errors
/// Another type, or half a character, which no text has.
pub(crate) fn chars<'a>(value: &'a Bound<'_, PyAny>, what: &str) -> PyResult<Cow<'a, str>> {
    let Ok(text) = value.cast::<PyString>() else {
        let kind = value.get_type().name()?;
        return Err(with_code(format!("{what}: expected a str, not {kind}"), "python-no-text"));
    };
    text.to_cow().map_err(|_surrogate| with_code(format!("{what}: no text: it has half a character"), "python-no-text"))
}

/// The text of a number: of a `str` itself, of a `Decimal` or an `int` its figures, of a `float` the shortest decimal that stands for it.
///
/// # Errors
/// What is no number, or none that a length can be.
pub(crate) fn text<'a>(value: &'a Bound<'_, PyAny>, what: &str) -> PyResult<Cow<'a, str>> {
    if value.is_instance_of::<PyString>() {
        return chars(value, what);
    }
    let given = || value.repr().map_or_else(|_| value.get_type().to_string(), |repr| repr.to_string());
    if value.is_instance_of::<PyBool>() {
        return Err(with_code(format!("{what}: {} is no number", given()), "python-no-number"));
    }
    if let Ok(number) = value.cast::<PyFloat>() {
        let number = number.value();
        if number.is_finite() {
            return Ok(number.to_string().into());
        }
        return Err(with_code(format!("{what}: {} is no number that can be measured", given()), "python-not-finite"));
    }
    if value.is_instance_of::<PyInt>() || is_short_float(value) {
        return Ok(value.str()?.to_cow()?.into_owned().into());
    }
    if value.is_instance(decimal_type(value.py())?)? {
        if !value.call_method0("is_finite")?.is_truthy()? {
            return Err(with_code(
                format!("{what}: {} is no number that can be measured", given()),
                "python-not-finite",
            ));
        }
        return Ok(value.call_method1("__format__", ("f",))?.extract::<String>()?.into());
    }
    if let Ok(whole) = value.call_method0("__index__") {
        return Ok(whole.str()?.to_cow()?.into_owned().into());
    }
    let kind = value.get_type().name()?;
    let allowed = "give a str, a Decimal, an int or a float";
    Err(with_code(format!("{what}: {} of type {kind} is no number; {allowed}", given()), "python-no-number"))
}

/// Whether it is a binary fraction of numpy with fewer bits than Python's own: what it prints is the shortest decimal that stands for it.
fn is_short_float(value: &Bound<'_, PyAny>) -> bool {
    value.get_type().name().is_ok_and(|name| name == "float32" || name == "float16")
}

/// A length in millimetres, unless a text states another unit.
pub(crate) fn length(value: &Bound<'_, PyAny>, what: &str) -> PyResult<Length> {
    text(value, what)?.parse().map_err(|error| refused(what, &error))
}

/// A diameter in millimetres, above zero.
pub(crate) fn diameter(value: &Bound<'_, PyAny>, what: &str) -> PyResult<Length> {
    let diameter = length(value, what)?;
    if Length::ZERO < diameter {
        return Ok(diameter);
    }
    Err(refused(what, &Message::new("cli-not-above-zero").with("diameter", &diameter)))
}
