//! What one look at the walk is told: the size while sizes are open, and the whole part afterwards.

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::part::Step;
use fitcheck_core::verdict::Status;

use super::walking::{Value, Walking};

/// The most sizes that are named.
const NAMED: usize = 12;

/// What the large verdict is of.
#[derive(Debug, Clone)]
pub enum Headline<'a> {
    /// Sizes are open: the size that the page is about, where it has a value.
    Size(Option<(usize, &'a Value)>),
    /// Every size has a value or a reason: the part.
    Part(FinishedPart),
}

/// A part of which nothing is open.
#[derive(Debug, Clone, PartialEq)]
pub struct FinishedPart {
    /// Its verdict; `None` where it has none.
    pub status: Option<Status>,
    /// Whether nobody measured what decides it.
    pub is_simulated: bool,
    /// Whether it is good, and a size lies beyond a limit where its rule accepts it.
    pub is_beyond_limits: bool,
    /// Why it is so, the most important reason first.
    pub reasons: Vec<Message>,
}

impl Walking {
    /// What the large verdict is of.
    pub fn headline(&self) -> Headline<'_> {
        if self.is_done() { Headline::Part(self.whole()) } else { Headline::Size(self.faced_value()) }
    }

    /// Whether every size has a value or a reason.
    pub fn is_done(&self) -> bool {
        self.is_begun() && self.standing().missing == 0
    }

    /// Whether nobody measured what decides the part.
    pub fn is_decided_by_simulation(&self) -> bool {
        let status = self.status();
        let decides =
            |step: &Step| step.counts().is_some_and(|taken| Some(taken.status) == status && !taken.is_simulated);
        status.is_some() && !self.walk.steps().iter().any(decides)
    }

    fn whole(&self) -> FinishedPart {
        let status = self.status();
        let standing = self.standing();
        let mut reasons = Vec::new();
        if let Some(status) = status.filter(|status| *status != Status::Good) {
            let of_it = self.named(|step| step.counts().is_some_and(|taken| taken.status == status));
            reasons.push(message!("walk-page-because").text("names", of_it));
        }
        let beyond = self.beyond_limits();
        if let Some(names) = &beyond {
            reasons.push(message!("walk-page-accepted").text("names", names));
        }
        reasons.push(standing.message());
        if 0 < standing.skipped {
            let skipped = self.named(|step| step.counts().is_none() && step.skipped.is_some());
            reasons.push(message!("walk-page-left-out").text("names", skipped));
        }
        if 0 < standing.contradicted {
            reasons.push(self.contradicted_said());
        }
        if 0 < standing.simulated {
            reasons.push(message!("walk-page-simulated").count("count", standing.simulated));
        }
        let is_beyond_limits = status == Some(Status::Good) && beyond.is_some();
        FinishedPart { status, is_simulated: self.is_decided_by_simulation(), is_beyond_limits, reasons }
    }

    /// The names of the sizes that their rule accepts although they lie beyond a limit; `None` where there is none.
    fn beyond_limits(&self) -> Option<String> {
        let is_it = |at: &usize| self.counting(*at).is_some_and(|value| value.record.verdict.is_beyond_limits());
        let names: Vec<&str> = (0..self.walk.steps().len()).filter(is_it).map(|at| self.name(at)).collect();
        (!names.is_empty()).then(|| shortened(&names))
    }

    /// That values of sizes contradict each other.
    pub(super) fn contradicted_said(&self) -> Message {
        let names = self.named(|step| !step.contradicting().is_empty());
        message!("walk-page-contradicted").text("names", names)
    }

    /// The names of the sizes of which something is true.
    fn named(&self, is_it: impl Fn(&Step) -> bool) -> String {
        let all: Vec<&str> =
            (0..).zip(self.walk.steps()).filter(|(_, step)| is_it(step)).map(|(at, _)| self.name(at)).collect();
        shortened(&all)
    }
}

/// Not more of them than one look takes in.
fn shortened(names: &[&str]) -> String {
    let more = if NAMED < names.len() { " …" } else { "" };
    format!("{}{more}", names.get(..NAMED).unwrap_or(names).join(", "))
}
