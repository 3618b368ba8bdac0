//! The values of a report for formats of measuring software, which have characteristics, parts with serial numbers, and values of both.
//!
//! A report has checks, and parts whose sizes some of them are. Here each check comes once: first the sizes of each part in the order of
//! its plan, also those without a value, then the checks that no part has. What is asked of a value makes its characteristic: checks
//! with the same name, callout and limits are values of one.

use std::collections::HashMap;
use std::io;

use fitcheck_core::length::Length;
use fitcheck_core::part::{FeatureKind, Size, WidthAxis};
use fitcheck_core::tolerance::{Callout, Feature, Limits, ToleranceClass};
use fitcheck_core::verdict::rules::Uncertainty;
use fitcheck_core::verdict::{Status, judge_size};
use sha2::{Digest as _, Sha256};

use super::Report;
use super::part::PartSheet;
use super::said::decimals_of;
use crate::journal::Record;
use crate::row;

/// A value, or the place of one that is missing.
pub(super) struct Given<'r> {
    /// The place of its part among those of the report; `None` for a check of no part.
    pub part: Option<usize>,
    pub asked: Asked<'r>,
    pub found: Found<'r>,
}

/// What was found of a size.
#[derive(Clone, Copy)]
pub(super) enum Found<'r> {
    Value(&'r Record),
    /// It was left out, for this reason.
    LeftOut(&'r str),
    Missing,
}

/// What is asked of a value.
pub(super) struct Asked<'r> {
    pub name: String,
    /// The number of its balloon; empty where it has none.
    pub number: &'r str,
    pub callout: Option<Callout>,
    pub limits: &'r Limits,
    pub quantity: Quantity,
    /// Where the plan says that it lies.
    pub place: Option<[Length; 3]>,
}

/// What kind of length a value is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Quantity {
    Diameter,
    /// The distance of two walls, along this axis.
    Width(WidthAxis),
    /// Where a face or a point lies.
    Coordinate,
    /// What no cycle measures.
    Length,
}

impl Quantity {
    /// Whether it is of a shape that the file describes.
    pub const fn has_shape(self) -> bool {
        matches!(self, Self::Diameter | Self::Width(_))
    }
}

impl<'r> Asked<'r> {
    fn of_size(size: &Size<'r>, limits: &'r Limits) -> Self {
        let quantity = match size.feature.kind {
            FeatureKind::Diameter(_) => Quantity::Diameter,
            FeatureKind::Width(_, axis) => Quantity::Width(axis),
            FeatureKind::Pocket(_) | FeatureKind::Boss(_) if size.side == 0 => Quantity::Width(WidthAxis::X),
            FeatureKind::Pocket(_) | FeatureKind::Boss(_) => Quantity::Width(WidthAxis::Y),
            FeatureKind::Face(..) | FeatureKind::Point(..) => Quantity::Coordinate,
            FeatureKind::Length(_) | FeatureKind::Form(_) => Quantity::Length,
        };
        let (name, number, place) = (size.name(), size.feature.number.as_str(), size.feature.place);
        Self { name, number, callout: size.callout, limits, quantity, place }
    }

    /// A check of no plan is that of a diameter.
    fn of_check(record: &'r Record) -> Self {
        let Record { id, callout, limits, .. } = record;
        let quantity = Quantity::Diameter;
        Self { name: id.clone(), number: "", callout: *callout, limits, quantity, place: None }
    }

    /// What it is called: its name, else what is asked for.
    pub(super) fn title(&self) -> String {
        match self.callout {
            _ if !self.name.is_empty() => self.name.clone(),
            Some(callout) => callout.to_string(),
            None => format!("{} mm", self.limits.nominal),
        }
    }

    /// The tolerance class, where there is one.
    pub(super) fn class(&self) -> Option<ToleranceClass> {
        self.callout?.class_for(self.limits.feature)
    }

    /// What all values of a characteristic have in common.
    fn key(&self) -> [u8; 16] {
        let Self { name, number, callout, limits, quantity, place } = self;
        let callout = callout.map_or_else(String::new, |callout| callout.to_string());
        let sizes = [limits.nominal, limits.minimum(), limits.maximum()].map(Length::nanometres);
        let place = place.map(|place| place.map(Length::nanometres));
        let feature = limits.feature.map(Feature::word);
        short(&format!("{:?}", (name, number, callout, sizes, quantity, place, feature)))
    }
}

/// Half of the hash of a text: enough that no two texts of a file share one.
fn short(text: &str) -> [u8; 16] {
    let mut half = [0; 16];
    half.iter_mut().zip(Sha256::digest(text)).for_each(|(to, from)| *to = from);
    half
}

/// A characteristic, by its number from 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Known {
    pub number: usize,
    /// The most decimals that one of its sizes has in millimetres, at least three.
    pub decimals: usize,
    /// The uncertainty that all of its values have.
    pub uncertainty: Option<Uncertainty>,
    values: usize,
}

/// The characteristics of a report, in the order in which they come first.
#[derive(Default)]
pub(super) struct Catalogue {
    known: HashMap<[u8; 16], Known>,
    /// How many are those of a hole, a shaft or a slot; the others say where something lies.
    sizes: usize,
}

impl Catalogue {
    /// Keeps what a value says of its characteristic.
    pub(super) fn see(&mut self, given: &Given<'_>) {
        let next = self.known.len() + 1;
        let new = Known { number: next, decimals: 3, uncertainty: None, values: 0 };
        let known = self.known.entry(given.asked.key()).or_insert(new);
        let limits = given.asked.limits;
        let sizes = [limits.nominal, limits.minimum(), limits.maximum()];
        known.decimals = sizes.into_iter().map(decimals_of).fold(known.decimals, usize::max);
        if let Found::Value(record) = given.found {
            known.decimals = known.decimals.max(decimals_of(record.measurement.diameter));
            let own = record.verdict.rule.uncertainty();
            known.uncertainty = if known.values == 0 { own } else { known.uncertainty.filter(|one| Some(*one) == own) };
            known.values += 1;
        }
        let is_new = known.number == next;
        self.sizes += usize::from(is_new && given.asked.quantity.has_shape());
    }

    /// The characteristic of a value.
    pub(super) fn of(&self, given: &Given<'_>) -> Option<Known> {
        self.known.get(&given.asked.key()).copied()
    }

    pub(super) fn count(&self) -> usize {
        self.known.len()
    }

    pub(super) const fn sizes(&self) -> usize {
        self.sizes
    }
}

/// Shows every value, in the same order each time.
///
/// # Errors
/// Those of the checks, and of what it was shown to.
pub(super) fn each(report: &Report, see: &mut dyn FnMut(&Given<'_>) -> io::Result<()>) -> io::Result<()> {
    (0..report.parts.len()).try_for_each(|at| of_part(report, at, see))?;
    of_none(report, see)
}

/// Shows the values of a part.
pub(super) fn of_part(report: &Report, at: usize, see: &mut dyn FnMut(&Given<'_>) -> io::Result<()>) -> io::Result<()> {
    let sizes = report.parts.get(at).into_iter().flat_map(PartSheet::sizes);
    for (size, step, record) in sizes {
        let found = match (record, &step.skipped) {
            (Some(record), _) => Found::Value(record),
            (None, Some(reason)) => Found::LeftOut(reason),
            (None, None) => Found::Missing,
        };
        let limits = record.map_or(size.limits, |record| &record.limits);
        see(&Given { part: Some(at), asked: Asked::of_size(&size, limits), found })?;
    }
    Ok(())
}

/// Shows the checks that are values of no part.
pub(super) fn of_none(report: &Report, see: &mut dyn FnMut(&Given<'_>) -> io::Result<()>) -> io::Result<()> {
    let mut taken: HashMap<[u8; 16], usize> = HashMap::new();
    for record in report.parts.iter().flat_map(PartSheet::records) {
        *taken.entry(same(record)).or_default() += 1;
    }
    report.checks.each(&mut |record| {
        // Without parts nothing is looked up.
        if !taken.is_empty()
            && let Some(count) = taken.get_mut(&same(record)).filter(|count| 0 < **count)
        {
            *count -= 1;
            return Ok(());
        }
        see(&Given { part: None, asked: Asked::of_check(record), found: Found::Value(record) })
    })
}

/// By what a value of a part is known among all checks.
fn same(record: &Record) -> [u8; 16] {
    let Record { time, id, limits, measurement, verdict, .. } = record;
    let sizes = [measurement.diameter, limits.minimum(), limits.maximum()].map(Length::nanometres);
    short(&format!("{:?}", (time, id, sizes, verdict.status(), &measurement.origin)))
}

/// Whether the value may stand in a file as one that its limits judge: somebody measured it, and the limits alone do not call it better
/// than the report does. Otherwise a program that knows nothing of guard bands and positions would say good.
pub(super) fn is_plain(record: &Record) -> bool {
    let by_limits = judge_size(&record.limits, record.measurement.diameter).status;
    !record.measurement.origin.is_simulated() && record.verdict.status() <= by_limits
}

/// The verdict in English, and everything that is to be known about it.
pub(super) fn remarks(record: &Record) -> String {
    let mut said = vec![if record.measurement.origin.is_simulated() {
        format!("SIMULATED {}", record.verdict.status().word())
    } else {
        record.verdict.status().word().to_owned()
    }];
    if record.verdict.size.status == Status::ReMeasure {
        said.push(match record.verdict.undecided {
            Some(why) => why.to_string(),
            None => "in a guard band of the rule".to_owned(),
        });
    }
    if !record.verdict.rule.is_plain() {
        said.push(record.verdict.rule.to_string());
    }
    if let Some(correction) = &record.correction {
        said.push(format!("corrected to 20 °C, measured {} mm", row::Millimetres(correction.measured).text(3)));
    }
    said.extend(row::warnings(record));
    said.join("; ")
}

/// What there is to say of a part: its status, and what it lacks.
pub(super) fn standing(part: &PartSheet) -> String {
    let counts = part.standing();
    let status = part.status().map_or("no verdict", Status::word);
    let mut said = format!("{status}: {counts}");
    if 0 < counts.simulated {
        said = format!("{said}, {} simulated", counts.simulated);
    }
    let missing = part.missing();
    if !missing.is_empty() {
        said = format!("{said}; missing {}", missing.join(", "));
    }
    for (name, reason) in part.left_out() {
        said = format!("{said}; {name} left out: {reason}");
    }
    said
}
