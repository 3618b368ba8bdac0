//! What is refused, with the words of the command line.

use fitcheck_core::message::Say;
use pyo3::exceptions::PyValueError;
use pyo3::types::PyAnyMethods as _;
use pyo3::{PyErr, Python, create_exception};

create_exception!(
    fitcheck,
    FitcheckError,
    PyValueError,
    "What was given cannot be answered; str() says why, `code` which text it is."
);

/// An exception that says in English what is wrong, with what was given before it.
pub(crate) fn refused(about: &str, error: &impl Say) -> PyErr {
    let message = error.message();
    let text = if about.is_empty() { message.to_string() } else { format!("{about}: {message}") };
    with_code(text, message.id)
}

/// The same with words of this package alone.
pub(crate) fn with_code(text: String, code: &'static str) -> PyErr {
    Python::attach(|py| {
        let error = FitcheckError::new_err(text);
        match error.value(py).setattr("code", code) {
            Ok(()) => error,
            Err(other) => other,
        }
    })
}
