//! A part that was measured by a plan: what stands above its checks in a report.

use std::sync::Arc;

use super::image::Image;
use crate::journal::Record;
use crate::message::Message;
use crate::part::{FeatureStanding, Plan, Standing, Step, Taken, Walk, standings};
use crate::verdict::Status;

/// A part with its values, as a report shows it.
#[derive(Debug, Clone)]
pub struct PartSheet {
    /// What it was measured by.
    pub plan: Arc<Plan>,
    walk: Walk,
    /// The value of every size that counts, as [`Plan::sizes`] has them.
    values: Vec<Option<Arc<Record>>>,
    /// Its picture, or why there is none; `None` where the plan names none.
    pub picture: Option<Result<Image, Message>>,
}

impl PartSheet {
    /// A part of which nothing is measured yet.
    pub fn new(plan: &Arc<Plan>, serial: &str) -> Self {
        let walk = Walk::new(plan, serial.to_owned());
        let values = vec![None; walk.steps().len()];
        Self { plan: Arc::clone(plan), walk, values, picture: None }
    }

    /// Takes a value of a size, by its place in the plan; the last one that was measured counts.
    pub fn take(&mut self, at: usize, record: Arc<Record>) {
        let is_simulated = record.measurement.origin.is_simulated();
        self.walk.take(at, Taken { status: record.verdict.status(), is_simulated });
        let is_last = |step: &Step| step.counting().is_some_and(|counts| counts + 1 == step.taken.len());
        let counts = self.walk.steps().get(at).is_some_and(is_last);
        if let Some(value) = self.values.get_mut(at).filter(|_| counts) {
            *value = Some(record);
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
    pub fn standing(&self) -> Standing {
        self.walk.standing()
    }

    /// Its verdict as it may be said.
    pub fn status(&self) -> Option<Status> {
        self.standing().said()
    }

    /// Every size: its name, what was measured of it, and the value that counts.
    pub fn sizes(&self) -> impl Iterator<Item = (crate::part::Size<'_>, &Step, Option<&Arc<Record>>)> {
        let values = self.walk.steps().iter().zip(&self.values);
        self.plan.sizes().zip(values).map(|(size, (step, value))| (size, step, value.as_ref()))
    }

    /// The values that count, in the order of the plan.
    pub fn records(&self) -> impl Iterator<Item = &Arc<Record>> {
        self.values.iter().flatten()
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
