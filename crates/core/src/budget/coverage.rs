//! The coverage factor: by Student's law with the effective degrees of freedom (GUM, annex G).

use crate::law::{normal_quantile, student_quantile};

/// The probability that the expanded uncertainty covers the value: that of two standard deviations, 95.45 %.
pub const PROBABILITY: f64 = 0.954_499_736_103_642;

/// From here up Student's law is the normal one to the third decimal of the factor.
const MANY: f64 = 100_000.0;

/// The coverage factor for 95.45 %, to the thousandth; `None` degrees of freedom are infinitely many.
pub fn factor(degrees_of_freedom: Option<f64>) -> f64 {
    (student(degrees_of_freedom, PROBABILITY) * 1_000.0).round() / 1_000.0
}

/// How many standard uncertainties to either side cover a value with a probability between 0 and 1. Degrees of freedom need not
/// be whole: Student's law is taken as it is, not at the next lower whole number.
pub fn student(degrees_of_freedom: Option<f64>, probability: f64) -> f64 {
    let upper = f64::midpoint(1.0, probability);
    match degrees_of_freedom.filter(|degrees| *degrees < MANY) {
        // With none, or hardly any, nothing is covered.
        Some(degrees) => {
            Some(student_quantile(degrees, upper)).filter(|factor| !factor.is_nan()).unwrap_or(f64::INFINITY)
        }
        None => normal_quantile(upper),
    }
}
