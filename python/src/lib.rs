//! Fitcheck for Python: limits of size, verdicts, fits, circles, and verdicts for tables of any length.
//!
//! | file | what |
//! |---|---|
//! | `given` | a number as Python has it, as exact text; lengths as `Decimal` |
//! | `error` | what is refused, with the words of the command line |
//! | `limits`, `check`, `fit`, `pair`, `circle`, `budget`, `statistics` | the functions of these names |
//! | `rule` | decision rules with what they need |
//! | `batch` | rows of anything that speaks Arrow |
//!
//! Everything that is computed lies in `fitcheck-core` and `fitcheck-exchange`. Python's types and docstrings stand in
//! `fitcheck/__init__.pyi`.

mod batch;
mod budget;
mod check;
mod circle;
mod error;
mod fit;
mod given;
mod limits;
mod pair;
mod rule;
mod statistics;

/// The compiled part of the package.
#[pyo3::pymodule]
mod _fitcheck {
    #[pymodule_export]
    use super::batch::{Rows, batch};
    #[pymodule_export]
    use super::budget::{Budget, budget};
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
    #[pymodule_export]
    use super::pair::{Pairing, pair};
    #[pymodule_export]
    use super::statistics::{Figure, Statistics, statistics};
}
