//! Alarms of control charts on the walk: what fired, what is open, and the answers to it.
//!
//! Once values are on disk, the statistics page says how their series are looked at, and the world outside computes them. Open alarms are
//! those of the journal: they come back with every look and after a restart. No verdict depends on any of this.

use std::collections::{BTreeMap, BTreeSet};

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::words::Words;
use fitcheck_exchange::journal::chain::Head;
use fitcheck_exchange::journal::entry::About;
use fitcheck_exchange::journal::query::RecordId;
use fitcheck_exchange::journal::{Alarm, AlarmAnswer};

use super::alarm_search::NewestValue;
use super::alarms_found::AlarmsFound;
use super::measuring::Arriving;
use super::{PartsPage, WalkField};
use crate::effect::Effect;
use crate::recording::{Named, Sent};
use crate::records::RecordRow;
use crate::shared::{News, Shared};

/// What stands between two entries of a list of causes or actions.
const BETWEEN: char = ';';

/// An alarm that nobody has answered.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OpenAlarm {
    /// Its entry.
    pub head: Head,
    pub alarm: Alarm,
    named: Named,
}

impl OpenAlarm {
    fn of(row: &RecordRow) -> Option<Self> {
        let entry = row.entry.as_ref().ok()?;
        let alarm = entry.alarm().filter(|alarm| alarm.answer.is_none() && row.corrected_by.is_none())?;
        let About { part, serial, feature, .. } = entry.about.clone();
        let named = Named { part, serial, feature, ..Named::default() };
        Some(Self { head: row.head, alarm: alarm.clone(), named })
    }

    /// Part and feature.
    pub fn name(&self) -> String {
        name(&self.named)
    }

    /// Whether both fired at the same value: one answer is for both.
    pub fn is_with(&self, other: &Self) -> bool {
        self.named == other.named && self.alarm.last == other.alarm.last
    }

    /// The feature, the rule, and since which part it is so.
    pub fn message(&self) -> Message {
        said(&self.named, &self.alarm)
    }
}

fn name(named: &Named) -> String {
    let texts = [named.part.as_str(), named.feature.as_str()];
    texts.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(" ")
}

fn said(named: &Named, alarm: &Alarm) -> Message {
    message!("walk-page-alarm").text("name", name(named)).message("said", alarm.message())
}

/// The alarms that the page knows.
#[derive(Debug, Default)]
pub struct Alarms {
    open: Vec<OpenAlarm>,
    /// Values that are not on disk yet, by their batches.
    awaited: BTreeMap<u64, Vec<RecordId>>,
    /// What was sent and is not on disk yet.
    sent: BTreeMap<u64, Vec<(Named, Alarm)>>,
    /// The alarms that were answered here: the journal may not know it yet.
    answered: BTreeSet<u64>,
    /// Why rules cannot be looked at, as it was told: not again at every value.
    told: BTreeSet<String>,
    /// The alarm that is being answered, by the number of its entry.
    pub answering: Option<u64>,
}

impl Alarms {
    /// The alarms that nobody has answered, the oldest first.
    pub fn open(&self) -> &[OpenAlarm] {
        &self.open
    }

    fn is_sent(&self, named: &Named, alarm: &Alarm) -> bool {
        let is_it = |(of, sent): &(Named, Alarm)| {
            (&of.part, &of.feature) == (&named.part, &named.feature) && sent.has_pattern_of(alarm)
        };
        self.sent.values().flatten().any(is_it)
    }
}

/// The entries of the shop's own list of causes or actions, as its own texts have them.
pub fn choices(words: &Words, id: &str) -> Vec<String> {
    let list = words.get(id);
    list.split(BETWEEN).map(str::trim).filter(|text| !text.is_empty()).map(str::to_owned).collect()
}

impl PartsPage {
    /// Values were sent to the journal: those of this part that somebody measured are looked at once they are on disk.
    pub(super) fn await_alarms(&mut self, sent: &Sent, values: impl IntoIterator<Item = (RecordId, bool)>) {
        let Some(run) = sent.run else { return };
        let measured: Vec<_> = values.into_iter().filter(|(_, counts)| *counts).map(|(id, _)| id).collect();
        if !measured.is_empty() {
            self.alarms.awaited.insert(run, measured);
        }
    }

    /// Whether a value takes part in a series.
    pub(super) fn takes_part(value: &Arriving) -> bool {
        let record = &value.record;
        value.at.is_some() && record.doubt.is_none() && !record.measurement.origin.is_simulated()
    }

    /// The journal has answered about a batch: its newest value of each feature is looked at, and what was sent is open from now on.
    pub(super) fn look_for_alarms(&mut self, run: u64, shared: &mut Shared) {
        let is_sent = self.alarms.sent.remove(&run).is_some();
        let Some(ids) = self.alarms.awaited.remove(&run) else {
            if is_sent {
                shared.spread(News::Measured(Vec::new()));
            }
            return;
        };
        let mut newest = BTreeMap::new();
        for id in ids {
            if let (Some(number), Some(named)) = (shared.recording.number_of(id), shared.recording.named_of(id)) {
                let Named { part, serial, feature, .. } = named.clone();
                newest.insert((part.clone(), feature.clone()), NewestValue { number, part, serial, feature });
            }
        }
        if !newest.is_empty() {
            shared.spread(News::Measured(newest.into_values().collect()));
        }
    }

    /// What was found of alarms: what fired is recorded and told, and what is open is shown.
    pub(super) fn take_alarms(&mut self, found: Result<Box<AlarmsFound>, Message>, shared: &mut Shared) {
        let AlarmsFound { fired, unchecked, open } = match found {
            Ok(found) => *found,
            Err(why) => return shared.tell(message!("walk-page-alarms-unread").message("why", why)),
        };
        for (NewestValue { part, feature, .. }, why) in unchecked {
            let name = name(&Named { part, feature, ..Named::default() });
            let said = message!("walk-page-alarms-unchecked").text("name", name).message("why", why);
            if self.alarms.told.insert(said.to_string()) {
                shared.tell(said);
            }
        }
        self.alarms.open = open.iter().filter_map(OpenAlarm::of).collect();
        let answered = &self.alarms.answered;
        self.alarms.open.retain(|alarm| !answered.contains(&alarm.head.number));
        if self.answered_alarm().is_none() {
            self.alarms.answering = None;
        }
        let named = |(value, alarm): (NewestValue, Alarm)| {
            let NewestValue { part, serial, feature, .. } = value;
            (Named { part, serial, feature, ..Named::default() }, alarm)
        };
        let fired: Vec<_> =
            fired.into_iter().map(named).filter(|(named, alarm)| !self.alarms.is_sent(named, alarm)).collect();
        if fired.is_empty() {
            return;
        }
        for (named, alarm) in &fired {
            shared.note(said(named, alarm), Vec::new());
        }
        match shared.recording.keep_alarms(fired.clone()) {
            Ok(run) => _ = self.alarms.sent.insert(run, fired),
            Err(why) => shared.tell(message!("walk-page-alarm-unrecorded").message("why", why)),
        }
    }

    /// The alarm that is being answered.
    pub fn answered_alarm(&self) -> Option<&OpenAlarm> {
        let number = self.alarms.answering?;
        self.alarms.open.iter().find(|alarm| alarm.head.number == number)
    }

    /// Asks for cause and action of an alarm.
    pub(super) fn ask_alarm(&mut self, number: u64) -> Vec<Effect> {
        self.forget_answer();
        self.alarms.answering = Some(number);
        if self.answered_alarm().is_some() { vec![Effect::Focus(WalkField::Cause.into())] } else { self.leave_alarm() }
    }

    fn forget_answer(&mut self) {
        self.alarms.answering = None;
        for field in [WalkField::Cause, WalkField::Action] {
            self.texts.set(field, "");
            self.errors.remove(&field);
        }
    }

    /// The answer is given later: the alarm stays open.
    pub(super) fn leave_alarm(&mut self) -> Vec<Effect> {
        self.forget_answer();
        let field = if self.walking.is_begun() { WalkField::Value } else { WalkField::Serial };
        vec![Effect::Focus(field.into())]
    }

    /// Records cause and action of the alarm that is being answered, and of those that fired at the same value.
    pub(super) fn answer_alarm(&mut self, shared: &mut Shared) -> Vec<Effect> {
        let Some(open) = self.answered_alarm().cloned() else { return Vec::new() };
        let [cause, action] =
            [WalkField::Cause, WalkField::Action].map(|field| self.texts.text(field).trim().to_owned());
        let texts = [(WalkField::Cause, &cause), (WalkField::Action, &action)];
        if let Some((field, _)) = texts.into_iter().find(|(_, text)| text.is_empty()) {
            self.errors.insert(field, message!("walk-page-alarm-empty"));
            return vec![Effect::Focus(field.into())];
        }
        let (with, others): (Vec<_>, Vec<_>) = self.alarms.open.iter().cloned().partition(|alarm| alarm.is_with(&open));
        let answered = |OpenAlarm { head, alarm, named }: OpenAlarm| {
            let answer = Some(AlarmAnswer { target: head, cause: cause.clone(), action: action.clone() });
            (named, Alarm { answer, ..alarm })
        };
        let numbers: Vec<u64> = with.iter().map(|alarm| alarm.head.number).collect();
        let answers: Vec<_> = with.into_iter().map(answered).collect();
        match shared.recording.keep_alarms(answers.clone()) {
            Ok(run) => {
                self.alarms.sent.insert(run, answers);
                self.alarms.answered.extend(numbers);
                self.alarms.open = others;
                self.leave_alarm()
            }
            Err(why) => {
                self.errors.insert(WalkField::Cause, why);
                vec![Effect::Focus(WalkField::Cause.into())]
            }
        }
    }
}
