//! Which rules fire at the newest value of a series: what somebody at the machine has to know now.

use fitcheck_statistics::{Reason, Signal};

use super::{Evaluated, FeatureSeries, Grouping, Look, Value};
use crate::journal::Alarm;

/// An alarm with the serial number of the part at whose value the rule fired.
pub type FiredAlarm = (String, Alarm);

impl FeatureSeries {
    /// The alarms at the value of an entry, where that is the newest one that counts and completes a point. Where nothing says how large a
    /// subgroup is, it is complete once the next one begins. A pattern of which an alarm is known gives no other one, and a pattern that ends
    /// before the newest point is none of this value.
    ///
    /// # Errors
    /// Why there is no chart although there are enough values: nothing would be seen from now on.
    pub fn alarms(&self, look: &Look, number: u64, known: &[Alarm]) -> Result<Vec<FiredAlarm>, Reason> {
        let of = self.evaluate(look);
        let newest = of.shown.last().and_then(|at| self.values.get(*at)).and_then(|value| value.origin.number);
        if newest != Some(number) {
            return Ok(Vec::new());
        }
        if let Err(why @ (Reason::Ungrouped { .. } | Reason::NoBaseline)) = &of.answer.chart {
            return Err(why.clone());
        }
        Ok(match (look.grouping.whole(&of.points), look.grouping) {
            (whole, _) if whole == of.shown.len() => self.alarms_of(&of, known),
            (_, Grouping::Single | Grouping::Of(_)) => Vec::new(),
            // Where nothing says how large a subgroup is, the newest one may go on.
            (whole, Grouping::By(_) | Grouping::Pause(_)) => {
                let values = self.values.iter().take(of.shown.get(whole).copied().unwrap_or_default());
                let before = Self { key: self.key.clone(), values: values.cloned().collect() };
                before.alarms_of(&before.evaluate(look), known)
            }
        })
    }

    /// The alarms at the newest point.
    fn alarms_of(&self, of: &Evaluated, known: &[Alarm]) -> Vec<FiredAlarm> {
        let value = |at: &usize| self.values.get(*at);
        let Some(newest) = of.shown.last().and_then(value).map(|value| &value.origin) else { return Vec::new() };
        let Some(last) = newest.number else { return Vec::new() };
        let count = of.points.len();
        let first_of = |signal: &Signal| -> Option<&Value> {
            let stretch = signal.stretches.last().filter(|stretch| stretch.end == count)?;
            value(of.shown.get(of.points.get(stretch.start)?.start)?)
        };
        let alarm = |signal: &Signal| {
            let origin = &first_of(signal)?.origin;
            let (rule, place, since) = (signal.rule, signal.place, origin.piece.clone());
            Some(Alarm { rule, place, first: origin.number?, last, since, answer: None })
        };
        let is_new = |alarm: &Alarm| !known.iter().any(|known| known.has_pattern_of(alarm));
        of.signals.iter().filter_map(alarm).filter(is_new).map(|alarm| (newest.piece.clone(), alarm)).collect()
    }
}
