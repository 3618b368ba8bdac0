//! The parts that the values of a run with a plan belong to: what is missing of each, and what all of them make of the exit code.

use std::collections::BTreeMap;

use super::Outcome;
use crate::exchange::Labels;
use crate::journal::Record;
use crate::part::{Plan, Standing, Taken, Walk};
use crate::verdict::Status;

/// The most parts that are known one by one; the verdicts of more count all the same.
const MOST: usize = 10_000;

/// Every part of a run, by the name and the serial number that its file says.
#[derive(Debug)]
pub(super) struct PlanParts {
    /// The place of each size, by its name.
    places: BTreeMap<String, usize>,
    /// A part of which nothing was measured.
    nothing: Walk,
    walks: BTreeMap<(String, String), Walk>,
    /// The worst verdict of the parts beyond those.
    beyond: Option<Status>,
}

impl PlanParts {
    /// Of no value yet.
    pub(super) fn of(plan: &Plan) -> Self {
        let places = plan.sizes().map(|size| size.name()).zip(0..).collect();
        Self { places, nothing: Walk::new(plan, String::new()), walks: BTreeMap::new(), beyond: None }
    }

    /// A value of a part, as it was judged.
    pub(super) fn see(&mut self, record: &Record, labels: &Labels) {
        let Some(at) = self.places.get(&record.id).copied() else { return };
        let (status, is_simulated) = (record.verdict.status(), record.measurement.origin.is_simulated());
        let key = (labels.part.clone(), labels.serial.clone());
        if MOST <= self.walks.len() && !self.walks.contains_key(&key) {
            self.beyond = self.beyond.max(Some(status));
            return;
        }
        let walk = self.walks.entry(key).or_insert_with(|| self.nothing.clone());
        walk.take(at, Taken { status, is_simulated });
    }

    /// Each part: its name and serial number as far as they are known, and its walk. Without a value it is one part without any.
    pub(super) fn each(&self) -> impl Iterator<Item = (String, &Walk)> {
        let nothing = self.walks.is_empty().then_some((String::new(), &self.nothing));
        let who = |(part, serial): &(String, String)| match (part.as_str(), serial.as_str()) {
            (text, "") | ("", text) => text.to_owned(),
            (part, serial) => format!("{part} {serial}"),
        };
        self.walks.iter().map(move |(key, walk)| (who(key), walk)).chain(nothing)
    }

    /// How many parts are known one by one, and whether there are more.
    pub(super) fn count(&self) -> (usize, bool) {
        (self.walks.len(), self.beyond.is_some())
    }

    /// The outcome of the run: the worst part, or a verdict of no part where that is worse. Without scrap, rework or doubt it is good where
    /// every part is, bad data where a part lacks a value, and to be looked at first where it was simulated.
    pub(super) fn outcome(&self, of_none: Option<Status>) -> Outcome {
        let standings: Vec<Standing> = self.each().map(|(_, walk)| walk.standing()).collect();
        let worst = standings.iter().filter_map(Standing::said).max().max(self.beyond).max(of_none);
        // Of a part that is not known what it lacks nothing is good.
        let is_open = self.beyond.is_some() || standings.iter().any(Standing::is_open);
        let judged = match worst {
            None | Some(Status::Good) if is_open => Outcome::BadData,
            Some(worst) => Outcome::Judged(worst),
            None => Outcome::Done,
        };
        let is_simulated = standings.iter().any(|standing| 0 < standing.simulated);
        if is_simulated { judged.worse(Outcome::LookFirst) } else { judged }
    }
}
