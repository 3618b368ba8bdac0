//! A part that was measured by a plan: what stands above its checks in a report.

use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_core::part::{FeatureStanding, PartStanding, Plan, Repeats, SizeValue, Step, Walk, standings};
use fitcheck_core::verdict::Status;
use jiff::civil::DateTime;

use super::image::Image;
use crate::journal::Record;

/// A part with its values, as a report shows it.
#[derive(Debug, Clone)]
pub struct PartSheet {
    /// What it was measured by.
    pub plan: Arc<Plan>,
    walk: Walk,
    /// The values of every size, as [`Plan::sizes`] has them: with their places those of which one may count.
    values: Vec<Vec<(usize, SizeValue, Arc<Record>)>>,
    /// Its picture, or why there is none; `None` where the plan names none.
    pub picture: Option<Result<Image, Message>>,
}

impl PartSheet {
    /// A part of which nothing is measured yet.
    pub fn new(plan: &Arc<Plan>, serial: &str) -> Self {
        let walk = Walk::new(plan, serial.to_owned());
        let values = vec![Vec::new(); walk.steps().len()];
        Self { plan: Arc::clone(plan), walk, values, picture: None }
    }

    /// A part as it was walked through, with all values of each size.
    pub fn of_walk(plan: &Arc<Plan>, walk: Walk, values: Vec<Vec<Arc<Record>>>) -> Self {
        let of_size = |(step, records): (&Step, Vec<Arc<Record>>)| {
            (0..).zip(step.taken.clone()).zip(records).map(|((at, taken), record)| (at, taken, record)).collect()
        };
        let values = walk.steps().iter().zip(values).map(of_size).collect();
        Self { plan: Arc::clone(plan), walk, values, picture: None }
    }

    /// A part of which several values of a size are counted in this way.
    #[must_use]
    pub fn by(self, repeats: Repeats) -> Self {
        Self { walk: self.walk.by(repeats), ..self }
    }

    /// The same part before anything was measured.
    #[must_use]
    pub fn unmeasured(&self) -> Self {
        Self { picture: self.picture.clone(), ..Self::new(&self.plan, self.serial()) }
    }

    /// Takes a value of a size, by its place in the plan, and when it was measured, where its file says so.
    pub fn take(&mut self, at: usize, record: Arc<Record>, when: Option<DateTime>) {
        let status = record.verdict.status();
        let is_simulated = record.measurement.origin.is_simulated();
        let place = self.walk.steps().get(at).map_or(0, |step| step.taken.len());
        let taken = SizeValue { status, is_simulated, when, is_settled: false };
        self.walk.take(at, taken);
        if let Some(values) = self.values.get_mut(at) {
            // Of values with the same verdict only the last one counts, and the latest.
            let is_of_kind = |other: &SizeValue| (other.status, other.is_simulated) == (status, is_simulated);
            let of_kind = values.iter().filter(|(_, other, _)| is_of_kind(other));
            let latest = of_kind.max_by_key(|(place, other, _)| (other.when, *place)).map(|(place, ..)| *place);
            values.retain(|(place, other, _)| !is_of_kind(other) || Some(*place) == latest);
            values.push((place, taken, record));
        }
    }

    /// Leaves a size out, with the reason.
    pub fn skip(&mut self, at: usize, reason: &str) {
        self.walk.skip(at, reason);
    }

    /// Its serial number; empty where it has none.
    pub fn serial(&self) -> &str {
        &self.walk.serial
    }

    /// The file name of its picture, where the plan names one.
    pub fn picture_name(&self) -> Option<&str> {
        Some(self.plan.head.picture.as_str()).filter(|name| !name.is_empty())
    }

    /// What its values make of it.
    pub fn standing(&self) -> PartStanding {
        self.walk.standing()
    }

    /// Its verdict as it may be said.
    pub fn status(&self) -> Option<Status> {
        self.standing().said()
    }

    /// Every size: its name, what was measured of it, and the value that counts.
    pub fn sizes(&self) -> impl Iterator<Item = (fitcheck_core::part::Size<'_>, &Step, Option<&Arc<Record>>)> {
        self.plan.sizes().zip(self.counting()).map(|(size, (step, value))| (size, step, value))
    }

    /// The values that count, in the order of the plan.
    pub fn records(&self) -> impl Iterator<Item = &Arc<Record>> {
        self.counting().filter_map(|(_, value)| value)
    }

    fn counting(&self) -> impl Iterator<Item = (&Step, Option<&Arc<Record>>)> {
        self.walk.steps().iter().zip(&self.values).map(|(step, values)| {
            let counting = step.counting();
            let value = values.iter().find(|(place, ..)| Some(*place) == counting);
            (step, value.map(|(.., record)| record))
        })
    }

    /// The names of the sizes with neither a value nor a reason.
    pub fn missing(&self) -> Vec<String> {
        self.sizes().filter(|(_, step, _)| step.is_open()).map(|(size, ..)| size.name()).collect()
    }

    /// The names of the sizes that were left out, with the reasons.
    pub fn left_out(&self) -> Vec<(String, String)> {
        let left = self.sizes().filter(|(.., value)| value.is_none());
        left.filter_map(|(size, step, _)| Some((size.name(), step.skipped.clone()?))).collect()
    }

    /// How many values are not the last ones of their sizes.
    pub fn older(&self) -> usize {
        self.walk.steps().iter().map(|step| step.taken.len().saturating_sub(1)).sum()
    }

    /// What its values make of each feature.
    pub fn features(&self) -> Vec<FeatureStanding> {
        standings(&self.plan, self.walk.steps())
    }
}
