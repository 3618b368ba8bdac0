//! The walk through a part: which feature is next, what was measured, what was left out and why, and what that makes of the part.

use super::plan::Plan;
use super::repeats::{Counting, Repeats, counting};
use super::taken::SizeValue;
use crate::message::Say;
use crate::verdict::Status;

/// One size of a part: its values in the order in which they came, or why it was left out.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Step {
    /// Its values, all of which are kept: [`Self::counts`] says which one counts.
    pub taken: Vec<SizeValue>,
    /// Which one of those counts that contradict each other.
    repeats: Repeats,
    /// Why it was left out; a value that comes later counts.
    pub skipped: Option<String>,
}

impl Step {
    /// The values of which one counts: those that somebody measured, and simulated ones where nobody did.
    fn live(&self) -> impl Iterator<Item = (usize, SizeValue)> {
        let nobody = self.taken.iter().all(|taken| taken.is_simulated);
        let of_somebody = move || self.taken.iter().filter(move |taken| nobody || !taken.is_simulated);
        // What somebody chose may have been taken out since.
        let none_left = of_somebody().all(|taken| taken.is_settled);
        let is_live = move |taken: &SizeValue| (nobody || !taken.is_simulated) && (none_left || !taken.is_settled);
        (0..).zip(self.taken.iter().copied()).filter(move |(_, taken)| is_live(taken))
    }

    /// The place of the newest of them.
    pub fn newest(&self) -> Option<usize> {
        counting(self.live(), Repeats::Last).map(|counting| counting.at)
    }

    fn decided(&self) -> Option<Counting> {
        counting(self.live(), self.repeats)
    }

    /// The place of the value that counts.
    pub fn counting(&self) -> Option<usize> {
        self.decided().map(|counting| counting.at)
    }

    /// The places of the values that contradict each other, in the order in which they came; none where one of them counts without doubt.
    pub fn contradicting(&self) -> Vec<usize> {
        let is_open = self.decided().is_some_and(|counting| counting.is_contradicted);
        if is_open { self.live().map(|(at, _)| at).collect() } else { Vec::new() }
    }

    /// The value that counts.
    pub fn counts(&self) -> Option<SizeValue> {
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
pub struct PartStanding {
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
    /// How many sizes have values that contradict each other.
    #[say(skip)]
    pub contradicted: usize,
}

impl PartStanding {
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

    /// The same where repeated values are to be counted in another way.
    #[must_use]
    pub fn by(mut self, repeats: Repeats) -> Self {
        self.steps.iter_mut().for_each(|step| step.repeats = repeats);
        self
    }

    /// Somebody chose: this value of a size counts no more.
    pub fn settle(&mut self, at: usize, place: usize) {
        if let Some(taken) = self.steps.get_mut(at).and_then(|step| step.taken.get_mut(place)) {
            taken.is_settled = true;
        }
    }

    /// Takes a value of a size.
    pub fn take(&mut self, at: usize, taken: SizeValue) {
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
    pub fn standing(&self) -> PartStanding {
        let mut standing = PartStanding::default();
        for step in &self.steps {
            match (step.counts(), &step.skipped) {
                (Some(taken), _) => {
                    standing.measured += 1;
                    standing.simulated += usize::from(taken.is_simulated);
                    standing.contradicted += usize::from(!step.contradicting().is_empty());
                    standing.worst = standing.worst.max(Some(taken.status));
                }
                (None, Some(_)) => standing.skipped += 1,
                (None, None) => standing.missing += 1,
            }
        }
        standing
    }
}
