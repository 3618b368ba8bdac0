//! What is done on the walk: a value is typed or simulated, a size is left out.

use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::part::{Plan, Step};
use fitcheck_core::probing::{Measurement, Origin};
use fitcheck_core::verdict::Doubt;
use fitcheck_core::words::Words;
use fitcheck_exchange::exchange::gauge::{self, GaugeRemark};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::entry::{FileRole, UsedFile};
use jiff::civil::DateTime;

use super::judging::judged;
use super::walking::Value;
use super::{PartsPage, WalkCommand, serials};
use crate::Question;
use crate::effect::Effect;
use crate::gauges::{FromGauge, measured_with};
use crate::parts::WalkField;
use crate::recording::{Named, Sent, ToKeep, used};
use crate::shared::Shared;
use crate::texts::Range;

impl PartsPage {
    pub(super) fn apply_walk(&mut self, command: WalkCommand, shared: &mut Shared, now: DateTime) -> Vec<Effect> {
        match command {
            WalkCommand::Begin => return self.begin(shared, now),
            WalkCommand::CountUp => {
                let next = serials::next(self.texts.text(WalkField::Serial));
                self.set_serial(next);
            }
            WalkCommand::Go(at) => {
                self.walking.go(at);
                self.errors.remove(&WalkField::Value);
                // What a gauge types next is a value of it.
                return vec![Effect::Focus(WalkField::Value.into())];
            }
            WalkCommand::Move(step) => {
                if let Some(last) = self.walking.count().checked_sub(1) {
                    self.walking.go(step.place(self.walking.at, last));
                }
            }
            WalkCommand::Take => self.take_typed(shared, now),
            WalkCommand::TakeMeant => {
                if let Some(meant) = self.walking.question.take().and_then(|question| question.doubt.meant()) {
                    self.texts.set(WalkField::Value, meant.to_string());
                    self.take_typed(shared, now);
                }
            }
            WalkCommand::MeasureAnew => {
                self.walking.quiet();
                self.clear_value();
                return vec![Effect::Focus(WalkField::Value.into())];
            }
            WalkCommand::Simulate => self.simulate(shared, now),
            WalkCommand::Again => {
                if let Some((at, _)) = self.walking.shown() {
                    self.walking.go(at);
                    return vec![Effect::Focus(WalkField::Value.into())];
                }
            }
            WalkCommand::CountNewest => {
                if let Some(name) = self.walking.count_newest() {
                    shared.tell(message!("walk-page-newest-counts").text("name", name));
                }
            }
            WalkCommand::AskSkip(is_open) => {
                self.walking.quiet();
                self.walking.is_skipping = is_open && self.walking.at.is_some();
                if !is_open {
                    return vec![Effect::Focus(WalkField::Value.into())];
                }
            }
            WalkCommand::Skip(reason) => return self.skip(&reason),
            WalkCommand::AskAlarm(number) => return self.ask_alarm(number),
            WalkCommand::LeaveAlarm => return self.leave_alarm(),
            WalkCommand::AnswerAlarm => return self.answer_alarm(shared),
            WalkCommand::AlarmsFound(found) => self.take_alarms(found, shared),
            WalkCommand::Next => return self.next_part(shared),
            WalkCommand::KeepOn => {
                self.walking.kept_on = self.document.opened;
                return vec![Effect::Focus(WalkField::Value.into())];
            }
            WalkCommand::Imported { run, name, result } => self.imported(run, &name, result, shared),
            WalkCommand::Came { run, result } => self.came(run, result, shared),
            WalkCommand::Watch { folder, is_folder } => self.watch(folder, is_folder, shared),
            WalkCommand::StopWatch => return self.watched.stop().into_iter().collect(),
            WalkCommand::Watched { run, news } => self.watch_news(run, *news, shared, now),
        }
        Vec::new()
    }

    /// The verdict has been read: the next size is asked for.
    pub(crate) fn go_on(&mut self) -> Vec<Effect> {
        self.walking.begin_asked();
        self.walking.at.map(|_| Effect::Focus(WalkField::Value.into())).into_iter().collect()
    }

    /// Reads the field, asks about a doubtful value, and takes it.
    fn take_typed(&mut self, shared: &mut Shared, now: DateTime) {
        let asked_about = self.walking.question.take();
        let Some(at) = self.walking.at else { return };
        if self.texts.text(WalkField::Value).trim().is_empty() && self.walking.begin_asked() {
            return;
        }
        // A value is of the size that it was typed for, and of no other one.
        if let Some(typed_at) = self.walking.typed_elsewhere() {
            let [name, asked] = [typed_at, at].map(|at| self.walking.name(at));
            let refusal = message!("walk-page-typed-elsewhere").text("name", name).text("asked", asked);
            self.errors.insert(WalkField::Value, refusal);
            return;
        }
        if self.refuse_serial(shared) {
            return;
        }
        let range = if self.walking.may_be_any() { Range::Any } else { Range::AboveZero };
        let asked = self.walking.asked().map(|size| size.limits.nominal);
        let gauged = gauge::read(self.texts.text(WalkField::Value), asked).map_err(|error| error.message());
        let read = gauged.and_then(|gauged| {
            // The range of the other fields.
            let value = range.read(&gauged.value.to_string())?;
            Ok((value, gauged.remarks.iter().map(fitcheck_core::message::Say::message).collect::<Vec<_>>()))
        });
        let taken = read.and_then(|(value, mut remarks)| {
            let (record, said) = self.judge(Measurement::of_diameter(value, Origin::Typed), shared, now)?;
            remarks.extend(said);
            Ok((record, remarks))
        });
        let (record, mut remarks) = match taken {
            Ok(taken) => taken,
            Err(problem) => {
                self.errors.insert(WalkField::Value, problem);
                return;
            }
        };
        if let Some(question) = question(&record) {
            let is_new = asked_about != Some(question);
            if is_new {
                self.asking.ask(now);
            }
            if is_new || !self.asking.is_answered(now) {
                self.walking.question = Some(question);
                return;
            }
        }
        let gauge = self.gauge.take();
        let of_gauge =
            gauge.iter().flat_map(|gauge| gauge.remarks.iter().map(GaugeRemark::message).chain([gauge.told()]));
        remarks.extend(of_gauge);
        self.clear_value();
        self.walking.settle_seen(at);
        self.keep_own(vec![(at, record, remarks)], gauge.as_ref(), shared);
        self.walking.go_on();
    }

    /// A text for the field of the value. What was asked about another one is over.
    pub(super) fn type_value(&mut self, text: &str) {
        self.gauge = None;
        self.walking.question = None;
        self.walking.typed(text);
    }

    /// A serial number that was scanned into the field of the value is told, and does not stay there. Returns whether it was one.
    pub(super) fn refuse_serial(&mut self, shared: &Shared) -> bool {
        let text = self.texts.text(WalkField::Value).trim().to_owned();
        let is_measured = |plan: &Plan| self.is_measured_already(&plan.head.part, &text, shared);
        let is_serial = serials::is_like(&text, self.walking.serial())
            || self.walking.plan.as_ref().is_some_and(|plan| is_measured(plan));
        if is_serial {
            self.clear_value();
            self.errors.insert(WalkField::Value, message!("walk-page-is-serial").text("given", text));
        }
        is_serial
    }

    /// Empties the field of the value.
    pub(super) fn clear_value(&mut self) {
        self.texts.set(WalkField::Value, "");
        self.walking.typed("");
        self.gauge = None;
        self.errors.remove(&WalkField::Value);
    }

    /// The size that is asked for is one that is open, unless somebody is at another one: while a value is typed it stays its own.
    pub(super) fn stay_open(&mut self) {
        if self.texts.text(WalkField::Value).trim().is_empty() {
            self.walking.stay_open();
        }
    }

    fn judge(
        &self,
        measurement: Measurement,
        shared: &Shared,
        now: DateTime,
    ) -> Result<(Record, Vec<Message>), Message> {
        let size = self.walking.asked().ok_or_else(|| message!("walk-page-nothing-asked"))?;
        judged(&size, measurement, shared, now)
    }

    /// Measures the feature by its cycle. The cycle of a pocket or boss measures both sides: the other one is taken where it is open.
    fn simulate(&mut self, shared: &mut Shared, now: DateTime) {
        self.walking.quiet();
        let Some(at) = self.walking.at else { return };
        match self.simulated(at, shared, now) {
            Ok(taken) => {
                self.walking.seed += 1;
                self.keep_own(taken, None, shared);
                self.walking.go(at);
                self.walking.go_on();
                self.walking.rest(at, true);
            }
            Err(problem) => self.walking.refusal = Some(problem),
        }
    }

    fn simulated(&self, at: usize, shared: &Shared, now: DateTime) -> Result<Vec<Judged>, Message> {
        // It would not count, and nobody would know that he has to measure again.
        if self.walking.is_measured(at) {
            return Err(message!("walk-page-simulate-measured").text("name", self.walking.name(at)));
        }
        let size = self.walking.asked().ok_or_else(|| message!("walk-page-nothing-asked"))?;
        let measured = size.feature.simulated(self.walking.seed + 1)?;
        let first = at.saturating_sub(size.side);
        let steps = self.walking.walk.steps();
        let mut taken = Vec::new();
        for ((place, size), measurement) in (first..).zip(size.feature.sizes()).zip(measured) {
            if place == at || steps.get(place).is_some_and(Step::is_open) {
                let (record, remarks) = judged(&size, measurement, shared, now)?;
                taken.push((place, record, remarks));
            }
        }
        // The one that was asked for is shown.
        taken.sort_by_key(|(place, ..)| *place == at);
        Ok(taken)
    }

    /// Values of this part that were measured here.
    fn keep_own(&mut self, taken: Vec<Judged>, gauge: Option<&FromGauge>, shared: &mut Shared) {
        let mut values = Vec::new();
        for (at, record, remarks) in taken {
            let confirmed = confirmed(&record).map(|said| shared.recorded_words().say(&said));
            let remark = measured_with(confirmed.as_deref().unwrap_or(""), gauge, shared);
            values.push(Arriving { at: Some(at), record: Arc::new(record), remarks, labels: None, file: None, remark });
        }
        self.keep(values, shared);
        self.walking.quiet();
    }

    /// Puts checks into the history, sends them to the journal as one batch, and those of this part into the walk.
    pub(super) fn keep(&mut self, values: Vec<Arriving>, shared: &mut Shared) -> Sent {
        if values.is_empty() {
            return Sent::default();
        }
        let first = shared.history.next();
        shared.history.add(values.iter().map(|value| Arc::clone(&value.record)).collect());
        let budget = shared.budget.as_deref().and_then(|open| used(FileRole::Budget, &open.file, open.sha256));
        let words = shared.recorded_words();
        let checks = values.iter().map(|value| {
            let budget = budget.clone().filter(|_| value.record.budget.is_some());
            let files = value.file.iter().cloned().chain(budget).collect();
            ToKeep { record: Arc::clone(&value.record), named: self.named(value, &words), files }
        });
        let checks = checks.collect();
        let sent = shared.recording.keep_named(first, checks);
        if let Some((count, why)) = &sent.refused {
            shared.tell(message!("walk-page-refused").count("count", *count).message("why", why.clone()));
        }
        let ids = (first.0..).map(fitcheck_exchange::journal::query::RecordId);
        self.await_alarms(&sent, ids.zip(values.iter().map(Self::takes_part)));
        let before = self.walking.standing().contradicted;
        for (id, value) in (first.0..).map(fitcheck_exchange::journal::query::RecordId).zip(values) {
            let Arriving { at, record, remarks, labels, .. } = value;
            // Of what was measured here the time is known, of what a file holds where that says it.
            let when = labels.map_or(Some(record.time), |labels| labels.time);
            if let Some(at) = at {
                self.walking.take(at, Value { record, id: Some(id), number: None, remarks, when, is_settled: false });
            }
        }
        if before < self.walking.standing().contradicted {
            shared.tell(self.walking.contradicted_said());
        }
        sent
    }

    /// What a value is named in the journal: by its file, and what that does not say by this part.
    fn named(&self, value: &Arriving, words: &Words) -> Named {
        let is_own = value.at.is_some();
        let of_file = value.labels.as_deref();
        // What nobody said is empty in the journal.
        let said = |text: Option<&String>| text.map_or_else(String::new, String::clone);
        let label = said(of_file.map(|labels| &labels.part));
        let part = said(self.walking.plan.as_ref().or(self.watched.plan()).map(|plan| &plan.head.part));
        let part = if part.is_empty() { label.clone() } else { part };
        // What the file calls the part stays findable where that is another name.
        let is_other = !label.is_empty() && !label.trim().eq_ignore_ascii_case(&part);
        let remark = || words.say(&message!("walk-page-remark-label").text("part", label.trim()));
        let serial = said(of_file.map(|labels| &labels.serial));
        Named {
            part,
            serial: if serial.is_empty() && is_own { self.walking.serial().to_owned() } else { serial },
            feature: value.record.id.clone(),
            who: said(of_file.map(|labels| &labels.who)),
            remark: if is_other { remark() } else { value.remark.clone() },
        }
    }

    fn skip(&mut self, reason: &str) -> Vec<Effect> {
        let Some(at) = self.walking.at else { return Vec::new() };
        if !self.walking.skip(at, reason) {
            self.walking.is_skipping = true;
            self.errors.insert(WalkField::Reason, message!("walk-page-no-reason"));
            return Vec::new();
        }
        self.errors.remove(&WalkField::Reason);
        self.texts.set(WalkField::Reason, "");
        self.walking.go_on();
        vec![Effect::Focus(WalkField::Value.into())]
    }
}

/// A judged value of a size, and what is to be said of it.
type Judged = (usize, Record, Vec<Message>);

/// A check on its way into history, journal and walk.
#[derive(Debug)]
pub(super) struct Arriving {
    /// The size of this part; `None` where it is of another part.
    pub at: Option<usize>,
    /// The check.
    pub record: Arc<Record>,
    /// What is to be said of it.
    pub remarks: Vec<Message>,
    /// What its file says of it.
    pub labels: Option<Box<fitcheck_exchange::exchange::Labels>>,
    pub file: Option<UsedFile>,
    /// What is kept beside it; empty where there is nothing.
    pub remark: String,
}

/// That somebody said of a value which cannot be that it is so.
fn confirmed(record: &Record) -> Option<Message> {
    matches!(record.doubt, Some(Doubt::Implausible { .. })).then(|| message!("walk-page-confirmed"))
}

/// What is asked about a typed value before it is taken, as it was typed.
fn question(record: &Record) -> Option<Question> {
    let measured: Length = record.measured();
    record.doubt.map(|doubt| Question { measured, doubt })
}
