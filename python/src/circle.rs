//! Circles through contacts, by every criterion of ISO 14405-1.

use fitcheck_core::probing::Contact;
use fitcheck_core::probing::circle::{Circle as Found, Evaluation as All, evaluate};
use pyo3::prelude::*;

use crate::error::refused;

/// A circle in millimetres.
#[pyclass(frozen, module = "fitcheck", get_all)]
#[derive(Debug, Clone, Copy)]
pub(crate) struct Circle {
    x: f64,
    y: f64,
    diameter: f64,
}

impl From<Found> for Circle {
    fn from(Found { x, y, diameter }: Found) -> Self {
        Self { x, y, diameter }
    }
}

#[pymethods]
impl Circle {
    fn __repr__(&self) -> String {
        format!("Circle(x={}, y={}, diameter={})", self.x, self.y, self.diameter)
    }
}

/// The ring of least width that holds all contacts, in millimetres.
#[pyclass(frozen, module = "fitcheck", get_all)]
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ring {
    x: f64,
    y: f64,
    width: f64,
    outer_diameter: f64,
    inner_diameter: f64,
}

/// The distance of two opposite contacts.
#[pyclass(frozen, module = "fitcheck", get_all)]
#[derive(Debug, Clone, Copy)]
pub(crate) struct TwoPoint {
    contacts: (usize, usize),
    size: f64,
    direction_deg: f64,
}

/// Everything that contacts say about a circle, in millimetres.
#[pyclass(frozen, module = "fitcheck", get_all)]
#[derive(Debug)]
pub(crate) struct Evaluation {
    least_squares: Circle,
    form: f64,
    residuals: Vec<f64>,
    minimum_circumscribed: Circle,
    maximum_inscribed: Option<Circle>,
    minimum_zone: Option<Ring>,
    two_point: Vec<TwoPoint>,
    contacts: usize,
    arc_deg: f64,
    warnings: Vec<String>,
}

impl Evaluation {
    fn of(found: All, contacts: usize) -> Self {
        Self {
            least_squares: found.least_squares.into(),
            form: found.form(),
            minimum_circumscribed: found.minimum_circumscribed.into(),
            maximum_inscribed: found.maximum_inscribed.map(Circle::from),
            minimum_zone: found.minimum_zone.as_ref().map(|zone| Ring {
                x: zone.x,
                y: zone.y,
                width: zone.width,
                outer_diameter: zone.outer_diameter,
                inner_diameter: zone.inner_diameter,
            }),
            two_point: found
                .two_point
                .iter()
                .map(|pair| TwoPoint {
                    contacts: pair.contacts.into(),
                    size: pair.size,
                    direction_deg: pair.direction_deg,
                })
                .collect(),
            contacts,
            arc_deg: found.arc_deg,
            warnings: found.warnings.iter().map(ToString::to_string).collect(),
            residuals: found.residuals,
        }
    }
}

#[pymethods]
impl Evaluation {
    fn __repr__(&self) -> String {
        let Circle { x, y, diameter } = self.least_squares;
        format!("Evaluation(diameter={diameter}, x={x}, y={y}, form={}, contacts={})", self.form, self.contacts)
    }
}

/// A contact as a sequence of two or three numbers.
#[derive(Debug, Clone, Copy, FromPyObject)]
pub(crate) enum Point {
    Three(f64, f64, f64),
    Two(f64, f64),
}

/// The circle through contacts, millimetres: by least squares and by every other criterion of ISO 14405-1.
///
/// Raises FitcheckError for fewer than three contacts, contacts on a line, or numbers that are not finite.
#[pyfunction]
pub(crate) fn circle(py: Python<'_>, contacts: Vec<Point>) -> PyResult<Evaluation> {
    let contacts: Vec<Contact> = contacts
        .into_iter()
        .map(|point| match point {
            Point::Three(x, y, z) => Contact { x, y, z },
            Point::Two(x, y) => Contact { x, y, z: 0.0 },
        })
        .collect();
    let found = py.detach(|| evaluate(&contacts));
    found.map(|found| Evaluation::of(found, contacts.len())).map_err(|error| refused("contacts", &error))
}
