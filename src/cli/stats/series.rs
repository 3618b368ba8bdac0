//! Which values of the files count, which are left out, and how they are grouped.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::cli::admitted::Admits as _;
use crate::cli::measured::{Measured, unreadable};
use crate::cli::{CliError, CliRemark, Io, import, now};
use crate::exchange::{ByPlan, ImportInputs, Item, Labels, Mapping, StatedLimits, Unjudged, WhyUnjudged, import_from};
use crate::files;
use crate::journal::Record;
use crate::length::Length;
use crate::part::Plan;
use crate::tolerance::Sources;

/// Why a value is left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LeftOut {
    /// Nobody measured it.
    Simulated,
    /// Its file says that it is none.
    Invalid,
    /// It contradicts something, or may be another quantity.
    Doubtful,
}

impl LeftOut {
    pub(super) const ALL: [Self; 3] = [Self::Simulated, Self::Invalid, Self::Doubtful];

    pub(super) const fn word(self) -> &'static str {
        match self {
            Self::Simulated => "simulated",
            Self::Invalid => "invalid",
            Self::Doubtful => "doubtful",
        }
    }
}

/// A measured value with what its file says of it.
#[derive(Debug)]
pub(super) struct Value {
    name: String,
    measured: Length,
    limits: [Option<Length>; 2],
    /// The part and what tells it from others of its kind.
    part: (String, String),
    left_out: Option<LeftOut>,
}

/// What was read.
#[derive(Debug, Default)]
pub(super) struct Read {
    pub(super) values: Vec<Value>,
    /// Whether a row or a file could not be read.
    pub(super) has_failed: bool,
}

/// Reads all files; what cannot be read is told.
pub(super) fn read(
    paths: &[PathBuf],
    sources: &Sources,
    mapping: Option<&Mapping>,
    plan: Option<&Plan>,
    io: &mut Io<'_>,
) -> Read {
    crate::cli::io::warn_of_repeats(paths, io);
    let mut read = Read::default();
    let by_plan = plan.map(ByPlan::new);
    for path in paths {
        let file = match Measured::open(path) {
            Ok(file) => file,
            Err(error) => {
                io.fail(&error);
                read.has_failed = true;
                continue;
            }
        };
        let beside = |ending: &str| files::beside(path, ending);
        let given =
            ImportInputs { beside: &beside, mapping, has_plan: plan.is_some(), ..ImportInputs::new(sources, now()) };
        let name = files::name_of(path).to_string_lossy();
        let mut doubted = None;
        let mut take_one = |item: Item| read.take(path, item, &mut doubted, io);
        let mut take = |item: Item| match &by_plan {
            Some(by_plan) => by_plan.item(item, &mut take_one),
            None => take_one(item),
        };
        file.read(|body| import_from(&name, body, given, &mut take));
    }
    read
}

impl Read {
    /// Takes what a file holds; a doubt about a row comes before the row.
    fn take(&mut self, path: &Path, item: Item, doubted: &mut Option<usize>, io: &mut Io<'_>) {
        import::warn(path, &item, io);
        if let Some(error) = unreadable(path, &item) {
            io.fail(&error);
        }
        let place = |line: usize| format!("{}:{line}", path.display());
        match item {
            Item::Record { line, record, labels } => {
                if let Some(doubt) = &record.doubt {
                    io.tell(format_args!("{}: warning: {doubt}", place(line)));
                }
                let is_doubted = record.doubt.is_some() || *doubted == Some(line);
                self.values.push(Value::of_record(&record, &labels, is_doubted));
            }
            Item::Unjudged(unjudged) => {
                if let Some(measured) = unjudged.measured {
                    let is_doubted = *doubted == Some(unjudged.line);
                    self.values.push(Value::of_unjudged(&unjudged, measured, is_doubted));
                } else {
                    io.tell(format_args!("{}: {}", place(unjudged.line), unjudged.why));
                    self.has_failed = true;
                }
            }
            Item::Error(error) => {
                io.tell(format_args!("{}: {}", place(error.place.line.unwrap_or(1)), error.what.kind));
                self.has_failed = true;
            }
            Item::Warning(warning) => {
                if let Some(line) = warning.what.row {
                    io.tell(format_args!("{}: warning: {}", place(line), warning.what.kind));
                    if warning.what.kind.wants_a_look() {
                        *doubted = Some(line);
                    }
                }
            }
            Item::Contacts(_) => {
                io.tell(format_args!("{}: {}", path.display(), CliRemark::NoColumns));
                self.has_failed = true;
            }
        }
    }
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
        let part = (labels.part.clone(), labels.piece().to_owned());
        Self { name: name.to_owned(), measured, limits: [lower, limits.maximum], part, left_out: None }
    }

    fn of_record(record: &Record, labels: &Labels, is_doubted: bool) -> Self {
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

    fn of_unjudged(of: &Unjudged, measured: Length, is_doubted: bool) -> Self {
        let asked = of.asked();
        let mut value = Self::of(&of.id, measured, asked, &of.labels);
        if matches!(of.why, WhyUnjudged::Coordinate(_) | WhyUnjudged::Point(_)) {
            let [lower, _] = &mut value.limits;
            *lower = asked.minimum;
        }
        value.left_out = if of.origin.is_simulated() {
            Some(LeftOut::Simulated)
        } else if is_value(&of.why) {
            is_doubted.then_some(LeftOut::Doubtful)
        } else {
            Some(LeftOut::Invalid)
        };
        value
    }
}

/// What makes a subgroup.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Grouping {
    /// Each value is one.
    Single,
    /// So many values in a row.
    Of(usize),
    /// The values of one part in a row.
    ByPart,
}

/// The values of one feature.
#[derive(Debug)]
pub(super) struct Series<'a> {
    /// Its name, where it has one.
    pub(super) name: Option<String>,
    /// The subgroups of the values that count, in millimetres.
    pub(super) groups: Vec<Vec<f64>>,
    of: Vec<&'a Value>,
}

impl<'a> Series<'a> {
    /// The values of a feature; without one, the files have one feature only.
    pub(super) fn of(values: &'a [Value], feature: Option<&str>, grouping: Grouping) -> Result<Self, CliError> {
        let names: BTreeSet<&str> = values.iter().map(|value| value.name.as_str()).collect();
        let all = || names.iter().take(MOST_NAMES).copied().collect::<Vec<_>>().join(", ");
        let name = match feature {
            Some(given) if names.contains(given) => Some(given),
            Some(given) => return Err(CliError::StatsNoFeature { given: given.to_owned(), names: all() }),
            None if names.len() == 1 => names.first().copied().filter(|name| !name.is_empty()),
            // Names of parts: every value has its own, and all have the same limits.
            None if names.len() == values.len() && are_alike(values) => None,
            None if names.is_empty() => None,
            None => return Err(CliError::StatsFeatures { names: all() }),
        };
        let of: Vec<&Value> = values.iter().filter(|value| feature.is_none_or(|name| value.name == name)).collect();
        let counted: Vec<&Value> = of.iter().filter(|value| value.left_out.is_none()).copied().collect();
        let groups: Vec<&[&Value]> = match grouping {
            Grouping::Single => counted.chunks(1).collect(),
            Grouping::Of(size) => counted.chunks(size).collect(),
            Grouping::ByPart if counted.iter().any(|value| value.part == Default::default()) => {
                return Err(CliError::StatsNoParts);
            }
            Grouping::ByPart => counted.chunk_by(|one, other| one.part == other.part).collect(),
        };
        let mm = |group: &[&Value]| group.iter().map(|value| value.measured.to_mm_f64()).collect();
        let groups = groups.into_iter().map(mm).collect();
        Ok(Self { name: name.map(str::to_owned), groups, of })
    }

    /// Lower and upper limit in millimetres, as far as the files state them.
    pub(super) fn limits(&self) -> Result<[Option<f64>; 2], CliError> {
        let stated = self.of.iter().map(|value| value.limits).filter(|limits| limits != &[None, None]);
        let mut stated = stated.collect::<Vec<_>>();
        stated.dedup();
        match stated.as_slice() {
            [] => Ok([None, None]),
            [limits] => Ok(limits.map(|limit| limit.map(Length::to_mm_f64))),
            _ => Err(CliError::StatsLimits),
        }
    }

    /// How many values count.
    pub(super) fn count(&self) -> usize {
        self.groups.iter().map(Vec::len).sum()
    }

    /// How many values are left out for each reason, where there are any.
    pub(super) fn left_out(&self) -> impl Iterator<Item = (LeftOut, usize)> {
        let count = |why: LeftOut| self.of.iter().filter(|value| value.left_out == Some(why)).count();
        LeftOut::ALL.into_iter().map(move |why| (why, count(why))).filter(|(_, count)| 0 < *count)
    }

    /// Whether doubtful values are left out.
    pub(super) fn has_doubts(&self) -> bool {
        self.left_out().any(|(why, _)| why == LeftOut::Doubtful)
    }
}

/// So many names of features are listed.
const MOST_NAMES: usize = 20;

/// Whether all values have the same limits.
fn are_alike(values: &[Value]) -> bool {
    values.windows(2).all(|pair| matches!(pair, [one, other] if one.limits == other.limits))
}
