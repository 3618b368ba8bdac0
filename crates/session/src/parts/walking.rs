//! The part that is being measured: which size is asked for, what was measured of each, and what that makes of the part.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::Message;
use fitcheck_core::part::{PartStanding, Plan, Size, SizeValue, Step, Walk};
use fitcheck_core::probing::Origin;
use fitcheck_core::verdict::{Doubt, Status};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::query::RecordId;
use jiff::civil::DateTime;

use super::planned::Planned;
use super::serials;
use crate::Question;

/// A value of a size.
#[derive(Debug, Clone)]
pub struct Value {
    /// What was decided.
    pub record: Arc<Record>,
    /// Its number in the history; `None` where it came back from the journal.
    pub id: Option<RecordId>,
    /// Its number in the journal, where it came back from there.
    pub number: Option<u64>,
    /// What was taken from a gauge besides the number, and what is to be said of the value.
    pub remarks: Vec<Message>,
    /// When it was measured, where that is known.
    pub when: Option<DateTime>,
    /// Whether it counts no more, because somebody measured again or chose another one.
    pub is_settled: bool,
}

/// A size as the list shows it.
#[derive(Debug, Clone, Copy)]
pub struct WalkRow<'a> {
    /// The size of the plan.
    pub size: &'a Size<'a>,
    /// What was measured of it, or why it was left out.
    pub step: &'a Step,
    /// The value that counts.
    pub value: Option<&'a Value>,
}

/// A part on its way through the plan.
#[derive(Debug, Clone, Default)]
pub struct Walking {
    /// The plan as it was when the part was begun: changes of it count from the next part on.
    pub plan: Option<Arc<Plan>>,
    /// Its file, where it has one.
    pub(super) path: Option<PathBuf>,
    /// How many plans had been opened when its own was open.
    pub(super) opened: u64,
    /// The same when somebody last said to go on with this part.
    pub(super) kept_on: u64,
    /// What was measured so far.
    pub walk: Walk,
    values: Vec<Vec<Value>>,
    names: Vec<String>,
    /// The positions of the sizes by their names.
    places: BTreeMap<String, usize>,
    /// The number of the part among all that were begun: what was read for another one is not taken.
    pub run: u64,
    /// What its plan asks for, as a hash, and since which record of the journal it does.
    pub(super) planned: Planned,
    /// The part that a file without serial numbers has named, where that is another name than the plan's.
    pub(super) label: Option<String>,
    /// The size that is asked for.
    pub at: Option<usize>,
    /// Whether somebody chose that size: no value that comes from elsewhere moves on from it.
    is_chosen: bool,
    /// How many values it had then: one that is typed now takes their place.
    seen: usize,
    /// The size that was asked for when the text in the field of the value was typed.
    typed_at: Option<usize>,
    /// The size that is looked at: the one whose value came last, or the one that was chosen since.
    shown: Option<usize>,
    /// The same while its verdict is new: that stays with its size until the next one is begun.
    resting: Option<usize>,
    /// A number that goes up whenever the size that is asked for has to come into sight.
    look: u64,
    /// What is asked about a typed value before it is taken.
    pub question: Option<Question>,
    /// Why the last simulation was refused.
    pub refusal: Option<Message>,
    /// Whether it is asked why the size is left out.
    pub is_skipping: bool,
    /// Whether it was said that something is missing, so that the next part may come.
    pub is_warned: bool,
    /// The newest record of the journal when the part was begun.
    pub(super) since: u64,
    /// How many features were simulated.
    pub(super) seed: u64,
}

impl Walking {
    /// Begins a part.
    pub(super) fn begin(&mut self, plan: &Arc<Plan>, path: Option<PathBuf>, serial: String, since: u64) {
        let walk = Walk::new(plan, serial);
        *self = Self {
            values: vec![Vec::new(); walk.steps().len()],
            places: (0..).zip(plan.sizes()).map(|(at, size)| (size.name(), at)).collect(),
            names: plan.sizes().map(|size| size.name()).collect(),
            planned: Planned::of(plan, since),
            plan: Some(Arc::clone(plan)),
            run: self.run + 1,
            path,
            at: walk.next(0),
            walk,
            look: self.look + 1,
            since,
            ..Self::default()
        };
    }

    /// The part is done, or given up.
    pub(super) fn end(&mut self) {
        *self = Self { look: self.look + 1, run: self.run, ..Self::default() };
    }

    /// Whether a part was begun.
    pub const fn is_begun(&self) -> bool {
        self.plan.is_some()
    }

    /// Its serial number; empty where it has none.
    pub fn serial(&self) -> &str {
        &self.walk.serial
    }

    /// What its values make of the part.
    pub fn standing(&self) -> PartStanding {
        self.walk.standing()
    }

    /// The names of the sizes without a value.
    pub fn missing(&self) -> impl Iterator<Item = &str> {
        self.walk.missing().filter_map(|at| self.names.get(at).map(String::as_str))
    }

    /// The names of the sizes with neither a value nor a reason.
    pub fn open(&self) -> impl Iterator<Item = &str> {
        let steps = self.names.iter().zip(self.walk.steps());
        steps.filter(|(_, step)| step.is_open()).map(|(name, _)| name.as_str())
    }

    /// How many sizes there are.
    pub fn count(&self) -> usize {
        self.names.len()
    }

    /// The name of a size.
    pub fn name(&self, at: usize) -> &str {
        self.names.get(at).map_or("", String::as_str)
    }

    /// Where to look: a number that goes up whenever the size that is asked for has to come into sight, and its place.
    pub const fn look(&self) -> (u64, Option<usize>) {
        (self.look, self.at)
    }

    pub fn asked(&self) -> Option<Size<'_>> {
        self.plan.as_deref()?.sizes().nth(self.at?)
    }

    /// Does something with a size of the list.
    pub fn with_row<T>(&self, at: usize, see: impl FnOnce(WalkRow<'_>) -> T) -> Option<T> {
        let size = self.plan.as_deref()?.sizes().nth(at)?;
        let step = self.walk.steps().get(at)?;
        Some(see(WalkRow { size: &size, step, value: self.counting(at) }))
    }

    /// How many sizes have which verdict, the worst first.
    pub fn counts(&self) -> Vec<(Status, usize)> {
        let mut counts = BTreeMap::new();
        for taken in self.walk.steps().iter().filter_map(Step::counts) {
            *counts.entry(taken.status).or_insert(0) += 1;
        }
        counts.into_iter().rev().collect()
    }

    /// The sizes of which the value that counts is not good.
    pub fn not_good(&self) -> impl Iterator<Item = usize> {
        let is_it = |step: &Step| step.counts().is_some_and(|taken| taken.status != Status::Good);
        (0..).zip(self.walk.steps()).filter(move |(_, step)| is_it(step)).map(|(at, _)| at)
    }

    /// The value of a size that counts.
    pub fn counting(&self, at: usize) -> Option<&Value> {
        self.values(at).get(self.walk.steps().get(at)?.counting()?)
    }

    /// The values of a size, in the order in which they came.
    pub fn values(&self, at: usize) -> &[Value] {
        self.values.get(at).map_or(&[], Vec::as_slice)
    }

    /// The size that is looked at, and the value of it that counts, where it has one.
    pub fn shown(&self) -> Option<(usize, &Value)> {
        let at = self.shown?;
        Some((at, self.counting(at)?))
    }

    /// The size that the page is about: the one whose verdict is new until the next one is begun, else the one that is asked for.
    pub fn faced(&self) -> Option<usize> {
        self.resting.or(self.at).or(self.shown)
    }

    /// That size, and the value of it that counts.
    pub fn faced_value(&self) -> Option<(usize, &Value)> {
        let at = self.faced()?;
        Some((at, self.counting(at)?))
    }

    /// The value whose verdict is new, until the next one is begun.
    fn resting(&self) -> Option<&Value> {
        self.counting(self.resting?)
    }

    /// Whether a verdict is new.
    pub fn rests(&self) -> bool {
        self.resting().is_some()
    }

    /// Whether it asks for a look.
    pub(crate) fn waits(&self) -> bool {
        self.resting().is_some_and(|value| value.record.verdict.asks_for_a_look())
    }

    /// Does something with that size as the plan has it.
    pub fn faced_size(&self) -> Option<Size<'_>> {
        self.plan.as_deref()?.sizes().nth(self.faced()?)
    }

    /// Whether a value is asked about that cannot be, as the plan says.
    pub(super) fn asks_about_implausible(&self) -> bool {
        self.question.is_some_and(|question| matches!(question.doubt, Doubt::Implausible { .. }))
    }

    /// Whether a text that is typed now begins the serial number of the next part: this one is done, and its own begins alike.
    pub fn begins_next(&self, text: &str) -> bool {
        self.is_done() && serials::may_begin(text, self.serial())
    }

    /// Whether somebody measured a size.
    pub(super) fn is_measured(&self, at: usize) -> bool {
        self.walk.steps().get(at).and_then(Step::counts).is_some_and(|taken| !taken.is_simulated)
    }

    /// A text was typed for the size that is asked for, or the field is empty.
    pub(super) fn typed(&mut self, text: &str) {
        self.typed_at = self.at.filter(|_| !text.trim().is_empty());
        self.resting = self.resting.filter(|_| self.typed_at.is_none());
    }

    /// The size that the text in the field was typed for, where another one is asked for now.
    pub(super) fn typed_elsewhere(&self) -> Option<usize> {
        self.typed_at.filter(|at| self.at != Some(*at))
    }

    /// The verdict of the part as a card may say it: nothing is good while something is missing, left out or simulated.
    pub fn status(&self) -> Option<Status> {
        self.standing().said()
    }

    /// The position of a size by its name.
    pub(super) fn place_of(&self, name: &str) -> Option<usize> {
        self.places.get(name).copied()
    }

    /// Takes a value. It is shown, and what is being asked stays: it may come from a file.
    pub(super) fn take(&mut self, at: usize, value: Value) {
        let status = value.record.verdict.status();
        let is_simulated = value.record.measurement.origin.is_simulated();
        let when = value.when;
        let is_settled = value.is_settled;
        self.walk.take(at, SizeValue { status, is_simulated, when, is_settled });
        if value.record.measurement.origin == Origin::Typed {
            // Who types a value of a size that has a typed one has gone back to it.
            self.settle(at, |_, before| before.record.measurement.origin == Origin::Typed);
        }
        let is_held = self.typed_at.is_some() || self.is_skipping || self.question.is_some();
        if let Some(values) = self.values.get_mut(at) {
            values.push(value);
            self.rest(at, !is_held && (!self.is_chosen || self.at == Some(at)));
        }
        self.refusal = None;
        self.is_warned = false;
    }

    /// The value of a size came last.
    pub(super) fn rest(&mut self, at: usize, rests: bool) {
        self.shown = Some(at);
        self.resting = rests.then_some(at);
    }

    /// Values that were measured before those that are there, in the order in which they came.
    pub(super) fn put_before(&mut self, values: Vec<(usize, Value)>) {
        let since = self.all();
        self.take_anew(values.into_iter().chain(since).collect());
    }

    pub(super) fn has(&self, is_it: impl Fn(&Value) -> bool) -> bool {
        self.values.iter().flatten().any(is_it)
    }

    /// The last size that has a value of which something is true.
    pub(super) fn place_where(&self, is_it: impl Fn(&Value) -> bool) -> Option<usize> {
        self.values.iter().rposition(|values| values.iter().any(&is_it))
    }

    /// Takes a value out and puts another one in its place; returns the name of its size.
    pub(super) fn replace(&mut self, is_it: impl Fn(&Value) -> bool, by: Option<(usize, Value)>) -> Option<String> {
        let mut all = self.all();
        let place = all.iter().position(|(_, value)| is_it(value));
        let at = place.and_then(|place| all.get(place)).or(by.as_ref()).map(|(at, _)| *at);
        match place {
            Some(place) => _ = all.splice(place..=place, by),
            None => all.extend(by),
        }
        self.stand_anew(all);
        at.map(|at| self.name(at).to_owned())
    }

    /// Takes values out.
    pub(super) fn remove(&mut self, is_it: impl Fn(&Value) -> bool) {
        let mut all = self.all();
        all.retain(|(_, value)| !is_it(value));
        self.stand_anew(all);
    }

    /// Takes what is left of the values; what is shown has some.
    fn stand_anew(&mut self, all: Vec<(usize, Value)>) {
        self.take_anew(all);
        self.shown = self.shown.filter(|at| !self.values(*at).is_empty());
        self.resting = self.resting.filter(|at| self.shown == Some(*at));
    }

    /// All values, size by size, in the order in which those of a size came.
    fn all(&mut self) -> Vec<(usize, Value)> {
        let empty = vec![Vec::new(); self.count()];
        let values = std::mem::replace(&mut self.values, empty);
        let of_sizes = (0..).zip(values);
        of_sizes.flat_map(|(at, values)| values.into_iter().map(move |value| (at, value))).collect()
    }

    /// Takes these values and no others; what is asked for and what is shown stays.
    fn take_anew(&mut self, values: Vec<(usize, Value)>) {
        let at = self.at;
        let shown = self.shown;
        let resting = self.resting;
        let reasons: Vec<_> = self.walk.steps().iter().map(|step| step.skipped.clone()).collect();
        if let Some(plan) = &self.plan {
            self.walk = Walk::new(plan, std::mem::take(&mut self.walk.serial));
        }
        for (at, reason) in (0..).zip(reasons) {
            reason.map(|reason| self.walk.skip(at, &reason));
        }
        for (at, value) in values {
            self.take(at, value);
        }
        self.at = at;
        self.shown = shown.or(self.shown);
        self.resting = resting;
    }

    /// Asks for the next size that is open; where none is, for none.
    pub(super) fn go_on(&mut self) {
        let from = self.at.map_or(0, |at| at + 1);
        self.at = self.walk.next(from);
        self.is_chosen = false;
        self.seen = 0;
        self.look += 1;
    }

    /// Values of a size count no more.
    fn settle(&mut self, at: usize, is_it: impl Fn(usize, &Value) -> bool) {
        let values = self.values.get_mut(at).into_iter().flatten();
        for (place, value) in (0..).zip(values).filter(|(place, value)| is_it(*place, value)) {
            value.is_settled = true;
            self.walk.settle(at, place);
        }
    }

    /// A value is typed for a size that somebody has gone back to: it takes the place of those that it had then.
    pub(super) fn settle_seen(&mut self, at: usize) {
        let seen = self.seen;
        self.settle(at, |place, _| place < seen);
    }

    /// The values of a size of which one counts, and nobody has said which one: of the size that is looked at, or the first one that has
    /// such values.
    pub fn contradicted(&self) -> Option<(usize, Vec<&Value>)> {
        let of = |at: usize| {
            let places = self.walk.steps().get(at)?.contradicting();
            let values: Vec<&Value> = places.into_iter().filter_map(|place| self.values(at).get(place)).collect();
            (!values.is_empty()).then_some((at, values))
        };
        self.shown.and_then(of).or_else(|| (0..self.count()).find_map(of))
    }

    /// Of the values that contradict each other the newest one counts; the name of their size.
    pub(super) fn count_newest(&mut self) -> Option<String> {
        let (at, _) = self.contradicted()?;
        let newest = self.walk.steps().get(at)?.newest()?;
        self.settle(at, |place, _| place != newest);
        self.shown = Some(at);
        Some(self.name(at).to_owned())
    }

    /// The size that is asked for is one that is open, if any is; one that was chosen, or about which something is asked, stays.
    pub(super) fn stay_open(&mut self) {
        let is_open = |at: usize| self.walk.steps().get(at).is_some_and(Step::is_open);
        let is_held = self.is_chosen || self.is_skipping || self.question.is_some();
        if !is_held && !self.at.is_some_and(is_open) {
            self.go_on();
        }
    }

    /// Asks for another size.
    pub(super) fn go(&mut self, at: usize) {
        if at < self.count() {
            self.at = Some(at);
            self.is_chosen = true;
            self.seen = self.values(at).len();
            self.look += 1;
            self.quiet();
            // Its own verdict is shown, or none.
            self.rest(at, false);
        }
    }

    /// Leaves out the size that is asked for.
    pub(super) fn skip(&mut self, at: usize, reason: &str) -> bool {
        let is_skipped = self.walk.skip(at, reason);
        self.resting = None;
        self.quiet();
        is_skipped
    }

    /// The reasons of the sizes that were left out, by their names.
    pub(super) fn skipped(&self) -> BTreeMap<String, String> {
        let steps = self.names.iter().zip(self.walk.steps());
        steps.filter_map(|(name, step)| Some((name.clone(), step.skipped.clone()?))).collect()
    }

    /// The sizes that were left out and have no value, with the reasons.
    pub(super) fn left_out(&self) -> impl Iterator<Item = (&str, &str)> {
        let steps = self.names.iter().zip(self.walk.steps()).filter(|(_, step)| step.taken.is_empty());
        steps.filter_map(|(name, step)| Some((name.as_str(), step.skipped.as_deref()?)))
    }

    /// Nothing more is said of the value that came last: the page is about the size that is asked for. Whether it was about another one.
    pub(super) fn begin_asked(&mut self) -> bool {
        self.resting.take().is_some_and(|at| self.at != Some(at))
    }

    /// Whatever was asked or refused is over.
    pub(super) fn quiet(&mut self) {
        self.question = None;
        self.refusal = None;
        self.is_skipping = false;
        self.is_warned = false;
    }

    /// Whether a size is a diameter: half of what is removed is on each side.
    pub fn is_round(&self, at: usize) -> bool {
        let is_round =
            |row: WalkRow<'_>| matches!(row.size.feature.kind, fitcheck_core::part::FeatureKind::Diameter(_));
        self.with_row(at, is_round).unwrap_or(false)
    }

    /// What a value may be besides its verdict: below zero only where it is no size.
    pub(super) fn may_be_any(&self) -> bool {
        use fitcheck_core::part::FeatureKind::{Face, Form, Point};
        self.asked().is_some_and(|size| matches!(size.feature.kind, Face(..) | Point(..) | Form(_)))
    }

    /// The deviation of a value from the nominal size.
    pub fn deviation(value: &Value) -> Length {
        value.record.verdict.size.deviation
    }
}
