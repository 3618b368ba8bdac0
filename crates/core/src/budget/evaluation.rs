//! A budget evaluated as in the GUM: u² is the sum of (c·u)², its degrees of freedom are those of Welch and Satterthwaite.

use super::{Contribution, ContributionKind, Evaluated, Geometry, Law, factor};
use crate::length::Length;
use crate::message::Say;
use crate::tolerance::Feature;
use crate::tolerance::fit::thermal::Correction;

/// What a budget is evaluated for.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Conditions {
    /// The measured size, for contributions of temperature.
    pub size: Option<Length>,
    /// The contacts that were taken, instead of those that the budget has.
    pub geometry: Option<Geometry>,
    /// Hole or shaft, where it is known: a calibrated piece is one of them.
    pub feature: Option<Feature>,
    /// How the measured value was brought to 20 °C, where it was.
    pub correction: Option<Correction>,
}

/// A row of the table of contributions.
#[derive(Debug, Clone, PartialEq)]
pub struct ContributionRow {
    /// What it comes from.
    pub name: String,
    /// How it was evaluated.
    pub evaluated: Evaluated,
    /// The law of its values.
    pub law: Law,
    /// What it does to the diameter.
    pub kind: ContributionKind,
    /// The unit of its standard uncertainty: `µm`, `K`, or `µm/(m K)` for an expansion.
    pub unit: &'static str,
    /// Its standard uncertainty.
    pub u: f64,
    /// By what that is multiplied, with everything that its kind brings; micrometres per unit.
    pub sensitivity: f64,
    /// The uncertainty of the diameter that comes of it, µm.
    pub contribution: f64,
    /// Its part of the variance, per cent.
    pub share: f64,
    /// Its degrees of freedom; `None` where they are infinite.
    pub degrees_of_freedom: Option<f64>,
    /// The contacts, for scatter.
    pub geometry: Option<Geometry>,
}

/// What would make the uncertainty smaller, with the combined uncertainty that it would give, µm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Help {
    /// The largest contribution, halved.
    Halved {
        /// The combined uncertainty then.
        u: f64,
    },
    /// As many touches, evenly round the full circle.
    FullCircle {
        /// How many.
        touches: usize,
        /// The combined uncertainty then.
        u: f64,
    },
    /// Twice as many touches, evenly round the full circle.
    MoreTouches {
        /// How many.
        touches: usize,
        /// The combined uncertainty then.
        u: f64,
    },
}

/// A budget for a size and contacts.
#[derive(Debug, Clone, PartialEq)]
pub struct Evaluation {
    /// The contributions, in the order of the budget.
    pub rows: Vec<ContributionRow>,
    /// The combined standard uncertainty, µm.
    pub u: f64,
    /// Effective degrees of freedom; `None` where they are infinite.
    pub degrees_of_freedom: Option<f64>,
    /// The coverage factor for 95.45 %.
    pub k: f64,
    /// Which row has the largest share; the first of several.
    pub largest: usize,
    /// What would make the uncertainty smaller.
    pub help: Vec<Help>,
}

/// Why a budget cannot be evaluated.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "budget-evaluation", error)]
pub enum EvaluationError {
    /// A contribution of temperature, and no size.
    NoSize {
        /// Its name.
        contribution: String,
    },
    /// Scatter, and no contacts.
    NoContacts {
        /// Its name.
        contribution: String,
    },
    /// Everything is zero.
    Nothing,
}

impl Evaluation {
    /// The expanded uncertainty, µm.
    pub fn expanded(&self) -> f64 {
        self.k * self.u
    }

    /// Evaluates contributions.
    ///
    /// # Errors
    /// [`EvaluationError`] where a size or contacts are missing, or nothing is uncertain.
    pub fn of(contributions: &[Contribution], conditions: &Conditions) -> Result<Self, EvaluationError> {
        let rows = contributions.iter().map(|contribution| row(contribution, conditions));
        let mut rows = rows.collect::<Result<Vec<ContributionRow>, _>>()?;
        // Hypotenuses do not lose small numbers.
        let u = rows.iter().fold(0.0, |u: f64, row| libm::hypot(u, row.contribution));
        if u <= 0.0 {
            return Err(EvaluationError::Nothing);
        }
        for row in &mut rows {
            row.share = (row.contribution / u).powi(2) * 100.0;
        }
        let inverse: f64 =
            rows.iter().filter_map(|row| Some((row.contribution / u).powi(4) / row.degrees_of_freedom?)).sum();
        let degrees_of_freedom = (0.0 < inverse).then(|| 1.0 / inverse);
        let k = factor(degrees_of_freedom);
        let largest = largest(&rows);
        let help = help(rows.get(largest).ok_or(EvaluationError::Nothing)?, &rows, largest);
        Ok(Self { rows, u, degrees_of_freedom, k, largest, help })
    }
}

fn row(contribution: &Contribution, conditions: &Conditions) -> Result<ContributionRow, EvaluationError> {
    let Contribution { name, evaluated, law, kind, u, sensitivity, degrees_of_freedom } = contribution;
    let named = || name.clone();
    // Millimetres per kelvin as micrometres.
    let um = |per_kelvin: f64| {
        let size = conditions.size.ok_or_else(|| EvaluationError::NoSize { contribution: named() })?;
        Ok(size.to_mm_f64() * per_kelvin * 1_000.0)
    };
    let (by_kind, unit, geometry) = match *kind {
        ContributionKind::Plain | ContributionKind::Resolution => (1.0, "µm", None),
        ContributionKind::Scatter(own) => {
            let geometry = conditions.geometry.or(own);
            let geometry = geometry.ok_or_else(|| EvaluationError::NoContacts { contribution: named() })?;
            (geometry.factor, "µm", Some(geometry))
        }
        ContributionKind::PartTemperature(alpha) | ContributionKind::ScaleTemperature(alpha) => (um(alpha)?, "K", None),
        // The expansion is in millionths.
        ContributionKind::PartExpansion(delta) | ContributionKind::ScaleExpansion(delta) => {
            (um(delta * 1e-6)?, "µm/(m K)", None)
        }
    };
    let sensitivity = sensitivity * by_kind;
    Ok(ContributionRow {
        name: named(),
        evaluated: *evaluated,
        law: *law,
        kind: *kind,
        unit,
        u: *u,
        sensitivity,
        contribution: (sensitivity * u).abs(),
        share: 0.0,
        degrees_of_freedom: *degrees_of_freedom,
        geometry,
    })
}

fn largest(rows: &[ContributionRow]) -> usize {
    let mut largest = (0, 0.0);
    for (number, row) in rows.iter().enumerate() {
        if largest.1 < row.contribution {
            largest = (number, row.contribution);
        }
    }
    largest.0
}

fn help(row: &ContributionRow, rows: &[ContributionRow], number: usize) -> Vec<Help> {
    let others = rows.iter().enumerate().filter(|(other, _)| *other != number);
    let others = others.fold(0.0, |u: f64, (_, row)| libm::hypot(u, row.contribution));
    let mut help = vec![Help::Halved { u: libm::hypot(others, row.contribution / 2.0) }];
    if let Some(Geometry { touches, factor, .. }) = row.geometry {
        let with = |touches| libm::hypot(others, row.contribution / factor * Geometry::even_factor(touches));
        // Evenly spaced contacts are on a full circle; a thousandth is rounding.
        if Geometry::even_factor(touches) * 1.001 < factor {
            help.push(Help::FullCircle { touches, u: with(touches) });
        }
        help.push(Help::MoreTouches { touches: 2 * touches, u: with(2 * touches) });
    }
    help
}
