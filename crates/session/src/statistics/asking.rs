//! From the fields to what is asked of the journal, and what it answers.

use std::sync::Arc;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_exchange::journal::ask::AskedKinds;
use fitcheck_exchange::series::{Evaluated, EvaluatedSeries, Factor, FeatureSeries, Grouping, Look};

use super::{MeanOf, PointsOf, SeriesFound, StatisticsField, StatisticsPage, asks_for};
use crate::effect::Effect;
use crate::parts::{AlarmSearch, NewestValue};
use crate::recording::Keeping;
use crate::records;
use crate::shared::Shared;
use crate::texts::whole;

/// How many values of a feature are looked at where the field does not say it.
const USUAL: usize = 125;

/// The most values of a feature, and the most values of a point whose range says something.
const MOST: usize = 100_000;
const MOST_IN_POINT: usize = 25;

/// The longest pause between two values of a point in minutes: 30 days.
const LONGEST_PAUSE: usize = 30 * 24 * 60;

impl StatisticsPage {
    /// The part that is open on its page: the first question is about it.
    pub(crate) fn see_part(&mut self, part: Option<&str>) {
        if self.open_part.as_deref() != part {
            self.open_part = part.map(str::to_owned);
        }
    }

    /// The page was opened: what is new is read.
    pub(super) fn opened(&mut self, shared: &Shared) {
        if !std::mem::replace(&mut self.has_asked, true)
            && self.texts.text(StatisticsField::Question).is_empty()
            && let Some(part) = &self.open_part
        {
            self.texts.set(StatisticsField::Question, asks_for(part));
        }
        self.ask(shared, false);
    }

    /// Asks about one part, or about all.
    pub(super) fn take_part(&mut self, part: Option<&str>, shared: &Shared) {
        self.texts.set(StatisticsField::Question, part.map_or_else(String::new, asks_for));
        self.ask(shared, false);
    }

    /// Reads the values that the question asks for. `rests` waits until nobody types.
    pub(super) fn ask(&mut self, shared: &Shared, rests: bool) {
        self.errors.remove(&StatisticsField::Question);
        self.culprit = None;
        let most = self.number(StatisticsField::Last, 1..=MOST);
        if !shared.recording.is_on() {
            return;
        }
        match records::question(self.texts.text(StatisticsField::Question), shared) {
            Ok(mut question) => {
                let Some(most) = most else { return };
                // What was withdrawn is left out, and counted.
                question.standing = false;
                question.kinds = AskedKinds::Checks;
                self.texts.text(StatisticsField::Question).trim().clone_into(&mut self.question);
                self.runs += 1;
                self.reading = Some(self.runs);
                self.errands.push(Effect::ReadSeries { run: self.runs, question: Box::new(question), most, rests });
            }
            Err(error) => {
                self.errors.insert(StatisticsField::Question, error.message());
                self.culprit = Some(error.span);
            }
        }
    }

    /// A whole number of a field within a range; otherwise the field says why not.
    fn number(&mut self, field: StatisticsField, range: std::ops::RangeInclusive<usize>) -> Option<usize> {
        self.errors.remove(&field);
        let outside = || {
            let said = message!("statistics-page-range");
            said.text("least", range.start()).text("most", range.end())
        };
        let read = whole::<usize>(self.texts.text(field));
        let read = read.and_then(|number| if range.contains(&number) { Ok(number) } else { Err(outside()) });
        read.map_err(|why| self.errors.insert(field, why)).ok()
    }

    /// The values were read.
    pub(super) fn take_found(&mut self, run: u64, result: Result<Arc<SeriesFound>, Message>) {
        if self.reading != Some(run) {
            return;
        }
        self.reading = None;
        match result {
            Ok(found) => {
                self.problem = None;
                let parts = found.features.iter().map(|feature| feature.key.part.0.clone());
                self.parts.extend(parts.filter(|part| !part.is_empty()));
                self.compute(found);
            }
            Err(why) => self.problem = Some(why),
        }
    }

    /// Computes everything again, as the page looks at it now.
    pub(super) fn recompute(&mut self) {
        let found = self.computing.take().map(|(_, found)| found);
        let found = found.or_else(|| self.found.clone());
        if let Some(found) = found {
            self.compute(found);
        }
    }

    fn compute(&mut self, found: Arc<SeriesFound>) {
        if let Some(grouping) = self.grouping() {
            self.look.grouping = grouping;
        }
        let looks = found.features.iter().map(|feature| self.look_of(feature)).collect();
        self.runs += 1;
        let features = found.features.clone();
        self.computing = Some((self.runs, found));
        self.errands.push(Effect::EvaluateSeries { run: self.runs, features, looks });
    }

    /// What makes a point; `None` where a field does not say it.
    fn grouping(&mut self) -> Option<Grouping> {
        for field in [StatisticsField::Size, StatisticsField::Pause] {
            self.errors.remove(&field);
        }
        match (self.points_of, self.mean_of) {
            (PointsOf::Single, _) => Some(Grouping::Single),
            (PointsOf::Means, MeanOf::Count) => self.number(StatisticsField::Size, 2..=MOST_IN_POINT).map(Grouping::Of),
            (PointsOf::Means, MeanOf::Pause) => {
                let minutes = self.number(StatisticsField::Pause, 1..=LONGEST_PAUSE)?;
                u32::try_from(minutes).ok().map(Grouping::Pause)
            }
            (PointsOf::Means, MeanOf::Part) => Some(Grouping::By(Factor::Part)),
            (PointsOf::Means, MeanOf::Station) => Some(Grouping::By(Factor::Gauge)),
            (PointsOf::Means, MeanOf::Person) => Some(Grouping::By(Factor::Who)),
        }
    }

    /// Other values make a point: the chart is another one.
    pub(super) fn regroup(&mut self) {
        self.cursor = None;
        self.window = None;
        self.asks_why = false;
        self.recompute();
    }

    /// Values are on disk: what fires there is looked for as the page looks at their series.
    pub(super) fn find_alarms(&mut self, newest: &[NewestValue], shared: &Shared) {
        if shared.recording.keeping != Keeping::Open {
            return;
        }
        let most = whole::<usize>(self.texts.text(StatisticsField::Last)).ok();
        let most = most.filter(|most| (1..=MOST).contains(most)).unwrap_or(USUAL);
        let (newest, look, baselines) = (newest.to_vec(), self.look.clone(), self.baselines.clone());
        self.errands.push(Effect::FindAlarms(Box::new(AlarmSearch { newest, look, baselines, most })));
    }

    fn look_of(&self, feature: &FeatureSeries) -> Look {
        Look { baseline: self.baselines.get(&feature.key).copied(), ..self.look.clone() }
    }

    /// Everything is computed.
    pub(super) fn take_answers(&mut self, run: u64, answers: Arc<Vec<Evaluated>>) {
        let Some((_, found)) = self.computing.take_if(|(of, _)| *of == run) else { return };
        self.shown = EvaluatedSeries { features: found.features.clone(), answers };
        self.found = Some(found);
        self.version += 1;
        if self.chosen().is_none() {
            let first = self.features().next().map(|(feature, _)| feature.key.clone());
            self.chosen = first;
            self.cursor = None;
            self.window = None;
        }
        let count = self.open().map_or(0, |(_, of)| of.points.len());
        self.cursor = self.cursor.filter(|cursor| *cursor < count);
        self.window = self.window.take().filter(|window| window.end <= count);
    }
}
