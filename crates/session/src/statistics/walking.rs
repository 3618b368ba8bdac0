//! Walking the points of the chart, which of them are in sight, and leaving them out.

use std::ops::Range;
use std::sync::Arc;

use super::{StatisticsField, StatisticsPage, Zooming};
use crate::effect::Effect;
use crate::page::Page;
use crate::shared::{News, Shared};
use crate::step::Step;

/// So few points are shown at least.
const FEWEST: usize = 10;

impl StatisticsPage {
    /// How many points the chart has.
    pub fn count(&self) -> usize {
        self.open().map_or(0, |(_, of)| of.points.len())
    }

    /// The points in sight.
    pub fn window(&self) -> Range<usize> {
        self.window.clone().unwrap_or(0..self.count())
    }

    pub(super) fn choose_feature(&mut self, at: usize) {
        let Some(key) = self.features().nth(at).map(|(feature, _)| feature.key.clone()) else { return };
        if self.chosen.as_ref() != Some(&key) {
            self.chosen = Some(key);
            self.cursor = None;
            self.window = None;
            self.asks_why = false;
        }
    }

    pub(super) fn move_feature(&mut self, step: Step) {
        let last = self.features().len().checked_sub(1);
        if let Some(last) = last {
            self.choose_feature(step.place(self.chosen(), last));
        }
    }

    /// Goes to another point; the window follows.
    pub(super) fn step(&mut self, step: Step) {
        let Some(last) = self.count().checked_sub(1) else { return };
        self.go_to(step.place(self.cursor, last));
    }

    pub(super) fn go_to(&mut self, point: usize) {
        if self.count() <= point {
            return;
        }
        self.asks_why = false;
        self.cursor = Some(point);
        let window = self.window();
        if !window.contains(&point) {
            let start = if point < window.start { point } else { point + 1 - window.len() };
            self.window = Some(start..start + window.len());
        }
    }

    pub(super) fn zoom(&mut self, zooming: Zooming) {
        let (count, window) = (self.count(), self.window());
        let length = match zooming {
            Zooming::In => (window.len() / 2).max(FEWEST),
            Zooming::Out => window.len().saturating_mul(2),
            Zooming::Whole => count,
        };
        let middle = self.cursor.unwrap_or(window.start + window.len() / 2);
        self.see(middle.saturating_sub(length / 2)..middle.saturating_sub(length / 2).saturating_add(length));
    }

    /// Shows these points, as far as there are so many, and not too few of them.
    pub(super) fn see(&mut self, window: Range<usize>) {
        let count = self.count();
        let length = window.len().max(FEWEST).min(count);
        let start = window.start.min(count - length);
        self.window = (length < count).then_some(start..start + length);
        self.cursor = self.cursor.filter(|cursor| self.window().contains(cursor));
    }

    /// Opens the record of a point; of several values, of the last one.
    pub(super) fn open_record(&self, point: Option<usize>, shared: &mut Shared) {
        let Some(point) = point.or(self.cursor) else { return };
        let number = self.values_of(point).filter_map(|value| value.origin.number).last();
        if let Some(number) = number {
            shared.open(Page::Records);
            shared.spread(News::ShowRecord(number));
        }
    }

    /// Whether control limits come from chosen points.
    pub fn is_frozen(&self) -> bool {
        self.chosen.as_ref().is_some_and(|key| self.baselines.contains_key(key))
    }

    /// The limits of the stage that has the cursor come from its points up to there, or from all points again.
    pub(super) fn freeze(&mut self) {
        let Some(key) = self.chosen.clone() else { return };
        if self.baselines.remove(&key).is_none() {
            let Some(cursor) = self.cursor else { return };
            let stages = self.open().and_then(|(_, of)| Some(&of.answer.chart.as_ref().ok()?.stages));
            let stage = stages.into_iter().flatten().find(|stage| stage.points.contains(&cursor));
            let first = stage.map_or(0, |stage| stage.points.start);
            let first = self.values_of(first).find_map(|value| value.origin.number);
            let last = self.values_of(cursor).filter_map(|value| value.origin.number).last();
            let Some(ends) = first.zip(last) else { return };
            self.baselines.insert(key, ends.into());
        }
        self.recompute();
    }

    /// The values that say that a stage begins at the cursor.
    fn stages_here(&self) -> impl Iterator<Item = u64> {
        let stages = self.open().map_or(&[][..], |(_, of)| of.stages.as_slice());
        stages.iter().filter(|(point, _)| Some(*point) == self.cursor).map(|(_, number)| *number)
    }

    /// Whether a stage begins at the cursor; `None` where none can: the first one begins where the chart does.
    pub fn stage(&self) -> Option<bool> {
        let has_one = self.stages_here().next().is_some();
        (has_one || 0 < self.cursor?).then_some(has_one)
    }

    /// A stage with limits of its own begins at the cursor, or no longer.
    pub(super) fn switch_stage(&mut self) {
        let Some(cursor) = self.cursor.filter(|_| self.stage().is_some()) else { return };
        let here: Vec<u64> = self.stages_here().collect();
        let first = self.values_of(cursor).find_map(|value| value.origin.number);
        if here.is_empty() {
            self.look.stages.extend(first);
        }
        self.look.stages.retain(|number| !here.contains(number));
        self.recompute();
    }

    /// Asks why the point is left out, or takes it in again.
    pub(super) fn leave_out(&mut self) -> Vec<Effect> {
        let Some(point) = self.cursor else { return Vec::new() };
        let numbers: Vec<u64> = self.values_of(point).filter_map(|value| value.origin.number).collect();
        let before = self.look.apart.len();
        self.look.apart.retain(|number, _| !numbers.contains(number));
        if self.look.apart.len() < before {
            self.recompute();
            return Vec::new();
        }
        self.asks_why = true;
        vec![Effect::Focus(StatisticsField::Reason.into())]
    }

    /// Leaves the point out for the reason in the field.
    pub(super) fn take_reason(&mut self) {
        let reason: Arc<str> = self.texts.text(StatisticsField::Reason).trim().into();
        let Some(point) = self.cursor.filter(|_| self.asks_why && !reason.is_empty()) else { return };
        let numbers: Vec<u64> = self.values_of(point).filter_map(|value| value.origin.number).collect();
        self.look.apart.extend(numbers.into_iter().map(|number| (number, Arc::clone(&reason))));
        self.texts.set(StatisticsField::Reason, "");
        self.asks_why = false;
        self.recompute();
    }
}
