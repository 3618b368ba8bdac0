//! The parts that the values of a run with a plan belong to: what is missing of each, and what all of them make of the exit code.

use std::collections::BTreeMap;

use jiff::civil::DateTime;

use super::args::one_of;
use super::people::mm;
use super::said::CliWarning;
use super::{Io, Outcome};
use crate::exchange::Labels;
use crate::journal::Record;
use crate::length::Length;
use crate::part::{PartStanding, Plan, Repeats, SizeValue, Step, Walk};
use crate::probing::Origin;
use crate::verdict::Status;

/// The most parts that are known one by one; the verdicts of more count all the same.
const MOST: usize = 10_000;

/// Which of several values of one feature counts.
#[derive(Debug, Clone, Copy, clap::Args)]
pub(super) struct RepeatArgs {
    /// Which value counts if values of one feature of a part contradict each other; without this the worst one, and the exit code says so
    #[arg(long, value_name = "WHICH", value_parser = one_of(Repeats::CHOICES, |repeats| repeats.word()), requires = "plan")]
    repeats: Option<Repeats>,
}

impl RepeatArgs {
    pub(super) fn repeats(self) -> Repeats {
        // Where nothing is said, the usual.
        self.repeats.unwrap_or_default()
    }
}

/// The last value of a size with some verdict: what is said of it where others contradict it.
#[derive(Debug, Clone)]
struct Noted {
    measured: Length,
    place: String,
}

/// The last value with each verdict, measured and simulated ones apart.
type OfStatus = [[Option<Noted>; Status::ALL.len()]; 2];

/// A part and what is said of the values of its sizes.
#[derive(Debug)]
struct Part {
    walk: Walk,
    noted: BTreeMap<usize, OfStatus>,
    /// How many values had come with its newest one.
    seen: u64,
}

/// Every part of a run, by the name and the serial number that its file says.
#[derive(Debug)]
pub(super) struct PlanParts {
    /// The place of each size, by its name.
    places: BTreeMap<String, usize>,
    /// A part of which nothing was measured.
    nothing: Walk,
    parts: BTreeMap<(String, String), Part>,
    /// The worst verdict of the parts beyond those.
    beyond: Option<Status>,
    is_stream: bool,
    /// How many values have come.
    seen: u64,
}

impl PlanParts {
    /// Of no value yet.
    pub(super) fn of(plan: &Plan, repeats: Repeats) -> Self {
        let places = plan.sizes().map(|size| size.name()).zip(0..).collect();
        let nothing = Walk::new(plan, String::new()).by(repeats);
        Self { places, nothing, parts: BTreeMap::new(), beyond: None, is_stream: false, seen: 0 }
    }

    /// The same for a run without an end: of more parts than are known the newest ones are kept.
    pub(super) fn of_stream(plan: &Plan) -> Self {
        Self { is_stream: true, ..Self::of(plan, Repeats::Open) }
    }

    /// Whether a size has this name.
    pub(super) fn has(&self, name: &str) -> bool {
        self.places.contains_key(name)
    }

    /// A value of a part from a line of its file, as it was judged. Without a time of its own its order is not known.
    pub(super) fn see(&mut self, record: &Record, labels: &Labels, line: Option<usize>) {
        self.see_of((labels.part.clone(), labels.piece().to_owned()), record, line, labels.time);
    }

    /// The same of a part by its name and serial number, with the time at which it was measured.
    pub(super) fn see_of(
        &mut self,
        key: (String, String),
        record: &Record,
        line: Option<usize>,
        when: Option<DateTime>,
    ) {
        let Some(at) = self.places.get(&record.id).copied() else { return };
        let status = record.verdict.status();
        let is_simulated = record.measurement.origin.is_simulated();
        if MOST <= self.parts.len() && !self.parts.contains_key(&key) {
            if !self.is_stream {
                self.beyond = self.beyond.max(Some(status));
                return;
            }
            self.forget_older_half();
        }
        let new = || Part { walk: self.nothing.clone(), noted: BTreeMap::new(), seen: 0 };
        let part = self.parts.entry(key).or_insert_with(new);
        self.seen += 1;
        part.seen = self.seen;
        part.walk.take(at, SizeValue { status, is_simulated, when, is_settled: false });
        let file = match &record.measurement.origin {
            Origin::Imported { file } | Origin::ImportedSimulation { file } => file.as_ref(),
            _ => "",
        };
        let place = line.map_or_else(|| file.to_owned(), |line| format!("{file}:{line}"));
        let [measured, simulated] = part.noted.entry(at).or_default();
        let of_status = if is_simulated { simulated } else { measured };
        if let Some((_, noted)) = Status::ALL.into_iter().zip(of_status).find(|(one, _)| *one == status) {
            *noted = Some(Noted { measured: record.measurement.diameter, place });
        }
    }

    fn forget_older_half(&mut self) {
        let mut seen: Vec<u64> = self.parts.values().map(|part| part.seen).collect();
        let half = seen.len() / 2;
        let middle = *seen.select_nth_unstable(half).1;
        self.parts.retain(|_, part| middle <= part.seen);
    }

    /// The values that contradict each other: the part as far as it is known by name, the size, and the values with their verdicts and
    /// places, the worst one first.
    pub(super) fn contradictions(&self) -> impl Iterator<Item = CliWarning<'static>> {
        let mut said = self.contradictions_of(|_| true).peekable();
        let how = said.peek().is_some().then_some(CliWarning::WorstCounts);
        said.chain(how)
    }

    /// Those of some parts, by name and serial number.
    pub(super) fn contradictions_of(
        &self,
        is_it: impl Fn(&(String, String)) -> bool,
    ) -> impl Iterator<Item = CliWarning<'static>> {
        let names: BTreeMap<usize, &String> = self.places.iter().map(|(name, at)| (*at, name)).collect();
        self.parts.iter().filter(move |(key, _)| is_it(key)).flat_map(move |(key, part)| {
            let steps = (0..).zip(part.walk.steps()).filter(|(_, step)| !step.contradicting().is_empty());
            let said: Vec<_> = steps
                .map(|(at, step)| {
                    let name = names.get(&at).map_or_else(String::new, |name| (*name).clone());
                    let who = who(key);
                    let values = part.values(at, step);
                    if who.is_empty() {
                        CliWarning::Contradiction { name, values }
                    } else {
                        CliWarning::ContradictionOf { who, name, values }
                    }
                })
                .collect();
            said
        })
    }

    /// Says which values contradict each other.
    pub(super) fn tell_contradictions(&self, io: &mut Io<'_>) {
        for contradiction in self.contradictions() {
            io.warn(&contradiction);
        }
    }

    /// Each part: its name and serial number as far as they are known, and its walk. Without a value it is one part without any.
    pub(super) fn each(&self) -> impl Iterator<Item = (String, &Walk)> {
        let nothing = self.parts.is_empty().then_some((String::new(), &self.nothing));
        self.parts.iter().map(move |(key, part)| (who(key), &part.walk)).chain(nothing)
    }

    /// How many parts are known one by one, and whether there are more.
    pub(super) fn count(&self) -> (usize, bool) {
        (self.parts.len(), self.beyond.is_some())
    }

    /// The outcome of the run: the worst part, or a verdict of no part where that is worse. Without scrap, rework or doubt it is good where
    /// every part is, bad data where a part lacks a value, and to be looked at first where it was simulated.
    pub(super) fn outcome(&self, of_none: Option<Status>) -> Outcome {
        let standings: Vec<PartStanding> = self.each().map(|(_, walk)| walk.standing()).collect();
        let worst = standings.iter().filter_map(PartStanding::said).max().max(self.beyond).max(of_none);
        // Of a part that is not known what it lacks nothing is good.
        let is_open = self.beyond.is_some() || standings.iter().any(PartStanding::is_open);
        let judged = match worst {
            None | Some(Status::Good) if is_open => Outcome::BadData,
            Some(worst) => Outcome::Judged(worst),
            None => Outcome::Done,
        };
        let is_simulated = standings.iter().any(|standing| 0 < standing.simulated);
        if is_simulated { judged.worse(Outcome::LookFirst) } else { judged }
    }
}

impl Part {
    /// `25.030 SCRAP (a.csv:2), 25.012 GOOD (a.csv:4)`
    fn values(&self, at: usize, step: &Step) -> String {
        let is_measured = step.taken.iter().any(|taken| !taken.is_simulated);
        let Some([measured, simulated]) = self.noted.get(&at) else { return String::new() };
        let of_status = Status::ALL.into_iter().zip(if is_measured { measured } else { simulated });
        let said = of_status.rev().filter_map(|(status, noted)| {
            let Noted { measured, place } = noted.as_ref()?;
            Some(format!("{} {} ({place})", mm(*measured), status.word()))
        });
        said.collect::<Vec<_>>().join(", ")
    }
}

/// A part by its name and serial number, as far as they are known.
fn who((part, serial): &(String, String)) -> String {
    match (part.as_str(), serial.as_str()) {
        (text, "") | ("", text) => text.to_owned(),
        (part, serial) => format!("{part} {serial}"),
    }
}
