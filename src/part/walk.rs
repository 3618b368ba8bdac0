//! The walk through a part: which feature is next, what was measured, what was left out and why, and what that makes of the part.

use super::plan::Plan;
use crate::message::Say;
use crate::verdict::Status;

/// A value of a size.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Taken {
    /// Its verdict.
    pub status: Status,
    /// Whether nobody measured it.
    pub is_simulated: bool,
}

/// One size of a part: its values in the order in which they came, or why it was left out.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Step {
    /// Its values, all of which are kept: [`Self::counts`] says which one counts.
    pub taken: Vec<Taken>,
    /// Why it was left out; a value that comes later counts.
    pub skipped: Option<String>,
}

impl Step {
    /// The place of the value that counts: the last one that somebody measured, and the last simulated one where nobody did.
    pub fn counting(&self) -> Option<usize> {
        let measured = self.taken.iter().rposition(|taken| !taken.is_simulated);
        measured.or_else(|| self.taken.len().checked_sub(1))
    }

    /// The value that counts.
    pub fn counts(&self) -> Option<Taken> {
        self.taken.get(self.counting()?).copied()
    }

    /// Whether there is neither a value nor a reason.
    pub fn is_open(&self) -> bool {
        self.taken.is_empty() && self.skipped.is_none()
    }
}

/// One part on its way through a plan.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Walk {
    /// Its serial number; empty where it has none.
    pub serial: String,
    steps: Vec<Step>,
}

/// What the values of a part make of it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Say)]
#[say(id = "part-standing")]
pub struct Standing {
    /// The worst of its sizes; `None` where nothing was measured.
    #[say(skip)]
    pub worst: Option<Status>,
    /// How many sizes have a value.
    pub measured: usize,
    /// How many have neither a value nor a reason.
    pub missing: usize,
    /// How many were left out with a reason.
    pub skipped: usize,
    /// How many of the values that count were simulated.
    #[say(skip)]
    pub simulated: usize,
}

impl Standing {
    /// Whether every size was measured, by somebody: without this nothing is green.
    pub const fn is_complete(&self) -> bool {
        !self.is_open() && self.simulated == 0
    }

    /// Whether a size has no value.
    pub const fn is_open(&self) -> bool {
        0 < self.missing || 0 < self.skipped
    }

    /// The status of the part as far as it is decided: scrap stays scrap, whatever is missing; good is said of a complete part alone.
    pub fn status(&self) -> Option<Status> {
        self.worst.filter(|worst| *worst != Status::Good || !self.is_open())
    }

    /// The status as a card or a report may say it: nothing is good while something is missing, left out or simulated.
    pub fn said(&self) -> Option<Status> {
        self.status().filter(|status| *status != Status::Good || self.is_complete())
    }
}

impl Walk {
    /// A part of which nothing is measured yet.
    pub fn new(plan: &Plan, serial: String) -> Self {
        Self { serial, steps: plan.sizes().map(|_| Step::default()).collect() }
    }

    /// Its sizes, as [`Plan::sizes`] has them.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Takes a value of a size.
    pub fn take(&mut self, at: usize, taken: Taken) {
        if let Some(step) = self.steps.get_mut(at) {
            step.taken.push(taken);
        }
    }

    /// Leaves a size out. An empty reason is none, and nothing happens; whether it was left out.
    pub fn skip(&mut self, at: usize, reason: &str) -> bool {
        let reason = reason.trim();
        match self.steps.get_mut(at) {
            Some(step) if !reason.is_empty() => {
                step.skipped = Some(reason.to_owned());
                true
            }
            _ => false,
        }
    }

    /// The size that is asked for next: the first one that is open, from a place on and then from the beginning.
    pub fn next(&self, from: usize) -> Option<usize> {
        let open =
            |range: std::ops::Range<usize>| range.into_iter().find(|at| self.steps.get(*at).is_some_and(Step::is_open));
        open(from..self.steps.len()).or_else(|| open(0..from.min(self.steps.len())))
    }

    /// The sizes without a value.
    pub fn missing(&self) -> impl Iterator<Item = usize> {
        (0..).zip(&self.steps).filter(|(_, step)| step.taken.is_empty()).map(|(at, _)| at)
    }

    /// What its values make of it.
    pub fn standing(&self) -> Standing {
        let mut standing = Standing::default();
        for step in &self.steps {
            match (step.counts(), &step.skipped) {
                (Some(taken), _) => {
                    standing.measured += 1;
                    standing.simulated += usize::from(taken.is_simulated);
                    standing.worst = standing.worst.max(Some(taken.status));
                }
                (None, Some(_)) => standing.skipped += 1,
                (None, None) => standing.missing += 1,
            }
        }
        standing
    }
}
