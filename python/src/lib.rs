//! Fitcheck for Python: limits of size, verdicts, fits, circles, and verdicts for tables of any length.
//!
//! | file | what |
//! |---|---|
//! | `given` | a number as Python has it, as exact text; lengths as `Decimal` |
//! | `error` | what is refused, with the words of the command line |
//! | `limits`, `rule`, `check`, `fit`, `circle` | the functions of these names |
//! | `batch` | rows of anything that speaks Arrow |
//!
//! Everything that is computed lies in `fitcheck-core` and `fitcheck-exchange`. Python's types and docstrings stand in
//! `fitcheck/__init__.pyi`.

mod batch;
mod check;
mod circle;
mod error;
mod fit;
mod given;
mod limits;
mod rule;

/// The compiled part of the package.
#[pyo3::pymodule]
mod _fitcheck {
    #[pymodule_export]
    use super::batch::{Rows, batch};
    #[pymodule_export]
    use super::check::{Verdict, check};
    #[pymodule_export]
    use super::circle::{Circle, Evaluation, Ring, TwoPoint, circle};
    #[pymodule_export]
    use super::error::FitcheckError;
    #[pymodule_export]
    use super::fit::{Fit, fit};
    #[pymodule_export]
    use super::limits::{Limits, limits};
}
