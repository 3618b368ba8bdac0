//! A value of a series: what was measured, its limits, where it comes from, and why it is left out.

use fitcheck_core::length::Length;
use jiff::civil::DateTime;

use crate::exchange::{Labels, StatedLimits, Unjudged, WhyUnjudged};
use crate::journal::Record;
use crate::journal::entry::{Checked, CycleCheck, Entry};

fitcheck_core::named! {
    /// Why a value is left out.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum LeftOut {
        /// All reasons, in the order in which they are counted.
        ALL;
        /// Its name in files.
        fn word;
        /// Nobody measured it.
        Simulated = "simulated",
        /// Its file says that it is none.
        Invalid = "invalid",
        /// It contradicts something, or may be another quantity.
        Doubtful = "doubtful",
        /// It was withdrawn, or another record stands in its place.
        Withdrawn = "withdrawn",
    }
}

/// Where a value comes from, as far as it is known; empty where it is not.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Origin {
    /// The part, such as its drawing number.
    pub part: String,
    /// What tells the part from others of its kind.
    pub piece: String,
    /// Who measured.
    pub who: String,
    /// The batch.
    pub batch: String,
    /// The machine that made the part.
    pub machine: String,
    /// What it was measured with, or at which station.
    pub gauge: String,
    /// Its number in the journal.
    pub number: Option<u64>,
    /// When it was measured.
    pub time: Option<DateTime>,
}

impl Origin {
    fn of(labels: &Labels) -> Self {
        let Labels { part, who, batch, machine, gauge, time, .. } = labels.clone();
        Self { part, piece: labels.piece().to_owned(), who, batch, machine, gauge, time, number: None }
    }

    /// Whether nothing names the part.
    pub const fn is_of_no_part(&self) -> bool {
        self.part.is_empty() && self.piece.is_empty()
    }

    /// The part and what tells it from others of its kind, in one name.
    pub fn whole_part(&self) -> String {
        let names = [self.part.as_str(), self.piece.as_str()];
        names.into_iter().filter(|name| !name.is_empty()).collect::<Vec<_>>().join(" ")
    }
}

/// A measured value with what is known of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Value {
    /// The feature.
    pub name: String,
    /// What was measured.
    pub measured: Length,
    /// What it should be, where the file says so.
    pub nominal: Option<Length>,
    /// Lower and upper limit, where there are any. The natural limit 0 of a form is none.
    pub limits: [Option<Length>; 2],
    /// Where it comes from.
    pub origin: Origin,
    /// Why it is left out, where it is.
    pub left_out: Option<LeftOut>,
}

/// Whether a value that makes no record is one all the same: for a series it needs no limits.
fn is_value(why: &WhyUnjudged) -> bool {
    match why {
        WhyUnjudged::NoCallout
        | WhyUnjudged::NotPositive { .. }
        | WhyUnjudged::NoLimits { .. }
        | WhyUnjudged::Coordinate(_)
        | WhyUnjudged::CoordinateWithoutLimits
        | WhyUnjudged::Size { .. }
        | WhyUnjudged::SizeWithoutLimits { .. }
        | WhyUnjudged::Point(_)
        | WhyUnjudged::PointWithoutTolerance
        | WhyUnjudged::OneLimit
        | WhyUnjudged::NoTolerance
        | WhyUnjudged::Rounded { .. }
        | WhyUnjudged::Implausible { .. }
        | WhyUnjudged::NotASize { .. }
        | WhyUnjudged::NotInPlan(_) => true,
        WhyUnjudged::SwappedLimits { .. }
        | WhyUnjudged::Quantity { .. }
        | WhyUnjudged::Kind { .. }
        | WhyUnjudged::Attribute { .. }
        | WhyUnjudged::NotValid { .. }
        | WhyUnjudged::Declaration { .. }
        | WhyUnjudged::Contacts { .. } => false,
    }
}

impl Value {
    fn of(name: &str, measured: Length, limits: StatedLimits, labels: &Labels) -> Self {
        // Nothing is less than round: the 0 of a form is no limit that a process could come near to.
        let lower = limits.minimum.filter(|minimum| *minimum != Length::ZERO);
        let origin = Origin::of(labels);
        let (name, nominal) = (name.to_owned(), limits.nominal);
        Self { name, measured, nominal, limits: [lower, limits.maximum], origin, left_out: None }
    }

    /// The value of a record; without one in doubt it counts unless it was simulated.
    pub fn of_record(record: &Record, labels: &Labels, is_doubted: bool) -> Self {
        let limits = &record.limits;
        let stated = StatedLimits {
            nominal: Some(limits.nominal),
            minimum: Some(limits.minimum()),
            maximum: Some(limits.maximum()),
        };
        let measurement = &record.measurement;
        let doubtful = is_doubted.then_some(LeftOut::Doubtful);
        let left_out = if measurement.origin.is_simulated() { Some(LeftOut::Simulated) } else { doubtful };
        Self { left_out, ..Self::of(&record.id, measurement.diameter, stated, labels) }
    }

    /// The value of a check in the journal, by the number of its entry; `None` where it measured no size.
    pub fn of_entry(number: u64, entry: &Entry, is_replaced: bool) -> Option<Self> {
        let about = &entry.about;
        let labels = Labels { part: about.part.clone(), who: about.who.clone(), ..Labels::default() };
        let mut value = match &entry.check()?.what {
            Checked::Size(record) => {
                let value = Self::of_record(record, &labels, record.doubt.is_some());
                Self { origin: Origin { time: Some(record.time), ..value.origin }, ..value }
            }
            Checked::Cycle(cycle) => Self::of_cycle(cycle, entry, &labels)?,
        };
        value.name.clone_from(&about.feature);
        value.origin.piece.clone_from(&about.serial);
        value.origin.gauge.clone_from(&about.station);
        value.origin.number = Some(number);
        if is_replaced {
            value.left_out = Some(LeftOut::Withdrawn);
        }
        Some(value)
    }

    fn of_cycle(cycle: &CycleCheck, entry: &Entry, labels: &Labels) -> Option<Self> {
        let [minimum, maximum] = cycle.limits.map_or([None, None], |limits| limits.map(Some));
        let value = Self::of("", cycle.measured?, StatedLimits { nominal: None, minimum, maximum }, labels);
        let left_out = cycle.origin.is_simulated().then_some(LeftOut::Simulated);
        Some(Self { left_out, origin: Origin { time: entry.about.time.local(), ..value.origin }, ..value })
    }

    /// A value that makes no record: for a series it needs no limits.
    pub fn of_unjudged(of: &Unjudged, measured: Length, is_doubted: bool) -> Self {
        let asked = of.asked();
        let mut value = Self::of(&of.id, measured, asked, &of.labels);
        if matches!(of.why, WhyUnjudged::Coordinate(_) | WhyUnjudged::Point(_)) {
            let [lower, _] = &mut value.limits;
            *lower = asked.minimum;
        }
        value.left_out = if of.origin.is_simulated() {
            Some(LeftOut::Simulated)
        } else if is_value(&of.why) {
            (is_doubted || matches!(of.why, WhyUnjudged::Implausible { .. })).then_some(LeftOut::Doubtful)
        } else {
            Some(LeftOut::Invalid)
        };
        value
    }
}

/// What calls its values by names that are those of parts: where no value names its part, its name is that of the part.
pub fn names_are_parts(values: &mut [Value]) {
    if values.iter().all(|value| value.origin.is_of_no_part()) {
        for value in values {
            value.origin.part = std::mem::take(&mut value.name);
        }
    }
}
