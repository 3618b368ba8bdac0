//! From text and fields to the answer. Everything is read anew at every change: no answer stays beside a text, a field or
//! a day that it was not made with.

use fitcheck_core::budget::{Assessment, Basis, Budget, Conditions, ContributionKind, Geometry, GeometryError};
use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use jiff::civil::Date;

use super::{Asks, BudgetField, BudgetPage, Readings};
use crate::texts::{Range, whole};

/// The field that was refused, and why.
type Refusal = (BudgetField, Message);

impl BudgetPage {
    /// The clock has moved on; only another day changes the answer.
    pub(crate) fn see_day(&mut self, today: Date) {
        if self.today != today {
            self.today = today;
            self.answer_anew();
        }
    }

    pub(super) fn read_anew(&mut self) {
        let text = &self.document.text;
        self.read = (!text.trim().is_empty()).then(|| Budget::read(text));
        self.read_rows();
        match &self.read {
            Some(Ok(budget)) => self.asks = asks(budget),
            Some(Err(_)) => {}
            None => self.asks = Asks::default(),
        }
        self.answer_anew();
    }

    /// Something that the answer depends on is another.
    pub(super) fn answer_anew(&mut self) {
        self.errors.clear();
        let conditions = self.conditions();
        let day = self.day();
        let conditions = self.taken(conditions);
        let day = self.taken(day);
        self.refuse_row();
        let Some(Ok(budget)) = &self.read else {
            self.answer = None;
            return;
        };
        self.readings = match (&budget.basis, &self.source) {
            (Basis::Calibrated(piece), Some(source)) => Some(Readings::of(source, piece.feature)),
            _ => None,
        };
        self.answer = conditions.zip(day).map(|(conditions, day)| {
            let readings = self.readings.as_ref().map(|readings| readings.measured.as_slice());
            let found = Assessment::of(budget.clone(), &conditions, readings, day);
            found.map_err(|error| error.message())
        });
    }

    /// A value of fields; a refusal stands beside its field.
    fn taken<T>(&mut self, value: Result<T, Refusal>) -> Option<T> {
        value.map_err(|(field, problem)| self.errors.insert(field, problem)).ok()
    }

    /// What stands in a field that the budget asks for; nothing else refuses an answer.
    fn given(&self, field: BudgetField, is_asked: bool) -> &str {
        if is_asked { self.texts.text(field).trim() } else { "" }
    }

    fn conditions(&self) -> Result<Conditions, Refusal> {
        let size = match self.given(BudgetField::Size, self.asks.size) {
            "" => None,
            text => Some(Range::AboveZero.read(text).map_err(|problem| (BudgetField::Size, problem))?),
        };
        let geometry = match &self.contacts {
            Some(taken) => Some(taken.geometry),
            None => self.steps()?,
        };
        Ok(Conditions { size, geometry, ..Conditions::default() })
    }

    /// The contacts of the fields; none where both are empty.
    fn steps(&self) -> Result<Option<Geometry>, Refusal> {
        let touches = BudgetField::Touches;
        let step = BudgetField::Step;
        let missing = |field| Err((field, message!("budget-page-other-missing")));
        match (self.given(touches, self.asks.contacts), self.given(step, self.asks.contacts)) {
            ("", "") => Ok(None),
            ("", _) => missing(touches),
            (_, "") => missing(step),
            (count, angle) => {
                let count = whole(count).map_err(|problem| (touches, problem))?;
                // A step has the digits of a length: a millionth of a degree.
                let angle: Length =
                    angle.parse().map_err(|error: fitcheck_core::length::LengthError| (step, error.message()))?;
                Geometry::steps(count, angle.to_mm_f64()).map(Some).map_err(|error| match error {
                    GeometryError::Step { .. } => (step, error.message()),
                    _ => (touches, error.message()),
                })
            }
        }
    }

    fn day(&self) -> Result<Date, Refusal> {
        let given = self.texts.text(BudgetField::Day).trim();
        if given.is_empty() {
            return Ok(self.today);
        }
        // Longer texts have a time, which would be passed over.
        let day = (given.len() == "2026-01-15".len()).then(|| given.parse().ok()).flatten();
        day.ok_or_else(|| (BudgetField::Day, message!("budget-page-no-day").text("given", given)))
    }
}

fn asks(budget: &Budget) -> Asks {
    match &budget.basis {
        Basis::Calibrated(_) => Asks { readings: true, ..Asks::default() },
        Basis::Contributions(contributions) => Asks {
            size: contributions.iter().any(|one| one.kind.grows_with_size()),
            contacts: contributions.iter().any(|one| matches!(one.kind, ContributionKind::Scatter(_))),
            readings: false,
        },
    }
}
