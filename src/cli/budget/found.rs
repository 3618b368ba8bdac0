//! A budget with its answer, and what has to be said of it.

use std::path::Path;

use jiff::civil::Date;
use serde_json::{Map, Value as Json, json};

use crate::budget::{
    Basis, Budget, CalibratedError, Conditions, Evaluation, EvaluationError, FEWEST_READINGS, Geometry, Repeated,
    Validity, uncertainty,
};
use crate::cli::io::read_input;
use crate::cli::said::{CliRemark, CliWarning};
use crate::cli::{CliError, Io, Refused as _};
use crate::control::text::decode;
use crate::length::Length;
use crate::message::{Message, Say};
use crate::verdict::rules::{Uncertainty, UncertaintyError};

/// A budget that was evaluated for a day.
#[derive(Debug)]
pub(in crate::cli) struct Found {
    pub(super) budget: Budget,
    pub(super) answer: Answer,
    pub(super) validity: Validity,
}

/// What a budget comes to.
#[derive(Debug)]
pub(super) enum Answer {
    /// From its contributions.
    Combined(Evaluation),
    /// From readings of a calibrated piece.
    Repeated(Repeated),
}

/// Why a budget comes to nothing.
#[derive(Debug, Say)]
#[say(prefix = "cli-budget")]
pub(in crate::cli) enum FoundError {
    /// Something is missing.
    #[say(transparent)]
    Evaluation(#[from] EvaluationError),
    /// The readings say nothing.
    #[say(transparent)]
    Calibrated(#[from] CalibratedError),
}

/// A budget's file, and the name to call it by.
pub(super) fn read(path: &Path, io: &mut Io<'_>) -> Result<(String, Budget), CliError> {
    let (name, bytes) = read_input(path, io)?;
    let budget = Budget::read(&decode(&bytes)).about(&name)?;
    Ok((name, budget))
}

impl Found {
    pub(super) fn of(
        budget: Budget,
        conditions: &Conditions,
        readings: Option<&[Length]>,
        day: Date,
    ) -> Result<Self, FoundError> {
        let answer = match &budget.basis {
            Basis::Contributions(contributions) => Answer::Combined(Evaluation::of(contributions, conditions)?),
            Basis::Calibrated(piece) => Answer::Repeated(piece.evaluate(readings)?),
        };
        Ok(Self { validity: budget.validity(day), budget, answer })
    }

    /// A file's budget for a measured value, and the uncertainty that a rule gets.
    pub(in crate::cli) fn read(
        path: &Path,
        conditions: &Conditions,
        io: &mut Io<'_>,
    ) -> Result<(Self, Uncertainty), CliError> {
        let (name, budget) = read(path, io)?;
        let found = Self::of(budget, conditions, None, crate::cli::now().date()).about(&name)?;
        let uncertainty = found.uncertainty().about(&name)?;
        Ok((found, uncertainty))
    }

    fn uncertainty(&self) -> Result<Uncertainty, UncertaintyError> {
        uncertainty(self.u(), self.k())
    }

    /// The standard uncertainty, µm.
    pub(super) fn u(&self) -> f64 {
        match &self.answer {
            Answer::Combined(evaluation) => evaluation.u,
            Answer::Repeated(repeated) => repeated.u(),
        }
    }

    /// The coverage factor.
    pub(super) const fn k(&self) -> f64 {
        match &self.answer {
            Answer::Combined(evaluation) => evaluation.k,
            Answer::Repeated(_) => Repeated::K,
        }
    }

    /// Effective degrees of freedom; `None` where they are infinite or the standard sets the coverage factor.
    pub(super) const fn degrees_of_freedom(&self) -> Option<f64> {
        match &self.answer {
            Answer::Combined(evaluation) => evaluation.degrees_of_freedom,
            Answer::Repeated(_) => None,
        }
    }

    /// By which document it was evaluated.
    pub(super) const fn method(&self) -> &'static str {
        match &self.answer {
            Answer::Combined(_) => "GUM",
            Answer::Repeated(repeated) if repeated.is_corrected => "ISO 15530-3:2011",
            Answer::Repeated(_) => "ISO/TS 15530-3:2004",
        }
    }

    /// What to check about it.
    pub(super) fn warnings(&self) -> Vec<Message> {
        let mut warnings = Vec::new();
        let Budget { date, valid_until, .. } = &self.budget;
        match self.validity {
            Validity::Valid => {}
            Validity::Expired => {
                warnings.push(CliWarning::BudgetExpired { until: valid_until.to_string() }.message());
            }
            Validity::NotYet => warnings.push(CliWarning::BudgetNotYet { date: date.to_string() }.message()),
        }
        if let Answer::Repeated(repeated) = &self.answer {
            if !repeated.is_enough() {
                let (readings, fewest) = (repeated.readings, FEWEST_READINGS);
                warnings.push(CliWarning::FewReadings { readings, fewest }.message());
            }
            let bias = format!("{:+.3}", repeated.bias);
            warnings.push(if repeated.is_corrected {
                CliWarning::BiasCorrected { bias }.message()
            } else {
                CliWarning::BiasNotCorrected { bias }.message()
            });
        }
        warnings
    }

    /// Says which budget gives the uncertainty of a check, for which contacts, and what to check about it.
    pub(in crate::cli) fn introduce(&self, io: &mut Io<'_>) {
        let Budget { name, date, valid_until, .. } = &self.budget;
        let (name, date, until) = (name.clone(), date.to_string(), valid_until.to_string());
        io.remark(&CliRemark::Budget { name, date, until });
        if let Some(Geometry { touches, step_deg, factor }) = self.geometry() {
            let step = step_deg.map(|step| format!(" × {}°", figure(step, 3))).unwrap_or_default();
            io.remark(&CliRemark::BudgetContacts { touches, step, factor: format!("{factor:.3}") });
        }
        self.tell(io);
    }

    /// Says what to check about it on standard error.
    pub(super) fn tell(&self, io: &mut Io<'_>) {
        for warning in self.warnings() {
            io.warn(&warning);
        }
    }

    /// Which budget it is and what it comes to, as programs read it.
    pub(in crate::cli) fn head(&self) -> Map<String, Json> {
        let Budget { name, date, by, valid_until, .. } = &self.budget;
        let warnings: Vec<String> = self.warnings().iter().map(ToString::to_string).collect();
        let head = [
            ("name", json!(name)),
            ("date", json!(date.to_string())),
            ("by", json!(by)),
            ("valid_until", json!(valid_until.to_string())),
            ("validity", json!(self.validity.word())),
            ("method", json!(self.method())),
            ("u_um", rounded(self.u(), 6)),
            ("degrees_of_freedom", self.degrees_of_freedom().map_or(Json::Null, |degrees| rounded(degrees, 2))),
            ("k", rounded(self.k(), 3)),
            ("expanded_um", rounded(self.u() * self.k(), 6)),
            ("warnings", json!(warnings)),
        ];
        let geometry = self.geometry();
        let contacts = [
            ("touches", json!(geometry.map(|geometry| geometry.touches))),
            ("step_deg", json!(geometry.and_then(|geometry| geometry.step_deg))),
            ("geometry_factor", json!(geometry.map(|geometry| rounded(geometry.factor, 6)))),
        ];
        let contacts = contacts.into_iter().filter(|_| geometry.is_some());
        head.into_iter().chain(contacts).map(|(name, value)| (name.to_owned(), value)).collect()
    }

    /// The contacts of its scatter; those of the first where several have their own.
    fn geometry(&self) -> Option<Geometry> {
        match &self.answer {
            Answer::Combined(evaluation) => evaluation.rows.iter().find_map(|row| row.geometry),
            Answer::Repeated(_) => None,
        }
    }
}

/// A number with so many decimals at most.
pub(super) fn rounded(number: f64, decimals: usize) -> Json {
    figure(number, decimals).parse::<f64>().map_or(Json::Null, |number| json!(number))
}

/// The same as text.
pub(super) fn figure(number: f64, decimals: usize) -> String {
    let text = format!("{number:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
