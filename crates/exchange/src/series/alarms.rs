//! Which rules fire at the newest value of a series: what somebody at the machine has to know now.

use fitcheck_statistics::Signal;

use super::{FeatureSeries, Look, Value};
use crate::journal::Alarm;

impl FeatureSeries {
    /// The alarms at the value of an entry, where that is the newest one that counts and completes a point. A pattern of which an alarm is
    /// known gives no other one, and a pattern that ends before the newest point is none of this value.
    pub fn alarms(&self, look: &Look, number: u64, known: &[Alarm]) -> Vec<Alarm> {
        let of = self.evaluate(look);
        let value = |at: &usize| self.values.get(*at);
        let newest = of.shown.last().and_then(value).and_then(|value| value.origin.number);
        if newest != Some(number) || !of.shown.len().is_multiple_of(look.size.max(1)) {
            return Vec::new();
        }
        let count = of.points.len();
        let first_of = |signal: &Signal| -> Option<&Value> {
            let stretch = signal.stretches.last().filter(|stretch| stretch.end == count)?;
            value(of.shown.get(of.points.get(stretch.start)?.start)?)
        };
        let alarm = |signal: &Signal| {
            let origin = &first_of(signal)?.origin;
            let (rule, place, since) = (signal.rule, signal.place, origin.piece.clone());
            Some(Alarm { rule, place, first: origin.number?, last: number, since, answer: None })
        };
        let is_new = |alarm: &Alarm| !known.iter().any(|known| known.has_pattern_of(alarm));
        of.signals.iter().filter_map(alarm).filter(is_new).collect()
    }
}
