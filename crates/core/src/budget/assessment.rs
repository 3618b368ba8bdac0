//! A budget that was evaluated for a day, and what has to be said of it.

use jiff::civil::Date;

use super::doubts::doubts;
use super::warning::BudgetWarning;
use super::{
    Basis, Budget, CalibratedError, Conditions, Evaluation, EvaluationError, FEWEST_READINGS, Geometry, GeometryError,
    Repeated, Validity, uncertainty,
};
use crate::length::Length;
use crate::message::Say;
use crate::verdict::rules::{Uncertainty, UncertaintyError};

/// A budget that was evaluated for a size, contacts and a day.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessment {
    /// The budget.
    pub budget: Budget,
    /// What it comes to.
    pub answer: Answer,
    /// Whether it counts on that day.
    pub validity: Validity,
    /// Whether it is about what was measured.
    doubts: Vec<BudgetWarning>,
}

/// What a budget comes to.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer {
    /// From its contributions.
    Combined(Evaluation),
    /// From readings of a calibrated piece.
    Repeated(Repeated),
}

/// Why a budget comes to nothing.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "budget", error)]
pub enum AssessmentError {
    /// Something is missing.
    #[say(transparent)]
    Evaluation(#[from] EvaluationError),
    /// The readings say nothing.
    #[say(transparent)]
    Calibrated(#[from] CalibratedError),
    /// The contacts make no circle.
    #[say(transparent)]
    Geometry(#[from] GeometryError),
    /// A rule has no place for the result.
    #[say(transparent)]
    Uncertainty(#[from] UncertaintyError),
}

/// Where an uncertainty comes from: what is kept of a budget beside the verdict that was made with it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Provenance {
    /// Which station and probe.
    pub name: String,
    /// When the budget was made.
    pub date: Date,
    /// Who made it.
    pub by: String,
    /// The last day on which it counts.
    pub valid_until: Date,
    /// Whether it has a scatter of touches, which counts for the contacts that were taken.
    pub counts_contacts: bool,
    /// Whether it counted on the day of the check.
    pub validity: Validity,
    /// What to check about it, on that day.
    pub warnings: Vec<BudgetWarning>,
}

impl Assessment {
    /// Evaluates a budget; `readings` of a calibrated piece take the place of its own.
    ///
    /// # Errors
    /// [`AssessmentError`] where a size or contacts are missing, or the readings say nothing.
    pub fn of(
        budget: Budget,
        conditions: &Conditions,
        readings: Option<&[Length]>,
        day: Date,
    ) -> Result<Self, AssessmentError> {
        let answer = match &budget.basis {
            Basis::Contributions(contributions) => Answer::Combined(Evaluation::of(contributions, conditions)?),
            Basis::Calibrated(piece) => Answer::Repeated(piece.evaluate(readings)?),
        };
        Ok(Self { validity: budget.validity(day), doubts: doubts(&budget, conditions), budget, answer })
    }

    /// What a rule gets.
    ///
    /// # Errors
    /// [`UncertaintyError`] where a rule has no place for it.
    pub fn uncertainty(&self) -> Result<Uncertainty, UncertaintyError> {
        uncertainty(self.u(), self.k())
    }

    /// The standard uncertainty, µm.
    pub fn u(&self) -> f64 {
        match &self.answer {
            Answer::Combined(evaluation) => evaluation.u,
            Answer::Repeated(repeated) => repeated.u(),
        }
    }

    /// The coverage factor.
    pub const fn k(&self) -> f64 {
        match &self.answer {
            Answer::Combined(evaluation) => evaluation.k,
            Answer::Repeated(_) => Repeated::K,
        }
    }

    /// The expanded uncertainty, µm.
    pub fn expanded(&self) -> f64 {
        self.u() * self.k()
    }

    /// Effective degrees of freedom; `None` where they are infinite or the standard sets the coverage factor.
    pub const fn degrees_of_freedom(&self) -> Option<f64> {
        match &self.answer {
            Answer::Combined(evaluation) => evaluation.degrees_of_freedom,
            Answer::Repeated(_) => None,
        }
    }

    /// By which document it was evaluated.
    pub const fn method(&self) -> &'static str {
        match &self.answer {
            Answer::Combined(_) => "GUM",
            Answer::Repeated(repeated) if repeated.is_corrected => "ISO 15530-3:2011",
            Answer::Repeated(_) => "ISO/TS 15530-3:2004",
        }
    }

    /// The contacts of its scatter; those of the first where several have their own.
    pub fn geometry(&self) -> Option<Geometry> {
        match &self.answer {
            Answer::Combined(evaluation) => evaluation.rows.iter().find_map(|row| row.geometry),
            Answer::Repeated(_) => None,
        }
    }

    /// What to check about it.
    pub fn warnings(&self) -> Vec<BudgetWarning> {
        let mut warnings = Vec::new();
        let Budget { date, valid_until, .. } = &self.budget;
        match self.validity {
            Validity::Valid => {}
            Validity::Expired => warnings.push(BudgetWarning::Expired { until: valid_until.to_string() }),
            Validity::NotYet => warnings.push(BudgetWarning::NotYet { date: date.to_string() }),
        }
        if let Some(why) = &self.budget.failed_study {
            warnings.push(BudgetWarning::FailedStudy { why: why.clone() });
        }
        if !self.budget.placeholders().is_empty() {
            warnings.push(BudgetWarning::OfTemplate);
        }
        if let Answer::Repeated(repeated) = &self.answer {
            if !repeated.is_enough() {
                let readings = repeated.readings;
                warnings.push(BudgetWarning::FewReadings { readings, fewest: FEWEST_READINGS });
            }
            let bias = format!("{:+.3}", repeated.bias);
            warnings.push(if repeated.is_corrected {
                BudgetWarning::BiasCorrected { bias }
            } else {
                BudgetWarning::BiasNotCorrected { bias }
            });
        }
        warnings.extend(self.doubts.iter().cloned());
        warnings
    }

    /// What is kept of it beside a verdict.
    pub fn provenance(&self) -> Provenance {
        let Budget { name, date, by, valid_until, .. } = &self.budget;
        Provenance {
            name: name.clone(),
            date: *date,
            by: by.clone(),
            valid_until: *valid_until,
            counts_contacts: self.geometry().is_some(),
            validity: self.validity,
            warnings: self.warnings(),
        }
    }
}
